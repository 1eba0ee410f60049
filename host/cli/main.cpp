#include "cli/program.hpp"

#include <csignal>
#include <fcntl.h>
#include <initializer_list>
#include <unistd.h>

int main(int argc, char** argv) {
    // The next file that is opened would take the place of a standard stream that is closed, and what is
    // printed would go into it. What stands in for it cannot be written, so that printing fails.
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(stream, F_GETFD) < 0)
            ::open("/dev/null", O_RDONLY);
    std::signal(SIGPIPE, SIG_IGN); // a reader who goes away is an error like any other
    std::signal(SIGXFSZ, SIG_IGN); // so is a file that grows too large
    return gabor::cli::run(argc, argv);
}
