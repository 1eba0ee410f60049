#include "image/georeference.hpp"

#include "error.hpp"
#include "image/tiff_tags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace gabor::image {

namespace {

// Keys, and their values.
constexpr std::uint16_t model_key = 1024, raster_key = 1025, angular_unit_key = 2054, linear_unit_key = 3076,
                        linear_size_key = 3077, vertical_code_key = 4096, vertical_unit_key = 4099;
constexpr std::uint16_t projected = 1, geographic = 2, point = 2, user_defined = 32767;
constexpr std::uint16_t metre_code = 9001, foot_code = 9002, survey_foot_code = 9003;
constexpr std::uint16_t degree_code = 9102;
constexpr std::uint16_t wgs84_code = 4326;

struct Unit {
    std::string name;
    double metres;
};

const Unit metre{"m", 1}, foot{"ft", 0.3048}, survey_foot{"US survey ft", 1200.0 / 3937};

std::optional<Unit> linear_unit(std::uint16_t code) {
    if (code == metre_code)
        return metre;
    if (code == foot_code)
        return foot;
    if (code == survey_foot_code)
        return survey_foot;
    return {};
}

Unit unit_named(const std::string& name) {
    for (const char* each : {"m", "metre", "meter", "metres", "meters"})
        if (name == each)
            return metre;
    for (const char* each : {"ft", "foot", "feet", "international foot"})
        if (name == each)
            return foot;
    for (const char* each : {"US survey foot", "us-ft", "ftUS", "sfoot", "US survey feet"})
        if (name == each)
            return survey_foot;
    throw RequestError(fmt::format("its heights have the unit '{}', neither metres nor feet", name));
}

// A key is four numbers: its id, the tag that holds its value or 0, a count, and the value or its index.
struct Keys {
    const GeoTags& tags;

    std::optional<std::uint16_t> operator()(std::uint16_t id) const {
        for (std::size_t i = 4; i + 3 < tags.keys.size(); i += 4)
            if (tags.keys[i] == id)
                return tags.keys[i + 3];
        return {};
    }
    double number(std::uint16_t id) const {
        for (std::size_t i = 4; i + 3 < tags.keys.size(); i += 4)
            if (tags.keys[i] == id && tags.keys[i + 1] == numbers_tag &&
                tags.keys[i + 3] < tags.numbers.size())
                return tags.numbers[tags.keys[i + 3]];
        return 0;
    }
};

// How a step of one row or column changes x and y, and the coordinates of the first pixel's corner.
struct Grid {
    double x_by_column, x_by_row, y_by_column, y_by_row, x, y;
};

Grid grid_of(const GeoTags& tags) {
    Grid grid{};
    if (tags.matrix.size() == 16) {
        const std::vector<double>& m = tags.matrix;
        grid = {m[0], m[1], m[4], m[5], m[3], m[7]};
    } else if (tags.pixel_scale.size() >= 2) {
        grid = {tags.pixel_scale[0], 0, 0, -tags.pixel_scale[1], 0, 0};
        if (tags.tie_points.size() >= 6) {
            grid.x = tags.tie_points[3] - grid.x_by_column * tags.tie_points[0];
            grid.y = tags.tie_points[4] - grid.y_by_row * tags.tie_points[1];
        }
    } else {
        throw RequestError("it is placed by control points instead of a pixel scale");
    }
    if (Keys{tags}(raster_key) == point) {
        grid.x -= (grid.x_by_column + grid.x_by_row) / 2;
        grid.y -= (grid.y_by_column + grid.y_by_row) / 2;
    }
    return grid;
}

// Metres per radian of longitude and of latitude: the radii of curvature of the ellipsoid
//     N cos(phi) = a cos(phi) / w,   M = a (1 - e^2) / w^3,   w^2 = 1 - e^2 sin^2(phi)
// (Snyder, Map projections: a working manual, 1987, equations 4-18 to 4-20).
std::array<double, 2> metres_per_radian(double latitude) {
    constexpr double a = 6378137, flattening = 1 / 298.257223563, e2 = flattening * (2 - flattening);
    const double w = std::sqrt(1 - e2 * std::pow(std::sin(latitude), 2));
    return {a * std::cos(latitude) / w, a * (1 - e2) / (w * w * w)};
}

double radians_of(std::uint16_t code) {
    constexpr double degree = std::numbers::pi / 180;
    switch (code) {
    case 9101:
        return 1;
    case degree_code:
    case 9122:
        return degree;
    case 9103:
        return degree / 60;
    case 9104:
        return degree / 3600;
    case 9105:
    case 9106:
        return std::numbers::pi / 200;
    default:
        throw RequestError(fmt::format("its coordinates have the angular unit {} of EPSG", code));
    }
}

// Whether the whole map lies where longitudes and latitudes do, with pixels as small as theirs.
bool looks_like_degrees(const Grid& grid, int width, int height) {
    const double right = grid.x + grid.x_by_column * width, bottom = grid.y + grid.y_by_row * height;
    return std::abs(grid.x_by_column) < 0.5 && std::abs(grid.y_by_row) < 0.5 &&
           std::max({-grid.x, -right, grid.x - 180, right - 180}) <= 180 &&
           std::max(std::abs(grid.y), std::abs(bottom)) <= 90 && (grid.x != 0 || grid.y != 0);
}

} // namespace

