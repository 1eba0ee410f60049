#include "image/exr.hpp"
#include "image/metadata.hpp"
#include "image/picture.hpp"

#include "error.hpp"
#include "scratch_folder.hpp"

#include <catch2/catch.hpp>

#include <sys/resource.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <tuple>

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

std::string big_endian(std::size_t value, int size) {
    std::string bytes;
    while (size-- > 0)
        bytes += static_cast<char>(value >> 8 * size);
    return bytes;
}

std::string fixed(double value) {
    return big_endian(static_cast<std::size_t>(std::lround(65536 * value)), 4);
}

/// The parts of an ICC profile, by default those of sRGB with tone curves of gamma 2.2.
struct Icc {
    const char* space = "RGB ";
    std::string description = "desc\0\0\0\0\0\0\0\4mine"s;
    std::string curve = "curv\0\0\0\0\0\0\0\1\2\x33"s;
    std::array<double, 6> primaries = {0.4361, 0.2225, 0.3851, 0.7169, 0.1431, 0.0606}; // x and y

    std::string foreign() const {
        const auto xyz = [&](std::size_t i) {
            return "XYZ \0\0\0\0"s + fixed(primaries[i]) + fixed(primaries[i + 1]) + fixed(0.1);
        };
        const std::array<std::pair<const char*, std::string>, 7> tags{
            {{"none", "desc\0\0\0\0\0\0\0\5wrong"s},
             {"desc", description},
             {std::strcmp(space, "GRAY") == 0 ? "kTRC" : "rTRC", curve},
             {"rXYZ", xyz(0)},
             {"gXYZ", xyz(2)},
             {"bXYZ", xyz(4)},
             {"kXYZ", "end"}}};
        std::string data;
        std::string table = big_endian(tags.size(), 4);
        for (const auto& [name, value] : tags) {
            table += name + big_endian(132 + 12 * tags.size() + data.size(), 4) + big_endian(value.size(), 4);
            data += value;
        }
        const std::string whole = std::string(16, '\0') + space + std::string(108, '\0') + table + data;
        return gabor::image::foreign_profile(
            {reinterpret_cast<const std::uint8_t*>(whole.data()), whole.size()});
    }
};

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

// Sizes, bits and pixels as another program, Pillow, reads them; JPEGs may be off by rounding. The first PNG,
// the first JPEG and the last TIFF are turned.
TEST_CASE("Each kind of file has its format and its pixels", "[picture]") {
    struct Known {
        const char* name;
        int width, height, bits;
        bool alpha;
        int x, y;
        std::vector<float> pixel;
    };
    for (const Known& known : {Known{"alpha.png", 9, 20, 8, true, 1, 17, {194, 178, 61, 194}},
                               {"colour.jpg", 33, 40, 8, false, 31, 2, {173, 178, 148}},
                               {"colour.tga", 20, 9, 8, false, 2, 1, {77, 194, 178}},
                               {"grey.jpg", 20, 9, 8, false, 2, 1, {189}},
                               {"grey.tga", 20, 9, 8, false, 2, 1, {114}},
                               {"grey16.png", 20, 9, 16, false, 0, 8, {52688}},
                               {"grey8.png", 20, 9, 8, false, 0, 8, {205}},
                               {"interlaced.png", 20, 9, 8, false, 0, 8, {205, 134, 50}},
                               {"palette.png", 20, 9, 4, true, 0, 8, {167, 145, 88, 64}},
                               {"palette.tga", 20, 9, 8, false, 0, 8, {190, 185, 180}},
                               {"progressive.jpg", 40, 33, 8, false, 0, 32, {102, 118, 180}},
                               {"runs.tga", 20, 9, 8, false, 0, 8, {205}},
                               {"strips.tif", 20, 9, 16, false, 2, 1, {49861}},
                               {"alpha.tif", 20, 9, 8, true, 2, 1, {194, 178, 61, 22}},
                               {"jpeg.tif", 20, 9, 8, false, 2, 1, {195, 179, 60}},
                               {"colour.tif", 9, 20, 8, false, 7, 2, {194, 178, 61}}}) {
        INFO(known.name);
        const auto file = gabor::image::open_picture(example(known.name));
        const auto& format = file->format();
        CHECK(std::array{format.width, format.height, format.bits, format.left, format.top} ==
              std::array{known.width, known.height, known.bits, 0, 0});
        CHECK(format.channels == static_cast<int>(known.pixel.size()) - known.alpha);
        CHECK(format.alpha == known.alpha);
        CHECK_FALSE(format.linear);
        const std::optional<Pixels> pixels = read(example(known.name));
        REQUIRE(pixels);
        const std::vector<float>& found = pixels->at(known.x, known.y);
        REQUIRE(found.size() == known.pixel.size());
        const float white = known.bits == 16 ? 65535 : 255;
        for (std::size_t i = 0; i < found.size(); ++i)
            CHECK(white * found[i] ==
                  Approx(known.pixel[i]).margin(0.1 + 2 * (std::strstr(known.name, "jp") != nullptr)));
    }
}

