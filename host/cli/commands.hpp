#pragma once

namespace CLI {
class App;
}

namespace gabor::cli {

/// Each of these functions adds one subcommand, whose callback does the work.
void add_render_command(CLI::App& app);
void add_maps_command(CLI::App& app);
void add_texture_command(CLI::App& app);
void add_join_command(CLI::App& app);
void add_erode_command(CLI::App& app);
void add_stats_command(CLI::App& app);
void add_fit_command(CLI::App& app);
void add_devices_command(CLI::App& app);
void add_materials_command(CLI::App& app);
void add_recipes_command(CLI::App& app);

} // namespace gabor::cli
