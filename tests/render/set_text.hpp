#pragma once

#include "render/request/parameters.hpp"

/// Sets a parameter from text, as the command line does.
inline void set_text(gabor::render::Request& request, std::string_view name, std::string_view text) {
    gabor::render::set(request, name, gabor::render::read(gabor::render::parameter(name), text));
}
