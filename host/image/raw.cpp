#include "error.hpp"
#include "image/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

namespace gabor::image {

namespace {

constexpr float hgt_void = -32768;

template <typename Word>
Word in_order(const std::uint8_t* bytes, std::endian order) {
    Word word;
    std::memcpy(&word, bytes, sizeof word);
    if (order != std::endian::native) {
        Word turned = 0;
        for (unsigned shift = 0; shift < 8 * sizeof word; shift += 8)
            turned = static_cast<Word>(turned << 8 | (word >> shift & 0xffu));
        word = turned;
    }
    return word;
}

class Raw : public PictureReader {
  public:
    Raw(const std::filesystem::path& path, int width, int height, std::endian order)
        : path_(path), file_(open_file(path)), order_(order) {
        const std::uintmax_t size = std::filesystem::file_size(path);
        const std::uintmax_t heights =
            static_cast<std::uintmax_t>(width) * static_cast<std::uintmax_t>(height);
        if (size != 2 * heights && size != 4 * heights)
            throw RequestError(
                fmt::format("'{}' has {} bytes, but {} x {} heights without a header take {} or, "
                            "as 32-bit floats, {}",
                            path.string(), size, width, height, 2 * heights, 4 * heights));
        floats_ = size == 4 * heights;
        bytes_.resize(size / static_cast<std::size_t>(height));
        set_format(
            {.width = width, .height = height, .channels = 1, .linear = floats_, .bits = floats_ ? 32 : 16});
    }

    void go_to(int row) {
        const auto at = static_cast<off_t>(bytes_.size()) * row;
        if (::fseeko(file_.get(), at, SEEK_SET) != 0)
            refuse_picture(path_, std::strerror(errno));
    }

    void read_row(std::span<float> row) override {
        if (std::fread(bytes_.data(), 1, bytes_.size(), file_.get()) != bytes_.size())
            refuse_picture(path_, "it ends early");
        const std::size_t size = bytes_.size() / static_cast<std::size_t>(format().width);
        fill(row, [&, at = bytes_.data()]() mutable {
            const std::uint8_t* const here = std::exchange(at, at + size);
            return floats_ ? std::bit_cast<float>(in_order<std::uint32_t>(here, order_))
                           : static_cast<float>(in_order<std::uint16_t>(here, order_)) / 65535.0f;
        });
    }

  private:
    std::filesystem::path path_;
    File file_;
    std::endian order_;
    bool floats_ = false;
    std::vector<std::uint8_t> bytes_;
};

// The longitude and latitude in a name like N49E006.hgt, which are those of the lower left height.
std::optional<std::array<int, 2>> place_in(const std::string& name) {
    int latitude = 0, longitude = 0;
    char north = 0, east = 0;
    if (std::sscanf(name.c_str(), "%c%2d%c%3d", &north, &latitude, &east, &longitude) != 4)
        return {};
    north = static_cast<char>(north | 0x20);
    east = static_cast<char>(east | 0x20);
    if ((north != 'n' && north != 's') || (east != 'e' && east != 'w') || latitude > 90 || longitude > 180)
        return {};
    return std::array{east == 'w' ? -longitude : longitude, north == 's' ? -latitude : latitude};
}

class Hgt : public PictureReader {
  public:
    Hgt(const std::filesystem::path& path, std::optional<std::array<int, 2>> size)
        : path_(path), file_(open_file(path)) {
        const std::uintmax_t heights = std::filesystem::file_size(path) / 2;
        if (!size) {
            const auto side = static_cast<int>(std::lround(std::sqrt(heights)));
            size = heights == 1801u * 3601u ? std::array{1801, 3601} : std::array{side, side}; // north of 50
        }
        const auto [width, height] = *size;
        if (static_cast<std::uintmax_t>(width) * static_cast<std::uintmax_t>(height) != heights ||
            std::filesystem::file_size(path) % 2 != 0 || std::min(width, height) < 2)
            refuse_picture(path, fmt::format("it has {} bytes; expected a square of 16-bit heights, or the "
                                             "size of another rectangle",
                                             std::filesystem::file_size(path)));
        Format format{.width = width, .height = height, .channels = 1, .linear = true, .bits = 32};
        format.missing = hgt_void;
        if (const auto place = place_in(path.filename().string())) // the heights of both edges are included
            format.geo = degree_tags((*place)[0], (*place)[1] + 1, 1.0 / (width - 1), 1.0 / (height - 1));
        set_format(format);
        bytes_.resize(2 * static_cast<std::size_t>(width));
    }

    void read_row(std::span<float> row) override {
        if (std::fread(bytes_.data(), 1, bytes_.size(), file_.get()) != bytes_.size())
            refuse_picture(path_, "it ends early");
        fill(row, [at = bytes_.data()]() mutable {
            const auto word = in_order<std::uint16_t>(std::exchange(at, at + 2), std::endian::big);
            return static_cast<float>(static_cast<std::int16_t>(word));
        });
    }

  private:
    std::filesystem::path path_;
    File file_;
    std::vector<std::uint8_t> bytes_;
};

} // namespace

std::endian byte_order_of(const std::filesystem::path& path, int width, int height) {
    constexpr int most_rows = 64;
    const int step = std::max(1, height / most_rows);
    std::vector<float> row(static_cast<std::size_t>(width));
    // Differences of neighbours. Those of floats are relative, because in the wrong order exponents are as
    // random as low bits.
    const auto unevenness = [&](std::endian order) {
        Raw file(path, width, height, order);
        const bool floats = file.format().bits == 32;
        double sum = 0;
        for (int y = 0; y < height; y += step) {
            file.go_to(y);
            file.read_row(row);
            for (std::size_t x = 1; x < row.size(); ++x) {
                const double one = row[x - 1], other = row[x];
                const double size = floats ? std::abs(one) + std::abs(other) : 1;
                if (one != other)
                    sum += std::isfinite(size) ? std::abs(one - other) / size : 1;
            }
        }
        return sum;
    };
    return unevenness(std::endian::big) < 0.5 * unevenness(std::endian::little) ? std::endian::big
                                                                                : std::endian::little;
}

std::unique_ptr<PictureReader> open_raw(const std::filesystem::path& path, int width, int height,
                                        std::endian order) {
    return std::make_unique<Raw>(path, width, height, order);
}

std::unique_ptr<PictureReader> open_hgt(const std::filesystem::path& path,
                                        std::optional<std::array<int, 2>> size) {
    return std::make_unique<Hgt>(path, size);
}

} // namespace gabor::image
