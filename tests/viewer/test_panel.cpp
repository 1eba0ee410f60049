// Tests the panel's text, and what the pointer does, without a window.

#include "viewer/dear_imgui.hpp"
#include "viewer/display.hpp"
#include "viewer/document_json.hpp"
#include "viewer/gallery.hpp"
#include "viewer/input.hpp"
#include "viewer/overlays.hpp"
#include "viewer/panels.hpp"
#include "viewer/photograph.hpp"
#include "viewer/ramp_editor.hpp"
#include "viewer/spectrum_panel.hpp"
#include "viewer/widgets.hpp"

#include "../image/scratch_folder.hpp"
#include "image/png.hpp"
#include "render/request/load.hpp"

#include <GLFW/glfw3.h>
#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <imgui_internal.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <random>
#include <regex>
#include <set>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

using namespace gabor;
using namespace gabor::viewer;

namespace {

// Dear ImGui without a renderer.
struct NoWindow {
    NoWindow() {
        ImGui::CreateContext();
        ImGui::GetIO().DisplaySize = {1440, 4000};
        ImGui::GetIO().IniFilename = nullptr;
        ImGui::GetIO().Fonts->Build();
    }
    ~NoWindow() { ImGui::DestroyContext(); }
};

// Returns all text of the panel, with every section open except the laboratory.
std::string panel_text(Session& session) {
    const NoWindow none;
    std::string text;
    for (int frame = 0; frame < 3; ++frame) {
        ImGui::NewFrame();
        ImGui::SetNextWindowSize({400, 4000});
        ImGui::Begin("panels");
        ImGui::BeginChild("sections");
        for (const char* title : {"Noise", "Material", "Terrain", "Photograph", "Spectrum", "View", "Light",
                                  "Animation", "Export", "File"})
            ImGui::GetStateStorage()->SetInt(ImGui::GetID(title), 1);
        ImGui::EndChild();
        ImGui::LogToBuffer(0);
        side_panel(session);
        text = ImGui::GetCurrentContext()->LogBuffer.c_str();
        ImGui::LogFinish();
        ImGui::End();
        ImGui::EndFrame();
    }
    return text;
}

// Draws the panel with every section open, and presses the button or check box with this label, or types a
// text into the field. The section is "" for the buttons above the sections.
void press_in_panel(Session& session, const std::string& section, const char* label,
                    const char* text = nullptr) {
    const NoWindow none;
    for (int frame = 0; frame < 5; ++frame) {
        if (text && frame == 3)
            ImGui::GetIO().AddInputCharactersUTF8(text);
        ImGui::NewFrame();
        ImGui::SetNextWindowSize({400, 4000});
        ImGui::Begin("panels");
        side_panel(session);
        ImGuiID id = ImGui::GetID(label);
        ImGui::BeginChild("sections");
        for (const char* title : {"Animation", "Export", "File", "View", "Laboratory"})
            ImGui::GetStateStorage()->SetInt(ImGui::GetID(title), 1);
        if (!section.empty()) {
            ImGui::PushID(section.c_str());
            id = ImGui::GetID(label);
            ImGui::PopID();
        }
        ImGui::EndChild();
        ImGui::End();
        if (frame == 1)
            dear_imgui::activate(id);
        if (frame == 1 && text)
            ImGui::GetCurrentContext()->NavNextActivateFlags = ImGuiActivateFlags_PreferInput;
        ImGui::EndFrame();
    }
}

// Draws a frame after the pointer has moved.
template <typename Draw>
void frame(ImVec2 pointer, Draw draw) {
    ImGui::GetIO().MousePos = pointer;
    ImGui::NewFrame();
    draw();
    ImGui::EndFrame();
}

// Presses the left button at one point, and releases it at another.
template <typename Draw>
void drag(ImVec2 from, ImVec2 to, Draw draw) {
    frame(from, draw);
    ImGui::GetIO().MouseDown[0] = true;
    frame(from, draw);
    frame(to, draw);
    ImGui::GetIO().MouseDown[0] = false;
    frame(to, draw);
}

// Draws a frame in which a key goes down.
template <typename Draw>
void press(int key, Draw draw) {
    dear_imgui::set_key(key, true);
    frame({400, 300}, draw);
    dear_imgui::set_key(key, false);
    frame({400, 300}, draw);
}

std::string panel_text(const Document& document) {
    Session session(document, "");
    return panel_text(session);
}

} // namespace

TEST_CASE("the panel avoids jargon outside the laboratory") {
    const std::regex jargon(R"(\b(scale|recipe|lattice|quadrature|cvm|sd|visits|kurtosis)\b)",
                            std::regex::icase);
    const auto check = [&](const std::string& mode, const Document& document) {
        INFO(mode);
        const std::string text = panel_text(document);
        INFO(text);
        for (const char* word :
             {"Materials and presets", "Photograph", "Copy code", "Export", "Export now", "Save as..."})
            CHECK(text.find(word) != std::string::npos);
        // For surfaces it would be empty.
        CHECK((text.find("Laboratory") == std::string::npos) == render::is_surface(document.request.kind));
        CHECK_FALSE(std::regex_search(text, jargon));
    };
    for (const render::Preset& preset : render::presets())
        check(std::string(preset.name), document_from_json(preset.json));
    for (const std::string_view view :
         {"flat", "horizon", "slice", "sphere", "torus", "terrain", "landscape", "ocean"})
        for (std::size_t output = 0; output < output_names.size(); ++output) {
            Document document = document_of({});
            set_parameter(document, "view", std::string(view));
            document.output = static_cast<Output>(output);
            document.colours = 5;
            check(fmt::format("{}, {}", view, output_names.at(output)), document);
        }
}

