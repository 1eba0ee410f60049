#include "viewer/preset_pictures.hpp"

#include "image/picture.hpp"
#include "viewer/embedded.hpp"

#include <span>

namespace gabor::viewer {

const PresetPictures& preset_pictures() {
    static const PresetPictures pictures = [] {
        const std::span<const unsigned char> jpeg = embedded("presets.jpg");
        const auto reader = image::open_jpeg(
            "presets.jpg",
            {::fmemopen(const_cast<unsigned char*>(jpeg.data()), jpeg.size(), "rb"), std::fclose});
        PresetPictures all;
        all.extent = {reader->format().width, reader->format().height};
        const std::size_t row = 3 * static_cast<std::size_t>(all.extent.width);
        all.colours.resize(row * static_cast<std::size_t>(all.extent.height));
        for (std::span<float> rest = all.colours; !rest.empty(); rest = rest.subspan(row))
            reader->read_row(rest.first(row));
        return all;
    }();
    return pictures;
}

} // namespace gabor::viewer
