#pragma once

#include "render/request/request.hpp"

#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <variant>

namespace gabor::render {

/// The value of a parameter. Integers are stored as `double`, which holds all of them exactly. Colours are
/// linear.
using Value = std::variant<bool, double, std::string, std::vector<noise::Lobe>, std::array<double, 3>>;

/// A closed interval.
struct Range {
    double low = 0;
    double high = 0;
};

/// The requests that have a parameter.
struct Scope {
    /// The options that give a request the parameter, as in "--view slice", or what it must be, as in
    /// "noise". Empty for all requests.
    std::string described;
    std::function<bool(const Request&)> holds;
};

/// Where requests store a value, whether or not it has an effect.
struct Place {
    std::function<std::optional<Value>(const Request&)> get; ///< nothing if the request has no such place
    std::function<void(Request&, const Value&)> put;         ///< sets a valid value in a request that has it
};

/// A row of the table that describes a Request. Command-line options, JSON, checks, their messages and the
/// viewer's controls all come from these rows.
struct Parameter {
    enum class Type { flag, integer, number, angle, choice, text, lobes, colour };
    /// What a parameter describes. Those of materials are named MATERIAL.PARAMETER.
    enum class Group { picture, noise, view, light, boards, coat, finish, terrain, sea, erosion, material };

    std::string_view name; ///< name in JSON; the command-line option has - instead of _
    Type type;
    std::string_view unit; ///< such as "cycles per kernel radius"; empty for none
    Range range;           ///< limits of integers, numbers and angles
    Range slider;          ///< the part of the range that a slider covers, logarithmic if low > 0
    Scope scope;           ///< the requests that have this parameter; in others it has no effect
    std::string_view help; ///< a sentence without its full stop; of some choices, a line for each
    Place place;
    std::vector<std::string_view> choices = {}; ///< the accepted values of a choice
    Group group = Group::picture;
    bool of_struct = false; ///< a member of a struct of a drop-in

    /// Returns the value, or nothing if the request has no such parameter.
    std::optional<Value> get(const Request& request) const {
        return scope.holds(request) ? place.get(request) : std::nullopt;
    }
};

/// The table, in the order in which files and help texts list it.
std::span<const Parameter> parameters();

/// The command-line option for a parameter.
std::string option_name(const Parameter& parameter);

/// Returns the parameter with that name. Throws RequestError, with similar names, if there is none.
const Parameter& parameter(std::string_view name);

/// A value of a lobe, described as in Parameter.
struct LobeParameter {
    std::string_view name;
    Parameter::Type type;
    std::string_view unit;
    Range range;
    Range slider;
    std::string_view help;
    double noise::Lobe::*member;
};

/// The values of a lobe, in the order in which files list them.
std::span<const LobeParameter> lobe_parameters();

/// Describes the accepted values, as in "a number from 2 to 4096 (pixels per kernel radius)".
std::string accepted(const Parameter& parameter);

/// Reads a value: "12", "45deg", "45°", "0.7854rad", "true", "horizon", "#c08040", "0.5,0.3,0.1" or a JSON
/// list of lobes. Names of choices may have any case. Throws RequestError with the message "'text': expected
/// ...". `to_text` is the inverse of `read`.
Value read(const Parameter& parameter, std::string_view text);
std::string to_text(const Value& value);

/// Tells whether other parameters exist or not depending on this one: view, material, boards, coat, finish
/// and lobes.
bool decides(const Parameter& parameter);

/// Sets values. Starts with those that decide what other parameters exist. Throws
/// RequestError for a value out of range, or a parameter that the request does not have. The message uses
/// `called` to name the parameter, either the name in JSON or the command-line option.
using Values = std::vector<std::pair<const Parameter*, Value>>;
std::string json_name(const Parameter& parameter);
void set(Request& request, const Values& values, std::string (*called)(const Parameter&) = json_name);
void set(Request& request, std::string_view name, const Value& value);

/// The default of a parameter in requests with the same view, material and number of lobes.
std::optional<Value> default_of(const Parameter& parameter, const Request& request);

/// Tells whether the request has that parameter with a value other than the default.
bool is_set(const Request& request, std::string_view name);

/// Resets every parameter that conflicts with this one, and the colour if it conflicts with anything. The
/// viewer resolves conflicts this way; the command line reports them as errors.
void drop_conflicting(Request& request, std::string_view name);

/// Throws RequestError if a value is out of range, or if two parameters conflict.
void check(const Request& request);

/// `to_json` writes the request as one JSON object, like the `gabor` attribute of EXR files. `from_json`
/// reads such an object. It uses defaults for absent values, and throws RequestError for a member that the
/// request does not have.
std::string to_json(const Request& request);
Request from_json(std::string_view json);

/// `lobes_from_json` reads a JSON list of lobes, or the `lobes` of a request; it throws RequestError if there
/// is no list. `lobes_to_json` writes a list.
std::vector<noise::Lobe> lobes_from_json(std::string_view json);
std::string lobes_to_json(const std::vector<noise::Lobe>& lobes);

} // namespace gabor::render
