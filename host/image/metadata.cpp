#include "image/metadata.hpp"

#include "image/png.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gabor::image {

namespace {

// The largest picture to turn, in bytes.
constexpr std::size_t most_turned = std::size_t{1} << 30;

// Integers in a file's bytes; bytes beyond its end are 0.
struct Bytes {
    std::span<const std::uint8_t> bytes;
    bool low_first = false;

    std::uint32_t operator()(std::size_t at, std::size_t size) const {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < size; ++i)
            if (const std::size_t from = at + (low_first ? size - 1 - i : i); from < bytes.size())
                value |= std::uint32_t{bytes[from]} << 8 * (size - 1 - i);
        return value;
    }
};

// An ICC profile, https://www.color.org/specification/ICC.1-2022-05.pdf: a header of 128 bytes, a table of
// tags, and their data.
struct Profile {
    Bytes read;

    // Returns where a tag's data begin, or the end of the file.
    std::size_t find(std::string_view name) const {
        for (std::size_t i = 0; i < std::min<std::size_t>(read(128, 4), 100); ++i)
            if (text(132 + 12 * i, 4, 1) == name)
                return read(136 + 12 * i, 4);
        return read.bytes.size();
    }

    // Returns printable text whose characters are `step` bytes apart.
    std::string text(std::size_t at, std::size_t count, std::size_t step) const {
        std::string found;
        for (std::size_t i = 0; i < std::min<std::size_t>(count, 80); ++i)
            if (const std::uint32_t letter = read(at + step * i, step); letter != 0)
                found += letter < ' ' || letter > '~' ? '?' : static_cast<char>(letter);
        return found;
    }

    std::string name() const {
        const std::size_t at = find("desc");
        const std::string found = text(at, 4, 1) == "mluc"
                                      ? text(at + read(at + 24, 4), read(at + 20, 4) / 2, 2)
                                      : text(at + 12, read(at + 8, 4), 1);
        return found.empty() ? "unnamed" : found;
    }

    double number(std::size_t at) const { return static_cast<std::int32_t>(read(at, 4)) / 65536.0; }

    // Returns the linear value of a channel at one half, from its tone curve.
    double half(std::size_t curve) const {
        const std::size_t count = read(curve + 8, 4);
        if (text(curve, 4, 1) == "para") { // (ax + b)^gamma
            const bool only_gamma = read(curve + 8, 2) == 0;
            const double x = only_gamma ? 0.5 : number(curve + 16) * 0.5 + number(curve + 20);
            return std::pow(x, number(curve + 12));
        }
        if (count < 2)
            return std::pow(0.5, count == 0 ? 1 : read(curve + 12, 2) / 256.0);
        return read(curve + 12 + (count - 1) / 2 * 2, 2) / 65535.0;
    }

    bool is_srgb() const {
        const bool grey = text(16, 4, 1) == "GRAY";
        const double linear = half(find(grey ? "kTRC" : "rTRC"));
        bool same = std::abs(linear - 0.2140) < 0.01; // also for a gamma of 2.2
        if (!grey)
            for (const auto& [primary, x, y] :
                 {std::tuple{"rXYZ", 0.4361, 0.2225}, {"gXYZ", 0.3851, 0.7169}, {"bXYZ", 0.1431, 0.0606}}) {
                const std::size_t at = find(primary);
                same &= std::abs(number(at + 8) - x) + std::abs(number(at + 12) - y) < 0.01;
            }
        return same;
    }
};

class Upright : public PictureReader {
  public:
    Upright(const std::filesystem::path& path, PictureReader& picture)
        : stored_(picture.format()),
          values_(static_cast<std::size_t>(stored_.channels + (stored_.alpha ? 1 : 0))),
          width_(static_cast<std::size_t>(stored_.width)), height_(static_cast<std::size_t>(stored_.height)) {
        const std::size_t count = values_ * width_ * height_;
        if (sizeof(std::uint16_t) * count > most_turned)
            refuse_picture(path, fmt::format("its EXIF data turn it, and it takes more than {} MiB: save it "
                                             "upright",
                                             most_turned >> 20));
        levels_ = std::make_unique_for_overwrite<std::uint16_t[]>(count);
        std::vector<float> row(width_ * static_cast<std::size_t>(stored_.channels));
        // Exact, as EXIF data are only read from files of 8 or 16 bits.
        const auto level = [](float value) { return static_cast<std::uint16_t>(quantize(value, 16)); };
        for (std::uint16_t* at = levels_.get(); at != levels_.get() + count;) {
            picture.read_row(row);
            for (std::size_t i = 0; i < row.size(); ++i) {
                *at++ = level(row[i]);
                if (stored_.alpha && (i + 1) % static_cast<std::size_t>(stored_.channels) == 0)
                    *at++ = level(picture.alpha()[i / static_cast<std::size_t>(stored_.channels)]);
            }
        }
        Format format = stored_;
        format.orientation = 1;
        if (stored_.orientation > 4)
            std::swap(format.width, format.height);
        set_format(format);
    }

    void read_row(std::span<float> row) override {
        fill(row, [this, i = std::size_t{0}]() mutable {
            const std::size_t x = i / values_, value = i % values_;
            ++i;
            return static_cast<float>(levels_[pixel(x, row_) * values_ + value]) / 65535.0f;
        });
        ++row_;
    }

  private:
    // Returns the index of the stored pixel that is shown at x, y.
    std::size_t pixel(std::size_t x, std::size_t y) const {
        const int o = stored_.orientation;
        if (o > 4)
            std::swap(x, y);
        if (o == 2 || o == 3 || o == 7 || o == 8)
            x = width_ - 1 - x;
        if (o == 3 || o == 4 || o == 6 || o == 7)
            y = height_ - 1 - y;
        return y * width_ + x;
    }

    Format stored_;
    std::size_t values_; // of a pixel
    std::size_t width_;
    std::size_t height_;
    std::unique_ptr<std::uint16_t[]> levels_;
    std::size_t row_ = 0; // the next
};

} // namespace

int exif_orientation(std::span<const std::uint8_t> exif) {
    const Bytes read{exif, !exif.empty() && exif[0] == 'I'};
    const std::size_t table = read(4, 4);
    for (std::size_t i = 0; i < read(table, 2); ++i)
        if (const std::size_t entry = table + 2 + 12 * i; read(entry, 2) == 0x0112)
            return read(entry + 8, 2) - 1 < 8 ? static_cast<int>(read(entry + 8, 2)) : 1;
    return 1;
}

std::string foreign_profile(std::span<const std::uint8_t> icc) {
    const Profile profile{{icc}};
    return profile.is_srgb() ? std::string{} : profile.name();
}

std::unique_ptr<PictureReader> upright(const std::filesystem::path& path,
                                       std::unique_ptr<PictureReader> picture) {
    if (picture->format().orientation == 1)
        return picture;
    return std::make_unique<Upright>(path, *picture);
}

} // namespace gabor::image
