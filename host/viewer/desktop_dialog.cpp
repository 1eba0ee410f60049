#include "viewer/desktop_dialog.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace gabor::viewer {

namespace {

std::vector<std::string> command_of(const std::string& program, const FileDialog& dialog) {
    const std::string place = (dialog.folder / dialog.name).string();
    const std::string patterns = fmt::format("*{}", fmt::join(dialog.endings, " *"));
    std::vector<std::string> command{program};
    if (program == "kdialog") {
        command.insert(command.end(), {"--title", dialog.title,
                                       dialog.folder_wanted ? "--getexistingdirectory"
                                       : dialog.saves       ? "--getsavefilename"
                                                            : "--getopenfilename",
                                       place});
        if (!dialog.folder_wanted)
            command.push_back(patterns);
        return command;
    }
    command.insert(command.end(), {"--file-selection", "--title=" + dialog.title, "--filename=" + place});
    if (dialog.folder_wanted)
        command.emplace_back("--directory");
    else
        command.push_back("--file-filter=" + patterns);
    if (dialog.saves)
        command.emplace_back("--save");
    return command;
}

} // namespace

DesktopDialog::~DesktopDialog() {
    if (!is_open())
        return;
    ::kill(process_, SIGTERM);
    ::waitpid(process_, nullptr, 0);
    ::close(pipe_);
}

bool DesktopDialog::open(const FileDialog& dialog) {
    const char* const desktop = std::getenv("XDG_CURRENT_DESKTOP");
    std::array<int, 2> ends{};
    if (!desktop || !*desktop || is_open() || ::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0)
        return false;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    std::array programs{"zenity", "kdialog"};
    if (std::string_view(desktop).find("KDE") != std::string_view::npos)
        std::swap(programs[0], programs[1]);
    for (const char* const program : programs) {
        std::vector<std::string> command = command_of(program, dialog);
        std::vector<char*> words;
        for (std::string& word : command)
            words.push_back(word.data());
        words.push_back(nullptr);
        if (::posix_spawnp(&process_, program, &actions, nullptr, words.data(), environ) == 0)
            break;
        process_ = 0;
    }
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    pipe_ = ends[0];
    if (!is_open())
        ::close(pipe_);
    said_.clear();
    return is_open();
}

std::optional<std::string> DesktopDialog::poll() {
    if (!is_open())
        return {};
    int status = 0;
    const bool ended = ::waitpid(process_, &status, WNOHANG) == process_;
    std::array<char, 4096> part{};
    for (ssize_t count = 0; (count = ::read(pipe_, part.data(), part.size())) > 0;)
        said_.append(part.data(), static_cast<std::size_t>(count));
    if (!ended)
        return {};
    process_ = 0;
    ::close(pipe_);
    constexpr int cancelled = 1;
    if (!WIFEXITED(status) || WEXITSTATUS(status) > cancelled)
        return {};
    return WEXITSTATUS(status) == cancelled ? "" : said_.substr(0, said_.find('\n'));
}

} // namespace gabor::viewer
