#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
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

/// Rows that are done, so that an interrupted study goes on where it was: `study.part` in the folder, as long
/// as the study is not complete.
class Journal {
  public:
    /// Continues the journal of the same study: one that was begun with the same `study` line.
    /// Throws RequestError when the folder cannot be written.
    Journal(const std::filesystem::path& folder, const std::string& study);

    /// Null for a row that was not measured.
    const Numbers* find(const Table& table, const Row& row) const;
    /// Throws std::runtime_error when the disk fails.
    void add(const Table& table, const Row& row, const Numbers& numbers);
    /// Forgets everything: the study is complete.
    void remove();

  private:
    std::filesystem::path path_;
    std::map<std::string, Numbers> rows_;
};

/// Measures what the journal does not have and writes `folder`/NAME.csv. `advance` is called after each row
/// with its cost; what it throws ends the work, and the journal keeps what was done.
void write_table(const Table& table, const std::filesystem::path& folder, Journal& journal,
                 const std::function<void(double)>& advance);

} // namespace gabor::study
