"""Runs the code that MaterialX generates from shaders/nodes/materialx: run.py TARGET VALUES.raw

Each function is a graph with one float as its output. moderngl draws the graphs of glsl, and Cycles those of osl. For the other
targets, the nodes' functions are cut out of the generated code and run: essl, vulkan, wgsl and slang on Vulkan, msl and
mdl as C++. First, all nodes are generated within a standard_surface and compiled if the target has a compiler here."""

import json
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
from packaged import packaged  # noqa: E402

FOLDER = tempfile.TemporaryDirectory(prefix="gabor-")
NODE = packaged("materialx", FOLDER.name)
GENERATORS = {"glsl": glsl.GlslShaderGenerator, "essl": glsl.EsslShaderGenerator, "vulkan": glsl.VkShaderGenerator,
              "wgsl": glsl.WgslShaderGenerator, "msl": msl.MslShaderGenerator, "slang": slang.SlangShaderGenerator,
              "osl": osl.OslShaderGenerator, "mdl": mdl.MdlShaderGenerator}
COMPILER = os.environ.get("CXX", "c++")

# ---- Documents -----------------------------------------------------------------------------------------------------

WAVE = """<input name="frequency" type="float" value="4.0" />
      <input name="orientation" type="float" value="45.000104" unittype="angle" unit="degree" />
      <input name="seed" type="integer" value="7" />"""
FLAT = f'<input name="texcoord" type="vector2" nodename="place" />{WAVE}'
SOLID = '<input name="position" type="vector3" nodename="spot" /><input name="frequency" type="float" value="4.0" />' \
        '<input name="direction" type="vector3" value="1, 2, 3" /><input name="seed" type="integer" value="7" />'
PLACE = """<position name="position" type="vector3"><input name="space" type="string" value="world" /></position>
    <floor name="pixel" type="vector3"><input name="in" type="vector3" nodename="position" /></floor>
    <add name="middle" type="vector3"><input name="in1" type="vector3" nodename="pixel" />
      <input name="in2" type="vector3" value="0.5, 0.5, 9.6" /></add>
    <multiply name="spot" type="vector3"><input name="in1" type="vector3" nodename="middle" />
      <input name="in2" type="float" value="0.03125" /></multiply>
    <convert name="place" type="vector2"><input name="in" type="vector3" nodename="spot" /></convert>"""


def weighed(kind, of, weights):
    """Returns the nodes for the dot product of a vector output with weights."""
    return (f'<constant name="weights" type="{kind}"><input name="value" type="{kind}" value="{weights}" /></constant>'
            f'<dotproduct name="weighed" type="float"><input name="in1" type="{kind}" {of} />'
            f'<input name="in2" type="{kind}" nodename="weights" /></dotproduct>')


def plus(of):
    """Returns the node for the noise plus the weighted outputs."""
    return (f'<add name="out" type="float"><input name="in1" type="float" {of} /><input name="in2" type="float" '
            'nodename="weighed" /></add>')


