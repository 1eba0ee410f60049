"""Runs the code that MaterialX generates from shaders/nodes/materialx: run.py TARGET VALUES.raw

Each function is a graph with one float as its output. moderngl draws the graphs of glsl, and Cycles those of osl. For the other
targets, the nodes' functions are cut out of the generated code and run: essl, vulkan, wgsl and slang on Vulkan, msl and
mdl as C++. First, all nodes are generated within a standard_surface and compiled if the target has a compiler here."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import MaterialX as mx
import MaterialX.PyMaterialXGenGlsl as glsl
import MaterialX.PyMaterialXGenMdl as mdl
import MaterialX.PyMaterialXGenMsl as msl
import MaterialX.PyMaterialXGenOsl as osl
import MaterialX.PyMaterialXGenShader as gen
import MaterialX.PyMaterialXGenSlang as slang
import numpy as np

ENGINES = pathlib.Path(__file__).resolve().parents[1]
DIALECTS = ENGINES.parent / "dialects"
sys.path[:0] = [str(DIALECTS), str(ENGINES)]
import metal  # noqa: E402
from scene import SLANG, in_cpp, on_vulkan, packaged, report  # noqa: E402

FOLDER = tempfile.TemporaryDirectory(prefix="gabor-")
NODE = packaged("materialx", FOLDER.name)
GENERATORS = {"glsl": glsl.GlslShaderGenerator, "essl": glsl.EsslShaderGenerator, "vulkan": glsl.VkShaderGenerator,
              "wgsl": glsl.WgslShaderGenerator, "msl": msl.MslShaderGenerator, "slang": slang.SlangShaderGenerator,
              "osl": osl.OslShaderGenerator, "mdl": mdl.MdlShaderGenerator}
COMPILER = os.environ.get("CXX", "c++")

# ---- Documents -----------------------------------------------------------------------------------------------------

def port(element, text):
    """Returns an input or output from its name, its type, and its value or @NODE or @NODE.OUTPUT."""
    name, kind, value = text.split(" ", 2)
    source, _, output = value.removeprefix("@").partition(".")
    given = f'nodename="{source}"' + f' output="{output}"' * bool(output) if value[0] == "@" else f'value="{value}"'
    return f'<{element} name="{name}" type="{kind}" {given} />'


def node(category, name, kind, *inputs):
    return f'<{category} name="{name}" type="{kind}">{"".join(port("input", each) for each in inputs)}</{category}>'


def weighed(kind, of, weights):
    """Returns the nodes for the dot product of a vector with weights."""
    return node("constant", "weights", kind, f"value {kind} {weights}") \
        + node("dotproduct", "weighed", "float", f"in1 {kind} {of}", f"in2 {kind} @weights")


def out(*inputs):
    """Returns the node for the sum of one or two numbers."""
    return node("add", "out", "float", *(f"in{number} float {each}" for number, each in enumerate(inputs, 1)))


FLAT = "texcoord vector2 @place", "frequency float 4.0", "orientation float 45.000104", "seed integer 7"
SOLID = "position vector3 @spot", "frequency float 4.0", "direction vector3 1, 2, 3", "seed integer 7"
FRACTAL = "octaves float 3.3", "lacunarity float 2", "diminish float 0.5", "seed integer 7"
PLACE = node("position", "position", "vector3", "space string world") + node("floor", "pixel", "vector3", "in vector3 @position") \
    + node("add", "middle", "vector3", "in1 vector3 @pixel", "in2 vector3 0.5, 0.5, 9.6") \
    + node("multiply", "spot", "vector3", "in1 vector3 @middle", "in2 float 0.03125") \
    + node("convert", "place", "vector2", "in vector3 @spot")
WAVE, STRIPES = (node(f"gabor{kind}2d", kind, "multioutput", *FLAT) for kind in ("wave", "stripes"))

# The functions of reference.FUNCTIONS as graphs; the node "out" is the output.
FUNCTIONS = {
    "noise": node("gabornoise2d", "out", "float", *FLAT),
    "complex": WAVE + out("@wave.quadrature", "0"),
    "gradient": WAVE + weighed("vector2", "@wave.gradient", "0.03125, 0.0625") + out("@wave.noise", "@weighed"),
    "four": node("gabornoise2d", "four", "vector4", *FLAT, "amplitude vector4 0.25, 0.5, 0.75, 1")
            + weighed("vector4", "@four", "1, 1, 1, 1") + out("@weighed"),
    "solid": node("gaborwave3d", "wave", "multioutput", *SOLID)
             + weighed("vector3", "@wave.gradient", "0.015625, 0.03125, 0.046875") + out("@wave.noise", "@weighed"),
    "stripes": STRIPES + node("combine3", "three", "vector3", "in1 float @stripes.cosine", "in2 float @stripes.sine",
                              "in3 float @stripes.intensity") + weighed("vector3", "@three", "0.25, 0.5, 0.75") + out("@weighed"),
    "brushed metal": node("gaborbrushedmetal", "metal", "multioutput", "texcoord vector2 @place", "seed integer 7")
                     + node("extract", "red", "float", "in color3 @metal.base_color")
                     + node("multiply", "weighed", "float", "in1 float @metal.height", "in2 float 200") + out("@red", "@weighed"),
    "fbm": node("gaborfractal2d", "fractal", "multioutput", FLAT[0], *FRACTAL) + out("@fractal.noise", "0"),
}


def graph(name, nodes, *outputs):
    return f'<nodegraph name="{name}">{PLACE}{nodes}{"".join(port("output", each) for each in outputs)}</nodegraph>'


# A surface whose inputs are the outputs of all nodes.
SHOWN = ("base_color color3 @colour", "specular_roughness float @rough", "specular_color color3 @metal.base_color",
         "coat float @stripes.sine", "sheen float @steep", "subsurface float @fractal.noise", "transmission float @solid.noise")
SURFACE = graph("graph", WAVE + STRIPES + node("gabornoise2d", "colour", "color3", *FLAT, "amplitude float 0.25", "pivot float 0.5")
                + node("gabornoise3d", "rough", "float", *SOLID) + node("magnitude", "steep", "float", "in vector2 @wave.gradient")
                + node("gaborbrushedmetal", "metal", "multioutput", "texcoord vector2 @place")
                + node("gaborfractal2d", "fractal", "multioutput", FLAT[0], *FRACTAL)
                + node("gaborfractal3d", "solid", "multioutput", SOLID[0], *FRACTAL, "basis integer 1"), *SHOWN) \
    + '<standard_surface name="surface" type="surfaceshader">' \
    + "".join('<input name="{0}" type="{1}" nodegraph="graph" output="{0}" />'.format(*each.split()) for each in SHOWN) \
    + "</standard_surface>" + node("surfacematerial", "scene", "material", "surfaceshader surfaceshader @surface")


def generated(target, content):
    """Returns the text of each stage of a document's shader."""
    search = mx.getDefaultDataSearchPath()
    search.append(mx.FilePath(str(NODE)))
    library = mx.createDocument()
    mx.loadLibraries(mx.getDefaultDataLibraryFolders(), search, library)
    mx.loadLibraries(["libraries/gabor"], mx.FileSearchPath(str(NODE)), library)
    scene = mx.createDocument()
    mx.readFromXmlString(scene, f'<?xml version="1.0"?><materialx version="1.39">{content}</materialx>')
    scene.setDataLibrary(library)
    for document in (scene, library):
        valid, message = document.validate()
        if not valid:
            sys.exit(message)
    generator = GENERATORS[target].create()
    context = gen.GenContext(generator)
    context.registerSourceCodeSearchPath(search)
    shader = generator.generate("scene", scene.getDescendant("scene/value") or scene.getDescendant("scene"), context)
    stages = [gen.PIXEL_STAGE] if target in ("osl", "mdl") else [gen.VERTEX_STAGE, gen.PIXEL_STAGE]
    return [shader.getSourceCode(stage) for stage in stages]


