#pragma once

#include <deque>
#include <optional>

namespace gabor::viewer {

/// How fast frames follow each other, and how long the window takes to show what was done in it. Times in
/// seconds.
class FrameMeter {
  public:
    struct Figures {
        double rate = 0; ///< frames per second
        /// The longest from input to the end of the drawing that shows it. Input waits for the next time that
        /// the window reads any, and may have come just after the last.
        double latency = 0;
    };

    /// The window has read its input.
    void read(double now);
    /// What it came to has been drawn.
    void drawn(double now);
    /// Of the last second; none before two frames have been drawn.
    std::optional<Figures> figures() const;

  private:
    struct Frame {
        double drawn;
        double latency;
    };

    std::optional<double> last_read_;
    std::optional<double> read_before_;
    std::deque<Frame> frames_;
};

} // namespace gabor::viewer
