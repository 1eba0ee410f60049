#include "render/request/parameters.hpp"

#include "error.hpp"
#include "names.hpp"
#include "render/request/material.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>

namespace gabor::render {

namespace {

using Group = Parameter::Group;
using Type = Parameter::Type;
using noise::Lobe;

constexpr Range none{};
constexpr std::size_t most_lobes = 16;

// The values of --view. Those of a place also say what it is.
struct NamedView {
    std::string_view name;
    Projection projection;
    Kind kind = Kind::noise; // or another pattern
};

constexpr std::array named_views{NamedView{"flat", Projection::flat},
                                 NamedView{"horizon", Projection::horizon},
                                 NamedView{"slice", Projection::slice},
                                 NamedView{"sphere", Projection::sphere},
                                 NamedView{"torus", Projection::torus},
                                 NamedView{"terrain", Projection::flat, Kind::terrain},
                                 NamedView{"landscape", Projection::place, Kind::terrain},
                                 NamedView{"ocean", Projection::place, Kind::sea}};

std::string_view view_name(const Request& request) {
    const Kind kind = is_pattern(request.kind) ? Kind::noise : request.kind;
    return std::ranges::find_if(named_views,
                                [&](const NamedView& view) {
                                    return view.projection == request.view.projection && view.kind == kind;
                                })
        ->name;
}

// Keeps the values that the previous view also has.
void put_view(Request& request, std::string_view name) {
    const NamedView& named = *std::ranges::find(named_views, name, &NamedView::name);
    const Kind pattern = is_pattern(request.kind)          ? request.kind
                         : request.material != no_material ? Kind::material
                         : request.fractal.shape != 0      ? Kind::fractal
                                                           : Kind::noise;
    const Kind kind = is_pattern(named.kind) ? pattern : named.kind;
    const View fresh{.projection = named.projection, .orbit = default_orbit(kind)};
    const bool alike = fresh.projection == request.view.projection ||
                       (fresh.is_body() && request.view.is_body()) || !is_pattern(kind);
    if (kind == request.kind && alike)
        request.view.projection = fresh.projection;
    else
        request.view = fresh;
    request.kind = kind;
}

// A material takes the place of another pattern; `check` refuses it elsewhere.
void put_material(Request& request, std::string_view name) {
    request.material = name;
    if (name == no_material)
        request.kind = request.kind == Kind::material ? Kind::noise : request.kind;
    else if (is_pattern(request.kind))
        request.kind = Kind::material;
}

// Fractal noise takes the place of noise; `check` refuses it elsewhere.
void put_fractal(Request& request, std::string_view name) {
    request.fractal.shape =
        static_cast<int>(std::ranges::find(fractal_shapes, name) - fractal_shapes.begin());
    if (request.kind == Kind::noise || request.kind == Kind::fractal)
        request.kind = request.fractal.shape != 0 ? Kind::fractal : Kind::noise;
}

Request plain(Request request) {
    put_material(request, no_material);
    put_fractal(request, fractal_shapes.front());
    return request;
}

// ---- The requests that have a parameter ----

template <Kind... kinds>
bool is(const Request& request) {
    return ((request.kind == kinds) || ...);
}

template <Projection... projections>
bool is_seen(const Request& request) {
    return ((request.view.projection == projections) || ...);
}

// A scope that needs no initialization: programs may use the table before main.
struct Constant {
    std::string_view described;
    bool (*holds)(const Request&);
    operator Scope() const { return {std::string(described), holds}; }
};

namespace scopes {

using enum Projection;

constexpr Constant all{"", [](const Request&) { return true; }};
constexpr Constant noise{"noise", is<Kind::noise>};
constexpr Constant one_lobe{"noise of a single lobe",
                            [](const Request& r) { return noise.holds(r) && r.lobes.size() == 1; }};
constexpr Constant paintable{"noise of a single lobe with --view flat",
                             [](const Request& r) { return one_lobe.holds(r) && is_seen<flat>(r); }};
constexpr Constant planar{"noise with --view flat or horizon",
                          [](const Request& r) { return noise.holds(r) && is_seen<flat, horizon>(r); }};
constexpr Constant bodies{"noise with --view sphere or torus",
                          [](const Request& r) { return noise.holds(r) && r.view.is_body(); }};
constexpr Constant valued{"noise", is<Kind::noise, Kind::fractal>};
constexpr Constant fractal{"--fractal NAME", is<Kind::fractal>};
constexpr Constant patterns{"noise or a material", [](const Request& r) { return is_pattern(r.kind); }};
constexpr Constant scaled{"noise, a material or terrain", [](const Request& r) { return !is<Kind::sea>(r); }};
constexpr Constant tiles{"--view flat or terrain", is_seen<flat>};
constexpr Constant slices{"--view slice", is_seen<slice>};
constexpr Constant orbits{"--view sphere, torus, landscape or ocean",
                          [](const Request& r) { return r.view.has_orbit(); }};
constexpr Constant places{"--view landscape or ocean", is_seen<place>};
constexpr Constant lit{"--material NAME, or --view terrain, landscape or ocean",
                       [](const Request& r) { return is_surface(r.kind); }};
constexpr Constant material{"--material NAME", is<Kind::material>};
constexpr Constant laid{"--boards and --material NAME",
                        [](const Request& r) { return material.holds(r) && r.boards; }};
constexpr Constant coated{"--coat and --material NAME",
                          [](const Request& r) { return material.holds(r) && r.coat; }};
constexpr Constant finished{"--finish and --material NAME",
                            [](const Request& r) { return material.holds(r) && r.finish; }};
constexpr Constant terrain{"--view terrain or landscape", is<Kind::terrain>};
constexpr Constant sea{"--view ocean", is<Kind::sea>};

} // namespace scopes

// What a request has instead of what a scope describes; empty if it has neither a material nor another view.
std::string other_than(const Scope& scope, const Request& request) {
    const auto mentions = [&](std::string_view word) {
        return scope.described.find(word) != std::string::npos;
    };
    if (mentions("lobe") && request.lobes.size() > 1)
        return fmt::format("{} lobes", request.lobes.size());
    const auto is = [&](const Constant& other) { return scope.described == other.described; };
    if ((is(scopes::laid) || is(scopes::coated) || is(scopes::finished)) && request.material != no_material)
        return "";
    if (request.material != no_material && (scope.holds(plain(request)) || mentions("material")))
        return request.material;
    if (request.kind == Kind::fractal && scope.holds(plain(request)))
        return "fractal noise";
    const std::string_view view = view_name(request);
    return view == view_name(Request()) ? "" : std::string(view);
}

// Returns what a scope describes in terms of options, or of JSON.
std::string needed(const Scope& scope, bool options) {
    std::string text = scope.described;
    for (std::size_t at = 0; !options && (at = text.find("--")) != text.npos;)
        text.erase(at, 2);
    return text;
}

// ---- The table ----

// Makes a place from a function that returns a pointer to a request's value, or null if it stores none.
template <typename Find>
Place found_by(Find find) {
    using T = std::remove_pointer_t<decltype(find(std::declval<Request&>()))>;
    using Held = std::conditional_t<std::is_arithmetic_v<T> && !std::is_same_v<T, bool>, double, T>;
    return {[find](const Request& request) {
                const T* value = find(request);
                return value ? std::optional<Value>(static_cast<Held>(*value)) : std::nullopt;
            },
            [find](Request& request, const Value& value) {
                *find(request) = static_cast<T>(std::get<Held>(value));
            }};
}

template <typename T>
Place in_request(T Request::*member) {
    return found_by([member](auto& request) { return &(request.*member); });
}

// A member of a member, such as the view.
template <typename Part, typename T>
Place in_part(Part Request::*part, T Part::*member) {
    return found_by([=](auto& request) { return &(request.*part.*member); });
}

Place in_orbit(double Orbit::*member) {
    return found_by([=](auto& request) { return &(request.view.orbit.*member); });
}

template <typename Get, typename Put>
Place by_name(Get get, Put put) {
    return {[get](const Request& request) { return Value(std::string(get(request))); },
            [put](Request& request, const Value& value) { put(request, std::get<std::string>(value)); }};
}

// `find` returns a reference to a request's index.
template <typename Find>
Place by_index(Find find, std::span<const std::string_view> names) {
    return by_name([=](const Request& r) { return names[static_cast<std::size_t>(find(r))]; },
                   [=](Request& r, const std::string& name) {
                       find(r) = static_cast<int>(std::ranges::find(names, name) - names.begin());
                   });
}

template <typename Named>
std::vector<std::string_view> names_of(const Named& named) {
    std::vector<std::string_view> names;
    for (const auto& each : named)
        names.push_back(each.name);
    return names;
}

constexpr LobeParameter lobe_row(std::string_view name, Type type, std::string_view unit, Range range,
                                 Range slider, std::string_view help, double Lobe::*member) {
    return {name, type, unit, range, slider, help, member};
}

constexpr std::array of_lobe{
    lobe_row("frequency", Type::number, "cycles per kernel radius", {0.001, 1024}, {0.05, 64},
             "Frequency of the waves", &Lobe::frequency),
    lobe_row("orientation", Type::angle, "degrees", {-36000, 36000}, {-180, 180},
             "Direction across the waves: 0 points right, 90 down", &Lobe::orientation),
    lobe_row("frequency_spread", Type::number, "fraction of the frequency", {0, 1}, {0, 1},
             "Half-width of the range of frequencies", &Lobe::frequency_spread),
    lobe_row("orientation_spread", Type::angle, "degrees", {0, 90}, {0, 90},
             "Half-width of the range of directions; 90 gives all directions", &Lobe::orientation_spread),
    lobe_row("power", Type::number, "relative to other lobes", {0, 1e9}, {0, 1}, "Share of the variance",
             &Lobe::power),
    lobe_row("radius", Type::number, "kernel radii", {0.01, 100}, {0.1, 10},
             "Radius of the kernels; a larger radius makes the lobe narrower", &Lobe::radius),
    lobe_row("stretch", Type::number, "", {0.01, 100}, {0.1, 10},
             "Radius of the kernels along y, divided by their radius along x", &Lobe::stretch),
};

Parameter row(std::string_view name, Type type, std::string_view unit, Range range, Range slider,
              const Scope& scope, std::string_view help, Place place,
              std::vector<std::string_view> choices = {}) {
    return {name, type, unit, range, slider, scope, help, std::move(place), std::move(choices)};
}

Parameter single_lobe_row(const LobeParameter& p) {
    return row(p.name, p.type, p.unit, p.range, p.slider, scopes::one_lobe, p.help,
               found_by([member = p.member](auto& request) {
                   return request.lobes.size() == 1 ? &(request.lobes.front().*member) : nullptr;
               }));
}

std::vector<Parameter> picture_rows() {
    return {row("width", Type::integer, "pixels", {1, 65536}, {64, 8192}, scopes::all, "Picture width",
                in_request(&Request::width)),
            row("height", Type::integer, "pixels", {1, 65536}, {64, 8192}, scopes::all, "Picture height",
                in_request(&Request::height))};
}

std::vector<Parameter> noise_rows() {
    std::vector<std::string_view> with_none{no_material};
    with_none.insert(with_none.end(), materials.begin(), materials.end());
    return {
        row("material", Type::choice, "", none, none, scopes::all,
            "Draw a material instead of the noise, on planes and bodies. It has channels R, G, B (linear), "
            "height, roughness, metalness, slope.x, slope.y, and lit.R, lit.G, lit.B, which a PNG shows. "
            "`gabor materials NAME` lists the options of one material, such as --wood.rings",
            by_name([](const Request& r) { return r.material; }, put_material), std::move(with_none)),
        row("boards", Type::flag, "", none, none, scopes::material,
            "Lay the material as planks or tiles, with joints between them. Whole boards fill a tile. `gabor "
            "materials boards` lists the options of boards",
            in_request(&Request::boards)),
        row("coat", Type::flag, "", none, none, scopes::material,
            "Coat the material with paint that wears and chips, or with sand, moss or snow that fills "
            "hollows. "
            "`gabor materials coat` lists the options of coats",
            in_request(&Request::coat)),
        row("finish", Type::flag, "", none, none, scopes::material,
            "Give the material a finish: uneven colour and gloss, dirt, dust and a grain. `gabor materials "
            "finish` lists the options of finishes",
            in_request(&Request::finish)),
        row("scale", Type::number, "pixels per kernel radius", {2, 4096}, {2, 512}, scopes::scaled,
            "Scale of the noise. By default, pictures of terrain span 8 kernel radii, and maps of a "
            "material 4",
            in_request(&Request::scale)),
        row("recipe", Type::choice, "", none, none, scopes::planar,
            "Variant of the noise. `gabor recipes` describes them",
            by_name([](const Request& r) { return r.recipe.name; },
                    [](Request& r, const std::string& name) { r.recipe = noise::find_recipe(name); }),
            names_of(noise::recipes())),
        single_lobe_row(of_lobe[0]),
        single_lobe_row(of_lobe[1]),
        single_lobe_row(of_lobe[2]),
        single_lobe_row(of_lobe[3]),
        row("lobes", Type::lobes, "", none, none, scopes::noise,
            "The power spectrum as a list of lobes, whose noises are added", in_request(&Request::lobes)),
        row("seed", Type::integer, "", {0, 4294967295}, {0, 1000}, scopes::all,
            "Seed; each seed gives a different noise", in_request(&Request::seed)),
        row("evolution", Type::number, "turns", {-1e9, 1e9}, {0, 1}, scopes::valued,
            "How far the noise has evolved in place; it repeats after 1", in_request(&Request::evolution)),
        row("paint", Type::text, "", none, none, scopes::paintable,
            "A map stretched over the picture. In a PNG, JPEG or TGA, red and green minus one half are the "
            "components, to the right and down, of a vector along the crests of the waves; --orientation "
            "turns this vector. An EXR has channels `frequency` and `orientation` (degrees)",
            in_request(&Request::paint)),
        row("gradient", Type::flag, "", none, none, scopes::valued,
            "Add channels `gradient.x` and `gradient.y`: derivatives to the right and down, per kernel "
            "radius",
            in_request(&Request::gradient)),
        row("phasor", Type::flag, "", none, none, scopes::noise,
            "Add channels `phase` (turns) and `intensity`", in_request(&Request::phasor)),
    };
}

std::vector<Parameter> fractal_rows() {
    const auto in_fractal = [](auto Fractal::*member) { return in_part(&Request::fractal, member); };
    return {
        row("fractal", Type::choice, "", none, none, scopes::all,
            "Draw a sum of octaves instead of waves, on planes: fBm, billows or ridges",
            by_name(
                [](const Request& r) { return fractal_shapes.at(static_cast<std::size_t>(r.fractal.shape)); },
                put_fractal),
            {fractal_shapes.begin(), fractal_shapes.end()}),
        row("fractal.octaves", Type::number, "", {1, 16}, {1, 10}, scopes::fractal,
            "Number of octaves; the last fades in with the fraction", in_fractal(&Fractal::octaves)),
        row("fractal.gain", Type::number, "", {0, 4}, {0.2, 1}, scopes::fractal,
            "Amplitude of an octave relative to the previous one", in_fractal(&Fractal::gain)),
        row("fractal.lacunarity", Type::number, "", {1, 4}, {1.5, 3}, scopes::fractal,
            "Frequency of an octave relative to the previous one", in_fractal(&Fractal::lacunarity)),
        row("fractal.turn", Type::angle, "degrees", {-36000, 36000}, {-90, 90}, scopes::fractal,
            "Angle between octaves, unless the picture tiles", in_fractal(&Fractal::turn)),
        row("fractal.basis", Type::choice, "", none, none, scopes::fractal,
            "Noise of an octave: smooth, or with the spectrum of Perlin noise",
            by_index(
                [](auto& r) -> auto& { return r.fractal.basis; }, fractal_bases),
            {fractal_bases.begin(), fractal_bases.end()}),
        row("fractal.warp", Type::number, "kernel radii", {-100, 100}, {0, 1}, scopes::fractal,
            "Strength of a warp by fBm of the same octaves", in_fractal(&Fractal::warp)),
    };
}

std::vector<Parameter> view_rows() {
    return {
        row("view", Type::choice, "", none, none, scopes::all,
            "What the picture shows:\n"
            "flat: the plane from above\n"
            "horizon: the plane in perspective, with the scale at its bottom row\n"
            "slice: a cut through noise in space\n"
            "sphere, torus: a body\n"
            "terrain: eroded mountains from above\n"
            "landscape: eroded mountains in perspective\n"
            "ocean: a sea in perspective.\n"
            "The last three have channels R, G, B, height, slope.x, slope.y, lit.R, lit.G, lit.B, and ridge "
            "and "
            "erosion or, for the ocean, jacobian and foam",
            by_name(view_name, put_view), names_of(named_views)),
        row("tileable", Type::flag, "", none, none, scopes::tiles, "Make the picture tile without seams",
            in_part(&Request::view, &View::tileable)),
        row("depth", Type::number, "kernel radii", {-1e6, 1e6}, {-10, 10}, scopes::slices,
            "Depth of the slice", in_part(&Request::view, &View::depth)),
        row("solid", Type::flag, "", none, none, scopes::bodies, "Cut the body from solid noise",
            in_part(&Request::view, &View::solid)),
        row("yaw", Type::angle, "degrees", {-36000, 36000}, {-180, 180}, scopes::orbits,
            "Camera angle around the body, the landscape or the vertical; the waves of a sea come from 180",
            in_orbit(&Orbit::yaw)),
        row("pitch", Type::angle, "degrees", {-90, 90}, {-90, 90}, scopes::orbits,
            "Camera angle above the equator, the ground or the sea", in_orbit(&Orbit::pitch)),
        row("zoom", Type::number, "", {0.1, 100}, {0.1, 10}, scopes::orbits,
            "Zoom factor; 1 shows the whole body", in_orbit(&Orbit::zoom)),
        row("focal_length", Type::number, "millimetres", {3.6, 360}, {10, 100}, scopes::places,
            "Focal length of the camera, whose sensor's longer side has 36 mm: shorter is wider",
            in_orbit(&Orbit::focal_length)),
        row("filter", Type::flag, "", none, none, scopes::patterns,
            "Antialias with a Gaussian filter whose standard deviation is half a pixel. In the plane, this "
            "adds a channel `removed`: the share of the variance that the filter removes",
            in_request(&Request::filter)),
    };
}

std::vector<Parameter> light_rows() {
    return {
        row("light_azimuth", Type::angle, "degrees", {-36000, 36000}, {-180, 180}, scopes::lit,
            "Direction that the light comes from: 0 is right, 90 below", in_request(&Request::light_azimuth)),
        row("light_elevation", Type::angle, "degrees", {0, 90}, {0, 90}, scopes::lit,
            "Angle of the light above the surface", in_request(&Request::light_elevation)),
        row("environment", Type::choice, "", none, none, scopes::material,
            "Surroundings that light a material, besides the lamp: a room with a window, an overcast sky, or "
            "nothing",
            by_index(
                [](auto& r) -> auto& { return r.environment; }, environments),
            {environments.begin(), environments.end()}),
    };
}

std::vector<Parameter> terrain_rows() {
    return {row("extent", Type::number, "", {0, 1e9}, {0, 10000}, scopes::terrain,
                "Width of the picture, in the unit of the heights, usually metres; 0 gives heights in kernel "
                "radii",
                in_request(&Request::extent)),
            row("cover", Type::choice, "", none, none, scopes::terrain,
                "Cover of the ground: grass, scree and snow; grass alone; sand below layered cliffs; or clay",
                by_index(
                    [](auto& r) -> auto& { return r.cover; }, covers),
                {covers.begin(), covers.end()}),
            row("water_level", Type::number, "", {-hill_reach, hill_reach}, {-hill_reach, 1}, scopes::terrain,
                "Water level of lakes, in kernel radii; the lowest level is below all ground",
                in_request(&Request::water_level))};
}

// Sea::loop_seconds is 0 or a power of 2 from 8.
constexpr std::array<std::string_view, 11> loops{"never", "8",   "16",   "32",   "64",  "128",
                                                 "256",   "512", "1024", "2048", "4096"};

Place seconds_of_loop() {
    return by_name(
        [](const Request& request) {
            const auto seconds = static_cast<unsigned>(request.sea.loop_seconds);
            return loops[seconds == 0 ? 0 : static_cast<std::size_t>(std::countr_zero(seconds) - 2)];
        },
        [](Request& request, const std::string& name) {
            const auto index = std::ranges::find(loops, name) - loops.begin();
            request.sea.loop_seconds = index == 0 ? 0 : 4 << index;
        });
}

std::vector<Parameter> sea_rows() {
    return {row("loop_seconds", Type::choice, "seconds", none, none, scopes::sea,
                "Time after which the sea repeats exactly, for films: several periods of the swell. "
                "Wave periods become integer fractions of the loop, and groups of waves stand still",
                seconds_of_loop(), {loops.begin(), loops.end()}),
            row("seconds", Type::number, "seconds", {-1e9, 1e9}, {0, 600}, scopes::sea, "Time",
                in_part(&Request::sea, &Sea::seconds)),
            row("altitude", Type::number, "metres", {1, 1000}, {1, 200}, scopes::sea,
                "Height of the camera above the sea; it stays above most waves", in_orbit(&Orbit::altitude))};
}

// A member of a struct of a drop-in. Numbers and angles use only the first of the three defaults.
struct StructRow {
    std::string_view name;
    Type type;
    std::string_view unit;
    Range range;
    Range slider;
    std::array<double, 3> by_default;
    std::string_view help;
};

constexpr StructRow of_structs[]{
#include "render/request/struct_rows.inc"
};

Place in_look(const StructRow& made) {
    const auto get = [&made](const Request& request) {
        const auto found = request.look.find(made.name);
        const auto& value = found == request.look.end() ? made.by_default : found->second;
        return made.type == Type::colour ? Value(value) : Value(value[0]);
    };
    const auto put = [&made](Request& request, const Value& value) {
        const auto* colour = std::get_if<std::array<double, 3>>(&value);
        const auto numbers = colour ? *colour : std::array{std::get<double>(value), 0.0, 0.0};
        if (numbers == made.by_default)
            request.look.erase(made.name);
        else
            request.look[made.name] = numbers;
    };
    return {get, put};
}

Parameter struct_row(const StructRow& made) {
    const std::size_t dot = made.name.find('.');
    const std::string_view of = made.name.substr(0, dot);
    const Scope one_material{fmt::format("--material {}", of),
                             [of](const Request& r) { return is<Kind::material>(r) && r.material == of; }};
    const auto [group, scope] = dot == of.npos   ? std::pair(Group::erosion, Scope(scopes::terrain))
                                : of == "sea"    ? std::pair(Group::sea, Scope(scopes::sea))
                                : of == "boards" ? std::pair(Group::boards, Scope(scopes::laid))
                                : of == "coat"   ? std::pair(Group::coat, Scope(scopes::coated))
                                : of == "finish" ? std::pair(Group::finish, Scope(scopes::finished))
                                                 : std::pair(Group::material, one_material);
    Parameter p = row(group == Group::sea ? made.name.substr(dot + 1) : made.name, made.type, made.unit,
                      made.range, made.slider, scope, made.help, in_look(made));
    p.group = group;
    p.of_struct = true;
    return p;
}

std::vector<Parameter> make_table() {
    std::vector<Parameter> table;
    const auto add = [&](Group group, std::vector<Parameter> rows) {
        for (Parameter& each : rows) {
            each.group = group;
            table.push_back(std::move(each));
        }
    };
    add(Group::picture, picture_rows());
    add(Group::noise, noise_rows());
    add(Group::noise, fractal_rows());
    add(Group::view, view_rows());
    add(Group::light, light_rows());
    add(Group::terrain, terrain_rows());
    std::ranges::transform(of_structs, std::back_inserter(table), struct_row);
    add(Group::sea, sea_rows());
    return table;
}

// ---- Conflicts ----

// Tells whether the request stores a value other than the default.
bool is_changed(const Request& request, const Parameter& p) {
    const std::optional<Value> value = p.place.get(request);
    return value && value != (decides(p) ? p.place.get(Request()) : default_of(p, request));
}

// Tells whether the request stores a value of the noise that has no effect in it. The values of materials and
// terrain may wait in a request for later.
bool is_stray(const Request& request, const Parameter& p) {
    if (p.scope.holds(request) || !is_changed(request, p))
        return false;
    return p.scope.holds(plain(request)) || p.scope.holds(Request());
}

struct Exclusion {
    std::string_view parameter;
    std::string_view other;
    bool (*conflicts)(const Request&); // whether they conflict in a request
    std::string_view because;
};

const std::array exclusions{
    Exclusion{"view", "material",
              [](const Request& r) {
                  return r.material != no_material && (!is_pattern(r.kind) || is_seen<Projection::slice>(r));
              },
              "only planes and bodies have materials"},
    Exclusion{
        "view", "fractal",
        [](const Request& r) { return r.fractal.shape != 0 && (!is_pattern(r.kind) || r.view.in_space()); },
        "only planes have fractal noise"},
    Exclusion{"material", "fractal",
              [](const Request& r) { return r.material != no_material && r.fractal.shape != 0; },
              "each replaces the noise"},
    Exclusion{"lobes", "recipe",
              [](const Request& r) {
                  return !r.recipe.is_lattice() &&
                         std::ranges::any_of(r.lobes, [](const Lobe& lobe) { return lobe.stretch != 1; });
              },
              "stretched kernels require a lattice recipe"},
    Exclusion{"filter", "recipe", [](const Request& r) { return r.filter && !can_filter(r); },
              "in the plane, the filter requires the lattice recipe"},
};

// ---- Colour ----

bool are_of_colour(const std::vector<Lobe>& lobes, const noise::Colour& colour) {
    return colour.weights.size() == lobes.size() &&
           std::ranges::all_of(lobes, [](const Lobe& l) { return l.is_one_wave() && l.power > 0; });
}

// Tells whether the request has anything that cannot be coloured.
bool is_colourless(const Request& request) {
    return request.quadrature || request.gradient || request.phasor || !request.paint.empty() ||
           request.kind != Kind::noise;
}

// ---- Values ----

std::string accepted_number(Type type, const Range& range, std::string_view unit) {
    std::string text =
        fmt::format("{} from {:.10g} to {:.10g}", type == Type::integer ? "a whole number" : "a number",
                    range.low, range.high);
    if (!unit.empty())
        text += fmt::format(" ({}{})", unit, type == Type::angle ? ", or radians as in 0.7854rad" : "");
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
            hexadecimal ? std::from_chars(at, at + 2, byte, 16) : system::from_chars(at, end, part);
        if (error != std::errc() || (hexadecimal && stop != at + 2))
            return {};
        if (hexadecimal)
            part = linear(byte);
        at = stop;
    }
    return at == end ? std::optional(colour) : std::nullopt;
}

bool has_range(Type type) {
    return type == Type::integer || type == Type::number || type == Type::angle;
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
                                               accepted_number(p.type, p.range, p.unit)));
    if (std::ranges::none_of(lobes, [](const Lobe& lobe) { return lobe.power > 0; }))
        throw RequestError("every lobe has power 0: at least one must have more");
}

