#include "cli/commands.hpp"

#include "image/exr.hpp"
#include "render/load.hpp"

namespace gabor::cli {

CLI::Option* add_elevation_option(CLI::App& command, std::vector<double>& elevation,
                                  const std::string& help) {
    return add_option(command, "--elevation", elevation, "RANGE", help)->delimiter(',')->expected(2);
}

render::Values given_values(const ParameterOptions& options) {
    render::Values values;
    for (const auto& [parameter, option] : options) {
        if (option->count() == 0)
            continue;
        const render::Parameter& p = *parameter;
        const auto text = option->as<std::string>();
        values.emplace_back(&p, with_prefix(render::option_name(p) + ' ', [&] {
            return p.kind == render::Parameter::Kind::lobes ? render::load_lobes(text)
                                                            : render::read(p, text);
        }));
    }
    return values;
}

void refuse(std::string_view option, std::string_view text, std::string_view accepted) {
    throw RequestError(fmt::format("{} '{}': expected {}", option, text, accepted));
}

int parse_integer(std::string_view option, std::string_view text, int low, int high, std::string_view where) {
    const std::string accepted = fmt::format("a whole number from {} to {}{}", low, high, where);
    const auto [value] = parse_integers<1>(option, text, ' ', accepted);
    if (value < low || value > high)
        refuse(option, text, accepted);
    return value;
}

image::Rect parse_region(std::string_view text) {
    const auto [x, y, width, height] = parse_integers<4>(
        "--region", text, ',', "X,Y,WIDTH,HEIGHT in pixels from the picture's upper left corner");
    return {x, y, width, height};
}

void check_within(const image::Rect& r, int width, int height, std::string_view whose,
                  std::string_view whole) {
    if (r.x < 0 || r.y < 0 || r.width < 1 || r.height < 1 || r.width > width - r.x || r.height > height - r.y)
        throw RequestError(fmt::format("{} {},{},{},{} is not within the {} of {} x {} pixels", whose, r.x,
                                       r.y, r.width, r.height, whole, width, height));
}

} // namespace gabor::cli
