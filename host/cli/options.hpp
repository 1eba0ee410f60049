#pragma once

// Adds and reads the options of commands.

#include "error.hpp"
#include "render/output/heightmap.hpp"
#include "render/request/parameters.hpp"
#include "system/number.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gabor::cli {

/// Adds an option. The help text shows `type` for its value.
template <typename Value>
CLI::Option* add_option(CLI::App& command, const std::string& name, Value& value, const std::string& type,
                        const std::string& help) {
    return command.add_option(name, value, help)->type_name(type);
}

/// Starts a group of options in the help text; an empty name hides them.
void begin_group(CLI::App& command, const std::string& name);

/// Adds an option for a range of heights; `help` says what 0 and 65535 stand for by default.
void add_elevation_option(CLI::App& command, std::optional<std::string>& elevation, std::string_view help);

/// Adds the option that stretches 16-bit heights.
void add_full_range_option(CLI::App& command, bool& full_range);

/// Checks the options of a heightmap that may have an EXR beside it.
void check_height_options(const std::filesystem::path& path, bool full_range, std::string_view compression,
                          bool exr);

/// Reads LOW,HIGH.
render::Elevation parse_elevation(std::string_view text);

/// Parameters from render::parameters(), each with its command-line option.
using ParameterOptions = std::vector<std::pair<const render::Parameter*, const CLI::Option*>>;

/// Adds the option of a parameter. The help text shows the parameter's value in `defaults`, if that has one,
/// or its defaults in other requests.
void add_parameter(CLI::App& command, ParameterOptions& options, const render::Parameter& parameter,
                   const render::Request& defaults);

/// Returns the values of the options that the user gave. Throws a RequestError that names an invalid option.
render::Values given_values(const ParameterOptions& options);

/// Tells whether the user gave the option of a parameter.
bool is_given(const ParameterOptions& options, std::string_view name);

/// Throws RequestError with the message "OPTION 'TEXT': expected ACCEPTED".
[[noreturn]] void refuse(std::string_view option, std::string_view text, std::string_view accepted);

/// Reads `count` numbers with `separator` between them, such as 1024x768 or 0,0,64,64.
template <typename Number, std::size_t count>
std::array<Number, count> parse_numbers(std::string_view option, std::string_view text, char separator,
                                        std::string_view accepted) {
    std::array<Number, count> values{};
    const char* at = text.data();
    const char* end = at + text.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0 && (at == end || *at++ != separator))
            refuse(option, text, accepted);
        const auto [stop, error] = system::from_chars(at, end, values[i]);
        if (error != std::errc())
            refuse(option, text, accepted);
        at = stop;
    }
    if (at != end)
        refuse(option, text, accepted);
    return values;
}

/// Reads a finite number above 0.
double parse_positive(std::string_view option, std::string_view text, std::string_view accepted);

/// Reads a whole number from `low` to `high`. Error messages append `where` to these limits.
int parse_integer(std::string_view option, std::string_view text, int low, int high,
                  std::string_view where = "");

/// Reads WIDTHxHEIGHT.
std::array<int, 2> parse_size(std::string_view text, int most);

/// Returns the extension of a file name, in lower case. Throws RequestError unless it is one of `accepted`,
/// or empty and not `required`.
std::string check_extension(std::string_view option, const std::filesystem::path& path,
                            const std::vector<const char*>& accepted, bool required);

/// Reads X,Y,WIDTH,HEIGHT.
image::Rect parse_region(std::string_view text);

/// Throws RequestError unless `region` lies within `width` x `height` pixels. The message calls the region
/// `whose` and the picture `whole`.
void check_within(const image::Rect& region, int width, int height, std::string_view whose,
                  std::string_view whole);

} // namespace gabor::cli
