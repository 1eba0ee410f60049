/* Starts a program, sends it an event of the console after some time, and prints its exit status in hexadecimal.
 *   control c|break|twice|kill MILLISECONDS PROGRAM [ARGUMENT]...    kill terminates it, twice sends two Ctrl-C */
#include <windows.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(int count, char** arguments) {
    char line[32768] = "";
    STARTUPINFOA start = {.cb = sizeof start};
    PROCESS_INFORMATION process;
    DWORD status = 0;
    for (int i = 3; i < count; ++i) {
        strcat(line, i > 3 ? " \"" : "\"");
        strcat(line, arguments[i]);
        strcat(line, "\"");
    }
    if (count < 4 || !CreateProcessA(NULL, line, NULL, NULL, TRUE, 0, NULL, NULL, &start, &process))
        return 1;
    Sleep(atoi(arguments[2]));
    SetConsoleCtrlHandler(NULL, TRUE); /* for Ctrl-C */
    if (strcmp(arguments[1], "kill") == 0)
        TerminateProcess(process.hProcess, 9);
    else if (strcmp(arguments[1], "break") == 0)
        GenerateConsoleCtrlEvent(CTRL_BREAK_EVENT, 0);
    else
        GenerateConsoleCtrlEvent(CTRL_C_EVENT, 0);
    if (strcmp(arguments[1], "twice") == 0) {
        Sleep(50);
        GenerateConsoleCtrlEvent(CTRL_C_EVENT, 0);
    }
    WaitForSingleObject(process.hProcess, 60000);
    GetExitCodeProcess(process.hProcess, &status);
    printf("%lx\n", status);
    return 0;
}
