#pragma once

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gabor::test {

/// A file of numbers that this version of the noise gives: 8 x 8 blocks by name. They are compared, or
/// written where the environment says GABOR_GOLDEN=write.
class Golden {
  public:
    static constexpr std::size_t side = 8;

    /// `name` of a file in tests/golden.
    explicit Golden(std::string_view name) : path_(fmt::format("{}/{}.txt", GABOR_GOLDEN_FOLDER, name)) {
        const char* mode = std::getenv("GABOR_GOLDEN");
        writing_ = mode && std::string_view(mode) == "write";
        if (!writing_)
            read();
    }

    /// Compares `value(i)`, i = row * side + column, with the block of that name, each within `tolerance`.
    template <typename Value>
    void block(const std::string& name, double tolerance, const Value& value) {
        std::vector<double> values;
        for (std::size_t i = 0; i < side * side; ++i)
            values.push_back(static_cast<double>(value(i)));
        if (writing_) {
            written_ += name + "\n";
            for (std::size_t i = 0; i < side * side; ++i)
                written_ += fmt::format("{:.{}g}{}", values[i], tolerance == 0 ? 10 : 7,
                                        i % side == side - 1 ? "\n" : " ");
            return;
        }
        const auto expected = blocks_.find(name);
        INFO(path_ << ": " << name);
        REQUIRE(expected != blocks_.end());
        for (std::size_t i = 0; i < side * side; ++i) {
            INFO("column " << i % side << ", row " << i / side << ": " << values[i] << " instead of "
                           << expected->second[i]);
            const double difference = std::abs(values[i] - expected->second[i]);
            REQUIRE(difference <= tolerance); // not of a NaN
            if (tolerance > 0)
                largest_ = std::max(largest_, difference / tolerance);
        }
        ++seen_;
    }

    /// Every block of the file must have been seen.
    void finish() {
        if (writing_) {
            std::ofstream(path_) << "version " << GABOR_VERSION << "\n" << written_;
            FAIL(path_ << " is written: look at what changed, and run the test without GABOR_GOLDEN");
        }
        fmt::print("{}: {} blocks, the largest difference {:.3f} of its tolerance\n", path_, seen_, largest_);
        CHECK(seen_ == blocks_.size());
    }

  private:
    void read() {
        std::ifstream file(path_);
        std::string line;
        std::getline(file, line);
        INFO(path_ << ": these are the pixels of another version");
        REQUIRE(line == std::string("version ") + GABOR_VERSION);
        while (std::getline(file, line)) {
            std::vector<double>& block = blocks_[line];
            REQUIRE(block.empty());
            for (double value = 0; block.size() < side * side && file >> value;)
                block.push_back(value);
            REQUIRE(block.size() == side * side);
            file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
        }
        REQUIRE(!blocks_.empty());
    }

    std::string path_;
    bool writing_ = false;
    std::string written_;
    std::map<std::string, std::vector<double>> blocks_;
    std::size_t seen_ = 0;
    double largest_ = 0;
};

} // namespace gabor::test
