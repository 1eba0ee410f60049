@tool
class_name VisualShaderNodeGaborNoise
extends VisualShaderNodeCustom
## Gabor noise for visual shaders, with mean 0 and variance 1, and its quadrature. The place is in kernel radii (UV * 8
## if unconnected), the frequency in cycles per kernel radius, the orientation in radians.

const NAMES := ["place", "frequency", "orientation", "seed"]
const TYPES := [PORT_TYPE_VECTOR_2D, PORT_TYPE_SCALAR, PORT_TYPE_SCALAR, PORT_TYPE_SCALAR_INT]
const DEFAULTS := [null, 4.0, 0.7854, 7]

func _get_name() -> String:
	return "GaborNoise"

func _get_category() -> String:
	return "Textures/Noise"

func _get_description() -> String:
	return "Gabor noise with a chosen frequency and direction: mean 0, variance 1"

func _get_return_icon_type() -> PortType:
	return PORT_TYPE_SCALAR

func _get_input_port_count() -> int:
	return NAMES.size()

func _get_input_port_name(port: int) -> String:
	return NAMES[port]

func _get_input_port_type(port: int) -> PortType:
	return TYPES[port]

func _get_input_port_default_value(port: int) -> Variant:
	return DEFAULTS[port]

func _get_output_port_count() -> int:
	return 2

func _get_output_port_name(port: int) -> String:
	return ["noise", "quadrature"][port]

func _get_output_port_type(_port: int) -> PortType:
	return PORT_TYPE_SCALAR

func _get_global_code(_mode: Shader.Mode) -> String:
	return '#include "res://addons/gabor_noise/gabor_noise.gdshaderinc"'

func _get_code(inputs: Array[String], outputs: Array[String], mode: Shader.Mode, _type: VisualShader.Type) -> String:
	if inputs[0].is_empty(): # the place is not connected; skies, fog and particles have no UV
		inputs[0] = "UV * 8.0" if mode in [Shader.MODE_CANVAS_ITEM, Shader.MODE_SPATIAL] else "vec2(0.0)"
	return "vec2 gabor = gabor_noise_quadrature(%s, %s, %s, uint(%s));\n%s = gabor.x;\n%s = gabor.y;" % (inputs + outputs)
