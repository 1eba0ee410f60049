#include "image/exr.hpp"

#include "error.hpp"
#include "scratch_folder.hpp"

#include <catch2/catch.hpp>

#include <ImfChannelList.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <ImfTiledOutputFile.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <sys/resource.h>
#include <sys/stat.h>

using gabor::RequestError;
using gabor::image::ExrReader;
namespace fs = std::filesystem;

namespace {

constexpr int width = 40;
constexpr int height = 36;
constexpr int left = -3; // a data window may start anywhere
constexpr int top = 11;
const Imath::Box2i box{{left, top}, {left + width - 1, top + height - 1}};

/// Small integers, which half, float and integer channels hold exactly.
std::vector<float> ramp() {
    std::vector<float> values(width * height);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<float>(i % 1000);
    return values;
}

template <class Pixel>
struct Channel {
    const char* name;
    std::vector<Pixel> values;
};

template <class Pixel>
constexpr Imf::PixelType type_of = Imf::FLOAT;
template <>
constexpr Imf::PixelType type_of<Imath::half> = Imf::HALF;
template <>
constexpr Imf::PixelType type_of<unsigned> = Imf::UINT;

/// An EXR as another program would write it, built channel by channel.
class Foreign {
  public:
    explicit Foreign(Imf::Compression compression = Imf::ZIP_COMPRESSION)
        : header(box, box, 1.0f, {0.0f, 0.0f}, 1.0f, Imf::INCREASING_Y, compression) {}

    template <class Pixel>
    void add(const char* name) {
        const auto values = ramp();
        auto& bytes = storage_.emplace_back(values.size() * sizeof(Pixel));
        for (std::size_t i = 0; i < values.size(); ++i) {
            const auto pixel = static_cast<Pixel>(values[i]);
            std::memcpy(&bytes[i * sizeof(Pixel)], &pixel, sizeof(Pixel));
        }
        header.channels().insert(name, Imf::Channel(type_of<Pixel>));
        buffer.insert(
            name, Imf::Slice::Make(type_of<Pixel>, bytes.data(), box, sizeof(Pixel), sizeof(Pixel) * width));
    }

    void write_scanlines(const fs::path& path, int rows = height) const {
        Imf::OutputFile file(path.c_str(), header);
        file.setFrameBuffer(buffer);
        file.writePixels(rows);
    }

    void write_tiles(const fs::path& path, Imf::LevelMode mode = Imf::ONE_LEVEL) {
        header.setTileDescription({16, 9, mode});
        Imf::TiledOutputFile file(path.c_str(), header);
        file.setFrameBuffer(buffer); // the higher levels repeat the corner of the lowest
        for (int y = 0; y < file.numYLevels(); ++y)
            for (int x = 0; x < file.numXLevels(); ++x)
                if (file.isValidLevel(x, y))
                    file.writeTiles(0, file.numXTiles(x) - 1, 0, file.numYTiles(y) - 1, x, y);
    }

    Imf::Header header;
    Imf::FrameBuffer buffer;

  private:
    std::vector<std::vector<char>> storage_;
};

std::vector<float> read_all(ExrReader& reader, int rows = 7) {
    std::vector<float> values;
    for (auto band = reader.read_rows(rows); !band.empty(); band = reader.read_rows(rows))
        values.insert(values.end(), band.begin(), band.end());
    return values;
}

std::string refusal(const fs::path& path, const std::vector<std::string>& channels = {}) {
    try {
        ExrReader reader(path, channels);
    } catch (const RequestError& error) {
        return error.what();
    }
    return "accepted";
}

/// Returns the file's bytes with `values` in place of those after `mark`.
template <std::size_t n>
std::string patched(std::string file, std::string_view mark, const std::array<std::int32_t, n>& values) {
    const std::size_t start = file.find(mark);
    REQUIRE(start != std::string::npos);
    std::memcpy(&file[start + mark.size()], values.data(), sizeof(values));
    return file;
}

constexpr std::string_view window_mark("dataWindow\0box2i\0\x10\0\0\0", 21);
constexpr std::string_view tiles_mark("tiles\0tiledesc\0\x9\0\0\0", 19);
constexpr std::string_view text_mark("gabor\0string\0", 13);
constexpr std::string_view offsets_mark("screenWindowWidth\0float\0\x4\0\0\0\0\0\x80\x3f\0", 33);

} // namespace

TEST_CASE("Scanlines of half and float are read as float", "[exr]") {
    const ScratchFolder folder;
    const auto path = folder / "in.exr";
    Foreign foreign(GENERATE(Imf::NO_COMPRESSION, Imf::PIZ_COMPRESSION, Imf::ZIP_COMPRESSION));
    foreign.header.lineOrder() = GENERATE(Imf::INCREASING_Y, Imf::DECREASING_Y);
    foreign.add<float>("float");
    foreign.add<Imath::half>("half");
    foreign.write_scanlines(path);
    for (const char* channel : {"float", "half"}) {
        ExrReader reader(path, {channel});
        CHECK(reader.header().channels.front() == channel);
        CHECK(reader.header().window.x == left);
        CHECK(reader.header().window.y == top);
        CHECK(reader.header().parameters.empty());
        CHECK(read_all(reader) == ramp());
        CHECK(reader.read_rows(1).empty());
    }
}

