"""Checks that Unity's graphs refer only to existing objects, and that hand-written ports to other languages give the same
noise as the GLSL. This test runs the ports on the CPU; tools/test-engines runs them in renderers and browsers."""

import functools
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import types
import unittest
from xml.etree import ElementTree

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "engines"))
import metal  # noqa: E402
import reference  # noqa: E402
from scene import SHADERS, in_cpp, on_vulkan, packaged  # noqa: E402

NODES = SHADERS / "nodes"


@functools.cache
def package(name):
    """Returns a temporary folder, while the program runs, with a node's package."""
    folder = tempfile.TemporaryDirectory(prefix="gabor-")
    packaged(name, folder.name)
    return folder


def materialx():
    """Returns the folder of MaterialX's library in its package."""
    return pathlib.Path(package("materialx").name) / "libraries" / "gabor"


def unity():
    """Returns the folder of Unity's package."""
    return pathlib.Path(package("unity").name)


def as_cpp(text, *pairs):
    """Returns a shader's text with float literals of C++, after replacing patterns."""
    for pattern, by in (*pairs, (r"(?<![\w.])(\d+\.\d+)(?![\df])", r"\1f")):
        text = re.sub(pattern, by, text)
    return text


OUT = (r"\bout (\w+)", r"\1&")


def unity_as_cpp(name):
    """Returns the functions of a file of Unity's package as C++."""
    return as_cpp((unity() / f"Gabor{name}.hlsl").read_text(), (r'#include "gabor_\w+.hlsl"', ""), OUT)


def guid(path):
    return re.search(r"^guid: ([0-9a-f]{32})$", (path.parent / f"{path.name}.meta").read_text(), re.MULTILINE)[1]


class UnityGraphs(unittest.TestCase):
    def setUp(self):
        self.paths = sorted(unity().glob("*.shadersubgraph"))
        self.assertEqual(len(self.paths), 17)

    def graphs(self):
        """Reads each graph in a test of its own."""
        for path in self.paths:
            with self.subTest(path.name):
                objects = [json.loads(part) for part in path.read_text().split("\n\n")]
                self.objects = {each["m_ObjectId"]: each for each in objects}
                self.assertEqual(len(self.objects), len(objects))
                yield objects[0]

    def one(self, kind):
        found = [each for each in self.objects.values() if each["m_Type"].endswith("." + kind)]
        self.assertEqual(len(found), 1)
        return found[0]

    def slots(self, node):
        return {slot["m_Id"]: slot for slot in (self.objects[each["m_Id"]] for each in node["m_Slots"])}

    def test_graphs_refer_to_existing_things(self):
        def references(value):
            if isinstance(value, dict):
                if set(value) == {"m_Id"} and value["m_Id"]:
                    yield value["m_Id"]
                for each in value.values():
                    yield from references(each)
            elif isinstance(value, list):
                for each in value:
                    yield from references(each)
        for graph in self.graphs():
            referred = {name for each in self.objects.values() for name in references(each)}
            self.assertEqual(referred | {graph["m_ObjectId"]}, set(self.objects))

    def test_edges_join_slots_of_one_kind(self):
        for graph in self.graphs():
            ends = []
            for edge in graph["m_Edges"]:
                out, into = (self.slots(self.objects[end["m_Node"]["m_Id"]])[end["m_SlotId"]]
                             for end in (edge["m_OutputSlot"], edge["m_InputSlot"]))
                self.assertEqual((out["m_SlotType"], into["m_SlotType"]), (1, 0))
                self.assertEqual(out["m_Type"], into["m_Type"])
                self.assertEqual(out["m_DisplayName"], into["m_DisplayName"])
                ends.append(into["m_ObjectId"])
            node, output = self.one("CustomFunctionNode"), self.one("SubGraphOutputNode")
            inputs = [slot["m_ObjectId"] for each in (node, output) for slot in self.slots(each).values() if not slot["m_SlotType"]]
            self.assertEqual(sorted(ends), sorted(inputs))

    def test_functions_match_their_files(self):
        files = {guid(path): path for path in unity().glob("Gabor*.hlsl")}
        self.assertEqual(len(files), 4)
        for _ in self.graphs():
            node = self.one("CustomFunctionNode")
            source = files[node["m_FunctionSource"]].read_text()
            for kind in ("float", "half"):
                arguments = re.search(rf"void {node['m_FunctionName']}_{kind}\((.*)\)", source)[1]
                slots = [(" out" * slot["m_SlotType"] + f" {kind}{re.search(r'Vector(.)MaterialSlot', slot['m_Type'])[1]}".removesuffix("1")
                          + f" {slot['m_ShaderOutputName']}").strip() for slot in self.slots(node).values()]
                self.assertEqual(arguments.split(", "), slots)


# Writes the values of functions.mjs, one for each function of gabor_noise.tsl.js, at the scene's points.
TSL = """
import { writeFileSync } from "node:fs";
import { dot, float, normalize, vec2, vec3 } from "./three_tsl.mjs";
import * as gabor from "./gabor_noise.mjs";

const points = Array.from({ length: 256 * 32 }, (_, i) => i);
const node = values => { const made = float(0); made.parts = [Float32Array.from(values)]; return made; };
const p = vec2(node(points.map(i => (i % 256 + 0.5) / 32)), node(points.map(i => (Math.floor(i / 256) + 0.5) / 32)));
const field = gabor.gabor_field(gabor.gabor_place_at(p), gabor.gabor_wave_vector(4, 0.7854), 7);
const surface = { normal: gabor.gabor_normal(field.gradient, p, 0.05), slope: field.gradient };
const metal = gabor.gabor_brushed_metal(p, 7), bare = gabor.gabor_noise_quadrature(p, -2.5, 0.6, -9);
const rest = { "complex.x": bare.x, "complex.y": bare.y, unorm: gabor.gabor_unorm(gabor.gabor_noise(p, 2.5, 0.6, gabor.gabor_derived_seed(-9, 3))),
               "colour.x": metal.colour.x, "colour.y": metal.colour.y, "colour.z": metal.colour.z, height: metal.height,
               "tilt.x": metal.slope.x, "tilt.y": metal.slope.y, roughness: metal.roughness.add(p.x.mul(0)), metalness: metal.metalness.add(p.x.mul(0)) };
const functions = { ...(await import("./functions.mjs")).functions(gabor, { dot, normalize, vec2, vec3 }, p),
                    "3d": gabor.gabor_noise_3d(vec3(p, 0.3), -4, vec3(2, 4, 6), 7), ...rest,
                    ...Object.fromEntries(["normal.x", "normal.y", "normal.z", "slope.x", "slope.y"].map(name => {
                        const [of, part] = name.split(".");
                        return [name, surface[of][part]];
                    })) };
writeFileSync(process.argv[2], Buffer.concat(Object.values(functions).map(value => Buffer.from(value.parts[0].buffer))));
console.log(JSON.stringify(Object.keys(functions)));
"""

# Writes the values of sums of octaves.
TSL_FRACTALS = """
import { writeFileSync } from "node:fs";
import { float, vec2, vec3 } from "./three_tsl.mjs";
import * as gabor from "./gabor_noise.mjs";

const points = Array.from({ length: 256 * 4 }, (_, i) => i);
const node = values => { const made = float(0); made.parts = [Float32Array.from(values)]; return made; };
const p = vec2(node(points.map(i => (i % 256 + 0.5) / 32)), node(points.map(i => (Math.floor(i / 256) + 0.5) / 32))), solid = vec3(p, 0.3);
const steps = [vec2(0.2, 0.05), vec2(0.1, -0.3)], solid_steps = [vec3(0.2, 0.05, -0.1), vec3(0.1, -0.3, 0.2)];
const place = { ...gabor.gabor_place_tiled(p, vec2(3, 4)), evolution: 0.3 };
const values = { smooth: gabor.gabor_smooth(p, 3), perlin: gabor.gabor_perlin(p, 3), perlin_3d: gabor.gabor_perlin_3d(solid, 3),
                 fbm: gabor.gabor_fbm(p, 4.5, 0.6, 3), fbm_3d: gabor.gabor_fbm_3d(solid, 4.5, 0.6, 3), billow: gabor.gabor_billow(p, 4.5, 0.6, 3),
                 ridged: gabor.gabor_ridged(p, 4.5, 0.6, 3), uniform: gabor.gabor_uniform(gabor.gabor_smooth(p, 3).mul(2)) };
const put = (name, { noise, gradient }, axes) => {
    values[name] = noise;
    for (const axis of axes) values[`${name}.${axis}`] = gradient[axis];
};
FRACTALS.forEach(([octaves, lacunarity, gain, shape, basis, seed], index) => {
    const fractal = gabor.gabor_fractal(octaves, gain, { lacunarity, shape, basis });
    put(`flat${index}`, gabor.gabor_fractal_noise(gabor.gabor_place_at(p), fractal, seed), "xy");
    put(`solid${index}`, gabor.gabor_fractal_noise_3d(gabor.gabor_place_3d_at(solid), fractal, seed), "xyz");
    put(`flat_filtered${index}`, gabor.gabor_fractal_noise_filtered(gabor.gabor_place_at(p), ...steps, fractal, seed), "xy");
    put(`solid_filtered${index}`, gabor.gabor_fractal_noise_3d_filtered(gabor.gabor_place_3d_at(solid), ...solid_steps, fractal, seed), "xyz");
    put(`tiled${index}`, gabor.gabor_fractal_noise(place, fractal, seed), "xy");
    const warp = gabor.gabor_warp(gabor.gabor_place_at(p), 0.2, fractal, seed);
    put(`warp${index}`, gabor.gabor_fractal_noise(warp.place, gabor.gabor_fractal(1, 0), 7), "xy");
    for (const part of ["dx", "dy"]) for (const axis of "xy") values[`warp${index} ${part}.${axis}`] = warp[part][axis];
});
put("tiled_warp", gabor.gabor_fractal_noise(gabor.gabor_warp(place, 0.2, gabor.gabor_fractal(2, 0.5), 5).place, gabor.gabor_fractal(1, 0), 7), "xy");
writeFileSync(process.argv[2], Buffer.concat(Object.values(values).map(value => Buffer.from(value.parts[0].buffer))));
console.log(JSON.stringify(Object.keys(values)));
"""
# The same in C++.
CPP_FRACTALS = """
    const gabor_vec3 solid(p, 0.3f);
    const gabor_vec2 dx(0.2f, 0.05f), dy(0.1f, -0.3f);
    const gabor_vec3 solid_dx(0.2f, 0.05f, -0.1f), solid_dy(0.1f, -0.3f, 0.2f);
    GaborPlace place = gabor_place_tiled(p, gabor_vec2(3.0f, 4.0f));
    place.evolution = 0.3f;
"""


