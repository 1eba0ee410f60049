// Joins regions of a picture.

#include "image/exr_inspection.hpp"
#include "image/exr_parts.hpp"

#include <ImfInputFile.h>
#include <ImfVersion.h>
#include <ImfXdr.h>

#include <algorithm>

namespace gabor::image {

namespace {

using Advance = std::function<void(std::uint64_t)>;

constexpr std::size_t band_bytes = std::size_t{16} << 20;

int rows_per_block(std::string_view compression) {
    return compression == "zip" ? 16 : compression == "piz" ? 32 : 1;
}

// Writes what Imf::OutputFile would, with blocks copied unchanged: the header, the table of block offsets,
// then for each block its first row, its length and its bytes.
void copy_blocks(const ExrReader& reader, const Imf::Header& header, int rows, ExrStream& stream,
                 const Advance& advance) {
    using Imf::Xdr::write;
    write<Imf::StreamIO>(stream, Imf::MAGIC);
    write<Imf::StreamIO>(stream, Imf::EXR_VERSION);
    header.writeTo(stream);
    const std::uint64_t table = stream.tellp();
    std::vector<std::uint64_t> offsets(static_cast<std::size_t>((reader.picture().height + rows - 1) / rows));
    const auto write_table = [&] {
        for (const std::uint64_t offset : offsets)
            write<Imf::StreamIO>(stream, offset);
    };
    write_table();
    auto offset = offsets.begin();
    for (const auto& [path, window] : reader.regions()) {
        Imf::InputFile in(path.c_str(), 0);
        for (int y = window.y; y < window.y + window.height; y += rows) {
            const char* bytes = nullptr;
            int count = 0;
            in.rawPixelData(y, bytes, count);
            *offset++ = stream.tellp();
            write<Imf::StreamIO>(stream, y);
            write<Imf::StreamIO>(stream, count);
            stream.write(bytes, count);
            advance(static_cast<std::uint64_t>(window.width) *
                    static_cast<std::uint64_t>(std::min(rows, window.y + window.height - y)));
        }
    }
    stream.seekp(table);
    write_table();
}

} // namespace

Rect join_exr(std::span<const std::filesystem::path> paths, const std::filesystem::path& output,
              const Advance& advance) {
    ExrReader reader(paths);
    const Rect picture = reader.picture();
    const ExrWriter::Description description{.picture = picture,
                                             .window = picture,
                                             .channels = reader.channels(),
                                             .compression = reader.compression(),
                                             .parameters = reader.parameters(),
                                             .software = reader.software(),
                                             .colour_space = reader.colour_space()};
    const int block = rows_per_block(reader.compression());
    const auto regions = reader.regions();
    if (std::ranges::all_of(regions, [&](const auto& region) {
            const Rect& window = region.second;
            return window.width == picture.width && (window.y - picture.y) % block == 0;
        })) {
        OutputFile file(not_a_pipe(output));
        ExrStream stream(file);
        copy_blocks(reader, exr_header(description), block, stream, advance);
        file.commit();
        return picture;
    }
    const std::size_t channels = reader.channels().size();
    const std::size_t row_bytes = static_cast<std::size_t>(picture.width) * channels * sizeof(float);
    const int rows = std::max(1, static_cast<int>(band_bytes / row_bytes));
    ExrWriter writer(output, description);
    for (auto band = reader.read_rows(rows); !band.empty(); band = reader.read_rows(rows)) {
        writer.write_rows(band);
        advance(band.size() / channels);
    }
    writer.commit();
    return picture;
}

} // namespace gabor::image
