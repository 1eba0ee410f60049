#include "viewer/document.hpp"
#include "viewer/document_json.hpp"
#include "viewer/panels.hpp"
#include "viewer/settings.hpp"

#include "error.hpp"
#include "noise/recipe.hpp"
#include "render/load.hpp"
#include "render/parameters.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

using namespace gabor;
using namespace gabor::viewer;

// Returns a document whose members differ from their defaults and from each other.
Document unlike_any() {
    Document document = document_of({.width = 320, .height = 200, .scale = 24, .seed = 9});
    document.camera = document.camera.moved(-1e9 + 0.25, 3.5);
    document.camera.zoom = 2.5;
    document.output = Output::phase;
    document.look = Look::roughness;
    document.directx_normals = true;
    document.colours = 3;
    document.contrast = 1.5f;
    document.request.time = 0.3;
    return document;
}

TEST_CASE("undo and redo go step by step, and moving the camera is not a step") {
    History history(unlike_any());
    history.now.request.lobes[0].frequency = 5;
    history.commit();
    history.now.camera = history.now.camera.moved(3, 4);
    history.commit();
    const Document moved = history.now;
    history.now.request.seed = 10;
    history.commit();
    const Document edited = history.now;
    history.undo();
    CHECK(history.now == moved);
    history.undo();
    CHECK(history.now.request == unlike_any().request);
    CHECK_FALSE(history.can_undo());
    history.redo();
    history.redo();
    CHECK(history.now == edited);
    CHECK_FALSE(history.can_redo());
    history.undo();
    history.now.request.seed = 11;
    history.commit();
    CHECK_FALSE(history.can_redo());
}

// A value of the parameter other than the request's, or nothing if it has only one.
std::optional<render::Value> other_value(const render::Parameter& parameter, const render::Request& request) {
    using Kind = render::Parameter::Kind;
    const render::Value now = *parameter.get(request);
    switch (parameter.kind) {
    case Kind::flag:
        return !std::get<bool>(now);
    case Kind::integer:
    case Kind::number:
    case Kind::angle: {
        const auto [low, high] = parameter.slider;
        const double middle = std::floor(low + 0.5 * (high - low));
        return std::get<double>(now) == middle ? high : middle;
    }
    case Kind::colour:
        return std::array{0.1, 0.2, 0.3};
    case Kind::choice:
        for (const std::string_view choice : parameter.choices)
            if (std::string(choice) != std::get<std::string>(now))
                return std::string(choice);
        [[fallthrough]];
    default:
        return {};
    }
}

TEST_CASE("every parameter is a step of undo, but for time and the camera's") {
    constexpr std::array still{"time", "yaw", "pitch", "zoom", "focal_length", "altitude"};
    std::set<std::string_view> seen;
    std::vector<render::Request> requests;
    for (const std::string_view view : render::parameter("view").choices) {
        requests.emplace_back();
        render::set(requests.back(), "view", std::string(view));
    }
    for (const std::string_view material : render::parameter("material").choices) {
        requests.emplace_back();
        render::set(requests.back(), "material", std::string(material));
    }
    requests.push_back(requests.back());
    render::set(requests.back(), "boards", true);
    for (const render::Request& request : requests)
        for (const render::Parameter& parameter : render::parameters()) {
            const auto value =
                parameter.scope.holds(request) ? other_value(parameter, request) : std::nullopt;
            if (!value)
                continue;
            History history(document_of(request));
            parameter.place.put(history.now.request, *value);
            history.commit();
            INFO(parameter.name << " in " << render::to_json(request));
            CHECK(history.can_undo() == (std::ranges::find(still, parameter.name) == still.end()));
            seen.insert(parameter.name);
        }
    CHECK(seen.size() > render::parameters().size() - 4); // texts and lobes have tests of their own
}

TEST_CASE("settings are read as they were saved") {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "gabor-viewer-settings";
    const char* before = std::getenv("XDG_CONFIG_HOME");
    const std::string kept = before ? before : "";
    ::setenv("XDG_CONFIG_HOME", folder.c_str(), 1);
    const Settings saved{.placement = {11, 22, 633, 444, true},
                         .panels = false,
                         .ui_scale = 1.5f,
                         .document = "a document",
                         .preset_path = "a preset",
                         .export_path = "an export",
                         .recent = {"one", "two"},
                         .unsaved_by = 77};
    save_settings(saved);
    const Settings read = load_settings();
    before ? ::setenv("XDG_CONFIG_HOME", kept.c_str(), 1) : ::unsetenv("XDG_CONFIG_HOME");
    std::filesystem::remove_all(folder);
    CHECK(read == saved);
}

