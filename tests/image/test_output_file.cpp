#include "image/output_file.hpp"

#include "error.hpp"
#include "scratch_folder.hpp"

#include <catch2/catch.hpp>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <optional>
#include <sys/file.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

using gabor::RequestError;
using gabor::image::OutputFile;
namespace fs = std::filesystem;

namespace {

void replace(const fs::path& path, std::string_view text) {
    OutputFile file(path);
    file.write(text);
    file.commit();
}

mode_t mode(const fs::path& path) {
    struct stat status {};
    ::stat(path.c_str(), &status);
    return status.st_mode & 07777;
}

/// Runs `body`, which returns an exit status, in a child process. Returns the status from waitpid.
template <class Body>
int in_child(Body body) {
    const pid_t child = ::fork();
    if (child == 0)
        ::_exit(body());
    int status = -1;
    ::waitpid(child, &status, 0);
    return status;
}

template <std::size_t Size>
bool filter_calls(sock_filter (&program)[Size]) {
    const sock_fprog filter{Size, program};
    return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

/// Makes O_TMPFILE fail in this process, as on file systems without it.
bool forbid_nameless_files() {
    constexpr unsigned nameless = O_TMPFILE & ~O_DIRECTORY;
    sock_filter program[] = {
        {BPF_LD | BPF_W | BPF_ABS, 0, 0, offsetof(seccomp_data, nr)},
        {BPF_JMP | BPF_JEQ | BPF_K, 0, 3, SYS_openat},
        {BPF_LD | BPF_W | BPF_ABS, 0, 0, offsetof(seccomp_data, args[2])},
        {BPF_JMP | BPF_JSET | BPF_K, 0, 1, nameless},
        {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ERRNO | EOPNOTSUPP},
        {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW},
    };
    return filter_calls(program);
}

/// Makes the kernel kill this process as soon as it makes this system call.
bool kill_at(unsigned call) {
    sock_filter program[] = {
        {BPF_LD | BPF_W | BPF_ABS, 0, 0, offsetof(seccomp_data, nr)},
        {BPF_JMP | BPF_JEQ | BPF_K, 0, 1, call},
        {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_KILL_PROCESS},
        {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW},
    };
    return filter_calls(program);
}

std::string refusal(const fs::path& path) {
    try {
        OutputFile file(path);
    } catch (const RequestError& error) {
        return error.what();
    }
    return "accepted";
}

} // namespace

TEST_CASE("A file appears under its name only after commit", "[output_file]") {
    const ScratchFolder folder;
    const fs::path path = folder / "out";

    OutputFile file(path);
    file.write("complete");
    CHECK(folder.count() == 0);
    file.commit();
    CHECK(read_file(path) == "complete");
    CHECK(folder.count() == 1);
}

TEST_CASE("An older file stays until commit, which replaces it", "[output_file]") {
    const ScratchFolder folder;
    const fs::path path = folder / "out";
    write_file(path, "a longer old content");

    { OutputFile(path).write(""); }
    CHECK(read_file(path) == "a longer old content");
    {
        OutputFile file(path);
        file.write("new");
        CHECK(read_file(path) == "a longer old content");
        file.commit();
    }
    CHECK(read_file(path) == "new");
    CHECK(folder.count() == 1);
}

TEST_CASE("A file's mode is that of an ordinary new file", "[output_file]") {
    const ScratchFolder folder;
    const mode_t before = ::umask(027);
    replace(folder / "narrow", "");
    ::umask(0);
    replace(folder / "wide", "");
    ::umask(before);
    CHECK(mode(folder / "narrow") == 0640);
    CHECK(mode(folder / "wide") == 0666);
}

TEST_CASE("A name that cannot be a file is refused with a one-line message", "[output_file]") {
    using Catch::Matchers::Contains;
    const ScratchFolder folder;
    write_file(folder / "file", "");

    CHECK_THAT(refusal(""), Contains("name is empty"));
    CHECK_THAT(refusal(folder.path()), Contains("it is a folder"));
    CHECK_THAT(refusal(folder / "file2/"), Contains("it is a folder"));
    CHECK_THAT(refusal(folder / "missing/out"),
               Contains("missing/out: folder ") && Contains("No such file or directory; expected"));
    CHECK_THAT(refusal(folder / "file/out"), Contains("Not a directory; expected"));
    CHECK_THAT(refusal(folder / std::string(300, 'x')), Contains("File name too long"));
    CHECK_THAT(refusal("/proc/out"), Contains("folder /proc: ") && Contains("writable folder"));
    CHECK(folder.count() == 1);
}

TEST_CASE("The longest possible name is accepted", "[output_file]") {
    const ScratchFolder folder;
    const std::string name(255, 'x');
    replace(folder / name, "long");
    CHECK(read_file(folder / name) == "long");
}

TEST_CASE("A symbolic link stays, and the file that it points to is replaced", "[output_file]") {
    const ScratchFolder folder;
    fs::create_directory(folder / "real");
    write_file(folder / "real/old", "old");
    fs::create_symlink("real/old", folder / "link");
    fs::create_symlink("link", folder / "link to link");
    fs::create_symlink("real/absent", folder / "dangling");
    fs::create_symlink("circle", folder / "circle");

    replace(folder / "link to link", "new");
    replace(folder / "dangling", "made");
    CHECK(fs::is_symlink(folder / "link to link"));
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(fs::is_symlink(folder / "dangling"));
    CHECK(read_file(folder / "real/old") == "new");
    CHECK(read_file(folder / "real/absent") == "made");
    CHECK_THROWS_AS(OutputFile(folder / "circle"), RequestError);
}

TEST_CASE("A device is written to and never replaced", "[output_file]") {
    replace("/dev/null", "gone");
    CHECK(fs::is_character_file("/dev/null"));

    OutputFile full("/dev/full");
    CHECK_THROWS_WITH(full.write("too much"), "cannot write /dev/full: No space left on device");
    CHECK(fs::is_character_file("/dev/full"));
}

TEST_CASE("A FIFO receives the data in order", "[output_file]") {
    const ScratchFolder folder;
    const fs::path path = folder / "fifo";
    REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
    const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK);

