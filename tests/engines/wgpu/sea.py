"""Draws a sea with a floating box to sea.png: the GPU moves the vertices, and the CPU floats the box. sea.py [SECONDS]
The WGSL works as it stands in wgpu for Rust and in Bevy."""

import math
import pathlib
import sys

import gabor_noise
import numpy as np
import wgpu
from PIL import Image

SHADERS = pathlib.Path(__file__).resolve().parents[3] / "shaders" / "translations"
WIND, SEED, SIDE, VERTICES, SIZE = 12.0, 7, 128.0, 512, (960, 540)
seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 60.0
SEA = "".join((SHADERS / f"gabor_{name}.wgsl").read_text() for name in ("noise", "ocean"))
OCEAN = SEA + f"""
@group(0) @binding(0) var<storage, read_write> ocean: GaborOcean;
@compute @workgroup_size(1) fn main() {{ ocean = gabor_ocean({WIND}); }}  // once per sea
"""
DRAW = SEA + f"""
struct Frame {{ view: mat4x4f, box: mat4x4f, eye: vec3f, seconds: f32 }}
@group(0) @binding(0) var<storage, read> ocean: GaborOcean;
@group(0) @binding(1) var<uniform> frame: Frame;
struct Vertex {{ @builtin(position) place: vec4f, @location(0) at: vec3f, @location(1) rest: vec2f }}
const spacing = {SIDE / VERTICES};
const sun = vec3f(-0.53, 0.21, -0.82);

@vertex fn water(@builtin(vertex_index) i: u32) -> Vertex {{
    let corner = vec2u(i % 6u % 2u, u32(i % 6u == 2u || i % 6u >= 4u));
    let rest = spacing * vec2f(vec2u(i / 6u % {VERTICES}u, i / 6u / {VERTICES}u) + corner) - {SIDE / 2};
    let w = gabor_water_filtered(rest, vec2f(spacing, 0.0), vec2f(0.0, spacing), frame.seconds, ocean, {SEED}u);
    let at = vec3f(rest.x + w.shift.x, w.height, rest.y + w.shift.y);
    return Vertex(frame.view * vec4f(at, 1.0), at, rest);
}}
fn sky(ray: vec3f) -> vec3f {{ return mix(vec3f(0.62, 0.72, 0.82), vec3f(0.18, 0.36, 0.62), sqrt(max(ray.y, 0.0))); }}
@fragment fn surface(v: Vertex) -> @location(0) vec4f {{
    let w = gabor_water_filtered(v.rest, dpdx(v.rest), dpdy(v.rest), frame.seconds, ocean, {SEED}u);
    let slope = w.slope / clamp(w.jacobian, 0.4, 2.0);  // where the water is now
    let normal = normalize(vec3f(-slope.x, 1.0, -slope.y));
    let ray = normalize(frame.eye - v.at);
    let rough = w.lost.x + w.lost.y + 0.0004;
    let facing = max(dot(normal, ray), 0.0);
    let h = normalize(sun + ray);
    let tilt = h.xz / h.y + slope;  // of the facets that mirror the sun, from the mean slope
    let mirrored = 0.02 + 0.98 * pow(1.0 - facing, 5.0) / (1.0 + 22.0 * rough);
    let light = mix(vec3f(0.01, 0.05, 0.055), sky(reflect(-ray, normal)), mirrored)
              + 0.02 * exp(-dot(tilt, tilt) / rough) / (rough * max(facing, 0.1)) * vec3f(1.0, 0.85, 0.6);
    return vec4f(mix(light, vec3f(0.8), 0.9 * gabor_foam(v.rest, dpdx(v.rest), dpdy(v.rest), w, ocean, {SEED}u)), 1.0);
}}

@vertex fn box(@builtin(vertex_index) i: u32) -> Vertex {{  // two triangles for each of six sides
    let side = i / 6u;
    let corner = 2.0 * vec2f(f32(i % 6u % 2u), f32(i % 6u == 2u || i % 6u >= 4u)) - 1.0;
    let out = select(-1.0, 1.0, side % 2u == 1u);
    let of_axis = array(vec3f(out, corner), vec3f(corner.x, out, corner.y), vec3f(corner, out));
    let normal = array(vec3f(out, 0.0, 0.0), vec3f(0.0, out, 0.0), vec3f(0.0, 0.0, out));
    let at = frame.box * vec4f(vec3f(1.5, 1.0, 1.5) * of_axis[side / 2u], 1.0);
    return Vertex(frame.view * at, (frame.box * vec4f(normal[side / 2u], 0.0)).xyz, vec2f(0.0));
}}
@fragment fn paint(v: Vertex) -> @location(0) vec4f {{
    return vec4f(vec3f(0.6, 0.16, 0.04) * (0.35 + max(dot(v.at, sun), 0.0) + 0.2 * v.at.y), 1.0);
}}
"""

