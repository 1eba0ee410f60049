#include "image/tiff_writer.hpp"

#include "image/output_file.hpp"
#include "image/tiff_tags.hpp"

#include <fmt/format.h>
#include <tiffio.h>

#include <algorithm>
#include <array>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace gabor::image {

namespace {

constexpr std::uint32_t rows_of_a_strip = 64;

TIFFFieldInfo field_info(std::uint32_t tag, TIFFDataType type, const char* name) {
    const bool text = type == TIFF_ASCII;
    const short count = text ? short{TIFF_VARIABLE} : short{TIFF_VARIABLE2};
    return {tag,
            count,
            count,
            type,
            FIELD_CUSTOM,
            1,
            text ? std::uint8_t{0} : std::uint8_t{1},
            const_cast<char*>(name)};
}

} // namespace

struct TiffWriter::State {
    explicit State(const std::filesystem::path& path) : file(path) {
        tiff.reset(
            TIFFClientOpen(path.c_str(), "wl", this, nothing, write, seek, close, size, nullptr, nullptr));
        if (!tiff)
            fail();
    }

    [[noreturn]] void fail() const {
        if (failure)
            std::rethrow_exception(failure);
        throw std::runtime_error(fmt::format("cannot write {}: libtiff failed", file.path().string()));
    }
    void require(bool success) const {
        if (!success)
            fail();
    }

    // What libtiff calls; exceptions must not pass through it.
    static tmsize_t nothing(thandle_t, void*, tmsize_t) { return 0; }
    static tmsize_t write(thandle_t handle, void* bytes, tmsize_t count) {
        auto& state = *static_cast<State*>(handle);
        try {
            state.file.write(
                std::span(static_cast<const std::byte*>(bytes), static_cast<std::size_t>(count)));
        } catch (...) {
            state.failure = std::current_exception();
            return 0;
        }
        state.end = std::max(state.end, state.file.position());
        return count;
    }
    static toff_t seek(thandle_t handle, toff_t offset, int from) {
        auto& state = *static_cast<State*>(handle);
        const std::uint64_t base = from == SEEK_SET   ? 0
                                   : from == SEEK_CUR ? state.file.position()
                                                      : state.end;
        try {
            state.file.seek(base + offset);
        } catch (...) {
            state.failure = std::current_exception();
            return static_cast<toff_t>(-1);
        }
        return base + offset;
    }
    static int close(thandle_t) { return 0; }
    static toff_t size(thandle_t handle) { return static_cast<State*>(handle)->end; }

    OutputFile file;
    std::uint64_t end = 0;
    std::exception_ptr failure;                                        // what OutputFile threw, if anything
    std::unique_ptr<TIFF, void (*)(TIFF*)> tiff{nullptr, TIFFCleanup}; // writes nothing
    std::uint32_t width = 0;
    std::uint32_t row = 0; // the next
    std::vector<float> line;
};

TiffWriter::TiffWriter(const std::filesystem::path& path, int width, int height, const GeoTags& geo,
                       std::optional<float> missing, bool compressed)
    : state_(std::make_unique<State>(path)) {
    TIFF* const tiff = state_->tiff.get();
    state_->width = static_cast<std::uint32_t>(width);
    static const std::array fields{field_info(pixel_scale_tag, TIFF_DOUBLE, "ModelPixelScale"),
                                   field_info(tie_points_tag, TIFF_DOUBLE, "ModelTiepoint"),
                                   field_info(matrix_tag, TIFF_DOUBLE, "ModelTransformation"),
                                   field_info(keys_tag, TIFF_SHORT, "GeoKeyDirectory"),
                                   field_info(numbers_tag, TIFF_DOUBLE, "GeoDoubleParams"),
                                   field_info(text_tag, TIFF_ASCII, "GeoAsciiParams"),
                                   field_info(metadata_tag, TIFF_ASCII, "GDAL_METADATA"),
                                   field_info(nodata_tag, TIFF_ASCII, "GDAL_NODATA")};
    TIFFMergeFieldInfo(tiff, fields.data(), static_cast<std::uint32_t>(fields.size()));
    const auto set = [&](std::uint32_t tag, auto value) {
        state_->require(TIFFSetField(tiff, tag, value) == 1);
    };
    set(TIFFTAG_IMAGEWIDTH, state_->width);
    set(TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(height));
    set(TIFFTAG_SAMPLESPERPIXEL, 1);
    set(TIFFTAG_BITSPERSAMPLE, 32);
    set(TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
    set(TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    set(TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    set(TIFFTAG_ROWSPERSTRIP, rows_of_a_strip);
    set(TIFFTAG_COMPRESSION, compressed ? COMPRESSION_ADOBE_DEFLATE : COMPRESSION_NONE);
    if (compressed)
        set(TIFFTAG_PREDICTOR, PREDICTOR_FLOATINGPOINT);
    const auto set_all = [&](std::uint32_t tag, const auto& values) {
        if (!values.empty())
            state_->require(
                TIFFSetField(tiff, tag, static_cast<std::uint32_t>(values.size()), values.data()) == 1);
    };
    set_all(pixel_scale_tag, geo.pixel_scale);
    set_all(tie_points_tag, geo.tie_points);
    set_all(matrix_tag, geo.matrix);
    set_all(keys_tag, geo.keys);
    set_all(numbers_tag, geo.numbers);
    if (!geo.text.empty())
        set(text_tag, geo.text.c_str());
    if (!geo.unit.empty())
        set(metadata_tag, fmt::format("<GDALMetadata>\n  <Item name=\"UNITTYPE\" sample=\"0\" "
                                      "role=\"unittype\">{}</Item>\n</GDALMetadata>\n",
                                      geo.unit)
                              .c_str());
    if (missing)
        set(nodata_tag, fmt::format("{:.9g}", *missing).c_str());
}

TiffWriter::~TiffWriter() = default;
TiffWriter::TiffWriter(TiffWriter&&) noexcept = default;

void TiffWriter::write_rows(std::span<const float> values) {
    State& s = *state_;
    for (; !values.empty(); values = values.subspan(s.width)) {
        s.line.assign(values.begin(), values.begin() + s.width); // libtiff changes it
        s.require(TIFFWriteScanline(s.tiff.get(), s.line.data(), s.row++) == 1);
    }
}

void TiffWriter::commit() {
    state_->require(TIFFFlush(state_->tiff.get()) == 1);
    state_->file.commit();
}

} // namespace gabor::image
