#include "viewer/preset_pictures.hpp"

#include "viewer/embedded.hpp"

#include <algorithm>
#include <memory>
#include <span>
#include <stdexcept>

#define STBI_ONLY_JPEG
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace gabor::viewer {

const PresetPictures& preset_pictures() {
    static const PresetPictures pictures = [] {
        const std::span<const unsigned char> jpeg = embedded("presets.jpg");
        PresetPictures all;
        int channels = 0;
        const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> bytes(
            stbi_load_from_memory(jpeg.data(), static_cast<int>(jpeg.size()), &all.extent.width,
                                  &all.extent.height, &channels, 3),
            stbi_image_free);
        if (!bytes)
            throw std::logic_error("the presets' pictures cannot be read");
        all.colours.resize(3 * static_cast<std::size_t>(all.extent.width) *
                           static_cast<std::size_t>(all.extent.height));
        std::transform(bytes.get(), bytes.get() + all.colours.size(), all.colours.begin(),
                       [](stbi_uc byte) { return static_cast<float>(byte) / 255.0f; });
        return all;
    }();
    return pictures;
}

} // namespace gabor::viewer
