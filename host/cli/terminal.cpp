#include "cli/terminal.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace gabor::cli {

Progress::Progress(std::string label, std::uint64_t total)
    : label_(std::move(label)), total_(total), terminal_(system::is_terminal()) {}

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

void check_interrupt() {
    if (const int interrupt = system::interrupt())
        throw Interrupted{interrupt};
}

} // namespace gabor::cli