TEST_CASE("Tiles are read as rows", "[exr]") {
    const ScratchFolder folder;
    const auto path = folder / "in.exr";
    Foreign foreign;
    foreign.add<float>("Y");
    foreign.add<Imath::half>("A");
    foreign.write_tiles(path, GENERATE(Imf::ONE_LEVEL, Imf::MIPMAP_LEVELS, Imf::RIPMAP_LEVELS));
    const int rows = GENERATE(1, 7, 9, 100);
    ExrReader luminance(path);
    CHECK(luminance.header().channels.front() == "Y");
    CHECK(read_all(luminance, rows) == ramp());
    ExrReader alpha(path, {"A"});
    CHECK(read_all(alpha, rows) == ramp());
}

TEST_CASE("Only the first of several parts is read", "[exr]") {
    const ScratchFolder folder;
    Foreign first;
    first.add<float>("one");
    Foreign second;
    second.add<float>("two");
    first.header.setName("first");
    second.header.setName("second");
    std::vector<Imf::Header> headers = {first.header, second.header};
    for (Imf::Header& header : headers)
        header.setType(Imf::SCANLINEIMAGE);
    {
        Imf::MultiPartOutputFile file((folder / "in.exr").c_str(), headers.data(), 2);
        Imf::OutputPart part0(file, 0);
        part0.setFrameBuffer(first.buffer);
        part0.writePixels(height);
        Imf::OutputPart part1(file, 1);
        part1.setFrameBuffer(second.buffer);
        part1.writePixels(height);
    }
    ExrReader reader(folder / "in.exr");
    CHECK(reader.header().channels.front() == "one");
    CHECK(read_all(reader) == ramp());
}

TEST_CASE("Without a channel name, the reader takes Y, else R, else the first half or float channel",
          "[exr]") {
    const ScratchFolder folder;
    const auto path = folder / "in.exr";
    Foreign foreign;
    foreign.add<unsigned>("A");
    foreign.add<Imath::half>("Z");
    foreign.write_scanlines(path);
    CHECK(ExrReader(path).header().channels.front() == "Z");
    foreign.add<float>("R");
    foreign.write_scanlines(path);
    CHECK(ExrReader(path).header().channels.front() == "R");
    foreign.add<float>("Y");
    foreign.write_scanlines(path);
    CHECK(ExrReader(path).header().channels.front() == "Y");
}

TEST_CASE("A channel that cannot be read is refused", "[exr]") {
    using Catch::Matchers::Contains;
    const ScratchFolder folder;
    const auto path = folder / "in.exr";
    Foreign foreign;
    foreign.add<unsigned>("id");
    foreign.write_scanlines(path);
    CHECK_THAT(refusal(path), Contains("no half or float channel among id"));
    CHECK_THAT(refusal(path, {"id"}), Contains("contains integers; only half and float are supported"));
    foreign.add<float>("Z");
    foreign.write_scanlines(path);
    CHECK_THAT(refusal(path, {"Y"}), Contains("there is no channel 'Y'; the file has Z, id"));

    for (const auto& [across, down] : {std::pair(2, 2), {1, 2}, {2, 1}}) {
        Imf::Header header({{0, 0}, {1, 1}}, {{0, 0}, {1, 1}});
        header.channels().insert("Y", Imf::Channel(Imf::FLOAT, across, down));
        {
            const std::array<float, 2> pixels{};
            Imf::FrameBuffer buffer;
            buffer.insert("Y", Imf::Slice::Make(Imf::FLOAT, pixels.data(), {0, 0}, 2, 2, 4,
                                                static_cast<std::size_t>(across == 1 ? 8 : 4), across, down));
            Imf::OutputFile file(path.c_str(), header);
            file.setFrameBuffer(buffer);
            file.writePixels(2);
        }
        CHECK_THAT(refusal(path), Contains("channel 'Y' is subsampled"));
    }
}

TEST_CASE("A file that is not a flat EXR is refused", "[exr]") {
    using Catch::Matchers::Contains;
    const ScratchFolder folder;
    CHECK_THAT(refusal(folder / "missing.exr"), Contains("missing.exr': No such file or directory"));
    CHECK_THAT(refusal(folder.path()), Contains("not a regular file"));
    REQUIRE(::mkfifo((folder / "fifo").c_str(), 0600) == 0);
    CHECK_THAT(refusal(folder / "fifo"), Contains("not a regular file"));
    write_file(folder / "empty", "");
    CHECK_THAT(refusal(folder / "empty"), Contains("truncated"));
    write_file(folder / "text", "Not an image at all, but a text of some length.\n");
    CHECK_THAT(refusal(folder / "text"), Contains("not an OpenEXR file"));

    Imf::Header header(2, 1);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    header.setType(Imf::DEEPSCANLINE);
    header.compression() = Imf::ZIPS_COMPRESSION;
    {
        std::array<unsigned, 2> counts = {1, 1};
        float value = 1.0f;
        std::array<float*, 2> samples = {&value, &value};
        Imf::DeepFrameBuffer buffer;
        buffer.insertSampleCountSlice(Imf::Slice::Make(Imf::UINT, counts.data(), {0, 0}, 2, 1));
        buffer.insert("Y", Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(samples.data()), sizeof(float*),
                                          2 * sizeof(float*), sizeof(float)));
        Imf::DeepScanLineOutputFile file((folder / "deep").c_str(), header);
        file.setFrameBuffer(buffer);
        file.writePixels(1);
    }
    CHECK_THAT(refusal(folder / "deep"), Contains("deep data"));
}

