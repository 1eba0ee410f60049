extends Node
## Shows the noise with a canvas shader; or draws it into a viewport, or with a compute shader, and writes the values:
## godot --path . [-- VALUES.raw canvas|compute]

func _ready() -> void:
	var arguments := OS.get_cmdline_user_args()
	if arguments.is_empty():
		add_child(rectangle(true))
		return
	var values := compute() if arguments[1] == "compute" else await canvas()
	FileAccess.open("res://" + arguments[0], FileAccess.WRITE).store_buffer(values.to_byte_array())
	print(JSON.stringify({
		engine = "Godot", version = Engine.get_version_info().string,
		dialect = "GLSL 450, compute" if arguments[1] == "compute" else "Godot, canvas",
		driver = "%s, %s" % [RenderingServer.get_video_adapter_name(), RenderingServer.get_current_rendering_method()],
	}))
	get_tree().quit()

func rectangle(shown: bool) -> ColorRect:
	var result := ColorRect.new()
	result.size = Vector2(256, 257)
	result.material = ShaderMaterial.new()
	result.material.shader = load("res://noise.gdshader")
	result.material.set_shader_parameter("shown", shown)
	return result

func canvas() -> PackedFloat32Array:
	var viewport := SubViewport.new()
	viewport.size = Vector2i(256, 257)
	viewport.transparent_bg = true # or there is no alpha to write to
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	viewport.add_child(rectangle(false))
	add_child(viewport)
	for frame in 3:
		await RenderingServer.frame_post_draw
	return viewport.get_texture().get_image().get_data().to_float32_array()

func compute() -> PackedFloat32Array:
	var device := RenderingServer.create_local_rendering_device()
	var source := RDShaderSource.new()
	source.source_compute = FileAccess.get_file_as_string("res://noise.comp") \
		.replace('#include "gabor_lattice.glsl"', FileAccess.get_file_as_string("res://gabor_lattice.glsl"))
	var spirv := device.shader_compile_spirv_from_source(source)
	var shader := device.shader_create_from_spirv(spirv)
	var size := 4 * 256 * 257
	var buffer := device.storage_buffer_create(size)
	var uniform := RDUniform.new()
	uniform.uniform_type = RenderingDevice.UNIFORM_TYPE_STORAGE_BUFFER
	uniform.add_id(buffer)
	var list := device.compute_list_begin()
	device.compute_list_bind_compute_pipeline(list, device.compute_pipeline_create(shader))
	device.compute_list_bind_uniform_set(list, device.uniform_set_create([uniform], shader, 0), 0)
	device.compute_list_dispatch(list, 32, 257, 1)
	device.compute_list_end()
	device.submit()
	device.sync()
	var values := device.buffer_get_data(buffer).to_float32_array()
	device.free_rid(buffer)
	device.free_rid(shader)
	device.free()
	return values
