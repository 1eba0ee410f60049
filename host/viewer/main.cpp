#include "viewer/app.hpp"

#include <csignal>

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN); // a file beyond the size limit is an error, not the end of the program
    return gabor::viewer::run_viewer(argc, argv);
}
