#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace gabor::cli {

/// A line on the terminal that shows how far long work has come and how long it will still take. Silent when
/// stderr is not a terminal, and in the first half second.
class Progress {
  public:
    Progress(std::string label, std::uint64_t total);
    ~Progress();

    void advance(std::uint64_t by);

  private:
    using Clock = std::chrono::steady_clock;
    std::string label_;
    std::uint64_t total_;
    std::uint64_t done_ = 0;
    Clock::time_point start_ = Clock::now();
    Clock::time_point drawn_ = start_;
    bool terminal_;
    bool visible_ = false;
};

/// Thrown by `check_interrupt` after SIGINT or SIGTERM.
struct Interrupted {
    int signal;
};

/// From now on SIGINT and SIGTERM are noted instead of ending the process.
void note_interrupts();

/// Throws Interrupted once a signal was noted. Long work calls it between its parts.
void check_interrupt();

/// The most memory that this process has had resident so far, bytes.
long peak_memory();

} // namespace gabor::cli
