#include "image/picture.hpp"

#include "system/number.hpp"

#include <fmt/format.h>
#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace gabor::image {

namespace {

constexpr std::uint32_t widest_tiff = 65536;
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 28; // of a row of tiles
// Tags and values of GeoTIFF and GDAL.
constexpr std::uint32_t pixel_scale_tag = 33550, geo_keys_tag = 34735, nodata_tag = 42113;
constexpr std::uint16_t model_type_key = 1024, geographic = 2;

class TiffPicture : public PictureReader {
  public:
    explicit TiffPicture(const std::filesystem::path& path) : path_(path) {
        const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(TIFFOpenOptionsAlloc(),
                                                                                   TIFFOpenOptionsFree);
        TIFFOpenOptionsSetErrorHandlerExtR(options.get(), on_error, &error_);
        TIFFOpenOptionsSetWarningHandlerExtR(options.get(), on_warning, nullptr);
        tiff_.reset(TIFFOpenExt(path.string().c_str(), "rm", options.get())); // m: not mapped to memory
        require(tiff_ != nullptr);

        const auto width = field<std::uint32_t>(TIFFTAG_IMAGEWIDTH);
        const auto height = field<std::uint32_t>(TIFFTAG_IMAGELENGTH);
        if (std::min(width, height) < 1 || std::max(width, height) > widest_tiff)
            refuse_picture(path_, fmt::format("it has {0} x {1} pixels; at most {2} x {2} are supported",
                                              width, height, widest_tiff));
        type_ = field<std::uint16_t>(TIFFTAG_SAMPLEFORMAT);
        bits_ = field<std::uint16_t>(TIFFTAG_BITSPERSAMPLE);
        channels_ = field<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL);
        const bool colour = channels_ == 3;
        if ((channels_ != 1 && !colour) || !has_known_type() ||
            field<std::uint16_t>(TIFFTAG_PHOTOMETRIC) !=
                (colour ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK) ||
            field<std::uint16_t>(TIFFTAG_PLANARCONFIG) != PLANARCONFIG_CONTIG ||
            field<std::uint16_t>(TIFFTAG_ORIENTATION) != ORIENTATION_TOPLEFT)
            refuse_picture(path_,
                           "expected a TIFF with one channel, from black to white, or with interleaved red, "
                           "green and blue, of 8-bit or 16-bit integers or 32-bit floats, from the upper "
                           "left corner");

        const auto pixel = fields<double>(pixel_scale_tag, TIFF_DOUBLE);
        levels_ = type_ == SAMPLEFORMAT_UINT && pixel.empty();
        Format format{static_cast<int>(width),      static_cast<int>(height), channels_, false,
                      type_ == SAMPLEFORMAT_IEEEFP, levels_ ? bits_ : 32};
        if (!pixel.empty() && pixel[0] > 0 && !in_degrees())
            format.extent = pixel[0] * width;
        const auto nodata = fields<char>(nodata_tag, TIFF_ASCII);
        float missing = 0;
        if (system::from_chars(nodata.data(), nodata.data() + nodata.size(), missing).ec == std::errc())
            format.missing = missing;
        set_format(format);

        tile_width_ = width;
        if (TIFFIsTiled(tiff_.get())) {
            tile_width_ = field<std::uint32_t>(TIFFTAG_TILEWIDTH);
            tile_height_ = field<std::uint32_t>(TIFFTAG_TILELENGTH);
        }
        const std::uint64_t across = (width + std::uint64_t{tile_width_} - 1) / tile_width_;
        if (tile_height_ > most_bytes / (across * tile_width_ * pixel_bytes()))
            refuse_picture(path_, fmt::format("a row of its tiles takes more than {} MiB", most_bytes >> 20));
        tiles_.resize(across * tile_bytes());
    }

    void read_row(std::span<float> row) override {
        if (row_ % tile_height_ == 0)
            read_tiles();
        if (type_ == SAMPLEFORMAT_IEEEFP)
            convert<float>(row, 1);
        else if (type_ == SAMPLEFORMAT_INT)
            convert<std::int16_t>(row, 1);
        else if (bits_ == 8)
            convert<std::uint8_t>(row, levels_ ? 255 : 1);
        else
            convert<std::uint16_t>(row, levels_ ? 65535 : 1);
        ++row_;
    }

  private:
    static int on_error(TIFF*, void* error, const char*, const char* format, std::va_list values) {
        std::array<char, 256> text{};
        std::vsnprintf(text.data(), text.size(), format, values);
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
    std::span<const Value> fields(std::uint32_t tag, TIFFDataType type) const {
        std::uint32_t count = 0;
        const Value* values = nullptr;
        if (TIFFFindField(tiff_.get(), tag, type))
            TIFFGetField(tiff_.get(), tag, &count, &values);
        return {values, count};
    }

    // Whether a GeoTIFF measures its pixels in degrees. A key is four numbers, the last of which is its
    // value.
    bool in_degrees() const {
        const auto keys = fields<std::uint16_t>(geo_keys_tag, TIFF_SHORT);
        for (std::size_t i = 4; i + 3 < keys.size(); i += 4)
            if (keys[i] == model_type_key)
                return keys[i + 3] == geographic;
        return false;
    }

    bool has_known_type() const {
        switch (type_) {
        case SAMPLEFORMAT_UINT:
            return bits_ == 8 || bits_ == 16;
        case SAMPLEFORMAT_INT:
            return bits_ == 16;
        default:
            return type_ == SAMPLEFORMAT_IEEEFP && bits_ == 32;
        }
    }

    std::size_t pixel_bytes() const { return static_cast<std::size_t>(channels_ * bits_ / 8); }
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
    void convert(std::span<float> row, float white) {
        const std::size_t across = tile_width_ * static_cast<std::size_t>(channels_); // values
        const std::byte* line = &tiles_[row_ % tile_height_ * across * sizeof(Value)];
        fill(row, [&, i = std::size_t{0}]() mutable {
            Value value;
            std::memcpy(&value, line + i / across * tile_bytes() + i % across * sizeof value, sizeof value);
            ++i;
            return static_cast<float>(value) / white;
        });
    }

    std::filesystem::path path_;
    std::string error_; // libtiff's last message
    std::unique_ptr<TIFF, void (*)(TIFF*)> tiff_{nullptr, TIFFClose};
    std::uint16_t type_ = 0;
    std::uint16_t bits_ = 0; // of a value
    std::uint16_t channels_ = 0;
    bool levels_ = false; // whether values stand for 0 to 1
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
