#include "image/metadata.hpp"
#include "image/picture.hpp"
#include "image/tiff_tags.hpp"

#include "system/number.hpp"

#include <fmt/format.h>
#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace gabor::image {

namespace {

constexpr std::uint32_t widest_tiff = 65536;
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 28; // of a row of tiles

// Returns the nearest finite float, so that a value beyond floats equals the one that stands for no height.
float to_float(double value) {
    constexpr double most = std::numeric_limits<float>::max();
    return static_cast<float>(std::isnan(value) ? value : std::clamp(value, -most, most));
}

std::optional<double> number_in(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(" +"), text.size()));
    double value = 0;
    const auto [end, error] = system::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() ? std::optional(value) : std::nullopt;
}

// The value of an item of the first band in GDAL's metadata, such as
//     <Item name="SCALE" sample="0" role="scale">0.1</Item>
std::string_view item(std::string_view metadata, std::string_view role) {
    const std::string attribute = fmt::format("role=\"{}\">", role);
    for (std::size_t at = metadata.find("<Item"); at != metadata.npos; at = metadata.find("<Item", at + 1)) {
        const std::string_view rest = metadata.substr(at, metadata.find("</Item>", at) - at);
        if (const std::size_t value = rest.find(attribute);
            value != rest.npos && rest.find("sample=\"0\"") < value)
            return rest.substr(value + attribute.size());
    }
    return {};
}

class TiffPicture : public PictureReader {
  public:
    explicit TiffPicture(const std::filesystem::path& path) : path_(path) {
        const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(TIFFOpenOptionsAlloc(),
                                                                                   TIFFOpenOptionsFree);
        TIFFOpenOptionsSetErrorHandlerExtR(options.get(), on_error, &error_);
        TIFFOpenOptionsSetWarningHandlerExtR(options.get(), on_warning, nullptr);
        tiff_.reset(TIFFOpenExt(path.string().c_str(), "rm", options.get())); // m: not mapped to memory
        require(tiff_ != nullptr);

        width_ = field<std::uint32_t>(TIFFTAG_IMAGEWIDTH);
        const auto height = field<std::uint32_t>(TIFFTAG_IMAGELENGTH);
        if (std::min(width_, height) < 1 || std::max(width_, height) > widest_tiff)
            refuse_picture(path_, fmt::format("it has {0} x {1} pixels; at most {2} x {2} are supported",
                                              width_, height, widest_tiff));
        Format format{.width = static_cast<int>(width_), .height = static_cast<int>(height)};
        read_values(format);
        read_place(format);
        const bool levels =
            type_ == SAMPLEFORMAT_UINT && bits_ <= 16 && (format.channels == 3 || !format.geo.exist());
        white_ = levels ? static_cast<double>((1u << bits_) - 1) : 1;
        format.bits = levels ? bits_ : 32;
        format.linear = type_ == SAMPLEFORMAT_IEEEFP;
        set_format(format);

        tile_width_ = width_;
        if (TIFFIsTiled(tiff_.get())) {
            tile_width_ = field<std::uint32_t>(TIFFTAG_TILEWIDTH);
            tile_height_ = field<std::uint32_t>(TIFFTAG_TILELENGTH);
        }
        const std::uint64_t across = (width_ + std::uint64_t{tile_width_} - 1) / tile_width_;
        if (tile_height_ > most_bytes / (across * tile_width_ * pixel_bytes()))
            refuse_picture(path_, fmt::format("a row of its tiles takes more than {} MiB", most_bytes >> 20));
        tiles_.resize(across * tile_bytes());
    }

    void read_row(std::span<float> row) override {
        if (row_ % tile_height_ == 0)
            read_tiles();
        if (type_ == SAMPLEFORMAT_IEEEFP)
            bits_ == 64 ? convert<double>(row) : convert<float>(row);
        else if (type_ == SAMPLEFORMAT_INT)
            bits_ == 8    ? convert<std::int8_t>(row)
            : bits_ == 16 ? convert<std::int16_t>(row)
                          : convert<std::int32_t>(row);
        else
            bits_ == 8    ? convert<std::uint8_t>(row)
            : bits_ == 16 ? convert<std::uint16_t>(row)
                          : convert<std::uint32_t>(row);
        ++row_;
    }

