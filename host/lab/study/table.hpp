#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace gabor::study {

/// What a row has measured.
using Numbers = std::vector<double>;

/// How a row is measured: in pieces, whose numbers are then combined. The pieces are always the same ones, so
/// that it makes no difference to the last bit where each of them was measured.
class Measurement {
  public:
    /// The numbers of each of the pieces that are asked for, which count from 0.
    using Measure = std::function<std::vector<Numbers>(std::uint32_t seed, std::span<const int> pieces)>;
    /// The row's, from those of all its pieces in their order.
    using Combine = std::function<Numbers(std::span<const Numbers> pieces)>;

    /// In one piece, which is the row.
    template <std::invocable<std::uint32_t> Whole>
    Measurement(Whole whole)
        : Measurement(
              1,
              [whole](std::uint32_t seed, std::span<const int>) { return std::vector<Numbers>{whole(seed)}; },
              [](std::span<const Numbers> pieces) { return pieces.front(); }) {}
    Measurement(int count, Measure measure, Combine combine)
        : count_(count), measure_(std::move(measure)), combine_(std::move(combine)) {}

    int count() const { return count_; }
    std::vector<Numbers> pieces(std::uint32_t seed, std::span<const int> which) const {
        return measure_(seed, which);
    }
    Numbers combine(std::span<const Numbers> pieces) const { return combine_(pieces); }
    Numbers whole(std::uint32_t seed) const;

  private:
    int count_;
    Measure measure_;
    Combine combine_;
};

/// One row of a table: its first columns as text, and what measures the others. Everything random in it comes
/// from the seed, which is a hash of the text: a row has the same numbers in whatever company it is measured.
struct Row {
    std::string key;
    double cost; ///< in any unit, for the time left
    Measurement measure;
};

/// A CSV to be.
struct Table {
    std::string name;    ///< of the file, without .csv
    std::string columns; ///< names of those that rows have; tables with the same ones share rows
    std::vector<Row> rows;
    std::string derived = {};                               ///< names of columns that need all rows
    std::function<void(std::vector<Numbers>&)> derive = {}; ///< appends them to each row
};

/// One of the parts of a study that is spread over machines.
struct Part {
    int index = 1; ///< from 1 to count
    int count = 1;
};

/// What a journal's file holds: the line that says of which study it is, and the rows and pieces of rows that
/// are done.
struct Record {
    std::string study;
    std::map<std::string, Numbers> rows;
};

/// Nothing where there is no such file.
std::optional<Record> read_record(const std::filesystem::path& path);

/// Rows that are done, so that an interrupted study goes on where it was: NAME.part in the folder, as long as
/// the study is not complete.
class Journal {
  public:
    /// Continues the journal of the same study: one that was begun with the same `study` line.
    /// Throws RequestError when the folder cannot be written.
    Journal(const std::filesystem::path& folder, const std::string& study, const std::string& name = "study");

    /// One that is kept nowhere.
    explicit Journal(std::map<std::string, Numbers> rows) : rows_(std::move(rows)) {}

    /// The numbers of a row of which the whole or every piece was measured.
    std::optional<Numbers> find(const Table& table, const Row& row) const;
    bool has_piece(const Table& table, const Row& row, int piece) const;
    /// Throws std::runtime_error when the disk fails, as the next one does.
    void add(const Table& table, const Row& row, const Numbers& numbers);
    void add_piece(const Table& table, const Row& row, int piece, const Numbers& numbers);
    /// Forgets everything: the study is complete.
    void remove();
    /// Makes NAME.rows of it: a part of a study is complete.
    void complete();

  private:
    void add(const std::string& label, const Numbers& numbers);

    std::filesystem::path path_;
    std::map<std::string, Numbers> rows_;
};

/// Measures what the journal does not have and writes `folder`/NAME.csv. `advance` is called after each row
/// with its cost; what it throws ends the work, and the journal keeps what was done.
void write_table(const Table& table, const std::filesystem::path& folder, Journal& journal,
                 const std::function<void(double)>& advance);

/// Measures what the journal does not have of a part of a study. Parts take rows in turns, the most expensive
/// first, each by the part that has had the least to do, and the pieces of a row one by one where it would
/// take more than half of a part's share: which they are depends on nothing else.
void measure_part(std::span<const Table> tables, const Part& part, Journal& journal,
                  const std::function<void(double)>& advance);

/// What `measure_part` will cost.
double cost_of_part(std::span<const Table> tables, const Part& part, const Journal& journal);

/// The first row that the journal does not have, as NAME and KEY; empty where it has all.
std::string missing_row(std::span<const Table> tables, const Journal& journal);

} // namespace gabor::study
