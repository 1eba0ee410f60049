#pragma once

#include "seconds.hpp"

#include <cstdint>
#include <string>

namespace gabor::cli {

/// Thrown by Progress::advance and `check_interrupt` after SIGINT or SIGTERM.
struct Interrupted {
    int signal;
};

/// Shows the progress of a long task and the remaining time on the terminal's last line. Prints nothing in
/// the first half second, or if stderr is not a terminal.
class Progress {
  public:
    Progress(std::string label, std::uint64_t total);
    ~Progress();

    /// Counts finished work. Throws Interrupted if a signal noted by `note_interrupts` has arrived.
    void advance(std::uint64_t by);

  private:
    std::string label_;
    std::uint64_t total_;
    std::uint64_t done_ = 0;
    Clock::time_point start_ = Clock::now();
    Clock::time_point drawn_ = start_;
    bool terminal_;
    bool visible_ = false;
};

/// Makes SIGINT and SIGTERM set a flag instead of terminating the process. A process that has not ended a
/// second later terminates at once.
void note_interrupts();

/// Throws Interrupted after SIGINT or SIGTERM. Long tasks without a Progress must call this function.
void check_interrupt();

/// The largest resident memory of this process so far, in bytes.
long peak_memory();

} // namespace gabor::cli
