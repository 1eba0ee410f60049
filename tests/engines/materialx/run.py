"""What MaterialX makes of the node of shaders/nodes/materialx: run.py glsl|osl VALUES.raw. In GLSL it is drawn with
moderngl, after its texts for OpenGL ES and Vulkan were compiled; in OSL by Cycles."""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

import MaterialX as mx
import MaterialX.PyMaterialXGenGlsl as glsl
import MaterialX.PyMaterialXGenOsl as osl
import MaterialX.PyMaterialXGenShader as gen
import numpy as np

ENGINES = pathlib.Path(__file__).resolve().parents[1]
NODE = ENGINES.parents[1] / "shaders" / "nodes" / "materialx"
SCENE = """<?xml version="1.0"?>
<materialx version="1.39">
  <nodegraph name="scene">
    <position name="position" type="vector3"><input name="space" type="string" value="world" /></position>
    <convert name="flat" type="vector2"><input name="in" type="vector3" nodename="position" /></convert>
    <floor name="pixel" type="vector2"><input name="in" type="vector2" nodename="flat" /></floor>
    <add name="middle" type="vector2"><input name="in1" type="vector2" nodename="pixel" />
      <input name="in2" type="vector2" value="0.5, 0.5" /></add>
    <multiply name="place" type="vector2"><input name="in1" type="vector2" nodename="middle" />
      <input name="in2" type="vector2" value="0.03125, 0.03125" /></multiply>
    <gabor_noise name="noise" type="float"><input name="texcoord" type="vector2" nodename="place" />
      <input name="frequency" type="float" value="4.0" /><input name="orientation" type="float" value="0.7854" />
      <input name="seed" type="integer" value="7" /></gabor_noise>
    <output name="out" type="float" nodename="noise" />
  </nodegraph>
</materialx>"""


def generated(generator):
    """The shader of the scene."""
    search = mx.getDefaultDataSearchPath()
    search.append(mx.FilePath(str(NODE)))
    library = mx.createDocument()
    mx.loadLibraries(mx.getDefaultDataLibraryFolders(), search, library)
    mx.readFromXmlFile(library, str(NODE / "gabor_lattice.mtlx"))
    scene = mx.createDocument()
    mx.readFromXmlString(scene, SCENE)
    scene.setDataLibrary(library)
    valid, message = scene.validate()
    if not valid:
        sys.exit(message)
    context = gen.GenContext(generator)
    context.registerSourceCodeSearchPath(search)
    return generator.generate("scene", scene.getDescendant("scene/out"), context)


def text(shader, stage):
    return shader.getSourceCode(stage)


def compiled(shader, *options):
    """Whether glslang takes both stages."""
    for stage, ending in ((gen.VERTEX_STAGE, "vert"), (gen.PIXEL_STAGE, "frag")):
        with tempfile.TemporaryDirectory(prefix="gabor-") as folder:
            path = pathlib.Path(folder) / f"shader.{ending}"
            path.write_text(text(shader, stage))
            subprocess.run(["glslangValidator", *options, path], cwd=folder, check=True, stdout=sys.stderr)


def drawn(shader):
    """The values, and the name of the driver."""
    import moderngl
    context = moderngl.create_context(standalone=True, backend="egl", libgl="libGL.so.1", libegl="libEGL.so.1")
    program = context.program(vertex_shader=text(shader, gen.VERTEX_STAGE), fragment_shader=text(shader, gen.PIXEL_STAGE))
    program["u_worldMatrix"] = tuple(np.eye(4).ravel())
    program["u_viewProjectionMatrix"] = (1 / 128, 0, 0, 0, 0, 1 / 128, 0, 0, 0, 0, 1, 0, -1, -1, 0, 1)
    corners = context.buffer(np.array([0, 0, 0, 512, 0, 0, 0, 512, 0], "f4"))
    target = context.framebuffer([context.texture((256, 256), 4, dtype="f4")])
    target.use()
    context.vertex_array(program, corners, "i_position").render(vertices=3)
    return np.frombuffer(target.read(components=4, dtype="f4"), "<f4"), context.info["GL_RENDERER"]


if __name__ == "__main__":
    target, path = sys.argv[1:3]
    if target == "osl":
        with tempfile.TemporaryDirectory(prefix="gabor-") as folder:
            for header in pathlib.Path(mx.__file__).parent.glob("libraries/stdlib/genosl/include/*.h"):
                shutil.copy(header, folder)
            shader = pathlib.Path(folder) / "scene.osl"
            shader.write_text(text(generated(osl.OslShaderGenerator.create()), gen.PIXEL_STAGE))
            run = subprocess.run([sys.executable, ENGINES / "blender" / "run.py", shader, path], check=True, text=True,
                                 stdout=subprocess.PIPE)
        facts = json.loads(run.stdout.splitlines()[-1]) | {"dialect": "OSL, in Cycles"}
    else:
        compiled(generated(glsl.EsslShaderGenerator.create()))
        compiled(generated(glsl.VkShaderGenerator.create()), "-V")
        values, driver = drawn(generated(glsl.GlslShaderGenerator.create()))
        pathlib.Path(path).write_bytes(values[0::4].tobytes())
        facts = {"dialect": "GLSL 400", "driver": driver}
    print(json.dumps(facts | {"engine": "MaterialX", "version": mx.getVersionString()}))
