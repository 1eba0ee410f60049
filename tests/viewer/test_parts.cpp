#include "viewer/display.hpp"
#include "viewer/document.hpp"
#include "viewer/document_json.hpp"
#include "viewer/drawing.hpp"
#include "viewer/gallery.hpp"
#include "viewer/session.hpp"
#include "viewer/settings.hpp"

#include "error.hpp"
#include "noise/recipe.hpp"
#include "render/request/load.hpp"
#include "render/request/parameters.hpp"

#include <catch2/catch.hpp>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <unistd.h>

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
    document.profile = 2;
    document.ramp = {{0.25f, {0, 0.2f, 1}}, {0.5f, {1, 0.4f, 0}}};
    document.request.light_azimuth = 70;
    document.request.light_elevation = 25;
    document.request.environment = 1;
    document.request.evolution = 0.3;
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

TEST_CASE("a document that was saved under another name has it in every step of undo") {
    History history(unlike_any());
    history.now.request.seed = 10;
    history.commit();
    history.saved_as("other.json");
    CHECK(history.now.path == "other.json");
    history.undo();
    CHECK(history.now.path == "other.json");
    CHECK(has_file(history.now));
}

TEST_CASE("what the window shows is a step of undo and is saved, where it is shown from is neither") {
    const Document plain = document_of({});
    const Document other = unlike_any();
    auto& [request, camera, output, look, normals, colours, ramp, profile, contrast, path, origin,
           photograph] = other; // a new member must be added here
    const auto check = [&](const char* name, auto Document::*member, const auto& value, bool is_content) {
        INFO(name);
        Session session(plain, "");
        session.document().*member = value;
        REQUIRE_FALSE(session.document() == plain);
        CHECK(is_changed(session) == is_content);
        session.history.commit();
        CHECK(session.history.can_undo() == is_content);
        session.history.undo();
        CHECK((session.document() == plain) == is_content);
    };
    check("request", &Document::request, request, true);
    check("camera", &Document::camera, camera, false);
    check("output", &Document::output, output, true);
    check("look", &Document::look, look, true);
    check("normals", &Document::directx_normals, normals, true);
    check("colours", &Document::colours, colours, true);
    check("ramp", &Document::ramp, ramp, true);
    check("profile", &Document::profile, profile, true);
    check("contrast", &Document::contrast, contrast, true);
    check("path", &Document::path, path + "2", false);
    check("origin", &Document::origin, origin / "file", false);
    check("photograph", &Document::photograph, photograph + "file", true);
}

TEST_CASE("undo keeps a thousand steps, and the last of them") {
    History history(document_of({}));
    for (std::uint32_t seed = 1; seed <= 1010; ++seed) {
        history.now.request.seed = seed;
        history.commit();
    }
    int steps = 0;
    for (; history.can_undo(); ++steps)
        history.undo();
    CHECK(steps == 999);
    CHECK(history.now.request.seed == 11);
    history.redo();
    CHECK(history.now.request.seed == 12);
}

// A value of the parameter other than the request's, or nothing if it has only one.
std::optional<render::Value> other_value(const render::Parameter& parameter, const render::Request& request) {
    using Type = render::Parameter::Type;
    const render::Value now = *parameter.get(request);
    switch (parameter.type) {
    case Type::flag:
        return !std::get<bool>(now);
    case Type::integer:
    case Type::number:
    case Type::angle: {
        const auto [low, high] = parameter.slider;
        const double middle = std::floor(low + 0.5 * (high - low));
        return std::get<double>(now) == middle ? high : middle;
    }
    case Type::colour:
        return std::array{0.1, 0.2, 0.3};
    case Type::choice:
        for (const std::string_view choice : parameter.choices)
            if (std::string(choice) != std::get<std::string>(now))
                return std::string(choice);
        [[fallthrough]];
    default:
        return {};
    }
}