TEST_CASE("each button and check box of the panel does what it says") {
    const auto after = [](const char* json, const char* section, const char* label,
                          const ExportTarget& target = {}, const char* text = nullptr) {
        auto session = std::make_unique<Session>(document_from_json(json), "");
        session->view = {800, 600};
        session->export_target = target;
        press_in_panel(*session, section, label, text);
        return session;
    };
    const char* const plain = R"({"width": 600, "height": 400, "scale": 40})";
    const char* const wood = R"({"material": "wood"})";
    CHECK(after(plain, "", "Materials and presets")->gallery);
    CHECK(after(plain, "", "Photograph")->dialog.value().title == "Fit a noise to a photograph");
    CHECK(after(plain, "", "Copy code")->message.text == "copied GLSL that draws this view");
    CHECK(after(plain, "Animation", "play")->playing);
    CHECK(after(plain, "File", "Open...")->dialog.value().title == "Open");
    CHECK(after(plain, "File", "Save")->dialog.value().title == "Save as a preset");
    CHECK(after(plain, "File", "Save as...")->dialog.value().title == "Save as a preset");
    CHECK(after(plain, "Export", "Export to...")->dialog.value().title == "Export to a file");
    CHECK(after(wood, "Export", "Export to...")->dialog.value().title == "Export maps to a folder");
    for (const auto& [label, width, height, scale] :
         {std::tuple("half size", 300, 200, 20.0), {"double size", 1200, 800, 80.0}}) {
        const render::Request made = after(plain, "Export", label)->document().request;
        CHECK(std::tuple(made.width, made.height, made.scale) == std::tuple(width, height, scale));
    }
    CHECK_FALSE(after(plain, "Export", "also write PNG")->export_target.png);
    CHECK(after(wood, "Export", "metres", {}, "2.5")->export_target.metres == 2.5);
    CHECK_FALSE(after(wood, "Export", "tileable##maps")->export_target.tileable);
    CHECK(after(wood, "Export", "DirectX normals")->export_target.directx);
    CHECK(after(plain, "Export", "16-bit floats", {.chosen = ExportAs::texture})->export_target.half);
    CHECK(
        after(plain, "Export", "tileable", {.chosen = ExportAs::texture})->document().request.view.tileable);
    CHECK(after(R"({"tileable": true})", "View", "2 x 2 tiles")->tiles);
    CHECK(after(plain, "View", "filter")->document().request.filter);
    CHECK(after(R"({"viewer": {"output": "gradient"}})", "View", "DirectX normals")
              ->document()
              .directx_normals);
    CHECK(after(plain, "Laboratory", "gradient")->document().request.gradient);
    CHECK(after(plain, "Laboratory", "phasor")->document().request.phasor);
}

TEST_CASE("a question gives the answer whose button is pressed") {
    for (const auto& [label, given] : {std::pair("Yes (Enter)", 1), {"No (N)", 2}, {"Cancel (Esc)", 0}}) {
        const NoWindow none;
        Session session(document_of({}), "");
        session.closing = Closing::asked;
        int found = 0;
        session.question =
            Question{"Is it?", {{"Yes", [&] { found = 1; }, 'Y'}, {"No", [&] { found = 2; }, 'N'}}};
        for (int i = 0; i < 4; ++i)
            frame({0, 0}, [&, name = label] {
                question_window(session);
                if (i == 1)
                    dear_imgui::activate(ImGui::FindWindowByName("Please confirm")->GetID(name));
            });
        CHECK_FALSE(session.question);
        CHECK(found == given);
        CHECK((session.closing == Closing::no) == (given == 0));
    }
    for (const auto& [key, given] :
         {std::pair(GLFW_KEY_ENTER, 1), {GLFW_KEY_Y, 1}, {GLFW_KEY_N, 2}, {GLFW_KEY_ESCAPE, 0}}) {
        const NoWindow none;
        Session session(document_of({}), "");
        int found = 0;
        session.question =
            Question{"Is it?", {{"Yes", [&] { found = 1; }, 'Y'}, {"No", [&] { found = 2; }, 'N'}}};
        press(GLFW_KEY_F, [&] { handle_input(session, 800, 600); });
        CHECK(session.question);
        CHECK_FALSE(session.document().request.filter);
        press(key, [&] { handle_input(session, 800, 600); });
        CHECK_FALSE(session.question);
        CHECK(found == given);
    }
}

