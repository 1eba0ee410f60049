#include "render/picture.hpp"

#include "error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gabor::render {

namespace {

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
    use("frequency_spread", picture.frequency_spread);
    use("orientation_spread", picture.orientation_spread);
    use("lobes", picture.lobes);
    use("sum", picture.sum);
    use("filter", picture.filter);
    use("view", picture.view);
    use("paint", picture.paint);
    use("phasor", picture.phasor);
    use("values", picture.values);
    use("solid", picture.solid);
    use("depth", picture.depth);
}

template <typename AnyLobe, typename Use>
void for_each_value(AnyLobe& lobe, Use use) {
    use("frequency", lobe.frequency);
    use("orientation", lobe.orientation);
    use("frequency_spread", lobe.frequency_spread);
    use("orientation_spread", lobe.orientation_spread);
    use("power", lobe.power);
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

void take(const nlohmann::json& value, std::string_view name, std::vector<Lobe>& into);

// Takes what a JSON object has of the parameters that `for_each` names; `of` is whose they are.
template <typename Object, typename ForEach>
void take_object(const nlohmann::json& json, Object& object, ForEach for_each, std::string_view of) {
    std::vector<std::string_view> known;
    for_each(object, [&](std::string_view name, auto& into) {
        known.push_back(name);
        if (const auto found = json.find(name); found != json.end())
            take(*found, name, into);
    });
    for (const auto& [name, value] : json.items())
        if (std::ranges::find(known, name) == known.end())
            throw RequestError(
                fmt::format("unknown {} '{}': the {}s are {}", of, name, of, fmt::join(known, ", ")));
}

void take(const nlohmann::json& value, std::string_view name, std::vector<Lobe>& into) {
    if (!value.is_array())
        throw RequestError(fmt::format("parameter '{}' must be a list of lobes", name));
    into.clear();
    for (const nlohmann::json& entry : value) {
        if (!entry.is_object())
            throw RequestError("a lobe must be an object such as {\"frequency\": 4, \"orientation\": 45}");
        take_object(
            entry, into.emplace_back(), [](auto& lobe, auto use) { for_each_value(lobe, use); },
            "value of a lobe");
        if (into.size() > largest_spectrum)
            throw RequestError(fmt::format("a spectrum may have {} lobes", largest_spectrum));
    }
}

nlohmann::ordered_json written(const std::vector<Lobe>& lobes) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Lobe& lobe : lobes) {
        nlohmann::ordered_json entry;
        for_each_value(lobe, [&](std::string_view name, double value) { entry[std::string(name)] = value; });
        list.push_back(entry);
    }
    return list;
}

template <typename T>
const T& written(const T& value) {
    return value;
}

void check_lobe(const Lobe& lobe) {
    check_range("frequency", lobe.frequency, smallest_frequency, largest_frequency);
    check_range("orientation", lobe.orientation, -36000, 36000);
    check_range("frequency_spread", lobe.frequency_spread, 0, 1);
    check_range("orientation_spread", lobe.orientation_spread, 0, 90);
    check_range("power", lobe.power, 0, 1e9);
}

// Whether two things that exclude each other are asked for.
void check_excluded(bool both, std::string_view what) {
    if (both)
        throw RequestError(fmt::format("{}: they exclude each other", what));
}

// Noise in space has neither lobes nor spreads other than none and all, and its own recipe.
void check_in_space(const Picture& picture) {
    if (!picture.lobes.empty() || picture.frequency_spread != 0 ||
        (picture.orientation_spread != 0 && picture.orientation_spread != 90))
        throw RequestError(fmt::format(
            "view {}: noise in space has one frequency, and an orientation_spread of 0 or 90", picture.view));
    if (picture.recipe != noise::recipes().front().name)
        throw RequestError(fmt::format("view {}: noise in space has a recipe of its own", picture.view));
    if (picture.quadrature || picture.gradient || picture.phasor || picture.values > 1 || picture.time != 0)
        throw RequestError(fmt::format(
            "view {}: it has no quadrature, gradient, phasor, further values or time", picture.view));
}

} // namespace

void check_range(std::string_view name, double value, double low, double high) {
    if (!(value >= low && value <= high))
        throw RequestError(fmt::format("{} is {}: it must be from {} to {}", name, value, low, high));
}

