#pragma once

#include "render/plan/camera.hpp"
#include "render/request/parameters.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace gabor::viewer {

using render::Camera;
using render::Coordinate;

enum class Output { value, gradient, phase, intensity, variance, phasor, lit, lit_phasor };

/// What the window shows of a material.
enum class Look { lit, colour, height, normal, roughness, metalness };

/// A stop of a colour map: its position, and its red, green and blue in sRGB, all from 0 to 1.
struct ColourStop {
    float at;
    std::array<float, 3> colour;
    bool operator==(const ColourStop&) const = default;
};
constexpr std::size_t most_stops = 8;

/// A colour in sRGB, written as #rrggbb.
std::string hex(const std::array<float, 3>& colour);

constexpr float least_contrast = 0.5f;
constexpr float most_contrast = 6;

/// Everything that decides what the window shows, except its panels. Undo keeps copies of it.
struct Document {
    render::Request request;
    Camera camera;
    Output output = Output::value;
    Look look = Look::lit;
    bool directx_normals = false; ///< green points down in normal maps, as in DirectX; in OpenGL it points up
    int colours = 0;              ///< colour map, as in shaders/viewer/colours.glsl; the last one is `ramp`
    std::vector<ColourStop> ramp{
        {0, {0.11f, 0.13f, 0.2f}}, {0.5f, {0.68f, 0.34f, 0.2f}}, {1, {1, 0.93f, 0.78f}}};
    int profile = 0;                 ///< profile of stripes, as in shaders/viewer/colours.glsl
    float contrast = 2;              ///< standard deviations from the mean to the ends of the colour map
    std::string path = "noise.json"; ///< file to save to
    std::filesystem::path origin; ///< absolute path of the file it was read from or saved to; empty for none
    std::string photograph;       ///< file of the photograph that the noise was fitted to; empty for none

    bool operator==(const Document&) const = default;
};

/// A document with the request's picture in the middle of the view.
Document document_of(const render::Request& request);

/// What changes while a request plays: the evolution of noise, or the seconds of a sea.
double& time_of(render::Request& request);

/// The document without its camera, time and file. Changes to these add no undo step and need no saving.
Document content_of(Document document);

/// Resets the camera around a body or a landscape.
void reset_orbit(render::Request& request);

/// Sets a parameter and resets those that conflict with it. A new view starts with its default camera, and
/// with the filter on if it is in perspective. Throws RequestError for a value that is not accepted.
void set_parameter(Document& document, std::string_view name, const render::Value& value);
/// Multiplies the picture's pixels along both sides, and keeps what it and the window show.
void resize(Document& document, double factor);

/// Adds the channels that an output needs.
render::Request with_output(render::Request request, Output output);

/// Undo and redo. Edit `now`, then `commit` a step.
class History {
  public:
    explicit History(Document document) : now(std::move(document)), steps_{now} {}

    Document now;

    /// Adds a step if anything has changed since the last one. Call it while nothing is being dragged. Moving
    /// the camera and playing time add no step.
    void commit();
    /// Records that `now` was saved to `path`, also in the steps that shared its previous path.
    void saved_as(const std::string& path);
    bool can_undo() const { return at_ > 0; }
    bool can_redo() const { return at_ + 1 < steps_.size(); }
    void undo();
    void redo();

  private:
    void go_to(std::size_t step);

    std::vector<Document> steps_;
    std::size_t at_ = 0;
};

/// Whether a control changes anything in the window. `control` is the name of a parameter, or `colours`,
/// `contrast`, `profile` or `tiles`.
bool has_effect(const Document& document, std::string_view control);

/// Whether the window shows a lit surface, and whether it shows a normal map.
bool is_lit(const Document& document);
bool shows_normals(const Document& document);

} // namespace gabor::viewer
