#pragma once

#include "render/picture.hpp"

namespace gabor::render {

/// A picture worth starting from.
struct Preset {
    std::string_view name;
    std::string_view json; ///< as `from_json` takes it
};

/// All of them: the files of host/render/presets.
std::span<const Preset> presets();

/// Throws RequestError, listing the known names, when there is no such preset.
const Preset& find_preset(std::string_view name);

} // namespace gabor::render
