#include "viewer/document_json.hpp"

#include "error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <type_traits>

namespace gabor::viewer {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::array<std::string_view, 2> normal_maps{"OpenGL", "DirectX"};

// Visits each choice of the window: its key, the names of what can be chosen, and the chosen one's index.
template <typename Document, typename Visit>
void visit_choices(Document& document, Visit visit) {
    visit("output", output_names, document.output);
    visit("look", look_names, document.look);
    visit("normals", normal_maps, document.directx_normals);
    visit("colours", colour_names, document.colours);
    visit("profile", profile_names, document.profile);
}

ordered_json json_of(const Camera& camera) {
    return {{"x", {camera.x.whole, camera.x.part}},
            {"y", {camera.y.whole, camera.y.part}},
            {"zoom", camera.zoom}};
}

Camera camera_of(const json& object) {
    const auto coordinate = [&](const char* axis) {
        return Coordinate{object.at(axis).at(0).get<std::int64_t>(), 0}.moved(
            object.at(axis).at(1).get<double>());
    };
    return {coordinate("x"), coordinate("y"), std::clamp(object.at("zoom").get<double>(), 1e-3, 1e3)};
}

// Reads [[position, "#rrggbb"], ...] and sorts the stops by position.
std::vector<ColourStop> ramp_of(const json& stops) {
    std::vector<ColourStop> ramp;
    for (const json& stop : stops) {
        ColourStop& read = ramp.emplace_back();
        read.at = stop.at(0).get<float>();
        unsigned int code = 0;
        const std::string text = stop.at(1).get<std::string>();
        if (text.size() != 7 || std::sscanf(text.c_str(), "#%6x", &code) != 1 ||
            !(read.at >= 0 && read.at <= 1))
            throw RequestError(fmt::format(
                "ramp {}: expected positions from 0 to 1 with colours such as #8a5c34", stop.dump()));
        for (std::size_t i = 0; i < 3; ++i)
            read.colour.at(i) = static_cast<float>(code >> (16 - 8 * i) & 255) / 255;
    }
    if (ramp.size() < 2 || ramp.size() > most_stops)
        throw RequestError(fmt::format("ramp: expected 2 to {} colours", most_stops));
    std::ranges::stable_sort(ramp, {}, &ColourStop::at);
    return ramp;
}

json json_of(const std::vector<ColourStop>& ramp) {
    json stops = json::array();
    for (const ColourStop& stop : ramp)
        stops.push_back({stop.at, hex(stop.colour)});
    return stops;
}

void read_view(const json& view, Document& document) {
    const auto choice = [&](const char* key, const auto& names, auto& number) {
        if (!view.contains(key))
            return;
        const json& value = view[key];
        const auto found =
            value.is_string() ? std::ranges::find(names, value.get<std::string>()) : names.end();
        if (found == names.end())
            throw RequestError(fmt::format("{} {}: expected {}", key, value.dump(), fmt::join(names, ", ")));
        number = static_cast<std::remove_reference_t<decltype(number)>>(found - names.begin());
    };
    visit_choices(document, choice);
    choice("environment", render::environments, document.request.environment);
    if (view.contains("ramp"))
        document.ramp = ramp_of(view["ramp"]);
    if (view.contains("contrast"))
        document.contrast = std::clamp(view["contrast"].get<float>(), least_contrast, most_contrast);
    if (view.contains("light")) {
        document.request.light_azimuth = view["light"].at(0).get<double>();
        document.request.light_elevation = std::clamp(view["light"].at(1).get<double>(), 0.0, 90.0);
    }
    if (view.contains("camera"))
        document.camera = camera_of(view["camera"]);
}

} // namespace

std::string to_json(const Document& document) {
    ordered_json object = ordered_json::parse(render::to_json(document.request));
    ordered_json& view = object["viewer"];
    visit_choices(document, [&](const char* key, const auto& names, auto number) {
        view[key] = names.at(static_cast<std::size_t>(number));
    });
    view["contrast"] = document.contrast;
    view["camera"] = json_of(document.camera);
    if (document.ramp != Document().ramp)
        view["ramp"] = json_of(document.ramp);
    if (!render::is_surface(document.request.kind)) { // a material's request contains both
        view["light"] = {document.request.light_azimuth, document.request.light_elevation};
        view["environment"] = render::environments.at(static_cast<std::size_t>(document.request.environment));
    }
    return object.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

Document document_from_json(std::string_view text, const Document& defaults) {
    Document document = defaults;
    document.request = render::from_json(text);
    document.camera = render::default_camera(document.request);
    const json object = json::parse(text);
    try {
        if (object.contains("viewer"))
            with_prefix("viewer: ", [&] { read_view(object["viewer"], document); });
    } catch (const json::exception& error) {
        throw RequestError(fmt::format("viewer: {}", error.what()));
    }
    return document;
}

} // namespace gabor::viewer
