#include "study/table.hpp"

#include "error.hpp"
#include "image/output_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

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

// What one part measures of a study: rows with one label once.
struct Share {
    struct Entry {
        const Table* table;
        const Row* row;
    };
    std::vector<Entry> rows;
    double cost = 0;
};

Share share_of(std::span<const Table> tables, const Part& part) {
    std::vector<Share::Entry> rows;
    std::set<std::string> labels;
    for (const Table& table : tables)
        for (const Row& row : table.rows)
            if (labels.insert(label(table, row)).second)
                rows.push_back({&table, &row});
    std::ranges::stable_sort(rows, std::ranges::greater(), [](const auto& entry) { return entry.row->cost; });
    std::vector<Share> shares(static_cast<std::size_t>(part.count));
    for (const Share::Entry& entry : rows) {
        // Rows that cost nothing are spread as well.
        Share& least = *std::ranges::min_element(
            shares, {}, [](const Share& share) { return std::pair(share.cost, share.rows.size()); });
        least.rows.push_back(entry);
        least.cost += entry.row->cost;
    }
    return shares[static_cast<std::size_t>(part.index - 1)];
}

} // namespace

std::optional<Record> read_record(const std::filesystem::path& path) {
    std::ifstream in(path);
    Record record;
    // A line counts when its end is there.
    const auto next = [&](std::string& line) { return std::getline(in, line) && !in.eof(); };
    if (!next(record.study))
        return {};
    // `label: number number ...`. Of two lines with one label the later counts.
    for (std::string line; next(line);) {
        const std::size_t colon = line.find(": ");
        if (colon == std::string::npos)
            continue;
        if (const auto numbers = parse_numbers(std::string_view(line).substr(colon + 1)))
            record.rows[line.substr(0, colon)] = *numbers;
    }
    return record;
}

Journal::Journal(const std::filesystem::path& folder, const std::string& study, const std::string& name)
    : path_(folder / (name + ".part")) {
    if (std::optional<Record> before = read_record(path_); before && before->study == study)
        rows_ = std::move(before->rows);
    std::ofstream out(path_, std::ios::trunc);
    out << study << '\n';
    for (const auto& [row, numbers] : rows_)
        out << fmt::format("{}: {}\n", row, fmt::join(numbers, " "));
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

void Journal::complete() {
    std::filesystem::rename(path_, std::filesystem::path(path_).replace_extension(".rows"));
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

void measure_part(std::span<const Table> tables, const Part& part, Journal& journal,
                  const std::function<void(double)>& advance) {
    for (const auto& [table, row] : share_of(tables, part).rows)
        if (!journal.find(*table, *row)) {
            journal.add(*table, *row, row->measure(hash(row->key)));
            advance(row->cost);
        }
}

double cost_of_part(std::span<const Table> tables, const Part& part, const Journal& journal) {
    double cost = 0;
    for (const auto& [table, row] : share_of(tables, part).rows)
        cost += journal.find(*table, *row) ? 0 : row->cost;
    return cost;
}

std::string missing_row(std::span<const Table> tables, const Journal& journal) {
    for (const Table& table : tables)
        for (const Row& row : table.rows)
            if (!journal.find(table, row))
                return fmt::format("{} of {}", row.key, table.name);
    return {};
}

} // namespace gabor::study