void check(const Picture& picture) {
    check_range("width", picture.width, 1, largest_side);
    check_range("height", picture.height, 1, largest_side);
    check_range("scale", picture.scale, smallest_scale, largest_scale);
    check_lobe(
        {picture.frequency, picture.orientation, picture.frequency_spread, picture.orientation_spread});
    std::ranges::for_each(picture.lobes, check_lobe);
    if (!picture.lobes.empty() &&
        std::ranges::none_of(picture.lobes, [](const Lobe& lobe) { return lobe.power > 0; }))
        throw RequestError("no lobe has any power: at least one must");
    check_range("values", picture.values, 1, 4);
    if (std::ranges::find(views(), picture.view) == views().end())
        throw RequestError(
            fmt::format("unknown view '{}': the views are {}", picture.view, fmt::join(views(), ", ")));
    check_excluded(picture.tileable && picture.view != "flat",
                   fmt::format("tileable and view {}", picture.view));
    check_excluded(picture.filter && picture.gradient, "filter and gradient");
    check_excluded(picture.filter && picture.values > 1, "filter and several values");
    check_excluded(!picture.paint.empty() && !picture.lobes.empty(), "paint and lobes");
    check_range("depth", picture.depth, -1e6, 1e6);
    if (is_in_space(picture))
        check_in_space(picture);
    check_excluded(!picture.paint.empty() && picture.view != "flat",
                   fmt::format("paint and view {}", picture.view));
    check_range("time", picture.time, -1e6, 1e6);
    noise::find_recipe(picture.recipe);
    if (picture.tileable && std::min(picture.width, picture.height) < 2 * picture.scale)
        throw RequestError(
            fmt::format("a tileable picture of {} x {} pixels at scale {}: each side must be at least two "
                        "kernel radii, {} pixels",
                        picture.width, picture.height, picture.scale, std::ceil(2 * picture.scale)));
}

std::span<const std::string_view> views() {
    static constexpr std::array<std::string_view, 5> all{"flat", "horizon", "slice", "sphere", "torus"};
    return all;
}

bool is_in_space(const Picture& picture) {
    return picture.view == "slice" || picture.view == "sphere" || picture.view == "torus";
}

std::vector<noise::Lobe> spectrum(const Picture& picture) {
    std::vector<Lobe> lobes = picture.lobes;
    if (lobes.empty())
        lobes.push_back(
            {picture.frequency, picture.orientation, picture.frequency_spread, picture.orientation_spread});
    std::vector<noise::Lobe> spectrum;
    for (const Lobe& lobe : lobes) {
        const auto radians = [](double degrees) {
            return std::remainder(degrees, 360.0) * std::numbers::pi / 180;
        };
        spectrum.push_back({lobe.frequency, radians(lobe.orientation), lobe.frequency_spread,
                            radians(lobe.orientation_spread), lobe.power});
    }
    return spectrum;
}

std::vector<std::string> channels(const Picture& picture) {
    if (is_in_space(picture))
        return {"Y", "A"};
    constexpr std::array noises{"Y", "second", "third", "fourth"};
    std::vector<std::string> names(noises.begin(), noises.begin() + picture.values);
    if (picture.quadrature)
        names.push_back("quadrature");
    if (picture.gradient)
        names.insert(names.end(), {"gradient.x", "gradient.y"});
    if (picture.phasor)
        names.insert(names.end(), {"phase", "intensity"});
    if (picture.filter)
        names.push_back("removed");
    return names;
}

std::string to_json(const Picture& picture) {
    nlohmann::ordered_json json;
    for_each_parameter(
        picture, [&](std::string_view name, const auto& value) { json[std::string(name)] = written(value); });
    return json.dump();
}

Picture from_json(std::string_view text) {
    const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
    if (!json.is_object())
        throw RequestError("the parameters are not a JSON object");
    Picture picture;
    take_object(
        json, picture, [](auto& taken, auto use) { for_each_parameter(taken, use); }, "parameter");
    check(picture);
    return picture;
}

std::vector<Lobe> lobes_from_json(std::string_view text) {
    const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
    if (json.is_object() && !json.contains("lobes"))
        throw RequestError("the object has no 'lobes'");
    if (!json.is_object() && !json.is_array())
        throw RequestError("not a JSON list of lobes, nor an object with 'lobes'");
    std::vector<Lobe> lobes;
    take(json.is_object() ? json["lobes"] : json, "lobes", lobes);
    if (lobes.empty())
        throw RequestError("the list of lobes is empty");
    return lobes;
}

} // namespace gabor::render
