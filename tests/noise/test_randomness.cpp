// Tests the randomness of the impulses' hash words.

#include "../largest.hpp"
#include "randomness.hpp"
#include "reference/reference.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

using gabor::noise::impulse_word;
using gabor::test::chi_square;
using gabor::test::draws;
using gabor::test::far;

namespace {

struct Input {
    std::int32_t column;
    std::int32_t row;
    int index;
    std::uint32_t seed;

    std::uint32_t word() const { return impulse_word(column, row, index, seed); }
};

// Sequences of inputs as in pictures: over the cells of a square, over seeds, and over the impulses of cells.
Input in_square(std::uint64_t i) {
    const auto along = static_cast<std::int32_t>(i & 0x3fff);
    const auto across = static_cast<std::int32_t>(i >> 14);
    return {along - 8192, across - 4096, 0, 7};
}

Input over_seeds(std::uint64_t i) {
    return {3, -5, 0, static_cast<std::uint32_t>(i)};
}

Input over_impulses(std::uint64_t i) {
    return {static_cast<std::int32_t>(i >> 5 & 0xfff), static_cast<std::int32_t>(i >> 17),
            static_cast<int>(i & 31), 7};
}

struct Sequence {
    std::string_view name;
    Input (*input)(std::uint64_t);
};

constexpr std::array sequences{Sequence{"cells", in_square}, Sequence{"seeds", over_seeds},
                               Sequence{"impulses", over_impulses}};

// A field that the drop-in takes from a word. Tests use at most its six leading bits.
struct Field {
    std::string_view name;
    int lowest;
    int bits;

    std::uint32_t of(std::uint32_t word) const {
        return word >> (lowest + bits - std::min(bits, 6)) & ((1u << std::min(bits, 6)) - 1);
    }
    std::uint32_t values() const { return 1u << std::min(bits, 6); }
};

constexpr std::array fields{Field{"x", 8, 23}, Field{"y", 0, 23}, Field{"phase", 0, 8},
                            Field{"magnitude", 31, 1}, Field{"phase rate", 8, 3}};

} // namespace

TEST_CASE("flipping any bit of an input flips each bit of the word half the time", "[randomness]") {
    gabor::test::Largest largest;
    for (const Sequence& sequence : sequences) {
        for (int bit = 0; bit < 32 * 3 + 5; ++bit) {
            std::array<std::uint64_t, 32> turned{};
            const std::uint64_t count = std::max<std::uint64_t>(draws() / 64, 1 << 14);
            for (std::uint64_t i = 0; i < count; ++i) {
                Input input = sequence.input(i * 64);
                const std::uint32_t before = input.word();
                const std::uint32_t flip = 1u << bit % 32;
                if (bit < 32)
                    input.column = static_cast<std::int32_t>(static_cast<std::uint32_t>(input.column) ^ flip);
                else if (bit < 64)
                    input.row = static_cast<std::int32_t>(static_cast<std::uint32_t>(input.row) ^ flip);
                else if (bit < 96)
                    input.seed ^= flip;
                else
                    input.index ^= static_cast<int>(flip);
                const std::uint32_t changed = before ^ input.word();
                for (unsigned k = 0; k < 32; ++k)
                    turned[k] += changed >> k & 1;
            }
            for (unsigned k = 0; k < 32; ++k) {
                const double share = static_cast<double>(turned[k]) / static_cast<double>(count);
                largest.see(share, 0.5, 0.03,
                            fmt::format("{}, input bit {}, output bit {}", sequence.name, bit, k));
            }
        }
    }
    largest.check("avalanche");
}

TEST_CASE("the fields of words are uniform", "[randomness]") {
    gabor::test::Largest largest;
    for (const Sequence& sequence : sequences) {
        // Histograms of the twelve bits that start at each byte of the word.
        std::array<std::vector<std::uint64_t>, 4> counts;
        for (auto& field : counts)
            field.resize(4096);
        for (std::uint64_t i = 0; i < draws(); ++i) {
            const std::uint32_t word = sequence.input(i).word();
            for (unsigned k = 0; k < 4; ++k)
                ++counts[k][std::rotl(word, static_cast<int>(8 * k)) & 0xfff];
        }
        for (unsigned k = 0; k < 4; ++k)
            largest.see(chi_square(counts[k]), 0, far,
                        fmt::format("{}, bits from {}", sequence.name, (32 - 8 * k) % 32));
    }
    largest.check("uniformity");
}

