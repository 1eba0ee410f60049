#include "image/deflater.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace gabor::image {

namespace {

constexpr std::size_t longest_block = 65535; // bytes of a stored block
constexpr std::uint16_t end_of_block = 256;
constexpr std::size_t shortest_run = 3;
constexpr std::size_t longest_run = 258;
constexpr float code_bits = 800;     // that another code must save
constexpr float most_saved = 0.985f; // a block that would not become smaller than this share is stored

// The symbol of a length, and its extra bits.
struct Length {
    std::uint16_t symbol = 0;
    std::uint8_t extra_bits = 0;
    std::uint8_t extra = 0;
};

// Each four symbols have one more extra bit, but 258 has a symbol of its own (RFC 1951, 3.2.5).
constexpr std::array<Length, longest_run + 1> lengths = [] {
    std::array<Length, longest_run + 1> table{};
    std::size_t length = shortest_run;
    for (std::uint16_t symbol = 257; symbol < 285; ++symbol) {
        const auto bits = static_cast<std::uint8_t>(symbol < 265 ? 0 : (symbol - 261) / 4);
        for (unsigned extra = 0; extra < 1u << bits && length < longest_run; ++extra)
            table[length++] = {symbol, bits, static_cast<std::uint8_t>(extra)};
    }
    table[longest_run] = {285, 0, 0};
    return table;
}();

// The number of bits that an ideal code needs. log2 is a line between powers of two, at most 0.09 too small.
template <std::size_t N>
float ideal_bits(const std::array<std::uint32_t, N>& counts) {
    const auto weighted = [](std::uint32_t count) {
        const auto value = static_cast<float>(count);
        return value * (static_cast<float>(std::bit_cast<std::int32_t>(value)) * 0x1p-23f - 126.96f);
    };
    float sum = 0;
    std::uint32_t all = 0;
    for (const std::uint32_t count : counts) {
        sum += weighted(count);
        all += count;
    }
    return weighted(all) - sum;
}

// Tells by a sample whether bytes are so evenly distributed that no code would save 2 %: by how many pairs
// are equal.
bool is_noise(std::span<const std::uint8_t> bytes) {
    constexpr std::size_t sampled = 512;
    constexpr std::uint32_t pairs =
        sampled * sampled / 256 * 115 / 100; // of n^2 / 256 for noise, counted twice
    if (bytes.size() < sampled)
        return false;
    std::array<std::uint16_t, 256> counts{};
    std::uint32_t equal = 0;
    for (std::size_t i = 0; i < sampled; ++i)
        equal += 2u * counts[bytes[i * (bytes.size() / sampled)]]++;
    return equal < pairs;
}

// A prefix code: the bits of each symbol, first bit lowest, and their number.
template <std::size_t N>
struct Code {
    std::array<std::uint16_t, N> bits{};
    std::array<std::uint8_t, N> lengths{};
};

// Returns the lengths of Huffman's code for symbols with these counts, at most `longest`.
template <std::size_t N>
std::array<std::uint8_t, N> huffman_lengths(std::array<std::uint32_t, N> counts, int longest) {
    std::array<std::uint8_t, N> result{};
    for (;;) {
        // Leaves by their count, then the nodes that join two, whose counts only grow.
        std::array<std::uint32_t, 2 * N> weights;
        std::array<std::uint16_t, 2 * N> parents;
        std::array<std::uint32_t, N> order;
        std::size_t leaves = 0;
        for (std::uint32_t i = 0; i < N; ++i)
            if (counts[i] > 0)
                order[leaves++] = counts[i] << 9 | i;
        std::sort(order.begin(), order.begin() + leaves);
        if (leaves == 1) {
            result[order[0] & 511] = 1;
            return result;
        }
        for (std::size_t i = 0; i < leaves; ++i)
            weights[i] = order[i] >> 9;
        std::size_t leaf = 0, inner = leaves, end = leaves;
        for (; end < 2 * leaves - 1; ++end) {
            weights[end] = 0;
            for (int k = 0; k < 2; ++k) {
                const bool take_leaf = leaf < leaves && (inner == end || weights[leaf] <= weights[inner]);
                const std::size_t taken = take_leaf ? leaf++ : inner++;
                weights[end] += weights[taken];
                parents[taken] = static_cast<std::uint16_t>(end);
            }
        }
        std::array<std::uint8_t, 2 * N> depths;
        depths[end - 1] = 0;
        for (std::size_t i = end - 1; i-- > 0;)
            depths[i] = static_cast<std::uint8_t>(depths[parents[i]] + 1);
        if (depths[0] <= longest) { // of the rarest symbol
            for (std::size_t i = 0; i < leaves; ++i)
                result[order[i] & 511] = depths[i];
            return result;
        }
        for (std::uint32_t& count : counts)
            count = (count + 1) / 2; // no longer exact, but shorter
    }
}

template <std::size_t N>
Code<N> code_of(const std::array<std::uint32_t, N>& counts, int longest) {
    Code<N> code;
    code.lengths = huffman_lengths(counts, longest);
    std::array<std::uint32_t, 17> next{}; // the canonical code of RFC 1951, 3.2.2
    for (const std::uint8_t length : code.lengths)
        ++next[length + 1u];
    next[1] = 0;
    for (std::size_t i = 1; i < next.size(); ++i)
        next[i] = (next[i] + next[i - 1]) << (i > 1 ? 1 : 0);
    for (std::size_t i = 0; i < N; ++i) {
        std::uint32_t bits = code.lengths[i] > 0 ? next[code.lengths[i]]++ : 0;
        for (int k = 0; k < code.lengths[i]; ++k, bits >>= 1)
            code.bits[i] = static_cast<std::uint16_t>(code.bits[i] << 1 | (bits & 1));
    }
    return code;
}

// A symbol of the code that stores lengths of codes: a length, or a repetition with extra bits.
struct Repetition {
    std::uint8_t symbol;
    std::uint8_t extra_bits = 0;
    std::uint8_t extra = 0;
};

std::vector<Repetition> repetitions_of(std::span<const std::uint8_t> lengths) {
    std::vector<Repetition> result;
    for (std::size_t i = 0; i < lengths.size();) {
        const std::uint8_t length = lengths[i];
        std::size_t run = 1;
        while (i + run < lengths.size() && lengths[i + run] == length)
            ++run;
        i += run;
        if (length != 0) {
            result.push_back({length});
            --run;
        }
        const std::size_t most = length == 0 ? 138 : 6;
        while (run >= 3) {
            const std::size_t part = std::min(run, most);
            run -= part;
            if (length != 0)
                result.push_back({16, 2, static_cast<std::uint8_t>(part - 3)});
            else if (part <= 10)
                result.push_back({17, 3, static_cast<std::uint8_t>(part - 3)});
            else
                result.push_back({18, 7, static_cast<std::uint8_t>(part - 11)});
        }
        result.insert(result.end(), run, Repetition{length});
    }
    return result;
}

} // namespace

