#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace gabor::test {

/// Returns the calls that a golden file lists.
inline std::vector<std::string> calls(const std::string& path) {
    std::vector<std::string> calls;
    std::ifstream file(path);
    std::string line;
    std::getline(file, line); // the version
    while (std::getline(file, line))
        calls.push_back(line.substr(0, line.rfind(": ")));
    return calls;
}

/// Whether a call's result is within the range that the documentation promises for arbitrary arguments.
inline bool is_in_range(const std::string& call, int point, float value) {
    const auto has = [&](const char* word) { return call.find(word) != std::string::npos; };
    const int kind = std::abs(point) % 5; // as in functions.glsl
    const bool is_sine =
        has("noise_quadrature(s.p, s.frequency"); // a sine's quadrature grows at low frequency
    if (kind == 2 &&
        (has("place") || has("ground") || has("tile") || has("block"))) // no promise for tiny periods
        return true;
    const bool unlimited = has("field") || has("gradient") || has("3d(") || has("node_position") ||
                           has("gabor_er") || has("gabor_terrain") || (kind == 0 && is_sine);
    // Compares integers, because compilers may assume that there is no NaN. As an integer, NaN is larger than
    // any number.
    return (std::bit_cast<std::uint32_t>(value) & 0x7fffffffu) <=
           std::bit_cast<std::uint32_t>(unlimited ? std::numeric_limits<float>::max() : 200.0f);
}

/// The results of calls at 64 points, for comparison with a golden file.
class Rows {
  public:
    static constexpr int points = 64;
    static constexpr int numbers = 16; ///< per line of the file, each a sum over every 16th point

    /// Starts a point: the values seen from now on belong to it.
    void begin(int point) {
        point_ = point;
        call_ = 0;
    }

    /// Records the point's next value. `call` may be empty if it is unknown.
    void see(const std::string& call, double value) {
        if (call_ == rows_.size())
            rows_.push_back({call, {}});
        constexpr double weights[points / numbers] = {1, -0.7, 0.8, -0.6};
        rows_[call_++].sums[static_cast<std::size_t>(point_ % numbers)] += weights[point_ / numbers] * value;
    }

    /// Whether the file at `path` has the same calls and the same sums within `tolerance`, or within `far`
    /// for the last quarter of a line's sums, whose points are far from the origin. Prints the differences.
    /// With GABOR_GOLDEN=write in the environment, writes the file instead and fails.
    bool compare(const std::string& path, double tolerance, double far) const {
        const char* mode = std::getenv("GABOR_GOLDEN");
        if (mode && std::string(mode) == "write")
            return write(path);
        std::ifstream file(path);
        std::string line;
        std::getline(file, line);
        if (line != version) {
            std::printf("%s starts with '%s' instead of '%s'\n", path.c_str(), line.c_str(), version);
            return false;
        }
        bool same = !rows_.empty();
        double largest = 0;
        std::string where = "nowhere";
        for (const Row& row : rows_) {
            std::getline(file, line);
            const std::size_t end = line.rfind(": ");
            if (end == std::string::npos || (!row.call.empty() && line.substr(0, end) != row.call)) {
                std::printf("%s has '%s' instead of '%s'\n", path.c_str(), line.substr(0, end).c_str(),
                            row.call.c_str());
                return false;
            }
            std::istringstream stream(line.substr(end + 2));
            for (std::size_t i = 0; i < numbers; ++i) {
                double expected = NAN;
                stream >> expected;
                const double difference = std::abs(row.sums[i] - expected);
                const double scaled = difference / (i < numbers * 3 / 4 ? tolerance : far);
                same &= scaled <= 1; // false for NaN
                if (!(scaled <= largest) && !std::isnan(largest)) {
                    largest = scaled;
                    where = line.substr(0, end) + ", number " + std::to_string(i);
                }
            }
        }
        if (std::getline(file, line)) {
            std::printf("%s has more calls: %s\n", path.c_str(), line.c_str());
            return false;
        }
        std::printf("%s: %zu calls, largest difference %.2g of the tolerance at %s\n", path.c_str(),
                    rows_.size(), largest, where.c_str());
        return same;
    }

  private:
    static constexpr const char* version = "version " GABOR_VERSION;

    struct Row {
        std::string call;
        std::array<double, numbers> sums;
    };

    bool write(const std::string& path) const {
        std::ofstream file(path);
        file << version << "\n";
        for (const Row& row : rows_) {
            file << row.call << ":";
            for (const double sum : row.sums) {
                char text[32];
                std::snprintf(text, sizeof text, " %.6f", sum);
                file << text;
            }
            file << "\n";
        }
        std::printf("wrote %s: review its diff\n", path.c_str());
        return false;
    }

    std::vector<Row> rows_;
    std::size_t call_ = 0;
    int point_ = 0;
};

} // namespace gabor::test
