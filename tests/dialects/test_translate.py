"""Checks what tools/translate makes of short pieces of GLSL: each is translated, and the result returns the value that GLSL's
rules give, or is refused in one line with its file and line. Nothing in between."""

import importlib.machinery
import importlib.util
import itertools
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import metal
import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
COMPILER = os.environ.get("CXX", "c++")
DAWN, SWIFTSHADER = HERE.parent / "engines" / "dawn", pathlib.Path("/usr/lib/chromium/vk_swiftshader_icd.json")
SCENE = pathlib.Path(os.environ.get("GABOR_SCENES", "nowhere")) / "scene_vulkan"  # runs SPIR-V
LANGUAGES = ["hlsl", "metal", "hpp", "wgsl", "gdshaderinc"]

sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "tools"))
loader = importlib.machinery.SourceFileLoader("translate", str(ROOT / "tools" / "translate"))
translate = importlib.util.module_from_spec(importlib.util.spec_from_loader("translate", loader))
loader.exec_module(translate)
glsl = translate.glsl

# Each snippet: its name, its GLSL (a text without try_value is the body of that function), the value of try_value at x, and the
# languages that refuse it, with the reason, or None if only metal.py lacks it.
SNIPPETS = [
    ("a function on one line", "float try_f(float x) { return 2.0 * x; } float try_value(float x) { return try_f(x); }", lambda x: 2 * x),
    ("components of an array in a struct", "struct TryRow { vec4 node[2]; int count; }; float try_value(float x) { TryRow row; int i = 1;\n"
     "row.node[0] = vec4(1.0); row.node[1] = vec4(x, 2.0, x, 3.0); row.node[i].x -= row.node[0].y; row.node[i] *= vec4(row.node[i].xy, row.node[0].zw);\n"
     "return row.node[i].x + 10.0 * row.node[i].y + 100.0 * row.node[i].z; }", lambda x: (x - 1)**2 + 40 + 100 * x),
    ("an array", "float a[3]; for (int i = 0; i < 3; ++i) a[i] = x + float(i); return a[0] + a[1] * a[2];", lambda x: x + (x + 1) * (x + 2)),
    ("a struct on one line", "struct TryPair { float a; vec2 b; }; float try_f(TryPair pair) { return pair.a + pair.b.y; }\n"
     "float try_value(float x) { return try_f(TryPair(x, vec2(3.0))); }", lambda x: x + 3),
    ("struct members with commas", "struct TryPair {\n    float a, b; // two\n    vec2 c;\n};\nfloat try_value(float x) {\n"
     "TryPair pair = TryPair(x, 2.0, vec2(x)), other = pair; other.a += 1.0; return pair.a + pair.b * other.a + pair.c.y; }", lambda x: 4 * x + 2),
    ("a struct in a struct", "struct TryInner { vec2 v; };\nstruct TryOuter { TryInner inner; bool on; };\nfloat try_value(float x) {\n"
     "TryOuter o = TryOuter(TryInner(vec2(x, 2.0)), x > 0.0); o.inner.v = o.inner.v.yx; return o.on ? o.inner.v.x : o.inner.v.y; }", lambda x: 2 if x > 0 else x),
    ("macros", "#define TRY_HALF vec3(0.5)\n#define TRY_COUNT 3\n"
     "float try_value(float x) { return dot(x * TRY_HALF, vec3(float(TRY_COUNT))); }", lambda x: 4.5 * x),
    ("a declaration with commas", "float a = x, b = 2.0 * a, c; c = a + b; vec3 d = vec3(0.0), e = d; e.z = d.y = c; return d.y + 10.0 * e.z;", lambda x: 33 * x),
    ("a nested ternary", "return x < -1.0 ? x > -2.0 ? 1.0 : 2.0 : x < 1.0 ? 3.0 : 4.0;", lambda x: (1 if x > -2 else 2) if x < -1 else 3 if x < 1 else 4),
    ("loops without braces", "for (int i = 0; i < 3; ++i) for (int j = 0; j <= i; j++) if (i != j) x += float(10 * i + j); else x *= 2.0;\n"
     "int k = 5; while (k > 2) k -= 2; do x += float(k); while (++k < 3); return x;", lambda x: ((x * 2 + 10) * 2 + 20 + 21) * 2 + 1 + 2),
    ("global constants", "const float try_half = 0.5;\nconst int try_count = 2, try_next = try_count + 1;\nconst vec2 try_pair = vec2(1.0, try_half);\n"
     "const uint try_word = 0x10u; // sixteen\nfloat try_value(float x) {\n"
     "float a[try_next]; a[try_count] = x * try_half; return a[2] + try_pair.y + float(try_word); }", lambda x: 0.5 * x + 16.5),
    ("inout of a struct", "struct TryPair { float a; vec2 b; };\nvoid try_f(inout TryPair pair, out vec2 old) { old = pair.b; pair.b.x += 1.0; pair.a = 2.0; }\n"
     "float try_value(float x) { TryPair pair = TryPair(x, vec2(x)); vec2 old; try_f(pair, old); return pair.a + pair.b.x + 10.0 * old.x; }", lambda x: 2 + x + 1 + 10 * x),
    ("parameters that change", "float try_f(float x, in vec2 v, const float k) { x += k; v *= x; return v.x + v.y; }\n"
     "float try_value(float x) { return try_f(x, vec2(x, 1.0), 2.0) + x; }", lambda x: (x + 2) * (x + 1) + x),
    ("a change in one expression", "float try_f(inout float f) { f += 1.0; return 2.0 * f; }\n"
     "float try_value(float x) { float a = x, b = 3.0 * try_f(x) + a; return x + b; }", lambda x: x + 1 + 6 * (x + 1) + x),
    ("a name in two scopes", "float t = 1.0; { vec2 t = vec2(5.0); x += t.y; } { float t = 2.0; x += t; } return x + t;", lambda x: x + 8),
    ("reserved words of other languages", "struct TryPair { float device; float register; };\n"
     "float try_f(float line, float of) { float point = line + of; return point; }\n"
     "float try_value(float thread) { TryPair pair = TryPair(thread, 2.0); return try_f(pair.device, pair.register); }", lambda x: x + 2),
    ("directives within statements", "\n#ifdef TRY_NEVER\n    if (x > 0.0)\n        x = 7.0;\n    else\n#endif\n        x += 1.0;\n"
     "    return x\n#ifdef TRY_NEVER\n        + 100.0\n#endif\n        ; // end\n", lambda x: x + 1),
    ("comments", "/* a block\n   comment */ float try_value(float x /* it's */) { // vec2's \"quote\n    return x; /* float try_g() { */ }", lambda x: x),
    ("names of kinds of token", "float comment = x, directive = 2.0 * comment; return comment + directive;", lambda x: 3 * x),
    ("numbers", "return 1e1 + .5 + 2. * x + 1.5e-3 * 1.0E3 + 1.0e-7 * 1.0e7 + float(0xffu - 250u) + float(7 / 2);", lambda x: 21 + 2 * x),
    ("a long call", "return clamp(mix(x,\n          2.0 * (x + 1.0), // twice\n          0.5),\n    -1.0, 3.0);", lambda x: min(max((x + 2 * (x + 1)) / 2, -1), 3)),
    ("atan and pow", "return atan(x) + atan(x, -1.0) + pow(2.0, x);", lambda x: math.atan(x) + math.atan2(x, -1) + 2**x),
    ("integers", "int i = int(floor(x));\nuint u = uint(i + 8);\nivec2 v = max(ivec2(abs(i), i), ivec2(1)) % ivec2(3);\n"
     "u ^= (u << 3u) | (u >> 1u) & ~2u;\nreturn float(clamp(i, -2, 2)) + float(u % 7u) + float(v.x * 100 + v.y);",
     lambda x: (lambda i, u: min(max(i, -2), 2) + (u ^ (u << 3 | u >> 1 & ~2)) % 7 + max(abs(i), 1) % 3 * 100 + max(i, 1) % 3)(
         math.floor(x), math.floor(x) + 8)),
    ("the rest of a vector by a number", "ivec2 v = ivec2(floor(vec2(x + 8.0))) % 3; return float(v.x);", lambda x: math.floor(x + 8) % 3),
    ("bits of a vector and a number", "ivec2 v = ivec2(floor(vec2(x + 8.0))) & 3; return float(v.x);", lambda x: math.floor(x + 8) & 3),
    ("bits of a vector", "return uintBitsToFloat(uvec2(1065353216u, 1073741824u)).y * x;", lambda x: 2 * x),
    ("functions of vectors", "vec3 v = vec3(vec2(sign(x), 2.0).xx, x < 0.0 ? -1.0 : 1.0);\nreturn dot(v.yy, vec2(1.0)) + length(vec4(v, 1.0)) + distance(v.xy, vec2(2.0));",
     lambda x: 2 * math.copysign(1, x) + 2 + math.sqrt(2) * (2 - math.copysign(1, x))),
    ("constructors", "vec4 v = vec4(x, vec2(1.0, 2.0), 3.0); return dot(v, vec4(1.0, 2.0, vec2(3.0))) + vec3(x, v.yz).z + float(uint(true));", lambda x: x + 2 + 6 + 9 + 2 + 1),
    ("four components", "return vec4(x, 1.0, 2.0, 3.0).wzyx.w;", lambda x: x, {"hpp": ":1: .wzyx, which", "metal": None}),
]
# What WGSL writes differently and no drop-in has, with its value or the reason of the refusal.
WGSL = [
    ("numbers beside vectors in functions", "vec3 v = min(max(vec3(x, 2.0, -1.0), 0.0), 1.5);\n"
     "return v.x + 10.0 * clamp(v, 0.25, 1.0).y + mix(v, vec3(4.0), 0.5).z + smoothstep(-4.0, 4.0, vec2(x)).x + step(0.5, vec2(x)).y;",
     lambda x: min(max(x, 0), 1.5) + 12 + (lambda t: t * t * (3 - 2 * t))((x + 4) / 8) + (x >= 0.5)),
    ("whole numbers beside vectors", "ivec2 v = max(clamp(ivec2(int(floor(x)), 3), -2, 2), -1); return float(v.x + 10 * v.y);",
     lambda x: max(min(max(math.floor(x), -2), 2), -1) + 20),
    ("a choice of vectors", "vec2 v = x > 0.0 ? vec2(x) : vec2(1.0, 2.0); return v.x + 10.0 * v.y;", lambda x: 11 * x if x > 0 else 21),
    ("a choice that guards a division", "int n = int(floor(x)); return float(n == 0 ? 7 : 12 / n);", lambda x: 7 if 0 <= x < 1 else int(12 / math.floor(x))),
    ("a choice over lines", "return x < 0.0 ? -1.0 // below\n                : x > 2.0\n                ? 1.0 /* above */ : 0.0;",
     lambda x: -1 if x < 0 else 1 if x > 2 else 0),
    ("continue before a test at the end", "int i = 0; do { ++i; if (i == 4) continue; x += float(i); } while (i < 4); return x;", lambda x: x + 6),
    ("-- in a test at the end", "int k = 4; do x += 1.0; while (--k > 0); return x;", lambda x: x + 4),
    ("a loop without parts", "int i = 0; for (;;) { if (i == 3) break; i++; } while (i < 9) { i += 2; } return x + float(i);", lambda x: x + 9),
    ("else after two conditions", "if (x > 0.0) if (x > 1.0) return 3.0; else return 2.0; return 1.0;", lambda x: 3 if x > 1 else 2 if x > 0 else 1),
    ("else over lines", "\nif (x > 1.0) // large\n    x = 1.0;\nelse if (x > 0.0)\n    x = 2.0;\nelse // small\n    for (int i = 0; i < 2; ++i)\n        x = 3.0 - x;\nreturn x;",
     lambda x: 1 if x > 1 else 2 if x > 0 else x),
    ("loops with variables of one name", "for (int i = 0; i < 2; ++i) x += 1.0; for (uint i = 0u; i < 3u; i++) x += float(i); return x;", lambda x: x + 5),
    ("a variable that starts as the one it hides", "float t = x; { float t = t + 1.0; x += t; } return x + t;", lambda x: 3 * x + 1),
    ("signs", "return +x - -x + -(-x) - - x;", lambda x: 4 * x),
    ("a negative unsigned number", "uint u = 3u; uvec2 v = -uvec2(u, 5u); return x + float(-u >> 30u) + float(v.y >> 29u);", lambda x: x + 3 + 7),
    ("shifts by signed numbers", "int n = 2; uvec2 v = uvec2(5u, 9u) << n; ivec2 w = ivec2(-16, 16) >> 2;\n"
     "return x + float(v.x + v.y) + float(w.x + w.y * 10) + float(ivec2(n) << ivec2(1, n) >> 1);".replace("float(ivec2(n) << ivec2(1, n) >> 1)", "float((ivec2(n) << ivec2(1, n) >> 1).y)"),
     lambda x: x + 56 + 36 + 4),
    ("bits without parentheses", "int a = 12, b = 10; return x + float(a & b | a ^ b + 1) + float(a + b << 1 & 63) + float(a & b & 9);", lambda x: x + 15 + 44 + 8),
    ("&& beside ||", "bool a = x > 0.0, b = x > 1.0, c = x < 2.0; return a && b || c && !a ? 1.0 : 2.0;", lambda x: 1 if x > 1 or x < 0 else 2),
    ("comparisons of comparisons", "return x > 0.0 == x > -1.0 ? 1.0 : 2.0;", lambda x: 2 if -1 < x < 0 else 1),
    ("bits with an assignment", "uvec2 v = uvec2(12u, 10u); v &= 6u; v <<= 1; v ^= uvec2(1u, 2u); int k = 7; k %= 4; k |= 8;\n"
     "return x + float(v.x + 100u * v.y) + float(k);", lambda x: x + 609 + 11),
    ("constructors that convert", "int i = 3; vec3 v = vec3(i, x, true); ivec2 w = ivec2(2.75, -2.75); uvec2 u = uvec2(i, 7);\n"
     "return v.x + v.y + v.z + float(w.x * 10 + w.y) + float(u.x + u.y) + float(bool(i)) + vec2(i).y;", lambda x: x + 3 + 1 + 18 + 10 + 1 + 3),
    ("32 bits", "uint u = uint(-1); int i = 0xffffffff; return x + float(u >> 28u) + float(i) + (2147483647 + 1 < 0 ? 5.0 : 6.0) + float(uvec2(-1, 1).x >> 31u);",
     lambda x: x + 15 - 1 + 5 + 1),
    ("kinds of numbers", "return x + float(010 + 0X1F) + 1.F + 2.0f + float(017u - 0xAU);", lambda x: x + 8 + 31 + 3 + 5),
    ("a constant as a length", "const int n = 3; float a[n + 1]; for (int i = 0; i < n; ++i) a[i] = x * float(i); return a[n - 1];", lambda x: 2 * x),
    ("an element of a parameter", "struct TryRow { float node[3]; vec3 v; };\nfloat try_f(TryRow row, int i) { return row.node[i] + row.v[i]; }\n"
     "float try_value(float x) { TryRow row; row.node[2] = x; row.v = vec3(0.0, 1.0, 2.0); int i = 2; row.v[i] += 1.0; return try_f(row, i); }", lambda x: x + 3),
    ("a name that a changed parameter would get", "float try_f(float v, float v_in) { v += v_in; return v; }\nfloat try_value(float x) { return try_f(x, 2.0); }", lambda x: x + 2),
    ("names of WGSL's", "struct TryPair { float array; float ptr; };\nfloat try_f(float let, inout float fn) { fn += let; return fn; }\n"
     "float try_value(float x) { float select = x > 0.0 ? 1.0 : 2.0, f32 = 3.0; vec2 vec2f = max(vec2(x, f32), 0.5);\n"
     "TryPair loop = TryPair(vec2f.y, 4.0); loop.ptr += try_f(select, f32); return loop.array + loop.ptr + f32; }", lambda x: 3 + 4 + 2 * (3 + (1 if x > 0 else 2))),
    ("out arguments that are parameters", "void try_add(inout float a, out vec2 b) { a += 1.0; b = vec2(a); b.x *= 2.0; }\n"
     "void try_more(inout float a, out vec2 b) { try_add(a, b); try_add(a, b); b.y = -b.y; }\n"
     "float try_value(float x) { vec2 v; try_more(x, v); return x + v.x + 10.0 * v.y; }", lambda x: -7 * (x + 2)),
    ("an element of an inout struct", "struct TryRow { float node[3]; int count; };\nvoid try_f(inout TryRow row, int i) { row.node[i] = 2.0 * row.node[i]; row.count++; --row.count; row.count += 2; }\n"
     "float try_value(float x) { TryRow row; row.count = 1; row.node[1] = x; try_f(row, 1); return row.node[1] + float(row.count); }", lambda x: 2 * x + 3),
    ("a result that nobody takes", "float try_f(inout float f) { f *= 2.0; return f; }\nfloat try_value(float x) { try_f(x); max(x, 1.0); return x; }", lambda x: 2 * x),
    ("a sum within a chain", "float a = 1.0, b = 2.0; a += b = x; float c = b = 3.0; return a + 10.0 * b + c;", lambda x: 1 + x + 33),
    ("macros of macros", "#define TRY_BASE (1 << 4)\n#define TRY_MASK (TRY_BASE - 1)\n#define TRY_NONE\n"
     "TRY_NONE float try_value(float x) { return float((int(floor(x)) + 24) & TRY_MASK); }", lambda x: math.floor(x) + 24 & 15),
    ("conditions", "#define TRY_KIND 2 // of three\n#if TRY_KIND == 1\nfloat try_f(float x) { return 1.0; }\n#elif TRY_KIND == (TRY_KIND & 3) && !defined(TRY_NEVER)\n"
     "float try_f(float x) {\n#if TRY_KIND != 2\n    x = 7.0;\n#else\n    x += 2.0;\n#endif\n    return x; }\n#else\n#error none\n#endif\n"
     "#if TRY_KIND < 1 || TRY_KIND > 3\n#error TRY_KIND must be 1 to 3\n#endif\nfloat try_value(float x) { return try_f(x); }", lambda x: x + 2),
    ("vectors in atan and components of components", "void try_f(inout vec3 v) { v.x = v.zy.x + v.y; v = v.zyx; }\n"
     "float try_value(float x) { vec3 v = vec3(x, 1.0, 2.0); try_f(v); return atan(vec2(x, 1.0), vec2(1.0, 2.0)).x + v.z; }", lambda x: math.atan(x) + 3),
    ("NaN in a test at the end", "float f = x, zero = x - x; do { f += 1.0; } while (f < zero / zero); return f;", lambda x: x + 1),
    ("++ within an expression", "int i = 0;\nreturn x + float(i++);", r":2: \+\+ within an expression"),
    ("an assignment within an expression", "\nreturn (x = 3.0) + 1.0;", ":2: '=' has no translation"),
    ("an assignment that is returned", "\nreturn x = 3.0;", ":2: = within an expression"),
    ("++ after a test", "int k = 0; while (k++ < 3) x += 1.0; return x;", r":1: \+\+ within an expression"),
    ("a macro without parentheses", "\n#define TRY_SUM 1.0 + 2.0\nfloat try_value(float x) { return x * TRY_SUM; }", r":2: \w+, a macro that is no constant in parentheses,"),
    ("a loop with two variables", "for (int i = 0, j = 3; i < j; ++i) x += 1.0; return x;", ":1: a loop with several variables"),
    ("a number that is too large", "return x * 1.0e39;", ":1: 1.0e39, more than a float holds,"),
    ("a division by 0", "\nreturn x + float(int(x) / 0);", ":2: a division by 0"),
    ("a constant divided by 0", "return x + 1.0 / 0.0;", ":1: a division of a constant by 0"),
    ("a constant beyond 32 bits", "return x + float(1 << 31);", ":1: a constant beyond 32 bits"),
    ("a shift by all bits", "uint u = 1u; return x + float(u << 32u);", ":1: << by 32"),
    ("#define within a function", "\n#define TRY_ONE 1.0\nreturn x * TRY_ONE;", ":2: #define within a function"),
    ("other directives", "#pragma optionNV(unroll all)\nfloat try_value(float x) { return x; }", ":1: #pragma has no translation"),
    ("an error", "\n#ifndef TRY_NEVER\n#error Define TRY_NEVER\n#endif\nfloat try_value(float x) { return x; }", r":3: Define \w+"),
    ("an unknown macro in a condition", "#if TRY_NEVER > 2\n#endif\nfloat try_value(float x) { return x; }", r":1: #if \w+ > 2 has no translation"),
    ("a call within a constant", "float try_f() { return 1.0; }\nconst float try_one = try_f();\nfloat try_value(float x) { return x * try_one; }", ":2: a call within a constant"),
    ("a reserved name beside its substitute", "float let = x;\nfloat let_ = 1.0; return let + let_;", ":2: let_ beside let, which WGSL reserves,"),
]
# What all languages refuse: GLSL that is wrong, and GLSL that some language lacks.
REFUSED = [
    ("an implicit conversion", "\nfloat y = 1;\nreturn x + y;", ":2: int in the place of float"),
    ("a variable that is not there", "\n\nreturn y;", ":3: 'y' has no translation"),
    ("an argument of another type", "float try_f(vec2 v) { return v.x; }\nfloat try_value(float x) { return try_f(x); }", ":2: float in the place of vec2"),
    ("too few arguments", "float try_f(vec2 v, float k) { return v.x; }\nfloat try_value(float x) { return try_f(vec2(x)); }", r":2: \w+\(vec2\) has"),
    ("a function of whole numbers", "\nreturn sin(3);", r":2: sin\(int\)"),
    ("a sum of two types", "\nreturn x + 1;", r":2: float \+ int"),
    ("a sum of two sizes", "\nreturn (vec2(x) + vec3(x)).x;", r":2: vec2 \+ vec3"),
    ("a condition that is a number", "int i = 1;\nif (i) x += 1.0; return x;", ":2: int in the place of bool"),
    ("a choice of two types", "return (x > 0.0 ? x : vec2(x)).x;", ":1: vec2 in the place of float"),
    ("a result of another type", "int try_f(float x) { return x; }\nfloat try_value(float x) { return float(try_f(x)); }", ":1: float in the place of int"),
    ("a component that is not there", "\nreturn vec2(x).z;", ":2: .z of a vec2"),
    ("an index that is no whole number", "vec2 v = vec2(x);\nreturn v[1.0];", ":2: an index of type float"),
    ("a missing semicolon", "x += 1.0\nreturn x;", ":2: 'return' where ; should be"),
    ("an overload", "float try_f(float x) { return x; }\nfloat try_f(vec2 v) { return v.x; }\nfloat try_value(float x) { return try_f(x); }",
     r":2: a second \w+ with other parameters"),
    ("+= of two components", "vec3 v = vec3(x);\nv.xy += vec2(1.0, x);\nreturn v.x;", ":2: a change of 'v.xy'"),
    ("components of a member", "struct TryPair { vec2 v; };\nfloat try_value(float x) { TryPair o; o.v.yx = vec2(x); return o.v.x; }", ":2: a change of 'o.v.yx'"),
    ("vectors that are equal", "vec2 v = vec2(floor(x), 1.0);\nreturn v == vec2(2.0, 1.0) ? 5.0 : 6.0;", ":2: == of a vec2"),
    ("comparisons of components", "\nreturn any(lessThan(vec2(x), vec2(1.0))) ? 1.0 : 2.0;", ":2: lessThan"),
    ("a macro with arguments", "\n#define TRY_TWICE(x) (2.0 * (x))\nfloat try_value(float x) { return TRY_TWICE(x + 1.0); }", r":2: \w+, a macro with arguments,"),
    ("precision", "precision mediump float;\nfloat try_value(float x) { return x; }", ":1: 'precision'"),
    ("a prototype", "float try_f(float x);\nfloat try_value(float x) { return try_f(x); }\nfloat try_f(float x) { return x * x; }", ":1: ';' where { should be"),
    ("an array constructor", "\nfloat a[2] = float[2](x, 1.0);\nreturn a[0];", ":2: 'float'"),
    ("a macro that is no expression", "#define TRY_LOOP for (int i = 0; i < 3; ++i)\nfloat try_value(float x) { TRY_LOOP x += 1.0; return x; }", ":1: 'int'"),
    ("a switch", "\nswitch (int(x)) { case 1: return 1.0; default: break; }\nreturn 2.0;", ":2: switch"),
    ("discard", "discard; return x;", ":1: 'discard'"),
    ("components as an out argument", "void try_f(out vec2 v) { v = vec2(1.0); }\nfloat try_value(float x) { vec3 v = vec3(x);\n    try_f(v.xy);\n    return v.x; }",
     ":3: a change of 'v.xy'"),
    ("a member as an out argument", "struct TryPair { float a; };\nvoid try_f(inout float f) { f += 1.0; }\n"
     "float try_value(float x) { TryPair pair; try_f(pair.a); return pair.a; }", ":3: 'pair.a' as an out argument"),
    ("one variable for two out arguments", "void try_f(out float a, out float b) { a = 1.0; b = 2.0; }\nfloat try_value(float x) { try_f(x, x); return x; }",
     ":2: a use and a change of a variable"),
    ("two changes in one expression", "float try_f(inout float f) { f += 1.0; return f; }\nfloat try_value(float x) {\n    return try_f(x) - 2.0 * try_f(x);\n}",
     ":3: a use and a change of a variable"),
    ("a += within an index", "vec3 a[2]; a[0] = vec3(x); a[1] = a[0]; int i = 0; a[i++].xy += vec2(1.0); return a[0].x + float(i);", ":1: a change within a part"),
    ("a change that && may skip", "bool try_f(inout float f) { f += 1.0; return true; }\nfloat try_value(float x) { if (x > 0.0 && try_f(x)) x += 1.0; return x; }",
     ":2: a change within a part of an expression"),
    ("a change of a component of components", "vec3 v = vec3(x); v.xy.x = 1.0; return v.x;", ":1: a change of 'v.xy.x'"),
    ("++ of a float", "x++; return x;", r":1: \+\+ of a float"),
    ("a global variable", "float try_state;\nfloat try_value(float x) { return x; }", r":1: ';' where \( should be"),
    ("two types in two branches", "\n#ifdef TRY_NEVER\n    vec2 n = vec2(x);\n#else\n    float n = x;\n#endif\n    return n;\n", ":5: a second n with another type"),
    ("half a function in a branch", "#ifdef TRY_NEVER\nfloat try_value(vec2 x) {\n#else\nfloat try_value(float x) {\n#endif\n    return 1.0;\n}", ":4: "),
    ("a shorter vector", "\nvec3 v = vec3(x);\nreturn vec2(v).x;", r":3: vec2\(vec3\)"),
    ("two kinds of number in a vector", "return vec3(ivec2(1), x).z;", r":1: vec3\(ivec2, float\)"),
    ("mod", "return mod(x, 2.0);", ":1: mod"),
    ("a matrix", "mat2 m; return x;", ":1: 'mat2'"),
    ("a uniform", "uniform float try_scale;\nfloat try_value(float x) { return x * try_scale; }", ":1: 'uniform'"),
    ("a mix of booleans", "return mix(vec2(x), vec2(1.0), bvec2(true)).x;", ":1: bvec2"),
    ("structs that are equal", "struct TryPair { float a; };\nfloat try_value(float x) { return TryPair(x) == TryPair(1.0) ? 1.0 : 2.0; }", ":2: == of structs"),
    ("structs from a ternary", "struct TryPair { float a; };\nfloat try_value(float x) { return (x > 0.0 ? TryPair(x) : TryPair(1.0)).a; }", r":2: \? of structs"),
    ("a copy of an array", "float a[2], b[2]; a[0] = x; a[1] = x; b = a; return b[0];", ":1: a whole array"),
    ("an array as a parameter", "float try_f(float a[2]) { return a[0]; }\nfloat try_value(float x) { float a[2]; return try_f(a); }", ":1: an array as a parameter"),
]


