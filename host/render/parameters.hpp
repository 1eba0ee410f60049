#pragma once

#include "render/request.hpp"

#include <functional>
#include <optional>
#include <span>

namespace gabor::render {

/// The value of any parameter. Integers are `double` too: all that fit here are exact.
using Value = std::variant<bool, double, std::string, std::vector<noise::Lobe>>;

struct Range {
    double low = 0;
    double high = 0;
};

/// One row of the table of what a Request holds. Options of the command line, JSON, checks and their
/// messages, the viewer's controls and its script all come from these rows.
struct Parameter {
    enum class Kind { flag, integer, number, angle, choice, text, recipe, lobes };

    std::string_view name; ///< in JSON; the option has - for _
    Kind kind;
    std::string_view unit; ///< "cycles per kernel radius"; empty for none
    Range range;           ///< of integers, numbers and angles; both ends belong to it
    Range slider;          ///< the part of the range that is worth a slider, logarithmic where low > 0
    std::string_view help;

    /// The value; none where the view or the lobes of the request have no such parameter: `depth` but for a
    /// slice, `frequency` where there are several lobes.
    std::function<std::optional<Value>(const Request&)> get;
    /// Puts in a value of the parameter's kind and range. Throws RequestError where `get` has none.
    std::function<void(Request&, const Value&)> put;
};

/// The table, in the order in which files and help texts list it.
std::span<const Parameter> parameters();

/// The row of that name. Throws RequestError, naming the closest ones, where there is none.
const Parameter& parameter(std::string_view name);

/// What a choice can be, or the names of the recipes.
std::vector<std::string_view> choices(const Parameter& parameter);

/// What is accepted, as in "a number from 2 to 4096, in pixels per kernel radius".
std::string accepted(const Parameter& parameter);

/// The value that a text stands for: "12", "45deg", "0.7854rad", "true", "horizon", a JSON list of lobes.
/// Throws RequestError, saying what is accepted. `written` is the way back.
Value read(const Parameter& parameter, std::string_view text);
std::string written(const Parameter& parameter, const Value& value);

/// Whether the request has that parameter, and with another value than by default.
bool is_set(const Request& request, std::string_view name);

/// Puts in the value, checked against its range. Throws RequestError where it is outside or does not belong
/// to the view or the lobes of the request.
void set(Request& request, std::string_view name, const Value& value);
void set(Request& request, std::string_view name, std::string_view text);

/// Sets back to their defaults all parameters that cannot stand beside this one as it is: what a window does
/// where the command line refuses.
void give_way(Request& request, std::string_view name);

/// Throws RequestError when a value is outside its range, or two exclude each other.
void check(const Request& request);

/// The request as one JSON object, as kept in the `gabor` attribute of EXR files, and back. `from_json` lets
/// absent values be as they are by default, and ignores those that its view or its lobes do not have; throws
/// RequestError on any other thing.
std::string to_json(const Request& request);
Request from_json(std::string_view json);

/// The lobes of a JSON list, or of the `lobes` of a request's object. Throws RequestError where there are
/// none.
std::vector<noise::Lobe> lobes_from_json(std::string_view json);

} // namespace gabor::render