    OutputFile file(path);
    file.write("one ");
    file.write("two");
    CHECK_NOTHROW(file.seek(7));
    CHECK_THROWS_AS(file.seek(0), std::runtime_error);
    file.commit();

    char text[8] = {};
    CHECK(::read(reader, text, sizeof(text)) == 7);
    CHECK(std::string(text) == "one two");
    ::close(reader);
    CHECK(fs::is_fifo(path));
    CHECK(folder.count() == 1);
}

TEST_CASE("A failing disk is not reported as an invalid request", "[output_file]") {
    const ScratchFolder folder;
    const fs::path path = folder / "out";
    // The file size limit stands in for a full disk: it cuts the first write short and makes the next one
    // fail.
    const int status = in_child([&] {
        ::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{1000, 1000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        const auto fails = [&](const auto& action) {
            try {
                action();
            } catch (const RequestError&) {
                return false;
            } catch (const std::runtime_error& error) {
                return error.what() == "cannot write " + path.string() + ": File too large";
            }
            return false;
        };
        OutputFile file(path);
        if (!fails([&] { file.write(std::string(2000, 'x')); }))
            return 2;
        return fails([&] { file.commit(); }) ? 0 : 3; // even if the first failure was ignored
    });
    CHECK(status == 0);
    CHECK(folder.count() == 0);
}

TEST_CASE("Replacing a file removes what a killed process left behind", "[output_file]") {
    const ScratchFolder folder;
    const fs::path path = folder / "out";
    write_file(path, "old");
    const int status = in_child([&] {
        if (!kill_at(SYS_rename))
            return 1;
        replace(path, "new");
        return 2;
    });
    REQUIRE(WIFSIGNALED(status));
    CHECK(read_file(path) == "old");
    REQUIRE(folder.count() == 2);

    write_file(folder / ".out.gabor-lockedfi", "not one of our names");
    write_file(folder / ".out.gabor-00c0ffee", "somebody writes here");
    const int writer = ::open((folder / ".out.gabor-00c0ffee").c_str(), O_WRONLY | O_CLOEXEC);
    REQUIRE(::flock(writer, LOCK_EX) == 0);
    replace(path, "newer");
    CHECK(read_file(path) == "newer");
    CHECK(folder.count() == 3);
    ::close(writer);
    replace(path, "newest");
    CHECK(read_file(path) == "newest");
    CHECK(folder.count() == 2);
}

TEST_CASE("A hidden file is used if the file system lacks unnamed files", "[output_file]") {
    const ScratchFolder folder;
    const fs::path path = folder / "out";
    const mode_t before = ::umask(027);
    const int status = in_child([&] {
        if (!forbid_nameless_files())
            return 1;
        {
            OutputFile abandoned(path);
            const std::string name = fs::directory_iterator(folder.path())->path().filename();
            if (folder.count() != 1 || name.size() != 19 || !name.starts_with(".out.gabor-"))
                return 2;
        }
        if (folder.count() != 0)
            return 3;
        replace(path, "old");
        OutputFile file(path);
        file.write("new");
        if (folder.count() != 2 || read_file(path) != "old")
            return 4;
        file.commit();
        return 0;
    });
    ::umask(before);
    REQUIRE(status == 0);
    CHECK(read_file(path) == "new");
    CHECK(mode(path) == 0640);
    CHECK(folder.count() == 1);
}
