#include "viewer/document.hpp"

#include "render/request/load.hpp"
#include "viewer/document_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gabor::viewer {

namespace {

using render::Kind;

constexpr std::size_t most_steps = 1000;

// The document without its viewpoint.
Document without_viewpoint(const Document& document) {
    Document content = content_of(document);
    reset_orbit(content.request);
    return content;
}

} // namespace

std::string hex(const std::array<float, 3>& colour) {
    std::string text = "#";
    for (const float part : colour)
        text += fmt::format("{:02x}", std::lround(255 * std::clamp(part, 0.0f, 1.0f)));
    return text;
}

void reset_orbit(render::Request& request) {
    request.view.orbit = render::default_orbit(request.kind);
}

void set_parameter(Document& document, std::string_view name, const render::Value& value) {
    render::Request& request = document.request;
    if (name == "paint")
        render::load_paint(std::get<std::string>(value)); // throws if the file is missing
    const bool was_noise = !render::is_surface(request.kind), was_terrain = request.kind == Kind::terrain;
    render::set(request, name, value);
    const bool terrain = request.kind == Kind::terrain;
    // The shorter side of the picture shows four units of a material, or eight of terrain.
    if ((name == "material" && was_noise != !render::is_surface(request.kind)) || terrain != was_terrain)
        request.scale = terrain || (was_noise && !was_terrain)
                            ? std::max(2.0, std::min(request.width, request.height) / (terrain ? 8.0 : 4.0))
                            : render::Request().scale;
    if (name == "view" && render::is_pattern(request.kind)) {
        request.filter = !request.view.is_flat() && render::can_filter(request);
        render::drop_conflicting(request, "filter");
    }
    render::drop_conflicting(request, name);
    if (static_cast<std::size_t>(document.look) >= looks(request).size())
        document.look = Look::lit;
    if (name == "view" || name == "material" || name == "width" || name == "height")
        document.camera = render::default_camera(document.request);
}

void resize(Document& document, double factor) {
    Document resized = document;
    for (const std::string_view name : {"width", "height", "scale"})
        if (const auto value = render::parameter(name).get(document.request)) {
            const double number = factor * std::get<double>(*value);
            set_parameter(resized, name, name == "scale" ? number : std::round(number));
        }
    resized.camera = document.camera;
    resized.camera.zoom /= factor;
    document = resized;
}

render::Request with_output(render::Request request, Output output) {
    if (render::is_surface(request.kind))
        return request; // surfaces always have all channels
    if (output == Output::gradient || output == Output::lit) {
        request.gradient = true;
        render::drop_conflicting(request, "gradient");
    } else if (output == Output::phase || output == Output::intensity) {
        request.quadrature = true;
        render::drop_conflicting(request, "phasor");
    } else if (output == Output::phasor || output == Output::lit_phasor) {
        request.quadrature = request.phasor = true;
        render::drop_conflicting(request, "phasor");
    }
    return request;
}

Document document_of(const render::Request& request) {
    Document document;
    document.request = request;
    document.camera = render::default_camera(document.request);
    return document;
}

double& time_of(render::Request& request) {
    return request.kind == Kind::sea ? request.sea.seconds : request.evolution;
}

Document content_of(Document document) {
    document.camera = {};
    time_of(document.request) = 0;
    document.path.clear();
    document.origin.clear();
    return document;
}

void History::commit() {
    if (without_viewpoint(now) == without_viewpoint(steps_[at_])) {
        steps_[at_] = now;
        return;
    }
    steps_.resize(at_ + 1);
    steps_.push_back(now);
    if (steps_.size() > most_steps)
        steps_.erase(steps_.begin());
    at_ = steps_.size() - 1;
}

void History::saved_as(const std::string& path) {
    const auto take_file = [before = now.path, &path](Document& document) {
        if (document.path == before) {
            document.path = path;
            document.origin = std::filesystem::absolute(path);
        }
    };
    std::ranges::for_each(steps_, take_file);
    take_file(now);
}

void History::undo() {
    if (can_undo())
        go_to(at_ - 1);
}

void History::redo() {
    if (can_redo())
        go_to(at_ + 1);
}

void History::go_to(std::size_t step) {
    steps_[at_] = now;
    at_ = step;
    now = steps_[at_];
}

bool has_effect(const Document& document, std::string_view control) {
    const render::Request& request = document.request;
    const Output output = document.output;
    if (control == "tiles")
        return render::is_pattern(request.kind) && request.view.tileable;
    if (control == "animation")
        return request.kind == Kind::sea || request.kind == Kind::noise;
    if (control == "profile" || control == "colours" || control == "contrast") {
        if (render::is_surface(request.kind))
            return control == "contrast" && document.look == Look::height;
        const bool stripes = output == Output::phasor || output == Output::lit_phasor;
        return control == "profile"                        ? stripes
               : request.colour && output == Output::value ? false // a photograph's noise keeps its colours
               : control == "colours"
                   ? output != Output::gradient
                   : output != Output::phase && output != Output::variance && output != Output::phasor;
    }
    // These are kept for later, although the picture does not show them.
    if (control == "orientation" && request.view.in_space() && request.lobes.size() == 1 &&
        render::is_isotropic(request.lobes.front()))
        return false;
    if ((control == "lobes" && !request.paint.empty()) ||
        ((control == "frequency" || control == "orientation") && !request.paint.empty() &&
         !render::has_only_directions(request.paint)))
        return false;
    const auto rows = render::lobe_parameters();
    const bool of_lobe = std::ranges::find(rows, control, &render::LobeParameter::name) != rows.end();
    return render::parameter(of_lobe ? "lobes" : control).scope.holds(request);
}

bool is_lit(const Document& document) {
    return render::is_surface(document.request.kind)
               ? document.look == Look::lit
               : document.output == Output::lit || document.output == Output::lit_phasor;
}

bool shows_normals(const Document& document) {
    return render::is_surface(document.request.kind) ? document.look == Look::normal
                                                     : document.output == Output::gradient;
}

} // namespace gabor::viewer
