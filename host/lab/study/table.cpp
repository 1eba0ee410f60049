#include "study/table.hpp"

#include "image/output_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <iterator>
#include <string_view>

namespace gabor::study {

namespace {

// FNV-1a.
std::uint32_t hash(std::string_view text) {
    std::uint32_t word = 0x811c9dc5u;
    for (const char c : text)
        word = (word ^ static_cast<unsigned char>(c)) * 0x01000193u;
    return word;
}

std::filesystem::path path_of(const Table& table, const std::filesystem::path& folder,
                              std::string_view extension) {
    return folder / fmt::format("{}.{}", table.name, extension);
}

} // namespace

void write_table(const Table& table, const std::filesystem::path& folder, const std::string& conditions,
                 MeasuredRows& measured, const std::function<void(double)>& advance) {
    image::OutputFile csv(path_of(table, folder, "csv")); // throws before measuring if it cannot be written
    const std::filesystem::path sidecar = path_of(table, folder, "json");
    image::OutputFile json(sidecar);
    std::vector<Numbers> all;
    for (const Row& row : table.rows) {
        const auto [entry, missing] = measured.try_emplace(table.columns + '\n' + row.key);
        if (missing)
            entry->second = row.measure(hash(row.key));
        all.push_back(entry->second);
        advance(row.cost);
    }
    if (table.derive)
        table.derive(all);
    std::string text = table.columns + (table.derived.empty() ? "" : "," + table.derived) + '\n';
    for (std::size_t i = 0; i < all.size(); ++i)
        text += fmt::format("{},{:.6g}\n", table.rows[i].key, fmt::join(all[i], ","));
    std::filesystem::remove(sidecar); // because it describes the previous table
    csv.write(text);
    csv.commit();
    json.write(conditions);
    json.commit();
}

bool is_finished(const Table& table, const std::filesystem::path& folder, const std::string& conditions) {
    std::ifstream sidecar(path_of(table, folder, "json"));
    return std::filesystem::exists(path_of(table, folder, "csv")) &&
           std::string(std::istreambuf_iterator<char>(sidecar), {}) == conditions;
}

double cost(std::span<const Table> tables) {
    double sum = 0;
    for (const Table& table : tables)
        for (const Row& row : table.rows)
            sum += row.cost;
    return sum;
}

} // namespace gabor::study