void Deflater::Block::clear() {
    bytes.clear();
    symbols.clear();
    counts.fill(0);
    counts[end_of_block] = 1;
    bits = 0;
    noise = false;
}

// Appends bytes. `before` is the byte before them, then the last of them.
void Deflater::Block::take(std::span<const std::uint8_t> added, int& before) {
    bytes.insert(bytes.end(), added.begin(), added.end());
    if (noise = is_noise(added); noise) {
        before = added.back();
        return;
    }
    symbols.resize(symbols.size() + added.size()); // room for no run
    auto symbol = symbols.end() - static_cast<std::ptrdiff_t>(added.size());
    int last = before;
    for (std::size_t i = 0; i < added.size();) {
        const std::uint8_t byte = added[i];
        // One branch, because each alone would often be mispredicted.
        if (i + shortest_run <= added.size() &&
            ((byte ^ last) | (byte ^ added[i + 1]) | (byte ^ added[i + 2])) == 0) {
            const std::size_t most = std::min(added.size() - i, longest_run);
            std::size_t run = shortest_run;
            while (run < most && added[i + run] == byte)
                ++run;
            *symbol++ = static_cast<std::uint16_t>(256 + run);
            ++counts[lengths[run].symbol];
            i += run;
        } else {
            *symbol++ = byte;
            ++counts[byte];
            last = byte;
            ++i;
        }
    }
    before = last;
    symbols.erase(symbol, symbols.end());
    bits = ideal_bits(counts);
}

bool Deflater::Block::joins(const Block& next) const {
    if (noise != next.noise || bytes.size() + next.bytes.size() > longest_block)
        return false;
    auto sums = counts;
    for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i] += next.counts[i];
    return noise || ideal_bits(sums) <= bits + next.bits + code_bits;
}

void Deflater::Block::append(const Block& next) {
    bytes.insert(bytes.end(), next.bytes.begin(), next.bytes.end());
    if (noise)
        return;
    symbols.insert(symbols.end(), next.symbols.begin(), next.symbols.end());
    for (std::size_t i = 0; i < counts.size(); ++i)
        counts[i] += next.counts[i];
    counts[end_of_block] = 1;
    bits = ideal_bits(counts);
}

Deflater::Deflater() : output_{0x78, 0x01} {
    waiting_.clear();
}

void Deflater::add_to_sums(std::span<const std::uint8_t> bytes) {
    constexpr std::size_t summed = 5552; // bytes whose sums fit into 32 bits (RFC 1950)
    for (; !bytes.empty(); bytes = bytes.subspan(std::min(summed, bytes.size()))) {
        const auto count = static_cast<std::uint32_t>(std::min(summed, bytes.size()));
        std::uint32_t low = 0, high = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            low += bytes[i];
            high += (count - i) * bytes[i];
        }
        high_sum_ = (high_sum_ + count * low_sum_ % 65521 + high % 65521) % 65521;
        low_sum_ = (low_sum_ + low) % 65521;
    }
}