TEST_CASE("a double click adds the colour that is there, and a button removes it") {
    const NoWindow none;
    Document document = document_of({});
    document.ramp = {{0, {0, 0, 0}}, {0.5f, {1, 0.4f, 0}}, {1, {1, 1, 1}}};
    Session session(document, "");
    ImVec2 corner;
    float width = 0;
    const auto draw = [&] {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({400, 300});
        ImGui::Begin("panels");
        corner = ImGui::GetCursorScreenPos();
        width = ImGui::CalcItemWidth();
        ramp_editor(session);
        ImGui::End();
    };
    const auto double_click = [&](float share) {
        const float edge = 0.4f * ImGui::GetFontSize();
        for (const bool down : {false, true, false, true, false}) {
            ImGui::GetIO().MouseDown[0] = down;
            frame({corner.x + std::lerp(edge, width - edge, share), corner.y + 4}, draw);
        }
    };
    frame({0, 0}, draw);
    double_click(0.25f);
    const std::vector<ColourStop>& ramp = session.document().ramp;
    REQUIRE(ramp.size() == 4);
    CHECK(session.selected_stop == 1);
    CHECK(ramp[1].at == Approx(0.25).margin(0.01));
    for (const auto& [c, part] : {std::pair(0u, 0.5), {1u, 0.2}, {2u, 0.0}})
        CHECK(ramp[1].colour.at(c) == Approx(part).margin(0.02));
    dear_imgui::activate(ImGui::FindWindowByName("panels")->GetID("remove"));
    frame({0, 0}, draw);
    CHECK(ramp == document.ramp);
    for (int i = 0; i < 8; ++i)
        double_click(0.06f + 0.11f * static_cast<float>(i));
    CHECK(ramp.size() == most_stops);
    CHECK(std::ranges::is_sorted(ramp, {}, &ColourStop::at));
}

TEST_CASE("the gallery shows each preset once, and finds words of names and groups") {
    const NoWindow none;
    Session session({}, "");
    session.gallery = true;
    Gallery gallery;
    const auto frame = [&] {
        ImGui::NewFrame();
        gallery = gallery_window(session, 1000, 4000);
        ImGui::EndFrame();
    };
    for (int i = 0; i < 3; ++i)
        frame();
    std::set<std::size_t> shown;
    for (const Gallery::Picture& picture : gallery.pictures)
        shown.insert(picture.preset);
    CHECK(gallery.pictures.size() == render::presets().size());
    CHECK(shown.size() == render::presets().size());
    for (const auto& [search, first] :
         std::map<std::string, std::string>{{"copper weath", "weathered-copper"},
                                            {"snow mountains", "alps"},
                                            {"cloth herringbone", "herringbone"}}) {
        ImGui::ClearActiveID(); // while the field has the focus, it keeps its own text
        session.search = search;
        frame();
        CHECK(render::presets()[gallery.pictures.front().preset].name == first);
    }
}

TEST_CASE("the gallery opens noises, which searching finds by what they draw") {
    const NoWindow none;
    const auto opened = [](const std::string& search, const char* name) {
        Session session(document_from_json(R"({"view": "ocean"})"), "");
        Gallery gallery;
        for (int frame = 0; frame < 6; ++frame) {
            session.gallery = session.gallery || frame == 0;
            ImGui::ClearActiveID(); // while the field has the focus, it keeps its own text
            session.search = search;
            ImGui::NewFrame();
            if (const Gallery shown = gallery_window(session, 1000, 4000); frame < 4)
                gallery = shown;
            ImGui::Begin("presets");
            ImGui::BeginChild("pictures");
            if (frame == 3)
                dear_imgui::activate(ImGui::GetID(name));
            ImGui::EndChild();
            ImGui::End();
            ImGui::EndFrame();
        }
        CHECK(gallery.pictures.empty()); // no preset is found
        CHECK_FALSE(session.gallery);
        CHECK(session.message.text == fmt::format("opened {}", name));
        CHECK(session.document().path == fmt::format("{}.json", name));
        CHECK(session.document() == session.saved);
        return session.document();
    };
    CHECK(opened("noise", "noise").request == render::Request());
    const Document clouds = opened("sky", "clouds");
    CHECK(clouds.request.kind == render::Kind::fractal);
    CHECK(clouds.colours == passes::own_colours);
    CHECK(clouds.ramp.front().colour[2] > 2 * clouds.ramp.front().colour[0]); // the sky is blue
    CHECK(opened("billow", "billows").request.fractal.shape == 2);
    CHECK(opened("ridges", "ridges").output == Output::lit);
}

TEST_CASE("sliders show thousands without an exponent") {
    const std::string text = panel_text(document_from_json(R"({"view": "ocean", "fetch": 200000})"));
    CHECK(text.find("200000") != std::string::npos);
    CHECK(text.find("e+") == std::string::npos);
}

TEST_CASE("a lobe's rows stay the same when another lobe is added, and angles outside a slider's range are "
          "shown inside it") {
    Document document = document_of({});
    const auto rows = [&] {
        const std::string text = panel_text(document);
        return text.substr(text.find("orientation spread"),
                           text.find("stretch") - text.find("orientation spread"));
    };
    const std::string of_one = rows();
    CHECK(of_one.find("radius") != std::string::npos);
    document.request.lobes.push_back({.orientation = 90});
    CHECK(rows() == of_one);
    CHECK(panel_text(document).find("power") > panel_text(document).find("stretch"));
    set_parameter(document, "view", std::string("landscape"));
    CHECK(panel_text(document).find("{ -145 }") != std::string::npos); // 215 degrees
}