TEST_CASE("Heights of a GeoTIFF and of an array are those in the file", "[picture]") {
    const auto geo = gabor::image::open_picture(example("geo.tif"));
    CHECK(std::tuple(geo->format().scale, geo->format().offset, *geo->format().missing) ==
          std::tuple(0.5, 0.0, -32768.0f));
    const auto size = gabor::image::pixel_size(geo->format().geo, 20, 9);
    CHECK(size.sides == std::array{10.0, 20.0});
    CHECK(size.unit == "m");
    CHECK(read(example("geo.tif")) == read(example("heights.npy")));
    CHECK(read(example("geo.tif"))->at(2, 1) == std::vector{-39.0f});
}

TEST_CASE("A TGA may begin at any corner, with one to four values per pixel", "[picture]") {
    const ScratchFolder folder;
    for (const int values : {1, 2, 3, 4})
        for (const int origin : {0, 1, 2, 3}) { // 1: from the right; 2: from the top
            INFO(values << " values, origin " << origin);
            std::string file = "\0\0\0\0\0\0\0\0\0\0\0\0\3\0\2\0"s;
            file[2] = values < 3 ? '\3' : '\2';
            file += static_cast<char>(8 * values);
            file += static_cast<char>(16 * origin + (values % 2 == 0 ? 8 : 0));
            for (int row = 0; row < 2; ++row)
                for (int column = 0; column < 3; ++column)
                    for (int i = 0; i < values; ++i) // colours are stored as blue, green, red
                        file += static_cast<char>(100 * (origin & 2 ? row : 1 - row) +
                                                  20 * (origin & 1 ? 2 - column : column) +
                                                  (values > 2 && i < 3 ? 2 - i : i));
            write_file(folder / "a.tga", file);
            const std::optional<Pixels> pixels = read(folder / "a.tga");
            REQUIRE(pixels);
            for (int y = 0; y < 2; ++y)
                for (int x = 0; x < 3; ++x) {
                    std::vector<float> wanted;
                    for (int i = 0; i < values; ++i)
                        wanted.push_back(static_cast<float>(100 * y + 20 * x + i) / 255);
                    CHECK(pixels->at(x, y) == wanted);
                }
        }
}