PixelSize pixel_size(const GeoTags& tags, int width, int height) {
    const Keys keys{tags};
    const Grid grid = grid_of(tags);
    PixelSize result;
    std::optional<Unit> across, of_heights;
    if (!tags.unit.empty())
        of_heights = unit_named(tags.unit);
    else if (const auto code = keys(vertical_unit_key); code && !(of_heights = linear_unit(*code)))
        throw RequestError(
            fmt::format("its heights have the unit {} of EPSG, neither metres nor feet", *code));
    else if (const auto system = keys(vertical_code_key); !code && system && *system != user_defined)
        of_heights = *system == 8228                      ? foot        // NAVD88
                     : *system == 5702 || *system == 6360 ? survey_foot // NGVD29, NAVD88
                                                          : metre;

    std::array<double, 2> lengths{1, 1}; // of a unit of x and y, in metres
    const std::uint16_t model = keys(model_key).value_or(0);
    if (model == geographic || (model != projected && looks_like_degrees(grid, width, height))) {
        if (model != geographic)
            result.assumed = "its coordinates are taken as degrees";
        const double radian = radians_of(keys(angular_unit_key).value_or(degree_code));
        const double latitude = radian * (grid.y + grid.y_by_column * width / 2 + grid.y_by_row * height / 2);
        if (!(std::abs(latitude) < 0.5 * std::numbers::pi))
            throw RequestError("its middle lies beyond the poles");
        lengths = metres_per_radian(latitude);
        for (double& length : lengths)
            length *= radian;
        across = metre;
    } else if (model == projected || model == 0) {
        if (const auto code = keys(linear_unit_key); code == user_defined) {
            const double metres = keys.number(linear_size_key);
            if (!(metres > 0 && std::isfinite(metres)))
                throw RequestError("its unit of length has no size");
            across = Unit{"", metres};
        } else if (code && !(across = linear_unit(*code))) {
            throw RequestError(
                fmt::format("its coordinates have the unit {} of EPSG, neither metres nor feet", *code));
        } else if (!code && model == projected) {
            result.assumed = fmt::format("its coordinates, without a unit, are taken as metres");
            across = metre;
        } else if (!code && of_heights) {
            result.assumed =
                fmt::format("its coordinates, without a unit, are taken as {}", of_heights->name);
        }
        if (across)
            lengths = {across->metres, across->metres};
    } else {
        throw RequestError(fmt::format("its coordinates are of the kind {} of GeoTIFF, neither projected nor "
                                       "geographic",
                                       model));
    }
    if (!of_heights)
        of_heights = across;
    const double height_unit = across && of_heights ? of_heights->metres : 1;
    if (of_heights)
        result.unit = of_heights->name;

    const std::array columns{grid.x_by_column * lengths[0], grid.y_by_column * lengths[1]},
        rows{grid.x_by_row * lengths[0], grid.y_by_row * lengths[1]};
    result.sides = {std::hypot(columns[0], columns[1]) / height_unit,
                    std::hypot(rows[0], rows[1]) / height_unit};
    const double skew = columns[0] * rows[0] + columns[1] * rows[1];
    constexpr double most_skew = 1e-3; // sine of the angle between rows and columns
    if (!(std::min(result.sides[0], result.sides[1]) > 0) ||
        !std::isfinite(result.sides[0] * result.sides[1]))
        throw RequestError("its pixels have no size");
    if (std::abs(skew) > most_skew * std::hypot(columns[0], columns[1]) * std::hypot(rows[0], rows[1]))
        throw RequestError("its rows and columns are not at right angles");
    return result;
}

GeoTags degree_tags(double longitude, double latitude, double step_x, double step_y) {
    return {.pixel_scale = {step_x, step_y, 0},
            .tie_points = {0, 0, 0, longitude, latitude, 0},
            .matrix = {},
            .keys = {1,    1, 0, 4,          model_key,        0, 1, geographic, raster_key, 0, 1, point,
                     2048, 0, 1, wgs84_code, angular_unit_key, 0, 1, degree_code},
            .numbers = {},
            .text = {},
            .unit = "m"};
}

GeoTags plain_tags(const std::array<double, 2>& sides) {
    GeoTags tags;
    tags.pixel_scale = {sides[0], sides[1], 0};
    tags.tie_points = {0, 0, 0, 0, 0, 0};
    return tags;
}

GeoTags moved(GeoTags tags, int x, int y) {
    if (tags.pixel_scale.size() >= 2 && tags.tie_points.size() >= 6) {
        tags.tie_points[3] += tags.pixel_scale[0] * x;
        tags.tie_points[4] -= tags.pixel_scale[1] * y;
    }
    if (tags.matrix.size() == 16)
        for (const std::size_t row : {0, 4, 8})
            tags.matrix[row + 3] += tags.matrix[row] * x + tags.matrix[row + 1] * y;
    return tags;
}

} // namespace gabor::image