# The box's height and tilt follow the water under its corners.
a, b, c, d = gabor_noise.water_height([-1.5, 1.5, -1.5, 1.5], [-1.5, -1.5, 1.5, 1.5], seconds=seconds, wind=WIND, seed=SEED)
up = np.array([(a + c - b - d) / 6, 1, (a + b - c - d) / 6])
up /= np.linalg.norm(up)
right = np.cross(up, [0, 0, 1])
right /= np.linalg.norm(right)
box = np.eye(4)
box[:3] = np.column_stack([right, up, np.cross(right, up), [0, (a + b + c + d) / 4 + 0.3, 0]])

eye = np.array([10.0, 5.0, 16.0])
back = eye / np.linalg.norm(eye)
x = np.cross([0, 1, 0], back)
x /= np.linalg.norm(x)
look = np.vstack([np.column_stack([[x, np.cross(back, x), back], -np.array([x, np.cross(back, x), back]) @ eye]), [0, 0, 0, 1]])
focal, near, far = 1 / math.tan(math.radians(45) / 2), 0.1, 500.0
view = np.array([[focal * SIZE[1] / SIZE[0], 0, 0, 0], [0, focal, 0, 0], [0, 0, far / (near - far), near * far / (near - far)], [0, 0, -1, 0]]) @ look

device = wgpu.gpu.request_adapter_sync(power_preference="high-performance").request_device_sync()
ocean = device.create_buffer(size=1024, usage=wgpu.BufferUsage.STORAGE)
frame = device.create_buffer_with_data(data=np.concatenate([view.T.ravel(), box.T.ravel(), eye, [seconds]]).astype("f4"),
                                       usage=wgpu.BufferUsage.UNIFORM)
encoder = device.create_command_encoder()
once = device.create_compute_pipeline(layout="auto", compute={"module": device.create_shader_module(code=OCEAN)})
compute = encoder.begin_compute_pass()
compute.set_pipeline(once)
compute.set_bind_group(0, device.create_bind_group(layout=once.get_bind_group_layout(0), entries=[{"binding": 0, "resource": {"buffer": ocean}}]))
compute.dispatch_workgroups(1)
compute.end()

kinds = wgpu.ShaderStage.VERTEX | wgpu.ShaderStage.FRAGMENT
layout = device.create_bind_group_layout(entries=[
    {"binding": 0, "visibility": kinds, "buffer": {"type": "read-only-storage"}},
    {"binding": 1, "visibility": kinds, "buffer": {"type": "uniform"}}])
group = device.create_bind_group(layout=layout, entries=[{"binding": i, "resource": {"buffer": buffer}} for i, buffer in enumerate((ocean, frame))])
picture = device.create_texture(size=(*SIZE, 1), format="rgba8unorm-srgb", usage=wgpu.TextureUsage.RENDER_ATTACHMENT | wgpu.TextureUsage.COPY_SRC)
depth = device.create_texture(size=(*SIZE, 1), format="depth32float", usage=wgpu.TextureUsage.RENDER_ATTACHMENT)
module = device.create_shader_module(code=DRAW)
draw = encoder.begin_render_pass(
    color_attachments=[{"view": picture.create_view(), "clear_value": (0.62, 0.72, 0.82, 1), "load_op": "clear", "store_op": "store"}],
    depth_stencil_attachment={"view": depth.create_view(), "depth_clear_value": 1, "depth_load_op": "clear", "depth_store_op": "store"})
for vertex, fragment, count in ("water", "surface", 6 * VERTICES**2), ("box", "paint", 36):
    draw.set_pipeline(device.create_render_pipeline(
        layout=device.create_pipeline_layout(bind_group_layouts=[layout]), vertex={"module": module, "entry_point": vertex},
        fragment={"module": module, "entry_point": fragment, "targets": [{"format": "rgba8unorm-srgb"}]},
        depth_stencil={"format": "depth32float", "depth_write_enabled": True, "depth_compare": "less"}))
    draw.set_bind_group(0, group)
    draw.draw(count)
draw.end()
device.queue.submit([encoder.finish()])
pixels = device.queue.read_texture({"texture": picture}, {"bytes_per_row": 4 * SIZE[0]}, (*SIZE, 1))
Image.fromarray(np.frombuffer(pixels, "u1").reshape(SIZE[1], SIZE[0], 4)).convert("RGB").save("sea.png")
