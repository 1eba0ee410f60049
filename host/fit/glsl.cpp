#include "fit/glsl.hpp"

#include "error.hpp"
#include "noise/glsl_literal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>

namespace gabor::fit {

namespace {

using noise::Colour;
using noise::literal;

// GLSL keywords and built-in functions that a file name might match.
constexpr std::array<std::string_view, 34> reserved{
    "abs",    "all",     "any",      "asin",       "atan", "ceil",      "clamp",  "common",  "cos",
    "cross",  "degrees", "distance", "dot",        "exp",  "filter",    "fixed",  "flat",    "floor",
    "fract",  "length",  "log",      "main",       "mix",  "normalize", "patch",  "refract", "round",
    "sample", "sampler", "smooth",   "smoothstep", "step", "texture",   "varying"};

template <typename Of>
std::string vector(Of of) {
    return literal(std::array{of(std::size_t{0}), of(std::size_t{1}), of(std::size_t{2})});
}

// Splits the variance of a component with this polynomial by degree: if the polynomial is the sum of a_n
// He_n, degree n contributes n! a_n^2, for n from 1 to 5.
std::array<double, 6> degree_shares(const std::array<double, 6>& c) {
    return {0,
            std::pow(c[1] + 3 * c[3] + 15 * c[5], 2),
            2 * std::pow(c[2] + 6 * c[4], 2),
            6 * std::pow(c[3] + 10 * c[5], 2),
            24 * c[4] * c[4],
            120 * c[5] * c[5]};
}

// The GLSL call that adds a lobe.
std::string lobe_call(const std::string& name, std::size_t index, const Wave& wave,
                      const std::array<Colour::Weight, 3>& weights, bool complex) {
    const Eigen::Vector2d cycles = wave.frequency.cwiseProduct(wave.radius);
    const auto of = [&](double Colour::Weight::*part) {
        return vector([&](std::size_t c) { return weights[c].*part; });
    };
    const std::array kernel{wave.radius.x(), wave.radius.y(), cycles.x(), cycles.y()};
    return fmt::format("{}_lobe(z, removed, p, d, filtered, {}, {}, {}{});", name, index, literal(kernel),
                       of(&Colour::Weight::noise), complex ? ", " + of(&Colour::Weight::quadrature) : "");
}

bool has_quadrature(const Colour& colour) {
    return std::ranges::any_of(colour.weights, [](const auto& weights) {
        return std::ranges::any_of(weights, [](const Colour::Weight& w) { return w.quadrature != 0; });
    });
}

} // namespace

std::string function_name(const std::filesystem::path& file) {
    std::string name = file.stem().string();
    const auto letter = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
    if (file.extension() != ".glsl" || !std::ranges::all_of(name, letter) || name.empty() ||
        std::isalpha(static_cast<unsigned char>(name[0])) == 0 || name.ends_with('_') ||
        name.find("__") != std::string::npos || name.starts_with("gl_") ||
        std::ranges::find(reserved, name) != reserved.end())
        throw RequestError(
            fmt::format("--glsl '{}': expected NAME.glsl, where NAME is valid for a GLSL function: letters, "
                        "digits and _, not a reserved word",
                        file.string()));
    return name;
}

std::string colour_function(const std::string& name, const Colour& colour) {
    const auto coefficient = [&](std::size_t n) {
        return vector([&](std::size_t c) { return colour.histogram[c][n]; });
    };
    const auto column = [&](std::size_t c) {
        return vector([&](std::size_t i) { return colour.mixing[i][c]; });
    };
    return fmt::format(
        R"(vec3 {name}_colour(vec3 z, vec3 v) {{ // maps normal components to the histogram; v: the variance that a filter removed
    z = clamp(z, -4.0, 4.0);
    vec3 s = z * z, c = {c0} + {c2} * (s + v) + {c4} * (s * (s + 6.0 * v) + 3.0 * v * v)
           + z * ({c1} + {c3} * (s + 3.0 * v) + {c5} * (s * (s + 10.0 * v) + 15.0 * v * v));
    return {mean} + c.x * {x} + c.y * {y} + c.z * {z};
}}
)",
        fmt::arg("name", name), fmt::arg("c0", coefficient(0)), fmt::arg("c1", coefficient(1)),
        fmt::arg("c2", coefficient(2)), fmt::arg("c3", coefficient(3)), fmt::arg("c4", coefficient(4)),
        fmt::arg("c5", coefficient(5)), fmt::arg("mean", literal(colour.mean)), fmt::arg("x", column(0)),
        fmt::arg("y", column(1)), fmt::arg("z", column(2)));
}

