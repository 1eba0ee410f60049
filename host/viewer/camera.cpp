#include "viewer/camera.hpp"

#include <cmath>

namespace gabor::viewer {

Coordinate Coordinate::moved(double by) const {
    const double carried = std::floor(by);
    Coordinate result{whole + static_cast<std::int64_t>(carried), part + (by - carried)};
    if (result.part >= 1) {
        ++result.whole;
        result.part -= 1;
    }
    return result;
}

void add_places(std::vector<AxisPlace>& places, const Coordinate& middle, int pixels, double scale, int stride,
                double radius) {
    const int count = (pixels + stride - 1) / stride;
    const long double far = static_cast<long double>(middle.whole) * radius;
    const long double base = std::floor(far);
    const double rest = static_cast<double>(far - base) + middle.part * radius;
    for (int i = 0; i < count; ++i) {
        const double cells = rest + ((i + 0.5) * stride - pixels / 2.0) / scale * radius;
        const double whole = std::floor(cells);
        const auto cell = static_cast<std::int64_t>(base) + static_cast<std::int64_t>(whole);
        places.push_back({static_cast<std::int32_t>(static_cast<std::uint32_t>(cell)), static_cast<float>(cells - whole)});
    }
}

} // namespace gabor::viewer