TEST_CASE("An EXR is read in colour, as its first channel or as the one that is asked for, with its alpha",
          "[picture]") {
    const ScratchFolder folder;
    const auto seen = [&](const std::vector<std::string>& channels, const char* space, const char* asked) {
        gabor::image::ExrWriter file(
            folder / "a.exr",
            {.picture = {0, 0, 9, 9}, .window = {3, 5, 1, 2}, .channels = channels, .colour_space = space});
        std::vector<float> pixels;
        for (std::size_t i = 0; i < 2 * channels.size(); ++i) // RGBA as 0, 1, 2, 3, then 4, 5, 6, 7
            pixels.push_back(static_cast<float>(i));
        file.write_rows(pixels);
        file.commit();
        const auto picture = gabor::image::open_picture(folder / "a.exr", asked);
        const auto& format = picture->format();
        CHECK(std::array{format.width, format.height, format.bits, format.left, format.top} ==
              std::array{1, 2, 32, 3, 5});
        CHECK(format.linear == (space != "sRGB"sv));
        std::vector<float> values(static_cast<std::size_t>(format.channels));
        for (int row = 0; row < 2; ++row)
            picture->read_row(values);
        values.insert(values.end(), picture->alpha().begin(), picture->alpha().end());
        return values;
    };
    using Values = std::vector<float>;
    CHECK(seen({"R", "G", "B", "A"}, "lin_rec709", "") == Values{4, 5, 6, 7});
    CHECK(seen({"R", "G", "B"}, "sRGB", "") == Values{3, 4, 5});
    CHECK(seen({"R", "G", "B", "A"}, "", "G") == Values{5, 7});
    CHECK(seen({"R", "G", "B", "A"}, "", "A") == Values{7});
    CHECK(seen({"R", "G", "B", "A"}, "", "height") == Values{4, 5, 6, 7});
    CHECK(seen({"Z", "Y"}, "", "") == Values{3});
    CHECK(seen({"Z", "W"}, "", "Z") == Values{2});
    CHECK(seen({"R", "G"}, "", "") == Values{2});
    const gabor::image::ExrHeader header = gabor::image::ExrReader(folder / "a.exr").header();
    CHECK(std::array{header.picture.width, header.picture.height, header.window.x, header.window.y} ==
          std::array{9, 9, 3, 5});
    const gabor::image::ExrHeader all{{0, 0, 1, 1}, {0, 0, 1, 1}, {"Y"}, "a", "b", "c"};
    gabor::image::ExrWriter file(folder / "b.exr", all);
    file.write_rows(std::array{1.0f});
    file.commit();
    const gabor::image::ExrHeader again = gabor::image::ExrReader(folder / "b.exr").header();
    CHECK(std::array{again.parameters, again.software, again.colour_space} ==
          std::array{all.parameters, all.software, all.colour_space});
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
    for (const bool low_first : {false, true}) { // the entry may be anywhere in a table anywhere
        const auto number = [&](std::size_t value, int size) {
            std::string text = big_endian(value, size);
            if (low_first)
                std::ranges::reverse(text);
            return text;
        };
        const auto entry = [&](std::size_t tag, std::size_t value) {
            return number(tag, 2) + number(3, 2) + number(1, 4) + number(value, 2) + number(7, 2);
        };
        const std::string exif = (low_first ? "II" : "MM") + number(42, 2) + number(300, 4) +
                                 std::string(292, 'x') + number(3, 2) + entry(0x0111, 2) + entry(0x1201, 4) +
                                 entry(0x0112, 5);
        const std::span of(reinterpret_cast<const std::uint8_t*>(exif.data()), exif.size());
        CHECK(gabor::image::exif_orientation(of) == 5);
        CHECK(gabor::image::exif_orientation(of.first(316)) == 1);
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

TEST_CASE("An ICC profile's name, tone curve and primaries are read in each of their encodings",
          "[picture]") {
    Icc gamma_1_8{.curve = "curv\0\0\0\0\0\0\0\1\1\xcd"s};
    CHECK(gamma_1_8.foreign() == "mine");
    gamma_1_8.description = "mluc\0\0\0\0\0\0\0\1\0\0\0\x0c"
                            "enUS\0\0\0\6\0\0\0\x1e\x4d\x4d\0a\1\7\0c"s;
    CHECK(gamma_1_8.foreign() == "a?c");
    gamma_1_8.description = "desc\0\0\0\0\0\0\0\xff"s + std::string(79, '~') + "!!\n";
    CHECK(gamma_1_8.foreign() == std::string(79, '~') + "!");
    gamma_1_8.description = std::string(12, '\0');
    CHECK(gamma_1_8.foreign() == "unnamed");

    const auto word = [](double value) {
        return big_endian(static_cast<std::size_t>(std::lround(65535 * value)), 2);
    };
    const std::string table = "curv\0\0\0\0\0\0\0"s, formula = "para\0\0\0\0"s;
    for (const char* space : {"RGB ", "GRAY"}) { // half has the linear value 0.214
        const auto is_srgb = [&](const std::string& curve) {
            return Icc{.space = space, .curve = curve}.foreign().empty();
        };
        for (const double away : {0.0, -0.0097, 0.0097, -0.0103, 0.0103}) {
            INFO(space << ", " << away);
            const bool near = std::abs(away) < 0.01;
            const double linear = 0.214 + away;
            CHECK(is_srgb(table + "\2" + word(linear) + word(1)) == near);
            CHECK(is_srgb(table + "\5" + word(0) + word(0.1) + word(linear) + word(0.5) + word(1)) == near);
            CHECK(is_srgb(formula + "\0\0\0\0"s + fixed(std::log(linear) / std::log(0.5))) == near);
            CHECK(is_srgb(formula + "\0\3\0\0"s + fixed(1) + fixed(0.3) + fixed(linear - 0.15)) == near);
        }
        CHECK(is_srgb(table + "\1\2\x33"));
        CHECK_FALSE(is_srgb(table + "\0"s));
    }
    for (std::size_t i = 0; i < 6; ++i)
        for (const double away : {-0.0097, 0.0097, -0.0103, 0.0103}) {
            INFO(i << ", " << away);
            Icc icc;
            icc.primaries[i] += away;
            CHECK(icc.foreign().empty() == (std::abs(away) < 0.01));
            icc.primaries[i ^ 1] += std::copysign(0.001, away);
            CHECK_FALSE(icc.foreign().empty());
        }
}