std::string glsl_of(const std::string& name, const std::filesystem::path& image, const Exemplar& exemplar,
                    const FittedNoise& fitted) {
    const Colour& colour = fitted.colour;
    const bool complex = has_quadrature(colour);
    std::string comment = image.filename().string();
    std::ranges::replace_if(
        comment, [](unsigned char c) { return c < ' ' || c == 0x7f || c == '\\'; }, '_');
    std::string lobes;
    const std::size_t in_line = fitted.waves.size() > 8 ? 2 : 1;
    for (std::size_t i = 0; i < fitted.waves.size(); ++i)
        lobes += (i % in_line == 0 ? "\n    " : " ") +
                 lobe_call(name, i, fitted.waves[i], colour.weights[i], complex);

    // A filter leaves (1 - removed)^n of the variance of degree n.
    std::array<double, 3> variances{};
    for (std::size_t c = 0; c < 3; ++c)
        for (const auto& row : colour.mixing)
            variances[c] += row[c] * row[c];
    const double variance = variances[0] + variances[1] + variances[2];
    const auto share = [&](std::size_t n) {
        return vector(
            [&](std::size_t c) { return variances[c] / variance * degree_shares(colour.histogram[c])[n]; });
    };
    return fmt::format(
        R"(// {name}.glsl: Gabor noise after {image}, by gabor fit. Paste it after gabor_noise.glsl and, to filter it, gabor_filter.glsl.
//     vec3 {name}(vec2 p): colour at p, in pixels of the photograph, {width} x {height}. Costs about {count} times gabor_noise.
//     vec4 {name}_filtered(vec2 p, vec2 dx, vec2 dy): its mean over a screen pixel, dx = dFdx(p), dy = dFdy(p); w: removed variance.
#ifndef GABOR_NOISE_GLSL
#error Include gabor_noise.glsl before {name}.glsl
#elif !defined(GABOR_TEXTURE_{name}_GLSL)
#define GABOR_TEXTURE_{name}_GLSL 1
const uint {name}_seed = 0u; // another seed gives another piece of the same texture
#ifdef GABOR_FILTER_GLSL
GaborField {name}_field(GaborPlace place, vec2 dx, vec2 dy, vec2 wave, bool filtered, uint seed) {{
    GaborField field;
    if (filtered) field = gabor_field_filtered(place, dx, dy, wave, seed);
    else field = gabor_field(place, wave, seed);
    return field;
}}
#else
GaborField {name}_field(GaborPlace place, vec2 dx, vec2 dy, vec2 wave, bool filtered, uint seed) {{
    return gabor_field(place, wave, seed);
}}
#endif
// Adds lobe i. k: its radii along x and y in pixels and its waves per radius; {weights}.
void {name}_lobe(inout vec3 z, inout vec3 removed, vec2 p, vec4 d, bool filtered, int i, vec4 k, {parameters}) {{
    uint seed = gabor_derived_seed({name}_seed, i);
    GaborField n = {name}_field(gabor_place_at(p / k.xy), d.xy / k.xy, d.zw / k.xy, k.zw, filtered, seed);
    z += {sum};
    removed += n.removed * {squares};
}}
void {name}_sum(inout vec3 z, inout vec3 removed, vec2 p, vec4 d, bool filtered) {{{lobes}
}}
{colour}vec3 {name}(vec2 p) {{
    vec3 z = vec3(0.0), removed = z;
    {name}_sum(z, removed, p, vec4(0.0), false);
    return {name}_colour(z, removed);
}}
#ifdef GABOR_FILTER_GLSL
vec4 {name}_filtered(vec2 p, vec2 dx, vec2 dy) {{
    vec3 z = vec3(0.0), removed = z;
    {name}_sum(z, removed, p, vec4(dx, dy), true);
    vec3 k = 1.0 - min(removed, vec3(1.0)), left = k * ({s1} + k * ({s2} + k * ({s3} + k * ({s4} + k * {s5}))));
    return vec4({name}_colour(z, removed), 1.0 - min(dot(left, vec3(1.0)), 1.0));
}}
#endif
#endif
)",
        fmt::arg("name", name), fmt::arg("image", comment), fmt::arg("width", exemplar.width),
        fmt::arg("height", exemplar.height), fmt::arg("count", fitted.waves.size()),
        fmt::arg("weights",
                 complex ? "a, b: weights of its noise and quadrature" : "a: weights of its noise"),
        fmt::arg("parameters", complex ? "vec3 a, vec3 b" : "vec3 a"),
        fmt::arg("squares", complex ? "(a * a + b * b)" : "a * a"),
        fmt::arg("sum", complex ? "n.noise * a + n.quadrature * b" : "n.noise * a"), fmt::arg("lobes", lobes),
        fmt::arg("colour", colour_function(name, colour)), fmt::arg("s1", share(1)), fmt::arg("s2", share(2)),
        fmt::arg("s3", share(3)), fmt::arg("s4", share(4)), fmt::arg("s5", share(5)));
}

} // namespace gabor::fit