# The functions of reference.FUNCTIONS as graphs; the node "out" is the output.
FUNCTIONS = {
    "noise": f'<gabornoise2d name="out" type="float">{FLAT}</gabornoise2d>',
    "complex": f'<gaborwave2d name="wave" type="multioutput">{FLAT}</gaborwave2d>'
               '<add name="out" type="float"><input name="in1" type="float" nodename="wave" output="quadrature" />'
               '<input name="in2" type="float" value="0" /></add>',
    "gradient": f'<gaborwave2d name="wave" type="multioutput">{FLAT}</gaborwave2d>'
                + weighed("vector2", 'nodename="wave" output="gradient"', "0.03125, 0.0625")
                + plus('nodename="wave" output="noise"'),
    "four": f'<gabornoise2d name="four" type="vector4">{FLAT}<input name="amplitude" type="vector4" value="0.25, 0.5, 0.75, 1" />'
            '</gabornoise2d>' + weighed("vector4", 'nodename="four"', "1, 1, 1, 1")
            + '<add name="out" type="float"><input name="in1" type="float" nodename="weighed" /></add>',
    "solid": f'<gaborwave3d name="wave" type="multioutput">{SOLID}</gaborwave3d>'
             + weighed("vector3", 'nodename="wave" output="gradient"', "0.015625, 0.03125, 0.046875")
             + plus('nodename="wave" output="noise"'),
    "stripes": f'<gaborstripes2d name="wave" type="multioutput">{FLAT}</gaborstripes2d>'
               '<combine3 name="three" type="vector3"><input name="in1" type="float" nodename="wave" output="cosine" />'
               '<input name="in2" type="float" nodename="wave" output="sine" />'
               '<input name="in3" type="float" nodename="wave" output="intensity" /></combine3>'
               + weighed("vector3", 'nodename="three"', "0.25, 0.5, 0.75")
               + '<add name="out" type="float"><input name="in1" type="float" nodename="weighed" /></add>',
    "brushed metal": '<gaborbrushedmetal name="metal" type="multioutput"><input name="texcoord" type="vector2" nodename="place" />'
                     '<input name="seed" type="integer" value="7" /></gaborbrushedmetal>'
                     '<extract name="red" type="float"><input name="in" type="color3" nodename="metal" output="base_color" />'
                     '</extract><multiply name="weighed" type="float"><input name="in1" type="float" nodename="metal" '
                     'output="height" /><input name="in2" type="float" value="200" /></multiply>' + plus('nodename="red"'),
}
SURFACE = f"""<nodegraph name="graph">{PLACE}
    <gabornoise2d name="colour" type="color3">{FLAT}<input name="amplitude" type="float" value="0.25" />
      <input name="pivot" type="float" value="0.5" /></gabornoise2d>
    <gabornoise3d name="rough" type="float">{SOLID}</gabornoise3d>
    <gaborwave2d name="wave" type="multioutput">{FLAT}</gaborwave2d>
    <magnitude name="steep" type="float"><input name="in" type="vector2" nodename="wave" output="gradient" /></magnitude>
    <gaborstripes2d name="stripes" type="multioutput">{FLAT}</gaborstripes2d>
    <gaborbrushedmetal name="metal" type="multioutput"><input name="texcoord" type="vector2" nodename="place" />
    </gaborbrushedmetal>
    <output name="sine_out" type="float" nodename="stripes" output="sine" />
    <output name="metal_out" type="color3" nodename="metal" output="base_color" />
    <output name="colour_out" type="color3" nodename="colour" /><output name="rough_out" type="float" nodename="rough" />
    <output name="steep_out" type="float" nodename="steep" /></nodegraph>
  <standard_surface name="surface" type="surfaceshader">
    <input name="base_color" type="color3" nodegraph="graph" output="colour_out" />
    <input name="specular_roughness" type="float" nodegraph="graph" output="rough_out" />
    <input name="specular_color" type="color3" nodegraph="graph" output="metal_out" />
    <input name="coat" type="float" nodegraph="graph" output="sine_out" />
    <input name="sheen" type="float" nodegraph="graph" output="steep_out" /></standard_surface>
  <surfacematerial name="scene" type="material"><input name="surfaceshader" type="surfaceshader" nodename="surface" />
  </surfacematerial>"""


