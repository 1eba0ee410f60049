#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gabor::image {

/// Compresses bytes to a zlib stream (RFC 1950 and 1951) of runs and Huffman codes alone: on noise, other
/// matches save little and take most of the time. For the EXR of maps of wood, zlib needs 2.1 times as long
/// with Z_RLE, for 9 % more bytes, and 4.3 times for as few; libdeflate, which cannot write a stream in
/// parts, 1.5 times.
class Deflater {
  public:
    Deflater();

    /// Compresses bytes that are alike, such as the high bytes of a row: these and the neighbours that
    /// resemble them share a code. At most 2^15 bytes give the best codes.
    void write(std::span<const std::uint8_t> bytes);
    /// Ends the stream.
    void finish();
    /// The compressed bytes so far. They may be removed.
    std::vector<std::uint8_t>& output() { return output_; }

  private:
    /// Bytes that share a code, also as symbols: a byte, or 256 plus the length of a run of the byte before.
    struct Block {
        std::vector<std::uint8_t> bytes;
        std::vector<std::uint16_t> symbols;
        std::array<std::uint32_t, 286> counts; ///< of the literals, the block's end and the codes of lengths
        float bits;                            ///< estimated size
        bool noise;                            ///< whether it is stored as it is, without symbols

        void clear();
        void take(std::span<const std::uint8_t> added, int& before);
        bool joins(const Block& next) const; ///< whether both need fewer bits with one code
        void append(const Block& next);
    };

    /// Bits, lowest first, and their number.
    struct Piece {
        std::uint32_t bits = 0;
        std::uint32_t count = 0;
    };

    void add_to_sums(std::span<const std::uint8_t> bytes);
    void put(std::uint64_t bits, int count);
    void put_all(std::span<const std::uint16_t> symbols, std::span<const Piece> pieces);
    void align();
    void write_block(const Block& block, bool last);
    void write_stored(std::span<const std::uint8_t> bytes, bool last);
    void write_coded(const Block& block, bool last);

    std::vector<std::uint8_t> output_;
    std::uint64_t bits_ = 0; ///< that wait for a whole byte, lowest first
    int bit_count_ = 0;
    Block waiting_; ///< the next bytes may join it
    Block next_;
    int before_ = -1;           ///< the byte before, or -1 for none
    std::uint32_t low_sum_ = 1; ///< of Adler-32
    std::uint32_t high_sum_ = 0;
};

} // namespace gabor::image