TEST_CASE("the frequency plane grows with a lobe that is dragged out, and its power with it") {
    const NoWindow none;
    Session session(document_of({}), "");
    const auto lobe = [&]() -> noise::Lobe& { return session.document().request.lobes.front(); };
    std::vector<std::tuple<float, float, ImU32>> drawn;
    ImVec2 corner;
    float side = 0;
    const auto panel = [&] {
        ImGui::SetNextWindowPos({});
        ImGui::SetNextWindowSize({900, 900});
        ImGui::Begin("spectrum");
        corner = ImGui::GetCursorScreenPos();
        side = 0.68f * ImGui::GetContentRegionAvail().x; // of the plane, in a wide window
        spectrum_panel(session);
        drawn.clear();
        for (const ImDrawVert& vertex : ImGui::GetWindowDrawList()->VtxBuffer)
            drawn.emplace_back(vertex.pos.x, vertex.pos.y, vertex.col);
        ImGui::End();
    };
    frame({1400, 10}, panel);
    const auto on_axis = [&](double of_half) {
        return ImVec2(corner.x + side / 2 * (1 + static_cast<float>(of_half)), corner.y + side / 2);
    };
    const double reached = std::exp2(2.5); // the power of the root of 2 above 1.35 * 4
    drag(on_axis(4 / reached), on_axis(0.99), panel);
    CHECK(lobe().frequency == Approx(0.99 * reached).epsilon(0.01));
    for (int i = 0; i < 2; ++i)
        frame({1400, 10}, panel);
    const auto grown = drawn;
    const noise::Lobe dragged = std::exchange(lobe(), {.frequency = 1});
    frame({1400, 10}, panel);
    CHECK((drawn != grown));
    lobe() = dragged;
    frame({1400, 10}, panel);
    CHECK((drawn == grown));
}

TEST_CASE("the panel shows only what has an effect") {
    const auto has = [](const Document& document, const std::string& label) {
        const std::string text = panel_text(document);
        return std::regex_search(text, std::regex("\\b" + label + "\\b"));
    };
    const Document noise = document_of({});
    Document lit = noise;
    lit.output = Output::lit;
    Document stripes = noise;
    stripes.output = Output::phasor;
    const Document wood = document_from_json(R"({"material": "wood"})");
    for (const auto& [label, with, without] : {std::tuple{"azimuth", lit, noise},
                                               {"profile", stripes, noise},
                                               {"rings", wood, noise},
                                               {"frequency", noise, wood},
                                               {"colours", noise, wood},
                                               {"evolution", noise, wood}}) {
        INFO(label);
        CHECK(has(with, label));
        CHECK_FALSE(has(without, label));
    }
}

TEST_CASE("a picture of twice the size shows the same, and so does the window") {
    Document document =
        document_from_json(R"({"material": "wood", "width": 300, "height": 200, "scale": 50})");
    document.camera = document.camera.moved(3, 4);
    const Document before = document;
    resize(document, 2);
    CHECK(document.request.width == 600);
    CHECK(document.request.height == 400);
    CHECK(document.request.scale == 100);
    CHECK(document.camera.x == before.camera.x);
    CHECK(document.camera.zoom == before.camera.zoom / 2);
    resize(document, 0.5);
    CHECK(document == before);
    CHECK_THROWS(resize(document, 1000));
    CHECK(document == before);
}

TEST_CASE("the place under the pointer stays there when the wheel turns or the plane is dragged, on dense "
          "screens, too") {
    for (const float density : {1.0f, 2.0f}) {
        const NoWindow none;
        ImGui::GetIO().DisplayFramebufferScale = {density, density};
        Session session(document_of({.scale = 24}), "");
        const auto input = [&] { handle_input(session, 800, 600); };
        const auto place = [&](ImVec2 at) {
            const Camera& camera = session.document().camera;
            const double scale = 24 * camera.zoom / double{density};
            return std::array{
                static_cast<double>(camera.x.whole) + camera.x.part + double{at.x - 400} / scale,
                static_cast<double>(camera.y.whole) + camera.y.part + double{at.y - 300} / scale};
        };
        const ImVec2 from{150, 420}, to{190, 330};
        frame(from, input);
        const auto before = place(from);
        ImGui::GetIO().MouseWheel = 2;
        frame(from, input);
        CHECK(session.document().camera.zoom > 1.2);
        const auto zoomed = place(from);
        drag(from, to, input);
        const auto moved = place(to);
        for (const std::size_t axis : {0u, 1u}) {
            CHECK(zoomed[axis] == Approx(before[axis]));
            CHECK(moved[axis] == Approx(before[axis]));
        }
        const auto pixels = [&](float from_middle) { return double{from_middle * density}; };
        CHECK(reading(session.document(), {pixels(to.x - 400), pixels(to.y - 300)},
                      std::array{std::string("Y")},
                      std::array{0.5f}) == fmt::format("at {:.2f}, {:.2f}\nvalue 0.5", moved[0], moved[1]));
    }
}