void check_value(const Parameter& p, const Value& value) {
    const auto refused = [&] { refuse(to_text(value), accepted(p)); };
    if (has_range(p.type)) {
        const double number = std::get<double>(value);
        if (!within(number, p.range) || (p.type == Type::integer && number != std::floor(number)))
            refused();
    } else if (p.type == Type::colour) {
        for (const double part : std::get<std::array<double, 3>>(value))
            if (!within(part, p.range))
                refused();
    } else if (p.type == Type::choice) {
        const std::string& name = std::get<std::string>(value);
        if (std::ranges::find(p.choices, name) == p.choices.end())
            throw RequestError(fmt::format("'{}': {}", name, expected(name, p.choices)));
    } else if (p.type == Type::lobes) {
        check_lobes(std::get<std::vector<Lobe>>(value));
    }
}

// Returns the beginning of a message about a parameter.
std::string prefix(const Parameter& p, std::string (*called)(const Parameter&) = json_name) {
    return fmt::format("{}{} ", called(p), p.type == Type::lobes ? ":" : "");
}

} // namespace

std::span<const Parameter> parameters() {
    static const std::vector<Parameter> table = make_table();
    return table;
}

std::string json_name(const Parameter& parameter) {
    return std::string(parameter.name);
}

std::string option_name(const Parameter& parameter) {
    std::string name = fmt::format("--{}", parameter.name);
    std::ranges::replace(name, '_', '-');
    return name;
}

