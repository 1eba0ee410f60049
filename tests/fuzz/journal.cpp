// The journal of an interrupted study: any bytes in `study.part`, then a table made from what it kept.

#include "study/table.hpp"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <unistd.h>

using namespace gabor;

namespace {

// In memory, and gone with the process.
struct Folder {
    std::filesystem::path path = "/dev/shm/gabor-fuzz-" + std::to_string(getpid());
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Folder folder;
    {
        std::ofstream file(folder.path / "study.part", std::ios::binary);
        file.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    }
    study::Table table{"table", "name,a,b", {}, "sum", [](std::vector<study::Numbers>& rows) {
                           for (study::Numbers& row : rows)
                               row.push_back(row.at(0) + row.at(1));
                       }};
    for (const char* key : {"first", "second"})
        table.rows.push_back({key, 1, [](std::uint32_t seed) { return study::Numbers{double(seed), 2}; }});
    study::Journal journal(folder.path, "study");
    study::write_table(table, folder.path, journal, [](double) {});
    return 0;
}
