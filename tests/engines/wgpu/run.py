"""Runs a drop-in in a GLSL 450 compute shader, or its WGSL translation, with wgpu, which contains naga:
run.py glsl|wgsl VALUES.raw DROP_IN [NAME=VALUE], where NAME is a macro in GLSL"""

import pathlib
import sys

import wgpu

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from scene import compute_shader, drop_in, report  # noqa: E402

language, path, name, *macros = sys.argv[1:]
WGSL = """
@group(0) @binding(0) var<storage, read_write> values: array<f32>;

@compute @workgroup_size(8)
fn main(@builtin(global_invocation_id) pixel: vec3u) {
    let p = (vec2f(pixel.xy) + 0.5) / 32.0;
    values[pixel.y * 256u + pixel.x] = gabor_noise(p, 4.0, 0.7854, 7u);
}
"""

if language == "wgsl":
    code = drop_in(name, (), "wgsl") + WGSL
else:  # naga does not support writeonly here
    code = compute_shader(name, macros).replace("writeonly ", "")
adapter = wgpu.gpu.request_adapter_sync(power_preference="high-performance")
device = adapter.request_device_sync()
size = 256 * 257 * 4
values = device.create_buffer(size=size, usage=wgpu.BufferUsage.STORAGE | wgpu.BufferUsage.COPY_SRC)
# For GLSL, the label must contain comp, vert or frag: it selects the stage.
module = device.create_shader_module(label="comp", code=code)
pipeline = device.create_compute_pipeline(layout="auto", compute={"module": module, "entry_point": "main"})
group = device.create_bind_group(layout=pipeline.get_bind_group_layout(0),
                                 entries=[{"binding": 0, "resource": {"buffer": values, "offset": 0, "size": size}}])
encoder = device.create_command_encoder()
compute = encoder.begin_compute_pass()
compute.set_pipeline(pipeline)
compute.set_bind_group(0, group)
compute.dispatch_workgroups(256 // 8, 257)
compute.end()
device.queue.submit([encoder.finish()])

report(path, device.queue.read_buffer(values), "wgpu", wgpu.__version__, "WGSL" if language == "wgsl" else "GLSL 450 by naga",
       adapter.info["device"])
