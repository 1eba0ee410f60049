#include "image/exr.hpp"
#include "image/exr_stream.hpp"
#include "image/exr_threads.hpp"

#include <ImfChannelList.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <ImfTiledOutputFile.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <stdexcept>

namespace gabor::image {

namespace {

constexpr int tile_side = 64;
constexpr std::uint64_t magic_and_version = 8; // bytes before the header
constexpr const char* average_name = "oiio:AverageColor";

// Formats the channels' means in a fixed number of characters, since the header precedes the pixels.
std::string average_text(const std::vector<double>& sums, double pixels) {
    std::vector<std::string> means;
    for (const double sum : sums)
        means.push_back(fmt::format("{:+.8e}", sum / pixels));
    return fmt::format("{}", fmt::join(means, ","));
}

Imf::Header make_header(const ExrTextureWriter::Description& description) {
    Imf::Header header(description.width, description.height);
    header.setTileDescription({tile_side, tile_side, Imf::MIPMAP_LEVELS, Imf::ROUND_DOWN});
    header.compression() = exr_compression(description.compression);
    header.zipCompressionLevel() = exr_zip_level;
    for (const std::string& channel : description.channels)
        header.channels().insert(channel, Imf::Channel(description.half ? Imf::HALF : Imf::FLOAT));
    const auto insert = [&](const char* name, const std::string& text) {
        header.insert(name, Imf::StringAttribute(text));
    };
    insert("gabor", description.parameters);
    insert("software", description.software);
    if (!description.colour_space.empty())
        insert("oiio:ColorSpace", description.colour_space);
    insert("textureformat", "Plain Texture");
    insert("wrapmodes", description.periodic ? "periodic,periodic" : "black,black");
    header.insert("fovcot", Imf::FloatAttribute(static_cast<float>(description.width) /
                                                static_cast<float>(description.height)));
    insert(average_name, average_text(std::vector<double>(description.channels.size()), 1));
    return header;
}

// Returns the file position of the average's text.
std::uint64_t average_place(const Imf::Header& header) {
    Imf::StdOSStream stream;
    header.writeTo(stream, true);
    const auto before = std::string(average_name) + '\0' + "string" + '\0';
    return magic_and_version + stream.str().find(before) + before.size() + sizeof(std::int32_t);
}

} // namespace

struct ExrTextureWriter::State {
    State(const std::filesystem::path& path, const Description& of, const Imf::Header& header)
        : description(of), place(average_place(header)), sums(of.channels.size()), file(not_a_pipe(path)),
          stream(file), image(std::in_place, stream, header) {}

    const Description description;
    const std::uint64_t place;
    std::vector<double> sums; // per channel of the first level
    int level = 0;
    int row = 0;             // where the next row of tiles starts in this level
    std::vector<float> rows; // of the incomplete row of tiles
    std::vector<half> halves;
    OutputFile file;
    ExrStream stream;
    std::optional<Imf::TiledOutputFile> image;

    std::size_t row_values() const {
        return static_cast<std::size_t>(image->levelWidth(level)) * description.channels.size();
    }
    void write_tiles();
};

void ExrTextureWriter::State::write_tiles() {
    const std::size_t channels = description.channels.size();
    const auto count = static_cast<std::int64_t>(rows.size() / row_values());
    const auto slice = [&](Imf::PixelType type, const auto* values) {
        Imf::FrameBuffer frame;
        for (std::size_t c = 0; c < channels; ++c)
            frame.insert(description.channels[c],
                         Imf::Slice::Make(type, values + c, {0, row}, image->levelWidth(level), count,
                                          channels * sizeof(*values), row_values() * sizeof(*values)));
        image->setFrameBuffer(frame);
    };
    if (description.half) {
        halves.assign(rows.begin(), rows.end());
        slice(Imf::HALF, halves.data());
    } else {
        slice(Imf::FLOAT, rows.data());
    }
    const int y = row / tile_side;
    image->writeTiles(0, image->numXTiles(level) - 1, y, y, level);
    if (level == 0)
        for (std::size_t i = 0; i < rows.size(); ++i)
            sums[i % channels] += double{rows[i]};
    row += static_cast<int>(count);
    rows.clear();
    if (row == image->levelHeight(level)) {
        row = 0;
        ++level;
    }
}

ExrTextureWriter::ExrTextureWriter(const std::filesystem::path& path, const Description& description) {
    start_exr_threads();
    state_ = std::make_unique<State>(path, description, make_header(description));
}

ExrTextureWriter::~ExrTextureWriter() = default;
ExrTextureWriter::ExrTextureWriter(ExrTextureWriter&&) noexcept = default;

void ExrTextureWriter::write_rows(std::span<const float> pixels) {
    State& s = *state_;
    while (!pixels.empty()) {
        if (s.level == s.image->numLevels() || pixels.size() % s.row_values() != 0)
            throw std::logic_error("ExrTextureWriter::write_rows takes whole rows of the level that is next");
        const int end = std::min(s.row + tile_side, s.image->levelHeight(s.level));
        const std::size_t wanted = static_cast<std::size_t>(end - s.row) * s.row_values() - s.rows.size();
        const auto part = pixels.first(std::min(wanted, pixels.size()));
        s.rows.insert(s.rows.end(), part.begin(), part.end());
        pixels = pixels.subspan(part.size());
        if (part.size() == wanted)
            s.write_tiles();
    }
}

void ExrTextureWriter::commit() {
    State& s = *state_;
    if (s.level != s.image->numLevels())
        throw std::logic_error("ExrTextureWriter::commit before the last level");
    s.image.reset();
    s.stream.rethrow_failure();
    const double pixels = double(s.description.width) * s.description.height;
    const std::string average = average_text(s.sums, pixels);
    s.file.seek(s.place);
    s.file.write(std::as_bytes(std::span(average)));
    s.file.commit();
}

} // namespace gabor::image
