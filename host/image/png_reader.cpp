#include "image/libpng.hpp"
#include "image/picture.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <new>
#include <string>
#include <vector>

namespace gabor::image {

namespace {

constexpr std::size_t most_interlaced = std::size_t{1}
                                        << 28; ///< limit in bytes: interlaced pictures are decoded in memory

class PngPicture : public PictureReader {
  public:
    explicit PngPicture(const std::filesystem::path& path);
    ~PngPicture() override { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngPicture(const PngPicture&) = delete;
    PngPicture& operator=(const PngPicture&) = delete;

    void read_row(std::span<float> row) override;

  private:
    template <class Calls>
    void guarded(Calls calls) {
        if (!succeeds(png_, calls))
            refuse_picture(path_, errors_.message);
    }
    void read_header();
    void read_interlaced();

    std::filesystem::path path_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    PngErrors errors_;
    bool interlaced_ = false;
    std::vector<png_byte> bytes_; ///< one row, or all rows of an interlaced picture
    std::size_t row_ = 0;
};

PngPicture::PngPicture(const std::filesystem::path& path)
    : path_(path), file_(std::fopen(path.c_str(), "rb"), std::fclose) {
    if (!file_)
        refuse_picture(path_, "it cannot be opened");
    png_ =
        png_create_read_struct(PNG_LIBPNG_VER_STRING, &errors_, PngErrors::on_error, PngErrors::on_warning);
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
    if (!info_) {
        png_destroy_read_struct(&png_, nullptr, nullptr);
        throw std::bad_alloc();
    }
    try {
        read_header();
        const std::size_t row = png_get_rowbytes(png_, info_);
        const std::size_t all = row * static_cast<std::size_t>(format_.height);
        if (interlaced_ && all > most_interlaced)
            refuse_picture(path_,
                           fmt::format("it is interlaced and larger than {} MiB: save it without interlacing",
                                       most_interlaced >> 20));
        bytes_.resize(interlaced_ ? all : row);
        if (interlaced_)
            read_interlaced();
    } catch (...) {
        png_destroy_read_struct(&png_, &info_, nullptr);
        throw;
    }
}

// Reads the header and lets libpng convert every format to 16-bit grey or RGB, with alpha if the file has it.
void PngPicture::read_header() {
    guarded([this] {
        png_set_user_limits(png_, widest_png, widest_png);
        png_init_io(png_, file_.get());
        png_read_info(png_, info_);
        const int type = png_get_color_type(png_, info_);
        format_.alpha = (type & PNG_COLOR_MASK_ALPHA) != 0 || png_get_valid(png_, info_, PNG_INFO_tRNS) != 0;
        interlaced_ = png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE;
        png_set_expand_16(png_);
        png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
    });
    format_.width = static_cast<int>(png_get_image_width(png_, info_));
    format_.height = static_cast<int>(png_get_image_height(png_, info_));
    format_.channels = png_get_channels(png_, info_) - (format_.alpha ? 1 : 0);
    alpha_.resize(format_.alpha ? static_cast<std::size_t>(format_.width) : 0);
}

void PngPicture::read_interlaced() {
    const std::size_t row = png_get_rowbytes(png_, info_);
    std::vector<png_bytep> rows;
    for (std::size_t at = 0; at < bytes_.size(); at += row)
        rows.push_back(&bytes_[at]);
    png_bytepp begin = rows.data();
    guarded([this, begin] { png_read_image(png_, begin); });
}

void PngPicture::read_row(std::span<float> row) {
    const png_byte* at = bytes_.data();
    if (interlaced_)
        at += row_ * 2 * (row.size() + alpha_.size());
    else
        guarded([this] { png_read_row(png_, bytes_.data(), nullptr); });
    ++row_;
    fill(row, [&at] {
        const int value = 256 * at[0] + at[1];
        at += 2;
        return static_cast<float>(value) / 65535.0f;
    });
}

} // namespace

std::unique_ptr<PictureReader> open_png(const std::filesystem::path& path) {
    return std::make_unique<PngPicture>(path);
}

} // namespace gabor::image