void Deflater::write(std::span<const std::uint8_t> bytes) {
    add_to_sums(bytes);
    while (!bytes.empty()) {
        const auto part = bytes.first(std::min(bytes.size(), longest_block));
        bytes = bytes.subspan(part.size());
        next_.clear();
        next_.take(part, before_);
        if (waiting_.joins(next_)) {
            waiting_.append(next_);
        } else {
            write_block(waiting_, false);
            std::swap(waiting_, next_);
        }
    }
}

void Deflater::finish() {
    write_block(waiting_, true);
    align();
    for (const std::uint32_t sum : {high_sum_, low_sum_}) {
        output_.push_back(static_cast<std::uint8_t>(sum >> 8));
        output_.push_back(static_cast<std::uint8_t>(sum));
    }
}

void Deflater::put(std::uint64_t bits, int count) {
    bits_ |= bits << bit_count_;
    bit_count_ += count;
    while (bit_count_ >= 8) {
        output_.push_back(static_cast<std::uint8_t>(bits_));
        bits_ >>= 8;
        bit_count_ -= 8;
    }
}

// Puts the bits of each symbol.
void Deflater::put_all(std::span<const std::uint16_t> symbols, std::span<const Piece> pieces) {
    const std::size_t before = output_.size();
    output_.resize(before + 3 * symbols.size() + 8); // a piece has at most 21 bits
    std::uint8_t* at = &output_[before];
    std::uint64_t bits = bits_;
    auto count = static_cast<std::uint32_t>(bit_count_);
    for (const std::uint16_t symbol : symbols) {
        const auto& [added, length] = pieces[symbol];
        bits |= std::uint64_t{added} << count;
        count += length;
        if (count >= 32) {
            for (int k = 0; k < 4; ++k)
                at[k] = static_cast<std::uint8_t>(bits >> 8 * k);
            at += 4;
            bits >>= 32;
            count -= 32;
        }
    }
    output_.resize(static_cast<std::size_t>(at - output_.data()));
    bits_ = bits;
    bit_count_ = static_cast<int>(count);
    put(0, 0);
}

void Deflater::align() {
    put(0, -bit_count_ & 7);
}

void Deflater::write_block(const Block& block, bool last) {
    if (block.noise || block.bits > most_saved * 8 * static_cast<float>(block.bytes.size()))
        write_stored(block.bytes, last);
    else
        write_coded(block, last);
}

void Deflater::write_stored(std::span<const std::uint8_t> bytes, bool last) {
    put(last ? 1 : 0, 3);
    align();
    const auto size = static_cast<std::uint32_t>(bytes.size());
    put(size | (~size & 0xffffu) << 16, 32);
    output_.insert(output_.end(), bytes.begin(), bytes.end());
}

// Writes a block with a code of its own, and its only distance, 1, as one bit.
void Deflater::write_coded(const Block& block, bool last) {
    constexpr int longest_code = 15;
    const Code<286> code = code_of(block.counts, longest_code);
    std::size_t used = code.lengths.size();
    while (code.lengths[used - 1] == 0)
        --used;
    std::vector<std::uint8_t> stored(code.lengths.begin(), code.lengths.begin() + used);
    stored.push_back(1); // the distance's
    const std::vector<Repetition> repetitions = repetitions_of(stored);
    std::array<std::uint32_t, 19> counts{};
    for (const Repetition& each : repetitions)
        ++counts[each.symbol];
    const Code<19> code_of_lengths = code_of(counts, 7);
    constexpr std::array<std::uint8_t, 19> order{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                 11, 4,  12, 3, 13, 2, 14, 1, 15};
    std::size_t listed = order.size();
    while (code_of_lengths.lengths[order[listed - 1]] == 0)
        --listed;
    put(last ? 5 : 4, 3);
    put(used - 257, 5);
    put(0, 5); // one distance
    put(listed - 4, 4);
    for (std::size_t i = 0; i < listed; ++i)
        put(code_of_lengths.lengths[order[i]], 3);
    for (const Repetition& each : repetitions) {
        put(code_of_lengths.bits[each.symbol], code_of_lengths.lengths[each.symbol]);
        put(each.extra, each.extra_bits);
    }
    std::array<Piece, 256 + longest_run + 1> pieces{};
    for (std::size_t byte = 0; byte < 256; ++byte)
        pieces[byte] = {code.bits[byte], code.lengths[byte]};
    for (std::size_t run = shortest_run; run <= longest_run; ++run) {
        const auto& [symbol, extra_bits, extra] = lengths[run];
        const std::uint32_t length = code.lengths[symbol];
        pieces[256 + run] = {code.bits[symbol] | std::uint32_t{extra} << length,
                             length + extra_bits + 1}; // and the distance, 0
    }
    put_all(block.symbols, pieces);
    put(code.bits[end_of_block], code.lengths[end_of_block]);
}

} // namespace gabor::image