TEST_CASE("documents survive a round trip through JSON") {
    Document document = unlike_any();
    document.request.lobes = {{.frequency = 3}, {.frequency = 5, .orientation = 70, .power = 0.5}};
    CHECK(document_from_json(to_json(document)) == document);
    CHECK(render::from_json(to_json(document)) == document.request); // gabor render reads it too
    CHECK(document_from_json(R"({"seed": 9})", document).colours == 3);
    CHECK_THROWS_WITH(document_from_json(R"({"viewer": {"output": "slope"}})"),
                      Catch::Contains("output \"slope\": expected value, gradient"));
    for (const char* wrong : {R"({"viewer": {"camera": 7}})", R"({"viewer": {"contrast": "high"}})"})
        CHECK_THROWS_AS(document_from_json(wrong), RequestError);
}

TEST_CASE("each view can be chosen from each other one and from a material") {
    const std::vector<std::string_view>& views = render::parameter("view").choices;
    for (const std::string_view before : views)
        for (const std::string_view after : views)
            for (const char* material : {"none", "wood"}) {
                Document document = document_of({});
                set_parameter(document, "view", std::string(before));
                set_parameter(document, "material", std::string(material));
                set_parameter(document, "view", std::string(after));
                INFO(before << " with material " << material << ", then " << after);
                CHECK(std::get<std::string>(*render::parameter("view").get(document.request)) == after);
                CHECK_NOTHROW(render::check(document.request));
            }
}

TEST_CASE("every control that is shown has an effect") {
    const auto with = [](std::string_view name, const render::Value& value) {
        Document document = document_of({});
        set_parameter(document, name, value);
        return document;
    };
    const Document plain = document_of({});
    for (const char* control :
         {"recipe", "frequency", "orientation", "lobes", "paint", "filter", "colours", "contrast", "seed"})
        CHECK(has_effect(plain, control));
    Document body = with("view", std::string("sphere"));
    for (const char* control : {"recipe", "paint"})
        CHECK_FALSE(has_effect(body, control));
    CHECK(has_effect(body, "orientation"));
    body.request.lobes.front().orientation_spread = 90;
    CHECK_FALSE(has_effect(body, "orientation"));
    Document painted = plain;
    painted.request.paint = "painted.exr";
    for (const char* control : {"frequency", "orientation", "lobes"})
        CHECK_FALSE(has_effect(painted, control));
    painted.request.paint = "directions.png";
    for (const char* control : {"frequency", "orientation"})
        CHECK(has_effect(painted, control));
    CHECK_FALSE(has_effect(painted, "lobes"));
    Document gradient = plain;
    gradient.output = Output::gradient;
    CHECK(has_effect(gradient, "filter"));
    CHECK_FALSE(has_effect(gradient, "colours"));
    CHECK(has_effect(gradient, "contrast"));
}

TEST_CASE("every preset has its picture") {
    const PresetPictures& pictures = preset_pictures();
    CHECK(std::ranges::is_sorted(render::preset_names())); // the order in which tools/gallery draws them
    const auto presets = static_cast<int>(render::presets().size());
    const int columns = PresetPictures::columns;
    CHECK(pictures.extent ==
          Extent{columns * PresetPictures::cell, (presets + columns - 1) / columns * PresetPictures::cell});
    CHECK(pictures.colours.size() == std::size_t{3} * static_cast<std::size_t>(pictures.extent.width) *
                                         static_cast<std::size_t>(pictures.extent.height));
    for (int index = 0; index < presets; ++index) { // no preset's cell is empty
        const int row = index / columns * PresetPictures::cell + PresetPictures::cell / 2;
        const int column = index % columns * PresetPictures::cell + PresetPictures::cell / 4;
        const auto first = pictures.colours.begin() + 3 * (row * pictures.extent.width + column);
        const auto [least, most] = std::minmax_element(first, first + 3 * PresetPictures::cell / 2);
        CHECK(*most - *least > 0.02f);
    }
}
