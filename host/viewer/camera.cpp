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

AxisPlace place_at(const Coordinate& coordinate, double by, double radius) {
    const long double far = static_cast<long double>(coordinate.whole) * radius;
    const long double base = std::floor(far);
    const double cells = static_cast<double>(far - base) + (coordinate.part + by) * radius;
    const double whole = std::floor(cells);
    const auto cell = static_cast<std::int64_t>(base) + static_cast<std::int64_t>(whole);
    return {static_cast<std::int32_t>(static_cast<std::uint32_t>(cell)), static_cast<float>(cells - whole)};
}

void add_places(std::vector<AxisPlace>& places, const Coordinate& middle, int pixels, double scale,
                int stride, double radius) {
    const int count = (pixels + stride - 1) / stride;
    for (int i = 0; i < count; ++i)
        places.push_back(place_at(middle, ((i + 0.5) * stride - pixels / 2.0) / scale, radius));
}

} // namespace gabor::viewer
