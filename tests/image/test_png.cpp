#include "image/png.hpp"

#include "error.hpp"
#include "scratch_folder.hpp"

#include <catch2/catch.hpp>
#include <png.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

using gabor::RequestError;
using gabor::image::PngWriter;

namespace {

struct Picture {
    int width = 0;
    int height = 0;
    bool colour = false;
    std::vector<std::uint8_t> bytes;
};

Picture decode(const std::filesystem::path& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    REQUIRE(png_image_begin_read_from_file(&image, path.c_str()));
    const bool colour = image.format & PNG_FORMAT_FLAG_COLOR;
    REQUIRE(image.format == (colour ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY));
    std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(image));
    REQUIRE(png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr));
    return {static_cast<int>(image.width), static_cast<int>(image.height), colour, bytes};
}

} // namespace

TEST_CASE("A PNG decodes to the nearest of 256 levels", "[png]") {
    const ScratchFolder folder;
    const auto path = folder / "out.png";
    const int channels = GENERATE(1, 3);
    const int width = 37;
    const int height = 20;
    std::vector<float> values(static_cast<std::size_t>(width * height * channels));
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<float>(i) / static_cast<float>(values.size() - 1);

    const auto row = static_cast<std::size_t>(width * channels);
    PngWriter writer(path, width, height, channels);
    writer.write_rows(std::span(values).first(3 * row));
    PngWriter moved(std::move(writer));
    moved.write_rows(std::span(values).subspan(3 * row));
    CHECK(folder.count() == 0);
    moved.commit();

    const Picture picture = decode(path);
    CHECK(picture.width == width);
    CHECK(picture.height == height);
    CHECK(picture.colour == (channels == 3));
    REQUIRE(picture.bytes.size() == values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        REQUIRE(picture.bytes[i] == std::lround(values[i] * 255.0f));
}

TEST_CASE("A PNG clamps values outside its range", "[png]") {
    const ScratchFolder folder;
    const float infinity = std::numeric_limits<float>::infinity();
    const std::vector<float> values = {-1.0f, -0.0f, 1.0f, 7.0f, infinity, -infinity, std::nanf(""), 0.5f};
    PngWriter writer(folder / "out.png", 8, 1, 1);
    writer.write_rows(values);
    writer.commit();
    CHECK(decode(folder / "out.png").bytes == std::vector<std::uint8_t>{0, 0, 255, 255, 255, 0, 0, 128});
}

TEST_CASE("A PNG can be as wide as any picture", "[png]") {
    const ScratchFolder folder;
    PngWriter writer(folder / "out.png", 65536, 2, 1);
    writer.write_rows(std::vector<float>(2 * 65536, 1.0f));
    writer.commit();
    CHECK(decode(folder / "out.png").width == 65536);
    CHECK_THROWS_AS(PngWriter(folder / "wider.png", 65537, 2, 1), std::runtime_error);
    CHECK(folder.count() == 1);
}

TEST_CASE("An unfinished PNG does not appear", "[png]") {
    const ScratchFolder folder;
    const std::vector<float> row(8, 0.5f);
    {
        PngWriter writer(folder / "out.png", 8, 2, 1);
        writer.write_rows(row);
        CHECK_THROWS_AS(writer.commit(), std::logic_error);
        CHECK_THROWS_AS(writer.write_rows(std::span(row).first(5)), std::logic_error);
        writer.write_rows(row);
        CHECK_THROWS_AS(writer.write_rows(row), std::logic_error);
    }
    CHECK(folder.count() == 0);
    CHECK_THROWS_AS(PngWriter(folder / "missing/out.png", 8, 2, 1), RequestError);
}

TEST_CASE("Writing a PNG to a full disk fails with an error", "[png]") {
    CHECK_THROWS_WITH(PngWriter("/dev/full", 8, 2, 1), "cannot write /dev/full: No space left on device");
}
