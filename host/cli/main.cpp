#include "cli/program.hpp"

int main(int argc, char** argv) {
    return gabor::cli::run(gabor::cli::gabor_program(), argc, argv);
}
