#include "image/deflater.hpp"

#include <catch2/catch.hpp>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using gabor::image::Deflater;
using Bytes = std::vector<std::uint8_t>;

namespace {

// Compresses pieces, and checks that zlib returns them. Returns the compressed size.
std::size_t compressed(const std::vector<Bytes>& pieces) {
    Deflater deflater;
    Bytes all, stream;
    for (const Bytes& piece : pieces) {
        deflater.write(piece);
        all.insert(all.end(), piece.begin(), piece.end());
        stream.insert(stream.end(), deflater.output().begin(), deflater.output().end());
        deflater.output().clear();
    }
    deflater.finish();
    stream.insert(stream.end(), deflater.output().begin(), deflater.output().end());
    Bytes read(all.size() + 1);
    uLongf size = read.size();
    REQUIRE(uncompress(read.data(), &size, stream.data(), stream.size()) == Z_OK);
    read.resize(size);
    CHECK(read == all);
    return stream.size();
}

Bytes noise(std::size_t size, double deviation) {
    std::minstd_rand random(5);
    std::normal_distribution<double> normal(0, deviation);
    Bytes bytes(size);
    for (std::uint8_t& byte : bytes)
        byte = static_cast<std::uint8_t>(std::lround(normal(random)));
    return bytes;
}

} // namespace

TEST_CASE("zlib inflates what a Deflater compresses", "[deflater]") {
    SECTION("nothing, and few bytes") {
        compressed({});
        compressed({{7}});
        compressed({{0, 0, 0, 0}, {}, {0, 0}, {1}});
    }
    SECTION("runs of each length, across pieces too") {
        std::vector<Bytes> pieces;
        for (std::size_t run = 1; run < 600; ++run)
            pieces.emplace_back(run, static_cast<std::uint8_t>(run / 2));
        CHECK(compressed(pieces) < 4000);
    }
    SECTION("noise, which is stored") {
        CHECK(compressed({noise(200000, 300)}) < 200100);
    }
    SECTION("values whose rarest has a longer code than deflate accepts") {
        Bytes bytes;
        for (std::size_t symbol = 0, count = 1, next = 1; bytes.size() < 60000; ++symbol) {
            for (std::size_t i = 0; i < count; ++i)
                bytes.push_back(static_cast<std::uint8_t>(3 * symbol));
            std::swap(count, next);
            next += count;
        }
        std::shuffle(bytes.begin(), bytes.end(), std::minstd_rand(3));
        compressed({bytes});
    }
}

TEST_CASE("A Deflater needs few more bits than an ideal code", "[deflater]") {
    // The entropy of a normal distribution of deviation s is log2(s sqrt(2 pi e)) bits.
    for (const double deviation : {2.0, 8.0, 20.0}) {
        const Bytes bytes = noise(1 << 20, deviation);
        const double ideal = std::log2(deviation * std::sqrt(2 * 3.14159265 * 2.71828183)) / 8;
        const auto size = static_cast<double>(compressed({bytes}));
        CHECK(size < 1.03 * ideal * static_cast<double>(bytes.size()));
    }
    // Rows with a code of their own between rows of noise, as in an EXR.
    std::vector<Bytes> rows;
    for (int i = 0; i < 50; ++i) {
        rows.push_back(noise(4096, 300));
        rows.push_back(noise(4096, 1));
    }
    CHECK(compressed(rows) < 50 * (4110 + 4096 * 22 / 80 + 60));
}
