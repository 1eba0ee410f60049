#include "cli/commands.hpp"
#include "cli/program.hpp"

namespace gabor::cli {

Program gabor_program() {
    return {"gabor",
            "Renders Gabor noise and measures it.",
            {add_render_command, add_maps_command, add_texture_command, add_erode_command, add_join_command,
             add_stats_command,
#if GABOR_FIT
             add_fit_command,
#endif
             add_devices_command, add_recipes_command, add_materials_command},
            R"(
Examples:
  gabor render --frequency 4 --orientation 45 -o noise.png
  gabor maps --material wood -o wood
  gabor render --preset storm --png storm.png
  gabor erode heights.png -o eroded.png

gabor COMMAND --help lists the options of a command.
)"};
}

} // namespace gabor::cli
