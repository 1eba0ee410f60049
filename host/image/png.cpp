#include "image/png.hpp"

#include "image/deflater.hpp"
#include "image/metadata.hpp"
#include "image/output_file.hpp"
#include "image/picture.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace gabor::image {

// The state of libpng while it reads or writes a file, and its last error.
struct Libpng {
    explicit Libpng(bool to_read)
        : reads(to_read), png((reads ? png_create_read_struct : png_create_write_struct)(
                              PNG_LIBPNG_VER_STRING, this, on_error, [](png_structp, png_const_charp) {})),
          info(png_create_info_struct(png)) {
        if (!info)
            throw std::bad_alloc();
    }
    ~Libpng() {
        reads ? png_destroy_read_struct(&png, &info, nullptr) : png_destroy_write_struct(&png, &info);
    }
    Libpng(const Libpng&) = delete;
    Libpng& operator=(const Libpng&) = delete;

    // Runs `calls` and returns whether libpng reported no error. libpng reports errors by a longjmp to here,
    // so `calls` must not own objects with destructors.
    template <class Calls>
    [[nodiscard]] bool succeeds(Calls calls) {
        if (setjmp(png_jmpbuf(png)) != 0)
            return false;
        calls();
        return true;
    }
    static void on_error(png_structp png, png_const_charp text) {
        static_cast<Libpng*>(png_get_error_ptr(png))->message = text;
        png_longjmp(png, 1);
    }

    bool reads;
    png_structp png;
    png_infop info;
    std::string message;
};

namespace {

constexpr png_uint_32 widest_png = 65536;
constexpr png_byte filter_up = 2;
constexpr std::size_t alike = std::size_t{1} << 14; // bytes to compress at a time
constexpr std::size_t chunk = std::size_t{1} << 16; // bytes of an IDAT chunk, or a few more
// The largest interlaced picture to read, in bytes: all of its rows are kept in memory.
constexpr std::size_t most_interlaced = std::size_t{1} << 28;

class PngPicture : public PictureReader {
  public:
    PngPicture(const std::filesystem::path& path, File file) : path_(path), file_(std::move(file)) {
        const png_structp png = libpng_.png;
        const png_infop info = libpng_.info;
        // libpng converts every format to 16-bit grey or RGB, with alpha if the file has it.
        Format format;
        guarded([&] {
            png_set_user_limits(png, widest_png, widest_png);
            png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT); // a damaged tRNS changes pixels
            png_init_io(png, file_.get());
            png_read_info(png, info);
            format.alpha = (png_get_color_type(png, info) & PNG_COLOR_MASK_ALPHA) != 0 ||
                           png_get_valid(png, info, PNG_INFO_tRNS) != 0;
            interlaced_ = png_get_interlace_type(png, info) != PNG_INTERLACE_NONE;
            format.bits = png_get_bit_depth(png, info);
            png_set_expand_16(png);
            png_set_interlace_handling(png);
            png_read_update_info(png, info);
        });
        format.width = static_cast<int>(png_get_image_width(png, info));
        format.height = static_cast<int>(png_get_image_height(png, info));
        format.channels = png_get_channels(png, info) - (format.alpha ? 1 : 0);
        png_bytep bytes = nullptr;
        png_uint_32 size = 0;
        if (png_get_eXIf_1(png, info, &size, &bytes) != 0)
            format.orientation = exif_orientation({bytes, size});
        png_charp name = nullptr;
        int compression = 0;
        if (png_get_iCCP(png, info, &name, &compression, &bytes, &size) != 0)
            format.profile = foreign_profile({bytes, size});
        set_format(format);
        row_bytes_ = png_get_rowbytes(png, info);
        bytes_.resize(row_bytes_);
        if (!interlaced_)
            return;
        const std::size_t all = row_bytes_ * static_cast<std::size_t>(format.height);
        if (all > most_interlaced)
            refuse_picture(path_,
                           fmt::format("it is interlaced and larger than {} MiB: save it without interlacing",
                                       most_interlaced >> 20));
        bytes_.resize(all);
        std::vector<png_bytep> rows;
        for (std::size_t at = 0; at < all; at += row_bytes_)
            rows.push_back(&bytes_[at]);
        guarded([&] { png_read_image(png, rows.data()); });
    }

    void read_row(std::span<float> row) override {
        const png_byte* at = bytes_.data() + next_;
        if (interlaced_)
            next_ += row_bytes_;
        else
            guarded([this] { png_read_row(libpng_.png, bytes_.data(), nullptr); });
        fill(row, [&at] {
            const int value = 256 * at[0] + at[1];
            at += 2;
            return static_cast<float>(value) / 65535.0f;
        });
    }

  private:
    template <class Calls>
    void guarded(Calls calls) {
        if (!libpng_.succeeds(calls))
            refuse_picture(path_, libpng_.message);
    }

    std::filesystem::path path_;
    File file_;
    Libpng libpng_{true};
    bool interlaced_ = false;
    std::size_t row_bytes_ = 0;
    std::vector<png_byte> bytes_; // one row, or all rows of an interlaced picture
    std::size_t next_ = 0;        // the byte at which the next row of an interlaced picture begins
};

} // namespace