  private:
    static int on_error(TIFF*, void* error, const char*, const char* format, std::va_list values) {
        std::array<char, 256> text{};
        std::vsnprintf(text.data(), text.size(), format, values);
        std::ranges::replace(text, '\n', ' ');
        *static_cast<std::string*>(error) = text.data();
        return 1; // handled
    }
    static int on_warning(TIFF*, void*, const char*, const char*, std::va_list) { return 1; }

    void require(bool success) const {
        if (!success)
            refuse_picture(path_, "it is truncated or damaged" + (error_.empty() ? "" : " (" + error_ + ")"));
    }

    template <typename Value>
    Value field(std::uint32_t tag) const {
        Value value = 0;
        TIFFGetFieldDefaulted(tiff_.get(), tag, &value);
        return value;
    }

    // The values of a tag that libtiff does not know; empty without the tag, or if it has another type.
    template <typename Value>
    std::vector<Value> fields(std::uint32_t tag, TIFFDataType type) const {
        std::uint32_t count = 0;
        const Value* values = nullptr;
        if (TIFFFindField(tiff_.get(), tag, type))
            TIFFGetField(tiff_.get(), tag, &count, &values);
        return {values, values + count};
    }
    std::string text(std::uint32_t tag) const {
        const std::vector<char> letters = fields<char>(tag, TIFF_ASCII);
        return {letters.begin(), std::ranges::find(letters, '\0')};
    }

