#include "cli/terminal.hpp"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <sys/resource.h>
#include <unistd.h>

namespace gabor::cli {

namespace {

volatile std::sig_atomic_t noted = 0;

void note(int signal) {
    noted = signal;
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
