#pragma once

#include "viewer/document.hpp"

#include <string>
#include <string_view>

namespace gabor::viewer {

/// A document as one JSON object: the request's parameters, as gabor render takes them, and under `viewer`
/// how the window shows them, which gabor render passes over.
std::string to_json(const Document& document);

/// The way back. What is not there is as in `defaults`. Throws RequestError, saying what is accepted.
Document document_from_json(std::string_view json, const Document& defaults = {});

/// The names of outputs, of looks and of colour maps, in the order of their numbers.
std::span<const std::string_view> output_names();
std::span<const std::string_view> look_names();
std::span<const std::string_view> colour_names();

} // namespace gabor::viewer
