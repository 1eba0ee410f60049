#include "image/exr_parts.hpp"

#include <ImfInputFile.h>
#include <ImfVersion.h>
#include <ImfXdr.h>

#include <algorithm>

namespace gabor::image {

namespace {

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
    std::vector<std::uint64_t> offsets(
        static_cast<std::size_t>((reader.header().picture.height + rows - 1) / rows));
    const auto write_table = [&] {
        for (const std::uint64_t offset : offsets)
            write<Imf::StreamIO>(stream, offset);
    };
    write_table();
    auto offset = offsets.begin();
    for (const auto& [path, window] : reader.regions()) {
        Imf::InputFile in(path.c_str(), 0);
        const int end = window.y + window.height;
        for (int y = window.y; y < end; y += rows) {
            const char* bytes = nullptr;
            int count = 0;
            in.rawPixelData(y, bytes, count);
            *offset++ = stream.tellp();
            write<Imf::StreamIO>(stream, y);
            write<Imf::StreamIO>(stream, count);
            stream.write(bytes, count);
            advance(Rect{0, y, window.width, std::min(rows, end - y)}.pixels());
        }
    }
    stream.seekp(table);
    write_table();
}

} // namespace

Rect join_exr(std::span<const std::filesystem::path> paths, const std::filesystem::path& output,
              const Advance& advance) {
    ExrReader reader(paths);
    const ExrHeader& header = reader.header();
    const int block = rows_per_block(header.compression);
    const auto regions = reader.regions();
    if (std::ranges::all_of(regions, [&](const auto& region) {
            const Rect& window = region.second;
            return window.width == header.picture.width && (window.y - header.picture.y) % block == 0;
        })) {
        OutputFile file(not_a_pipe(output));
        ExrStream stream(file);
        copy_blocks(reader, exr_header(header), block, stream, advance);
        file.commit();
        return header.picture;
    }
    ExrWriter writer(output, header);
    reader.read_bands([&](std::span<const float> band) {
        writer.write_rows(band);
        advance(band.size() / header.channels.size());
    });
    writer.commit();
    return header.picture;
}

} // namespace gabor::image
