#pragma once

#include "viewer/document.hpp"

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace gabor::viewer {

/// Writes a document as one JSON object: the request's parameters, as gabor render reads them, and under
/// `viewer` how the window shows them, which gabor render ignores.
std::string to_json(const Document& document);

/// Reads such an object. Missing parameters and a missing camera have their usual defaults; other missing
/// members are taken from `defaults`. Throws RequestError, which says what is accepted.
Document document_from_json(std::string_view json, const Document& defaults = {});

/// Names in the order of Output, Look, the colour maps and the profiles of stripes.
inline constexpr std::array<std::string_view, 8> output_names{"value",    "gradient", "phase", "intensity",
                                                              "variance", "stripes",  "lit",   "lit stripes"};
inline constexpr std::array<std::string_view, 6> look_names{"lit",    "colour",    "height",
                                                            "normal", "roughness", "metalness"};
/// The names of the looks that the request's material or terrain has.
inline std::span<const std::string_view> looks(const render::Request& request) {
    return std::span(look_names).first(render::is_pattern(request.kind) ? look_names.size() : 4);
}
inline constexpr std::array<std::string_view, 6> colour_names{"grey",  "viridis", "cool to warm",
                                                              "ember", "sea",     "own"};
inline constexpr std::array<std::string_view, 5> profile_names{"sine", "triangle", "sawtooth", "bands",
                                                               "ridges"};

} // namespace gabor::viewer
