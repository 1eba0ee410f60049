#pragma once

namespace gabor::viewer {

/// The size of a window, a view or a picture, in pixels.
struct Extent {
    int width = 0;
    int height = 0;
    bool operator==(const Extent&) const = default;
};

} // namespace gabor::viewer
