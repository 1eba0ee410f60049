#include "image/picture.hpp"

#include "error.hpp"
#include "scratch_folder.hpp"

#include <catch2/catch.hpp>

#include <sys/resource.h>
#include <zlib.h>

#include <array>
#include <cstring>
#include <optional>

using gabor::image::PictureReader;
using namespace std::string_literals;
using namespace std::string_view_literals;
namespace fs = std::filesystem;

namespace {

struct Pixels {
    int width;
    int height;
    std::vector<std::vector<float>> values; ///< of each pixel, with its alpha
    bool operator==(const Pixels&) const = default;
    const std::vector<float>& at(int x, int y) const {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

/// Returns nothing if the file is refused.
std::optional<Pixels> read(const fs::path& path) {
    try {
        const std::unique_ptr<PictureReader> file = gabor::image::open_picture(path);
        const auto& format = file->format();
        Pixels pixels{format.width, format.height, {}};
        const auto width = static_cast<std::size_t>(format.width),
                   channels = static_cast<std::size_t>(format.channels);
        std::vector<float> row(width * channels);
        for (int y = 0; y < format.height; ++y) {
            file->read_row(row);
            for (std::size_t x = 0; x < width; ++x) {
                const auto pixel = std::span(row).subspan(x * channels, channels);
                pixels.values.emplace_back(pixel.begin(), pixel.end());
                if (format.alpha)
                    pixels.values.back().push_back(file->alpha()[x]);
            }
        }
        return pixels;
    } catch (const gabor::RequestError& error) {
        if (std::string_view(error.what()).find('\n') != std::string_view::npos)
            FAIL(error.what());
        return {};
    }
}

const fs::path corpus = GABOR_CORPUS_FOLDER;

fs::path example(const char* name) {
    return corpus / "picture" / name;
}

/// A small file of each kind.
std::vector<fs::path> examples() {
    std::vector<fs::path> paths{corpus / "exr/zip.exr"};
    for (const auto& entry : fs::directory_iterator(corpus / "picture"))
        paths.push_back(entry.path());
    return paths;
}

/// Corrects the checksum of a PNG's chunk, which is shorter than 256 bytes.
void correct_checksum(std::string& png, std::string_view chunk) {
    const std::size_t at = png.find(chunk), size = 4 + static_cast<unsigned char>(png.at(at - 1));
    const auto sum = ::crc32(0, reinterpret_cast<const Bytef*>(&png[at]), static_cast<uInt>(size));
    for (std::size_t i = 0; i < 4; ++i)
        png.at(at + size + i) = static_cast<char>(sum >> (24 - 8 * i));
}

/// Changes the orientation in EXIF data: those of a JPEG here begin with the low byte, those of a PNG with
/// the high one.
std::string with_orientation(std::string bytes, char orientation) {
    if (const auto tag = bytes.find("\x12\1\3\0\1\0\0\0"s); tag != bytes.npos) {
        bytes[tag + 8] = orientation;
        return bytes;
    }
    bytes.at(bytes.find("\1\x12\0\3\0\0\0\1"s) + 9) = orientation;
    correct_checksum(bytes, "eXIf");
    return bytes;
}

} // namespace

TEST_CASE("A file that ends early is refused, or has all of its pixels", "[picture]") {
    const ScratchFolder folder;
    for (const fs::path& path : examples()) {
        INFO(path);
        const std::optional<Pixels> whole = read(path);
        REQUIRE(whole);
        const std::string bytes = read_file(path);
        std::string accepted;
        for (std::size_t length = 0; length < bytes.size(); ++length) {
            write_file(folder / "cut", std::string_view(bytes).substr(0, length));
            if (const std::optional<Pixels> cut = read(folder / "cut"); cut && cut != whole)
                accepted += std::to_string(length) + " ";
        }
        CHECK(accepted.empty());
    }
}

TEST_CASE("A flipped bit does no harm, and is refused where a file has checksums", "[picture]") {
    const ScratchFolder folder;
    for (const fs::path& path : examples()) {
        INFO(path);
        const std::optional<Pixels> whole = read(path);
        std::string bytes = read_file(path);
        std::string accepted;
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            const auto bit = static_cast<char>(1 << i % 8);
            bytes[i] ^= bit;
            write_file(folder / "flipped", bytes);
            if (const std::optional<Pixels> flipped = read(folder / "flipped"); flipped && flipped != whole)
                accepted += std::to_string(i) + " ";
            bytes[i] ^= bit;
        }
        CHECK((accepted.empty() || path.extension() != ".png"));
    }
}

TEST_CASE("A grey TGA may have alpha", "[picture]") {
    const ScratchFolder folder;
    write_file(folder / "grey.tga", "\0\0\3\0\0\0\0\0\0\0\0\0\2\0\1\0\x10\x28\x33\x66\xff\0"s);
    const std::optional<Pixels> grey = read(folder / "grey.tga");
    REQUIRE(grey);
    CHECK(grey->values == std::vector<std::vector<float>>{{51 / 255.0f, 102 / 255.0f}, {1, 0}});
}

TEST_CASE("A few bytes cannot claim a huge picture", "[picture]") {
    const ScratchFolder folder;
    rusage before{};
    ::getrusage(RUSAGE_SELF, &before);
    for (const char kind : {'\2', '\x0a'}) { // without and with run-length encoding
        write_file(folder / "huge.tga", "\0\0"s + kind + "\0\0\0\0\0\0\0\0\0\0\x40\0\x40\x20\0"s);
        CHECK(!read(folder / "huge.tga"));
    }
    std::string turned = read_file(example("alpha.png"));
    turned.replace(turned.find("IHDR") + 4, 8, "\0\1\0\0\0\1\0\0"s);
    correct_checksum(turned, "IHDR");
    write_file(folder / "turned.png", turned);
    CHECK_THROWS_WITH(gabor::image::open_picture(folder / "turned.png"),
                      Catch::Matchers::Contains("more than 1024 MiB"));
    rusage after{};
    ::getrusage(RUSAGE_SELF, &after);
    CHECK(after.ru_maxrss - before.ru_maxrss < 64 * 1024); // KiB
}

TEST_CASE("A picture is turned and mirrored as its EXIF data demand", "[picture]") {
    const ScratchFolder folder;
    const char* const name = GENERATE("colour.jpg", "alpha.png");
    const std::string bytes = read_file(example(name));
    const auto turned = [&](char orientation) {
        write_file(folder / "turned", with_orientation(bytes, orientation));
        return read(folder / "turned").value();
    };
    const Pixels stored = turned(1);
    CHECK(turned(0) == stored);
    CHECK(turned(9) == stored);
    // From the EXIF standard: the sides where the first stored row and column are seen.
    constexpr std::array sides{"top left", "top right", "bottom right", "bottom left",
                               "left top", "right top", "right bottom", "left bottom"};
    for (std::size_t i = 0; i < sides.size(); ++i) {
        INFO(name << ", " << sides[i]);
        const Pixels seen = turned(static_cast<char>(i + 1));
        REQUIRE(seen.width == (i < 4 ? stored.width : stored.height));
        REQUIRE(seen.values.size() == stored.values.size());
        const std::string row_side(sides[i], std::strcspn(sides[i], " "));
        const std::string column_side = sides[i] + row_side.size() + 1;
        bool same = true;
        for (int row = 0; row < stored.height; ++row)
            for (int column = 0; column < stored.width; ++column) {
                int x = 0;
                int y = 0;
                for (const auto& [side, distance] : {std::pair(row_side, row), {column_side, column}}) {
                    if (side == "left" || side == "right")
                        x = side == "left" ? distance : seen.width - 1 - distance;
                    else
                        y = side == "top" ? distance : seen.height - 1 - distance;
                }
                same &= seen.at(x, y) == stored.at(column, row);
            }
        CHECK(same);
    }
}

TEST_CASE("Superfluous bytes before and after a JPEG's scans are ignored, others are damage", "[picture]") {
    const ScratchFolder folder;
    const auto with_bytes_before = [&](std::string_view marker, const char* name) {
        const std::string bytes = read_file(example(name));
        write_file(folder / "longer", std::string(bytes).insert(bytes.rfind(marker), "\1\2\3"));
        return read(folder / "longer");
    };
    CHECK(with_bytes_before("\xff\xc2", "progressive.jpg") == read(example("progressive.jpg"))); // the frame
    CHECK(with_bytes_before("\xff\xd9", "colour.jpg") == read(example("colour.jpg")));           // the end
    CHECK(!with_bytes_before("\xff\xda", "progressive.jpg")); // the last scan
}

TEST_CASE("An ICC profile is named unless its colours are those of sRGB", "[picture]") {
    const ScratchFolder folder;
    const std::string bytes = read_file(example("profile.jpg"));
    const auto profile = [&](std::string_view from, std::string_view to) {
        std::string changed = bytes;
        REQUIRE(changed.find(from) != changed.npos);
        write_file(folder / "profile", changed.replace(changed.find(from), from.size(), to));
        return gabor::image::open_picture(folder / "profile")->format().profile;
    };
    CHECK(profile("", "").empty());
    CHECK(gabor::image::open_picture(example("profile.png"))->format().profile.empty());
    CHECK(profile("\x6f\xa0"sv, "\x9c\x18"sv) == "sRGB built-in");     // Adobe RGB's red
    CHECK(profile("\0\2\x66\x66"sv, "\0\1\0\0"sv) == "sRGB built-in"); // a gamma of 1 in place of 2.4
}
