// Tests the panel's text, without a window.

#include "viewer/document_json.hpp"
#include "viewer/panels.hpp"

#include "render/load.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <imgui_internal.h>

#include <regex>
#include <set>
#include <string>

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
