#include "study/table.hpp"

#include "error.hpp"
#include "image/output_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>

namespace gabor::study {

namespace {

// FNV-1a.
std::uint32_t hash(std::string_view text) {
    std::uint32_t word = 0x811c9dc5u;
    for (const char c : text)
        word = (word ^ static_cast<unsigned char>(c)) * 0x01000193u;
    return word;
}

std::string label(const Table& table, const Row& row) {
    return fmt::format("{:08x} {}", hash(table.columns), row.key);
}

// How many numbers a row has: the columns that its text does not fill.
std::size_t numbers_of(const Table& table, const Row& row) {
    return static_cast<std::size_t>(std::ranges::count(table.columns, ',') -
                                    std::ranges::count(row.key, ','));
}

// ` number number ...`, nothing where anything else stands there.
std::optional<Numbers> parse_numbers(std::string_view text) {
    Numbers numbers;
    while (text.starts_with(' ')) {
        text.remove_prefix(1);
        const auto [end, error] =
            std::from_chars(text.data(), text.data() + text.size(), numbers.emplace_back());
        if (error != std::errc())
            return std::nullopt;
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    return text.empty() ? std::optional(numbers) : std::nullopt;
}

} // namespace

Journal::Journal(const std::filesystem::path& folder, const std::string& study)
    : path_(folder / "study.part") {
    std::ifstream in(path_);
    std::string line;
    if (std::getline(in, line) && line == study && !in.eof()) {
        // A line counts when its end is there: `label: number number ...`. Of two with one label the later
        // does.
        while (std::getline(in, line) && !in.eof()) {
            const std::size_t colon = line.find(": ");
            if (colon == std::string::npos)
                continue;
            if (const auto numbers = parse_numbers(std::string_view(line).substr(colon + 1)))
                rows_[line.substr(0, colon)] = *numbers;
        }
    }
    in.close();
    std::ofstream out(path_, std::ios::trunc);
    out << study << '\n';
    for (const auto& [name, numbers] : rows_)
        out << fmt::format("{}: {}\n", name, fmt::join(numbers, " "));
    if (!out.flush())
        throw RequestError(
            fmt::format("cannot write in '{}': -o takes a folder that can be written", folder.string()));
}

const Numbers* Journal::find(const Table& table, const Row& row) const {
    const auto found = rows_.find(label(table, row));
    return found == rows_.end() || found->second.size() != numbers_of(table, row) ? nullptr : &found->second;
}

void Journal::add(const Table& table, const Row& row, const Numbers& numbers) {
    std::ofstream out(path_, std::ios::app);
    out << fmt::format("{}: {}\n", label(table, row), fmt::join(numbers, " "));
    if (!out.flush())
        throw std::runtime_error(fmt::format("cannot write '{}'", path_.string()));
    rows_[label(table, row)] = numbers;
}

void Journal::remove() {
    std::filesystem::remove(path_);
}

void write_table(const Table& table, const std::filesystem::path& folder, Journal& journal,
                 const std::function<void(double)>& advance) {
    std::vector<Numbers> numbers;
    for (const Row& row : table.rows) {
        if (!journal.find(table, row)) {
            journal.add(table, row, row.measure(hash(row.key)));
            advance(row.cost);
        }
        numbers.push_back(*journal.find(table, row));
    }
    if (table.derive)
        table.derive(numbers);
    std::string text = table.columns + (table.derived.empty() ? "" : "," + table.derived) + '\n';
    for (std::size_t i = 0; i < numbers.size(); ++i)
        text += fmt::format("{},{:.6g}\n", table.rows[i].key, fmt::join(numbers[i], ","));
    image::OutputFile file(folder / (table.name + ".csv"));
    file.write(std::as_bytes(std::span(text)));
    file.commit();
}

} // namespace gabor::study
