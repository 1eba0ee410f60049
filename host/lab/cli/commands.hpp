#pragma once

namespace CLI {
class App;
}

namespace gabor::lab {

/// Each of these functions adds one subcommand, whose callback does the work.
void add_study_command(CLI::App& app);
void add_bench_command(CLI::App& app);

} // namespace gabor::lab
