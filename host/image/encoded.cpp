#include "image/picture.hpp"

#include <cmath>

namespace gabor::image {

namespace {

constexpr float no_height = -32768; // below both encodings' heights on Earth

// Terrain-RGB: https://docs.mapbox.com/data/tilesets/guides/access-elevation-data
// Terrarium: https://github.com/tilezen/joerd/blob/master/docs/formats.md
class Encoded : public PictureReader {
  public:
    Encoded(const std::filesystem::path& path, bool terrarium)
        : file_(open_picture(path)), terrarium_(terrarium),
          row_(3 * static_cast<std::size_t>(file_->format().width)) {
        Format format = file_->format();
        if (format.channels != 3 || format.bits != 8)
            refuse_picture(path, "encoded heights need a picture of 8 bits in red, green and blue");
        if (!format.profile.empty())
            refuse_picture(path, "encoded heights must not have a colour profile");
        if (format.alpha)
            format.missing = no_height;
        set_format({.width = format.width,
                    .height = format.height,
                    .channels = 1,
                    .linear = true,
                    .bits = 32,
                    .missing = format.missing});
    }

    void read_row(std::span<float> row) override {
        file_->read_row(row_);
        const auto level = [](float share) { return std::round(255.0 * share); };
        fill(row, [&, at = row_.begin(), x = std::size_t{0}]() mutable {
            const double red = level(*at++), green = level(*at++), blue = level(*at++);
            if (const auto alpha = file_->alpha(); !alpha.empty() && alpha[x++] == 0)
                return no_height;
            return static_cast<float>(terrarium_ ? red * 256 + green + blue / 256 - 32768
                                                 : (red * 65536 + green * 256 + blue) / 10 - 10000);
        });
    }

  private:
    std::unique_ptr<PictureReader> file_;
    bool terrarium_;
    std::vector<float> row_;
};

} // namespace

std::unique_ptr<PictureReader> open_encoded(const std::filesystem::path& path, bool terrarium) {
    return std::make_unique<Encoded>(path, terrarium);
}

} // namespace gabor::image