TEST_CASE("A truncated file is refused, wherever it ends", "[exr]") {
    const ScratchFolder folder;
    const bool tiled = GENERATE(false, true);
    Foreign foreign(GENERATE(Imf::NO_COMPRESSION, Imf::ZIP_COMPRESSION));
    foreign.add<Imath::half>("Y");
    const auto path = folder / "in.exr";
    tiled ? foreign.write_tiles(path) : foreign.write_scanlines(path);
    REQUIRE(refusal(path) == "accepted");

    const std::uintmax_t whole = fs::file_size(path);
    for (std::uintmax_t size = whole; size > 0;) {
        size -= size < 600 || size + 20 > whole ? 1 : 7;
        CAPTURE(size);
        fs::resize_file(path, size);
        REQUIRE(refusal(path) != "accepted");
    }
}

TEST_CASE("A file whose writer was stopped is refused", "[exr]") {
    using Catch::Matchers::Contains;
    const ScratchFolder folder;
    Foreign foreign;
    foreign.add<float>("Y");
    foreign.write_scanlines(folder / "half", height / 2);
    CHECK_THAT(refusal(folder / "half"), Contains("truncated or damaged"));
    foreign.write_scanlines(folder / "whole");
    write_file(folder / "no offsets", patched(read_file(folder / "whole"), offsets_mark, std::array{0, 0}));
    CHECK_THAT(refusal(folder / "no offsets"), Contains("truncated or damaged"));
}

TEST_CASE("A file compressed by a newer OpenEXR is refused by this name", "[exr]") {
    const ScratchFolder folder;
    Foreign foreign(Imf::ZIP_COMPRESSION);
    foreign.add<float>("Y");
    foreign.write_scanlines(folder / "zip");
    REQUIRE(refusal(folder / "zip") == "accepted");
    std::string bytes = read_file(folder / "zip");
    const std::string mark("compression\0compression\0\1\0\0\0", 28);
    const std::size_t at = bytes.find(mark);
    REQUIRE(at != bytes.npos);
    bytes[at + mark.size()] = 100;
    write_file(folder / "newer", bytes);
    CHECK_THAT(refusal(folder / "newer"), Catch::Matchers::Contains("compressed by a newer OpenEXR"));
    bytes[at + mark.size()] = 3; // ZIP, as it was
    write_file(folder / "again", bytes);
    CHECK(refusal(folder / "again") == "accepted");
}

TEST_CASE("A window that the file cannot hold is refused before memory is allocated", "[exr]") {
    using Catch::Matchers::Contains;
    const ScratchFolder folder;
    const auto path = folder / "in.exr";
    Foreign foreign(GENERATE(Imf::NO_COMPRESSION, Imf::ZIP_COMPRESSION));
    foreign.add<float>("Y");
    foreign.write_scanlines(path);
    const std::string whole = read_file(path);
    rusage before{};
    ::getrusage(RUSAGE_SELF, &before);

    const std::int32_t far = 0x3ffffffe; // the farthest corner that OpenEXR allows
    for (const auto& window : {std::array{0, 0, 65536, 0}, std::array{0, 0, 0, 65536},
                               std::array{0, 0, far, far}, std::array{-far, -far, far, far}}) {
        write_file(path, patched(whole, window_mark, window));
        CHECK_THAT(refusal(path), Contains("at most 65536 x 65536 are supported"));
    }
    for (const auto& window :
         {std::array{0, 0, 65535, 65535}, std::array{0, 0, INT32_MAX, INT32_MAX},
          std::array{INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX}, std::array{5, 5, 4, 4}}) {
        write_file(path, patched(whole, window_mark, window));
        CHECK(refusal(path) != "accepted");
    }

    foreign.header.insert("gabor", Imf::StringAttribute("hello"));
    foreign.write_scanlines(path);
    write_file(path, patched(read_file(path), text_mark, std::array{INT32_MAX}));
    CHECK_THAT(refusal(path), Contains("truncated or damaged"));

    foreign.write_tiles(path);
    const std::string tiled = read_file(path);
    for (const auto& size :
         {std::array{65536, 8192}, std::array{16, 4 << 20}, std::array{INT32_MAX, INT32_MAX}}) {
        write_file(path, patched(tiled, tiles_mark, size));
        CHECK(refusal(path) != "accepted");
    }

    rusage after{};
    ::getrusage(RUSAGE_SELF, &after);
    CHECK(after.ru_maxrss - before.ru_maxrss < 64 * 1024); // KiB
}
