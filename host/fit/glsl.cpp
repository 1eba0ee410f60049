#include "fit/glsl.hpp"

#include "error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>

namespace gabor::fit {

namespace {

using noise::Colour;

// Keywords and built-in functions of GLSL that a file may be named after.
constexpr std::array<std::string_view, 34> reserved{
    "abs",    "all",     "any",      "asin",       "atan", "ceil",      "clamp",  "common",  "cos",
    "cross",  "degrees", "distance", "dot",        "exp",  "filter",    "fixed",  "flat",    "floor",
    "fract",  "length",  "log",      "main",       "mix",  "normalize", "patch",  "refract", "round",
    "sample", "sampler", "smooth",   "smoothstep", "step", "texture",   "varying"};

std::string number(double value) {
    std::string text = fmt::format("{:.8g}", static_cast<double>(static_cast<float>(value)));
    if (text.find_first_of(".e") == std::string::npos)
        text += ".0";
    return text;
}

std::string vector(double x, double y, double z) {
    return fmt::format("vec3({}, {}, {})", number(x), number(y), number(z));
}

template <typename Of>
std::string vector(Of of) {
    return vector(of(std::size_t{0}), of(std::size_t{1}), of(std::size_t{2}));
}

// Shares of the variance that components' polynomials have in their parts of degree 1 to 5: n! a_n^2 for a
// sum a_n He_n.
std::array<double, 6> degree_shares(const std::array<double, 6>& c) {
    return {0,
            std::pow(c[1] + 3 * c[3] + 15 * c[5], 2),
            2 * std::pow(c[2] + 6 * c[4], 2),
            6 * std::pow(c[3] + 10 * c[5], 2),
            24 * c[4] * c[4],
            120 * c[5] * c[5]};
}

// A lobe's wave, its radius and its weights, as its line needs them.
struct Line {
    std::string radius;
    std::string frequency; ///< cycles per radius
    std::string orientation;
    std::string noise; ///< weights of the noise
    std::string quadrature;
    std::string squares;
};

Line line_of(const Wave& wave, const std::array<Colour::Weight, 3>& weights) {
    const auto of = [&](auto value) { return vector([&](std::size_t c) { return value(weights[c]); }); };
    return {number(wave.radius.x()),
            number(wave.frequency.norm() * wave.radius.x()),
            number(std::atan2(wave.frequency.y(), wave.frequency.x())),
            of([](const Colour::Weight& w) { return w.noise; }),
            of([](const Colour::Weight& w) { return w.quadrature; }),
            of([](const Colour::Weight& w) { return w.noise * w.noise + w.quadrature * w.quadrature; })};
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
            fmt::format("--glsl '{}': it takes NAME.glsl with the name of a function, of letters, digits "
                        "and _, and no word of GLSL",
                        file.string()));
    return name;
}

std::string colour_function(const std::string& name, const Colour& colour) {
    const auto coefficient = [&](std::size_t n) {
        return vector([&](std::size_t c) { return colour.histogram[c][n]; });
    };
    const auto row = [&](std::size_t i) {
        return vector([&](std::size_t c) { return colour.mixing[i][c]; });
    };
    return fmt::format(R"(
// The colour of three independent normal components, each taken to its own law by a polynomial. Where a filter has
// removed a share of their variance, that of the polynomial of what it left and of any normal rest.
vec3 {name}_colour(vec3 z, vec3 removed)
{{
    z = clamp(z, -4.0, 4.0);
    vec3 s = z * z;
    vec3 v = removed;
    vec3 even = {c0}
              + {c2} * (s + v)
              + {c4} * (s * (s + 6.0 * v) + 3.0 * v * v);
    vec3 odd = {c1}
             + {c3} * (s + 3.0 * v)
             + {c5} * (s * (s + 10.0 * v) + 15.0 * v * v);
    vec3 component = even + z * odd;
    return {mean}
         + vec3(dot({r}, component),
                dot({g}, component),
                dot({b}, component));
}}
)",
                       fmt::arg("name", name), fmt::arg("c0", coefficient(0)), fmt::arg("c1", coefficient(1)),
                       fmt::arg("c2", coefficient(2)), fmt::arg("c3", coefficient(3)),
                       fmt::arg("c4", coefficient(4)), fmt::arg("c5", coefficient(5)),
                       fmt::arg("mean", vector(colour.mean[0], colour.mean[1], colour.mean[2])),
                       fmt::arg("r", row(0)), fmt::arg("g", row(1)), fmt::arg("b", row(2)));
}

