#include "image/picture.hpp"

#include "error.hpp"
#include "image/exr.hpp"
#include "image/metadata.hpp"
#include "names.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

namespace gabor::image {

namespace {

using namespace std::string_view_literals;

class ExrPicture : public PictureReader {
  public:
    ExrPicture(const std::filesystem::path& path, const std::string& channel) {
        const ExrReader file(path);
        std::vector<std::string> names = file.header().channels;
        if (!channel.empty() && file.has_channel(channel))
            names = {channel};
        else if (names.front() == "R" && file.has_channel("G") && file.has_channel("B"))
            names = {"R", "G", "B"};
        const Rect& window = file.header().window;
        set_format({window.width, window.height, static_cast<int>(names.size()),
                    file.has_channel("A") && names.front() != "A", file.header().colour_space != "sRGB", 32,
                    window.x, window.y});
        if (format().alpha)
            names.push_back("A");
        reader_.emplace(path, names);
    }

    void read_row(std::span<float> row) override {
        auto value = reader_->read_rows(1).begin();
        fill(row, [&value] { return *value++; });
    }

  private:
    std::optional<ExrReader> reader_;
};

} // namespace

void refuse_picture(const std::filesystem::path& path, std::string_view reason) {
    throw RequestError(fmt::format("cannot read '{}': {}", path.string(), reason));
}

File open_file(const std::filesystem::path& path) {
    std::error_code error;
    if (const auto status = std::filesystem::status(path, error); !error && !is_regular_file(status))
        refuse_picture(path, "it is not a regular file");
    File file(std::fopen(path.string().c_str(), "rb"), std::fclose);
    if (!file)
        refuse_picture(path, std::strerror(errno));
    return file;
}

std::unique_ptr<PictureReader> open_picture(const std::filesystem::path& path, const std::string& channel,
                                            std::string_view hint) {
    File file = open_file(path);
    std::array<char, 8> start{};
    const std::string_view head(start.data(), std::fread(start.data(), 1, start.size(), file.get()));
    std::rewind(file.get());
    if (head == "\x89PNG\r\n\x1a\n"sv)
        return upright(path, open_png(path, std::move(file)));
    if (head.starts_with("\xff\xd8\xff"sv))
        return upright(path, open_jpeg(path, std::move(file)));
    if (head.starts_with("\x76\x2f\x31\x01"sv))
        return std::make_unique<ExrPicture>(path, channel);
    if (head.starts_with("II*\0"sv) || head.starts_with("MM\0*"sv) || head.starts_with("II+\0"sv) ||
        head.starts_with("MM\0+"sv)) // + is BigTIFF
        return upright(path, open_tiff(path));
    if (head.starts_with("\x93NUMPY"sv))
        return open_npy(path, std::move(file));
    if (lower(head.substr(0, 5)) == "ncols")
        return open_asc(path, std::move(file));
    if (auto tga = open_tga(path, std::move(file))) // TGA files have no signature
        return tga;
    throw RequestError(
        fmt::format("'{}' is not a readable picture: expected PNG, JPEG, TGA, TIFF, OpenEXR, .npy or .asc{}",
                    path.string(), hint));
}

} // namespace gabor::image