# The outputs of the shaders, which are C++ functions in the namespace osl, and those of the drop-ins.
NOISE = """
    vector gradient(0), gradient_3d(0);
    float noise, value, phase, intensity, noise_3d, value_3d, phase_3d, intensity_3d;
    const vector place = vector(p.x, p.y, 0.3f) * 0.25f, along(1, 2, 3);
    osl::gabor_noise(place, 4, -4, 0.7854f, 7, 0, along, value, phase, intensity, noise, gradient);
    osl::gabor_noise(place, 4, -4, 0.7854f, 7, 1, along, value_3d, phase_3d, intensity_3d, noise_3d, gradient_3d);
    const gabor_vec3 plane = gabor_noise_gradient(p, 4.0f, 0.7854f, 7u);
    const GaborField3d space = gabor_field_3d(gabor_place_3d_at(gabor_vec3(p, 0.3f)),
                                              4.0f * gabor_impl_unit(gabor_vec3(1.0f, 2.0f, 3.0f)), 7u);
"""
MATERIALX = """
    osl::vector4 plane, space;
    int seed;
    osl::mx_gaborfield2d(osl::vector2{p.x, p.y}, -4, 30, 7, plane);
    osl::mx_gaborfield3d(vector(p.x, p.y, 0.3f), -4, vector(2, 4, 6), 7, space);
    osl::mx_gaborseed(9, -2, seed);
    const GaborField value = gabor_field(gabor_place_at(p), gabor_wave_vector(4.0f, 0.5235988f), 7u);
    const GaborField3d solid = gabor_field_3d(gabor_place_3d_at(gabor_vec3(p, 0.3f)),
                                              4.0f * gabor_impl_unit(gabor_vec3(1.0f, 2.0f, 3.0f)), 7u);
"""
EROSION = """
    float height, ridge, usual_height, usual_ridge;
    osl::gabor_erosion(vector(0.5f * p.x, 0.5f * p.y, 0), 2, 7, 3, 1.3f, 0.15f, 1.9f, 0.6f, 0.4f, 1.2f, 3, 0.3f, 0.05f, 0.7f, 0.8f, height, ridge);
    osl::gabor_erosion(vector(0.5f * p.x, 0.5f * p.y, 0), 2, 7, DEFAULTS, usual_height, usual_ridge);
    const GaborTerrain hills = gabor_terrain(p, 7), usual = gabor_eroded(p, hills, gabor_erosion(), 7);
    const GaborErosion erosion{3, 1.3f, 0.15f, 1.9f, 0.6f, 0.4f, 1.2f, 3, 0.3f, 0.05f, 0.7f, 0.8f};
    const GaborTerrain expected = gabor_eroded(p, hills, erosion, 7);
"""
OCEAN = """
    vector moved[] = {0, 0, 0};
    float height[3], fold[3];
    const gabor_vec2 place = p * 61.0f - gabor_vec2(3000.0f, -900.0f);
    const vector half(0.5f * place.x, 0.5f * place.y, 0);
    osl::gabor_ocean(half, 2, -71.3f, 13, 0.6f, 90000, 2.5f, 11, 2.1f, 0, 0, 7, moved[0], height[0], fold[0]);
    osl::gabor_ocean(half, 2, -71.3f, 13, 0.6f, 90000, 2.5f, 11, 2.1f, 15, 70, 7, moved[1], height[1], fold[1]);
    osl::gabor_ocean(vector(place.x, place.y, 0), DEFAULTS, moved[2], height[2], fold[2]);
    static const GaborOcean seas[] = {gabor_ocean_of(GaborSea{13.0f, 9.0e4f, 2.5f, 11.0f, 2.1f, 0.0f, 0.6f, 0}),
                                      gabor_ocean_of(GaborSea{13.0f, 9.0e4f, 2.5f, 11.0f, 2.1f, 15.0f, 0.6f, 64}), gabor_ocean(10.0f)};
    const GaborWater water[] = {gabor_water(place, -71.3f, seas[0], 7u), gabor_water(place, -71.3f, seas[1], 7u),
                                gabor_water(place, 0.0f, seas[2], 0u)};
    const float units[] = {0.5f, 0.5f, 1.0f};
"""

# Octaves, lacunarities, gains, shapes, bases and seeds of fractals.
FRACTALS = [(1.0, 2.0, 0.5, 0, 0, 7), (4.3, 2.0, 0.6, 0, 1, -3), (5.0, 1.9, 0.5, 1, 0, 8), (3.0, 2.2, 0.8, 1, 1, 9), (5.0, 2.0, 0.5, 2, 0, 2),
            (2.5, 3.0, 0.4, 2, 1, 5)]

# The types and functions of MDL that its module needs, in C++.
MDL = """#include "gabor_fractal.hpp"
#include "gabor_noise_3d.hpp"
using float2 = gabor_vec2; using float3 = gabor_vec3; using float4 = gabor_vec4; using color = gabor_vec3;
struct Right { int bits; };
int operator>>(int word, Right right) { return int(std::uint32_t(word) >> right.bits); }
using std::abs; using std::ceil; using std::floor; using std::sqrt;
template <typename T> T min(T a, float b) { return gabor_cpp_min(a, b); }
template <typename T> T max(T a, float b) { return gabor_cpp_max(a, b); }
template <typename T> T clamp(T a, float low, float high) { return gabor_cpp_clamp(a, low, high); }
template <typename T> float dot(T a, T b) { return gabor_cpp_dot(a, b); }
float rsqrt(float a) { return 1.0f / std::sqrt(a); }
"""
# The nodes of MaterialX's graphs, in C++.
GRAPHS = """#include "gabor_noise.hpp"
#include "gabor_spectrum.hpp"
#include "gabor_fractal.hpp"
#include "gabor_materials.hpp"
#include <algorithm>
struct Value {
    float part[4];
    Value(float all) : part{all, all, all, all} {}
    Value(float x, float y, float z = 0.0f, float w = 0.0f) : part{x, y, z, w} {}
    Value(gabor_vec3 v) : Value(v.x, v.y, v.z) {}
};
template <typename Operation> Value each(Value a, Value b, Operation operation) {
    for (int i = 0; i < 4; ++i) a.part[i] = operation(a.part[i], b.part[i]);
    return a;
}
Value add(Value a, Value b) { return each(a, b, [](float x, float y) { return x + y; }); }
Value subtract(Value a, Value b) { return each(a, b, [](float x, float y) { return x - y; }); }
Value multiply(Value a, Value b) { return each(a, b, [](float x, float y) { return x * y; }); }
Value divide(Value a, Value b) { return each(a, b, [](float x, float y) { return x / y; }); }
Value max(Value a, Value b) { return each(a, b, [](float x, float y) { return std::max(x, y); }); }
Value min(Value a, Value b) { return each(a, b, [](float x, float y) { return std::min(x, y); }); }
Value exp(Value a) { return each(a, a, [](float x, float) { return std::exp(x); }); }
Value clamp(Value a) { return each(a, a, [](float x, float) { return std::min(std::max(x, 0.0f), 1.0f); }); }
Value extract(Value a, int index) { return a.part[index]; }
Value combine2(Value a, Value b) { return {a.part[0], b.part[0]}; }
Value magnitude(Value a) { return std::sqrt(a.part[0] * a.part[0] + a.part[1] * a.part[1]); }
int gaborseed(int seed, int index) { return int(gabor_derived_seed(std::uint32_t(seed), index)); }
Value gaborfield2d(Value p, float frequency, float degrees, int seed) {
    const GaborField field = gabor_field(gabor_place_at({p.part[0], p.part[1]}),
                                         gabor_wave_vector(frequency, 0.017453293f * degrees), std::uint32_t(seed));
    return {field.noise, field.quadrature, field.gradient.x, field.gradient.y};
}
Value gaborfield2d(Value p, float frequency, int seed) { return gaborfield2d(p, frequency, 45.0f, seed); }
float parts(Value a, int i) { return a.part[i]; }
"""