def snippet(text, number):
    """Returns a whole text, with a number in its names so that all snippets fit into one program."""
    text = text if "try_value" in text else f"float try_value(float x) {{ {text} }}"
    return re.sub(r"\b(try|Try|TRY)(?=[_A-Z])", rf"\g<1>{number}", text)


def snippets(ending):
    """Yields the number of each snippet for a language, and the rest. Those of WGSL are also tried as GLSL."""
    yield from ((number, *each) for number, each in enumerate(SNIPPETS))
    if ending in ("wgsl", "comp"):
        yield from ((number, *each) for number, each in enumerate(WGSL, 200) if callable(each[2]))


class Snippets(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="gabor-")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.x = (np.arange(256) + 0.5) / 32 - 4

    def translated(self, number, text, ending):
        """Returns a snippet's translation without the header, or the reason of the refusal."""
        name = f"snippet{number}"
        path = self.folder / f"{name}.glsl"
        path.write_text(snippet(text, number))
        try:
            return translate.LANGUAGES[ending][2](translate.wgsl.shader(path) if ending == "wgsl" else translate.shader(path)).text(), None
        except translate.glsl.Refused as refused:
            return None, str(refused)

    def accepted(self, ending):
        """Yields the number, translation and function of each snippet that a language has, and checks refusals of others."""
        for number, name, text, wanted, *exceptions in snippets(ending):
            with self.subTest(name):
                made, refused = self.translated(number, text, ending)
                reason = exceptions[0].get(ending, "") if exceptions else ""
                if reason:
                    self.assertIsNone(made, f"{name} is translated")
                    self.assertRegex(refused, rf"snippet{number}\.glsl{reason.replace('try', f'try{number}')}[^\n]*$")
                else:
                    self.assertIsNone(refused)
                    if reason is not None:
                        yield number, made, wanted

    def test_refused(self):
        for number, (name, text, reason) in enumerate(REFUSED, 100):
            with self.subTest(name):
                made, refused = self.translated(number, text, "hlsl")
                self.assertIsNone(made, f"{name} is translated")
                self.assertRegex(refused, rf"snippet{number}\.glsl{reason}[^\n]*$")

    def test_refused_by_wgsl(self):
        for number, (name, text, reason) in enumerate(WGSL, 200):
            if not callable(reason):
                with self.subTest(name):
                    made, refused = self.translated(number, text, "wgsl")
                    self.assertIsNone(made, f"{name} is translated")
                    self.assertRegex(refused, rf"snippet{number}\.glsl{reason}[^\n]*$")

    def check(self, values, accepted):
        for row, (number, _, wanted) in zip(values, accepted, strict=True):
            with self.subTest((WGSL[number - 200] if number >= 200 else SNIPPETS[number])[0]):
                np.testing.assert_allclose(row, [wanted(x) for x in self.x], rtol=1e-5, atol=2e-5)

    def test_cpp(self):
        accepted = list(self.accepted("hpp"))
        text = '#include "gabor_vectors.hpp"\n' + "\n".join(made for _, made, _ in accepted)
        self.check(self.run_cpp(text, accepted, "-std=c++11", "-I", translate.TRANSLATIONS), accepted)

    def test_metal(self):
        accepted = list(self.accepted("metal"))
        text = "#include <metal_stdlib>\nusing namespace metal;\n" + "\n".join(made for _, made, _ in accepted)
        self.check(self.run_cpp(metal.as_cpp(text), accepted, *metal.options(COMPILER)), accepted)

    def run_cpp(self, text, accepted, *options):
        calls = ", ".join(f"try{number}_value" for number, *_ in accepted)
        text += f"""
#include <cstdio>
int main() {{
    float (*const calls[])(float) = {{{calls}}};
    for (auto call : calls)
        for (int i = 0; i < 256; ++i)
            std::printf("%.9g\\n", double(call((float(i) + 0.5f) / 32.0f - 4.0f)));
}}
"""
        program = self.folder / "program"
        said = subprocess.run([COMPILER, "-Wall", "-Wextra", "-Werror", "-O0", "-Dalways_inline=unused", "-Wno-attributes", "-Wno-unused", "-Wno-parentheses", *options,
                               "-x", "c++", "-", "-o", program], input=text, capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said.stderr)
        values = subprocess.run([program], capture_output=True, text=True, check=True).stdout
        return np.array(values.split(), float).reshape(len(accepted), 256)

    def shader(self, ending, x, start, end):
        """Writes a compute shader with all snippets, and returns it with what they return."""
        accepted = list(self.accepted(ending)) if ending in LANGUAGES else [
            (number, snippet(text, number), wanted) for number, _, text, wanted, *_ in snippets(ending)]
        text = "\n".join([*(made for _, made, _ in accepted), start])
        text += "".join(f"    if (pixel.y == {row}u) {{ value = try{number}_value({x}); }}\n" for row, (number, *_) in enumerate(accepted))
        shader = self.folder / f"shader.{ending}"
        shader.write_text(text + end)
        return shader, accepted

    def run_spirv(self, ending, x, start, end, command):
        """Compiles a compute shader with all snippets, and runs it on the device, if there is one."""
        shader, accepted = self.shader(ending, x, start, end)
        spirv, values = shader.with_suffix(".spv"), shader.with_suffix(".raw")
        said = subprocess.run(["sh", "-c", command, shader, spirv], capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said.stdout + said.stderr)
        subprocess.run(["spirv-val", "--target-env", "vulkan1.1", spirv], check=True)
        if not SCENE.exists():
            self.skipTest("compiled, but not run: GABOR_SCENES is not set")
        subprocess.run([SCENE, str(len(accepted)), "1", spirv, values], check=True, stdout=subprocess.DEVNULL)
        self.check(np.fromfile(values, "<f4").reshape(-1, 256), accepted)

    def test_glsl(self):
        """The snippets themselves: their functions must be right."""
        self.run_spirv("comp", "(float(pixel.x) + 0.5) / 32.0 - 4.0", """
layout(local_size_x = 8) in;
layout(std430, binding = 0) writeonly buffer Values { float values[]; };
void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    float value = 0.0;
""", "    values[pixel.y * 256u + pixel.x] = value;\n}\n", '(echo "#version 450"; cat "$0") | glslangValidator --stdin -S comp -V -o "$1"')

    def test_hlsl(self):
        self.run_spirv("hlsl", "(float(pixel.x) + 0.5) / 32.0 - 4.0", """
RWStructuredBuffer<float> values : register(u0);
[numthreads(8, 1, 1)] void main(uint3 pixel : SV_DispatchThreadID) {
    float value = 0.0;
""", "    values[pixel.y * 256 + pixel.x] = value;\n}\n", 'glslangValidator -V -D -S comp -e main "$0" -o "$1"')

    WGSL_SHADER = "wgsl", "(f32(pixel.x) + 0.5) / 32.0 - 4.0", """
@group(0) @binding(0) var<storage, read_write> values: array<f32>;
@compute @workgroup_size(8) fn main(@builtin(global_invocation_id) pixel: vec3u) {
    var value = 0.0;
""", "    values[pixel.y * 256u + pixel.x] = value;\n}\n"

    @unittest.skipUnless((DAWN / "node_modules").exists() and SWIFTSHADER.exists(), "Dawn is not installed: tools/test-engines dawn installs it")
    def test_wgsl_by_tint(self):
        """Tint is stricter than naga about parentheses."""
        shader, accepted = self.shader(*self.WGSL_SHADER)
        values = shader.with_suffix(".raw")
        said = subprocess.run(["node", DAWN / "run.mjs", values, shader, str(len(accepted)), "1"], capture_output=True, text=True,
                              env=os.environ | {"VK_ICD_FILENAMES": str(SWIFTSHADER)})
        self.assertEqual(said.returncode, 0, said.stderr)
        self.check(np.fromfile(values, "<f4").reshape(-1, 256), accepted)

    @unittest.skipUnless(shutil.which("naga"), "naga is not installed")
    def test_wgsl_by_naga(self):
        self.run_spirv(*self.WGSL_SHADER, 'naga "$0" "$1" && spirv-opt -O "$1" -o "$1"')

    def test_godot(self):
        """Godot's language has everything that is translated, so only small numbers, the names of variables and numbers beside
        bits of vectors change."""
        for number, made, _ in self.accepted("gdshaderinc"):
            plain = re.sub(r"\bg_(?=\w)", "", made.replace("(1.0 / 1.0e7)", "1.0e-7"))
            self.assertEqual(plain, snippet(SNIPPETS[number][1], number).replace("& 3;", "& ivec2(3);"))
            nodes = [node for item in glsl.Shader(made, "made").items if item.kind == "function" for node in item.walk()]
            names = {node.name.text for node in nodes if node.kind in ("parameter", "variable")}
            self.assertEqual([name for name in names if not name.startswith("g_")], [])