TEST_CASE("every parameter is a step of undo, but for time and the camera's") {
    constexpr std::array still{"evolution", "seconds", "yaw", "pitch", "zoom", "focal_length", "altitude"};
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
    render::set(requests.back(), "coat", true);
    render::set(requests.back(), "finish", true);
    requests.emplace_back();
    render::set(requests.back(), "fractal", std::string("fbm"));
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

// Sets an environment variable, or unsets it, until the end of the scope.
class Variable {
  public:
    Variable(const char* name, const char* value) : name_(name) {
        if (const char* before = std::getenv(name))
            before_ = before;
        set(value);
    }
    ~Variable() { set(before_ ? before_->c_str() : nullptr); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

  private:
    void set(const char* value) { value ? ::setenv(name_, value, 1) : ::unsetenv(name_); }
    const char* name_;
    std::optional<std::string> before_;
};

// A configuration folder of its own.
struct ConfigFolder {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / fmt::format("gabor-viewer-settings-{}", ::getpid());
    const Variable variable{"XDG_CONFIG_HOME", path.c_str()};
    ~ConfigFolder() { std::filesystem::remove_all(path); }
};

TEST_CASE("settings are below the home folder where nothing names another") {
    const ConfigFolder home;
    const Variable none("XDG_CONFIG_HOME", nullptr), alone("HOME", home.path.c_str());
    Settings settings;
    settings.document = "a document";
    save_settings(settings);
    CHECK(std::filesystem::exists(home.path / ".config/gabor-noise/viewer.json"));
    CHECK(load_settings().document == "a document");
}

TEST_CASE("paths in the home folder begin with ~, those of folders whose names begin alike do not") {
    const Variable home("HOME", "/home/anna");
    CHECK(path_from_home("/home/anna/a.json") == "~/a.json");
    CHECK(path_from_home("/home/anna/b/../a.json") == "~/a.json");
    CHECK(path_from_home("/home/annabel/a.json") == "/home/annabel/a.json");
    CHECK(path_from_home("/home/ann") == "/home/ann");
    CHECK(path_from_home("/other/home/anna/a.json") == "/other/home/anna/a.json");
}

TEST_CASE("settings are read as they were saved") {
    const ConfigFolder folder;
    const Settings saved{.placement = {11, 22, 633, 444, true},
                         .panels = false,
                         .ui_scale = 1.5f,
                         .document = "a document",
                         .preset_path = "a preset",
                         .export_path = "an export",
                         .recent = {"one", "two"},
                         .unsaved_by = 77};
    save_settings(saved);
    CHECK(load_settings() == saved);
}

TEST_CASE("settings beyond their ranges are limited, and broken ones are the defaults") {
    const auto read = [](const std::string& json) {
        const ConfigFolder folder;
        std::filesystem::create_directories(folder.path / "gabor-noise");
        std::ofstream(folder.path / "gabor-noise/viewer.json") << json;
        return load_settings();
    };
    CHECK(read(R"({"placement": {"x": -9, "y": -9, "width": 1, "height": 1}, "ui_scale": 0})") ==
          Settings{.placement = {-1, -1, 480, 320}, .ui_scale = least_ui_scale});
    CHECK(read(R"({"placement": {"x": 1e9, "y": 1e9, "width": 1e9, "height": 1e9}, "ui_scale": 9})") ==
          Settings{.placement = {32767, 32767, 32767, 32767}, .ui_scale = most_ui_scale});
    CHECK(read(R"({"panels": "no", "ui_scale": 2})") == Settings());
    CHECK(read("") == Settings());
}

TEST_CASE("the ten last files are remembered, the last one first") {
    Session session({}, "");
    for (int i = 0; i < 12; ++i)
        add_recent(session, fmt::format("/file{}", i));
    add_recent(session, "/file5");
    std::vector<std::string> expected{"/file5"};
    for (int i = 11; expected.size() < 10; --i)
        if (i != 5)
            expected.push_back(fmt::format("/file{}", i));
    CHECK(session.recent == expected);
    add_recent(session, "file5"); // another session may begin in another folder
    CHECK(session.recent.front() == (std::filesystem::current_path() / "file5").string());
}

TEST_CASE("a document's view is limited to what the window can show, and a ramp is sorted") {
    const auto viewer = [](const std::string& json) {
        return document_from_json(fmt::format(R"({{"viewer": {{{}}}}})", json));
    };
    for (const auto& [given, zoom] : {std::pair("0", 1e-3), {"7", 7.0}, {"1e9", 1e3}}) {
        const auto camera =
            viewer(fmt::format(R"("camera": {{"x": [3, 0.25], "y": [-2, 1.5], "zoom": {}}})", given)).camera;
        CHECK(camera == Camera{{3, 0.25}, {-1, 0.5}, zoom});
    }
    CHECK(viewer(R"("contrast": 0)").contrast == least_contrast);
    CHECK(viewer(R"("contrast": 99)").contrast == most_contrast);
    CHECK(viewer(R"("light": [10, -5])").request.light_elevation == 0);
    CHECK(viewer(R"("light": [10, 95])").request.light_elevation == 90);
    CHECK(viewer(R"("ramp": [[1, "#ff0080"], [0, "#000000"], [0.5, "#003300"]])").ramp ==
          std::vector<ColourStop>{{0, {0, 0, 0}}, {0.5f, {0, 0.2f, 0}}, {1, {1, 0, 128 / 255.0f}}});
    const std::string stop = R"([0.5, "#123456"])";
    for (const auto& [ramp, accepted] : {std::pair(stop, false),
                                         {stop + "," + stop, true},
                                         {fmt::format("{}", fmt::join(std::vector(8, stop), ",")), true},
                                         {fmt::format("{}", fmt::join(std::vector(9, stop), ",")), false},
                                         {stop + R"(,[1.1, "#123456"])", false},
                                         {stop + R"(,[-0.1, "#123456"])", false},
                                         {stop + R"(,[1, "#12345"])", false},
                                         {stop + R"(,[1, "123456"])", false}}) {
        INFO(ramp);
        const auto read = [&, list = ramp] { return viewer(fmt::format(R"("ramp": [{}])", list)); };
        if (accepted)
            CHECK_NOTHROW(read());
        else
            CHECK_THROWS_AS(read(), RequestError);
    }
}

TEST_CASE("another material or view fits the picture, and other changes leave the view as it is") {
    Document document = document_of({.width = 600, .height = 400});
    const auto set = [&](std::string_view name, const render::Value& value) {
        document.camera = document.camera.moved(1, 2);
        set_parameter(document, name, value);
        return document.camera == render::default_camera(document.request);
    };
    CHECK_FALSE(set("seed", 3.0));
    CHECK(set("material", std::string("wood")));
    CHECK(document.request.scale == 100); // four units
    CHECK_FALSE(set("scale", 70.0));
    CHECK(set("material", std::string("marble")));
    CHECK(document.request.scale == 70);
    CHECK(set("width", 500.0));
    CHECK(set("height", 300.0));
    document.look = Look::metalness;
    CHECK(set("view", std::string("terrain")));
    CHECK(document.request.material == "none");
    CHECK(document.request.scale == 37.5); // eight hills
    CHECK(document.look == Look::lit);     // terrain has no metalness
    document.look = Look::normal;
    CHECK(set("view", std::string("landscape")));
    CHECK(document.look == Look::normal);
    CHECK_FALSE(document.request.filter);
    CHECK(set("view", std::string("sphere")));
    CHECK(document.request.scale == 32);
    CHECK(document.request.filter); // in perspective
    CHECK(set("view", std::string("slice")));
    CHECK_FALSE(document.request.filter);
    CHECK_THROWS_AS(set("paint", std::string("missing.exr")), RequestError);
}

TEST_CASE("an export has the document's name, and the form and files that were chosen") {
    const auto of = [](const char* json, const ExportTarget& target) {
        Document document = document_from_json(json);
        document.path = "folder/mine.json";
        return target.of(document);
    };
    const auto chosen = [](ExportAs as) { return ExportTarget{.chosen = as}; };
    const char* const noise = "{}";
    const char* const wood = R"({"material": "wood"})";
    for (const auto& [json, target, as] :
         {std::tuple(noise, ExportTarget(), ExportAs::picture),
          {wood, ExportTarget(), ExportAs::maps},
          {R"({"view": "terrain"})", ExportTarget(), ExportAs::maps},
          {R"({"view": "landscape"})", ExportTarget(), ExportAs::picture},
          {R"({"view": "landscape"})", chosen(ExportAs::maps), ExportAs::maps},
          {R"({"view": "ocean"})", ExportTarget(), ExportAs::picture},
          {R"({"view": "sphere", "material": "wood"})", ExportTarget(), ExportAs::picture},
          {R"({"view": "slice"})", chosen(ExportAs::maps), ExportAs::picture},
          {noise, chosen(ExportAs::maps), ExportAs::maps},
          {wood, chosen(ExportAs::frames), ExportAs::frames}}) {
        INFO(json);
        CHECK(of(json, target).as == as);
        CHECK(of(json, target).name() == (as == ExportAs::maps ? "folder/mine" : "folder/mine.exr"));
    }
    Document fitted = document_of({});
    fitted.photograph = "photo.png";
    CHECK(ExportTarget().of(fitted).name() == "noise-noise.exr");
    CHECK(ExportTarget{.path = "a.exr", .folder = "b"}.of(fitted).name() == "a.exr");

    const auto names = [](const ExportTarget& target) {
        std::string text;
        for (const std::filesystem::path& path : paths_of(target))
            text += path.string() + " ";
        return text;
    };
    for (const auto& [target, expected] :
         {std::pair(of(noise, {}), "folder/mine.exr folder/mine.png "),
          {of(noise, {.png = false}), "folder/mine.exr "},
          {of(noise, chosen(ExportAs::texture)), "folder/mine.exr "},
          {of(noise, {.path = "a.exr", .chosen = ExportAs::frames, .frames = 2}),
           "a.0001.exr a.0001.png a.0002.exr a.0002.png "},
          {of(noise, chosen(ExportAs::maps)),
           "folder/mine/base_color.png folder/mine/normal.png folder/mine/height.png "}})
        CHECK(names(target) == expected);
    ExportTarget coloured = of(noise, chosen(ExportAs::maps));
    coloured.coloured = true;
    CHECK(names(coloured) == "folder/mine/base_color.png ");
    CHECK(names(of(wood, {.directx = true})).find("normal_directx.png") != std::string::npos);
    CHECK(names(of(wood, {})).find("normal_directx.png") == std::string::npos);
}

TEST_CASE("a zoomed view is displayed as a picture of its scale, and tiles move with the camera") {
    const Document document = document_of({.width = 120, .height = 90, .scale = 24});
    Document moved = document;
    moved.camera = moved.camera.moved(6.25, -0.75); // pixels: 150 and -18
    CHECK(tiling_of(moved, {300, 200}).moved == std::array{30.0f, 72.0f});
    Document large = document;
    large.request.scale *= 2.5;
    const passes::DisplayPush zoomed = display_push(document, 3, 2.5), whole = display_push(large, 3, 1);
    CHECK(zoomed.spacing == Approx(whole.spacing));
    CHECK(zoomed.turns == Approx(whole.turns));
}

TEST_CASE("an export renders what the window shows, in its form") {
    Document document = document_from_json(R"({"width": 600, "height": 400, "scale": 50})");
    CHECK(exported(document, {}) == document.request);
    document.output = Output::lit;
    CHECK(exported(document, {}).gradient);
    CHECK(exported(document, {.as = ExportAs::texture}).filter);
    const auto maps = [](const Document& of, bool tileable) {
        return exported(of, {.as = ExportAs::maps, .map_side = 1000, .tileable = tileable});
    };
    const auto tiles = [](const render::Request& request) {
        return std::get<bool>(*render::parameter("tileable").get(request));
    };
    const Document wood =
        document_from_json(R"({"material": "wood", "width": 600, "height": 400, "scale": 50})");
    const Document land =
        document_from_json(R"({"view": "landscape", "width": 600, "height": 400, "scale": 200})");
    for (const auto& [of, scale, tile_scale, filter] : {std::tuple(document, 125.0, 125.0, false),
                                                        {wood, 125.0, 125.0, true},
                                                        {land, 500.0, 250.0, false}}) // a tile has four hills
        for (const bool tileable : {true, false}) {
            const render::Request made = maps(of, tileable);
            CHECK(made.width == 1000);
            CHECK(made.height == 1000);
            CHECK(made.scale == (tileable ? tile_scale : scale));
            CHECK(made.filter == filter);
            CHECK(tiles(made) == tileable);
        }
}

TEST_CASE("documents survive a round trip through JSON") {
    Document document = unlike_any();
    document.request.lobes = {{.frequency = 3}, {.frequency = 5, .orientation = 70, .power = 0.5}};
    CHECK(document_from_json(to_json(document)) == document);
    CHECK(render::to_json(render::from_json(to_json(document))) ==
          render::to_json(document.request)); // gabor render reads it too
    Document wood = document_from_json(R"({"material": "wood", "light_azimuth": 3, "environment": "dark"})");
    wood.look = Look::height;
    CHECK(document_from_json(to_json(wood)) == wood);
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
