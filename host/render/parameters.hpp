#pragma once

#include "render/request.hpp"

#include <functional>
#include <optional>
#include <span>
#include <utility>

namespace gabor::render {

/// The value of any parameter. Integers are `double` too: all that fit here are exact.
using Value = std::variant<bool, double, std::string, std::vector<noise::Lobe>>;

/// Both ends belong to it.
struct Range {
    double low = 0;
    double high = 0;
};

/// One row of the table of what a Request holds. The command line's options, JSON, the checks and their
/// messages, the viewer's controls and its script all come from these rows.
struct Parameter {
    enum class Kind { flag, integer, number, angle, choice, text, recipe, lobes };

    std::string_view name; ///< in JSON; the option has - for _
    Kind kind;
    std::string_view unit;       ///< "cycles per kernel radius"; empty for none
    Range range;                 ///< of integers, numbers and angles; both ends belong to it
    Range slider;                ///< the part of the range that is worth a slider, logarithmic where low > 0
    std::string_view applies_to; ///< the requests that have it, as in "the view slice"; empty for all
    std::string_view help;       ///< a sentence without its full stop

    /// The value; none where the request has no such parameter.
    std::function<std::optional<Value>(const Request&)> get;
    /// Sets a value of the right kind and range, in a request that has the parameter.
    std::function<void(Request&, const Value&)> put;
};

/// The table, in the order in which files and help texts list it.
std::span<const Parameter> parameters();

/// The row of that name. Throws RequestError, listing the names, where there is none.
const Parameter& parameter(std::string_view name);

/// One value of a lobe, as Parameter. Those of a request's only lobe, but for its power, are parameters too.
struct LobeParameter {
    std::string_view name;
    Parameter::Kind kind;
    std::string_view unit;
    Range range;
    Range slider;
    std::string_view help;
    double noise::Lobe::*member;
};

/// What each lobe of a list holds.
std::span<const LobeParameter> lobe_parameters();

/// What a choice, or a recipe, can be.
std::vector<std::string_view> choices(const Parameter& parameter);

/// What is accepted, as in "a number from 2 to 4096 (pixels per kernel radius)".
std::string accepted(const Parameter& parameter);

/// The value that a text stands for: "12", "45deg", "0.7854rad", "true", "horizon", a JSON list of lobes.
/// Throws RequestError, "'text': it takes ...". `to_text` is the way back.
Value read(const Parameter& parameter, std::string_view text);
std::string to_text(const Value& value);

/// Sets values, view and lobes first: they decide which other parameters there are. Throws RequestError where
/// a value is outside its range, or the request has no such parameter.
using Values = std::vector<std::pair<const Parameter*, Value>>;
void set(Request& request, const Values& values);
void set(Request& request, std::string_view name, const Value& value);

/// Sets a parameter from text.
void set_text(Request& request, std::string_view name, std::string_view text);

/// Whether the request has that parameter, with another value than its default.
bool is_set(const Request& request, std::string_view name);

/// Resets everything that conflicts with this parameter, colours too: a window does so where the command line
/// refuses.
void drop_conflicting(Request& request, std::string_view name);

/// Throws RequestError where a value is outside its range, or two conflict.
void check(const Request& request);

/// Whether a material has that parameter; all others are the noise's.
bool applies_to_material(std::string_view name);

/// The request as one JSON object, as kept in the `gabor` attribute of EXR files, and back. `from_json` lets
/// absent values be as they are by default, and ignores those that such a request does not have; throws
/// RequestError on anything else.
std::string to_json(const Request& request);
Request from_json(std::string_view json);

/// The lobes of a JSON list, or of the `lobes` of a request's object, and back. Throws RequestError where
/// there is no such list.
std::vector<noise::Lobe> lobes_from_json(std::string_view json);
std::string lobes_to_json(const std::vector<noise::Lobe>& lobes);

} // namespace gabor::render
