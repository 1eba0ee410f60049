# Adds Gabor noise, as a group of Blender's own nodes, to the shader editor: Add > Texture > Gabor Noise (Normalized).
#
# It computes the same sum as gabor_noise.glsl with three taps, so its values have the same distribution. But shader
# nodes have no integers to hash, so White Noise nodes supply other amplitudes.
#
# Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

import math

import bpy

NODE, FIELD = "Gabor Noise Node", "Gabor Noise (Normalized)"
# Each part of an amplitude is nearly normal: (u - 0.893 clamp(u, -0.937, 0.937)) (1 + 0.623 u^2), u uniform in [-1, 1].
SLOPE, KNEE, SQUARE, DEVIATION = 0.89289313, 0.93687596, 0.62342056, 0.09190329


class Builder:
    """Builds a node group. A value is a socket, a number or a tuple of numbers."""

    def __init__(self, name, inputs, outputs):
        self.tree = bpy.data.node_groups.new(name, "ShaderNodeTree")
        for way, sockets in (("INPUT", inputs), ("OUTPUT", outputs)):
            for socket, kind, *default in sockets:
                made = self.tree.interface.new_socket(socket, in_out=way, socket_type=f"NodeSocket{kind}")
                if default:
                    made.default_value = default[0]
        self.given = self.tree.nodes.new("NodeGroupInput").outputs
        self.result = self.tree.nodes.new("NodeGroupOutput").inputs

    def node(self, kind, *values, **properties):
        node = self.tree.nodes.new(f"ShaderNode{kind}")
        for name, value in properties.items():
            setattr(node, name, value)
        for value, put in zip(values, node.inputs):
            self.put(value, put)
        return node.outputs

    def put(self, value, put):
        if isinstance(value, bpy.types.NodeSocket):
            self.tree.links.new(value, put)
        else:
            put.default_value = value

    def math(self, operation, *values):
        return self.node("Math", *values, operation=operation)[0]

    def vector(self, operation, *values):
        return self.node("VectorMath", *values, operation=operation)[0]

    def scaled(self, vector, factor):
        node = self.tree.nodes.new("ShaderNodeVectorMath")
        node.operation = "SCALE"
        self.put(vector, node.inputs[0])
        self.put(factor, node.inputs["Scale"])
        return node.outputs[0]

    def dot(self, a, b):
        return self.node("VectorMath", a, b, operation="DOT_PRODUCT")["Value"]

    def arranged(self):
        """Arranges nodes in columns, so that they do not overlap."""
        for index, node in enumerate(self.tree.nodes):
            node.location = 180 * (index // 8), -180 * (index % 8)
        return self.tree


def node_group():
    """Makes the group that computes the cosine and sine of one lattice node's wave, at an offset in kernel radii."""
    b = Builder(NODE, [("Offset", "Vector"), ("Wave", "Vector"), ("Node", "Vector"), ("Seed", "Float")],
                [("Cosine", "Float"), ("Sine", "Float")])
    offset, wave, place, seed = (b.given[name] for name in ("Offset", "Wave", "Node", "Seed"))
    white = b.tree.nodes.new("ShaderNodeTexWhiteNoise")
    white.noise_dimensions = "4D"
    b.put(place, white.inputs["Vector"])
    b.put(seed, white.inputs["W"])
    u = b.vector("MULTIPLY_ADD", white.outputs["Color"], (2, 2, 2), (-1, -1, -1))
    inner = b.vector("MINIMUM", b.vector("MAXIMUM", u, (-KNEE,) * 3), (KNEE,) * 3)
    law = b.vector("MULTIPLY", b.vector("SUBTRACT", u, b.scaled(inner, SLOPE)),
                   b.vector("MULTIPLY_ADD", b.vector("MULTIPLY", u, u), (SQUARE,) * 3, (1, 1, 1)))
    parts = b.node("SeparateXYZ", law)

    # Hann's windows along x and y, divided by the amplitude's standard deviation and by the sum of squared windows, 9/8.
    cosines = b.node("SeparateXYZ", b.vector("COSINE", b.scaled(offset, math.pi)))
    window = b.math("MULTIPLY", *(b.math("MULTIPLY_ADD", cosines[axis], 0.5, 0.5) for axis in (0, 1)))
    window = b.math("MULTIPLY", window, 1 / (DEVIATION * 1.125))
    phase = b.math("MULTIPLY", b.math("FRACT", b.dot(wave, offset)), 2 * math.pi)
    cosine, sine = (b.math("MULTIPLY", b.math(wanted, phase), window) for wanted in ("COSINE", "SINE"))
    b.put(b.math("SUBTRACT", b.math("MULTIPLY", parts[0], cosine), b.math("MULTIPLY", parts[1], sine)), b.result["Cosine"])
    b.put(b.math("MULTIPLY_ADD", parts[0], sine, b.math("MULTIPLY", parts[1], cosine)), b.result["Sine"])
    return b.arranged()


def field_group():
    """Makes, once per file, the group that sums the waves of the 3 x 3 lattice nodes around a point."""
    if FIELD in bpy.data.node_groups:
        return bpy.data.node_groups[FIELD]
    one = node_group()
    b = Builder(FIELD, [("Vector", "Vector"), ("Scale", "Float", 5.0), ("Frequency", "Float", 2.0),
                        ("Orientation", "Float", math.pi / 4), ("Seed", "Float", 0.0)],
                [("Value", "Float"), ("Phase", "Float"), ("Intensity", "Float"), ("Noise", "Float"), ("Quadrature", "Float")])
    b.tree.interface.items_tree["Orientation"].subtype = "ANGLE"
    place = b.vector("MULTIPLY", b.scaled(b.given["Vector"], b.given["Scale"]), (1.5, 1.5, 0))  # in node spacings
    nearest = b.vector("FLOOR", b.vector("ADD", place, (0.5, 0.5, 0)))
    offset = b.vector("SUBTRACT", place, nearest)
    direction = b.node("CombineXYZ", b.math("COSINE", b.given["Orientation"]), b.math("SINE", b.given["Orientation"]), 0.0)[0]
    wave = b.scaled(direction, b.math("ABSOLUTE", b.given["Frequency"]))
    cosine = sine = 0.0
    for j in (-1.0, 0.0, 1.0):
        for i in (-1.0, 0.0, 1.0):
            node = b.tree.nodes.new("ShaderNodeGroup")
            node.node_tree = one
            b.put(b.scaled(b.vector("SUBTRACT", offset, (i, j, 0)), 2 / 3), node.inputs["Offset"])
            b.put(wave, node.inputs["Wave"])
            b.put(b.vector("ADD", nearest, (i, j, 0)), node.inputs["Node"])
            b.put(b.given["Seed"], node.inputs["Seed"])
            cosine = b.math("ADD", cosine, node.outputs["Cosine"])
            sine = b.math("ADD", sine, node.outputs["Sine"])
    value = b.node("Clamp", b.math("MULTIPLY_ADD", sine, 0.25, 0.5))[0]
    phase = b.math("FRACT", b.math("MULTIPLY", b.math("ARCTAN2", sine, cosine), 0.5 / math.pi))
    intensity = b.math("SQRT", b.math("MULTIPLY_ADD", sine, sine, b.math("MULTIPLY", cosine, cosine)))
    for name, made in (("Value", value), ("Phase", phase), ("Intensity", intensity), ("Noise", sine), ("Quadrature", cosine)):
        b.put(made, b.result[name])
    return b.arranged()


class GABOR_OT_add(bpy.types.Operator):
    """Add normalized Gabor noise, built from Blender's own nodes"""
    bl_idname = "node.add_gabor_noise"
    bl_label = FIELD
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        space = context.space_data
        return space and space.type == "NODE_EDITOR" and space.tree_type == "ShaderNodeTree" and space.edit_tree

    def execute(self, context):
        tree = context.space_data.edit_tree
        for node in tree.nodes:
            node.select = False
        node = tree.nodes.new("ShaderNodeGroup")
        node.node_tree = field_group()
        node.location = context.space_data.cursor_location
        tree.nodes.active = node
        return {"FINISHED"}


def menu(self, _context):
    self.layout.operator(GABOR_OT_add.bl_idname)


def menus():
    """Returns a list with the shader editor's texture menu, whose name depends on Blender's version."""
    return [getattr(bpy.types, name) for name in ("NODE_MT_shader_node_add_all", "NODE_MT_category_shader_texture")
            if hasattr(bpy.types, name)][-1:]


def register():
    bpy.utils.register_class(GABOR_OT_add)
    for each in menus():
        each.append(menu)


def unregister():
    for each in menus():
        each.remove(menu)
    bpy.utils.unregister_class(GABOR_OT_add)
