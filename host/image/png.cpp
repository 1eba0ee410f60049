#include "image/png.hpp"

#include "image/libpng.hpp"
#include "image/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <stdexcept>
#include <vector>

namespace gabor::image {

namespace {

// On noise, higher levels take up to four times as long and save next to nothing.
constexpr int compression_level = 1;
constexpr int filter = PNG_FILTER_UP;

std::uint32_t quantize(float value, int bits) {
    const float clamped = value > 0.0f ? std::min(value, 1.0f) : 0.0f; // NaN becomes 0
    return static_cast<std::uint32_t>(clamped * static_cast<float>((1 << bits) - 1) + 0.5f);
}

} // namespace

struct PngWriter::State {
    State(const std::filesystem::path& path, int width, int height, int channels, int bits);
    ~State() { png_destroy_write_struct(&png, &info); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    template <class Calls>
    void guarded(Calls calls) {
        if (!succeeds(png, calls))
            rethrow();
    }
    [[noreturn]] void rethrow() const;

    static void on_write(png_structp png, png_bytep bytes, std::size_t count);

    OutputFile file;
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::size_t values; ///< number of values in a row
    int bits;
    std::vector<png_byte> row;
    int rows_left;
    PngErrors errors;           ///< libpng's errors
    std::exception_ptr failure; ///< the disk's error, if any
};

PngWriter::State::State(const std::filesystem::path& path, int width, int height, int channels, int bits_)
    : file(path), values(static_cast<std::size_t>(width) * static_cast<std::size_t>(channels)), bits(bits_),
      row(values * static_cast<std::size_t>(bits / 8)), rows_left(height) {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &errors, PngErrors::on_error, PngErrors::on_warning);
    info = png ? png_create_info_struct(png) : nullptr;
}

void PngWriter::State::rethrow() const {
    if (failure)
        std::rethrow_exception(failure);
    throw std::runtime_error(fmt::format("cannot write {}: {}", file.path().string(), errors.message));
}

void PngWriter::State::on_write(png_structp png, png_bytep bytes, std::size_t count) {
    auto& state = *static_cast<State*>(png_get_io_ptr(png));
    try {
        state.file.write(std::as_bytes(std::span(bytes, count)));
        return;
    } catch (...) {
        state.failure = std::current_exception();
    }
    png_error(png, "the file cannot be written"); // after the handler, because it jumps over destructors
}

PngWriter::PngWriter(const std::filesystem::path& path, int width, int height, int channels, int bits) {
    if (width < 1 || height < 1 || (channels != 1 && channels != 3) || (bits != 8 && bits != 16))
        throw std::logic_error(
            "PngWriter takes non-empty pictures with one or three channels of 8 or 16 bits");
    state_ = std::make_unique<State>(path, width, height, channels, bits);
    if (!state_->info)
        throw std::bad_alloc();
    const png_structp png = state_->png;
    const png_infop info = state_->info;
    State* const state = state_.get();
    state_->guarded([=] {
        png_set_write_fn(png, state, State::on_write, [](png_structp) {});
        png_set_user_limits(png, widest_png, widest_png);
        png_set_compression_level(png, compression_level);
        png_set_filter(png, PNG_FILTER_TYPE_BASE, filter);
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
    const std::size_t rows = values.size() / state_->values;
    if (values.size() % state_->values != 0 || rows > static_cast<std::size_t>(state_->rows_left))
        throw std::logic_error("PngWriter::write_rows takes whole rows and no more than the picture has");
    for (; !values.empty(); values = values.subspan(state_->values)) {
        auto byte = row.begin();
        for (const float value : values.first(state_->values)) {
            const std::uint32_t level = quantize(value, state_->bits);
            if (state_->bits == 16)
                *byte++ = static_cast<png_byte>(level >> 8);
            *byte++ = static_cast<png_byte>(level);
        }
        state_->guarded([&] { png_write_row(state_->png, row.data()); });
        --state_->rows_left;
    }
}

void PngWriter::commit() {
    if (state_->rows_left != 0)
        throw std::logic_error("PngWriter::commit before the last row");
    state_->guarded([&] { png_write_end(state_->png, state_->info); });
    state_->file.commit();
}

} // namespace gabor::image