class Functions(unittest.TestCase):
    def calls(self):
        """Returns GLSL with each function that is translated, for numbers, where GLSL ES has it, and vectors."""
        counts = {"clamp": 3, "mix": 3, "smoothstep": 3} | dict.fromkeys(["min", "max", "pow", "step", "dot", "distance", "cross", "reflect"], 2)
        lines = ["step(0.5, vec2(x)); smoothstep(0.0, 1.0, vec4(x)); mix(vec3(x), vec3(1.0), 0.5); atan(vec2(x), vec2(1.0)); sign(-2); abs(-1);",
                 "abs(ivec3(-1)); min(1, 2); min(uvec2(1u), uvec2(2u)); max(1u, 2u); clamp(1, 2, 3); clamp(ivec4(1), ivec4(0), ivec4(2));"]
        for name, size in itertools.product(glsl.FUNCTIONS, (1, 2, 3, 4)):
            kind = "uint" if name == "uintBitsToFloat" else "float"
            of_vectors = name in {*glsl.REDUCING, "normalize", "reflect"}
            if size == 3 or name != "cross" and (size > 1 or not of_vectors):
                given = [f"{glsl.TYPES[kind, size]}(x)"] * counts.get(name, 1)
                lines.append(f"{name}({', '.join(given)});")
            if name in ("min", "max", "clamp"):
                lines.append(f"{name}({glsl.TYPES['float', size]}(x){', 1.0' * (counts[name] - 1)});")
        self.assertGreater(len(lines), 100)
        return "void gabor_all(float x) {" + "\n".join(lines) + "}\n"

    def test_cpp_has_each_function_for_each_size(self):
        tree = glsl.Shader(self.calls(), "all.glsl")
        said = subprocess.run([COMPILER, "-std=c++11", "-fsyntax-only", "-Wno-unused", "-I", translate.TRANSLATIONS, "-x", "c++", "-"],
                              input='#include "gabor_vectors.hpp"\n' + translate.Cpp(tree).text(), capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said.stderr)

    @unittest.skipUnless(shutil.which("naga"), "naga is not installed")
    def test_wgsl_has_each_function_for_each_size(self):
        with tempfile.TemporaryDirectory(prefix="gabor-") as folder:
            path, made = (pathlib.Path(folder) / f"all.{ending}" for ending in ("glsl", "wgsl"))
            path.write_text(self.calls())
            made.write_text(translate.translation(path, "wgsl"))
            said = subprocess.run(["naga", made], capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said.stderr)


