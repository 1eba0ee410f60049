#include "image/picture.hpp"

#include "error.hpp"
#include "image/exr.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

namespace gabor::image {

namespace {

using namespace std::string_view_literals;

/// Reads each channel with its own ExrReader.
class ExrPicture : public PictureReader {
  public:
    ExrPicture(const std::filesystem::path& path, const std::string& channel) {
        readers_.emplace_back(path);
        if (!channel.empty() && readers_.front().has_channel(channel)) {
            readers_.clear();
            readers_.emplace_back(path, channel);
        }
        const ExrReader& first = readers_.front();
        format_ = {first.window().width, first.window().height, 1, first.has_channel("A"),
                   first.colour_space() != "sRGB"};
        if (first.channel() == "R" && first.has_channel("G") && first.has_channel("B")) {
            readers_.emplace_back(path, "G");
            readers_.emplace_back(path, "B");
            format_.channels = 3;
        }
        if (format_.alpha)
            alpha_reader_.emplace(path, "A");
    }

    void read_row(std::span<float> row) override {
        for (std::size_t c = 0; c < readers_.size(); ++c) {
            std::size_t at = c;
            for (const float value : readers_[c].read_rows(1)) {
                row[at] = value;
                at += readers_.size();
            }
        }
        if (alpha_reader_) {
            const auto alpha = alpha_reader_->read_rows(1);
            alpha_.assign(alpha.begin(), alpha.end());
        }
    }

  private:
    std::vector<ExrReader> readers_;
    std::optional<ExrReader> alpha_reader_;
};

} // namespace

std::unique_ptr<PictureReader> open_picture(const std::filesystem::path& path, const std::string& channel) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (error)
        throw RequestError(fmt::format("cannot read '{}': {}", path.string(), error.message()));
    if (!std::filesystem::is_regular_file(status)) // opening a FIFO would block
        throw RequestError(fmt::format("cannot read '{}': it is not a regular file", path.string()));

    std::array<char, 8> start{};
    std::ifstream file(path, std::ios::binary);
    file.read(start.data(), start.size());
    if (!file.is_open() || file.bad())
        throw RequestError(fmt::format("cannot read '{}'", path.string()));
    const std::string_view head(start.data(), static_cast<std::size_t>(file.gcount()));
    if (head == "\x89PNG\r\n\x1a\n"sv)
        return open_png(path);
    if (head.starts_with("\xff\xd8\xff"sv))
        return open_jpeg(path);
    if (head.starts_with("\x76\x2f\x31\x01"sv))
        return std::make_unique<ExrPicture>(path, channel);
    if (auto tga = open_tga(path)) // which starts with no signature
        return tga;
    throw RequestError(fmt::format("'{}' is no picture that can be read: it takes PNG, JPEG, TGA or OpenEXR",
                                   path.string()));
}

} // namespace gabor::image
