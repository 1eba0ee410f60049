#include "image/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <regex>
#include <string>

namespace gabor::image {

namespace {

constexpr int widest_npy = 65536;

// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
class Npy : public PictureReader {
  public:
    Npy(const std::filesystem::path& path, File file) : path_(path), file_(std::move(file)) {
        std::array<unsigned char, 12> start{};
        read(start.data(), 10);
        std::size_t length = start[8] + 256u * start[9];
        if (start[6] > 1) { // four bytes hold the length
            read(&start[10], 2);
            length += 65536u * start[10] + 16777216u * start[11];
        }
        if (length > 4096) // std::regex recurses
            refuse_picture(path_, "it has a header of more than 4 KiB");
        std::string header(length, '\0');
        read(header.data(), length);
        std::smatch found;
        const auto find = [&](const char* pattern) {
            return std::regex_search(header, found, std::regex(pattern));
        };
        if (!find("'descr': *'([<>|=])([fiu])([1248])'"))
            refuse_picture(path_, "expected an array of integers or floats");
        const std::endian order = found[1] == ">" ? std::endian::big : std::endian::little;
        swapped_ = order != std::endian::native && found[1] != "|";
        kind_ = *found[2].first;
        size_ = static_cast<std::size_t>(*found[3].first - '0');
        if (!find("'fortran_order': *False"))
            refuse_picture(path_,
                           "its rows are not stored one after the other: save numpy.ascontiguousarray");
        if (!find("'shape': *[(]([0-9]{1,9}), *([0-9]{1,9}),?[)]"))
            refuse_picture(path_, "expected an array of two dimensions");
        Format format{.width = std::stoi(found[2]),
                      .height = std::stoi(found[1]),
                      .channels = 1,
                      .linear = true,
                      .bits = 32};
        if (std::min(format.width, format.height) < 1 || std::max(format.width, format.height) > widest_npy)
            refuse_picture(path_, fmt::format("it has {0} x {1} values; at most {2} x {2} are supported",
                                              format.width, format.height, widest_npy));
        if (kind_ == 'f' && size_ < 4)
            refuse_picture(path_, "it has 16-bit floats; expected 32 or 64 bits");
        set_format(format);
        bytes_.resize(size_ * static_cast<std::size_t>(format.width));
    }

    void read_row(std::span<float> row) override {
        read(bytes_.data(), bytes_.size());
        fill(row, [this, at = bytes_.data()]() mutable {
            std::array<unsigned char, 8> bytes{};
            std::memcpy(bytes.data(), at, size_);
            at += size_;
            if (swapped_)
                std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size_));
            if (kind_ == 'f')
                return size_ == 4 ? as<float>(bytes) : as<double>(bytes);
            if (kind_ == 'u')
                return as<std::uint64_t>(bytes);
            return size_ == 1   ? as<std::int8_t>(bytes)
                   : size_ == 2 ? as<std::int16_t>(bytes)
                   : size_ == 4 ? as<std::int32_t>(bytes)
                                : as<std::int64_t>(bytes);
        });
    }

  private:
    template <typename Value>
    static float as(const std::array<unsigned char, 8>& bytes) {
        Value value;
        std::memcpy(&value, bytes.data(), sizeof value);
        return static_cast<float>(value);
    }

    void read(void* to, std::size_t count) {
        if (std::fread(to, 1, count, file_.get()) != count)
            refuse_picture(path_, "it ends early");
    }

    std::filesystem::path path_;
    File file_;
    bool swapped_ = false;
    char kind_ = 'f';
    std::size_t size_ = 4; // of a value, in bytes
    std::vector<unsigned char> bytes_;
};

} // namespace

std::unique_ptr<PictureReader> open_npy(const std::filesystem::path& path, File file) {
    return std::make_unique<Npy>(path, std::move(file));
}

} // namespace gabor::image
