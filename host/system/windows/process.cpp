#include "system/process.hpp"

#include "system/windows/windows.hpp"

#include <atomic>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <io.h>
#include <string>

#include <psapi.h> // must follow <windows.h>

namespace gabor::system {

namespace {

constexpr int none = -1;
std::atomic<int> noted = none; // an event of the console

// How long a program may take to clean up.
constexpr DWORD patience = 1000; // milliseconds

std::wstring program_path() {
    std::wstring path(32768, L'\0');
    path.resize(::GetModuleFileNameW(nullptr, path.data(), static_cast<DWORD>(path.size())));
    return path;
}

// Runs on a thread of its own for every event: Ctrl-C, Ctrl-Break, which Wine 8 does not deliver, or the end
// of the console or session. Ends a program that is still waiting, for example for a driver to compile a
// shader; Windows deletes incomplete files.
BOOL WINAPI note(DWORD event) {
    int expected = none;
    if (!noted.compare_exchange_strong(expected, static_cast<int>(event)))
        return FALSE; // the second time: end at once
    ::Sleep(patience);
    const std::string text = std::string(is_terminal() ? "\r\x1b[K" : "") +
                             std::filesystem::path(program_path()).stem().string() +
                             ": interrupted; no half-written file was kept\n";
    DWORD written = 0;
    ::WriteFile(::GetStdHandle(STD_ERROR_HANDLE), text.data(), static_cast<DWORD>(text.size()), &written,
                nullptr);
    end_by(static_cast<int>(event) + 1);
}

bool is_open(DWORD stream) {
    const HANDLE handle = ::GetStdHandle(stream);
    return handle && handle != INVALID_HANDLE_VALUE && ::GetFileType(handle) != FILE_TYPE_UNKNOWN;
}

// Prints with plain line ends: to the stream that the program was given or, if a program with a window was
// given none, to the console that started it. Without any, printing goes nowhere.
void open_stream(std::FILE* stream, DWORD number, bool console) {
    if (!is_open(number) && !(console && std::freopen("CONOUT$", "w", stream)))
        std::freopen("NUL", "r", stream); // printing fails
    ::_setmode(::_fileno(stream), _O_BINARY);
}

} // namespace

void prepare() {
    std::setlocale(LC_CTYPE,
                   ".UTF-8"); // for std::filesystem::path; gabor.manifest sets the rest of the process
    const bool console = (is_open(STD_OUTPUT_HANDLE) && is_open(STD_ERROR_HANDLE)) || ::GetConsoleWindow() ||
                         ::AttachConsole(ATTACH_PARENT_PROCESS);
    open_stream(stdout, STD_OUTPUT_HANDLE, console);
    open_stream(stderr, STD_ERROR_HANDLE, console);
    // Windows buffers what goes to files and pipes, and end_by would lose it.
    std::setvbuf(stderr, nullptr, _IONBF, 0);
    ::SetConsoleOutputCP(CP_UTF8);
}

bool is_terminal() {
    const HANDLE console = ::GetStdHandle(STD_ERROR_HANDLE);
    DWORD mode = 0;
    return ::GetConsoleMode(console, &mode) &&
           ::SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

void note_interrupts() {
    ::SetConsoleCtrlHandler(note, TRUE);
}

int interrupt() {
    return noted + 1; // CTRL_C_EVENT is 0
}

void end_by(int) {
    ::TerminateProcess(::GetCurrentProcess(), static_cast<UINT>(STATUS_CONTROL_C_EXIT));
    std::_Exit(1);
}

void show_error(std::string_view message) {
    if (is_open(STD_ERROR_HANDLE))
        return;
    const std::filesystem::path text{std::string(message)}; // as UTF-16
    ::MessageBoxW(nullptr, text.c_str(), std::filesystem::path(program_path()).stem().c_str(),
                  MB_OK | MB_ICONERROR);
}

int process_id() {
    return static_cast<int>(::GetCurrentProcessId());
}

bool is_running(int process) {
    const Handle handle(::OpenProcess(SYNCHRONIZE, FALSE, static_cast<DWORD>(process)));
    return handle && ::WaitForSingleObject(handle.get(), 0) == WAIT_TIMEOUT;
}

std::uint64_t peak_memory() {
    PROCESS_MEMORY_COUNTERS memory{};
    ::K32GetProcessMemoryInfo(::GetCurrentProcess(), &memory, sizeof memory);
    return memory.PeakWorkingSetSize;
}

double cpu_seconds() {
    FILETIME created{}, ended{}, kernel{}, user{};
    ::GetProcessTimes(::GetCurrentProcess(), &created, &ended, &kernel, &user);
    const auto seconds = [](const FILETIME& time) {
        return 429.4967296 * time.dwHighDateTime + 1e-7 * time.dwLowDateTime; // 2^32 * 100 ns
    };
    return seconds(kernel) + seconds(user);
}

void return_memory() {}

} // namespace gabor::system
