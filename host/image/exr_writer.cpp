#include "error.hpp"
#include "image/deflater.hpp"
#include "image/exr_parts.hpp"
#include "image/output_file.hpp"

#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFloatAttribute.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <ImfTiledOutputFile.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <stdexcept>

namespace gabor::image {

namespace {

constexpr int tile_side = 64;
constexpr int zip_level =
    1; // of textures and single rows: on noise, OpenEXR's level 4 takes a fifth longer and saves 4 %
constexpr int zip_rows = 16; // that are compressed together
constexpr std::array<char, 8> magic_and_version{0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0}; // before the header
constexpr const char* average_name = "oiio:AverageColor";

// Formats the channels' means as text of a fixed length, so that `commit` can overwrite it in the header.
std::string average_text(const std::vector<double>& sums, double pixels) {
    std::vector<std::string> means;
    for (const double sum : sums)
        means.push_back(fmt::format("{:+.8e}", sum / pixels));
    return fmt::format("{}", fmt::join(means, ","));
}

// Returns the file position of the average's text.
std::uint64_t average_place(const Imf::Header& header) {
    Imf::StdOSStream stream;
    header.writeTo(stream, true);
    const auto before = std::string(average_name) + '\0' + "string" + '\0';
    return magic_and_version.size() + stream.str().find(before) + before.size() + sizeof(std::int32_t);
}

Imath::Box2i box(const Rect& window) {
    return {{window.x, window.y}, {window.x + window.width - 1, window.y + window.height - 1}};
}

Imf::Header exr_header(const ExrHeader& description) {
    Imf::Header header(box(description.picture), box(description.window));
    constexpr std::array methods{Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION,
                                 Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION};
    header.compression() = methods.at(static_cast<std::size_t>(
        std::ranges::find(exr_compressions, description.compression) - exr_compressions.begin()));
    header.zipCompressionLevel() = zip_level;
    for (const std::string& channel : description.channels)
        header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    for (const std::string& channel : description.halves)
        header.channels().insert(channel, Imf::Channel(Imf::HALF));
    const auto insert = [&](const char* name, const std::string& text) {
        header.insert(name, Imf::StringAttribute(text));
    };
    insert("gabor", description.parameters);
    if (!description.software.empty())
        insert("software", description.software);
    if (!description.colour_space.empty())
        insert("oiio:ColorSpace", description.colour_space);
    if (description.metres) {
        header.insert("gabor.width", Imf::FloatAttribute(static_cast<float>(*description.metres)));
        insert("gabor.unit", "metre");
    }
    if (description.texture) {
        header.setTileDescription({tile_side, tile_side, Imf::MIPMAP_LEVELS, Imf::ROUND_DOWN});
        insert("textureformat", "Plain Texture");
        insert("wrapmodes", description.texture->periodic ? "periodic,periodic" : "black,black");
        header.insert("fovcot", Imf::FloatAttribute(static_cast<float>(description.window.width) /
                                                    static_cast<float>(description.window.height)));
        insert(average_name, average_text(std::vector<double>(description.channels.size()), 1));
    }
    return header;
}

// Returns the path. Throws RequestError for a pipe, because the table of offsets is not written in order.
const std::filesystem::path& not_a_pipe(const std::filesystem::path& path) {
    if (system::is_pipe(path))
        throw RequestError(
            fmt::format("cannot write {}: it is a pipe; expected the path of a file", path.string()));
    return path;
}

} // namespace

// Lets OpenEXR write into an OutputFile. The destructor of Imf::OutputFile, which writes the table of
// offsets, swallows exceptions, but OutputFile::commit reports them.
class ExrStream final : public Imf::OStream {
  public:
    explicit ExrStream(OutputFile& file) : OStream(file.path().string().c_str()), file_(file) {}

    void write(const char* bytes, int count) override {
        file_.write({bytes, static_cast<std::size_t>(count)});
    }
    std::uint64_t tellp() override { return file_.position(); }
    void seekp(std::uint64_t position) override { file_.seek(position); }

