#include "render/picture.hpp"

#include "error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace gabor::render {

namespace {

void check_range(std::string_view name, double value, double low, double high) {
    if (!(value >= low && value <= high))
        throw RequestError(fmt::format("{} is {}: it must be from {} to {}", name, value, low, high));
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

std::string to_json(const Picture& picture) {
    nlohmann::ordered_json json;
    json["recipe"] = picture.recipe;
    json["frequency"] = picture.frequency;
    json["orientation"] = picture.orientation;
    json["seed"] = picture.seed;
    json["scale"] = picture.scale;
    json["width"] = picture.width;
    json["height"] = picture.height;
    json["tileable"] = picture.tileable;
    json["time"] = picture.time;
    return json.dump();
}

Picture from_json(std::string_view text) {
    const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
    if (!json.is_object())
        throw RequestError("the parameters are not a JSON object");
    Picture picture;
    for (const auto& [name, value] : json.items()) {
        if (name == "recipe")
            take(value, name, picture.recipe);
        else if (name == "frequency")
            take(value, name, picture.frequency);
        else if (name == "orientation")
            take(value, name, picture.orientation);
        else if (name == "seed")
            take(value, name, picture.seed);
        else if (name == "scale")
            take(value, name, picture.scale);
        else if (name == "width")
            take(value, name, picture.width);
        else if (name == "height")
            take(value, name, picture.height);
        else if (name == "tileable")
            take(value, name, picture.tileable);
        else if (name == "time")
            take(value, name, picture.time);
        else
            throw RequestError(
                fmt::format("unknown parameter '{}': the parameters are recipe, frequency, orientation, "
                            "seed, scale, width, height, tileable, time",
                            name));
    }
    check(picture);
    return picture;
}

} // namespace gabor::render
