#include "viewer/photograph.hpp"

#include "viewer/file_dialog.hpp"
#include "viewer/widgets.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace gabor::viewer {

namespace {

// Returns the camera that shows the same position of a noise whose kernel radius is `times` as long.
Camera in_radii(const Camera& camera, double times) {
    const auto coordinate = [&](const Coordinate& c) {
        return Coordinate{}.moved((static_cast<double>(c.whole) + c.part) / times);
    };
    return {coordinate(camera.x), coordinate(camera.y), camera.zoom};
}

// Shrinks large pictures to a size that is quick to export.
void limit_size(render::Request& request) {
    constexpr double most = 4096;
    const double shrunk = std::min(1.0, most / std::max(request.width, request.height));
    request.width = static_cast<int>(std::lround(shrunk * request.width));
    request.height = static_cast<int>(std::lround(shrunk * request.height));
}

void take(Session& session, FittedPreset fitted) {
    limit_size(fitted.request);
    Document next = session.document();
    const render::Request before = std::exchange(next.request, fitted.request);
    const bool again = session.fitted && session.fitted_path == session.fitter.path() &&
                       before.colour.has_value() == fitted.request.colour.has_value();
    if (again) {
        next.request.seed = before.seed;
        next.request.filter = before.filter;
        next.camera = in_radii(next.camera, next.request.scale / before.scale);
    } else {
        session.export_target.chosen = session.export_target.of(session.document()).as; // keeps the form
        reset_panel(session);
        next.camera = render::default_camera(next.request);
        next.output = Output::value;
        next.contrast = Document().contrast;
        next.path = std::filesystem::path(session.fitter.path()).replace_extension(".json").string();
        next.origin.clear();
    }
    next.photograph = session.fitted_path = session.fitter.path();
    add_recent(session, session.fitted_path);
    session.document() = next;
    session.fitted = std::move(fitted);
}

} // namespace

bool is_photograph(const std::filesystem::path& path) {
    return std::ranges::find(photograph_endings, lower_extension(path)) != photograph_endings.end();
}

void open_photograph(Session& session, const std::string& path) {
    session.fitter.open(path);
    session.photograph_beside = true;
}

void poll_fitter(Session& session) {
    session.fitter.poll();
    if (std::string error = session.fitter.take_error(); !error.empty())
        notify(session, std::move(error), true);
    if (std::optional<FittedPreset> fitted = session.fitter.take())
        take(session, std::move(*fitted));
}

bool shows_photograph(const Session& session) {
    const Document& document = session.history.now;
    const auto& photograph = session.fitter.photograph();
    return session.photograph_beside && photograph &&
           (document.photograph == photograph->path || session.fitter.running()) &&
           document.request.kind == render::Kind::noise &&
           document.request.view.projection == render::Projection::flat;
}

std::optional<std::string> fitted_glsl(const Session& session) {
    if (!session.fitted || session.history.now.output != Output::value)
        return {};
    const render::Request& now = session.history.now.request;
    render::Request fitted = session.fitted->request;
    fitted.seed = now.seed;
    fitted.filter = now.filter; // the GLSL has a filtered and an unfiltered form
    fitted.width = now.width;
    fitted.height = now.height;
    if (fitted != now)
        return {};
    std::string code = session.fitted->glsl;
    constexpr std::string_view seed = "_seed = 0u;";
    if (const std::size_t at = code.find(seed); at != std::string::npos)
        code.replace(at, seed.size(), fmt::format("_seed = {}u;", now.seed));
    return code;
}

void photograph_panel(Session& session) {
    Fitter& fitter = session.fitter;
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::TextUnformatted(std::filesystem::path(fitter.path()).filename().string().c_str());
    auto lobes = static_cast<float>(fitter.lobes());
    if (slider("lobes", lobes, 1, Fitter::most_lobes, "%.0f", ImGuiSliderFlags_AlwaysClamp))
        fitter.set_lobes(static_cast<int>(lobes));
    tooltip("The largest number of lobes; each costs as much as a plain noise. The fit uses fewer if more "
            "would overfit.");
    ImGui::Checkbox("side by side", &session.photograph_beside);
    tooltip("Tab: show the photograph beside its noise, or the noise alone");
    ImGui::SameLine();
    if (ImGui::Button("Close"))
        fitter.close();
    tooltip("Close the photograph, and keep the noise");
    if (fitter.running())
        progress_bar(fitter.progress(), width);
    else if (session.fitted)
        for (const std::string& line : session.fitted->lines)
            ImGui::TextWrapped("%s", line.c_str());
}

void photograph_overlay(const Session& session, float width, float height) {
    if (!shows_photograph(session))
        return;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const float margin = ImGui::GetStyle().WindowPadding.x;
    const float middle = width * session.divider;
    const ImU32 text = ImGui::GetColorU32(ImGuiCol_Text);
    label(draw, {margin, margin}, "photograph", text);
    label(draw, {middle + margin, margin},
          session.fitted ? fmt::format("fitted noise, {} lobes", session.history.now.request.lobes.size())
                         : "fitting a noise",
          text);
    draw.AddLine({middle, 0}, {middle, height}, IM_COL32(12, 13, 15, 255), 3);
}

} // namespace gabor::viewer
