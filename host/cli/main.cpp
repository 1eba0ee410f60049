#include "cli/program.hpp"

int main(int argc, char** argv) {
    return gabor::cli::run(argc, argv);
}
