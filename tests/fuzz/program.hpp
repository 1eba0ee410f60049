#pragma once

#include "cli/program.hpp"

#include <cstdint>
#include <cstdlib>
#include <fcntl.h>
#include <span>
#include <string>
#include <sys/mman.h>
#include <unistd.h>
#include <vector>

namespace gabor::fuzz {

/// Runs the program in this process, in a folder where no file can be created. Its exit status must be 0 or
/// 2, since 1 means that the work failed.
inline void run(const std::vector<std::string>& arguments) {
    static const bool nowhere = chdir("/proc/self/fdinfo") == 0;
    std::vector<const char*> pointers{"gabor"};
    for (const std::string& argument : arguments)
        pointers.push_back(argument.c_str());
    static const cli::Program program = cli::gabor_program();
    const int status = cli::run(program, static_cast<int>(pointers.size()), pointers.data());
    if (!nowhere || (status != 0 && status != 2))
        std::abort();
}

/// A file in memory.
class MemoryFile {
  public:
    explicit MemoryFile(std::span<const std::uint8_t> bytes)
        : descriptor_(memfd_create("input", MFD_CLOEXEC)) {
        if (descriptor_ < 0 ||
            write(descriptor_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
            std::abort();
    }
    ~MemoryFile() { close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

  private:
    int descriptor_;
};

} // namespace gabor::fuzz
