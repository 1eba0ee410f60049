/* Starts a program, sends it an event of the console after some time, and prints its exit status in hexadecimal.
 *   control c|twice|kill MILLISECONDS PROGRAM [ARGUMENT]...    kill terminates it, twice sends two Ctrl-C */
#include <windows.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static HANDLE inherited(DWORD stream) {
    const HANDLE handle = GetStdHandle(stream);
    SetHandleInformation(handle, HANDLE_FLAG_INHERIT, HANDLE_FLAG_INHERIT);
    return handle;
}

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
    start.dwFlags = STARTF_USESTDHANDLES;
    start.hStdInput = inherited(STD_INPUT_HANDLE);
    start.hStdOutput = inherited(STD_OUTPUT_HANDLE);
    start.hStdError = inherited(STD_ERROR_HANDLE);
    FreeConsole(); /* events need a console, which Wine gives only to programs that it starts from a terminal */
    AllocConsole();
    if (count < 4 || !CreateProcessA(NULL, line, NULL, NULL, TRUE, 0, NULL, NULL, &start, &process))
        return 1;
    Sleep(atoi(arguments[2]));
    SetConsoleCtrlHandler(NULL, TRUE); /* ignores Ctrl-C */
    if (strcmp(arguments[1], "kill") == 0)
        TerminateProcess(process.hProcess, 9);
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