class Nodes(unittest.TestCase):
    def test_osl_and_mdl_refuse_what_they_lack(self):
        for body in ("return vec2(x);", "vec4 v = vec4(x, x, x, x); return v.xy;", "return vec2(fract(x), x);", "return vec2(vec3(x, x, x).yz);", "x += 1.0;"):
            tree = glsl.Shader(f"vec2 mx_f(float x)\n{{\n    {body}\n}}\n", "mx.glsl")
            for printer in (translate.nodes.Osl, translate.nodes.Mdl):
                with self.subTest(body, printer=printer), self.assertRaisesRegex(glsl.Refused, "mx.glsl:[13]: .*to OSL or MDL, has no translation"):
                    printer(tree)


class Program(unittest.TestCase):
    def run_program(self, *arguments):
        said = subprocess.run([sys.executable, "-B", ROOT / "tools" / "translate", *arguments], capture_output=True, text=True)
        return said.returncode, said.stderr

    def test_refusal(self):
        """A refusal is one line with the file and line, and exit status 1; bad arguments have status 2."""
        with tempfile.TemporaryDirectory(prefix="gabor-") as folder:
            path = pathlib.Path(folder) / "sea.glsl"
            path.write_text("// sea.glsl: sea. Paste it after gabor_noise.glsl.\n#define SEA_GLSL\nfloat sea(vec2 p) {\n    return mod(p.x, 2.0);\n}\n")
            self.assertEqual(self.run_program(path), (1, f"translate: {path}:4: mod has no translation\n"))
            self.assertEqual(self.run_program(path.with_name("lake.glsl"))[0], 2)
        self.assertEqual(self.run_program("-DGABOR_LOBES=2")[0], 2)

    def test_every_function_is_in_every_language(self):
        """WGSL lacks only functions that call a function-like macro of the user."""
        lacking = []
        for path in translate.copies.DROP_INS:
            functions = {item.name.text for item in translate.shader(path).items if item.kind in ("function", "struct")}
            self.assertGreater(len(functions), 3)
            for ending in LANGUAGES:
                words = {token.text for token in glsl.tokens(translate.translation(path, ending))}
                lacking += [(ending, function) for function in sorted(functions - words)]
        self.assertEqual({ending for ending, _ in lacking}, {"wgsl"})
        self.assertTrue(all("direction" in function for _, function in lacking), lacking)

    def test_macros_of_others_do_no_harm(self):
        """Shaders and programs define such names before they include a file, as in #define time (iTime * 0.5)."""
        names = set("time near far PI TAU EPS resolution mouse uv rot map iTime iMouse iResolution".split())
        for path in [*translate.copies.DROP_INS, *translate.TRANSLATIONS.iterdir()]:
            self.assertEqual(names & set(re.findall(r"\w+", glsl.without_comments(path.read_text()))), set(), path.name)

    def test_macros_of_wgsl(self):
        """-D chooses code and constants, and a name that no file has is refused."""
        with tempfile.TemporaryDirectory(prefix="gabor-") as folder:
            def made(name, *macros):
                said = self.run_program("wgsl", ROOT / "shaders" / f"{name}.glsl", *macros, "-o", folder)
                return said if said[0] else (pathlib.Path(folder) / f"{name}.wgsl").read_text()
            two = made("gabor_noise", "-DGABOR_TAPS=2")
            self.assertIn("const GABOR_TAPS: i32 = 2;\n", two)
            self.assertIn("const_assert GABOR_TAPS == 2;\n", two)
            self.assertNotIn("you may edit", two)
            self.assertNotIn("1.0966099", two)
            self.assertIn("1.0966099", made("gabor_noise"))
            lobes = made("gabor_spectrum", "-DGABOR_LOBES=6")
            self.assertIn("// Constants that you may edit: GABOR_LOBES.\n", lobes)
            self.assertIn("const GABOR_LOBES: i32 = 6;\nconst_assert GABOR_LOBES >= 1; // GABOR_LOBES must be", lobes)
            self.assertEqual(made("gabor_filter", "-DGABOR_TAPS=2"), (1, "translate: shaders/gabor_filter.glsl:29: gabor_filter.glsl needs GABOR_TAPS 3\n"))
            self.assertEqual(made("gabor_noise", "-DGABOR_TAP=2"), (1, "translate: -DGABOR_TAP=2: no file has this macro\n"))
            self.assertEqual(self.run_program("hlsl", "-DGABOR_TAPS=2", "-o", folder)[0], 2)

    def test_wgsl_is_short(self):
        files = sorted(translate.TRANSLATIONS.glob("*.wgsl"))
        self.assertGreater(len(files), 10)
        for path in files:
            lines, original = (text.read_text().count("\n") for text in (path, translate.TRANSLATIONS.parent / f"{path.stem}.glsl"))
            self.assertLess(lines, 1.1 * original, path.name)

    def test_check_of_a_folder(self):
        """--check -o compares the files of another folder."""
        with tempfile.TemporaryDirectory(prefix="gabor-") as folder:
            self.assertEqual(self.run_program(ROOT / "shaders" / "gabor_noise.glsl", "-o", folder), (0, ""))
            (pathlib.Path(folder) / "gabor_noise.hlsl").write_text("old")
            said = subprocess.run([sys.executable, "-B", ROOT / "tools" / "translate", "--check", "-o", folder, ROOT / "shaders" / "gabor_noise.glsl"],
                                  capture_output=True, text=True)
        self.assertEqual((said.returncode, said.stderr, re.findall(r"(\S+): not current", said.stdout)), (1, "", ["gabor_noise.hlsl"]))
        self.assertIn("gabor_noise.metal: current\n", said.stdout)


if __name__ == "__main__":
    unittest.main()