TEST_CASE("the fields of one word are independent", "[randomness]") {
    gabor::test::Largest largest;
    for (const Sequence& sequence : sequences) {
        for (std::size_t a = 0; a < fields.size(); ++a) {
            for (std::size_t b = a + 1; b < fields.size(); ++b) {
                std::vector<std::uint64_t> counts(fields[a].values() * fields[b].values());
                for (std::uint64_t i = 0; i < draws(); ++i) {
                    const std::uint32_t word = sequence.input(i).word();
                    ++counts[fields[a].of(word) * fields[b].values() + fields[b].of(word)];
                }
                largest.see(chi_square(counts), 0, far,
                            fmt::format("{}, {} and {}", sequence.name, fields[a].name, fields[b].name));
            }
        }
    }
    largest.check("fields of a word");
}

TEST_CASE("the words of neighbours are independent", "[randomness]") {
    using Step = std::function<void(Input&)>;
    const std::vector<std::pair<std::string_view, Step>> steps{
        {"the next column", [](Input& input) { ++input.column; }},
        {"the next row", [](Input& input) { ++input.row; }},
        {"the diagonal", [](Input& input) { ++input.column, ++input.row; }},
        {"the other diagonal", [](Input& input) { ++input.column, --input.row; }},
        {"two columns on", [](Input& input) { input.column += 2; }},
        {"two rows on", [](Input& input) { input.row += 2; }},
        {"256 columns on", [](Input& input) { input.column += 256; }},
        {"column and row exchanged", [](Input& input) { std::swap(input.column, ++input.row); }},
        {"the next seed", [](Input& input) { ++input.seed; }},
        {"the next impulse", [](Input& input) { ++input.index; }}};
    gabor::test::Largest joint, linear;
    for (const auto& [name, step] : steps) {
        std::array<std::vector<std::uint64_t>, fields.size()> counts;
        std::array<double, fields.size()> product{};
        for (std::size_t f = 0; f < fields.size(); ++f)
            counts[f].resize(fields[f].values() * fields[f].values());
        for (std::uint64_t i = 0; i < draws(); ++i) {
            Input input = in_square(i);
            const std::uint32_t word = input.word();
            step(input);
            const std::uint32_t other = input.word();
            for (std::size_t f = 0; f < fields.size(); ++f) {
                const std::uint32_t a = fields[f].of(word);
                const std::uint32_t b = fields[f].of(other);
                ++counts[f][a * fields[f].values() + b];
                const double middle = 0.5 * (fields[f].values() - 1);
                product[f] += (a - middle) * (b - middle);
            }
        }
        for (std::size_t f = 0; f < fields.size(); ++f) {
            const double variance = (std::pow(fields[f].values(), 2) - 1) / 12;
            const std::string which = fmt::format("{}, {}", fields[f].name, name);
            joint.see(chi_square(counts[f]), 0, far, which);
            linear.see(product[f] / variance / std::sqrt(static_cast<double>(draws())), 0, far, which);
        }
    }
    joint.check("neighbours, jointly");
    linear.check("neighbours, correlation");
}

TEST_CASE("along a row of cells, each of the 2^32 words occurs once: the period is 2^32 cells",
          "[.][period]") {
    std::vector<std::uint64_t> seen(std::size_t{1} << 26);
    for (std::uint64_t column = 0; column < std::uint64_t{1} << 32; ++column) {
        const std::uint32_t word =
            impulse_word(static_cast<std::int32_t>(static_cast<std::uint32_t>(column)), -77, 0, 7);
        seen[word >> 6] |= std::uint64_t{1} << (word & 63);
    }
    CHECK(std::ranges::all_of(seen, [](std::uint64_t bits) { return ~bits == 0; }));
}
