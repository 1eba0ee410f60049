#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace gabor::study {

/// The numbers of a row.
using Numbers = std::vector<double>;

/// One row of a table: its first columns as text, and a function that measures the others. Its random numbers
/// depend only on a hash of the text, so a row has the same numbers in any table and in every run.
struct Row {
    std::string key;
    double cost; ///< cost in any unit; serves to estimate the time left
    std::function<Numbers(std::uint32_t seed)> measure;
};

/// A CSV table to be measured.
struct Table {
    std::string name;    ///< name of the file, without .csv
    std::string columns; ///< comma-separated, text columns first; tables with the same columns share rows
    std::vector<Row> rows;
    std::string derived = {};                               ///< names of columns that need all rows
    std::function<void(std::vector<Numbers>&)> derive = {}; ///< appends these columns to each row
};

/// Rows that this process has measured, indexed by their table's columns and their key.
using MeasuredRows = std::map<std::string, Numbers>;

/// Measures a table and writes `folder`/NAME.csv, then NAME.json with `conditions`: everything else that the
/// numbers depend on. Takes rows from `measured` if they are there, and adds the others. Calls `advance` with
/// the cost of each row; an exception from it aborts, and nothing is written.
void write_table(const Table& table, const std::filesystem::path& folder, const std::string& conditions,
                 MeasuredRows& measured, const std::function<void(double)>& advance);

/// Tells whether the folder holds the complete table, measured under these conditions.
bool is_finished(const Table& table, const std::filesystem::path& folder, const std::string& conditions);

/// Adds up the costs of all rows.
double cost(std::span<const Table> tables);

} // namespace gabor::study
