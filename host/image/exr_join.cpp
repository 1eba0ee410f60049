// Joins regions of a picture.

#include "image/exr.hpp"
#include "image/exr_context.hpp"
#include "image/exr_mosaic.hpp"
#include "image/exr_stream.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfVersion.h>
#include <ImfXdr.h>

#include <algorithm>
#include <vector>

namespace gabor::image {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t band_bytes = std::size_t{16} << 20;

// ---- Copying ----

int lines_per_block(const fs::path& path) {
    const ExrContext file(path);
    std::int32_t lines = 0;
    file.require(exr_get_scanlines_per_chunk(file, 0, &lines));
    return lines;
}

// Returns the compressed block that starts at row `y`.
void read_block(const ExrContext& file, int y, std::vector<char>& bytes) {
    exr_chunk_info_t block;
    file.require(exr_read_scanline_chunk_info(file, 0, y, &block));
    bytes.resize(block.packed_size);
    file.require(exr_read_chunk(file, 0, &block, bytes.data()));
}

// Writes what Imf::OutputFile would, with blocks copied unchanged: the header, the table of block offsets,
// then for each block its first row, its length and its bytes. (OpenEXR's C library would add an attribute.)
void copy_blocks(const ExrMosaic& mosaic, const Imf::Header& header, int lines, ExrStream& stream,
                 const std::function<void(std::uint64_t)>& advance) {
    using Imf::Xdr::write;
    write<Imf::StreamIO>(stream, Imf::MAGIC);
    write<Imf::StreamIO>(stream, Imf::EXR_VERSION);
    header.writeTo(stream);
    const std::uint64_t table = stream.tellp();
    const int rows = header.dataWindow().size().y + 1;
    std::vector<std::uint64_t> offsets(static_cast<std::size_t>((rows + lines - 1) / lines));
    const auto write_table = [&] {
        for (const std::uint64_t offset : offsets)
            write<Imf::StreamIO>(stream, offset);
    };
    write_table();

    std::vector<char> block;
    auto offset = offsets.begin();
    for (const ExrMosaic::Region& region : mosaic.regions()) {
        const ExrContext in(region.path);
        const Imath::Box2i& window = region.window;
        for (int y = window.min.y; y <= window.max.y; y += lines) {
            read_block(in, y, block);
            *offset++ = stream.tellp();
            write<Imf::StreamIO>(stream, y);
            write<Imf::StreamIO>(stream, static_cast<int>(block.size()));
            stream.write(block.data(), static_cast<int>(block.size()));
            advance(static_cast<std::uint64_t>(window.size().x + 1) *
                    static_cast<std::uint64_t>(std::min(lines, window.max.y - y + 1)));
        }
    }
    stream.seekp(table);
    write_table();
}

// ---- Row by row ----

void read_and_write(ExrMosaic& mosaic, const Imf::Header& header, ExrStream& stream,
                    const std::function<void(std::uint64_t)>& advance) {
    const Imath::Box2i& picture = header.dataWindow();
    std::vector<std::string> channels;
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i)
        channels.emplace_back(i.name());

    const auto width = static_cast<std::size_t>(picture.size().x) + 1;
    const std::size_t row_bytes = width * channels.size() * sizeof(float);
    const int most_rows = std::max(1, static_cast<int>(band_bytes / row_bytes));
    std::vector<float> band(static_cast<std::size_t>(most_rows) * width * channels.size());
    Imf::OutputFile out(stream, header);
    for (int y = picture.min.y; y <= picture.max.y; y += most_rows) {
        const int rows = std::min(most_rows, picture.max.y - y + 1);
        Imf::FrameBuffer frame;
        for (std::size_t c = 0; c < channels.size(); ++c)
            frame.insert(channels[c],
                         Imf::Slice::Make(Imf::FLOAT, band.data() + c * width, {picture.min.x, y},
                                          static_cast<std::int64_t>(width), rows, sizeof(float), row_bytes));
        mosaic.read(frame, y, y + rows - 1);
        out.setFrameBuffer(frame);
        out.writePixels(rows);
        advance(static_cast<std::uint64_t>(rows) * width);
    }
}

} // namespace

Rect join_exr(std::span<const fs::path> paths, const fs::path& output,
              const std::function<void(std::uint64_t)>& advance) {
    ExrMosaic mosaic(paths);
    Imf::Header header = mosaic.header();
    header.zipCompressionLevel() = exr_zip_level;
    const Imath::Box2i& picture = header.dataWindow();
    const int lines = lines_per_block(paths.front());
    const bool blocks_match = std::ranges::all_of(mosaic.regions(), [&](const ExrMosaic::Region& region) {
        return region.window.min.x == picture.min.x && region.window.max.x == picture.max.x &&
               (region.window.min.y - picture.min.y) % lines == 0;
    });
    OutputFile file(not_a_pipe(output));
    ExrStream stream(file);
    if (blocks_match)
        copy_blocks(mosaic, header, lines, stream, advance);
    else
        read_and_write(mosaic, header, stream, advance);
    stream.rethrow_failure();
    file.commit();
    return to_rect(picture);
}

} // namespace gabor::image
