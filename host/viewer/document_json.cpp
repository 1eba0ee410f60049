#include "viewer/document_json.hpp"

#include "error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace gabor::viewer {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::array<std::string_view, 7> outputs{"value",    "gradient", "phase", "intensity",
                                                  "variance", "phasor",   "lit"};
constexpr std::array<std::string_view, 6> looks{"lit",    "colour",    "height",
                                                "normal", "roughness", "metalness"};
constexpr std::array<std::string_view, 2> normal_maps{"OpenGL", "DirectX"};
constexpr std::array<std::string_view, 5> colours{"grey", "viridis", "cool to warm", "ember", "sea"};

// Which of these names stands at `key`.
template <typename Names>
std::size_t index_of(const json& object, const char* key, const Names& names) {
    const json& value = object.at(key);
    const auto found = value.is_string() ? std::ranges::find(names, value.get<std::string>()) : names.end();
    if (found == names.end())
        throw RequestError(fmt::format("{} {}: it takes {}", key, value.dump(), fmt::join(names, ", ")));
    return static_cast<std::size_t>(found - names.begin());
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

void read_view(const json& view, Document& document) {
    if (view.contains("output"))
        document.output = static_cast<Output>(index_of(view, "output", outputs));
    if (view.contains("look"))
        document.look = static_cast<Look>(index_of(view, "look", looks));
    if (view.contains("normals"))
        document.directx_normals = index_of(view, "normals", normal_maps) == 1;
    if (view.contains("colours"))
        document.colours = static_cast<int>(index_of(view, "colours", colours));
    if (view.contains("contrast"))
        document.contrast = std::clamp(view["contrast"].get<float>(), least_contrast, most_contrast);
    if (view.contains("camera"))
        document.camera = camera_of(view["camera"]);
}

} // namespace

std::span<const std::string_view> output_names() {
    return outputs;
}

std::span<const std::string_view> look_names() {
    return looks;
}

std::span<const std::string_view> colour_names() {
    return colours;
}

std::string to_json(const Document& document) {
    ordered_json object = ordered_json::parse(render::to_json(document.request));
    object["viewer"] = {{"output", outputs.at(static_cast<std::size_t>(document.output))},
                        {"look", looks.at(static_cast<std::size_t>(document.look))},
                        {"normals", normal_maps.at(document.directx_normals)},
                        {"colours", colours.at(static_cast<std::size_t>(document.colours))},
                        {"contrast", document.contrast},
                        {"camera", json_of(document.camera)}};
    return object.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

Document document_from_json(std::string_view text, const Document& defaults) {
    Document document = document_of(render::from_json(text));
    document.output = defaults.output;
    document.look = defaults.look;
    document.directx_normals = defaults.directx_normals;
    document.colours = defaults.colours;
    document.contrast = defaults.contrast;
    const json object = json::parse(text);
    if (!object.contains("viewer"))
        return document;
    try {
        read_view(object["viewer"], document);
    } catch (const json::exception& error) {
        throw RequestError(fmt::format("viewer: {}", error.what()));
    } catch (const RequestError& error) {
        throw RequestError(fmt::format("viewer: {}", error.what()));
    }
    return document;
}

} // namespace gabor::viewer