std::span<const LobeParameter> lobe_parameters() {
    return of_lobe;
}

const Parameter& parameter(std::string_view name) {
    const auto found = std::ranges::find(parameters(), name, &Parameter::name);
    if (found != parameters().end())
        return *found;
    const std::string_view material = name.substr(0, name.find('.') + 1); // with its dot; empty without one
    std::vector<std::string_view> names, of_material;
    for (const Parameter& p : parameters()) {
        names.push_back(p.name);
        if (!material.empty() && p.name.starts_with(material))
            of_material.push_back(p.name);
    }
    throw RequestError(fmt::format("unknown parameter '{}': {}", name,
                                   of_material.empty()
                                       ? did_you_mean(name, names) + "`gabor render --help` lists the options"
                                       : expected(name, of_material)));
}

std::string accepted(const Parameter& p) {
    switch (p.type) {
    case Type::flag:
        return "true or false";
    case Type::choice:
        return fmt::format("{}", fmt::join(p.choices, ", "));
    case Type::text:
        return "a name";
    case Type::colour:
        return "#rrggbb, or linear red, green and blue from 0 to 1, as in 0.5,0.3,0.1";
    case Type::lobes:
        return "a list like [{\"frequency\": 4, \"orientation\": 45, \"power\": 1}]";
    default:
        return accepted_number(p.type, p.range, p.unit);
    }
}

