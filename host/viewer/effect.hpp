#pragma once

#include "viewer/document.hpp"

#include <string_view>

namespace gabor::viewer {

/// Why a control changes nothing that the window shows of this document, as a sentence for its user; empty
/// where it does. `control`: the name of a parameter, or `colours`, `contrast`, `tiles`.
std::string_view disabled_reason(const Document& document, std::string_view control);

} // namespace gabor::viewer
