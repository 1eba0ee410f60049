#include "image/picture.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <memory>

#define STBI_ONLY_TGA
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace gabor::image {

namespace {

constexpr std::int64_t most_pixels = std::int64_t{1} << 28; // the whole picture is decoded in memory

class TgaPicture : public PictureReader {
  public:
    TgaPicture(const std::filesystem::path& path, std::FILE* file, int width, int height, int values) {
        if (std::int64_t{width} * height > most_pixels)
            refuse_picture(path,
                           fmt::format("a TGA may have at most {} million pixels", most_pixels / 1000000));
        bytes_.reset(stbi_load_from_file(file, &width, &height, &values, 0));
        if (!bytes_)
            refuse_picture(path, stbi_failure_reason());
        set_format({width, height, values < 3 ? 1 : 3, values % 2 == 0});
        next_ = bytes_.get();
    }

    void read_row(std::span<float> row) override {
        fill(row, [this] { return static_cast<float>(*next_++) / 255.0f; });
    }

  private:
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
