#pragma once

#include "fit/fit.hpp"

#include <filesystem>
#include <string>

namespace gabor::fit {

/// The name of the function for a file NAME.glsl. Throws RequestError if GLSL does not allow it.
std::string function_name(const std::filesystem::path& file);

/// The GLSL function vec3 NAME_colour(vec3 z, vec3 removed). It returns the colour of the components z after
/// a filter has removed the shares `removed` of their variance.
std::string colour_function(const std::string& name, const noise::Colour& colour);

/// GLSL to put after gabor_noise.glsl:
///     vec3 NAME(vec2 p)                             the colour, p in the exemplar's pixels
///     vec4 NAME_filtered(vec2 p, vec2 dx, vec2 dy)  its mean over a pixel, and the removed variance, if
///                                                   gabor_filter.glsl comes before
std::string glsl_of(const std::string& name, const std::filesystem::path& image, const Exemplar& exemplar,
                    const FittedNoise& fitted);

} // namespace gabor::fit