std::unique_ptr<PictureReader> open_png(const std::filesystem::path& path, File file) {
    return std::make_unique<PngPicture>(path, std::move(file));
}

std::uint32_t quantize(float value, int bits) {
    const float clamped = value > 0.0f ? std::min(value, 1.0f) : 0.0f; // NaN becomes 0
    return static_cast<std::uint32_t>(
        static_cast<int>(clamped * static_cast<float>((1 << bits) - 1) + 0.5f)); // int: vectors have no other
}

struct PngWriter::State : Libpng {
    State(const std::filesystem::path& path, int width, int height, int channels, int bits_)
        : Libpng(false), file(path),
          values(static_cast<std::size_t>(width) * static_cast<std::size_t>(channels)), bits(bits_),
          row(values * static_cast<std::size_t>(bits / 8)), above(row.size()), rows_left(height) {}

    template <class Calls>
    void guarded(Calls calls) {
        if (succeeds(calls))
            return;
        if (failure)
            std::rethrow_exception(failure);
        throw std::runtime_error(fmt::format("cannot write {}: {}", file.path().string(), message));
    }
    static void on_write(png_structp png, png_bytep bytes, std::size_t count);
    void add_row();
    void write_chunk(const char* name, std::span<const png_byte> bytes);

    OutputFile file;
    std::size_t values; ///< number of values in a row
    int bits;
    std::vector<png_byte> row;
    std::vector<png_byte> above;    ///< the row before
    std::vector<png_byte> filtered; ///< not compressed yet
    Deflater deflater;
    int rows_left;
    std::exception_ptr failure; ///< what OutputFile::write threw, if anything
};

void PngWriter::State::on_write(png_structp png, png_bytep bytes, std::size_t count) {
    auto& state = *static_cast<State*>(png_get_io_ptr(png));
    try {
        state.file.write(std::as_bytes(std::span(bytes, count)));
        return;
    } catch (...) {
        state.failure = std::current_exception();
    }
    // png_error is called outside the handler, because its longjmp would skip the exception's destructor.
    png_error(png, "the file cannot be written");
}

void PngWriter::State::write_chunk(const char* name, std::span<const png_byte> bytes) {
    guarded(
        [&] { png_write_chunk(png, reinterpret_cast<png_const_bytep>(name), bytes.data(), bytes.size()); });
}

// Filters the row and, once there are enough bytes, compresses and writes them.
void PngWriter::State::add_row() {
    filtered.push_back(filter_up);
    filtered.resize(filtered.size() + row.size());
    std::ranges::transform(row, above, filtered.end() - static_cast<std::ptrdiff_t>(row.size()),
                           [](png_byte here, png_byte over) { return static_cast<png_byte>(here - over); });
    std::swap(row, above);
    const bool last = --rows_left == 0;
    if (last || filtered.size() >= alike) {
        deflater.write(filtered);
        filtered.clear();
    }
    if (last)
        deflater.finish();
    if (last || deflater.output().size() >= chunk) {
        write_chunk("IDAT", deflater.output());
        deflater.output().clear();
    }
}

PngWriter::PngWriter(const std::filesystem::path& path, int width, int height, int channels, int bits)
    : state_(std::make_unique<State>(path, width, height, channels, bits)) {
    const png_structp png = state_->png;
    const png_infop info = state_->info;
    State* const state = state_.get();
    state_->guarded([=] {
        png_set_write_fn(png, state, State::on_write, [](png_structp) {});
        png_set_user_limits(png, widest_png, widest_png);
        png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), bits,
                     channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_write_info(png, info);
    });
}

PngWriter::~PngWriter() = default;
PngWriter::PngWriter(PngWriter&&) noexcept = default;

void PngWriter::write_rows(std::span<const float> values) {
    std::vector<png_byte>& row = state_->row;
    const int bits = state_->bits;
    const std::size_t rows = values.size() / state_->values;
    if (values.size() % state_->values != 0 || rows > static_cast<std::size_t>(state_->rows_left))
        throw std::logic_error("PngWriter::write_rows takes whole rows and no more than the picture has");
    for (; !values.empty(); values = values.subspan(state_->values)) {
        const std::size_t count = state_->values;
        png_byte* const bytes = row.data();
        for (std::size_t i = 0; bits == 8 && i < count; ++i)
            bytes[i] = static_cast<png_byte>(quantize(values[i], 8));
        for (std::size_t i = 0; bits == 16 && i < count; ++i) {
            const std::uint32_t level = quantize(values[i], 16);
            bytes[2 * i] = static_cast<png_byte>(level >> 8);
            bytes[2 * i + 1] = static_cast<png_byte>(level);
        }
        state_->add_row();
    }
}

void PngWriter::commit() {
    if (state_->rows_left != 0)
        throw std::logic_error("PngWriter::commit called before the last row");
    state_->write_chunk("IEND", {});
    state_->file.commit();
}

} // namespace gabor::image
