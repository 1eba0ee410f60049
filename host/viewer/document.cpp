#include "viewer/document.hpp"

#include "render/load.hpp"

#include <algorithm>

namespace gabor::viewer {

namespace {

constexpr std::size_t most_steps = 1000;

// The document without what changes by looking around or by itself.
Document without_viewpoint(const Document& document) {
    Document content = content_of(document);
    if (auto* body = std::get_if<render::Body>(&content.request.view))
        *body = {body->shape, body->solid};
    return content;
}

} // namespace

void set_parameter(Document& document, std::string_view name, const render::Value& value) {
    render::Request& request = document.request;
    if (name == "paint")
        render::load_paint(std::get<std::string>(value)); // throws if it is missing
    const bool was_noise = !render::has_material(request);
    render::set(request, name, value);
    if (name == "material" &&
        was_noise != !render::has_material(request)) // a picture shows four by four units
        request.scale = was_noise ? std::max(2.0, std::min(request.width, request.height) / 4.0)
                                  : render::Request().scale;
    if (name == "view") {
        request.filter = !render::is_flat(request.view) && render::can_filter(request);
        render::drop_conflicting(request, "filter");
    }
    render::drop_conflicting(request, name);
    if (name == "view" || name == "material" || name == "width" || name == "height")
        document.camera = render::default_camera(document.request);
}

render::Request with_output(render::Request request, Output output) {
    if (render::has_material(request))
        return request; // always has all channels
    if (output == Output::gradient || output == Output::lit) {
        request.gradient = true;
        render::drop_conflicting(request, "gradient");
    } else if (output == Output::phase || output == Output::intensity) {
        request.quadrature = true;
        render::drop_conflicting(request, "quadrature");
    } else if (output == Output::phasor) {
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

Document content_of(Document document) {
    document.camera = {};
    document.request.time = 0;
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

} // namespace gabor::viewer
