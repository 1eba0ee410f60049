#include "error.hpp"
#include "render/request/parameters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

// nlohmann-json finds these conversions by their names.
namespace gabor::noise {

void to_json(nlohmann::ordered_json& entry, const Lobe& lobe) {
    for (const render::LobeParameter& p : render::lobe_parameters())
        entry[std::string(p.name)] = lobe.*p.member;
}

void from_json(const nlohmann::ordered_json& entry, Lobe& lobe) {
    if (!entry.is_object())
        throw RequestError("a lobe must be an object such as {\"frequency\": 4, \"orientation\": 45}");
    const auto rows = render::lobe_parameters();
    for (const auto& [name, value] : entry.items()) {
        const auto found = std::ranges::find(rows, name, &render::LobeParameter::name);
        if (found == rows.end()) {
            std::vector<std::string_view> names;
            std::ranges::transform(rows, std::back_inserter(names), &render::LobeParameter::name);
            throw RequestError(
                fmt::format("unknown '{}' in a lobe: a lobe has {}", name, fmt::join(names, ", ")));
        }
        if (!value.is_number())
            throw RequestError(fmt::format("{} of a lobe must be a number", name));
        lobe.*found->member = value;
    }
}

void to_json(nlohmann::ordered_json& pair, const Colour::Weight& weight) {
    pair = {weight.quadrature, weight.noise};
}

void from_json(const nlohmann::ordered_json& pair, Colour::Weight& weight) {
    weight = {.quadrature = pair.at(0), .noise = pair.at(1)};
}

} // namespace gabor::noise

namespace gabor::render {

namespace {

using Type = Parameter::Type;
using json = nlohmann::ordered_json;
using noise::Lobe;

// Replaces invalid UTF-8, because file names may contain any bytes.
std::string dumped(const json& value) {
    return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::vector<Lobe> lobes_of(const json& list) {
    if (!list.is_array())
        throw RequestError("'lobes' must be a list");
    return list.get<std::vector<Lobe>>();
}

Value value_of(const Parameter& p, const json& value) {
    const auto must = [&](bool holds) {
        if (!holds)
            throw RequestError(fmt::format("{} '{}': expected {}", p.name, dumped(value), accepted(p)));
    };
    switch (p.type) {
    case Type::flag:
        must(value.is_boolean());
        return value.get<bool>();
    case Type::integer:
        must(value.is_number_integer());
        return value.get<double>();
    case Type::number:
    case Type::angle:
        must(value.is_number());
        return value.get<double>();
    case Type::lobes:
        return lobes_of(value);
    case Type::colour:
        if (value.is_string())
            return with_prefix(fmt::format("{} ", p.name), [&] { return read(p, value.get<std::string>()); });
        must(value.is_array() && value.size() == 3 &&
             std::ranges::all_of(value, [](const json& part) { return part.is_number(); }));
        return value.get<std::array<double, 3>>();
    default: // the names of some choices are numbers
        must(value.is_string() || value.is_number_integer());
        return value.is_string() ? value.get<std::string>() : dumped(value);
    }
}

json json_of(const Parameter& p, const Value& value) {
    if (p.type == Type::integer)
        return static_cast<std::int64_t>(std::get<double>(value));
    return std::visit([](const auto& held) { return json(held); }, value);
}

json json_of(const noise::Colour& colour) {
    json object{{"weights", colour.weights},
                {"histogram", colour.histogram},
                {"mean", colour.mean},
                {"mixing", colour.mixing}};
    if (colour.linear)
        object["linear"] = true;
    return object;
}

noise::Colour colour_of(json object) {
    try {
        noise::Colour colour;
        colour.linear = object.value("linear", false);
        object.at("weights").get_to(colour.weights);
        object.at("histogram").get_to(colour.histogram);
        object.at("mean").get_to(colour.mean);
        object.at("mixing").get_to(colour.mixing);
        if (!colour.linear)
            object.erase("linear");
        const json written = json_of(colour);
        if (object.size() == written.size() && std::ranges::all_of(written.items(), [&](const auto& member) {
                return object.at(member.key()) == member.value(); // false if the JSON has more elements
            }))
            return colour;
    } catch (const json::exception&) {
    }
    throw RequestError("a colour has weights (a list with three pairs of numbers for each lobe), histogram "
                       "(three lists of six numbers), mean (three numbers), mixing (three lists of three "
                       "numbers) and, optionally, linear (true or false)");
}

} // namespace

std::string to_json(const Request& request) {
    json object;
    // A single lobe is written as separate values if its other values are defaults.
    const Lobe& lobe = request.lobes.front();
    const bool by_values =
        request.lobes.size() == 1 && lobe.power == 1 && lobe.radii() == std::array{1.0, 1.0};
    for (const Parameter& p : parameters())
        if (const std::optional<Value> value = p.get(request); value && !(p.type == Type::lobes && by_values))
            object[std::string(p.name)] = json_of(p, *value);
    if (request.colour)
        object["colour"] = json_of(*request.colour);
    return dumped(object);
}

Request from_json(std::string_view text) {
    const json object = json::parse(text, nullptr, false);
    if (!object.is_object())
        throw RequestError("the parameters are not a JSON object");
    Values values;
    Request request;
    for (const auto& [name, entry] : object.items()) {
        if (name == "viewer") // how gabor-viewer shows the picture
            continue;
        if (name == "colour") {
            request.colour = colour_of(entry);
            continue;
        }
        const Parameter& p = parameter(name);
        values.emplace_back(&p, value_of(p, entry));
    }
    set(request, values);
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
    return dumped(json(lobes));
}

} // namespace gabor::render
