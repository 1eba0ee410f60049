#include "cli/program.hpp"
#include "lab/cli/commands.hpp"

int main(int argc, char** argv) {
    return gabor::cli::run(
        {"gabor-lab",
         "Reproduces and extends the figures of \"Making Gabor Noise Fast and Normalized\", and "
         "times the noises.",
         {gabor::lab::add_study_command, gabor::lab::add_bench_command}},
        argc, argv);
}
