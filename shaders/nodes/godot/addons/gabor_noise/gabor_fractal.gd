@tool
class_name VisualShaderNodeGaborFractal
extends VisualShaderNodeCustom
## fBm, billows or ridges for visual shaders, with mean 0 and variance 1, and their gradient per kernel radius. The place
## is in kernel radii (UV * 8 if unconnected); the last octave fades in with the fraction of the octaves.

const NAMES := ["place", "octaves", "gain", "seed"]
const TYPES := [PORT_TYPE_VECTOR_2D, PORT_TYPE_SCALAR, PORT_TYPE_SCALAR, PORT_TYPE_SCALAR_INT]
const DEFAULTS := [null, 5.0, 0.5, 7]
const CHOICES := ["Shape", "Basis", "Filter"]
# Shapes and bases stand in the order of the constants in the included file; the pixel exists in fragment functions alone.
const OPTIONS := [["fBm", "Billows", "Ridges"], ["Smooth", "Perlin"], ["None", "Pixel"]]

func _get_name() -> String:
	return "GaborFractal"

func _get_category() -> String:
	return "Textures/Noise"

func _get_description() -> String:
	return "fBm, billows or ridges: mean 0, variance 1"

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
	return ["noise", "gradient"][port]

func _get_output_port_type(port: int) -> PortType:
	return [PORT_TYPE_SCALAR, PORT_TYPE_VECTOR_2D][port]

func _get_property_count() -> int:
	return CHOICES.size()

func _get_property_name(index: int) -> String:
	return CHOICES[index]

func _get_property_default_index(_index: int) -> int:
	return 0

func _get_property_options(index: int) -> PackedStringArray:
	return PackedStringArray(OPTIONS[index])

func _get_global_code(_mode: Shader.Mode) -> String:
	return '#include "res://addons/gabor_noise/gabor_fractal.gdshaderinc"'

func _get_code(inputs: Array[String], outputs: Array[String], mode: Shader.Mode, type: VisualShader.Type) -> String:
	if inputs[0].is_empty(): # the place is not connected; skies, fog and particles have no UV
		inputs[0] = "UV * 8.0" if mode in [Shader.MODE_CANVAS_ITEM, Shader.MODE_SPATIAL] else "vec2(0.0)"
	var filtered := get_option_index(2) == 1 and type == VisualShader.TYPE_FRAGMENT
	var function := "_filtered(gabor_place_at(place), dFdx(place), dFdy(place), " if filtered else "(gabor_place_at(place), "
	var choices := [get_option_index(0), get_option_index(1), function]
	return "vec2 place = %s;\nGaborFractal fractal = gabor_fractal(%s, %s);\nuint seed = uint(%s);\nfractal.shape = %d;\nfractal.basis = %d;\nGaborFractalNoise gabor = gabor_fractal_noise%sfractal, seed);\n%s = gabor.noise;\n%s = gabor.gradient;" % (inputs + choices + outputs)
