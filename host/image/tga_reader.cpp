#include "image/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>

#define STBI_ONLY_TGA
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>

namespace gabor::image {

namespace {

constexpr std::int64_t most_pixels = std::int64_t{1} << 28; // the whole picture is decoded in memory

// Reads a file for stb_image, which takes bytes that are missing for zeros.
struct Source {
    std::FILE* file;
    bool short_of_bytes = false;
};

constexpr stbi_io_callbacks callbacks{
    [](void* source, char* bytes, int size) {
        auto& of = *static_cast<Source*>(source);
        const auto read = std::fread(bytes, 1, static_cast<std::size_t>(size), of.file);
        of.short_of_bytes |= read == 0;
        return static_cast<int>(read);
    },
    [](void* source, int size) { std::fseek(static_cast<Source*>(source)->file, size, SEEK_CUR); },
    [](void* source) { return std::feof(static_cast<Source*>(source)->file); }};

// The bytes of the file's header.
using Header = std::array<std::uint8_t, 18>;

// The bytes of the file up to the end of its pixels; the least, if they are run-length encoded.
std::int64_t needed_bytes(const Header& header) {
    const auto word = [&](std::size_t i) { return std::int64_t{header[i]} + 256 * header[i + 1]; };
    const auto bytes = [](int bits) { return std::int64_t{(bits + 7) / 8}; };
    const std::int64_t pixels = word(12) * word(14);
    return 18 + header[0] + header[1] * word(5) * bytes(header[7]) +
           (header[2] >= 8 ? (pixels + 127) / 128 * (1 + bytes(header[16])) : pixels * bytes(header[16]));
}

class TgaPicture : public PictureReader {
  public:
    TgaPicture(const std::filesystem::path& path, std::FILE* file, int width, int height, int values) {
        if (std::int64_t{width} * height > most_pixels)
            refuse_picture(path,
                           fmt::format("a TGA may have at most {} million pixels", most_pixels / 1000000));
        Header header{};
        const bool whole_header = std::fread(header.data(), 1, header.size(), file) == header.size();
        std::fseek(file, 0, SEEK_END);
        const std::int64_t size = std::ftell(file);
        std::rewind(file);
        Source source{file};
        const bool whole = whole_header && size >= needed_bytes(header);
        if (whole)
            bytes_.reset(stbi_load_from_callbacks(&callbacks, &source, &width, &height, &values, 0));
        if (!whole || source.short_of_bytes)
            refuse_picture(path, "the file ends before its last pixel");
        if (!bytes_)
            refuse_picture(path, stbi_failure_reason());
        if (header[17] & 0x10) // from right to left
            for (int y = 0; y < height; ++y)
                for (int left = 0, right = width - 1; left < right; ++left, --right)
                    std::swap_ranges(pixel(y, left, width, values), pixel(y, left + 1, width, values),
                                     pixel(y, right, width, values));
        set_format({width, height, values < 3 ? 1 : 3, values % 2 == 0});
        next_ = bytes_.get();
    }

    void read_row(std::span<float> row) override {
        fill(row, [this] { return static_cast<float>(*next_++) / 255.0f; });
    }

  private:
    stbi_uc* pixel(int row, int column, int width, int values) {
        return bytes_.get() + (std::int64_t{row} * width + column) * values;
    }

    std::unique_ptr<stbi_uc, void (*)(void*)> bytes_{nullptr, stbi_image_free};
    const stbi_uc* next_ = nullptr;
};

} // namespace

std::unique_ptr<PictureReader> open_tga(const std::filesystem::path& path, File file) {
    int width = 0;
    int height = 0;
    int values = 0;
    if (stbi_info_from_file(file.get(), &width, &height, &values) == 0)
        return nullptr;
    return std::make_unique<TgaPicture>(path, file.get(), width, height, values);
}

} // namespace gabor::image
