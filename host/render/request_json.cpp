#include "error.hpp"
#include "render/parameters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace gabor::render {

namespace {

using Kind = Parameter::Kind;
using nlohmann::json;
using nlohmann::ordered_json;
using noise::Lobe;

// Replaces invalid UTF-8, because file names may contain any bytes.
template <typename Json>
std::string dumped(const Json& value) {
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Lobe lobe_of(const json& entry) {
    if (!entry.is_object())
        throw RequestError("a lobe must be an object such as {\"frequency\": 4, \"orientation\": 45}");
    Lobe lobe;
    for (const auto& [name, value] : entry.items()) {
        const auto found = std::ranges::find(lobe_parameters(), name, &LobeParameter::name);
        if (found == lobe_parameters().end()) {
            std::vector<std::string_view> names;
            std::ranges::transform(lobe_parameters(), std::back_inserter(names), &LobeParameter::name);
            throw RequestError(
                fmt::format("unknown '{}' in a lobe: a lobe has {}", name, fmt::join(names, ", ")));
        }
        if (!value.is_number())
            throw RequestError(fmt::format("{} of a lobe must be a number", name));
        lobe.*found->member = value.get<double>();
    }
    return lobe;
}

std::vector<Lobe> lobes_of(const json& list) {
    if (!list.is_array())
        throw RequestError("'lobes' must be a list");
    std::vector<Lobe> lobes;
    std::ranges::transform(list, std::back_inserter(lobes), lobe_of);
    return lobes;
}

ordered_json json_of(const std::vector<Lobe>& lobes) {
    ordered_json list = ordered_json::array();
    for (const Lobe& lobe : lobes) {
        ordered_json& entry = list.emplace_back();
        for (const LobeParameter& p : lobe_parameters())
            entry[std::string(p.name)] = lobe.*p.member;
    }
    return list;
}

Value value_of(const Parameter& p, const json& value) {
    const auto must = [&](bool holds) {
        if (!holds)
            throw RequestError(fmt::format("{} '{}': expected {}", p.name, dumped(value), accepted(p)));
    };
    switch (p.kind) {
    case Kind::flag:
        must(value.is_boolean());
        return value.get<bool>();
    case Kind::integer:
        must(value.is_number_integer());
        return value.get<double>();
    case Kind::number:
    case Kind::angle:
        must(value.is_number());
        return value.get<double>();
    case Kind::lobes:
        return lobes_of(value);
    case Kind::colour:
        if (value.is_string())
            return with_prefix(fmt::format("{} ", p.name), [&] { return read(p, value.get<std::string>()); });
        must(value.is_array() && value.size() == 3 &&
             std::ranges::all_of(value, [](const json& part) { return part.is_number(); }));
        return value.get<std::array<double, 3>>();
    default:
        must(value.is_string());
        return value.get<std::string>();
    }
}

ordered_json json_of(const Parameter& p, const Value& value) {
    if (p.kind == Kind::integer)
        return static_cast<std::int64_t>(std::get<double>(value));
    if (const auto* lobes = std::get_if<std::vector<Lobe>>(&value))
        return json_of(*lobes);
    if (const auto* text = std::get_if<std::string>(&value))
        return *text;
    if (const auto* number = std::get_if<double>(&value))
        return *number;
    if (const auto* colour = std::get_if<std::array<double, 3>>(&value))
        return *colour;
    return std::get<bool>(value);
}

// Reads nested lists with the lengths of the array.
template <typename T, std::size_t count>
void read_numbers(std::array<T, count>& values, const json& list, std::string_view name) {
    if (!list.is_array() || list.size() != count)
        throw RequestError(fmt::format("{} of a colour must be a list of {}", name, count));
    for (std::size_t i = 0; i < count; ++i) {
        if constexpr (std::is_same_v<T, double>) {
            if (!list[i].is_number())
                throw RequestError(fmt::format("{} of a colour must consist of numbers", name));
            values[i] = list[i].get<double>();
        } else {
            read_numbers(values[i], list[i], name);
        }
    }
}

using Weights = std::array<std::array<double, 2>, 3>; // (quadrature, noise)

noise::Colour colour_of(const json& object) {
    if (!object.is_object())
        throw RequestError("the colour must be an object");
    for (const char* name : {"weights", "histogram", "mean", "mixing"})
        if (!object.contains(name))
            throw RequestError(fmt::format("the colour has no '{}'", name));
    const json linear = object.value("linear", json(false));
    if (object.size() != (object.contains("linear") ? 5 : 4) || !object["weights"].is_array() ||
        !linear.is_boolean())
        throw RequestError(
            "a colour has weights (one set per lobe), histogram, mean, mixing and, optionally, linear");
    noise::Colour colour;
    colour.linear = linear;
    for (const json& entry : object["weights"]) {
        Weights weights{};
        read_numbers(weights, entry, "weights");
        auto& to = colour.weights.emplace_back();
        std::ranges::transform(weights, to.begin(), [](const auto& w) {
            return noise::Colour::Weight{.quadrature = w[0], .noise = w[1]};
        });
    }
    read_numbers(colour.histogram, object["histogram"], "histogram");
    read_numbers(colour.mean, object["mean"], "mean");
    read_numbers(colour.mixing, object["mixing"], "mixing");
    return colour;
}

ordered_json json_of(const noise::Colour& colour) {
    ordered_json list = ordered_json::array();
    for (const auto& weights : colour.weights) {
        Weights numbers{};
        std::ranges::transform(weights, numbers.begin(), [](const noise::Colour::Weight& w) {
            return std::array{w.quadrature, w.noise};
        });
        list.push_back(numbers);
    }
    ordered_json object{{"weights", std::move(list)},
                        {"histogram", colour.histogram},
                        {"mean", colour.mean},
                        {"mixing", colour.mixing}};
    if (colour.linear)
        object["linear"] = true;
    return object;
}

bool is_of_lobe(const Parameter& p) {
    return std::ranges::find(lobe_parameters(), p.name, &LobeParameter::name) != lobe_parameters().end();
}

} // namespace

std::string to_json(const Request& request) {
    Request drawn = request;
    drawn.recipe = drawing_recipe(request);
    ordered_json object;
    // A single lobe is written as separate values if its other values are defaults.
    const Lobe& lobe = request.lobes.front();
    const bool by_values =
        request.lobes.size() == 1 && lobe.power == 1 && lobe.radii() == std::array{1.0, 1.0};
    for (const Parameter& p : parameters())
        if (const std::optional<Value> value = p.get(drawn); value && !(p.kind == Kind::lobes && by_values))
            object[std::string(p.name)] = json_of(p, *value);
    if (request.colour)
        object["colour"] = json_of(*request.colour);
    return dumped(object);
}

Request from_json(std::string_view text) {
    const json object = json::parse(text, nullptr, false);
    if (!object.is_object())
        throw RequestError("the parameters are not a JSON object");
    Values deciding; // decide which other parameters exist
    Values others;
    bool has_lobes = false;
    Request request;
    for (const auto& [name, entry] : object.items()) {
        if (name == "sum" || name == "viewer") // written by versions before 1.1.0 and by gabor-viewer
            continue;
        if (name == "colour") {
            request.colour = colour_of(entry);
            continue;
        }
        const Parameter& p = parameter(name);
        const Value value = value_of(p, entry);
        const auto* lobes = std::get_if<std::vector<Lobe>>(&value);
        if (lobes && lobes->empty())
            continue; // the other values describe the lobe
        has_lobes |= lobes != nullptr;
        (lobes || p.kind == Kind::choice ? deciding : others).emplace_back(&p, value);
    }
    set(request, deciding);
    std::erase_if(others, [&](const auto& each) {
        return !each.first->get(request) || (has_lobes && is_of_lobe(*each.first));
    });
    set(request, others);
    check(request);
    return request;
}

std::vector<Lobe> lobes_from_json(std::string_view text) {
    const json list = json::parse(text, nullptr, false);
    if (list.is_object() && !list.contains("lobes"))
        throw RequestError("the object has no 'lobes'");
    if (!list.is_object() && !list.is_array())
        throw RequestError("expected a JSON list of lobes or an object with 'lobes'");
    return lobes_of(list.is_object() ? list["lobes"] : list);
}

std::string lobes_to_json(const std::vector<Lobe>& lobes) {
    return dumped(json_of(lobes));
}

} // namespace gabor::render
