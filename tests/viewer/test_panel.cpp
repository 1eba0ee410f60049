// Tests the panel's text, and what the pointer does, without a window.

#include "viewer/document_json.hpp"
#include "viewer/panels.hpp"
#include "viewer/photograph.hpp"

#include "image/png.hpp"
#include "render/load.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <imgui_internal.h>

#include <filesystem>
#include <random>
#include <regex>
#include <set>
#include <string>
#include <thread>

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
        for (const char* word : {"Materials and presets", "Photograph", "Copy code", "Export", "Export now",
                                 "Save as...", "Laboratory"})
            CHECK(text.find(word) != std::string::npos);
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

TEST_CASE("the gallery shows each preset once") {
    const NoWindow none;
    Session session({}, "");
    session.gallery = true;
    Gallery gallery;
    for (int frame = 0; frame < 3; ++frame) {
        ImGui::NewFrame();
        gallery = gallery_window(session, 1000, 4000);
        ImGui::EndFrame();
    }
    std::set<std::size_t> shown;
    for (const Gallery::Picture& picture : gallery.pictures)
        shown.insert(picture.preset);
    CHECK(gallery.pictures.size() == render::presets().size());
    CHECK(shown.size() == render::presets().size());
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
                                               {"time", noise, wood}}) {
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
    }
}

TEST_CASE("a body turns with its surface, however near it is") {
    const auto turned = [](double zoom) {
        const NoWindow none;
        Document document = document_from_json(R"({"view": "sphere"})");
        set_parameter(document, "zoom", zoom);
        Session session(document, "");
        const double before = std::get<render::Body>(session.document().request.view).yaw;
        drag({400, 300}, {440, 300}, [&] { handle_input(session, 800, 600); });
        return std::get<render::Body>(session.document().request.view).yaw - before;
    };
    CHECK(std::abs(turned(1)) > 5);
    CHECK(turned(4) == Approx(turned(1) / 4));
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

TEST_CASE("another number of lobes leaves a photograph's noise where it is") {
    const std::filesystem::path path = std::filesystem::temp_directory_path() / "gabor-photograph.png";
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
    open_photograph(session, path.string());
    fit(1);
    std::filesystem::remove(path);
    REQUIRE(session.fitted);
    Document& document = session.document();
    document.camera = document.camera.moved(3.25, -1.5);
    const double scale = document.request.scale;
    const auto pixel = [&](const Coordinate& c) {
        return (static_cast<double>(c.whole) + c.part) * document.request.scale;
    };
    const std::array before{pixel(document.camera.x), pixel(document.camera.y)};
    fit(6);
    CHECK(document.request.scale != scale);
    CHECK(pixel(document.camera.x) == Approx(before[0]));
    CHECK(pixel(document.camera.y) == Approx(before[1]));
}
