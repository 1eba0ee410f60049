#include "viewer/frame_meter.hpp"

#include <algorithm>
#include <utility>

namespace gabor::viewer {

void FrameMeter::read(double now) {
    read_before_ = std::exchange(last_read_, now);
}

void FrameMeter::drawn(double now) {
    if (!read_before_)
        return;
    frames_.push_back({now, now - *read_before_});
    while (frames_.front().drawn < now - 1)
        frames_.pop_front();
}

std::optional<FrameMeter::Figures> FrameMeter::figures() const {
    if (frames_.size() < 2)
        return {};
    return Figures{static_cast<double>(frames_.size() - 1) / (frames_.back().drawn - frames_.front().drawn),
                   std::ranges::max(frames_, {}, &Frame::latency).latency};
}

} // namespace gabor::viewer