# ---- Compilers -----------------------------------------------------------------------------------------------------

def run(*command, **options):
    return subprocess.run(list(map(str, command)), check=True, stdout=subprocess.PIPE, text=True, **options).stdout


def spirv(target, text, ending, folder):
    """Compiles GLSL (frag, vert or comp) or Slang to SPIR-V; for the target wgsl, naga turns the GLSL into WGSL first."""
    source, made = folder / f"shader.{ending}", folder / "shader.spv"
    source.write_text(text)
    if target == "slang":
        stage = {"frag": "fragment", "vert": "vertex", "comp": "compute"}[ending]
        entry = {"frag": "fragmentMain", "vert": "vertexMain", "comp": "main"}[ending]
        run(sys.executable, "-B", DIALECTS / "slangc.py", source, entry, stage, made)
    elif target == "wgsl":
        wgsl = folder / "shader.wgsl"
        run("naga", "--input-kind", "glsl", "--shader-stage", {"frag": "fragment", "vert": "vertex", "comp": "compute"}[ending],
            source, wgsl)
        run("naga", wgsl, made)
    elif target == "vulkan":
        run("glslangValidator", "-V", source, "-o", made)
    else:
        run("glslangValidator", source)
    return made


def compiled(target, stages, folder):
    """Compiles all stages for targets that have a compiler here."""
    if target in ("glsl", "essl", "vulkan", "wgsl", "slang"):
        for text, ending in zip(stages, ("vert", "frag")):
            spirv(target, text, ending, folder)


