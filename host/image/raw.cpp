#include "error.hpp"
#include "image/picture.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>

namespace gabor::image {

namespace {

class Raw : public PictureReader {
  public:
    Raw(const std::filesystem::path& path, int width, int height) : path_(path), file_(open_file(path)) {
        const std::uintmax_t size = std::filesystem::file_size(path);
        const std::uintmax_t heights =
            static_cast<std::uintmax_t>(width) * static_cast<std::uintmax_t>(height);
        if (size != 2 * heights && size != 4 * heights)
            throw RequestError(
                fmt::format("'{}' has {} bytes, but {} x {} heights without a header take {} or, "
                            "as 32-bit floats, {}",
                            path.string(), size, width, height, 2 * heights, 4 * heights));
        floats_ = size == 4 * heights;
        bytes_.resize(size / static_cast<std::size_t>(height));
        set_format({width, height, 1, false, floats_, floats_ ? 32 : 16});
    }

    void read_row(std::span<float> row) override {
        if (std::fread(bytes_.data(), 1, bytes_.size(), file_.get()) != bytes_.size())
            refuse_picture(path_, "it ends early");
        fill(row, [this, at = bytes_.data()]() mutable {
            std::uint32_t value = 0;
            for (unsigned shift = 0; shift < (floats_ ? 32u : 16u); shift += 8)
                value |= static_cast<std::uint32_t>(*at++) << shift;
            return floats_ ? std::bit_cast<float>(value) : static_cast<float>(value) / 65535.0f;
        });
    }

  private:
    std::filesystem::path path_;
    File file_;
    bool floats_ = false;
    std::vector<std::uint8_t> bytes_;
};

} // namespace

std::unique_ptr<PictureReader> open_raw(const std::filesystem::path& path, int width, int height) {
    return std::make_unique<Raw>(path, width, height);
}

} // namespace gabor::image
