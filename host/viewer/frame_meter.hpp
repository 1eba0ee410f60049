#pragma once

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>

namespace gabor::viewer {

/// Measures the frame rate and how long input takes to reach the screen. Times are in seconds.
class FrameMeter {
  public:
    struct Figures {
        double rate = 0;    ///< frames per second
        double latency = 0; ///< the longest time from an input, just missed by one frame, to its picture
    };

    /// Call when the window has read its input.
    void read(double now) { read_before_ = std::exchange(last_read_, now); }
    /// Call when the frame with that input has been drawn.
    void drawn(double now) {
        if (!read_before_)
            return;
        frames_.emplace_back(now, now - *read_before_);
        while (frames_.front().first < now - 1)
            frames_.pop_front();
    }
    /// Figures of the last second; none before the second frame.
    std::optional<Figures> figures() const {
        if (frames_.size() < 2)
            return {};
        return Figures{static_cast<double>(frames_.size() - 1) /
                           (frames_.back().first - frames_.front().first),
                       std::ranges::max(frames_, {}, &Frame::second).second};
    }

  private:
    using Frame = std::pair<double, double>; ///< when it was drawn, and its latency

    std::optional<double> last_read_;
    std::optional<double> read_before_;
    std::deque<Frame> frames_;
};

} // namespace gabor::viewer