# ---- The nodes' functions alone ------------------------------------------------------------------------------------

# The names are those of reference.FUNCTIONS.
VALUES = {
    "noise": "field2d(p, 7).x",
    "complex": "field2d(p, 7).y",
    "gradient": "field2d(p, 7).x + (field2d(p, 7).z + 2.0 * field2d(p, 7).w) / 32.0",
    "four": "0.25 * (field2d(p, 7).x + 2.0 * field2d(p, part(-1)).x + 3.0 * field2d(p, part(-2)).x + 4.0 * field2d(p, part(-3)).x)",
    "solid": "field3d(p).x + (field3d(p).y + 2.0 * field3d(p).z + 3.0 * field3d(p).w) / 64.0",
    "fbm": "fractal2d(p).x",
}
MDL_FOUR = "dot(mx_gabornoise2d_vector4(float4(0.25, 0.5, 0.75, 1.0), 0.0, p, 4.0, 45.000104, 7), float4(1.0, 1.0, 1.0, 1.0))"
CALLS = """
float4 field2d(float2 p, int seed) { float4 r; mx_gaborfield2d(p, 4.0, 45.000104, seed, r); return r; }
float4 field3d(float2 p) { float4 r; mx_gaborfield3d(float3(p.x, p.y, 0.3), 4.0, float3(1.0, 2.0, 3.0), 7, r); return r; }
float3 fractal2d(float2 p) { float3 r; mx_gaborfractalfield2d(p, 3.3, 2.0, 0.5, 0, 0, 7, r); return r; }
int part(int index) { int r; mx_gaborseed(7, index, r); return r; }
"""
RETURNING = re.sub(r"float\d r; (\w+\(.*?), r\); return r;", r"return \1);", CALLS.replace("int r;", "float4 r;"))
GLSL = """#version 450
FUNCTIONS
layout(local_size_x = 8) in;
layout(std430, binding = 0) buffer Values { float values[]; };
void main()
{
    vec2 p = (vec2(gl_GlobalInvocationID.xy) + 0.5) / 32.0;
    values[gl_GlobalInvocationID.y * 256u + gl_GlobalInvocationID.x] = VALUE;
}
"""
CPP = """#include <metal_stdlib>
using namespace metal;
using color = float3;
struct Right { int bits; };
int operator>>(int word, Right right) { return int(unsigned(word) >> right.bits); }
"""


def functions(target):
    """Returns the nodes' functions, cut out of a shader that uses all nodes."""
    if target == "mdl":
        text = (NODE / "libraries" / "gabor" / "genmdl" / "mx_gabor.mdl").read_text()
        text = re.sub(r"^(mdl|import) .*$|^export ", "", text, flags=re.MULTILINE)
        return re.sub(r">>> (\d+)", r">> Right{\1}", text) + RETURNING
    text = generated(target, SURFACE)[-1]
    text = "".join(match[0] + "\n" for match in re.finditer(
        r"^ *#define MX_GABOR.*|^( *)\w+ mx_gabor\w*\([^)]*\)\s*\{\n(?:.*\n)*?\1\}", text, re.MULTILINE))
    calls = CALLS if target in ("msl", "slang") else re.sub(r"\bfloat([234])", r"vec\1", CALLS)
    return text + calls