  private:
    OutputFile& file_;
};

// half(value).bits(), which compilers do not inline.
std::uint32_t half_bits(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    const std::uint32_t rounded = (bits + 0xfff + (bits >> 13 & 1)) & 0x7fffffff; // to even
    if (rounded - 0x38800000 < 0x0f000000) // neither too small nor too large for a normal half
        return (bits >> 16 & 0x8000) | (rounded - 0x38000000) >> 13;
    return half(value).bits();
}

// Writes rows compressed by ZIP, as OpenEXR does, but several times as fast.
class ZipLines {
  public:
    ZipLines(Imf::OStream& stream, const ExrHeader& description, const Imf::Header& header)
        : stream_(stream), window_(description.window) {
        const auto& names = description.channels;
        for (auto each = header.channels().begin(); each != header.channels().end(); ++each)
            channels_.push_back(
                {static_cast<std::size_t>(std::ranges::find(names, each.name()) - names.begin()),
                 each.channel().type == Imf::HALF});
        stream.write(magic_and_version.data(), static_cast<int>(magic_and_version.size()));
        header.writeTo(stream);
        offsets_at_ = stream.tellp();
        offsets_.resize(static_cast<std::size_t>((window_.height + zip_rows - 1) / zip_rows));
        write_offsets();
    }

    // Writes zip_rows rows, or those that are left; `row` is the first of them.
    void write(std::span<const float> values, int row);
    void finish() {
        stream_.seekp(offsets_at_);
        write_offsets();
    }

  private:
    struct Channel {
        std::size_t index;
        bool half;
    };

    void write_offsets() { write_integers(std::span<const std::uint64_t>(offsets_)); }
    void write_bytes(std::span<const std::uint8_t> bytes) {
        stream_.write(reinterpret_cast<const char*>(bytes.data()), static_cast<int>(bytes.size()));
    }
    template <typename T>
    void write_integers(std::span<const T> integers) {
        std::vector<std::uint8_t> bytes;
        for (const T integer : integers)
            for (std::size_t i = 0; i < sizeof(T); ++i)
                bytes.push_back(static_cast<std::uint8_t>(integer >> 8 * i));
        write_bytes(bytes);
    }

    Imf::OStream& stream_;
    Rect window_;
    std::vector<Channel> channels_; // in the file's order
    std::uint64_t offsets_at_;
    std::vector<std::uint64_t> offsets_;
    std::vector<std::uint8_t> bytes_;       // of whole rows, the even ones before the odd ones
    std::vector<std::uint8_t> differences_; // of each from the one before
};

void ZipLines::write(std::span<const float> values, int row) {
    const std::size_t stride = channels_.size();
    const auto width = static_cast<std::size_t>(window_.width);
    std::size_t row_bytes = 0;
    for (const Channel& channel : channels_)
        row_bytes += width * (channel.half ? 2 : 4);
    bytes_.resize(values.size() / (width * stride) * row_bytes);
    std::uint8_t* even = bytes_.data();
    std::uint8_t* odd = even + bytes_.size() / 2;
    const auto put = [&](std::uint32_t bits) {
        *even++ = static_cast<std::uint8_t>(bits);
        *odd++ = static_cast<std::uint8_t>(bits >> 8);
    };
    for (std::size_t line = 0; line < values.size(); line += width * stride)
        for (const Channel& channel : channels_) {
            const float* const first = &values[line + channel.index];
            if (channel.half) {
                for (std::size_t x = 0; x < width; ++x)
                    put(half_bits(first[x * stride]));
            } else {
                for (std::size_t x = 0; x < width; ++x) {
                    const auto bits = std::bit_cast<std::uint32_t>(first[x * stride]);
                    put(bits);
                    put(bits >> 16);
                }
            }
        }
    differences_.resize(bytes_.size());
    differences_[0] = bytes_[0];
    for (std::size_t i = 1; i < bytes_.size(); ++i)
        differences_[i] = static_cast<std::uint8_t>(bytes_[i] - bytes_[i - 1] + 0x80);
    Deflater deflater;
    const std::size_t alike = width; // bytes of a channel of halves in one row
    for (std::size_t i = 0; i < differences_.size(); i += alike)
        deflater.write(std::span(differences_).subspan(i, alike));
    deflater.finish();
    std::span<const std::uint8_t> stored = deflater.output();
    if (stored.size() >= bytes_.size()) { // then readers expect the values as they are
        for (std::size_t i = 0; i < bytes_.size(); ++i)
            differences_[i] = bytes_[i / 2 + (i % 2) * (bytes_.size() / 2)];
        stored = differences_;
    }
    offsets_[static_cast<std::size_t>(row / zip_rows)] = stream_.tellp();
    const std::array<std::int32_t, 2> place{window_.y + row, static_cast<std::int32_t>(stored.size())};
    write_integers(std::span<const std::int32_t>(place));
    write_bytes(stored);
}

struct ExrWriter::State {
    State(const std::filesystem::path& path, const ExrHeader& of)
        : description(of), header(exr_header(of)), sums(of.channels.size()), file(not_a_pipe(path)),
          stream(file) {
        if (of.texture)
            tiles.emplace(stream, header);
        else if (of.compression == "zip")
            zip.emplace(stream, of, header);
        else
            lines.emplace(stream, header);
    }

