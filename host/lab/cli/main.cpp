#include "cli/program.hpp"
#include "lab/cli/commands.hpp"

int main(int argc, char** argv) {
    return gabor::cli::run({"gabor-lab",
                            "Reproduces and extends the paper's figures, and times the noises.",
                            {gabor::lab::add_study_command, gabor::lab::add_bench_command}},
                           argc, argv);
}
