#include "cli/options.hpp"

#include "render/request/load.hpp"
#include "render/request/material.hpp"

#include <fmt/ranges.h>

#include <algorithm>

namespace gabor::cli {

namespace {

using Type = render::Parameter::Type;

// Returns the value in `request`, or the values in views or in a material that have this parameter.
std::string default_text(const render::Parameter& parameter, const render::Request& request) {
    std::vector<render::Request> others{request, {}};
    render::set(others.back(), "material", std::string(render::materials.front()));
    render::set(others.emplace_back(), "fractal", std::string(render::fractal_shapes.at(1)));
    for (const std::string_view view : render::parameter("view").choices)
        render::set(others.emplace_back(), "view", std::string(view));
    others.resize(parameter.get(request) ? 1 : others.size());
    std::string text;
    std::optional<render::Value> last;
    for (const render::Request& other : others)
        if (const std::optional<render::Value> value = parameter.get(other); value && value != last) {
            text += last ? fmt::format(", or {} in the {} view", render::to_text(*value),
                                       render::to_text(*render::parameter("view").get(other)))
                         : render::to_text(*value);
            last = value;
        }
    return text;
}

std::string help_of(const render::Parameter& p, const render::Request& defaults) {
    std::string text(p.help);
    if (!p.scope.holds(defaults))
        text += fmt::format(" (with {})", p.scope.described);
    if (p.type == Type::lobes)
        return fmt::format("{}: a JSON file with {}", text, render::accepted(p));
    if (p.type == Type::choice && text.find('\n') != text.npos) // the help has the choices
        return fmt::format("{} [{}]", text, default_text(p, defaults));
    return p.type == Type::flag || p.type == Type::text
               ? text
               : fmt::format("{}: {} [{}]", text, render::accepted(p), default_text(p, defaults));
}

} // namespace

void begin_group(CLI::App& command, const std::string& name) {
    command.option_defaults()->group(name);
}

void add_elevation_option(CLI::App& command, std::optional<std::string>& elevation, std::string_view help) {
    add_option(command, "--elevation", elevation, "LOW,HIGH",
               fmt::format("Heights that 0 and 65535 stand for in 16-bit files [{}]", help));
}

void add_full_range_option(CLI::App& command, bool& full_range) {
    command.add_flag("--full-range", full_range,
                     "Stretch 16-bit heights, so that the lowest is 0 and the highest 65535; the scale then "
                     "differs between regions");
}

void check_height_options(const std::filesystem::path& path, bool full_range, std::string_view compression,
                          bool exr) {
    if (full_range && !render::is_16_bit(path))
        throw RequestError(fmt::format(
            "--full-range is for 16-bit heights in .png, .r16 or .raw: '{}' has floats", path.string()));
    if (compression == "none" || exr || render::has_extension(path, ".exr"))
        return;
    if (!render::is_tiff(path))
        throw RequestError("--compression requires an EXR or a TIFF");
    if (compression != "zip")
        throw RequestError(fmt::format("--compression '{}': expected none or zip for a TIFF", compression));
}

render::Elevation parse_elevation(std::string_view text) {
    constexpr std::string_view accepted = "LOW,HIGH, the lower height first";
    const auto [low, high] = parse_numbers<double, 2>("--elevation", text, ',', accepted);
    if (!(low < high && std::isfinite(high - low)))
        refuse("--elevation", text, accepted);
    return {low, high};
}

void add_parameter(CLI::App& command, ParameterOptions& options, const render::Parameter& parameter,
                   const render::Request& defaults) {
    // In the order of Type.
    constexpr std::array types{"", "NUMBER", "NUMBER", "ANGLE", "NAME", "FILE", "FILE", "COLOUR"};
    const std::string name = render::option_name(parameter);
    CLI::Option* option =
        parameter.type == Type::flag
            ? command.add_flag(fmt::format("{},!--no-{}", name, name.substr(2)))
                  ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
            : command.add_option(name)->type_name(types.at(static_cast<std::size_t>(parameter.type)));
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
            return p.type == Type::lobes ? render::load_lobes(text) : render::read(p, text);
        }));
    }
    return values;
}

bool is_given(const ParameterOptions& options, std::string_view name) {
    return std::ranges::any_of(
        options, [&](const auto& each) { return each.first->name == name && each.second->count() > 0; });
}

void refuse(std::string_view option, std::string_view text, std::string_view accepted) {
    throw RequestError(fmt::format("{} '{}': expected {}", option, text, accepted));
}

double parse_positive(std::string_view option, std::string_view text, std::string_view accepted) {
    const auto [value] = parse_numbers<double, 1>(option, text, ',', accepted);
    if (!(value > 0 && std::isfinite(value)))
        refuse(option, text, accepted);
    return value;
}

int parse_integer(std::string_view option, std::string_view text, int low, int high, std::string_view where) {
    const std::string accepted = fmt::format("a whole number from {} to {}{}", low, high, where);
    const auto [value] = parse_numbers<int, 1>(option, text, ' ', accepted);
    if (value < low || value > high)
        refuse(option, text, accepted);
    return value;
}

std::array<int, 2> parse_size(std::string_view text, int most) {
    const std::string accepted = fmt::format("WIDTHxHEIGHT or the side of a square, each from 1 to {}", most);
    const bool square = text.find('x') == text.npos;
    const auto side = square ? parse_numbers<int, 1>("--size", text, 'x', accepted) : std::array{0};
    const auto size =
        square ? std::array{side[0], side[0]} : parse_numbers<int, 2>("--size", text, 'x', accepted);
    if (std::ranges::min(size) < 1 || std::ranges::max(size) > most)
        refuse("--size", text, accepted);
    return size;
}

std::string check_extension(std::string_view option, const std::filesystem::path& path,
                            const std::vector<const char*>& accepted, bool required) {
    const auto found = std::ranges::find_if(
        accepted, [&](const char* extension) { return render::has_extension(path, extension); });
    if (found != accepted.end())
        return *found;
    if (!path.has_extension() && path != "-" && !required)
        return "";
    const auto before = std::span(accepted).first(accepted.size() - 1);
    refuse(option, path.string(),
           fmt::format("a file name that ends in {}{}{}", fmt::join(before, ", "),
                       before.empty() ? "" : " or ", accepted.back()));
}

image::Rect parse_region(std::string_view text) {
    const auto [x, y, width, height] = parse_numbers<int, 4>(
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