    int levels() const { return tiles ? tiles->numLevels() : 1; }
    int width() const { return tiles ? tiles->levelWidth(level) : description.window.width; }
    int height() const { return tiles ? tiles->levelHeight(level) : description.window.height; }
    std::size_t row_values() const { return static_cast<std::size_t>(width()) * description.channels.size(); }
    void write(std::span<const float> values);
    void write_frame(std::span<const float> values, int count);

    const ExrHeader description;
    const Imf::Header header;
    std::vector<double> sums; ///< sum of each channel over a texture's first level
    int level = 0;
    int row = 0; ///< next row of the level
    std::vector<float>
        rows; ///< values of an incomplete row of tiles, or of rows that are compressed together
    std::vector<half> halves;
    OutputFile file;
    ExrStream stream;
    std::optional<Imf::OutputFile> lines;
    std::optional<ZipLines> zip;
    std::optional<Imf::TiledOutputFile> tiles;
};

// Writes rows; `values` must be a whole row of tiles, or all rows that are compressed together.
void ExrWriter::State::write(std::span<const float> values) {
    const auto count = static_cast<int>(values.size() / row_values());
    if (zip)
        zip->write(values, row);
    else
        write_frame(values, count);
    row += count;
    if (row == height()) {
        row = 0;
        ++level;
    }
}

// Lets OpenEXR write rows.
void ExrWriter::State::write_frame(std::span<const float> values, int count) {
    const Imath::V2i corner(description.window.x, description.window.y + row);
    const auto frame_of = [&](Imf::PixelType type, const auto* first) {
        return frame_buffer(type, first, description.channels, corner, width(), count);
    };
    Imf::FrameBuffer frame = frame_of(Imf::FLOAT, values.data());
    if (!description.halves.empty()) {
        halves.assign(values.begin(), values.end());
        const Imf::FrameBuffer rounded = frame_of(Imf::HALF, halves.data());
        for (const std::string& channel : description.halves)
            frame.insert(channel, rounded[channel]);
    }
    if (lines) { // OpenEXR compresses straight from `values`
        lines->setFrameBuffer(frame);
        lines->writePixels(count);
    } else {
        tiles->setFrameBuffer(frame);
        const int y = row / tile_side;
        tiles->writeTiles(0, tiles->numXTiles(level) - 1, y, y, level);
        for (std::size_t i = 0; level == 0 && i < values.size(); ++i)
            sums[i % sums.size()] += double{values[i]};
    }
}

ExrWriter::ExrWriter(const std::filesystem::path& path, const ExrHeader& header) {
    start_exr_threads();
    state_ = std::make_unique<State>(path, header);
}

ExrWriter::~ExrWriter() = default;
ExrWriter::ExrWriter(ExrWriter&&) noexcept = default;

void ExrWriter::write_rows(std::span<const float> pixels) {
    State& s = *state_;
    while (!pixels.empty()) {
        if (s.level == s.levels() || pixels.size() % s.row_values() != 0)
            throw std::logic_error("ExrWriter::write_rows takes whole rows and no more than the file has");
        const int together = s.tiles ? tile_side : s.zip ? zip_rows : s.height();
        const int end = std::min(s.row + together, s.height());
        const std::size_t wanted = static_cast<std::size_t>(end - s.row) * s.row_values() - s.rows.size();
        const auto part = pixels.first(std::min(wanted, pixels.size()));
        pixels = pixels.subspan(part.size());
        if (s.rows.empty() && (s.lines || part.size() == wanted)) {
            s.write(part);
            continue;
        }
        s.rows.insert(s.rows.end(), part.begin(), part.end());
        if (part.size() == wanted) {
            s.write(s.rows);
            s.rows.clear();
        }
    }
}

void ExrWriter::commit() {
    State& s = *state_;
    if (s.level != s.levels())
        throw std::logic_error("ExrWriter::commit called before the last row");
    s.lines.reset();
    s.tiles.reset();
    if (s.zip)
        s.zip->finish();
    if (s.description.texture) {
        const std::string average = average_text(s.sums, static_cast<double>(s.description.window.pixels()));
        s.file.seek(average_place(s.header));
        s.file.write(average);
    }
    s.file.commit();
}

} // namespace gabor::image
