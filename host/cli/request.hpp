#pragma once

// The options that describe a request, which render, maps and texture share.

#include "cli/options.hpp"
#include "image/exr.hpp"

namespace gabor::cli {

/// Values that are not given come from --like or --preset, or are defaults.
struct RequestOptions {
    std::optional<std::string> size;
    std::optional<std::string> region;
    std::optional<std::string> like;
    std::optional<std::string> preset;
    ParameterOptions parameters; ///< all but width and height, which are in `size`
};

/// Adds --preset, --like, and --size, whose help says that sides have at most `most` pixels and that the
/// default is `size`.
void add_source_options(CLI::App& command, RequestOptions& options, double most, std::string_view size);
void add_region_option(CLI::App& command, RequestOptions& options);

/// Adds the options of a group's parameters, or of those that the command `offers`, under a title; an empty
/// title hides them.
void add_group(CLI::App& command, RequestOptions& options, const std::string& title,
               render::Parameter::Group group, bool (*offers)(const render::Parameter&) = nullptr);

/// Adds and reads --frames.
void add_frames_option(CLI::App& command, std::optional<std::string>& frames);
int frames_of(const std::optional<std::string>& frames);

/// What the options ask for.
struct Asked {
    render::Request request;
    std::optional<image::Rect> like_region; ///< of the file of --like, if its size is kept
    bool scaled = false;                    ///< whether an option, a preset or another file sets the scale
    int side = 0;                           ///< shorter side of the picture, before options change it

    /// The region of --region or --like, or the whole picture. Throws RequestError unless the region lies
    /// within the picture.
    image::Rect region(const RequestOptions& options) const;
};

/// Reads the options. Unless a scale is given, terrain spans two hills. Does not check the request.
Asked asked_by(const RequestOptions& options);

/// What is drawn, as in "material wood".
std::string subject(const render::Request& request);

} // namespace gabor::cli
