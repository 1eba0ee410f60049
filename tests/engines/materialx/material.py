"""The MaterialX document of a folder that `gabor render --maps` wrote, in the room and under the lamp of the viewer's
lit view (shaders/passes/light.glsl), by MaterialX's own renderer in OpenGL: material.py FOLDER VALUES.raw
AZIMUTH/ELEVATION..."""

import json
import math
import pathlib
import sys
import tempfile

import MaterialX as mx
import MaterialX.PyMaterialXGenGlsl as glsl
import MaterialX.PyMaterialXGenShader as gen
import MaterialX.PyMaterialXRender as mx_render
import MaterialX.PyMaterialXRenderGlsl as mx_glsl
import numpy as np

folder, values = map(pathlib.Path, sys.argv[1:3])
lights = [tuple(map(float, light.split("/"))) for light in sys.argv[3:]]


def smoothstep(low, high, x):
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def directions(height):
    """MaterialX's environment map: rows go down from the top, and its middle is +z, towards the eye."""
    up = np.pi * (0.5 - (np.arange(height) + 0.5) / height)[:, None]
    around = np.pi * (np.arange(2 * height) + 0.5)[None] / height - np.pi
    return np.dstack([-np.cos(up) * np.sin(around), np.sin(up) + 0 * around, np.cos(up) * np.cos(around)])


def room(d):
    down = -d[..., 1]
    window = smoothstep(-0.3, 0.3, 0.35 - abs(d[..., 0] + 0.12 - 0.2 * down)) * smoothstep(-0.3, 0.3, 0.4 - down)
    return np.array([0.13, 0.14, 0.16]) + window[..., None] * [0.8, 0.85, 0.95]


def irradiance(d):
    """Over pi."""
    light = directions(32)
    area = np.sqrt(1 - light[..., 1:2] ** 2) * (np.pi / 32) ** 2
    return np.maximum(np.tensordot(d, light, (2, 2)), 0).reshape(-1, 32 * 64) @ (room(light) * area).reshape(-1, 3) / np.pi


def image(rgb):
    made = mx_render.Image.create(rgb.shape[1], rgb.shape[0], 3, mx_render.FLOAT)
    made.createResourceBuffer()
    for y, row in enumerate(rgb.tolist()):
        for x, texel in enumerate(row):
            made.setTexelColor(x, y, mx.Color4(*texel, 1))
    return made


document = mx.createDocument()
search = mx.getDefaultDataSearchPath()
mx.loadLibraries(mx.getDefaultDataLibraryFolders(), search, document)
mx.readFromXmlFile(document, str(folder / "material.mtlx"))
lamp = document.addNode("point_light", "lamp", "lightshader")
lamp.setInputValue("position", mx.Vector3(0, 0, 1))
lamp.setInputValue("color", mx.Color3(1, 0.96, 0.9))
lamp.setInputValue("intensity", 0.7 * math.pi)
lamp.setInputValue("decay_rate", 0.0)

generator = glsl.GlslShaderGenerator.create()
context = gen.GenContext(generator)
context.registerSourceCodeSearchPath(search)
context.getOptions().fileTextureVerticalFlip = True  # as in OpenGL, v = 0 is the first row
context.getOptions().hwMaxActiveLightSources = 1
colours = gen.DefaultColorManagementSystem.create(generator.getTarget())
colours.loadLibrary(document)
generator.setColorManagementSystem(colours)

renderer = mx_glsl.GlslRenderer.create(16, 16, mx_render.FLOAT)
renderer.initialize()  # before the textures
files = mx_glsl.GLTextureHandler.create(mx_render.StbImageLoader.create())
files.setSearchPath(mx.FileSearchPath(str(folder)))
renderer.setImageHandler(files)
probe = files.acquireImage(mx.FilePath("base_color.png"))
width, height = probe.getWidth(), probe.getHeight()
renderer.setSize(width, height)

handler = mx_render.LightHandler.create()
handler.setEnvRadianceMap(image(room(directions(64))))
handler.setEnvIrradianceMap(image(irradiance(directions(16)).reshape(16, 32, 3)))
handler.setEnvSampleCount(256)
handler.registerLights(document, [lamp], context)
handler.setLightSources([lamp])
renderer.setLightHandler(handler)

x, y = 0.5 * width / max(width, height), 0.5 * height / max(width, height)
with tempfile.TemporaryDirectory(prefix="gabor-") as scratch:
    square = pathlib.Path(scratch) / "square.obj"
    square.write_text(f"v {-x} {-y} 0\nv {x} {-y} 0\nv {x} {y} 0\nv {-x} {y} 0\nvn 0 0 1\n"
                      "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1/1 2/2/1 3/3/1 4/4/1\n")
    geometry = renderer.getGeometryHandler()
    geometry.addLoader(mx_render.TinyObjLoader.create())
    geometry.loadGeometry(mx.FilePath(str(square)), False)

camera = mx_render.Camera.create()
camera.setViewMatrix(mx_render.Camera.createViewMatrix(mx.Vector3(0, 0, 1.8), mx.Vector3(0, 0, 0), mx.Vector3(0, 1, 0)))
near = 0.1
camera.setProjectionMatrix(mx_render.Camera.createPerspectiveMatrix(-x * near / 1.8, x * near / 1.8, -y * near / 1.8,
                                                                    y * near / 1.8, near, 10))
renderer.setCamera(camera)

shader = generator.generate("material", document.getMaterialNodes()[0], context)
renderer.createProgram(shader)
renderer.validateInputs()
pictures = []
for azimuth, elevation in lights:
    a, e = math.radians(azimuth), math.radians(elevation)
    lamp.setInputValue("position", mx.Vector3(2.5 * math.cos(e) * math.cos(a), -2.5 * math.cos(e) * math.sin(a), 2.5 * math.sin(e)))
    renderer.render()
    shown = renderer.captureImage(None)
    pictures.append([[list(shown.getTexelColor(column, row).asTuple()) for column in range(width)] for row in reversed(range(height))])
values.write_bytes(np.array(pictures, "<f4").tobytes())
print(json.dumps({"engine": "MaterialX", "version": mx.getVersionString()}))
