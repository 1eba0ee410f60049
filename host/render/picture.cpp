#include "render/picture.hpp"

#include "error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace gabor::render {

namespace {

void check_range(std::string_view name, double value, double low, double high) {
    if (!(value >= low && value <= high))
        throw RequestError(fmt::format("{} is {}: it must be from {} to {}", name, value, low, high));
}

// Calls `use` with the name and the value of each, in the order in which files list them.
template <typename AnyPicture, typename Use>
void for_each_parameter(AnyPicture& picture, Use use) {
    use("recipe", picture.recipe);
    use("frequency", picture.frequency);
    use("orientation", picture.orientation);
    use("seed", picture.seed);
    use("scale", picture.scale);
    use("width", picture.width);
    use("height", picture.height);
    use("tileable", picture.tileable);
    use("time", picture.time);
    use("quadrature", picture.quadrature);
    use("gradient", picture.gradient);
}

template <typename T>
void take(const nlohmann::json& value, std::string_view name, T& into) {
    // nlohmann converts between numbers silently; only what fits exactly is meant.
    if constexpr (std::is_same_v<T, std::string>) {
        if (!value.is_string())
            throw RequestError(fmt::format("parameter '{}' must be a string", name));
    } else if constexpr (std::is_same_v<T, bool>) {
        if (!value.is_boolean())
            throw RequestError(fmt::format("parameter '{}' must be true or false", name));
    } else if constexpr (std::is_integral_v<T>) {
        if (!value.is_number_integer() || !std::in_range<T>(value.get<std::int64_t>()))
            throw RequestError(
                fmt::format("parameter '{}' must be an integer of {} bits", name, 8 * sizeof(T)));
    } else {
        if (!value.is_number())
            throw RequestError(fmt::format("parameter '{}' must be a number", name));
    }
    into = value.get<T>();
}

} // namespace

void check(const Picture& picture) {
    check_range("width", picture.width, 1, largest_side);
    check_range("height", picture.height, 1, largest_side);
    check_range("scale", picture.scale, smallest_scale, largest_scale);
    check_range("frequency", picture.frequency, smallest_frequency, largest_frequency);
    check_range("orientation", picture.orientation, -36000, 36000);
    check_range("time", picture.time, -1e6, 1e6);
    noise::find_recipe(picture.recipe);
    if (picture.tileable && std::min(picture.width, picture.height) < 2 * picture.scale)
        throw RequestError(
            fmt::format("a tileable picture of {} x {} pixels at scale {}: each side must be at least two "
                        "kernel radii, {} pixels",
                        picture.width, picture.height, picture.scale, std::ceil(2 * picture.scale)));
}

std::vector<std::string> channels(const Picture& picture) {
    std::vector<std::string> names{"Y"};
    if (picture.quadrature)
        names.push_back("quadrature");
    if (picture.gradient)
        names.insert(names.end(), {"gradient.x", "gradient.y"});
    return names;
}

std::string to_json(const Picture& picture) {
    nlohmann::ordered_json json;
    for_each_parameter(picture,
                       [&](std::string_view name, const auto& value) { json[std::string(name)] = value; });
    return json.dump();
}

Picture from_json(std::string_view text) {
    const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
    if (!json.is_object())
        throw RequestError("the parameters are not a JSON object");
    Picture picture;
    std::vector<std::string_view> known;
    for_each_parameter(picture, [&](std::string_view name, auto& into) {
        known.push_back(name);
        if (const auto found = json.find(name); found != json.end())
            take(*found, name, into);
    });
    for (const auto& [name, value] : json.items())
        if (std::ranges::find(known, name) == known.end())
            throw RequestError(
                fmt::format("unknown parameter '{}': the parameters are {}", name, fmt::join(known, ", ")));
    check(picture);
    return picture;
}

} // namespace gabor::render