Value read(const Parameter& p, std::string_view text) {
    Value value;
    if (has_range(p.type)) {
        std::string_view digits = text;
        bool in_radians = false;
        if (p.type == Type::angle) {
            in_radians = digits.ends_with("rad");
            for (const std::string_view unit : {"rad", "deg", "\u00b0"})
                if (digits.ends_with(unit)) {
                    digits.remove_suffix(unit.size());
                    break;
                }
        }
        double number = 0;
        std::int64_t whole = 0;
        const char* end = digits.data() + digits.size();
        const auto [stop, error] = p.type == Type::integer ? std::from_chars(digits.data(), end, whole)
                                                           : system::from_chars(digits.data(), end, number);
        if (error != std::errc() || stop != end)
            refuse(text, accepted(p));
        if (p.type == Type::integer)
            number = static_cast<double>(whole);
        value = in_radians ? noise::degrees(number) : number;
    } else if (p.type == Type::flag) {
        if (text != "true" && text != "false")
            refuse(text, accepted(p));
        value = text == "true";
    } else if (p.type == Type::lobes) {
        value = lobes_from_json(text);
    } else if (p.type == Type::colour) {
        const auto colour = read_colour(text);
        if (!colour)
            refuse(text, accepted(p));
        value = *colour;
    } else if (p.type == Type::choice) {
        value = std::string(in_any_case(text, p.choices));
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

void set(Request& request, const Values& values, std::string (*called)(const Parameter&)) {
    for (const int rank : {0, 1, 2})
        for (const auto& named : values) { // clang's lambdas cannot capture structured bindings
            const Parameter& p = *named.first;
            const bool of_material =
                p.name == "boards" || p.name == "coat" || p.name == "finish"; // which comes before these
            if (rank != (of_material ? 1 : decides(p) ? 0 : 2))
                continue;
            with_prefix(prefix(p, called), [&] { check_value(p, named.second); });
            if (!p.get(request)) {
                const std::string other = other_than(p.scope, request);
                throw RequestError(fmt::format("{} needs {}{}{}", called(p),
                                               needed(p.scope, called == option_name),
                                               other.empty() ? "" : ", not ", other));
            }
            p.place.put(request, named.second);
        }
}

void set(Request& request, std::string_view name, const Value& value) {
    set(request, Values{{&parameter(name), value}});
}

std::optional<Value> default_of(const Parameter& parameter, const Request& request) {
    Request fresh;
    fresh.kind = request.kind;
    fresh.material = request.material;
    fresh.fractal.shape = request.fractal.shape;
    fresh.view = {.projection = request.view.projection, .orbit = default_orbit(request.kind)};
    fresh.lobes.resize(request.lobes.size());
    return parameter.place.get(fresh);
}

bool decides(const Parameter& p) {
    return p.type == Type::lobes || p.name == "view" || p.name == "material" || p.name == "fractal" ||
           p.name == "boards" || p.name == "coat" || p.name == "finish";
}

bool is_set(const Request& request, std::string_view name) {
    const Parameter& p = parameter(name);
    return p.scope.holds(request) && is_changed(request, p);
}

void drop_conflicting(Request& request, std::string_view name) {
    const Parameter& kept = parameter(name);
    if (is_stray(request, kept)) {
        request.kind = Kind::noise;
        request.material = no_material;
        request.fractal.shape = 0;
        request.view = {};
        if (is_stray(request, kept))
            request.lobes.resize(1);
    }
    const auto reset = [&](const Parameter& p) { p.place.put(request, *p.place.get(Request())); };
    for (const Parameter& p : parameters())
        if (is_stray(request, p))
            reset(p);
    for (const Exclusion& exclusion : exclusions)
        if (exclusion.conflicts(request) && (name == exclusion.parameter || name == exclusion.other))
            reset(parameter(name == exclusion.parameter ? exclusion.other : exclusion.parameter));
    if (request.colour && (is_colourless(request) || !are_of_colour(request.lobes, *request.colour)))
        request.colour.reset();
}

std::vector<float> struct_values(const Request& request) {
    const Group group = is<Kind::terrain>(request) ? Group::erosion
                        : is<Kind::sea>(request)   ? Group::sea
                                                   : Group::material;
    std::vector<float> values;
    for (const Parameter& p : parameters()) {
        if (!p.of_struct)
            continue;
        const bool always = group == Group::material &&
                            (p.group == Group::boards || p.group == Group::coat || p.group == Group::finish);
        const std::optional<Value> value = always             ? p.place.get(request)
                                           : p.group == group ? p.get(request)
                                                              : std::nullopt;
        if (!value)
            continue;
        if (const auto* colour = std::get_if<std::array<double, 3>>(&*value)) {
            values.resize((values.size() + 3) / 4 * 4); // std430 aligns vec3 to four floats
            for (const double part : *colour)
                values.push_back(static_cast<float>(part));
        } else {
            const double number = std::get<double>(*value);
            values.push_back(p.type == Type::integer ? std::bit_cast<float>(static_cast<std::int32_t>(number))
                             : p.type == Type::angle ? static_cast<float>(noise::radians(number))
                                                     : static_cast<float>(number));
        }
    }
    return values;
}

void check(const Request& request) {
    for (const Parameter& p : parameters())
        if (const std::optional<Value> value = p.get(request))
            with_prefix(prefix(p), [&] { check_value(p, *value); });
    for (const Exclusion& exclusion : exclusions)
        if (exclusion.conflicts(request)) {
            const auto described = [&](std::string_view name) {
                return name == "view" ? fmt::format("view {}", view_name(request)) : std::string(name);
            };
            throw RequestError(fmt::format("{} conflicts with {}: {}", described(exclusion.parameter),
                                           described(exclusion.other), exclusion.because));
        }
    for (const Parameter& p : parameters())
        if (is_stray(request, p))
            throw RequestError(fmt::format("{} conflicts with {}: it needs {}", p.name,
                                           other_than(p.scope, request), needed(p.scope, false)));
    if (request.colour && !are_of_colour(request.lobes, *request.colour))
        throw RequestError("colour requires weights for each lobe, and lobes with power but no spread: use "
                           "the lobes that came with the colour");
    if (request.colour && is_colourless(request))
        throw RequestError("colours conflict with paint, materials, gradient and phasor");
    const auto require_sides = [&](std::string_view what, std::string_view described) {
        const double least = std::ceil(least_tile(request) * request.scale - 1e-9);
        if (std::min(request.width, request.height) < least)
            throw RequestError(fmt::format(
                "a {} of {} x {} pixels at scale {} is too small: each side must be at least {}, {} pixels",
                what, request.width, request.height, request.scale, described, least));
    };
    if (request.view.tileable && is<Kind::terrain>(request))
        require_sides("terrain tile", "four kernel radii");
    else if (request.view.tileable && is<Kind::fractal>(request))
        require_sides("tileable picture", "8/3 kernel radii");
    else if (request.view.tileable && is<Kind::noise>(request))
        require_sides("tileable picture",
                      request.lobes.size() > 1 ? "two kernel radii of its widest lobe" : "two kernel radii");
}

} // namespace gabor::render
