#include "image/exr.hpp"

#include "error.hpp"
#include "image/exr_stream.hpp"
#include "image/exr_threads.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace gabor::image {

namespace {

// Only lossless methods for 32-bit floats.
constexpr std::array<std::string_view, 5> names = {"none", "rle", "zips", "zip", "piz"};
constexpr std::array methods = {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION,
                                Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION};

} // namespace

Imf::Compression exr_compression(std::string_view name) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
        throw RequestError(
            fmt::format("unknown compression '{}'; accepted are {}", name, fmt::join(names, ", ")));
    return methods[static_cast<std::size_t>(found - names.begin())];
}

std::string_view exr_compression_name(Imf::Compression method) {
    const auto found = std::ranges::find(methods, method);
    return found == methods.end() ? "" : names[static_cast<std::size_t>(found - methods.begin())];
}

namespace {

Imath::Box2i box(const Rect& window) {
    return {{window.x, window.y}, {window.x + window.width - 1, window.y + window.height - 1}};
}

Imf::Header make_header(const ExrWriter::Description& description) {
    Imf::Header header(box(description.picture), box(description.window));
    header.compression() = exr_compression(description.compression);
    header.zipCompressionLevel() = exr_zip_level;
    for (const std::string& channel : description.channels)
        header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    header.insert("gabor", Imf::StringAttribute(description.parameters));
    if (!description.software.empty())
        header.insert("software", Imf::StringAttribute(description.software));
    if (!description.colour_space.empty())
        header.insert("oiio:ColorSpace", Imf::StringAttribute(description.colour_space));
    return header;
}

} // namespace

std::span<const std::string_view> compression_names() {
    return names;
}

struct ExrWriter::State {
    State(const std::filesystem::path& path, const Description& description, const Imf::Header& header)
        : window(description.window), channels(description.channels), file(not_a_pipe(path)), stream(file),
          image(std::in_place, stream, header) {}

    const Rect window;
    const std::vector<std::string> channels;
    int rows_written = 0;
    OutputFile file;
    ExrStream stream;
    std::optional<Imf::OutputFile> image;
};

ExrWriter::ExrWriter(const std::filesystem::path& path, const Description& description) {
    start_exr_threads();
    state_ = std::make_unique<State>(path, description, make_header(description));
}

ExrWriter::~ExrWriter() = default;
ExrWriter::ExrWriter(ExrWriter&&) noexcept = default;

void ExrWriter::write_rows(std::span<const float> pixels) {
    const Rect& window = state_->window;
    const std::size_t x_stride = state_->channels.size();
    const std::size_t y_stride = x_stride * static_cast<std::size_t>(window.width);
    const std::size_t rows = pixels.size() / y_stride;
    if (pixels.size() % y_stride != 0 ||
        rows > static_cast<std::size_t>(window.height - state_->rows_written))
        throw std::logic_error("ExrWriter::write_rows takes whole rows and no more than the window has");
    if (rows == 0)
        return;

    // OpenEXR compresses straight from `pixels`; the base pointer is shifted so that row `y` of the picture
    // is its first row.
    const int y = window.y + state_->rows_written;
    Imf::FrameBuffer band;
    for (std::size_t c = 0; c < x_stride; ++c)
        band.insert(state_->channels[c],
                    Imf::Slice::Make(Imf::FLOAT, pixels.data() + c, {window.x, y}, window.width,
                                     static_cast<std::int64_t>(rows), x_stride * sizeof(float),
                                     y_stride * sizeof(float)));
    state_->image->setFrameBuffer(band);
    state_->image->writePixels(static_cast<int>(rows));
    state_->rows_written += static_cast<int>(rows);
}

void ExrWriter::commit() {
    if (state_->rows_written != state_->window.height)
        throw std::logic_error("ExrWriter::commit before the last row");
    state_->image.reset();
    state_->stream.rethrow_failure();
    state_->file.commit();
}

} // namespace gabor::image