std::string glsl_of(const std::string& name, const std::filesystem::path& image, const Exemplar& exemplar,
                    const FittedNoise& fitted) {
    const Colour& colour = fitted.colour;
    const bool complex = has_quadrature(colour);
    std::string comment = image.filename().string();
    std::ranges::replace_if(
        comment, [](unsigned char c) { return c < ' ' || c == 0x7f || c == '\\'; }, '_');
    std::string text =
        fmt::format(R"(// {name}.glsl: Gabor noise after {image}, {width} x {height} pixels, by gabor fit.
//
// Put it after gabor_lattice.glsl and gabor_spectrum.glsl.
//
//     vec3 {name}(vec2 p)                             its colour at p, in pixels of that picture
//     vec4 {name}_filtered(vec2 p, vec2 dx, vec2 dy)  as a pixel sees it that reaches dx and dy further to its neighbours,
//                                                     dFdx(p) and dFdy(p), and the share of the variance that this removed
//
// The first costs about as much as {count} gabor_noise.

#ifndef GABOR_SPECTRUM_GLSL
#error Include gabor_lattice.glsl and gabor_spectrum.glsl before {name}.glsl
#endif
#ifndef GABOR_TEXTURE_{name}_GLSL
#define GABOR_TEXTURE_{name}_GLSL

const uint {name}_seed = 0u; // which instance of the noise
)",
                    fmt::arg("name", name), fmt::arg("image", comment), fmt::arg("width", exemplar.width),
                    fmt::arg("height", exemplar.height), fmt::arg("count", fitted.waves.size()));
    text += colour_function(name, colour);

    std::string plain;
    std::string filtered;
    for (std::size_t i = 0; i < fitted.waves.size(); ++i) {
        const Line line = line_of(fitted.waves[i], colour.weights[i]);
        const std::string seed = fmt::format("gabor_lobe_seed({}_seed, {})", name, i);
        const std::string arguments =
            fmt::format("p / {}, {}, {}, {}", line.radius, line.frequency, line.orientation, seed);
        if (complex)
            plain += fmt::format("    n = gabor_noise_complex({});\n    z += n.x * {} + n.y * {};\n",
                                 arguments, line.quadrature, line.noise);
        else
            plain += fmt::format("    z += gabor_noise({}) * {};\n", arguments, line.noise);
        filtered += fmt::format(
            "    n = gabor_field_filtered(gabor_place(ivec2(0), p * (GABOR_RADIUS / {0})), "
            "gabor_kernel({1}, {2}),\n"
            "                             gabor_footprint(dx / {0}, dy / {0}), {3}, share).value;\n",
            line.radius, line.frequency, line.orientation, seed);
        filtered += complex ? fmt::format("    z += n.x * {} + n.y * {};\n", line.quadrature, line.noise)
                            : fmt::format("    z += n.y * {};\n", line.noise);
        filtered += fmt::format("    removed += share * {};\n", line.squares);
    }
    text += fmt::format(R"(
vec3 {name}(vec2 p)
{{
    vec3 z = vec3(0.0);
{declaration}{plain}    return {name}_colour(z, vec3(0.0));
}}
)",
                        fmt::arg("name", name), fmt::arg("declaration", complex ? "    vec2 n;\n" : ""),
                        fmt::arg("plain", plain));

    // What is left of the variance, from the polynomials' parts: those of degree n keep (1 - removed)^n.
    double variance = 0;
    std::array<double, 3> variances{};
    for (std::size_t c = 0; c < 3; ++c)
        for (const auto& row : colour.mixing)
            variances[c] += row[c] * row[c];
    for (const double v : variances)
        variance += v;
    const auto share = [&](std::size_t n) {
        return vector(
            [&](std::size_t c) { return variances[c] / variance * degree_shares(colour.histogram[c])[n]; });
    };
    text += fmt::format(R"(
#if GABOR_TAPS == 3 // as the filter of gabor_spectrum.glsl
vec4 {name}_filtered(vec2 p, vec2 dx, vec2 dy)
{{
    vec3 z = vec3(0.0);
    vec3 removed = vec3(0.0);
    vec2 n;
    float share;
{filtered}    vec3 kept = 1.0 - min(removed, vec3(1.0));
    vec3 left = kept * ({s1} + kept * ({s2} + kept * ({s3}
              + kept * ({s4} + kept * {s5}))));
    return vec4({name}_colour(z, removed), 1.0 - min(dot(left, vec3(1.0)), 1.0));
}}
#endif

#endif // GABOR_TEXTURE_{name}_GLSL
)",
                        fmt::arg("name", name), fmt::arg("filtered", filtered), fmt::arg("s1", share(1)),
                        fmt::arg("s2", share(2)), fmt::arg("s3", share(3)), fmt::arg("s4", share(4)),
                        fmt::arg("s5", share(5)));
    return text;
}

} // namespace gabor::fit
