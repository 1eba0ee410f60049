#pragma once

#include "render/picture.hpp"
#include "render/solid.hpp"
#include "study/ingredients.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace gabor::viewer {

/// A coordinate in kernel radii that is as precise far away as it is near: whole + part, part in [0, 1).
struct Coordinate {
    std::int64_t whole = 0;
    double part = 0;

    Coordinate moved(double by) const;
    bool operator==(const Coordinate&) const = default;
};

/// The point of the plane in the middle of the view.
struct Camera {
    Coordinate x;
    Coordinate y;

    Camera moved(double by_x, double by_y) const { return {x.moved(by_x), y.moved(by_y)}; }
    bool operator==(const Camera&) const = default;
};

enum class Output { value, gradient, phase, intensity, variance };

enum class View { plane, perspective, sphere, torus };
/// Of noise in space, on a sphere or a torus: along one direction or along all, in space or along the
/// surface.
using Waves = render::SolidWaves;

constexpr bool on_body(View view) {
    return view == View::sphere || view == View::torus;
}

/// From where a body is seen.
struct Orbit {
    float yaw = 0;    ///< degrees around a body's axis
    float pitch = 30; ///< degrees above its equator
    float zoom = 1;   ///< how much larger than to fit the view a body is
    bool operator==(const Orbit&) const = default;
};

/// What stands beside the picture in the split view: another recipe of the drop-in on the same parameters, or
/// one of the noises that the paper compares.
struct Comparison {
    std::string recipe; ///< empty for `ingredients`
    study::Ingredients ingredients;
    bool operator==(const Comparison&) const = default;
};

/// All that decides what the window shows, but for the panels. A plain value: undo keeps copies.
struct Document {
    render::Picture picture;
    Camera camera;
    std::optional<View> body; ///< a sphere or a torus, instead of the picture's plane
    Waves waves = Waves::surface_isotropic;
    Orbit orbit;
    Output output = Output::value;
    int colours = 0;    ///< colour map, as in shaders/viewer/colours.glsl
    float contrast = 2; ///< standard deviations from the mean to the ends
    std::optional<Comparison> comparison;

    View view() const;
    /// Another view, with the filter where it is needed, and the camera where it begins.
    void set_view(View view);
    /// The picture with its view: what presets and exports hold. Noise in space has one lobe, a recipe of its
    /// own and no time; what it cannot have is left out.
    render::Picture exported() const;
    bool operator==(const Document& other) const;
};

/// Where the camera is for the view to show what gabor render does.
Camera default_camera(const Document& document);

/// A document with the picture in the middle of the view. Throws RequestError for a view that the viewer does
/// not have.
Document document_of(const render::Picture& picture);

/// Where one has been. What is edited is `now`; `commit` makes a step of what has changed since the last one.
class History {
  public:
    explicit History(Document document) : now(std::move(document)), steps_{now} {}

    Document now;

    /// Call while nothing is being dragged. Where the camera stands is no step of its own, nor is the time.
    void commit();
    bool can_undo() const { return at_ > 0; }
    bool can_redo() const { return at_ + 1 < steps_.size(); }
    void undo();
    void redo();

  private:
    void go_to(std::size_t step);

    std::vector<Document> steps_;
    std::size_t at_ = 0;
};

} // namespace gabor::viewer
