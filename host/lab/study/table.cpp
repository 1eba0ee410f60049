#include "study/table.hpp"

#include "error.hpp"
#include "image/output_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <functional>
#include <numeric>
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

std::string label(const Table& table, const Row& row, int piece) {
    return fmt::format("{} piece {} of {}", label(table, row), piece + 1, row.measure.count());
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

// The pieces of a row that one part measures.
struct Task {
    const Table* table;
    const Row* row;
    std::vector<int> pieces;
    bool whole; // it has all of them, and the row's numbers are kept instead of theirs

    double cost() const { return row->cost * static_cast<double>(pieces.size()) / row->measure.count(); }
};

std::vector<int> all_pieces(const Measurement& measurement) {
    std::vector<int> pieces(static_cast<std::size_t>(measurement.count()));
    std::iota(pieces.begin(), pieces.end(), 0);
    return pieces;
}

// Rows with one label once.
std::vector<Task> different_rows(std::span<const Table> tables) {
    std::vector<Task> rows;
    std::set<std::string> labels;
    for (const Table& table : tables)
        for (const Row& row : table.rows)
            if (labels.insert(label(table, row)).second)
                rows.push_back({&table, &row, all_pieces(row.measure), true});
    return rows;
}

// What one part measures of a study.
struct Share {
    std::vector<Task> tasks;
    double cost = 0;
};

Share share_of(std::span<const Table> tables, const Part& part) {
    const std::vector<Task> rows = different_rows(tables);
    double total = 0;
    for (const Task& row : rows)
        total += row.cost();
    std::vector<Task> tasks;
    for (const Task& row : rows) {
        if (row.pieces.size() == 1 || row.cost() <= total / (2 * part.count))
            tasks.push_back(row);
        else
            for (const int piece : row.pieces)
                tasks.push_back({row.table, row.row, {piece}, false});
    }
    std::ranges::stable_sort(tasks, std::ranges::greater(), &Task::cost);

    std::vector<Share> shares(static_cast<std::size_t>(part.count));
    for (const Task& task : tasks) {
        // Rows that cost nothing are spread as well.
        Share& least = *std::ranges::min_element(
            shares, {}, [](const Share& share) { return std::pair(share.cost, share.tasks.size()); });
        if (!least.tasks.empty() && least.tasks.back().row == task.row)
            least.tasks.back().pieces.push_back(task.pieces.front());
        else
            least.tasks.push_back(task);
        least.cost += task.cost();
    }
    return shares[static_cast<std::size_t>(part.index - 1)];
}

// What of it the journal does not have.
std::vector<Task> tasks_left(std::span<const Table> tables, const Part& part, const Journal& journal) {
    std::vector<Task> tasks = share_of(tables, part).tasks;
    for (Task& task : tasks)
        std::erase_if(task.pieces, [&](int piece) {
            return task.whole ? journal.find(*task.table, *task.row).has_value()
                              : journal.has_piece(*task.table, *task.row, piece);
        });
    std::erase_if(tasks, [](const Task& task) { return task.pieces.empty(); });
    return tasks;
}

} // namespace

Numbers Measurement::whole(std::uint32_t seed) const {
    return combine_(measure_(seed, all_pieces(*this)));
}

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

std::optional<Numbers> Journal::find(const Table& table, const Row& row) const {
    if (const auto found = rows_.find(label(table, row));
        found != rows_.end() && found->second.size() == numbers_of(table, row))
        return found->second;
    std::vector<Numbers> pieces;
    for (const int piece : all_pieces(row.measure)) {
        const auto found = rows_.find(label(table, row, piece));
        if (found == rows_.end())
            return {};
        pieces.push_back(found->second);
    }
    return row.measure.combine(pieces);
}

bool Journal::has_piece(const Table& table, const Row& row, int piece) const {
    return rows_.contains(label(table, row, piece));
}

void Journal::add(const Table& table, const Row& row, const Numbers& numbers) {
    add(label(table, row), numbers);
}

void Journal::add_piece(const Table& table, const Row& row, int piece, const Numbers& numbers) {
    add(label(table, row, piece), numbers);
}

void Journal::add(const std::string& label, const Numbers& numbers) {
    std::ofstream out(path_, std::ios::app);
    out << fmt::format("{}: {}\n", label, fmt::join(numbers, " "));
    if (!out.flush())
        throw std::runtime_error(fmt::format("cannot write '{}'", path_.string()));
    rows_[label] = numbers;
}

void Journal::remove() {
    std::filesystem::remove(path_);
}

void Journal::complete() {
    std::filesystem::rename(path_, std::filesystem::path(path_).replace_extension(".rows"));
}

void write_table(const Table& table, const std::filesystem::path& folder, Journal& journal,
                 const std::function<void(double)>& advance) {
    std::vector<Numbers> all;
    for (const Row& row : table.rows) {
        std::optional<Numbers> numbers = journal.find(table, row);
        if (!numbers) {
            numbers = row.measure.whole(hash(row.key));
            journal.add(table, row, *numbers);
            advance(row.cost);
        }
        all.push_back(std::move(*numbers));
    }
    if (table.derive)
        table.derive(all);
    std::string text = table.columns + (table.derived.empty() ? "" : "," + table.derived) + '\n';
    for (std::size_t i = 0; i < all.size(); ++i)
        text += fmt::format("{},{:.6g}\n", table.rows[i].key, fmt::join(all[i], ","));
    image::OutputFile file(folder / (table.name + ".csv"));
    file.write(std::as_bytes(std::span(text)));
    file.commit();
}

void measure_part(std::span<const Table> tables, const Part& part, Journal& journal,
                  const std::function<void(double)>& advance) {
    for (const Task& task : tasks_left(tables, part, journal)) {
        const Row& row = *task.row;
        if (task.whole) {
            journal.add(*task.table, row, row.measure.whole(hash(row.key)));
        } else {
            const std::vector<Numbers> numbers = row.measure.pieces(hash(row.key), task.pieces);
            for (std::size_t i = 0; i < numbers.size(); ++i)
                journal.add_piece(*task.table, row, task.pieces[i], numbers[i]);
        }
        advance(task.cost());
    }
}

double cost_of_part(std::span<const Table> tables, const Part& part, const Journal& journal) {
    double cost = 0;
    for (const Task& task : tasks_left(tables, part, journal))
        cost += task.cost();
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
