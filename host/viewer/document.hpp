#pragma once

#include "render/camera.hpp"
#include "render/parameters.hpp"

#include <vector>

namespace gabor::viewer {

using render::Camera;
using render::Coordinate;

enum class Output { value, gradient, phase, intensity, variance, phasor, lit };

/// What is shown of a material.
enum class Look { lit, colour, height, normal, roughness, metalness };

constexpr float least_contrast = 0.5f;
constexpr float most_contrast = 6;

/// All that decides what the window shows, but for the panels. A plain value: undo keeps copies.
struct Document {
    render::Request request;
    Camera camera;
    Output output = Output::value;
    Look look = Look::lit;
    bool directx_normals = false; ///< normal maps have green for down, as DirectX, and not for up, as OpenGL
    int colours = 0;              ///< colour map, as in shaders/viewer/colours.glsl
    float contrast = 2;           ///< standard deviations from the mean to the ends

    bool operator==(const Document&) const = default;
};

/// A document with the request's picture in the middle of the view.
Document document_of(const render::Request& request);

/// Puts in a parameter, and back to default what cannot stand beside it. Another view begins where the camera
/// is by default, and filtered where it has a distance. Throws RequestError where that value cannot be.
void set_parameter(Document& document, std::string_view name, const render::Value& value);

/// The request with the channels that an output is made of, beside its own.
render::Request with_output(render::Request request, Output output);

/// What undo and redo go through. What is edited is `now`; `commit` makes a step of what has changed since
/// the last one.
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
