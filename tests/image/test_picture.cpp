#include "image/picture.hpp"

#include "error.hpp"
#include "scratch_folder.hpp"

#include <catch2/catch.hpp>

#include <sys/resource.h>

#include <optional>

using gabor::image::PictureReader;
using namespace std::string_literals;
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

/// A small file of each kind.
std::vector<fs::path> examples() {
    std::vector<fs::path> paths{corpus / "exr/zip.exr"};
    for (const auto& entry : fs::directory_iterator(corpus / "picture"))
        paths.push_back(entry.path());
    return paths;
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

TEST_CASE("A few bytes cannot claim a huge TGA", "[picture]") {
    const ScratchFolder folder;
    rusage before{};
    ::getrusage(RUSAGE_SELF, &before);
    for (const char kind : {'\2', '\x0a'}) { // without and with run-length encoding
        write_file(folder / "huge.tga", "\0\0"s + kind + "\0\0\0\0\0\0\0\0\0\0\x40\0\x40\x20\0"s);
        CHECK(!read(folder / "huge.tga"));
    }
    rusage after{};
    ::getrusage(RUSAGE_SELF, &after);
    CHECK(after.ru_maxrss - before.ru_maxrss < 64 * 1024); // KiB
}