# Nodes in the languages of engines, which run here as C++. HLSL makes an unsigned 0 of a negative float.
ENGINES = """#include "gabor_fractal.hpp"
#include <cstring>
struct Word {
    std::uint32_t word;
    Word(int number) : word(std::uint32_t(number)) {}
    Word(float number) : word(number > 0.0f ? std::uint32_t(number) : 0u) {}
    operator std::uint32_t() const { return word; }
};
Word floatBitsToUint(float number) { Word word(0); std::memcpy(&word, &number, 4); return word; }
using half = float;
using float2 = gabor_vec2; using float3 = gabor_vec3; using half2 = gabor_vec2; using half3 = gabor_vec3;
using vec2 = gabor_vec2; using vec3 = gabor_vec3; using vec4 = gabor_vec4;
vec4 iMouse(500.0f, 130.0f, 1.0f, 0.0f);
vec3 iResolution(800.0f, 450.0f, 1.0f);
#define uint Word
float2 ddx(float2) { return {0.2f, 0.05f}; }
float2 ddy(float2) { return {0.1f, -0.3f}; }
float2 dFdx(float2 p) { return ddx(p); }
float2 dFdy(float2 p) { return ddy(p); }
"""
USED = """
    float a, b, c, d, e, f, g;
    gabor_vec2 slope, slope_half;
    gabor_vec3 stripes, stripes_half;
    gabor_vec4 color;
    const gabor_vec2 along(3.0f, -1.0f), turned(along.y, along.x);
    GaborNoise_float(p, 4.0f, 0.7854f, -3.0f, a, b);
    GaborNoise_half(p, 3.0f, 0.5f, -4.0f, c, d);
    GaborStripes_float(p, along, 3.0f, -5.0f, e, slope, stripes);
    GaborStripes_half(p, turned, 2.0f, -6.0f, f, slope_half, stripes_half);
    float fractals[4];
    gabor_vec2 slopes[4];
    GaborFractal_float(p, 4.3f, 2.0f, 0.6f, 2.0f, 1.0f, -3.0f, fractals[0], slopes[0]);
    GaborFractal_half(p, 3.0f, 2.0f, 0.5f, 1.0f, 0.0f, 4.0f, fractals[1], slopes[1]);
    GaborFractalFiltered_float(p, 4.3f, 2.0f, 0.6f, 2.0f, 1.0f, -3.0f, fractals[2], slopes[2]);
    GaborFractalFiltered_half(p, 3.0f, 2.0f, 0.5f, 1.0f, 0.0f, 4.0f, fractals[3], slopes[3]);
    const GaborFractal kinds[] = {{4.3f, 0.6f, 2.0f, 0.64350111f, GABOR_PERLIN, GABOR_RIDGED}, {3.0f, 0.5f, 2.0f, 0.64350111f, GABOR_SMOOTH, GABOR_BILLOW}};
    const int numbers[] = {-3, 4};
    GaborFractalNoise wanted[4];
    for (int i = 0; i < 4; ++i)
        wanted[i] = i < 2 ? gabor_fractal_noise(gabor_place_at(p), kinds[i], numbers[i])
                          : gabor_fractal_noise_filtered(gabor_place_at(p), ddx(p), ddy(p), kinds[i - 2], numbers[i - 2]);
    GaborFractal tiles = kinds[0];
    tiles.turn = 0.0f;
    mainImage(color, 32.0f * p);
    const gabor_vec2 z_a = gabor_noise_quadrature(p, 4.0f, 0.7854f, -3), z_c = gabor_noise_quadrature(p, 3.0f, 0.5f, -4);
    const GaborField z_e = gabor_field(gabor_place_at(p), along, -5), z_f = gabor_field(gabor_place_at(p), turned, -6);
    const gabor_vec3 s_e = gabor_stripes_of(z_e, 3.0f), s_f = gabor_stripes_of(z_f, 2.0f);
    const gabor_vec2 godot = gabor_noise_quadrature(p, 2.5f, 0.3f, -7);
    const float scale = 8.0f, maker_seed = 0.3f;
    float noise, quadrature;
    { const gabor_vec2 place = p; const float frequency = 2.5f, orientation = 0.3f; const int seed = -7; GODOT }
    float godots[2];
    gabor_vec2 rises[2];
    { FIRST }
    { SECOND }
"""
# The value of each output, and what it should be.
OUTPUTS = {"a": "z_a.x", "b": "z_a.y", "c": "z_c.x", "d": "z_c.y", "e": "z_e.noise", "f": "z_f.noise",
           **{f"slope{half}.{axis}": f"z_{z}.gradient.{axis}" for half, z in (("", "e"), ("_half", "f")) for axis in "xy"},
           **{f"stripes{half}.{axis}": f"s_{z}.{axis}" for half, z in (("", "e"), ("_half", "f")) for axis in "xyz"},
           "unreal(p, 3.0f, 0.5f, -4.0f)": "z_c.x", "noise": "godot.x", "quadrature": "godot.y",
           "float(MAKER)": "gabor_unorm(gabor_noise_tiled(p, gabor_vec2(8.0f), 2.5f, 0.5235988f, floatBitsToUint(0.3f)))",
           **{f"fractals[{i}]": f"wanted[{i}].noise" for i in range(4)},
           **{f"slopes[{i}].{axis}": f"wanted[{i}].gradient.{axis}" for i in range(4) for axis in "xy"},
           **{f"godots[{i}]": f"wanted[{2 * i}].noise" for i in range(2)},
           **{f"rises[{i}].{axis}": f"wanted[{2 * i}].gradient.{axis}" for i in range(2) for axis in "xy"},
           "unreal_fractal(p, 3.0f, 2.0f, 0.5f, 1.0f, 0.0f, 4.0f)": "wanted[1].noise",
           "float(FRACTAL_MAKER)": "gabor_unorm(gabor_fractal_noise(gabor_place_tiled(p, gabor_vec2(8.0f)), tiles, floatBitsToUint(0.3f)).noise)",
           "color.x": "gabor_unorm(gabor_noise(p, 5.0f, 3.1416f * 130.0f / 450.0f, 7u))", "color.z": "color.x"}

LAND = '''
    float heights[4], ridges[2], folds[2];
    gabor_vec2 slopes[4], shifts[2];
    gabor_vec4 cover[2];
    const GaborErosion gullies{3, 1.3f, 0.15f, 1.9f, 0.6f, 0.4f, 1.2f, 3, 0.3f, 0.05f, 0.7f, 0.8f};
    const GaborTerrainPlace ground{{0, 0}, p, {0, 0}};
    static const GaborOcean sea = gabor_ocean_of(GaborSea{13.0f, 9.0e4f, 2.5f, 11.0f, 2.1f, 15.0f, 0.6f, 64});
    const float pixels[] = {0.0f, 0.5f};
    for (int i = 0; i < 2; ++i) {
        (i ? GaborTerrain_half : GaborTerrain_float)(p, 0.2f * pixels[i], 3.0f, 1.3f, 0.15f, 1.9f, 0.6f, 0.4f, 1.2f, 3.0f, 0.3f, 0.05f, 0.7f,
                                                     0.8f, -7.0f, heights[i], slopes[i], ridges[i], cover[i]);
        (i ? GaborSea_half : GaborSea_float)(9.0f * p, pixels[i], 71.3f, 13.0f, 9.0e4f, 2.5f, 11.0f, 2.1f, 15.0f, 0.6f, 64.0f, -7.0f,
                                             heights[i + 2], shifts[i], slopes[i + 2], folds[i]);
    }
    GaborTerrain land[2];
    GaborWater water[2];
    for (int i = 0; i < 2; ++i) {
        const gabor_vec2 dx(pixels[i], 0.0f), dy(0.0f, pixels[i]);
        land[i] = gabor_eroded_at(ground, 0.2f * dx, 0.2f * dy, gabor_terrain_at(ground, 0.2f * dx, 0.2f * dy, std::uint32_t(-7)), gullies, std::uint32_t(-7));
        water[i] = gabor_water_filtered(9.0f * p, dx, dy, 71.3f, sea, std::uint32_t(-7));
    }
'''
LAND_OUTPUTS = {f"{output}{axis}": f"{expected}{axis}" for i in range(2) for output, expected, axes in (
    (f"heights[{i}]", f"land[{i}].height", [""]), (f"slopes[{i}]", f"land[{i}].slope", [".x", ".y"]), (f"ridges[{i}]", f"land[{i}].ridge", [""]),
    (f"cover[{i}]", f"gabor_ground_cover(land[{i}])", [".x", ".y", ".z", ".w"]), (f"heights[{i + 2}]", f"water[{i}].height", [""]),
    (f"shifts[{i}]", f"water[{i}].shift", [".x", ".y"]), (f"slopes[{i + 2}]", f"water[{i}].slope", [".x", ".y"]), (f"folds[{i}]", f"water[{i}].jacobian", [""]))
    for axis in axes}