TEST_CASE("a body turns with its surface, however near it is, and the camera of a landscape or a sea turns") {
    for (const auto& [view, zoom, yaw, pitch, least, most] :
         {std::tuple("sphere", 1.0, -16.0, 12.0, -89.0, 89.0),
          {"torus", 4.0, -4.0, 3.0, -89.0, 89.0},
          {"landscape", 4.0, 16.0, 12.0, 0.0, 89.0},
          {"ocean", 1.0, 16.0, 12.0, 0.0, 89.0}})
        for (const float density : {1.0f, 2.0f}) {
            INFO(view);
            const NoWindow none;
            ImGui::GetIO().DisplayFramebufferScale = {density, density};
            Session session(document_from_json(fmt::format(R"({{"view": "{}", "zoom": {}}})", view, zoom)),
                            "");
            const auto angle = [&](std::string_view name) {
                return std::get<double>(*render::parameter(name).get(session.document().request));
            };
            const auto input = [&] { handle_input(session, 800, 600); };
            const double yaw_before = angle("yaw"), pitch_before = angle("pitch");
            drag({400, 300}, {440, 330}, input);
            CHECK(std::remainder(angle("yaw") - yaw_before - yaw, 360) == Approx(0).margin(1e-6));
            CHECK(angle("pitch") - pitch_before == Approx(pitch));
            CHECK(std::abs(angle("yaw")) <= 180);
            for (const auto& [to, end] : {std::pair(-3000.0f, least), {3000.0f, most}}) {
                drag({400, 300}, {400, 300 + to}, input);
                CHECK(angle("pitch") == end);
            }
            for (const auto& [turns, end] : {std::pair(-99.0f, 0.1), {99.0f, 100.0}}) {
                ImGui::GetIO().MouseWheel = turns;
                frame({400, 300}, input);
                CHECK(angle("zoom") == end);
            }
        }
}

TEST_CASE("arrows, plus and minus move and zoom like the pointer") {
    const NoWindow none;
    Session session(document_of({.scale = 20}), "");
    const auto input = [&] { handle_input(session, 800, 600); };
    const Camera before = session.document().camera;
    const auto moved = [&] {
        const Camera& camera = session.document().camera;
        const auto by = [](const Coordinate& a, const Coordinate& b) {
            return static_cast<double>(a.whole - b.whole) + a.part - b.part;
        };
        return std::array{by(camera.x, before.x), by(camera.y, before.y)};
    };
    for (const auto& [key, x, y] : {std::tuple(GLFW_KEY_RIGHT, 2, 0),
                                    {GLFW_KEY_DOWN, 2, 2},
                                    {GLFW_KEY_LEFT, 0, 2},
                                    {GLFW_KEY_UP, 0, 0}}) { // 40 pixels are two kernel radii
        press(key, input);
        CHECK(moved() == std::array<double, 2>{x * 1.0, y * 1.0});
    }
    press(GLFW_KEY_EQUAL, input);
    CHECK(session.document().camera.zoom == Approx(1.15));
    press(GLFW_KEY_MINUS, input);
    CHECK(session.document().camera.zoom == Approx(1));
    CHECK(moved()[0] == Approx(0).margin(1e-9));
    for (const auto& [turns, scale] : {std::pair(-99.0f, 2.0), {99.0f, 4096.0}}) {
        ImGui::GetIO().MouseWheel = turns;
        frame({400, 300}, input);
        CHECK(session.document().camera.zoom * 20 == Approx(scale));
    }
}

