#pragma once

namespace gabor::viewer {

/// Pixels of a window, a view or a picture.
struct Extent {
    int width = 0;
    int height = 0;
    bool operator==(const Extent&) const = default;
};

} // namespace gabor::viewer
