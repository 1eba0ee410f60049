extends Node3D
## Floats a box on the sea of sea.gdshader. Heights come from a compute shader, because GDScript cannot call C++; a server written
## in C++ or C# computes the same heights with gabor_ocean.hpp. With an argument, saves a picture: godot --path . sea.tscn -- sea.png

const WIND := 12.0
var seconds := 60.0
var device := RenderingServer.create_local_rendering_device()
var shader: RID
var pipeline: RID

func _ready() -> void:
	var source := RDShaderSource.new()
	source.source_compute = FileAccess.get_file_as_string("res://heights.comp")
	for name in ["gabor_noise", "gabor_ocean"]: # RDShaderSource does not resolve includes
		source.source_compute = source.source_compute.replace('#include "%s.glsl"' % name, FileAccess.get_file_as_string("res://%s.glsl" % name))
	shader = device.shader_create_from_spirv(device.shader_compile_spirv_from_source(source))
	pipeline = device.compute_pipeline_create(shader)
	if not OS.get_cmdline_user_args().is_empty():
		for frame in 4:
			await RenderingServer.frame_post_draw
		get_viewport().get_texture().get_image().save_png("res://" + OS.get_cmdline_user_args()[0])
		get_tree().quit()

## Returns the heights of the water above points, in metres.
func heights(points: PackedVector2Array) -> PackedFloat32Array:
	var bytes := points.to_byte_array()
	var buffer := device.storage_buffer_create(bytes.size(), bytes)
	var uniform := RDUniform.new()
	uniform.uniform_type = RenderingDevice.UNIFORM_TYPE_STORAGE_BUFFER
	uniform.add_id(buffer)
	var push := PackedFloat32Array([WIND, seconds, 0, 0]).to_byte_array()
	push.encode_s32(8, points.size())
	var list := device.compute_list_begin()
	device.compute_list_bind_compute_pipeline(list, pipeline)
	device.compute_list_bind_uniform_set(list, device.uniform_set_create([uniform], shader, 0), 0)
	device.compute_list_set_push_constant(list, push, push.size())
	device.compute_list_dispatch(list, (points.size() + 63) / 64, 1, 1)
	device.compute_list_end()
	device.submit()
	device.sync()
	var found := device.buffer_get_data(buffer).to_float32_array()
	device.free_rid(buffer)
	return PackedFloat32Array(range(points.size()).map(func(i): return found[2 * i]))

func _process(delta: float) -> void:
	seconds += delta
	$Sea.mesh.material.set_shader_parameter("seconds", seconds)
	$Sea.mesh.material.set_shader_parameter("wind", WIND)
	var h := heights([Vector2(-1.5, -1.5), Vector2(1.5, -1.5), Vector2(-1.5, 1.5), Vector2(1.5, 1.5)])
	var normal := Vector3((h[0] + h[2] - h[1] - h[3]) / 6, 1, (h[0] + h[1] - h[2] - h[3]) / 6).normalized()
	$Box.transform = Transform3D(Basis(Quaternion(Vector3.UP, normal)), Vector3(0, (h[0] + h[1] + h[2] + h[3]) / 4 + 0.3, 0))