TEST_CASE("each key does what the page of keys says, or says why it cannot") {
    const auto after = [](const char* json, const std::vector<int>& keys, bool ctrl = false) {
        const NoWindow none;
        auto session = std::make_unique<Session>(document_from_json(json), "");
        session->view = {800, 600};
        dear_imgui::set_modifiers(ctrl, false);
        for (const int key : keys) {
            press(key, [&] { handle_input(*session, 800, 600); });
            session->history.commit();
        }
        return session;
    };
    const char* const plain = R"({"scale": 40})";
    const char* const wood = R"({"material": "wood"})";
    const char* const tile = R"({"tileable": true})";
    for (std::size_t i = 0; i < output_names.size(); ++i)
        CHECK(after(plain, {GLFW_KEY_1 + static_cast<int>(i)})->document().output == static_cast<Output>(i));
    for (std::size_t i = 0; i < look_names.size(); ++i)
        CHECK(after(wood, {GLFW_KEY_1 + static_cast<int>(i)})->document().look == static_cast<Look>(i));
    CHECK(after(R"({"view": "terrain"})", {GLFW_KEY_5})->document().look == Look::lit);
    CHECK(after(plain, {GLFW_KEY_V})->document().request.view.has_horizon());
    for (const auto& [times, view] :
         {std::pair(1u, "horizon"), {2u, "sphere"}, {3u, "torus"}, {4u, "flat"}}) {
        const auto session = after(wood, std::vector<int>(times, GLFW_KEY_V));
        CHECK(session->document().request.material == "wood"); // other views have none
        CHECK(std::get<std::string>(*render::parameter("view").get(session->document().request)) == view);
    }
    CHECK(after(plain, {GLFW_KEY_F})->document().request.filter);
    CHECK_FALSE(after(plain, {GLFW_KEY_F, GLFW_KEY_F})->document().request.filter);
    CHECK(after(plain, {GLFW_KEY_C, GLFW_KEY_C})->document().colours == 2);
    CHECK(after(plain, {GLFW_KEY_C, GLFW_KEY_C, GLFW_KEY_C, GLFW_KEY_C, GLFW_KEY_C, GLFW_KEY_C})
              ->document()
              .colours == 0);
    CHECK(after(plain, {GLFW_KEY_N, GLFW_KEY_N})->document().request.seed == 2);
    CHECK(after(tile, {GLFW_KEY_T})->tiles);
    CHECK(after(plain, {GLFW_KEY_T})->tiles);
    CHECK(after(plain, {GLFW_KEY_T})->document().request.view.tileable);
    CHECK(after(plain, {GLFW_KEY_P})->gallery);
    CHECK(after(plain, {GLFW_KEY_SPACE})->playing);
    CHECK_FALSE(after(plain, {GLFW_KEY_H})->panels);
    CHECK(after(plain, {GLFW_KEY_F1})->help);
    CHECK(after(plain, {GLFW_KEY_F11})->full_screen);
    CHECK_FALSE(after(plain, {GLFW_KEY_F1, GLFW_KEY_P, GLFW_KEY_ESCAPE})->help);
    CHECK_FALSE(after(plain, {GLFW_KEY_P, GLFW_KEY_ESCAPE})->gallery);
    CHECK(after(plain, {GLFW_KEY_TAB})->photograph_beside); // there is no photograph
    CHECK(after(plain, {GLFW_KEY_HOME})->document() == document_from_json(plain));
    CHECK(after(plain, {GLFW_KEY_RIGHT, GLFW_KEY_EQUAL, GLFW_KEY_HOME})->document() ==
          document_from_json(plain));
    for (const auto& [json, key, message] :
         {std::tuple(R"({"view": "sphere"})", GLFW_KEY_T, "This view has no tiles"),
          {R"({"view": "terrain"})", GLFW_KEY_F, "Nothing can be filtered here"},
          {wood, GLFW_KEY_C, "This view has its own colours"},
          {wood, GLFW_KEY_SPACE, "Nothing here changes with time"}}) {
        const auto session = after(json, {key});
        CHECK(session->message.text == message);
        CHECK(session->document() == document_from_json(json));
        CHECK_FALSE((session->tiles || session->playing));
    }
    CHECK(after(plain, {GLFW_KEY_O}, true)->dialog.value().action == "Open");
    CHECK(after(plain, {GLFW_KEY_S}, true)->dialog.value().action == "Save");
    CHECK(after(plain, {GLFW_KEY_Q}, true)->closing == Closing::asked);
    CHECK(after(plain, {GLFW_KEY_N, GLFW_KEY_3}, true)->document() ==
          document_from_json(plain)); // not with Ctrl
    CHECK(after(plain, {GLFW_KEY_C}, true)->message.text == "copied GLSL that draws this view");
    for (const auto& [keys, seed] : {std::pair(std::vector{GLFW_KEY_Z}, 1u),
                                     {std::vector{GLFW_KEY_Z, GLFW_KEY_Z}, 0u},
                                     {std::vector{GLFW_KEY_Z, GLFW_KEY_Y}, 2u}}) {
        const NoWindow none;
        Session session(document_of({}), "");
        for (std::uint32_t i = 1; i <= 2; ++i) {
            session.document().request.seed = i;
            session.history.commit();
        }
        dear_imgui::set_modifiers(true, false);
        for (const int key : keys)
            press(key, [&] { handle_input(session, 800, 600); });
        CHECK(session.document().request.seed == seed);
        dear_imgui::set_modifiers(true, true); // now Z goes forwards
        press(GLFW_KEY_Z, [&] { handle_input(session, 800, 600); });
        CHECK(session.document().request.seed == std::min(seed + 1, 2u));
    }
}

TEST_CASE("a slider covers the usual values, and a double click resets it") {
    for (const auto& [low, middle] : {std::pair(1.0, 10.0), {0.0, 50.0}}) { // logarithmic above 0
        const NoWindow none;
        double value = 7;
        bool changed = false;
        ImVec2 first, last;
        const auto draw = [&] {
            ImGui::SetNextWindowPos({0, 0});
            ImGui::SetNextWindowSize({600, 300});
            ImGui::Begin("panels");
            changed |= number_slider("number", value, {-1000, 1000}, {low, 100}, 3);
            first = ImGui::GetItemRectMin();
            last = {first.x + ImGui::CalcItemWidth(), first.y + 4};
            ImGui::End();
        };
        frame({0, 0}, draw);
        drag({first.x + 20, last.y}, {first.x, last.y}, draw);
        CHECK(value == low);
        drag({first.x + 40, last.y}, {last.x, last.y}, draw);
        CHECK(value == 100);
        drag({first.x + 60, last.y}, {(first.x + last.x) / 2, last.y}, draw);
        CHECK(value == Approx(middle).epsilon(0.03));
        CHECK(std::exchange(changed, false));
        for (const bool down : {true, false, true, false}) {
            ImGui::GetIO().MouseDown[0] = down;
            frame({first.x + 80, last.y}, draw);
        }
        CHECK(value == 3);
        CHECK(changed);
    }
}

