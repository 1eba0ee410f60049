#include "viewer/gallery.hpp"

#include "image/picture.hpp"
#include "render/request/load.hpp"
#include "render/request/material.hpp"
#include "viewer/display.hpp"
#include "viewer/embedded.hpp"
#include "viewer/widgets.hpp"

#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace gabor::viewer {

namespace {

// Presets that are shown together. Search finds the words of the title too.
struct Group {
    std::string title;
    std::vector<std::string> kinds; ///< materials and views
    std::vector<std::size_t> presets = {};
};

std::vector<Group> grouped_presets() {
    std::vector<Group> groups{{"Wood and bark", {"wood", "bark"}},
                              {"Cloth, fabric and fibre", {"fabric", "carbon-fibre"}},
                              {"Leather, skin and fur", {"leather", "zebra"}},
                              {"Metal and paint", {"brushed-metal", "scratches"}},
                              {"Stone and sand", {"marble", "strata", "sand"}},
                              {"Snowy mountains, hills and canyons", {"landscape"}},
                              {"Seas and lakes", {"ocean"}}};
    Group others{"Other materials", {}};
    for (const std::string_view material : render::materials)
        if (std::ranges::none_of(groups, [&](const Group& group) {
                return std::ranges::find(group.kinds, material) != group.kinds.end();
            }))
            others.kinds.emplace_back(material);
    groups.push_back(others); // not shown without presets
    std::vector<std::string> kinds;
    for (const std::string_view name : render::preset_names()) {
        const render::Request request = render::preset(name);
        const char* const kind = request.kind != render::Kind::material ? "view" : "material";
        kinds.push_back(std::get<std::string>(*render::parameter(kind).get(request)));
    }
    for (Group& group : groups)
        for (const std::string& kind : group.kinds)
            for (std::size_t i = 0; i < kinds.size(); ++i)
                if (kinds[i] == kind)
                    group.presets.push_back(i);
    return groups;
}

// Noises to begin with, which have no picture.
struct Start {
    const char* name;
    const char* words; ///< that find it, besides its name
    const char* shape; ///< of fractal noise
    Output output = Output::value;
    std::vector<ColourStop> ramp = {};
};
const std::vector<Start> starts{{"noise", "plain gabor", "none"},
                                {"clouds",
                                 "cloud sky fbm fractal perlin",
                                 "fbm",
                                 Output::value,
                                 {{0, {0.2f, 0.42f, 0.75f}},
                                  {0.5f, {0.25f, 0.47f, 0.78f}},
                                  {0.62f, {1, 1, 1}},
                                  {1, {0.62f, 0.66f, 0.72f}}}},
                                {"billows", "billow fractal", "billow", Output::lit},
                                {"ridges", "ridged fractal", "ridged", Output::lit}};

Document document_of_start(const Start& start) {
    Document document = document_of({});
    set_parameter(document, "fractal", start.shape);
    if (document.request.kind == render::Kind::fractal) {
        document.request.scale = 128;
        document.request.fractal.octaves = 7;
    }
    document.output = start.output;
    if (!start.ramp.empty()) {
        document.colours = passes::own_colours;
        document.ramp = start.ramp;
    }
    return document;
}

// A space, and the words in lower case.
std::string spaced(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) {
        return std::isalnum(c) ? static_cast<char>(std::tolower(c)) : ' ';
    });
    return ' ' + text;
}

// The number of words searched for that begin a word of the text.
int words_found(const std::string& search, const std::string& text) {
    std::istringstream words(spaced(search));
    int found = 0;
    for (std::string word; words >> word;)
        found += spaced(text).find(' ' + word) != std::string::npos;
    return found;
}

} // namespace

const PresetPictures& preset_pictures() {
    static const PresetPictures pictures = [] {
        const auto reader = image::open_jpeg("presets.jpg", embedded("presets.jpg"));
        PresetPictures all;
        all.extent = {reader->format().width, reader->format().height};
        const std::size_t row = 3 * static_cast<std::size_t>(all.extent.width);
        all.colours.resize(row * static_cast<std::size_t>(all.extent.height));
        for (std::span<float> rest = all.colours; !rest.empty(); rest = rest.subspan(row))
            reader->read_row(rest.first(row));
        return all;
    }();
    return pictures;
}

Gallery gallery_window(Session& session, float width, float height) {
    if (!session.gallery)
        return {};
    static const std::vector<Group> groups = grouped_presets();
    const std::span<const render::Preset> presets = render::presets();
    const ImGuiStyle& style = ImGui::GetStyle();
    Gallery gallery{.picture_side = PresetPictures::side};
    for (const render::Preset& preset : presets)
        gallery.picture_side =
            std::max(gallery.picture_side,
                     ImGui::CalcTextSize(std::string(preset.name).c_str()).x + 2 * style.FramePadding.x);
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({width, height});
    ImGui::Begin("presets", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoBackground |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    if (ImGui::IsWindowAppearing()) {
        session.search.clear();
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(std::min(24 * ImGui::GetFontSize(), ImGui::GetContentRegionAvail().x));
    const bool entered = ImGui::InputTextWithHint("##search", "Search, for example: copper", &session.search,
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    const auto found = [&](const Group& group, std::size_t preset) {
        return words_found(session.search, fmt::format("{} {}", group.title, presets[preset].name));
    };
    const auto noises_found = [&](const Start& start) {
        return words_found(session.search, fmt::format("{} {}", start.name, start.words));
    };
    int most = 0;
    for (const Start& start : starts)
        most = std::max(most, noises_found(start));
    for (const Group& group : groups)
        for (const std::size_t preset : group.presets)
            most = std::max(most, found(group, preset));
    if (most == 0 && !session.search.empty())
        ImGui::TextUnformatted("Nothing has that name. These are all:");
    ImGui::BeginChild("pictures");
    gallery.top = ImGui::GetWindowPos().y;
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    bool first = true;
    bool noises = false;
    for (const Start& start : starts) {
        if (noises_found(start) < most)
            continue;
        if (!std::exchange(noises, true))
            ImGui::TextDisabled("Noises");
        else
            ImGui::SameLine();
        if (ImGui::Button(start.name, {gallery.picture_side, 0}) ||
            (entered && std::exchange(first, false))) {
            open_document(session, document_of_start(start), start.name);
            session.gallery = false;
        }
    }
    for (const Group& group : groups) {
        bool titled = false;
        for (const std::size_t preset : group.presets) {
            if (found(group, preset) < most)
                continue;
            if (!std::exchange(titled, true))
                ImGui::TextDisabled("%s", group.title.c_str());
            else if (ImGui::GetItemRectMax().x + style.ItemSpacing.x + gallery.picture_side <= right)
                ImGui::SameLine();
            const std::string name(presets[preset].name);
            const bool chosen =
                ImGui::InvisibleButton(name.c_str(), {gallery.picture_side, gallery.picture_side});
            const ImVec2 corner = ImGui::GetItemRectMin();
            const ImVec2 end = ImGui::GetItemRectMax();
            if (ImGui::IsItemVisible())
                gallery.pictures.push_back({preset, corner});
            draw.AddRect(corner, end,
                         ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_CheckMark : ImGuiCol_Separator),
                         0, 0, 2);
            label(draw, {corner.x, end.y - ImGui::GetFontSize() - style.FramePadding.x}, name,
                  ImGui::GetColorU32(ImGuiCol_Text));
            if (chosen || (entered && std::exchange(first, false))) {
                open_preset(session, name);
                session.gallery = false;
            }
        }
    }
    ImGui::EndChild();
    ImGui::End();
    return gallery;
}

} // namespace gabor::viewer
