#include "cli/terminal.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <string_view>
#include <sys/resource.h>
#include <tuple>
#include <unistd.h>

namespace gabor::cli {

namespace {

volatile std::sig_atomic_t noted = 0;

// How long a signalled program may take to clean up.
constexpr unsigned patience = 1; // seconds

// Ends a program that is still waiting, for example for a driver to compile a shader. Calls only what a
// signal handler may call. Incomplete files have no name yet, or a hidden one that the next run removes.
void end(int) {
    constexpr std::string_view clear = "\r\x1b[K", text = ": interrupted; no half-written file was kept\n";
    const std::string_view name = program_invocation_short_name;
    if (isatty(STDERR_FILENO))
        std::ignore = write(STDERR_FILENO, clear.data(), clear.size());
    for (const std::string_view part : {name, text})
        std::ignore = write(STDERR_FILENO, part.data(), part.size());
    std::signal(noted, SIG_DFL);
    std::raise(noted);
}

void note(int signal) {
    noted = signal;
    alarm(patience);
}

} // namespace

Progress::Progress(std::string label, std::uint64_t total)
    : label_(std::move(label)), total_(total), terminal_(isatty(STDERR_FILENO)) {}

Progress::~Progress() {
    if (visible_)
        fmt::print(stderr, "\r\x1b[K");
}

void Progress::advance(std::uint64_t by) {
    using namespace std::chrono_literals;
    check_interrupt();
    done_ += by;
    const Clock::time_point now = Clock::now();
    if (!terminal_ || now - drawn_ < (visible_ ? 100ms : 500ms))
        return;
    const double share = static_cast<double>(done_) / static_cast<double>(total_);
    const double left = seconds_since(start_) * (1 - share) / share;
    fmt::print(stderr, "\r{} {:.0f} %, {:.0f} s left\x1b[K", label_, 100 * share, left);
    std::fflush(stderr);
    drawn_ = now;
    visible_ = true;
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

void check_interrupt() {
    if (noted)
        throw Interrupted{noted};
}

long peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss * 1024;
}

} // namespace gabor::cli