TEST_CASE("files are listed by their endings, in order and without hidden ones, and folders are entered") {
    const ScratchFolder folder;
    std::filesystem::create_directories(folder / "sub");
    for (const char* name : {"b.json", "a.JSON", "c.exr", "d.png", ".hidden.json", "e.txt", "sub/f.json"})
        std::ofstream(folder / name) << R"({"seed": 5})";
    const NoWindow none;
    Session session(document_of({}), "");
    session.document().path = (folder / "mine.json").string();
    const auto shown = [&] {
        for (int i = 0; i < 2; ++i)
            frame({0, 0}, [&] { dialog_window(session); });
        return std::pair(session.dialog.value().folders, session.dialog.value().files);
    };
    using Names = std::vector<std::string>;
    ask_for_file(session);
    CHECK(shown() == std::pair(Names{"sub"}, Names{"a.JSON", "b.json", "c.exr", "d.png"}));
    session.dialog.value().name = "sub";
    answer_dialog(session);
    CHECK(session.dialog.value().name.empty());
    CHECK(shown() == std::pair(Names{}, Names{"f.json"}));
    answer_dialog(session); // an empty name chooses nothing
    session.dialog.value().name = "..";
    answer_dialog(session);
    CHECK(session.dialog.value().folder == folder.path());
    session.dialog.value().name = "b.json";
    answer_dialog(session);
    CHECK_FALSE(session.dialog);
    CHECK(session.document().request.seed == 5);
    for (const auto& [ask, files] : {std::pair(&ask_where_to_save, Names{"a.JSON", "b.json"}),
                                     {&ask_for_paint, Names{"c.exr", "d.png"}},
                                     {&ask_for_photograph, Names{"c.exr", "d.png"}},
                                     {&ask_where_to_export, Names{"c.exr"}}}) {
        ask(session);
        CHECK(shown().second == files);
        cancel_dialog(session);
    }
    set_parameter(session.document(), "material", std::string("wood"));
    ask_where_to_export(session); // maps go to a folder
    CHECK(shown() == std::pair(Names{"sub"}, Names{}));
    CHECK(session.dialog.value().folder_wanted);
}

TEST_CASE("files that the session did not write are named before they are replaced") {
    const ScratchFolder folder;
    const auto path = [&](const char* name) { return (folder / name).string(); };
    for (const char* name : {"a.0001.exr", "a.0002.png", "a.0003.exr", "a.0003.png"})
        std::ofstream(path(name)) << "mine";
    const NoWindow none;
    Session session(document_of({}), "");
    session.export_target = {.path = path("a.exr"), .chosen = ExportAs::frames, .frames = 2};
    const auto asked = [&] {
        start_export(session);
        const std::string text = session.question ? session.question->text : "";
        answer(session, {});
        return text;
    };
    CHECK(asked() == fmt::format("Overwrite {} and {}? This session did not write them from this document.",
                                 path("a.0001.exr"), path("a.0002.png")));
    session.export_target.frames = 3;
    CHECK(asked() ==
          fmt::format("Overwrite {} and {} and 2 more? This session did not write them from this document.",
                      path("a.0001.exr"), path("a.0002.png")));
    session.export_target.path = path("a.png");
    CHECK(asked().empty());
    CHECK(session.message.text == "the name of an export must end in .exr");
    session.document().path = path("a.0001.exr"); // is saved as a.0001.json
    write_preset(session);
    CHECK(has_file(session.document()));
    CHECK(session.document().path == path("a.0001.json"));
    CHECK_FALSE(is_changed(session));
    CHECK(session.recent == std::vector{path("a.0001.json")});
}

TEST_CASE("a ramp keeps two colours") {
    const auto text = [](const std::vector<ColourStop>& ramp) {
        const NoWindow none;
        Document document = document_of({});
        document.ramp = ramp;
        Session session(document, "");
        std::string drawn;
        frame({0, 0}, [&] {
            ImGui::Begin("colours");
            ImGui::LogToBuffer(0);
            ramp_editor(session);
            drawn = ImGui::GetCurrentContext()->LogBuffer.c_str();
            ImGui::LogFinish();
            ImGui::End();
        });
        return drawn;
    };
    CHECK(text({{0, {0, 0, 0}}, {0.5f, {1, 0, 0}}, {1, {1, 1, 1}}}).find("remove") != std::string::npos);
    CHECK(text({{0, {0, 0, 0}}, {1, {1, 1, 1}}}).find("remove") == std::string::npos);
}

TEST_CASE("a colour stays between its neighbours") {
    for (const std::size_t stop : {0u, 1u, 2u, 3u})
        for (const float target : {0.02f, 0.98f}) {
            const NoWindow none;
            Document document = document_of({});
            document.ramp = {{0.1f, {0, 0, 0}}, {0.4f, {1, 0, 0}}, {0.6f, {0, 1, 0}}, {0.9f, {1, 1, 1}}};
            Session session(document, "");
            ImVec2 corner, ends;
            const auto draw = [&] {
                ImGui::SetNextWindowPos({0, 0});
                ImGui::SetNextWindowSize({400, 300});
                ImGui::Begin("colours");
                corner = ImGui::GetCursorScreenPos();
                const float edge = 0.4f * ImGui::GetFontSize();
                ends = {corner.x + edge, corner.x + ImGui::CalcItemWidth() - edge};
                ramp_editor(session);
                ImGui::End();
            };
            frame({0, 0}, draw);
            const auto at = [&](float share) {
                return ImVec2(std::lerp(ends.x, ends.y, share), corner.y + 4);
            };
            drag(at(document.ramp[stop].at), at(target), draw);
            const float low = stop > 0 ? document.ramp[stop - 1].at : target;
            const float high = stop < 3 ? document.ramp[stop + 1].at : target;
            CHECK(session.document().ramp[stop].at == Approx(target < 0.5f ? low : high).margin(0.005));
        }
}

