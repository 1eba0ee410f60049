#pragma once

#include <string_view>

namespace CLI {
class App;
}
namespace gabor::image {
struct Rect;
}

namespace gabor::cli {

/// Each of these functions adds one subcommand, whose callback does the work.
void add_render_command(CLI::App& app);
void add_join_command(CLI::App& app);
void add_erode_command(CLI::App& app);
void add_stats_command(CLI::App& app);
void add_fit_command(CLI::App& app);
void add_devices_command(CLI::App& app);
void add_materials_command(CLI::App& app);
void add_recipes_command(CLI::App& app);

/// Throws RequestError, which says `whose` region it is, unless `region` lies within the `whole` of `width` x
/// `height` pixels.
void check_within(const image::Rect& region, int width, int height, std::string_view whose,
                  std::string_view whole);

} // namespace gabor::cli
