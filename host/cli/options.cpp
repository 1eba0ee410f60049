#include "cli/commands.hpp"

#include "render/load.hpp"
#include "render/material.hpp"

#include <fmt/ranges.h>

namespace gabor::cli {

namespace {

using Kind = render::Parameter::Kind;

// The type names that help texts show.
const char* type_name(Kind kind) {
    switch (kind) {
    case Kind::integer:
    case Kind::number:
        return "NUMBER";
    case Kind::angle:
        return "ANGLE";
    case Kind::colour:
        return "COLOUR";
    case Kind::text:
    case Kind::lobes:
        return "FILE";
    default:
        return "NAME";
    }
}

// Returns the value in `request`, or the values in views or in a material that have this parameter.
std::string default_text(const render::Parameter& parameter, const render::Request& request) {
    if (const std::optional<render::Value> value = parameter.get(request))
        return render::to_text(*value);
    if (const auto value = parameter.get({.material = std::string(render::materials.front())}))
        return render::to_text(*value);
    std::string text;
    std::optional<render::Value> last;
    for (const std::string_view view : render::parameter("view").choices) {
        render::Request other;
        render::set(other, "view", std::string(view));
        const std::optional<render::Value> value = parameter.get(other);
        if (value && value != last)
            text += last ? fmt::format(", or {} in the {} view", render::to_text(*value), view)
                         : render::to_text(*value);
        last = value ? value : last;
    }
    return text;
}

std::string help_of(const render::Parameter& parameter, const render::Request& defaults) {
    const std::string scope =
        parameter.scope.holds(defaults) ? "" : fmt::format(" (for {})", parameter.scope.described);
    std::vector<std::string> recipes;
    switch (parameter.kind) {
    case Kind::flag:
    case Kind::text:
        return fmt::format("{}{}", parameter.help, scope);
    case Kind::lobes:
        return fmt::format("{}: a JSON file with {}", parameter.help, render::accepted(parameter));
    case Kind::recipe:
        for (const noise::Recipe& recipe : noise::recipes())
            recipes.push_back(fmt::format("{} ({})", recipe.name, recipe.summary));
        return fmt::format("{}: {} [{}]", parameter.help, fmt::join(recipes, "; "),
                           default_text(parameter, defaults));
    default:
        return fmt::format("{}{}: {} [{}]", parameter.help, scope, render::accepted(parameter),
                           default_text(parameter, defaults));
    }
}

} // namespace

void begin_group(CLI::App& command, const std::string& name) {
    command.option_defaults()->group(name);
}

void add_elevation_option(CLI::App& command, std::optional<std::string>& elevation, std::string_view help) {
    add_option(command, "--elevation", elevation, "LOW,HIGH",
               fmt::format("Heights that 0 and 65535 stand for in 16-bit files [{}]", help));
}

render::Elevation parse_elevation(std::string_view text) {
    const auto comma = std::min(text.find(','), text.size());
    render::Elevation range{};
    const auto read = [](std::string_view number, double& value) {
        return std::from_chars(number.data(), number.data() + number.size(), value);
    };
    const auto low = read(text.substr(0, comma), range.low);
    const auto high = read(text.substr(std::min(comma + 1, text.size())), range.high);
    if (low.ec != std::errc() || high.ec != std::errc() || low.ptr != text.data() + comma ||
        high.ptr != text.data() + text.size() || !(range.low < range.high) ||
        !std::isfinite(range.high - range.low))
        refuse("--elevation", text, "LOW,HIGH, the lower height first");
    return range;
}

void add_parameter(CLI::App& command, ParameterOptions& options, const render::Parameter& parameter,
                   const render::Request& defaults) {
    const std::string name = render::option_name(parameter);
    CLI::Option* option = parameter.kind == Kind::flag
                              ? command.add_flag(fmt::format("{},!--no-{}", name, name.substr(2)))
                                    ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
                              : command.add_option(name)->type_name(type_name(parameter.kind));
    options.emplace_back(&parameter, option->description(help_of(parameter, defaults)));
}

render::Values given_values(const ParameterOptions& options) {
    render::Values values;
    for (const auto& [parameter, option] : options) {
        if (option->count() == 0)
            continue;
        const render::Parameter& p = *parameter;
        const auto text = option->as<std::string>();
        values.emplace_back(&p, with_prefix(render::option_name(p) + ' ', [&] {
            return p.kind == Kind::lobes ? render::load_lobes(text) : render::read(p, text);
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
