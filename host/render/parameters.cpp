#include "render/parameters.hpp"

#include "error.hpp"
#include "render/material.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace gabor::render {

namespace {

using namespace std::string_view_literals;
using Kind = Parameter::Kind;
using noise::Lobe;

constexpr Range none{};
constexpr std::size_t most_lobes = 16;
constexpr std::string_view one_lobe = "a single lobe";
constexpr std::string_view bodies = "the sphere or torus view";
constexpr std::string_view terrains = "the terrain or landscape view";
constexpr std::string_view lit_views = "a material or terrain";
constexpr std::string_view orbits = "the sphere, torus or landscape view";

struct NamedView {
    std::string_view name;
    View view;
};

const std::array named_views{NamedView{"flat", Plane()},
                             NamedView{"horizon", Horizon()},
                             NamedView{"slice", Slice()},
                             NamedView{"sphere", Body{Shape::sphere}},
                             NamedView{"torus", Body{Shape::torus}},
                             NamedView{"terrain", Terrain()},
                             NamedView{"landscape", Terrain{.perspective = true}}};

std::string_view name_of(const View& view) {
    if (const Body* body = std::get_if<Body>(&view))
        return body->shape == Shape::sphere ? "sphere" : "torus";
    if (const Terrain* terrain = std::get_if<Terrain>(&view))
        return terrain->perspective ? "landscape" : "terrain";
    return named_views[view.index()].name; // the first three are in the order of View's types
}

// Returns the view with that name. It keeps the values that the previous view also has.
View view_of(std::string_view name, const View& before) {
    const View& fresh = std::ranges::find(named_views, name, &NamedView::name)->view;
    if (fresh.index() != before.index())
        return fresh;
    View view = before;
    if (Body* body = std::get_if<Body>(&view))
        body->shape = std::get<Body>(fresh).shape;
    if (Terrain* terrain = std::get_if<Terrain>(&view))
        terrain->perspective = std::get<Terrain>(fresh).perspective;
    return view;
}

// ---- The table ----

// Makes a row from a function that returns a pointer to a request's value, or null if the request has none.
template <typename Find>
Parameter row(std::string_view name, Kind kind, std::string_view unit, Range range, Range slider,
              std::string_view applies_to, std::string_view help, Find find) {
    using T = std::remove_pointer_t<decltype(find(std::declval<Request&>()))>;
    using Held = std::conditional_t<std::is_arithmetic_v<T> && !std::is_same_v<T, bool>, double, T>;
    return {name,
            kind,
            unit,
            range,
            slider,
            std::string(applies_to),
            help,
            [find](const Request& request) {
                const T* value = find(request);
                return value ? std::optional<Value>(static_cast<Held>(*value)) : std::nullopt;
            },
            [find](Request& request, const Value& value) {
                *find(request) = static_cast<T>(std::get<Held>(value));
            }};
}

template <typename Find>
Parameter flag(std::string_view name, std::string_view applies_to, std::string_view help, Find find) {
    return row(name, Kind::flag, "", none, none, applies_to, help, find);
}

// Each of these returns a function that finds a value in a request: in_view a member of one kind of view,
// in_orbit a camera setting of a body or landscape, and if_lit a setting of the light.
template <typename OneView, typename T>
auto in_view(T OneView::*member) {
    return [member](auto& request) {
        auto* view = std::get_if<OneView>(&request.view);
        return view ? &(view->*member) : nullptr;
    };
}

auto in_orbit(double Body::*of_body, double Terrain::*of_terrain) {
    return [=](auto& request) {
        auto* body = std::get_if<Body>(&request.view);
        auto* terrain = std::get_if<Terrain>(&request.view);
        return body ? &(body->*of_body) : terrain && terrain->perspective ? &(terrain->*of_terrain) : nullptr;
    };
}

auto if_lit(double Request::*member) {
    return [member](auto& request) { return has_material(request) ? &(request.*member) : nullptr; };
}

Parameter erosion_row(std::string_view name, Range range, Range slider, std::string_view help,
                      double Erosion::*member) {
    return row(name, Kind::number, "", range, slider, terrains, help, [member](auto& request) {
        auto* terrain = std::get_if<Terrain>(&request.view);
        return terrain ? &(terrain->erosion.*member) : nullptr;
    });
}

constexpr LobeParameter lobe_row(std::string_view name, Kind kind, std::string_view unit, Range range,
                                 Range slider, std::string_view help, double Lobe::*member) {
    return {name, kind, unit, range, slider, help, member};
}

constexpr std::array of_lobe{
    lobe_row("frequency", Kind::number, "cycles per kernel radius", {0.001, 1024}, {0.05, 64},
             "Frequency of the waves", &Lobe::frequency),
    lobe_row("orientation", Kind::angle, "degrees", {-36000, 36000}, {-180, 180},
             "Direction across the waves: 0 points right, 90 down", &Lobe::orientation),
    lobe_row("frequency_spread", Kind::number, "fraction of the frequency", {0, 1}, {0, 1},
             "Half-width of the range of frequencies", &Lobe::frequency_spread),
    lobe_row("orientation_spread", Kind::angle, "degrees", {0, 90}, {0, 90},
             "Half-width of the range of directions; 90 gives all directions", &Lobe::orientation_spread),
    lobe_row("power", Kind::number, "relative to other lobes", {0, 1e9}, {0, 1}, "Share of the variance",
             &Lobe::power),
    lobe_row("radius", Kind::number, "kernel radii", {0.01, 100}, {0.1, 10},
             "Radius of the kernels; a larger radius makes the lobe narrower", &Lobe::radius),
    lobe_row("stretch", Kind::number, "", {0.01, 100}, {0.1, 10},
             "Radius of the kernels along y, divided by their radius along x", &Lobe::stretch),
};

Parameter single_lobe_row(const LobeParameter& p) {
    return row(p.name, p.kind, p.unit, p.range, p.slider, one_lobe, p.help,
               [member = p.member](auto& request) {
                   return request.lobes.size() == 1 ? &(request.lobes.front().*member) : nullptr;
               });
}

// A parameter of a material. Numbers and angles use only the first of the three defaults.
struct MaterialRow {
    std::string_view name;
    Kind kind;
    Range range;
    std::array<double, 3> by_default;
    std::string_view help;
};

constexpr MaterialRow of_materials[]{
#include "render/material_rows.inc"
};

std::string_view material_of(std::string_view name) {
    return name.substr(0, name.find('.'));
}

Parameter material_row(const MaterialRow& made) {
    return {made.name,
            made.kind,
            made.kind == Kind::angle ? "degrees" : "",
            made.range,
            made.kind == Kind::angle && made.range.low < 0 ? Range{-180, 180} : made.range,
            fmt::format("the {} material", material_of(made.name)),
            made.help,
            [&made](const Request& request) -> std::optional<Value> {
                if (request.material != material_of(made.name))
                    return {};
                const auto found = request.look.find(made.name);
                const std::array<double, 3>& value =
                    found == request.look.end() ? made.by_default : found->second;
                return made.kind == Kind::colour ? Value(value) : Value(value[0]);
            },
            [&made](Request& request, const Value& value) {
                std::array<double, 3> numbers{};
                if (made.kind == Kind::colour)
                    numbers = std::get<std::array<double, 3>>(value);
                else
                    numbers[0] = std::get<double>(value);
                if (numbers == made.by_default)
                    request.look.erase(made.name);
                else
                    request.look[made.name] = numbers;
            }};
}

std::vector<Parameter> make_table() {
    std::vector<Parameter> table{
        row("width", Kind::integer, "pixels", {1, 65536}, {64, 8192}, "", "Picture width",
            [](auto& r) { return &r.width; }),
        row("height", Kind::integer, "pixels", {1, 65536}, {64, 8192}, "", "Picture height",
            [](auto& r) { return &r.height; }),
        row("scale", Kind::number, "pixels per kernel radius", {2, 4096}, {2, 512}, "", "Scale of the noise",
            [](auto& r) { return &r.scale; }),
        {"recipe", Kind::recipe, "", none, none, "", "Variant of the noise",
         [](const Request& r) { return Value(noise::to_string(r.recipe)); },
         [](Request& r, const Value& v) { r.recipe = noise::find_recipe(std::get<std::string>(v)); }},
        single_lobe_row(of_lobe[0]),
        single_lobe_row(of_lobe[1]),
        single_lobe_row(of_lobe[2]),
        single_lobe_row(of_lobe[3]),
        {"lobes", Kind::lobes, "", none, none, "",
         "The power spectrum as a list of lobes, whose noises are added",
         [](const Request& r) { return Value(r.lobes); },
         [](Request& r, const Value& v) { r.lobes = std::get<std::vector<Lobe>>(v); }},
        row("seed", Kind::integer, "", {0, 4294967295}, {0, 1000}, "",
            "Seed; each seed gives a different noise", [](auto& r) { return &r.seed; }),
        row("time", Kind::number, "periods", {-1e6, 1e6}, {0, 1}, "", "Time in an animation with period 1",
            [](auto& r) { return &r.time; }),
        {"view", Kind::choice, "", none, none, "",
         "`horizon` is a plane in perspective, with the scale at its bottom row; `slice` cuts through noise "
         "in space; `sphere` and `torus` show noise on their surface; `terrain` shows eroded mountains from "
         "above and `landscape` in perspective. Terrain has channels R, G, B, height, slope.x, slope.y, "
         "lit.R, lit.G, lit.B, ridge, erosion",
         [](const Request& r) { return Value(std::string(name_of(r.view))); },
         [](Request& r, const Value& v) { r.view = view_of(std::get<std::string>(v), r.view); }},
        {"material", Kind::choice, "", none, none, "",
         "Draw a material instead of the noise, on planes and bodies. It has channels R, G, B (linear), "
         "height, roughness, metalness, slope.x, slope.y, and lit.R, lit.G, lit.B, which a PNG shows. `gabor "
         "materials NAME` lists the options of one material, such as --wood.rings",
         [](const Request& r) { return Value(r.material); },
         [](Request& r, const Value& v) { r.material = std::get<std::string>(v); }},
        flag("tileable", "the flat or terrain view", "Make the picture tile without seams",
             [](auto& r) {
                 auto* plane = std::get_if<Plane>(&r.view);
                 auto* terrain = std::get_if<Terrain>(&r.view);
                 return plane                              ? &plane->tileable
                        : terrain && !terrain->perspective ? &terrain->tileable
                                                           : nullptr;
             }),
        row("depth", Kind::number, "kernel radii", {-1e6, 1e6}, {-10, 10}, "the slice view",
            "Depth of the slice", in_view(&Slice::depth)),
        flag("solid", bodies, "Cut the body from solid noise", in_view(&Body::solid)),
        row("yaw", Kind::angle, "degrees", {-36000, 36000}, {-180, 180}, orbits,
            "Camera angle around the body or the landscape", in_orbit(&Body::yaw, &Terrain::yaw)),
        row("pitch", Kind::angle, "degrees", {-90, 90}, {-90, 90}, orbits,
            "Camera angle above the equator or the ground", in_orbit(&Body::pitch, &Terrain::pitch)),
        row("zoom", Kind::number, "", {0.1, 100}, {0.1, 10}, orbits, "Zoom factor; 1 shows the whole body",
            in_orbit(&Body::zoom, &Terrain::zoom)),
        row("light_azimuth", Kind::angle, "degrees", {-36000, 36000}, {-180, 180}, lit_views,
            "Direction that the light comes from: 0 is right, 90 below", if_lit(&Request::light_azimuth)),
        row("light_elevation", Kind::angle, "degrees", {0, 90}, {0, 90}, lit_views,
            "Angle of the light above the surface", if_lit(&Request::light_elevation)),
        {"environment", Kind::choice, "", none, none, "a material",
         "What surrounds a material besides its lamp: a room with a window, an overcast sky, or nothing",
         [](const Request& r) {
             return has_material(r) && !has_terrain(r)
                        ? std::optional<Value>(
                              std::string(environments.at(static_cast<std::size_t>(r.environment))))
                        : std::nullopt;
         },
         [](Request& r, const Value& v) {
             r.environment = static_cast<int>(std::ranges::find(environments, std::get<std::string>(v)) -
                                              environments.begin());
         }},
        row("extent", Kind::number, "", {0, 1e9}, {0, 10000}, terrains,
            "Width of the picture in the unit of heights; 0 gives heights in kernel radii",
            in_view(&Terrain::extent)),
        row("octaves", Kind::integer, "", {0, 16}, {0, 10}, terrains, "Octaves of gullies",
            [](auto& r) {
                auto* terrain = std::get_if<Terrain>(&r.view);
                return terrain ? &terrain->erosion.octaves : nullptr;
            }),
        erosion_row("gully_frequency", {1e-3, 1e4}, {0.1, 10},
                    "Number of first-octave gullies per kernel radius", &Erosion::frequency),
        erosion_row("strength", {0, 10}, {0, 0.5}, "Depth of first-octave gullies times their frequency",
                    &Erosion::strength),
        erosion_row("lacunarity", {1, 8}, {1, 4}, "Frequency of an octave, relative to the previous one",
                    &Erosion::lacunarity),
        erosion_row("gain", {0, 2}, {0, 1}, "Depth of an octave, relative to the previous one",
                    &Erosion::gain),
        erosion_row("onset", {1e-6, 100}, {0.01, 4}, "Slope at which gullies reach their full depth",
                    &Erosion::onset),
        erosion_row("detail", {0.1, 100}, {0.1, 10},
                    "How far fine gullies reach into creases and onto ridges", &Erosion::detail),
        erosion_row("uniformity", {0, 100}, {0, 8}, "How uniform the depths of gullies are",
                    &Erosion::uniformity),
        erosion_row("ridge_rounding", {0, 10}, {0, 2}, "Width of rounded ridges", &Erosion::ridge_rounding),
        erosion_row("crease_rounding", {0, 10}, {0, 2}, "Width of rounded creases",
                    &Erosion::crease_rounding),
        erosion_row("gully_weight", {0, 1}, {0, 1},
                    "Depth of gullies, relative to how far peaks rise and valleys sink",
                    &Erosion::gully_weight),
        erosion_row("branching", {0, 10}, {0, 2}, "How much gullies turn the finer gullies beside them",
                    &Erosion::branching),
        flag("filter", "",
             "Antialias with a Gaussian filter whose standard deviation is half a pixel. In the plane, this "
             "adds a channel `removed`: the share of the variance that the filter removes",
             [](auto& r) { return &r.filter; }),
        row("paint", Kind::text, "", none, none, "",
            "A map stretched over the picture. In a PNG, JPEG or TGA, red and green minus one half are the "
            "components, to the right and down, of a vector along the crests of the waves; --orientation "
            "turns this vector. An EXR has channels `frequency` and `orientation` (degrees)",
            [](auto& r) { return &r.paint; }),
        flag("quadrature", "", "Add a channel `quadrature`: the noise with cosines instead of sines",
             [](auto& r) { return &r.quadrature; }),
        flag("gradient", "",
             "Add channels `gradient.x` and `gradient.y`: derivatives to the right and down, per kernel "
             "radius",
             [](auto& r) { return &r.gradient; }),
        flag("phasor", "", "Add channels `phase` (turns) and `intensity`", [](auto& r) { return &r.phasor; }),
        row("values", Kind::integer, "", {1, 4}, {1, 4}, "", "Number of independent noises per pixel",
            [](auto& r) { return &r.values; }),
    };
    std::ranges::transform(of_materials, std::back_inserter(table), material_row);
    return table;
}

// ---- Conflicts ----

struct Exclusion {
    std::string_view parameter;
    std::string_view other;
    bool (*conflicts)(const Request&); // whether they conflict in a request
    std::string_view because;
};

const std::array exclusions{
    Exclusion{"view", "material",
              [](const Request& r) {
                  return (std::holds_alternative<Slice>(r.view) || has_terrain(r)) &&
                         r.material != no_material;
              },
              "only planes and bodies have materials"},
    Exclusion{"paint", "lobes", [](const Request& r) { return !r.paint.empty() && r.lobes.size() > 1; },
              "paint replaces the frequency and orientation of a single lobe"},
    Exclusion{"paint", "view",
              [](const Request& r) { return !r.paint.empty() && !std::holds_alternative<Plane>(r.view); },
              "paint requires --view flat"},
    Exclusion{"values", "recipe",
              [](const Request& r) { return r.values > 1 && !in_space(r) && !r.recipe.is_lattice(); },
              "several values require a lattice recipe"},
    Exclusion{"lobes", "recipe",
              [](const Request& r) {
                  return !r.recipe.is_lattice() &&
                         std::ranges::any_of(r.lobes, [](const Lobe& lobe) { return lobe.stretch != 1; });
              },
              "stretched kernels require a lattice recipe"},
    Exclusion{"filter", "recipe", [](const Request& r) { return r.filter && !can_filter(r); },
              "in the plane, the filter requires the lattice recipe"},
    Exclusion{"view", "recipe",
              [](const Request& r) {
                  return in_space(r) && r.recipe != noise::recipes().front() &&
                         r.recipe != noise::sparse_recipes().front();
              },
              "noise in space always uses the lattice recipe"},
};

// The parameters that materials and terrain use besides their own.
constexpr std::array of_material{
    "width"sv,         "height"sv,          "scale"sv,      "recipe"sv, "seed"sv, "view"sv,
    "filter"sv,        "material"sv,        "yaw"sv,        "pitch"sv,  "zoom"sv, "tileable"sv,
    "light_azimuth"sv, "light_elevation"sv, "environment"sv};
constexpr std::array of_terrain{"width"sv, "height"sv, "scale"sv,   "recipe"sv,
                                "seed"sv,  "view"sv,   "material"sv};

// Returns the parameters that are set although the material or terrain does not use them.
std::vector<const Parameter*> unused_by_material(const Request& request) {
    std::vector<const Parameter*> found;
    if (has_material(request))
        for (const Parameter& p : parameters())
            if (!applies_to_material(request, p.name) && is_set(request, p.name))
                found.push_back(&p);
    return found;
}

// ---- Colour ----

bool are_of_colour(const std::vector<Lobe>& lobes, const noise::Colour& colour) {
    return colour.weights.size() == lobes.size() &&
           std::ranges::all_of(lobes, [](const Lobe& l) { return l.is_one_wave() && l.power > 0; });
}

// Tells whether the request has anything that cannot be coloured.
bool is_colourless(const Request& request) {
    return request.quadrature || request.gradient || request.phasor || request.values > 1 ||
           !request.paint.empty() || has_material(request);
}

// ---- Values ----

std::string accepted_number(Kind kind, const Range& range, std::string_view unit) {
    std::string text =
        fmt::format("{} from {:.10g} to {:.10g}", kind == Kind::integer ? "a whole number" : "a number",
                    range.low, range.high);
    if (!unit.empty())
        text += fmt::format(" ({}{})", unit, kind == Kind::angle ? ", or radians as in 0.7854rad" : "");
    return text;
}

// Converts an sRGB byte to linear light.
double linear(int byte) {
    const double value = byte / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

// Reads "#rrggbb" or three numbers.
std::optional<std::array<double, 3>> read_colour(std::string_view text) {
    std::array<double, 3> colour{};
    const bool hexadecimal = text.starts_with('#') && text.size() == 7;
    const char* at = text.data() + (hexadecimal ? 1 : 0);
    const char* const end = text.data() + text.size();
    for (double& part : colour) {
        if (!hexadecimal && &part != colour.data() && (at == end || *at++ != ','))
            return {};
        int byte = 0;
        const auto [stop, error] =
            hexadecimal ? std::from_chars(at, at + 2, byte, 16) : std::from_chars(at, end, part);
        if (error != std::errc() || (hexadecimal && stop != at + 2))
            return {};
        if (hexadecimal)
            part = linear(byte);
        at = stop;
    }
    return at == end ? std::optional(colour) : std::nullopt;
}

bool has_range(Kind kind) {
    return kind == Kind::integer || kind == Kind::number || kind == Kind::angle;
}

[[noreturn]] void refuse(std::string_view text, std::string_view what_is_accepted) {
    throw RequestError(fmt::format("'{}': expected {}", text, what_is_accepted));
}

bool within(double value, const Range& range) {
    return value >= range.low && value <= range.high;
}

void check_lobes(const std::vector<Lobe>& lobes) {
    if (lobes.empty())
        throw RequestError("the list of lobes is empty");
    if (lobes.size() > most_lobes)
        throw RequestError(fmt::format("a spectrum has at most {} lobes", most_lobes));
    for (const Lobe& lobe : lobes)
        for (const LobeParameter& p : of_lobe)
            if (!within(lobe.*p.member, p.range))
                throw RequestError(fmt::format("{} {} of a lobe: expected {}", p.name, lobe.*p.member,
                                               accepted_number(p.kind, p.range, p.unit)));
    if (std::ranges::none_of(lobes, [](const Lobe& lobe) { return lobe.power > 0; }))
        throw RequestError("every lobe has power 0: at least one must have more");
}

void check_value(const Parameter& p, const Value& value) {
    const auto refused = [&] { refuse(to_text(value), accepted(p)); };
    if (has_range(p.kind)) {
        const double number = std::get<double>(value);
        if (!within(number, p.range) || (p.kind == Kind::integer && number != std::floor(number)))
            refused();
    } else if (p.kind == Kind::colour) {
        for (const double part : std::get<std::array<double, 3>>(value))
            if (!within(part, p.range))
                refused();
    } else if (p.kind == Kind::choice) {
        const std::vector<std::string_view> all = choices(p);
        if (std::ranges::find(all, std::get<std::string>(value)) == all.end())
            refused();
    } else if (p.kind == Kind::recipe) {
        noise::find_recipe(std::get<std::string>(value));
    } else if (p.kind == Kind::lobes) {
        check_lobes(std::get<std::vector<Lobe>>(value));
    }
}

// Returns the beginning of a message about a parameter.
std::string prefix(const Parameter& p) {
    return fmt::format("{}{} ", p.name, p.kind == Kind::lobes ? ":" : "");
}

} // namespace

std::span<const Parameter> parameters() {
    static const std::vector<Parameter> table = make_table();
    return table;
}

std::string option_name(const Parameter& parameter) {
    std::string name = fmt::format("--{}", parameter.name);
    std::ranges::replace(name, '_', '-');
    return name;
}

std::vector<const Parameter*> erosion_parameters() {
    std::vector<const Parameter*> found;
    bool reached = false; // whether the loop has reached the rows of erosion
    for (const Parameter& p : parameters())
        if ((reached |= p.name == "octaves") && p.applies_to == terrains)
            found.push_back(&p);
    return found;
}

std::span<const LobeParameter> lobe_parameters() {
    return of_lobe;
}

const Parameter& parameter(std::string_view name) {
    const auto found = std::ranges::find(parameters(), name, &Parameter::name);
    if (found != parameters().end())
        return *found;
    std::vector<std::string_view> names; // parameters of the material in `name`, or the general ones
    for (const Parameter& p : parameters())
        if (is_of_one_material(p) ? name.starts_with(fmt::format("{}.", material_of(p.name)))
                                  : name.find('.') == name.npos)
            names.push_back(p.name);
    throw RequestError(
        fmt::format("unknown parameter '{}': the parameters are {}", name, fmt::join(names, ", ")));
}

std::vector<std::string_view> choices(const Parameter& p) {
    std::vector<std::string_view> names;
    if (p.name == "material") {
        names.assign(materials.begin(), materials.end());
        names.insert(names.begin(), no_material);
    } else if (p.name == "environment") {
        names.assign(environments.begin(), environments.end());
    } else if (p.kind == Kind::choice) {
        std::ranges::transform(named_views, std::back_inserter(names), &NamedView::name);
    } else {
        std::ranges::transform(noise::recipes(), std::back_inserter(names), &noise::Recipe::name);
    }
    return names;
}

std::string accepted(const Parameter& p) {
    switch (p.kind) {
    case Kind::flag:
        return "true or false";
    case Kind::choice:
        return fmt::format("{}", fmt::join(choices(p), ", "));
    case Kind::recipe:
        return noise::accepted_recipes();
    case Kind::text:
        return "a name";
    case Kind::colour:
        return "a colour: #rrggbb, or linear red, green and blue from 0 to 1, as in 0.5,0.3,0.1";
    case Kind::lobes:
        return "a list like [{\"frequency\": 4, \"orientation\": 45, \"power\": 1}]";
    default:
        return accepted_number(p.kind, p.range, p.unit);
    }
}

Value read(const Parameter& p, std::string_view text) {
    Value value;
    if (has_range(p.kind)) {
        std::string_view digits = text;
        bool in_radians = false;
        if (p.kind == Kind::angle) {
            in_radians = digits.ends_with("rad");
            if (in_radians || digits.ends_with("deg"))
                digits.remove_suffix(3);
        }
        double number = 0;
        std::int64_t whole = 0;
        const char* end = digits.data() + digits.size();
        const auto [stop, error] = p.kind == Kind::integer ? std::from_chars(digits.data(), end, whole)
                                                           : std::from_chars(digits.data(), end, number);
        if (error != std::errc() || stop != end)
            refuse(text, accepted(p));
        if (p.kind == Kind::integer)
            number = static_cast<double>(whole);
        value = in_radians ? noise::degrees(number) : number;
    } else if (p.kind == Kind::flag) {
        if (text != "true" && text != "false")
            refuse(text, accepted(p));
        value = text == "true";
    } else if (p.kind == Kind::lobes) {
        value = lobes_from_json(text);
    } else if (p.kind == Kind::colour) {
        const auto colour = read_colour(text);
        if (!colour)
            refuse(text, accepted(p));
        value = *colour;
    } else {
        value = std::string(text);
    }
    check_value(p, value);
    return value;
}

std::string to_text(const Value& value) {
    if (const auto* text = std::get_if<std::string>(&value))
        return *text;
    if (const auto* number = std::get_if<double>(&value))
        return fmt::format("{}", *number);
    if (const auto* on = std::get_if<bool>(&value))
        return *on ? "true" : "false";
    if (const auto* colour = std::get_if<std::array<double, 3>>(&value))
        return fmt::format("{}", fmt::join(*colour, ","));
    return lobes_to_json(std::get<std::vector<Lobe>>(value));
}

void set(Request& request, const Values& values) {
    for (const bool deciding : {true, false}) {
        for (const auto& named : values) { // clang's lambdas cannot capture structured bindings
            const Parameter* p = named.first;
            const Value& value = named.second;
            if (deciding != (p->applies_to.empty() && (p->kind == Kind::choice || p->kind == Kind::lobes)))
                continue;
            with_prefix(prefix(*p), [&] { check_value(*p, value); });
            if (!p->get(request))
                throw RequestError(
                    fmt::format("{} requires {}, not {}", p->name, p->applies_to,
                                p->applies_to == one_lobe ? fmt::format("{}", request.lobes.size())
                                : is_of_one_material(*p)  ? request.material
                                                          : std::string(name_of(request.view))));
            p->put(request, value);
        }
    }
}

void set(Request& request, std::string_view name, const Value& value) {
    set(request, Values{{&parameter(name), value}});
}

bool is_set(const Request& request, std::string_view name) {
    const Parameter& p = parameter(name);
    const std::optional<Value> value = p.get(request);
    std::optional<Value> by_default = p.get(Request());
    if (!by_default) { // the default request lacks this parameter
        Request fresh;
        fresh.lobes = request.lobes;
        fresh.material = request.material;
        fresh.view = view_of(name_of(request.view), fresh.view);
        by_default = p.get(fresh);
    }
    return value && value != by_default;
}

void drop_conflicting(Request& request, std::string_view name) {
    for (const Parameter* p : unused_by_material(request)) {
        if (name == p->name) {
            request.material = no_material;
            if (has_terrain(request))
                request.view = Plane();
        } else if (const auto value = p->get(Request());
                   (name == "material" || name == "view") && value && p->get(request))
            p->put(request, *value);
    }
    for (const Exclusion& exclusion : exclusions) {
        if (!exclusion.conflicts(request) || (name != exclusion.parameter && name != exclusion.other))
            continue;
        const std::string_view loser = name == exclusion.parameter ? exclusion.other : exclusion.parameter;
        if (loser == "lobes")
            request.lobes.resize(1);
        else
            parameter(loser).put(request, *parameter(loser).get(Request()));
    }
    if (request.colour && (is_colourless(request) || !are_of_colour(request.lobes, *request.colour)))
        request.colour.reset();
}

bool is_of_one_material(const Parameter& p) {
    return p.name.find('.') != p.name.npos;
}

std::vector<float> material_parameters(const Request& request) {
    std::vector<float> values;
    for (const Parameter& p : parameters()) {
        if (!is_of_one_material(p))
            continue;
        const std::optional<Value> value = p.get(request);
        if (!value)
            continue;
        if (const auto* colour = std::get_if<std::array<double, 3>>(&*value)) {
            values.resize((values.size() + 3) / 4 * 4); // std430 aligns vec3 to four floats
            for (const double part : *colour)
                values.push_back(static_cast<float>(part));
        } else {
            const double number = std::get<double>(*value);
            values.push_back(static_cast<float>(p.kind == Kind::angle ? noise::radians(number) : number));
        }
    }
    return values;
}

bool applies_to_material(const Request& request, std::string_view name) {
    if (!has_terrain(request))
        return name.find('.') != name.npos || std::ranges::find(of_material, name) != of_material.end();
    return std::ranges::find(of_terrain, name) != of_terrain.end() ||
           (parameter(name).applies_to != one_lobe && !parameter(name).applies_to.empty() &&
            parameter(name).get(request));
}

void check(const Request& request) {
    for (const Parameter& p : parameters())
        if (const std::optional<Value> value = p.get(request))
            with_prefix(prefix(p), [&] { check_value(p, *value); });
    for (const Exclusion& exclusion : exclusions)
        if (exclusion.conflicts(request)) {
            const auto described = [&](std::string_view name) {
                return name == "view" ? fmt::format("view {}", name_of(request.view)) : std::string(name);
            };
            throw RequestError(fmt::format("{} conflicts with {}: {}", described(exclusion.parameter),
                                           described(exclusion.other), exclusion.because));
        }
    for (const Parameter* p : unused_by_material(request))
        throw RequestError(fmt::format("{} conflicts with {}: only the noise has this parameter", p->name,
                                       has_terrain(request) ? fmt::format("view {}", name_of(request.view))
                                                            : "material " + request.material));
    if (request.colour && !are_of_colour(request.lobes, *request.colour))
        throw RequestError("colour requires weights for each lobe, and lobes with power but no spread: "
                           "use the lobes that came with the colour");
    if (request.colour && is_colourless(request))
        throw RequestError(
            "colours conflict with paint, materials, quadrature, gradient, phasor and several values");
    const auto require_sides = [&](std::string_view what, double units, std::string_view described) {
        const double least = std::ceil(units * request.scale);
        if (std::min(request.width, request.height) < least)
            throw RequestError(
                fmt::format("a {} of {} x {} pixels at scale {} is too small: each side must be at least {}, "
                            "{} pixels",
                            what, request.width, request.height, request.scale, described, least));
    };
    if (const Terrain* terrain = std::get_if<Terrain>(&request.view); terrain && terrain->tileable)
        require_sides("terrain tile", 4, "four kernel radii");
    else if (!terrain && is_tiled(request) && !has_material(request))
        require_sides("tileable picture",
                      2 * std::ranges::max(request.lobes, {}, &Lobe::longest_radius).longest_radius(),
                      request.lobes.size() > 1 ? "two kernel radii of its widest lobe" : "two kernel radii");
}

} // namespace gabor::render
