extends Node
## Shows the noise with a canvas shader. With arguments, draws it into a viewport with a canvas shader or the addon's node, or
## into a buffer with a compute shader, and writes the values: godot --path . [-- VALUES.raw canvas|node|compute]

func _ready() -> void:
	var arguments := OS.get_cmdline_user_args()
	if arguments.is_empty():
		add_child(rectangle(load("res://noise.gdshader"), true))
		return
	var node := arguments[1] == "node"
	var values := compute() if arguments[1] == "compute" else await canvas(visual("noise", true) if node else load("res://noise.gdshader"))
	if node: # its default position, UV * 8, is the same here
		values.resize(256 * 256)
		var unconnected := await canvas(visual("noise", false))
		for i in values.size():
			if not absf(unconnected[i] - values[i]) < 1e-4:
				OS.crash("unconnected: %s instead of %s at %d" % [unconnected[i], values[i], i])
		values.append_array((await canvas(visual("fractal", true))).slice(0, 256 * 256))
	FileAccess.open("res://" + arguments[0], FileAccess.WRITE).store_buffer(values.to_byte_array())
	var facts := {
		engine = "Godot", version = Engine.get_version_info().string,
		dialect = {compute = "GLSL 450, compute", canvas = "Godot, canvas", node = "Godot, visual shader"}[arguments[1]],
		driver = "%s, %s" % [RenderingServer.get_video_adapter_name(), RenderingServer.get_current_rendering_method()],
	}
	if node:
		facts.functions = ["noise", "fbm"]
	print(JSON.stringify(facts))
	get_tree().quit()

func rectangle(shader: Shader, shown: bool) -> ColorRect:
	var result := ColorRect.new()
	result.size = Vector2(256, 256 if shader is VisualShader else 257)
	result.material = ShaderMaterial.new()
	result.material.shader = shader
	result.material.set_shader_parameter("shown", shown)
	return result

## Makes a visual shader with one of the addon's nodes, a node for its position, which may stay unconnected, and a node that writes the
## noise's 32 bits as four bytes.
func visual(kind: String, connected: bool) -> VisualShader:
	var shader := VisualShader.new()
	shader.set_mode(Shader.MODE_CANVAS_ITEM)
	shader.set("modes/blend", 5) # disabled
	shader.set("flags/unshaded", true)
	var place := VisualShaderNodeExpression.new()
	place.add_output_port(0, VisualShaderNode.PORT_TYPE_VECTOR_2D, "place")
	place.expression = "place = FRAGCOORD.xy / 32.0;"
	var bytes := VisualShaderNodeExpression.new()
	bytes.add_input_port(0, VisualShaderNode.PORT_TYPE_SCALAR, "noise")
	bytes.add_output_port(0, VisualShaderNode.PORT_TYPE_VECTOR_3D, "colour")
	bytes.add_output_port(1, VisualShaderNode.PORT_TYPE_SCALAR, "alpha")
	bytes.expression = """uint bits = floatBitsToUint(noise);
		colour = vec3(uvec3(bits, bits >> 8u, bits >> 16u) & uvec3(255u)) / 255.0;
		alpha = float(bits >> 24u) / 255.0;"""
	var noise: VisualShaderNodeCustom = load("res://addons/gabor_noise/gabor_%s.gd" % kind).new()
	for port in noise._get_input_port_count(): # as the editor does
		if noise._get_input_port_default_value(port) != null:
			noise.set_input_port_default_value(port, noise._get_input_port_default_value(port))
	if kind == "fractal":
		noise.set_input_port_default_value(1, 3.3)
	var nodes := [place, noise, bytes]
	for i in nodes.size():
		shader.add_node(VisualShader.TYPE_FRAGMENT, nodes[i], Vector2(300 * i, 0), i + 2)
	if connected:
		shader.connect_nodes(VisualShader.TYPE_FRAGMENT, 2, 0, 3, 0)
	shader.connect_nodes(VisualShader.TYPE_FRAGMENT, 3, 0, 4, 0)
	shader.connect_nodes(VisualShader.TYPE_FRAGMENT, 4, 0, 0, 0)
	shader.connect_nodes(VisualShader.TYPE_FRAGMENT, 4, 1, 0, 1)
	return shader

func canvas(shader: Shader) -> PackedFloat32Array:
	var viewport := SubViewport.new()
	viewport.size = Vector2i(256, 257)
	viewport.transparent_bg = true # otherwise there is no alpha to write to
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	viewport.add_child(rectangle(shader, false))
	add_child(viewport)
	for frame in 3:
		await RenderingServer.frame_post_draw
	return viewport.get_texture().get_image().get_data().to_float32_array()

func compute() -> PackedFloat32Array:
	var device := RenderingServer.create_local_rendering_device()
	var source := RDShaderSource.new()
	source.source_compute = FileAccess.get_file_as_string("res://noise.comp") \
		.replace('#include "gabor_noise.glsl"', FileAccess.get_file_as_string("res://gabor_noise.glsl"))
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
