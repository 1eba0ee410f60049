#include "viewer/app.hpp"

#include <csignal>

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN); // a file that grows too large is an error like any other
    return gabor::viewer::run_viewer(argc, argv);
}
