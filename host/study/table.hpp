#pragma once

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

/// One row of a table: its first columns as text, and what measures the others. Everything random in it comes
/// from the seed, which is a hash of the text: a row has the same numbers in whatever company it is measured.
struct Row {
    std::string key;
    double cost = 1; ///< in any unit, for the time left
    std::function<Numbers(std::uint32_t seed)> measure;
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

/// What a journal's file holds: the line that says of which study it is, and the rows that are done.
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

    /// Null for a row that was not measured.
    const Numbers* find(const Table& table, const Row& row) const;
    /// Throws std::runtime_error when the disk fails.
    void add(const Table& table, const Row& row, const Numbers& numbers);
    /// Forgets everything: the study is complete.
    void remove();
    /// Makes NAME.rows of it: a part of a study is complete.
    void complete();

  private:
    std::filesystem::path path_;
    std::map<std::string, Numbers> rows_;
};

/// Measures what the journal does not have and writes `folder`/NAME.csv. `advance` is called after each row
/// with its cost; what it throws ends the work, and the journal keeps what was done.
void write_table(const Table& table, const std::filesystem::path& folder, Journal& journal,
                 const std::function<void(double)>& advance);

/// Measures those rows of a part of a study that the journal does not have. Parts take rows in turns, the
/// most expensive first, each by the part that has had the least to do: which rows these are depends on
/// nothing else.
void measure_part(std::span<const Table> tables, const Part& part, Journal& journal,
                  const std::function<void(double)>& advance);

/// What `measure_part` will cost.
double cost_of_part(std::span<const Table> tables, const Part& part, const Journal& journal);

/// The first row that the journal does not have, as NAME and KEY; empty where it has all.
std::string missing_row(std::span<const Table> tables, const Journal& journal);

} // namespace gabor::study