    // Reads what the values of a pixel are.
    void read_values(Format& format) {
        type_ = field<std::uint16_t>(TIFFTAG_SAMPLEFORMAT);
        bits_ = field<std::uint16_t>(TIFFTAG_BITSPERSAMPLE);
        values_ = field<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL);
        auto colours = field<std::uint16_t>(TIFFTAG_PHOTOMETRIC);
        if (colours == PHOTOMETRIC_YCBCR && field<std::uint16_t>(TIFFTAG_COMPRESSION) == COMPRESSION_JPEG) {
            TIFFSetField(tiff_.get(), TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
            colours = PHOTOMETRIC_RGB;
        }
        format.channels = colours == PHOTOMETRIC_RGB ? 3 : 1;
        std::uint16_t extra = 0;
        const std::uint16_t* kinds = nullptr;
        TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_EXTRASAMPLES, &extra, &kinds);
        format.alpha = extra == 1 && kinds[0] != EXTRASAMPLE_UNSPECIFIED;
        premultiplied_ = format.alpha && kinds[0] == EXTRASAMPLE_ASSOCALPHA;
        const bool known_type = type_ == SAMPLEFORMAT_IEEEFP
                                    ? bits_ == 32 || bits_ == 64
                                    : (type_ == SAMPLEFORMAT_UINT || type_ == SAMPLEFORMAT_INT) &&
                                          (bits_ == 8 || bits_ == 16 || bits_ == 32);
        if (!known_type)
            refuse_picture(path_, fmt::format("it has {}-bit {}; expected a TIFF of 8-, 16- or 32-bit "
                                              "integers or 32- or 64-bit floats",
                                              bits_,
                                              type_ == SAMPLEFORMAT_IEEEFP ? "floats"
                                              : type_ <= SAMPLEFORMAT_INT  ? "integers"
                                                                           : "values of another type"));
        if (colours != PHOTOMETRIC_RGB && colours != PHOTOMETRIC_MINISBLACK)
            refuse_picture(path_, "its colours are neither grey, from black to white, nor RGB");
        if (values_ != format.channels + (format.alpha ? 1 : 0))
            refuse_picture(path_,
                           fmt::format("it has {} channels; expected a TIFF with one, or three of RGB, "
                                       "with or without alpha",
                                       values_));
        if (values_ > 1 && field<std::uint16_t>(TIFFTAG_PLANARCONFIG) != PLANARCONFIG_CONTIG)
            refuse_picture(path_, "its channels lie apart; expected a TIFF with interleaved channels");
        format.orientation = field<std::uint16_t>(TIFFTAG_ORIENTATION);
        if (format.orientation != ORIENTATION_TOPLEFT &&
            (format.orientation > ORIENTATION_LEFTBOT || type_ != SAMPLEFORMAT_UINT || bits_ > 16))
            refuse_picture(path_, "its first row is not at the top, or begins at the right; expected a TIFF "
                                  "from the upper left corner");
        std::uint32_t size = 0;
        const std::uint8_t* profile = nullptr;
        if (TIFFGetField(tiff_.get(), TIFFTAG_ICCPROFILE, &size, &profile))
            format.profile = foreign_profile({profile, size});
    }

    // Reads the tags of GeoTIFF and of GDAL.
    void read_place(Format& format) const {
        format.geo = {fields<double>(pixel_scale_tag, TIFF_DOUBLE),
                      fields<double>(tie_points_tag, TIFF_DOUBLE),
                      fields<double>(matrix_tag, TIFF_DOUBLE),
                      fields<std::uint16_t>(keys_tag, TIFF_SHORT),
                      fields<double>(numbers_tag, TIFF_DOUBLE),
                      text(text_tag),
                      {}};
        const std::string metadata = text(metadata_tag);
        format.geo.unit = item(metadata, "unittype");
        format.scale = number_in(item(metadata, "scale")).value_or(1);
        format.offset = number_in(item(metadata, "offset")).value_or(0);
        if (const auto missing = number_in(text(nodata_tag)))
            format.missing = to_float(*missing);
    }

    std::size_t pixel_bytes() const { return std::size_t{values_} * bits_ / 8; }
    std::size_t tile_bytes() const { return pixel_bytes() * tile_width_ * tile_height_; }

    // Reads the row of tiles that starts here; in strips, a row of pixels.
    void read_tiles() {
        std::byte* at = tiles_.data();
        if (!TIFFIsTiled(tiff_.get()))
            return require(TIFFReadScanline(tiff_.get(), at, row_) >= 0);
        for (std::uint32_t x = 0; at != tiles_.data() + tiles_.size(); x += tile_width_, at += tile_bytes())
            require(TIFFReadTile(tiff_.get(), at, x, row_, 0, 0) >= 0);
    }

    template <typename Value>
    void convert(std::span<float> row) {
        const std::size_t line = row_ % tile_height_ * tile_width_ * pixel_bytes();
        fill(row, [&, i = std::size_t{0}]() mutable {
            const std::size_t x = i / values_;
            Value value;
            std::memcpy(&value,
                        &tiles_[line + x / tile_width_ * tile_bytes() + x % tile_width_ * pixel_bytes() +
                                i % values_ * sizeof value],
                        sizeof value);
            ++i;
            return white_ == 1 ? to_float(static_cast<double>(value))
                               : static_cast<float>(value) / static_cast<float>(white_);
        });
        const auto channels = static_cast<std::size_t>(format().channels);
        for (std::size_t i = 0; premultiplied_ && i < row.size(); ++i)
            if (const float share = alpha()[i / channels]; share > 0)
                row[i] /= share;
    }

    std::filesystem::path path_;
    std::string error_; // libtiff's last message
    std::unique_ptr<TIFF, void (*)(TIFF*)> tiff_{nullptr, TIFFClose};
    std::uint16_t type_ = 0;
    std::uint16_t bits_ = 0;
    std::uint16_t values_ = 0; // of a pixel
    bool premultiplied_ = false;
    double white_ = 1; // the value that stands for 1
    std::uint32_t width_ = 0;
    std::uint32_t tile_width_ = 0;
    std::uint32_t tile_height_ = 1;
    std::vector<std::byte> tiles_; // a row of tiles
    std::uint32_t row_ = 0;        // the next
};

} // namespace

std::unique_ptr<PictureReader> open_tiff(const std::filesystem::path& path) {
    return std::make_unique<TiffPicture>(path);
}

} // namespace gabor::image