def godot_node(name, choices=(0, 0, 0)):
    """Returns the functions of a Godot node with these options chosen: GDScript is nearly Python."""
    text = (NODES / f"godot/addons/gabor_noise/gabor_{name}.gd").read_text()
    text = re.sub(r"(?m)^(@tool|class_name .*|extends .*)$", "", text)
    text = re.sub(r"(?m)^(\t?)(?:const|var) (\w+) :=", r"\1\2 =", text)
    text = re.sub(r"(?m)^func (\w+)\((.*?)\) -> [\w.]+:", lambda match: f"def {match[1]}({re.sub(':[^,]*', '', match[2])}):", text)
    text = re.sub(r"% (\(inputs.*\))", r"% tuple\1", text)
    for one, other in (".size()", ".__len__()"), (".is_empty()", " == ''"), ("null", "None"):
        text = text.replace(one, other)
    node = {name: name for name in re.findall(r"PORT_TYPE_\w+", text)} | {"get_option_index": choices.__getitem__, "PackedStringArray": list}
    modes = ("MODE_CANVAS_ITEM", "MODE_SPATIAL", "MODE_PARTICLES", "MODE_SKY", "MODE_FOG")
    node |= {"Shader": types.SimpleNamespace(**{name: name for name in modes}), "VisualShader": types.SimpleNamespace(TYPE_FRAGMENT="fragment")}
    exec(text, node)
    return node


class Interfaces(unittest.TestCase):
    """The names, types, defaults and ranges of what each node shows its users must be those of tests/golden/nodes.txt.
    GABOR_GOLDEN=write rewrites that file."""

    maxDiff = None

    def test_are_those_of_the_golden_file(self):
        found = "".join(f"{line}\n" for kind in (self.unity, self.godot, self.material_maker, self.osl, self.materialx, self.blender) for line in kind())
        golden = HERE.parent / "golden" / "nodes.txt"
        if os.environ.get("GABOR_GOLDEN") == "write":
            golden.write_text(found)
        self.assertEqual(found, golden.read_text())

    def unity(self):
        for path in sorted(unity().glob("*.shadersubgraph")):
            graph, *objects = map(json.loads, path.read_text().split("\n\n"))
            named = {each["m_ObjectId"]: each for each in objects}
            yield f"Unity: {graph['m_Path']}/{path.stem}, {named[graph['m_OutputNode']['m_Id']]['m_Name']}"
            for each in (named[each["m_Id"]] for each in graph["m_Properties"]):
                yield f"    {each['m_Name']} {each['m_Type'].rpartition('.')[2]} {each['m_Value']} {each.get('m_RangeValues')} {each['m_Hidden']}"
            category, = (each for each in objects if each["m_Type"].endswith("CategoryData"))
            self.assertEqual(category["m_ChildObjectList"], graph["m_Properties"])
            for each in (each for each in objects if each["m_Type"].endswith("PropertyNode")):
                self.assertEqual(named[each["m_Slots"][0]["m_Id"]]["m_DisplayName"], named[each["m_Property"]["m_Id"]]["m_Name"])
            slots = [named[each["m_Id"]] for each in named[graph["m_OutputNode"]["m_Id"]]["m_Slots"]]
            yield "    out: " + ", ".join(f"{each['m_DisplayName']} {each['m_Type'].rpartition('.')[2]}" for each in slots)

    def godot(self):
        for name in "noise", "fractal":
            node = godot_node(name)
            yield f"Godot: {node['_get_category']()}/{node['_get_name']()} {node['_get_return_icon_type']()}: {node['_get_description']()}"
            for port in range(node["_get_input_port_count"]()):
                yield "    " + " ".join(str(node[f"_get_input_port_{what}"](port)) for what in ("name", "type", "default_value"))
            for port in range(node["_get_output_port_count"]()):
                yield "    out: " + " ".join(str(node[f"_get_output_port_{what}"](port)) for what in ("name", "type"))
            for index in range(node["_get_property_count"]() if "_get_property_count" in node else 0):
                yield "    choice: " + " ".join(str(node[f"_get_property_{what}"](index)) for what in ("name", "options", "default_index"))
            yield "    " + node["_get_global_code"]("")
            for place, mode in ("p", "MODE_SPATIAL"), ("", "MODE_SPATIAL"), ("", "MODE_CANVAS_ITEM"), ("", "MODE_SKY"):
                yield f"    {mode} {node['_get_code']([place, 'f', 'o', 's'], ['n', 'q'], mode, None)!r}"

    def material_maker(self):
        for path in sorted((NODES / "material_maker").glob("*.mmg")):
            node = json.loads(path.read_text())
            model = node["shader_model"]
            self.assertEqual(set(node["parameters"]), {each["name"] for each in model["parameters"]})
            yield f"Material Maker: {node['type']} {node['name']} {node['parameters']}"
            for each in (model, *model["parameters"], *model["outputs"]):
                yield "    " + " ".join(f"{name}={value}" for name, value in each.items()
                                        if name not in ("parameters", "outputs", "global", "f") and value != "")

    def osl(self):
        for path in sorted((NODES / "osl").glob("*.osl")):
            yield f"OSL: {path.stem}"
            for line in re.search(r"(?s)^shader \w+\(\n(.*?)\)\n\{", path.read_text(), re.MULTILINE)[1].split("\n"):
                yield line

    def materialx(self):
        folder = materialx()
        used = {}
        for node in ElementTree.parse(folder / "gabor_defs.mtlx").iter("nodedef"):
            self.assertEqual(node.get("name").removeprefix("ND_").partition("_")[0], node.get("node"))
            yield "MaterialX: " + " ".join(node.attrib.values()) + " -> " + ", ".join(" ".join(each.attrib.values()) for each in node.findall("output"))
            for put in node.findall("input"):
                used.setdefault(" ".join(f"{name}={value}" for name, value in put.attrib.items()), []).append(node.get("name").removeprefix("ND_gabor"))
        for put, nodes in used.items():
            yield f"    {put}: {' '.join(nodes)}"
        for path in sorted(folder.glob("*/*_impl.mtlx")):
            for each in ElementTree.parse(path).iter("implementation"):
                name, target = each.get("nodedef").removeprefix("ND_"), path.parent.name
                file = {"genglsl": f"mx_{name}.glsl", "genosl": f"mx_{name}.osl", "genmdl": "gabor/genmdl/mx_gabor.mdl"}[target]
                self.assertEqual(list(each.attrib.values()), [f"IM_{name}_{target}", f"ND_{name}", file, f"mx_{name}", target])

    def blender(self):
        from blender_nodes import bpy
        sys.path.insert(0, str(NODES / "blender"))
        import gabor_noise
        operator = gabor_noise.GABOR_OT_add
        yield f"Blender: {operator.bl_idname} {operator.bl_label}: {operator.__doc__}"
        gabor_noise.field_group()
        for name, group in bpy.data.node_groups.items():
            for each in group.sockets:
                yield f"    {name}: {' '.join(map(str, vars(each).values()))}"
        # Adding the node to an editor's tree.
        tree, menus = type(bpy.data.node_groups[name])(), []
        old = tree.new("ShaderNodeTexNoise")
        old.select, tree.active = True, old
        space = types.SimpleNamespace(type="NODE_EDITOR", tree_type="ShaderNodeTree", edit_tree=tree, cursor_location=(3, 4))
        context = types.SimpleNamespace(space_data=space)
        self.assertTrue(operator.poll(context))
        for name, other in ("type", "VIEW_3D"), ("tree_type", "GeometryNodeTree"), ("edit_tree", None):
            self.assertFalse(operator.poll(types.SimpleNamespace(space_data=types.SimpleNamespace(**vars(space) | {name: other}))))
        self.assertEqual(operator.execute(None, context), {"FINISHED"})
        added = tree.active
        self.assertEqual((added.kind, added.node_tree, added.location, old.select), ("Group", gabor_noise.field_group(), (3, 4), False))
        for names in (["NODE_MT_category_shader_texture"], ["NODE_MT_shader_node_add_all", "NODE_MT_category_shader_texture"]):
            for each in names:
                setattr(bpy.types, each, menus)
            bpy.utils = types.SimpleNamespace(register_class=menus.append, unregister_class=menus.remove)
            gabor_noise.register()
            self.assertEqual(menus, [operator, gabor_noise.menu])
            gabor_noise.unregister()
            self.assertEqual(menus, [])
        self.assertEqual(gabor_noise.menus(), [menus])
        gabor_noise.menu(types.SimpleNamespace(layout=types.SimpleNamespace(operator=menus.append)), None)
        self.assertEqual(menus, ["node.add_gabor_noise"])


# Draws every eighth pixel of a 256 x 256 picture with code for Shadertoy, twice: with the mouse button up and down.
SHADERTOY = """#version 450
layout(local_size_x = 8) in;
layout(std430, set = 0, binding = 0) writeonly buffer Values { float values[]; };
const vec3 iResolution = vec3(256.0, 256.0, 1.0);
const float iTime = 7.3;
vec4 iMouse;
CODE
void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (pixel.x < 32u) {
        vec4 colour;
        iMouse = pixel.y < 32u ? vec4(0.0) : vec4(180.0, 90.0, 1.0, 1.0);
        mainImage(colour, 8.0 * vec2(pixel.x, pixel.y % 32u) + 0.5);
        values[pixel.y * 256u + pixel.x] = dot(colour, vec4(0.3, 0.6, 0.1, 0.0));
    }
}
"""