def drawn_alone(target, folder):
    """Returns the values of each node function, run without the rest of the graph."""
    text, values = functions(target), folder / "values.raw"
    if target in ("msl", "mdl"):
        wanted = VALUES | {"four": MDL_FOUR} if target == "mdl" else VALUES
        return in_cpp(folder, CPP + metal.as_cpp(text), wanted.values(), "-O1", "-fwrapv", *metal.options(COMPILER))[:, :256]
    drawn = []
    for value in VALUES.values():
        source = (text + SLANG if target == "slang" else GLSL.replace("FUNCTIONS", text)).replace("VALUE", value)
        if target == "essl":
            source = source.replace("#version 450", "#version 310 es\nprecision highp float;")
        made = spirv("vulkan" if target == "essl" else target, source, "comp", folder)
        drawn.append(on_vulkan(made)[1][:65536])
    return drawn


# ---- Whole graphs --------------------------------------------------------------------------------------------------

def drawn_by_opengl():
    """Draws each function as a graph; returns the values and the driver's name."""
    import moderngl
    context = moderngl.create_context(standalone=True, backend="egl", libgl="libGL.so.1", libegl="libEGL.so.1")
    corners = context.buffer(np.array([0, 0, 0, 512, 0, 0, 0, 512, 0], "f4"))
    target = context.framebuffer([context.texture((256, 256), 4, dtype="f4")])
    target.use()
    drawn = []
    for nodes in FUNCTIONS.values():
        vertex, fragment = generated("glsl", graph("scene", nodes, "value float @out"))
        program = context.program(vertex_shader=vertex, fragment_shader=fragment)
        program["u_worldMatrix"] = tuple(np.eye(4).ravel())
        program["u_viewProjectionMatrix"] = (1 / 128, 0, 0, 0, 0, 1 / 128, 0, 0, 0, 0, 1, 0, -1, -1, 0, 1)
        context.vertex_array(program, corners, "i_position").render(vertices=3)
        drawn.append(np.frombuffer(target.read(components=4, dtype="f4"), "<f4")[0::4])
    return drawn, context.info["GL_RENDERER"]


def drawn_by_cycles(folder):
    for header in pathlib.Path(mx.__file__).parent.glob("libraries/stdlib/genosl/include/*.h"):
        shutil.copy(header, folder)
    for name, nodes in FUNCTIONS.items():
        shader, values = folder / f"{name}.osl", folder / "values.raw"
        shader.write_text(generated("osl", graph("scene", nodes, "value float @out"))[0])
        run(sys.executable, "-B", ENGINES / "blender" / "run.py", shader, values)
        yield np.fromfile(values, "<f4")


RAN = {"glsl": "GLSL 400", "essl": "ESSL, functions only", "vulkan": "Vulkan GLSL, functions only",
       "wgsl": "WGSL by naga, functions only", "msl": "MSL, functions only, as C++", "slang": "Slang, functions only",
       "osl": "OSL, in Cycles", "mdl": "MDL, functions only, as C++"}


def main():
    target, path = sys.argv[1:3]
    with tempfile.TemporaryDirectory(prefix="gabor-") as name:
        folder, driver = pathlib.Path(name), "CPU"
        compiled(target, generated(target, SURFACE), folder)
        if target == "glsl":
            drawn, driver = drawn_by_opengl()
        elif target == "osl":
            drawn = drawn_by_cycles(folder)
        else:
            drawn = drawn_alone(target, folder)
            driver = "CPU" if target in ("msl", "mdl") else "llvmpipe"
        values = np.concatenate([np.asarray(each, "<f4").ravel() for each in drawn])
    report(path, values, "MaterialX", mx.getVersionString(), RAN[target], driver,
           functions=list(FUNCTIONS if target in ("glsl", "osl") else VALUES))


if __name__ == "__main__":
    main()
