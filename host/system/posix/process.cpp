#include "system/process.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <fcntl.h>
#include <sys/resource.h>
#include <tuple>
#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace gabor::system {

namespace {

volatile std::sig_atomic_t noted = 0;

// How long a signalled program may take to clean up.
constexpr unsigned patience = 1; // seconds

std::string_view program_name() {
#ifdef __GLIBC__
    return program_invocation_short_name;
#else
    return ::getprogname();
#endif
}

// Ends a program that is still waiting, for example for a driver to compile a shader. Calls only what a
// signal handler may call. Incomplete files have no name yet, or a hidden one that the next run removes.
void end(int) {
    constexpr std::string_view clear = "\r\x1b[K", text = ": interrupted; no half-written file was kept\n";
    if (is_terminal())
        std::ignore = write(STDERR_FILENO, clear.data(), clear.size());
    for (const std::string_view part : {program_name(), text})
        std::ignore = write(STDERR_FILENO, part.data(), part.size());
    end_by(noted);
}

void note(int signal) {
    noted = signal;
    alarm(patience);
}

} // namespace

void prepare() {
    // If a standard stream is closed, the next file to be opened would take its descriptor and receive what
    // is printed. Open a read-only file in its place, so that printing fails instead.
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(stream, F_GETFD) < 0)
            ::open("/dev/null", O_RDONLY);
    // Report a closed pipe and a file that is too large like any other error.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

bool is_terminal() {
    return ::isatty(STDERR_FILENO);
}

void note_interrupts() {
    struct sigaction action = {};
    action.sa_handler = note;
    action.sa_flags =
        static_cast<int>(SA_RESTART | SA_RESETHAND); // a second signal terminates the process at once
    for (const int signal : {SIGINT, SIGTERM})
        sigaction(signal, &action, nullptr);
    std::signal(SIGALRM, end);
}

int interrupt() {
    return noted;
}

void end_by(int interrupt) {
    std::signal(interrupt, SIG_DFL);
    std::raise(interrupt);
    std::_Exit(1);
}

void show_error(std::string_view) {}

int process_id() {
    return ::getpid();
}

bool is_running(int process) {
    return process > 0 && ::kill(process, 0) == 0;
}

std::uint64_t peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
    constexpr std::uint64_t unit = 1;
#else
    constexpr std::uint64_t unit = 1024;
#endif
    return static_cast<std::uint64_t>(usage.ru_maxrss) * unit;
}

double cpu_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void return_memory() {
#ifdef __GLIBC__
    mallopt(M_ARENA_MAX, 1);
    mallopt(M_TRIM_THRESHOLD, 1 << 17);
#endif
}

} // namespace gabor::system
