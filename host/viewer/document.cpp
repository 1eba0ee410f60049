#include "viewer/document.hpp"

#include "error.hpp"

#include <cmath>

namespace gabor::viewer {

namespace {

constexpr std::size_t most_steps = 1000;

// The document but for what moves by itself or by looking around.
Document without_viewpoint(Document document) {
    document.camera = {};
    document.orbit = {};
    document.picture.scale = 0;
    document.picture.time = 0;
    return document;
}

} // namespace

Coordinate Coordinate::moved(double by) const {
    const double carried = std::floor(by);
    Coordinate result{whole + static_cast<std::int64_t>(carried), part + (by - carried)};
    if (result.part >= 1) {
        ++result.whole;
        result.part -= 1;
    }
    return result;
}

bool Document::operator==(const Document& other) const {
    return render::to_json(picture) == render::to_json(other.picture) && camera == other.camera &&
           body == other.body && waves == other.waves && orbit == other.orbit && output == other.output &&
           colours == other.colours && contrast == other.contrast && comparison == other.comparison;
}

View Document::view() const {
    if (body)
        return *body;
    return picture.view == "horizon" ? View::perspective : View::plane;
}

void Document::set_view(View view) {
    body.reset();
    if (on_body(view))
        body = view;
    picture.view = view == View::perspective ? "horizon" : "flat";
    picture.filter = view != View::plane;
    if (picture.filter) { // they exclude each other
        picture.gradient = false;
        picture.values = 1;
    }
    if (view != View::plane) {
        picture.tileable = false;
        picture.paint.clear();
    }
    camera = default_camera(*this);
}

render::Picture Document::exported() const {
    if (!body)
        return picture;
    const render::Lobe first =
        picture.lobes.empty() ? render::Lobe{picture.frequency, picture.orientation} : picture.lobes.front();
    render::Picture result;
    result.width = picture.width;
    result.height = picture.height;
    result.scale = picture.scale;
    result.frequency = first.frequency;
    result.orientation = first.orientation;
    result.orientation_spread = waves == Waves::isotropic || waves == Waves::surface_isotropic ? 90 : 0;
    result.solid = waves == Waves::oriented || waves == Waves::isotropic;
    result.seed = picture.seed;
    result.filter = picture.filter;
    result.view = *body == View::sphere ? "sphere" : "torus";
    return result;
}

Camera default_camera(const Document& document) {
    const render::Picture& picture = document.picture;
    if (document.view() != View::plane)
        return {};
    return Camera{}.moved(picture.width / 2.0 / picture.scale, picture.height / 2.0 / picture.scale);
}

Document document_of(const render::Picture& picture) {
    Document document;
    document.picture = picture;
    if (render::is_in_space(picture)) {
        if (picture.view == "slice")
            throw RequestError("view slice: the viewer has the views flat, horizon, sphere and torus");
        document.body = picture.view == "sphere" ? View::sphere : View::torus;
        document.waves = render::in_space(picture).waves;
        document.picture.view = "flat";
    }
    document.camera = default_camera(document);
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

} // namespace gabor::viewer