TEST_CASE("a photograph larger than a screen is shown as the means of squares") {
    constexpr int width = 4100, height = 131, square = 3;
    const ScratchFolder folder;
    const std::filesystem::path path = folder / "large.png";
    std::mt19937 random(3);
    std::vector<float> colours;
    for (int i = 0; i < 3 * width * height; ++i)
        colours.push_back(static_cast<float>(random() >> 8 & 255) / 255);
    image::PngWriter png(path, width, height, 3);
    png.write_rows(colours);
    png.commit();
    Fitter fitter;
    fitter.open(path.string());
    fitter.set_lobes(1);
    do {
        fitter.poll();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    } while (fitter.running());
    fitter.poll();
    REQUIRE(fitter.photograph());
    const Photograph& seen = *fitter.photograph();
    CHECK(seen.square == square);
    REQUIRE(seen.grid == Extent{width / square, height / square});
    for (const auto& [x, y] : {std::pair(0, 0), {7, 20}, {width / square - 1, height / square - 1}})
        for (int c = 0; c < 3; ++c) {
            float mean = 0;
            for (int i = 0; i < square * square; ++i)
                mean += colours[static_cast<std::size_t>(
                            3 * ((square * y + i / square) * width + square * x + i % square) + c)] /
                        (square * square);
            CHECK(seen.pixels[static_cast<std::size_t>(3 * (y * seen.grid.width + x) + c)] == Approx(mean));
        }
}

TEST_CASE("a photograph's noise replaces the document's, and another number of lobes leaves it where it is") {
    const ScratchFolder folder;
    const std::filesystem::path path = folder / "photograph.png";
    constexpr int side = 128;
    std::mt19937 random(3);
    std::vector<float> grey(side * side);
    const auto unit = [&] { return static_cast<float>(random()) * 0x1p-32f; };
    float phase = 0;
    for (float& value : grey) { // stripes that drift, and noise
        phase += 0.6f + 0.6f * unit();
        value = 0.4f + 0.2f * std::sin(phase) + 0.3f * unit();
    }
    image::PngWriter png(path, side, side, 1);
    png.write_rows(grey);
    png.commit();
    const NoWindow none;
    Session session(document_of({}), "");
    const auto fit = [&](int lobes) {
        session.fitter.set_lobes(lobes);
        do {
            poll_fitter(session);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        } while (session.fitter.running());
    };
    Document& document = session.document();
    document.output = Output::phase;
    document.contrast = 5;
    document.colours = 3;
    open_photograph(session, path.string());
    fit(1);
    REQUIRE(session.fitted);
    CHECK(document.output == Output::value);
    CHECK(document.contrast == Document().contrast);
    CHECK(document.colours == 3);
    CHECK(document.path == std::filesystem::path(path).replace_extension(".json"));
    CHECK(document.photograph == path);
    CHECK(session.recent.front() == path);
    CHECK(document.request.width == side);
    CHECK(session.export_target.of(document).as == ExportAs::picture);

    CHECK(shows_photograph(session));
    for (const auto& change : std::vector<std::function<void(Document&)>>{
             [](Document& d) { d.request.lobes[0].frequency *= 1.1; },
             [](Document& d) { d.output = Output::lit; },
             [](Document& d) { set_parameter(d, "view", std::string("horizon")); },
             [](Document& d) { d.request.evolution = 0.5; }}) {
        const Document kept = document;
        change(document);
        CHECK_FALSE(fitted_glsl(session)); // which draws only what was fitted
        CHECK(shows_photograph(session) == !document.request.view.has_horizon());
        document = kept;
    }
    document.request.seed = 41;
    document.request.filter = true;
    document.request.width = 99;
    CHECK(fitted_glsl(session).value().find("_seed = 41u;") != std::string::npos);

    // The divider moves alone, and each side zooms about its own middle.
    const auto input = [&] { handle_input(session, 800, 600); };
    const Camera still = document.camera;
    for (const auto& [x, share] :
         {std::pair(600.0f, 0.75f), {20.0f, 0.1f}, {790.0f, 0.9f}, {600.0f, 0.75f}}) {
        drag({800 * session.divider + 3, 300}, {x, 310}, input);
        CHECK(session.divider == share);
    }
    CHECK(document.camera == still);
    for (const auto& [pointer, middle] : {std::pair(200.0f, 300.0f), {650.0f, 700.0f}}) {
        const auto place = [&] {
            return static_cast<double>(document.camera.x.whole) + document.camera.x.part +
                   double{pointer - middle} / (document.request.scale * document.camera.zoom);
        };
        const double pointed = place();
        ImGui::GetIO().MouseWheel = 3;
        frame({pointer, 300}, input);
        CHECK(document.camera != still);
        CHECK(place() == Approx(pointed));
    }
    document.camera = still;
    document.camera = document.camera.moved(3.25, -1.5);
    const double scale = document.request.scale;
    const auto pixel = [&](const Coordinate& c) {
        return (static_cast<double>(c.whole) + c.part) * document.request.scale;
    };
    const std::array before{pixel(document.camera.x), pixel(document.camera.y)};
    fit(6);
    CHECK(document.request.seed == 41);
    CHECK(document.request.filter);
    CHECK(document.request.scale != scale);
    CHECK(pixel(document.camera.x) == Approx(before[0]));
    CHECK(pixel(document.camera.y) == Approx(before[1]));
}
