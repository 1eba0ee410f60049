#pragma once

#include "seconds.hpp"
#include "system/process.hpp"

#include <cstdint>
#include <string>

namespace gabor::cli {

/// Progress::advance and `check_interrupt` throw this after a request to end, such as Ctrl-C.
struct Interrupted {
    int by; ///< as from system::interrupt
};

/// Shows the progress of a long task and the remaining time on the terminal's last line. Prints nothing in
/// the first half second, or if stderr is not a terminal.
class Progress {
  public:
    Progress(std::string label, std::uint64_t total);
    ~Progress();

    /// Counts finished work. Throws Interrupted if system::note_interrupts noted a request to end.
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

/// Throws Interrupted if system::note_interrupts noted a request to end. Long tasks without a Progress must
/// call this function.
void check_interrupt();

} // namespace gabor::cli