@unittest.skipUnless("GABOR_SCENES" in os.environ and shutil.which("glslangValidator"), "needs a device and glslangValidator")
class Drawn(unittest.TestCase):
    """Of Shadertoy's code and of Bevy's example, the sums of rows and columns of pictures must be those of tests/golden/drawn.txt. GABOR_GOLDEN=write rewrites that file."""

    def test_pictures(self):
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory(prefix="gabor-")))
        golden, lines = HERE.parent / "golden" / "drawn.txt", []
        for path in sorted(packaged("shadertoy", folder / "shadertoy").glob("*.frag")):
            (folder / "shader.comp").write_text(SHADERTOY.replace("CODE", path.read_text()))
            subprocess.run(["glslangValidator", "--quiet", "-V", "-o", folder / "shader.spv", folder / "shader.comp"], check=True)
            for mouse, picture in zip((0, 3), on_vulkan(folder / "shader.spv", rows=64)[1].reshape(2, 32, 256)[..., :32]):
                lines.append((f"{path.name} {mouse}", np.concatenate([picture.sum(0), picture.sum(1)])))
        if shutil.which("naga"):  # Bevy's example, with the modules that it imports
            modules = [(SHADERS / "translations" / f"gabor_{name}.wgsl").read_text() for name in ("noise", "direction")]
            example = re.sub("(?m)^#import.*", "", (NODES / "bevy/example/src/stripes.wgsl").read_text())
            self.assertEqual((example.count("768u"), example.count("fn draw")), (1, 1))
            (folder / "shader.wgsl").write_text("\n".join([*modules, example.replace("768u", "256u").replace("fn draw", "fn main")]))
            subprocess.run(["naga", folder / "shader.wgsl", folder / "shader.spv"], check=True, stdout=subprocess.DEVNULL)
            picture = on_vulkan(folder / "shader.spv", rows=256)[1].view("<u4").reshape(256, 256)
            colours = np.stack([picture >> shift & 255 for shift in (0, 8, 16, 24)]) / 2040
            lines.append(("stripes.wgsl", np.concatenate([colours.mean((0, 2))[::8], colours.mean((0, 1))[::8], colours.mean((1, 2))]) * 256))
        if os.environ.get("GABOR_GOLDEN") == "write":
            golden.write_text("".join(f"{name}: {' '.join(f'{each:.2f}' for each in sums)}\n" for name, sums in lines))
        wanted = dict(line.split(": ") for line in golden.read_text().splitlines())
        self.assertEqual([name for name, _ in lines], [name for name in wanted if name != "stripes.wgsl" or shutil.which("naga")])
        for name, sums in lines:
            with self.subTest(name):
                self.assertTrue(np.isfinite(sums).all())
                np.testing.assert_allclose(sums, [float(each) for each in wanted[name].split()], rtol=0, atol=0.2)


SHIMS = """#version 450
layout(local_size_x = 8) in;
layout(std430, set = 0, binding = 0) writeonly buffer Values { float values[]; };
TEXTS
float at(uint word) {
    return 1000.0 * float(gabor_impl_mix(word, 0x9e3779b1u) >> 8) / 16777216.0 - 500.0;
}
void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    uint i = 256u * pixel.y + pixel.x, picture = pixel.y / 256u;
    vec3 p = vec3(at(3u * i), at(3u * i + 1u), at(3u * i + 2u));
    if (picture >= 16u) p = vec3(vec2(pixel) / 6.0 + 300.0 * vec2(picture, picture * picture % 7u), 3.7 * float(picture));
    values[i] = VALUE;
}
"""


