#pragma once

#include "render/request.hpp"

#include <functional>
#include <optional>
#include <span>
#include <utility>

namespace gabor::render {

/// The value of a parameter. Integers are stored as `double`, which holds all of them exactly. Colours are
/// linear.
using Value = std::variant<bool, double, std::string, std::vector<noise::Lobe>, std::array<double, 3>>;

/// A closed interval.
struct Range {
    double low = 0;
    double high = 0;
};

/// A row of the table that describes a Request. Command-line options, JSON, checks, their messages and the
/// viewer's controls all come from these rows.
struct Parameter {
    enum class Kind { flag, integer, number, angle, choice, text, recipe, lobes, colour };

    std::string_view name; ///< name in JSON; the command-line option has - instead of _
    Kind kind;
    std::string_view unit;  ///< such as "cycles per kernel radius"; empty for none
    Range range;            ///< limits of integers, numbers and angles
    Range slider;           ///< the part of the range that a slider covers, logarithmic if low > 0
    std::string applies_to; ///< which requests have this parameter, as in "the slice view"; empty if all do
    std::string_view help;  ///< a sentence without its full stop

    /// Returns the value, or nothing if the request has no such parameter.
    std::function<std::optional<Value>(const Request&)> get;
    /// Sets a valid value in a request that has the parameter.
    std::function<void(Request&, const Value&)> put;
};

/// The table, in the order in which files and help texts list it.
std::span<const Parameter> parameters();

/// The command-line option for a parameter.
std::string option_name(const Parameter& parameter);

/// The rows for the members of GaborErosion.
std::vector<const Parameter*> erosion_parameters();

/// Returns the parameter with that name. Throws RequestError, listing the names, if there is none.
const Parameter& parameter(std::string_view name);

/// A value of a lobe, described as in Parameter.
struct LobeParameter {
    std::string_view name;
    Parameter::Kind kind;
    std::string_view unit;
    Range range;
    Range slider;
    std::string_view help;
    double noise::Lobe::*member;
};

/// The values of a lobe, in the order in which files list them.
std::span<const LobeParameter> lobe_parameters();

/// The accepted values of a choice or a recipe.
std::vector<std::string_view> choices(const Parameter& parameter);

/// Describes the accepted values, as in "a number from 2 to 4096 (pixels per kernel radius)".
std::string accepted(const Parameter& parameter);

/// Reads a value: "12", "45deg", "0.7854rad", "true", "horizon", "#c08040", "0.5,0.3,0.1" or a JSON list of
/// lobes. Throws RequestError with the message "'text': expected ...". `to_text` is the inverse of `read`.
Value read(const Parameter& parameter, std::string_view text);
std::string to_text(const Value& value);

/// Sets values. Starts with view, material and lobes, which decide what other parameters exist. Throws
/// RequestError for a value out of range, or a parameter that the request does not have.
using Values = std::vector<std::pair<const Parameter*, Value>>;
void set(Request& request, const Values& values);
void set(Request& request, std::string_view name, const Value& value);

/// Tells whether the request has that parameter with a value other than the default.
bool is_set(const Request& request, std::string_view name);

/// Resets every parameter that conflicts with this one, and the colour if it conflicts with anything. The
/// viewer resolves conflicts this way; the command line reports them as errors.
void drop_conflicting(Request& request, std::string_view name);

/// Throws RequestError if a value is out of range, or if two parameters conflict.
void check(const Request& request);

/// Tells whether the request's material or terrain uses that parameter.
bool applies_to_material(const Request& request, std::string_view name);

/// Tells whether this is a parameter of one material, named MATERIAL.PARAMETER.
bool is_of_one_material(const Parameter& parameter);

/// `to_json` writes the request as one JSON object, like the `gabor` attribute of EXR files. `from_json`
/// reads such an object. It uses defaults for absent values, ignores known parameters that this request does
/// not have, and throws RequestError for anything else.
std::string to_json(const Request& request);
Request from_json(std::string_view json);

/// `lobes_from_json` reads a JSON list of lobes, or the `lobes` of a request; it throws RequestError if there
/// is no list. `lobes_to_json` writes a list.
std::vector<noise::Lobe> lobes_from_json(std::string_view json);
std::string lobes_to_json(const std::vector<noise::Lobe>& lobes);

} // namespace gabor::render
