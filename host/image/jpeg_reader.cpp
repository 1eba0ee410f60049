#include "image/metadata.hpp"

#include <fmt/format.h>

#include <csetjmp>
#include <string>
#include <vector>

#include <jpeglib.h> // must follow <cstdio>

#include <jerror.h>

namespace gabor::image {

namespace {

using namespace std::string_view_literals;

class JpegPicture : public PictureReader {
  public:
    JpegPicture(const std::filesystem::path& path, File file, std::span<const unsigned char> memory)
        : path_(path), file_(std::move(file)) {
        jpeg_.err = jpeg_std_error(&errors_);
        errors_.error_exit = on_error;
        errors_.emit_message = on_message;
        guarded([this, memory] {
            jpeg_create_decompress(&jpeg_);
            if (file_)
                jpeg_stdio_src(&jpeg_, file_.get());
            else
                jpeg_mem_src(&jpeg_, memory.data(), static_cast<unsigned long>(memory.size()));
            jpeg_save_markers(&jpeg_, JPEG_APP0 + 1, 0xffff);
            jpeg_save_markers(&jpeg_, JPEG_APP0 + 2, 0xffff);
            jpeg_read_header(&jpeg_, TRUE);
        });
        const int colours = jpeg_.num_components;
        if (colours != 1 && colours != 3)
            refuse_picture(path_, fmt::format("it has {} channels{}; only grey and RGB are supported",
                                              colours, colours == 4 ? ", CMYK" : ""));
        jpeg_.out_color_space = colours == 1 ? JCS_GRAYSCALE : JCS_RGB;
        guarded([this] { jpeg_start_decompress(&jpeg_); });
        Format format{static_cast<int>(jpeg_.output_width), static_cast<int>(jpeg_.output_height), colours};
        std::vector<std::uint8_t> icc; // may be in several parts
        for (auto marker = jpeg_.marker_list; marker; marker = marker->next) {
            const std::span<const std::uint8_t> data(marker->data, marker->data_length);
            const std::string_view text(reinterpret_cast<const char*>(marker->data), marker->data_length);
            if (text.starts_with("Exif\0\0"sv))
                format.orientation = exif_orientation(data.subspan(6));
            if (text.starts_with("ICC_PROFILE\0"sv) && data.size() > 14)
                icc.insert(icc.end(), data.begin() + 14, data.end());
        }
        if (!icc.empty())
            format.profile = foreign_profile(icc);
        set_format(format);
        bytes_.resize(std::size_t{jpeg_.output_width} * static_cast<std::size_t>(colours));
    }

    void read_row(std::span<float> row) override {
        guarded([this] {
            JSAMPROW into = bytes_.data();
            jpeg_read_scanlines(&jpeg_, &into, 1);
        });
        fill(row, [at = bytes_.data()]() mutable { return static_cast<float>(*at++) / 255.0f; });
    }

  private:
    struct Errors : jpeg_error_mgr {
        std::jmp_buf jump;
    };
    struct Decoder : jpeg_decompress_struct {
        ~Decoder() { jpeg_destroy_decompress(this); }
    };

    /// Runs `calls`. libjpeg reports errors and damaged data by a longjmp to here, so `calls` must not own
    /// objects with destructors.
    template <class Calls>
    void guarded(Calls calls) {
        if (setjmp(errors_.jump) == 0) {
            calls();
            return;
        }
        std::string text(JMSG_LENGTH_MAX, '\0');
        errors_.format_message(reinterpret_cast<j_common_ptr>(&jpeg_), text.data());
        refuse_picture(path_, text.c_str());
    }
    static void on_error(j_common_ptr jpeg) { std::longjmp(static_cast<Errors*>(jpeg->err)->jump, 1); }
    static void on_message(j_common_ptr jpeg, int level) {
        // A warning: the data is damaged, unless these are superfluous bytes before the first scan.
        if (level < 0 && (jpeg->err->msg_code != JWRN_EXTRANEOUS_DATA ||
                          reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number > 0))
            on_error(jpeg);
    }

    std::filesystem::path path_;
    File file_;
    Errors errors_{};
    Decoder jpeg_{};
    std::vector<JSAMPLE> bytes_;
};

} // namespace

std::unique_ptr<PictureReader> open_jpeg(const std::filesystem::path& path, File file) {
    return std::make_unique<JpegPicture>(path, std::move(file), std::span<const unsigned char>());
}

std::unique_ptr<PictureReader> open_jpeg(const std::filesystem::path& path,
                                         std::span<const unsigned char> memory) {
    return std::make_unique<JpegPicture>(path, File(nullptr, std::fclose), memory);
}

} // namespace gabor::image
