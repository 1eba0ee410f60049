#include "image/picture.hpp"

#include "system/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <string>

namespace gabor::image {

namespace {

constexpr double widest_asc = 65536;

// The keys that say what a file of well-known text beside a map does: https://www.ogc.org/standard/wkt-crs/
std::vector<double> unit_beside(const std::filesystem::path& map, std::vector<std::uint16_t>& keys) {
    std::ifstream file(std::filesystem::path(map).replace_extension(".prj"));
    std::string text(1 << 14, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (text.starts_with("GEOG")) {
        keys = {1, 1, 0, 1, 1024, 0, 1, 2};
    } else if (text.starts_with("PROJ")) {
        // The last unit is that of the projection: UNIT["Foot_US",0.3048006096012192]
        const std::size_t comma = text.find(',', text.rfind("UNIT["));
        double metres = 0;
        if (comma != text.npos &&
            system::from_chars(&text[comma + 1], text.data() + text.size(), metres).ec == std::errc()) {
            keys = {1, 1, 0, 3, 1024, 0, 1, 1, 3076, 0, 1, 32767, 3077, 34736, 1, 0};
            return {metres};
        }
    }
    return {};
}

// The number that a word is; "nan", which GDAL writes for no height, is one.
std::optional<double> value_of(const std::string& word) {
    double value = 0;
    const char* const end = word.data() + word.size();
    const auto found = system::from_chars(word.data() + (word[0] == '+'), end, value);
    return found.ec == std::errc() && found.ptr == end ? std::optional(value) : std::nullopt;
}

// https://desktop.arcgis.com/en/arcmap/latest/manage-data/raster-and-images/esri-ascii-raster-format.htm
class Asc : public PictureReader {
  public:
    Asc(const std::filesystem::path& path, File file) : path_(path), file_(std::move(file)) {
        std::map<std::string, double> header{{"nodata_value", -9999}};
        for (word_ = next();
             !word_.empty() && std::isalpha(static_cast<unsigned char>(word_[0])) && !value_of(word_);
             word_ = next()) {
            if (header.size() > 16)
                refuse_picture(path_, "it has a header of more than 16 lines");
            std::string name = word_;
            std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
            header[name] = number(next());
        }
        const auto given = [&](const char* name) {
            const auto found = header.find(name);
            return found != header.end() ? std::optional(found->second) : std::nullopt;
        };
        const double width = given("ncols").value_or(0), height = given("nrows").value_or(0);
        const double dx = given("cellsize").value_or(given("dx").value_or(0)), dy = given("dy").value_or(dx);
        if (!(std::min(width, height) >= 1 && std::max(width, height) <= widest_asc && dx > 0 && dy > 0))
            refuse_picture(path_, fmt::format("its header needs ncols and nrows from 1 to {}, and a cellsize "
                                              "above 0",
                                              widest_asc));
        Format format{.width = static_cast<int>(width),
                      .height = static_cast<int>(height),
                      .channels = 1,
                      .linear = true,
                      .bits = 32};
        format.missing = static_cast<float>(*given("nodata_value"));
        const double left = given("xllcorner").value_or(given("xllcenter").value_or(0) - dx / 2);
        const double bottom = given("yllcorner").value_or(given("yllcenter").value_or(0) - dy / 2);
        format.geo.pixel_scale = {dx, dy, 0};
        format.geo.tie_points = {0, 0, 0, left, bottom + dy * format.height, 0};
        format.geo.numbers = unit_beside(path, format.geo.keys);
        set_format(format);
    }

    void read_row(std::span<float> row) override {
        fill(row, [this] {
            const double value = number(word_);
            word_ = next();
            return static_cast<float>(value);
        });
        if (++row_ == format().height && !word_.empty())
            refuse_picture(path_, "it has more heights than its header says");
    }

  private:
    // Returns the next word, or nothing at the end of the file.
    std::string next() {
        std::string word;
        for (int c = std::fgetc(file_.get()); c != EOF; c = std::fgetc(file_.get())) {
            if (!std::isspace(c))
                word += static_cast<char>(c);
            else if (!word.empty())
                break;
            if (word.size() > 64)
                refuse_picture(path_, "it has a word of more than 64 letters");
        }
        return word;
    }

    double number(const std::string& word) const {
        if (word.empty())
            refuse_picture(path_, "it ends early");
        const std::optional<double> value = value_of(word);
        if (!value)
            refuse_picture(path_, fmt::format("'{}' is not a number", word));
        return *value;
    }

    std::filesystem::path path_;
    File file_;
    std::string word_; // the next
    int row_ = 0;
};

} // namespace

std::unique_ptr<PictureReader> open_asc(const std::filesystem::path& path, File file) {
    return std::make_unique<Asc>(path, std::move(file));
}

} // namespace gabor::image