@unittest.skipUnless("GABOR_SCENES" in os.environ and shutil.which("glslangValidator"), "needs a device and glslangValidator")
class Shims(unittest.TestCase):
    """Draws the shim's functions at a million random places, and in 16 pictures with 6 pixels per cell."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="gabor-")))
        cls.texts = "".join((SHADERS / name).read_text() for name in ("gabor_noise.glsl", "gabor_fractal.glsl",
                                                                      "nodes/shims/webgl_noise.glsl"))

    def drawn(self, value, pictures=32):
        (self.folder / "shader.comp").write_text(SHIMS.replace("TEXTS", self.texts).replace("VALUE", value))
        subprocess.run(["glslangValidator", "--quiet", "-V", "-o", self.folder / "shader.spv", self.folder / "shader.comp"], check=True)
        values = on_vulkan(self.folder / "shader.spv", rows=256 * pictures)[1].astype(float).reshape(-1, 256, 256)
        self.assertTrue(np.isfinite(values).all())
        return values[:16].ravel(), values[16:]

    def test_they_have_the_deviation_and_size_of_webgl_noise(self):
        """The README's table has those of webgl-noise, and the shim's."""
        calls = {"snoise(vec2)": "snoise(p.xy)", "snoise(vec3)": "snoise(p)", "cnoise(vec2)": "cnoise(p.xy)", "cnoise(vec3)": "cnoise(p)",
                 "pnoise(vec2, vec2)": "pnoise(p.xy, vec2(50.0, 64.0))", "pnoise(vec3, vec3)": "pnoise(p, vec3(50.0, 64.0, 36.0))"}
        rows = re.findall(r"(?m)^\| (`[scp]noise.*) \| ([\d.]+), ([\d.]+) \| ([\d.]+), ([\d.]+) \| ([\d.]+) % \|$",
                          (NODES / "shims" / "README.md").read_text())
        facts = {call: [float(each) for each in row] for names, *row in rows for call in re.findall("`(.*?)`", names)}
        self.assertEqual(set(facts), set(calls))
        window, along = np.hanning(256), np.fft.fftfreq(256, 1 / 6)
        cycles = np.hypot(along[:, None], along)
        for name, (deviation, ours, centroid, our_centroid, beyond) in facts.items():
            values, pictures = self.drawn(calls[name])
            pictures = pictures - pictures.mean((1, 2), keepdims=True)
            power = (np.abs(np.fft.fft2(window[:, None] * window * pictures)) ** 2).mean(0)
            found = values.std(), (power * cycles).sum() / power.sum()
            print(f"{name}: mean {values.mean():.4f}, deviation {found[0]:.4f}, webgl-noise {deviation}; centroid {found[1]:.3f}, "
                  f"webgl-noise {centroid}; beyond 1 {100 * (np.abs(values) > 1).mean():.2f} %")
            with self.subTest(name):
                self.assertLess(abs(values.mean()), 0.003)
                self.assertLess(abs(found[0] / deviation - 1), 0.01)
                self.assertLess(abs(found[0] / ours - 1), 0.005)
                self.assertLess(abs(found[1] / centroid - 1), 0.03)
                self.assertLess(abs(found[1] / our_centroid - 1), 0.02)
                self.assertLess(abs(100 * (np.abs(values) > 1).mean() - beyond), 0.06)

    def test_pnoise_repeats(self):
        for one, other in (("pnoise(p.xy, vec2(7.0, 3.0))", "pnoise(p.xy + vec2(14.0, -3.0), vec2(7.0, 3.0))"),
                           ("pnoise(p, vec3(7.0, 3.0, 4.0))", "pnoise(p + vec3(7.0, -6.0, 4.0), vec3(7.0, 3.0, 4.0))"),
                           ("pnoise(p.xy, vec2(0.0))", "cnoise(p.xy)"), ("pnoise(p, vec3(0.0))", "cnoise(p)")):
            values, _ = self.drawn(f"{one} - {other}", 1)
            print(f"{one} and {other} differ by at most {np.abs(values).max():.1e}")
            self.assertLess(np.abs(values).max(), 5e-4)
            self.assertGreater(self.drawn(one, 1)[0].std(), 0.25)


class ByHand(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory(prefix="gabor-")))

    def compare(self, function, values):
        error, place = reference.largest_difference(function, values)
        print(f"{function}: largest difference {error:.2g} at row and column {place}")
        self.assertLess(error, 1e-5)

    def osl(self, text, drop_ins, code, values):
        """Returns the values of expressions after code that calls OSL as C++ functions. `text` is OSL, or a shader's name."""
        if text.endswith(".osl"):
            text = (packaged("osl", self.folder / "osl") / text).read_text()
        text = re.sub(r" = [^\[\n]*\[\[.*\]\]", "", re.sub(r"^shader ", "void ", text, flags=re.MULTILINE))
        text = re.sub(r"output (\w+ \w+\[)", r"\1", text)  # arrays are passed by reference anyway
        text = re.sub(r"output (\w+) (\w+)", r"\1& \2", text)
        text = re.sub(r"(?<![\w.])(\d+\.\d+(?:e-?\d+)?)(?![\w.])", r"\1f", text)
        includes = "".join(f'#include "{file}.hpp"\n' for file in drop_ins)
        return in_cpp(self.folder, f'#include "osl.hpp"\nnamespace osl {{\n{text}}}\n{includes}', values, "-O1", "-fwrapv", "-DGABOR_INLINE=inline", "-I",
                      SHADERS / "translations", *metal.options(os.environ.get("CXX", "c++")), code=code, rows=32).astype(float)

    def test_open_shading_language(self):
        """Compares the noise with the reference and the shader's other outputs with the translation to C++."""
        made = self.osl("gabor_noise.osl", ["gabor_noise", "gabor_noise_3d"], NOISE, [
            *"noise gradient.x gradient.y gradient.z value phase intensity".split(),
            *"noise_3d gradient_3d.x gradient_3d.y gradient_3d.z value_3d phase_3d intensity_3d".split(),
            "gabor_noise_quadrature(p, 4.0f, 0.7854f, 7u).y", *"plane.y plane.z space.noise space.gradient.x space.gradient.y space.gradient.z".split()])
        plane, space, expected = np.split(made, 3)
        self.compare("noise", plane[0])
        self.assertLess(np.abs(plane[1:3] - expected[1:3]).max(), 2e-3)
        self.assertLess(np.abs(space[0] - expected[3]).max(), 3e-5)
        self.assertLess(np.abs(space[1:4] - expected[4:]).max(), 2e-3)
        for noise, *_, value, phase, intensity in (plane, space):
            self.assertLess(np.abs(value - np.clip(0.5 + 0.25 * noise, 0, 1)).max(), 1e-6)
        self.assertEqual(np.abs(plane[3]).max(), 0)
        phase, intensity = plane[5:]
        self.assertLess(np.abs(intensity * np.sin(2 * np.pi * phase) - plane[0]).max(), 1e-5)
        self.assertLess(np.abs(intensity * np.cos(2 * np.pi * phase) - expected[0]).max(), 2e-5)
        self.assertTrue(((0 <= phase) & (phase <= 1)).all())

    def test_nodes_of_materialx(self):
        """Runs the nodes' functions, translated to OSL."""
        folder = materialx() / "genosl"
        names = "lib/mx_gabor", "mx_gaborfield2d", "mx_gaborfield3d", "mx_gaborseed"
        text = "struct vector2 { float x; float y; };\nstruct vector4 { float x; float y; float z; float w; };\n" + "".join(
            re.sub("#include.*", "", (folder / f"{name}.osl").read_text()) for name in names)
        made, expected = np.split(self.osl(text, ["gabor_noise", "gabor_noise_3d"], MATERIALX, [
            *(f"plane.{part}" for part in "xyzw"), *(f"space.{part}" for part in "xyzw"), "float(seed)",
            *"value.noise value.quadrature value.gradient.x value.gradient.y".split(),
            *"solid.noise solid.gradient.x solid.gradient.y solid.gradient.z float(int(gabor_derived_seed(9,-2)))".split()]), 2)
        self.assertLess(np.abs(made - expected).max(), 2e-3)

    def compare_fractals(self, names, made, expected, jumps):
        """Compares outputs of fractals. `jumps` is whether an output jumps, as the gradients of billows and ridges do where an octave is 0."""
        self.assertEqual(made.shape, expected.shape)
        errors = {}
        for name, one, other in zip(names, made, expected, strict=True):
            with self.subTest(name):
                self.assertGreater(other.std(), 0.1)
                error = np.sort((np.abs(one - other) / max(1, other.std())).ravel())
                errors[name] = error[-1 - error.size // 500 if jumps(name) else -1]
                self.assertLess(errors[name], 1e-5)
        print(*max((error, name) for name, error in errors.items()))

    def test_fractals_in_open_shading_language(self):
        """Runs gabor_fractal.osl, and MaterialX's nodes translated to OSL."""
        folder = materialx() / "genosl"
        text = (packaged("osl", self.folder / "osl") / "gabor_fractal.osl").read_text() + "".join(
            re.sub("#include.*", "", (folder / f"mx_gaborfractalfield{dim}d.osl").read_text()) for dim in (2, 3))
        text = text.replace("struct vector4", "struct vector2 { float x; float y; };\nstruct vector4", 1)
        code, names, values, expected = "float shown;", [], [], []
        for case, (octaves, lacunarity, gain, shape, basis, seed) in enumerate(FRACTALS):
            for solid, dim in (0, 2), (1, 3):
                sum, parts = f"{case}_{dim}", "xyz"[:dim]
                given = f"{octaves}f, {lacunarity}f, {gain}f, {shape}, {basis}, {seed}"
                place = "{p.x, p.y}" if dim == 2 else "(p.x, p.y, 0.3f)"
                code += f"""
                    float noise{sum}; vector gradient{sum}; {"osl::vector4" if solid else "vector"} node{sum};
                    osl::gabor_fractal(0.25f * vector(p.x, p.y, 0.3f), 4, {given}, {solid}, shown, noise{sum}, gradient{sum});
                    osl::mx_gaborfractalfield{dim}d({"vector" if solid else "osl::vector2"}{place}, {given}, node{sum});
                    const auto drop{sum} = gabor_fractal_noise{"_3d" * solid}(gabor_place{"_3d" * solid}_at({"gabor_vec3(p, 0.3f)" if solid else "p"}),
                        GaborFractal{{{octaves}f, {gain}f, {lacunarity}f, 0.64350111f, {basis}, {shape}}}, std::uint32_t({seed}));"""
                for output, of in ("noise", [f"noise{sum}", f"node{sum}.x"]), *((f"d/d{part}", [f"gradient{sum}.{part}", f"node{sum}.{next}"])
                                                                              for part, next in zip(parts, "yzw")):
                    names += [f"{dim}D, shape {shape}, basis {basis}, {kind} {output}" for kind in ("OSL", "MaterialX")]
                    values += of
                    expected += 2 * [f"drop{sum}.noise" if output == "noise" else f"drop{sum}.gradient.{output[-1]}"]
        self.compare_fractals(names, *np.split(self.osl(text, ["gabor_noise", "gabor_fractal"], code, values + expected), 2),
                              lambda name: "d/d" in name and "shape 0" not in name)

    def test_module_of_materialx(self):
        """Runs MDL's functions as C++."""
        text = (materialx() / "genmdl/mx_gabor.mdl").read_text().partition("import ::math::*;\n")[2].replace("export ", "")
        text = re.sub(r"(?<![\w.])(\d+\.\d+(?:e-?\d+)?)(?![\w.])", r"\1f", re.sub(r">>> (\d+)", r">> Right{\1}", text))
        seeds = ["seed", *(f"int(gabor_derived_seed(seed,-{k}))" for k in (1, 2, 3))]
        cases = {"mx_gaborseed(seed,-2)": [seeds[2]]}
        for dim, given, noise in (("2d", "p,-4.0f,30.0f,seed", "gabor_field(gabor_place_at(p),flat,std::uint32_t({})).noise"),
                                  ("3d", "place,-4.0f,along,seed", "gabor_field_3d(gabor_place_3d_at(place),solid,std::uint32_t({})).noise")):
            field = noise.format("seed").removesuffix(".noise")
            cases[f"mx_gaborfield{dim}({given})"] = [f"{field}.{part}" for part in (
                "noise quadrature gradient.x gradient.y" if dim == "2d" else "noise gradient.x gradient.y gradient.z").split()]
            for kind, count in ("float", 1), ("vector2", 2), ("vector3", 3), ("vector4", 4), ("color3", 3):
                each = "-1.5f,2.0f,0.5f,3.0f".split(",")[:count]
                several = each[0] if count == 1 else f"float{count}({','.join(each)})"
                for suffix, amplitude, amplitudes in ("", several, each), ("FA", "-1.5f", count * ["-1.5f"]):
                    if count > 1 or not suffix:
                        cases[f"mx_gabornoise{dim}_{kind}{suffix}({amplitude},0.25f,{given})"] = [
                            f"{one}*{noise.format(seed)}+0.25f" for one, seed in zip(amplitudes, seeds)]
            for octaves, lacunarity, gain, shape, basis, number in FRACTALS:
                call = f"mx_gaborfractalfield{dim}({given.partition(',')[0]},{octaves}f,{lacunarity}f,{gain}f,{shape},{basis},{number})"
                three = "_3d" * (dim == "3d")
                drop_in = (f"gabor_fractal_noise{three}(gabor_place{three}_at({given.partition(',')[0]}),GaborFractal{{{octaves}f,{gain}f,{lacunarity}f,"
                           f"0.64350111f,{basis},{shape}}},std::uint32_t({number}))")
                cases[call] = [f"{drop_in}.{part}" for part in ["noise", *(f"gradient.{axis}" for axis in "xyz"[:int(dim[0])])]]
        parts = [f"float({call})" if len(outputs) == 1 else f"{call}.{part}" for call, outputs in cases.items() for part, _ in zip("xyzw", outputs)]
        made, expected = np.split(in_cpp(self.folder, f"{MDL}{text}", [*parts, *(f"float({output})" for outputs in cases.values() for output in outputs)],
                                         "-std=c++17", "-O1", "-fwrapv", "-DGABOR_INLINE=inline", "-I", SHADERS / "translations", rows=2, code="""
            const int seed = 9;
            const gabor_vec3 place(p, 0.3f), along(2.0f, 4.0f, 6.0f), solid = 4.0f * gabor_impl_unit(along);
            const gabor_vec2 flat = gabor_wave_vector(4.0f, 0.5235988f);"""), 2)
        for part, one, other in zip(parts, made, expected):
            with self.subTest(part):
                np.testing.assert_allclose(one, other, rtol=1e-6, atol=2e-3 if "field" in part else 1e-4)
        self.assertEqual({call.partition("(")[0] for call in cases}, set(re.findall(r"(?m)^\w+ (mx_gabor(?:noise|field|fractalfield|seed)\w*)\(", text)))

    def test_erosion_in_open_shading_language(self):
        given = re.findall(r"^    (?:float|int) \w+ = ([\d.]+) \[\[", (NODES / "osl" / "gabor_erosion.osl").read_text(), re.MULTILINE)
        outputs = "2.0f*height 2.0f*usual_height ridge usual_ridge expected.height usual.height expected.ridge usual.ridge".split()
        made, expected = np.split(self.osl("gabor_erosion.osl", ["gabor_noise", "gabor_erosion"],
                                           EROSION.replace("DEFAULTS", ", ".join(given[2:])), outputs), 2)
        error = np.abs(made - expected).max(axis=(1, 2))
        print(f"largest differences of height and ridge: {error}")
        self.assertTrue((error < [1e-5, 1e-5, 1e-3, 1e-3]).all())

    def test_ocean_in_open_shading_language(self):
        given = re.findall(r"^    (?:float|int) \w+ = ([\d.]+) \[\[", (NODES / "osl" / "gabor_ocean.osl").read_text(), re.MULTILINE)
        code = OCEAN.replace("DEFAULTS", ", ".join(f"{each}f" if "." in each else each for each in given))
        outputs = [each.replace("I", str(i)) for each in ("moved[I].x moved[I].y moved[I].z height[I] fold[I] units[I]*water[I].shift.x "
                   "units[I]*water[I].shift.y units[I]*water[I].height units[I]*water[I].height water[I].jacobian").split() for i in range(3)]
        made, expected = np.split(self.osl("gabor_ocean.osl", ["gabor_noise", "gabor_ocean"], code, outputs), 2)
        error = np.abs(made - expected).max(axis=(1, 2)) / expected.std(axis=(1, 2)) / 4
        print(f"largest differences, in significant heights: {error.max():.2g}")
        self.assertLess(error.max(), 1e-5)

    def test_each_output_of_nodes_that_call_the_drop_in(self):
        """Unity, Unreal, Godot, Material Maker and Shadertoy, with negative seeds, and with inputs that all differ."""
        unreal, fractal = ((pathlib.Path(package("unreal").name) / f"Gabor {name}.hlsl").read_text() for name in ("Noise", "Fractal"))
        shadertoy = as_cpp((NODES / "shadertoy" / "gabor_noise.frag").read_text().partition("// ---- your code ----")[2], OUT)
        godot = (NODES / "godot/addons/gabor_noise/gabor_noise.gd").read_text()
        names = [json.loads(re.search(pattern, godot)[1]) for pattern in (r"const NAMES := (\[.*\])", r"return (\[.*\])\[port\]")]
        defaults = json.loads(re.search(r"const DEFAULTS := (\[.*\])", godot)[1])
        self.assertEqual(dict(zip(names[0], defaults)), {"place": None, "frequency": 4, "orientation": 0.7854, "seed": 7})
        godot = re.search(r'return "(vec2 gabor = .*)" % \(inputs \+ outputs\)', godot)[1].replace("\\n", "\n") % tuple(sum(names, []))
        fractals = [as_cpp(godot_node("fractal", choices)["_get_code"](["p", "4.3f", "0.6f", "-3"], [f"godots[{i}]", f"rises[{i}]"], None, "fragment"))
                    for i, choices in enumerate(((2, 1, 0), (2, 1, 1)))]
        given = dict(uv="(p / 8.0f)", scale="8.0f", frequency="2.5f", orientation="30.0f", seed="0.3f", octaves="4.3f", gain="0.6f", basis="1", shape="2")
        makers = []
        for name in "noise", "fractal":
            output, = json.loads((NODES / "material_maker" / f"gabor_{name}.mmg").read_text())["shader_model"]["outputs"]
            code = as_cpp(output["f"], *((rf"\${name}\b", value) for name, value in given.items()))
            makers.append(re.sub(r"GaborFractal\((.*?)\)", r"GaborFractal{\1}", code))
        before = f"{ENGINES}{unity_as_cpp('Noise')}\nfloat unreal(float2 Place, float Frequency, float Orientation, float Seed) {{ float Quadrature;\n{unreal} }}\n"
        before += f"float unreal_fractal(float2 Place, float Octaves, float Lacunarity, float Gain, float Shape, float Basis, float Seed) {{ float2 Gradient;\n{as_cpp(fractal)} }}\n{shadertoy}"
        values = [*OUTPUTS, *OUTPUTS.values()]
        made, expected = np.split(in_cpp(self.folder, before, [value.replace("FRACTAL_MAKER", makers[1]).replace("MAKER", makers[0]) for value in values], "-std=c++17", "-O1",
                                         "-DGABOR_INLINE=inline", "-I", SHADERS / "translations", rows=32, code=USED.replace("GODOT", godot).replace("FIRST", fractals[0]).replace("SECOND", fractals[1])), 2)
        for output, one, other in zip(OUTPUTS, made, expected):
            with self.subTest(output):
                self.assertGreater(one.std(), 0.1)
                np.testing.assert_allclose(one, other, rtol=0, atol=1e-5)

    def test_terrain_and_sea_of_unity(self):
        """With a pixel and without; Unreal's nodes have the same text."""
        before = ("#include \"gabor_erosion.hpp\"\n#include \"gabor_ocean.hpp\"\n"
                  f"{ENGINES}using int2 = gabor_ivec2; using half4 = gabor_vec4; using float4 = gabor_vec4;\n{unity_as_cpp('Terrain')}\n{unity_as_cpp('Sea')}")
        made, expected = np.split(in_cpp(self.folder, before, [*LAND_OUTPUTS, *LAND_OUTPUTS.values()], "-std=c++17", "-O1",
                                         "-DGABOR_INLINE=inline", "-I", SHADERS / "translations", rows=16, code=LAND), 2)
        for output, one, other in zip(LAND_OUTPUTS, made, expected):
            with self.subTest(output):
                self.assertGreater(one.std(), 0.01)
                np.testing.assert_allclose(one, other, rtol=0, atol=1e-5)

    def test_nodes_of_blender(self):
        from blender_nodes import bpy, white_noise  # replaces Blender's own bpy
        sys.path.insert(0, str(NODES / "blender"))
        import gabor_noise
        group, place, seed = gabor_noise.field_group(), np.random.default_rng(1).uniform(-9, 9, (3, 500)), 5.0

        def amplitudes(i, j):
            white = 2 * white_noise(np.array([i, j, 0 * i], float), seed) - 1
            return (reference.law(white[0]) + 1j * reference.law(white[1])) / reference.DEVIATION
        wanted = reference.complex_lattice((0, 0), 1.5 * 3 * place[0], 1.5 * 3 * place[1], amplitudes=amplitudes,
                                           wave=(2.5 * np.cos(0.6), 2.5 * np.sin(0.6)))
        given = {"Vector": place, "Scale": 3.0, "Frequency": -2.5, "Orientation": 0.6, "Seed": seed}
        for output, expected in {"Noise": wanted.imag, "Quadrature": wanted.real, "Value": np.clip(0.5 + 0.25 * wanted.imag, 0, 1),
                                 "Phase": np.angle(wanted) / (2 * np.pi) % 1, "Intensity": np.abs(wanted)}.items():
            np.testing.assert_allclose(group.value(output, given), expected, rtol=0, atol=1e-4, err_msg=output)
        self.assertIs(gabor_noise.field_group(), group)
        self.assertEqual(len(bpy.data.node_groups), 2)

    def test_nodes_of_godot_read_no_uv_where_there_is_none(self):
        for name in "noise", "fractal":
            for mode, has_uv in ("SPATIAL", True), ("CANVAS_ITEM", True), ("SKY", False), ("FOG", False), ("PARTICLES", False):
                code = godot_node(name)["_get_code"](["", "f", "o", "s"], ["n", "q"], f"MODE_{mode}", None)
                self.assertEqual("UV" in code, has_uv, f"{name}, {mode}")

    def test_graphs_of_materialx(self):
        """Each component of a noise has a seed of its own, and each output of a wave a component of its field."""
        defined = {each.get("name"): each for each in ElementTree.parse(materialx() / "gabor_defs.mtlx").iter("nodedef")}
        graphs = {}
        for graph in ElementTree.parse(materialx() / "gabor_ng.mtlx").getroot().iter("nodegraph"):
            nodes = {each.get("name"): each for each in graph}

            def value(put):
                if put.get("nodename") is None:
                    return put.get("interfacename") or put.get("value")
                node = nodes[put.get("nodename")]
                return node.tag + "(" + ", ".join(f"{each.get('name')}={value(each)}" for each in node) + ")"
            graphs[graph.get("name").removeprefix("NG_")] = [value(output) for output in graph.findall("output")]
            self.assertEqual(graph.get("nodedef"), graph.get("name").replace("NG_", "ND_"))
            self.assertEqual(*({each.get("name"): each.get("type") for each in of.findall("output")} for of in (graph, defined[graph.get("nodedef")])))

        every = set(graphs)

        def combined(parts):
            return parts[0] if len(parts) == 1 else f"combine{len(parts)}({', '.join(f'in{k}={part}' for k, part in enumerate(parts, 1))})"
        for dim, place, along in ("2d", "texcoord", "orientation"), ("3d", "position", "direction"):
            def part(index, seed="seed"):
                field = f"gaborfield{dim}({place}={place}, frequency=frequency, {along}={along}, seed={seed})"
                return f"extract(in={field}, index={index})"
            noises = [part(0), *(part(0, f"gaborseed(seed=seed, index=-{k})") for k in (1, 2, 3))]
            for count, kind in enumerate(("float", "vector2", "vector3", "vector4"), 1):
                self.assertEqual(graphs.pop(f"gabornoise{dim}_{kind}"),
                                 [f"add(in1=multiply(in1={combined(noises[:count])}, in2=amplitude), in2=pivot)"])
                given = f"pivot=pivot, {place}={place}, frequency=frequency, {along}={along}, seed=seed"
                for of in [kind, kind.replace("vector", "color")][:1 + (count > 2)] if count > 1 else ():
                    self.assertEqual(graphs.pop(f"gabornoise{dim}_{of}FA"), [f"gabornoise{dim}(amplitude=convert(in=amplitude), {given})"])
                if count > 2:
                    self.assertEqual(graphs.pop(f"gabornoise{dim}_color{count}"), [f"convert(in=gabornoise{dim}(amplitude=amplitude, {given}))"])
            parts = [part(0), part(1), combined([part(2), part(3)])] if dim == "2d" else [part(0), combined([part(1), part(2), part(3)])]
            self.assertEqual(graphs.pop(f"gaborwave{dim}"), parts)
            given = f"{place}={place}, octaves=octaves, lacunarity=lacunarity, diminish=diminish, shape=shape, basis=basis, seed=seed"
            parts = [f"extract(in=gaborfractalfield{dim}({given}), index={index})" for index in range(1 + int(dim[0]))]
            self.assertEqual(graphs.pop(f"gaborfractal{dim}"), [parts[0], combined(parts[1:])])
        self.assertEqual(set(defined), {f"ND_{name}" for name in (*every, "gaborfield2d", "gaborfield3d", "gaborfractalfield2d", "gaborfractalfield3d", "gaborseed")})
        self.assertEqual(set(graphs), {"gaborbrushedmetal", "gaborstripes2d"})
        values = [re.sub(r"\b(\w+)=(?!=)", "", value) for graph in graphs.values() for value in graph]
        values = [re.sub(r"(?<= )([\d.]+, [\d.]+)(?=\))", r"Value{\1}", re.sub(r"constant\((.*?)\)", r"Value{\1}", value)) for value in values]
        expected = ["metal.colour", "metal.height", "stripes.x", "stripes.y", "stripes.z"]
        made, wanted = np.split(in_cpp(self.folder, GRAPHS, [f"parts({each}, {i})" for each in (*values, *expected) for i in range(3)], "-std=c++17",
                                       "-O1", "-DGABOR_INLINE=inline", "-I", SHADERS / "translations", rows=32, code="""
            const Value texcoord{p.x, p.y};
            const float frequency = 3.0f, orientation = 30.0f, sharpness = 1.5f;
            const int seed = -7;
            const GaborMaterial metal = gabor_brushed_metal(p, std::uint32_t(seed));
            const gabor_vec3 stripes = gabor_stripes(p, gabor_wave_vector(3.0f, 0.5235988f), 1.5f, std::uint32_t(seed));"""), 2)
        for one, other in zip(made, wanted):
            np.testing.assert_allclose(one, other, rtol=0, atol=1e-5 * max(1, other.std()))

    def test_fractals_of_three(self):
        if not shutil.which("node"):
            self.skipTest("node is not installed")
        source = (NODES / "three" / "gabor_noise.tsl.js").read_text()
        (self.folder / "gabor_noise.mjs").write_text(source.replace('"three/tsl"', '"./three_tsl.mjs"'))
        (self.folder / "three_tsl.mjs").write_text((HERE / "three_tsl.mjs").read_text())
        (self.folder / "scene.mjs").write_text(TSL_FRACTALS.replace("FRACTALS", json.dumps(FRACTALS)))
        said = subprocess.run(["node", self.folder / "scene.mjs", self.folder / "values.raw"], check=True, stdout=subprocess.PIPE, text=True).stdout
        names, code = json.loads(said), CPP_FRACTALS
        made = np.fromfile(self.folder / "values.raw", "<f4").reshape(len(names), 4, 256)
        shown = {"smooth": "gabor_smooth(p, 3)", "perlin": "gabor_perlin(p, 3)", "perlin_3d": "gabor_perlin_3d(solid, 3)",
                 "fbm": "gabor_fbm(p, 4.5f, 0.6f, 3)", "fbm_3d": "gabor_fbm_3d(solid, 4.5f, 0.6f, 3)", "billow": "gabor_billow(p, 4.5f, 0.6f, 3)",
                 "ridged": "gabor_ridged(p, 4.5f, 0.6f, 3)", "uniform": "gabor_uniform(2.0f * gabor_smooth(p, 3))"}
        for index, (octaves, lacunarity, gain, shape, basis, seed) in enumerate(FRACTALS):
            given = f"kind{index}, std::uint32_t({seed})"
            code += f"""
                const GaborFractal kind{index} = {{{octaves}f, {gain}f, {lacunarity}f, 0.64350111f, {basis}, {shape}}};
                const auto flat{index} = gabor_fractal_noise(gabor_place_at(p), {given});
                const auto solid{index} = gabor_fractal_noise_3d(gabor_place_3d_at(solid), {given});
                const auto flat_filtered{index} = gabor_fractal_noise_filtered(gabor_place_at(p), dx, dy, {given});
                const auto solid_filtered{index} = gabor_fractal_noise_3d_filtered(gabor_place_3d_at(solid), solid_dx, solid_dy, {given});
                const auto tiled{index} = gabor_fractal_noise(place, {given});
                const auto moved{index} = gabor_warp(gabor_place_at(p), 0.2f, {given});
                const auto warp{index} = gabor_fractal_noise(moved{index}.place, gabor_fractal(1.0f, 0.0f), 7);"""
        code += "const auto tiled_warp = gabor_fractal_noise(gabor_warp(place, 0.2f, gabor_fractal(2.0f, 0.5f), 5).place, gabor_fractal(1.0f, 0.0f), 7);\n"
        for name in names[len(shown):]:
            of, _, part = name.partition(".")
            shown[name] = name.replace("warp", "moved").replace(" ", ".") if " " in name else f"{of}.gradient.{part}" if part else f"{of}.noise"
        self.assertEqual(list(shown), names)
        expected = in_cpp(self.folder, '#include "gabor_fractal.hpp"\n', shown.values(), "-std=c++17", "-O1", "-DGABOR_INLINE=inline", "-I",
                          SHADERS / "translations", rows=4, code=code)
        self.compare_fractals(names, made, expected, lambda name: (found := re.match(r"(?!warp\d\.)\w+(\d)[. ]", name)) and FRACTALS[int(found[1])][3] > 0)

    def test_nodes_of_three(self):
        if not shutil.which("node"):
            self.skipTest("node is not installed")
        source = (NODES / "three" / "gabor_noise.tsl.js").read_text()
        source_types = (NODES / "three" / "gabor_noise.tsl.d.ts").read_text()
        functions = HERE.parent / "engines" / "tsl" / "functions.mjs"
        for name, text in {"functions.mjs": functions.read_text(), "three_tsl.mjs": (HERE / "three_tsl.mjs").read_text(), "scene.mjs": TSL,
                           "gabor_noise.mjs": source.replace('"three/tsl"', '"./three_tsl.mjs"')}.items():
            (self.folder / name).write_text(text)
        values = self.folder / "values.raw"
        said = subprocess.run(["node", self.folder / "scene.mjs", values], check=True, stdout=subprocess.PIPE, text=True).stdout
        names = json.loads(said)
        pictures = np.split(np.fromfile(values, "<f4"), len(names))
        for name, picture in list(zip(names, pictures))[:-17]:
            with self.subTest(name):
                self.compare(name, picture)
        headers = "".join(f'#include "gabor_{name}.hpp"\n' for name in ("noise", "spectrum", "filter", "materials"))
        expected = in_cpp(self.folder, headers, [
            "wave.x", "wave.y", "gabor_unorm(gabor_noise(p,2.5f,0.6f,gabor_derived_seed(std::uint32_t(-9),3)))", "metal.colour.x", "metal.colour.y",
            "metal.colour.z", "metal.height", "metal.slope.x", "metal.slope.y", "metal.roughness", "metal.metalness"], "-std=c++17", "-O1",
            "-DGABOR_INLINE=inline", "-I", SHADERS / "translations", rows=32, code="""
            const gabor_vec2 wave = gabor_noise_quadrature(p, -2.5f, 0.6f, std::uint32_t(-9));
            const GaborMaterial metal = gabor_brushed_metal(p, 7u);""")
        self.assertEqual(names[-16:-5], "complex.x complex.y unorm colour.x colour.y colour.z height tilt.x tilt.y roughness metalness".split())
        for name, one, other in zip(names[-16:-5], pictures[-16:-5], expected):
            with self.subTest(name):
                np.testing.assert_allclose(one.reshape(32, 256), other, rtol=0, atol=2e-5)
        y, x = (np.mgrid[0:32, 0:256] + 0.5) / 32
        self.assertLess(np.abs(pictures[-17].reshape(32, 256) - reference.complex_lattice_3d(x, y, 0.3, (1, 2, 3)).imag).max(), 1e-5)
        declared = re.findall(r"(?s)export function (\w+)\((.*?)\):", source_types)
        defined = re.findall(r"(?m)^export const (\w+) = \(?(.*?)\)? =>", source)
        self.assertEqual(dict((name, re.sub(r"\??: [\w<>]+", "", given)) for name, given in declared),
                         dict((name, given.replace(" = {}", "")) for name, given in defined))
        called = set(re.findall(r"\bgabor\.(gabor_\w+)", functions.read_text() + TSL + TSL_FRACTALS))
        self.assertEqual(set(re.findall(r"(?m)^export const (gabor_\w+)", source)) - called, {"gabor_stripes_of"})
        # The surface shows two kernel radii per unit, and p grows downwards.
        normal, slope = np.array(pictures[-5:-2], float), 0.05 * 2 * np.array(pictures[-2:], float)
        wanted = np.array([-slope[0], slope[1], np.ones_like(slope[0])]) / np.sqrt(1 + (slope**2).sum(0))
        self.assertLess(np.abs(normal - wanted).max(), 1e-4)
        self.assertGreater(normal[1].std(), 0.1)


if __name__ == "__main__":
    unittest.main()