def graph(nodes):
    return f'<nodegraph name="scene">{PLACE}{nodes}<output name="value" type="float" nodename="out" /></nodegraph>'


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
}
MDL_FOUR = "dot(mx_gabornoise2d_vector4(float4(0.25, 0.5, 0.75, 1.0), 0.0, p, 4.0, 45.000104, 7), float4(1.0, 1.0, 1.0, 1.0))"
CALLS = """
float4 field2d(float2 p, int seed) { float4 r; mx_gaborfield2d(p, 4.0, 45.000104, seed, r); return r; }
float4 field3d(float2 p) { float4 r; mx_gaborfield3d(float3(p.x, p.y, 0.3), 4.0, float3(1.0, 2.0, 3.0), 7, r); return r; }
int part(int index) { int r; mx_gaborseed(7, index, r); return r; }
"""
RETURNING = re.sub(r"float4 r; (\w+\(.*?), r\); return r;", r"return \1);", CALLS.replace("int r;", "float4 r;"))
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
SLANG = """FUNCTIONS
[[vk::binding(0)]] RWStructuredBuffer<float> values;
[shader("compute")][numthreads(8, 1, 1)] void main(uint3 pixel : SV_DispatchThreadID)
{
    float2 p = (float2(pixel.xy) + 0.5) / 32.0;
    values[pixel.y * 256 + pixel.x] = VALUE;
}
"""
CPP = """#include <fstream>
#include <metal_stdlib>
using namespace metal;
using color = float3;
int mdl_right(int word, int bits) { return int(unsigned(word) >> bits); }
FUNCTIONS
int main(int, char** argv)
{
    std::ofstream file(argv[1], std::ios::binary);
    for (int i = 0; i < 256 * 256; ++i) {
        const float2 p = (float2(float(i % 256), float(i / 256)) + 0.5) / 32.0;
        const float value = VALUE;
        file.write(reinterpret_cast<const char*>(&value), sizeof value);
    }
}
"""


def functions(target):
    """Returns the nodes' functions, cut out of a shader that uses all nodes."""
    if target == "mdl":
        text = (NODE / "libraries" / "gabor" / "genmdl" / "mx_gabor.mdl").read_text()
        text = re.sub(r"^(mdl|import) .*$|^export ", "", text, flags=re.MULTILINE)
        return re.sub(r"(\w+|\((?:[^()]|\([^()]*\))*\)) >>> (\d+)", r"mdl_right(\1, \2)", text) + RETURNING
    text = generated(target, SURFACE)[-1]
    text = "".join(match[0] + "\n" for match in re.finditer(
        r"^ *#define MX_GABOR.*|^( *)\w+ mx_gabor\w*\([^)]*\)\s*\{\n(?:.*\n)*?\1\}", text, re.MULTILINE))
    calls = CALLS if target in ("msl", "slang") else re.sub(r"\bfloat([234])", r"vec\1", CALLS)
    return text + calls


def drawn_alone(target, folder):
    """Yields the values of each node function, run without the rest of the graph."""
    text, values = functions(target), folder / "values.raw"
    wanted = VALUES | {"four": MDL_FOUR} if target == "mdl" else VALUES
    for value in wanted.values():
        if target in ("msl", "mdl"):
            source, program = folder / "program.cpp", folder / "program"
            source.write_text(CPP.replace("FUNCTIONS", metal.as_cpp(text)).replace("VALUE", value))
            run(COMPILER, *metal.options(COMPILER), "-O1", "-fwrapv", source, "-o", program)
            run(program, values)
        else:
            source = (SLANG if target == "slang" else GLSL).replace("FUNCTIONS", text).replace("VALUE", value)
            if target == "essl":
                source = source.replace("#version 450", "#version 310 es\nprecision highp float;")
            made = spirv("vulkan" if target == "essl" else target, source, "comp", folder)
            run(pathlib.Path(os.environ["GABOR_SCENES"]) / "scene_vulkan", made, values)
        yield np.fromfile(values, "<f4")[:65536]


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
        vertex, fragment = generated("glsl", graph(nodes))
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
        shader.write_text(generated("osl", graph(nodes))[0])
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
        pathlib.Path(path).write_bytes(b"".join(np.ascontiguousarray(each, "<f4").tobytes() for each in drawn))
    print(json.dumps({"engine": "MaterialX", "version": mx.getVersionString(), "dialect": RAN[target], "driver": driver,
                      "functions": list(FUNCTIONS if target in ("glsl", "osl") else VALUES)}))


if __name__ == "__main__":
    main()
