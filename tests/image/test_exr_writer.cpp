#include "image/exr.hpp"

#include "error.hpp"
#include "scratch_folder.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <random>
#include <sys/stat.h>
#include <unistd.h>

using namespace gabor::image;
using gabor::RequestError;

namespace {

/// Floats with arbitrary bit patterns, including NaNs, infinities and denormals.
std::vector<float> any_floats(std::size_t count) {
    std::vector<float> values(count);
    std::mt19937 random(7);
    for (float& value : values)
        value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    const std::uint32_t special[] = {0x7f800000, 0xff800000, 0x7fc00001, 0x00000001, 0x80000000, 0x807fffff};
    for (std::size_t i = 0; i < std::size(special) && i < count; ++i)
        values[i] = std::bit_cast<float>(special[i]);
    return values;
}

bool same_bits(std::span<const float> a, std::span<const float> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

std::vector<float> channel_of(const std::vector<float>& pixels, std::size_t channel, std::size_t channels) {
    std::vector<float> values;
    for (std::size_t i = channel; i < pixels.size(); i += channels)
        values.push_back(pixels[i]);
    return values;
}

std::vector<float> read_all(const std::filesystem::path& path, const std::string& channel, int rows) {
    ExrReader reader(path, {channel});
    std::vector<float> values;
    for (auto band = reader.read_rows(rows); !band.empty(); band = reader.read_rows(rows))
        values.insert(values.end(), band.begin(), band.end());
    return values;
}

void write(const std::filesystem::path& path, const gabor::image::ExrHeader& description,
           std::span<const float> pixels, std::vector<int> heights) {
    const auto row = static_cast<std::size_t>(description.window.width) * description.channels.size();
    ExrWriter writer(path, description);
    for (std::size_t i = 0; !pixels.empty(); ++i) {
        const std::size_t height = static_cast<std::size_t>(heights[i % heights.size()]);
        const auto band = pixels.first(std::min(pixels.size(), height * row));
        writer.write_rows(band);
        pixels = pixels.subspan(band.size());
    }
    writer.commit();
}

const Rect small = {0, 0, 8, 5};

} // namespace

TEST_CASE("Every bit is kept, with bands of any height", "[exr]") {
    const ScratchFolder folder;
    const auto path = folder / "out.exr";
    const Rect window = {3, 5, 61, 150};
    const std::vector<std::string> channels =
        GENERATE(std::vector<std::string>{"Y"}, std::vector<std::string>{"R", "G", "B"},
                 std::vector<std::string>{"noise.0", "A", "Z", "noise.1"});
    const auto pixels = any_floats(61 * 150 * channels.size());
    write(path, {{0, 0, 100, 200}, window, channels, {}}, pixels, {1, 7, 16, 33, 2, 31});
    for (std::size_t c = 0; c < channels.size(); ++c)
        for (const int rows : {1, 13, 64, 1000})
            CHECK(same_bits(read_all(path, channels[c], rows), channel_of(pixels, c, channels.size())));
}

TEST_CASE("A window may lie in the far corner of the largest picture", "[exr]") {
    const ScratchFolder folder;
    const auto path = folder / "out.exr";
    const Rect picture = {0, 0, 65536, 65536};
    const Rect window = GENERATE(Rect{65500, 65507, 36, 29}, Rect{65535, 0, 1, 20}, Rect{0, 65535, 9, 1});
    const auto pixels = any_floats(static_cast<std::size_t>(window.width * window.height) * 2);
    write(path, {picture, window, {"a", "b"}, {}}, pixels, {3, 10});

    const ExrReader reader(path, {"a"});
    CHECK(reader.header().picture.width == 65536);
    CHECK(reader.header().picture.height == 65536);
    CHECK(reader.header().window.x == window.x);
    CHECK(reader.header().window.y == window.y);
    CHECK(reader.header().window.width == window.width);
    CHECK(reader.header().window.height == window.height);
    CHECK(same_bits(read_all(path, "b", 4), channel_of(pixels, 1, 2)));
}

TEST_CASE("The parameters are stored as text", "[exr]") {
    const ScratchFolder folder;
    const auto pixels = any_floats(40);
    const std::string parameters =
        GENERATE(std::string(), std::string("{\"seed\": 1}\nσ = 2"), std::string(5000, 'x'));
    write(folder / "out.exr", {small, small, {"Y"}, parameters}, pixels, {5});
    CHECK(ExrReader(folder / "out.exr").header().parameters == parameters);
}

TEST_CASE("An EXR in a missing folder is refused", "[exr]") {
    const ScratchFolder folder;
    CHECK_THROWS_AS(ExrWriter(folder / "missing/out.exr", {small, small, {"Y"}, {}}), RequestError);
    CHECK(folder.count() == 0);
}

TEST_CASE("An unfinished EXR does not appear", "[exr]") {
    const ScratchFolder folder;
    const auto path = folder / "out.exr";
    const auto pixels = any_floats(40);
    write_file(path, "old");
    {
        ExrWriter writer(path, {small, small, {"Y"}, {}});
        writer.write_rows(std::span(pixels).first(32));
        CHECK_THROWS_AS(writer.commit(), std::logic_error);
        ExrWriter moved(std::move(writer));
        CHECK_THROWS_AS(moved.write_rows(std::span(pixels).first(16)), std::logic_error);
        CHECK_THROWS_AS(moved.write_rows(std::span(pixels).first(7)), std::logic_error);
        moved.write_rows({});
    }
    CHECK(read_file(path) == "old");
    CHECK(folder.count() == 1);
}

TEST_CASE("Writing an EXR to a full disk fails with an error", "[exr]") {
    using Catch::Matchers::Contains;
    CHECK_THROWS_WITH(ExrWriter("/dev/full", {small, small, {"Y"}, {}}),
                      Contains("/dev/full: No space left on device"));
}
