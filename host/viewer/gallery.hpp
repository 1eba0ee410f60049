#pragma once

#include "viewer/session.hpp"

namespace gabor::viewer {

/// Where the pictures of the presets stand in a view, in its units.
struct GalleryPlace {
    float x;
    float y;
    float scale; ///< units per pixel of PresetPictures
};
GalleryPlace gallery_place(float width, float height);

/// The names of the presets on their pictures, and what a click on one does.
void gallery_window(Session& session, float width, float height);

} // namespace gabor::viewer
