"""The part of bpy that shaders/nodes/blender/gabor_noise uses, evaluated with numpy: a vector is an array of 3 x points."""

import sys
import types

import numpy as np


class NodeSocket:
    """An input or an output."""

    def __init__(self, node):
        self.node, self.default_value, self.source = node, 0.0, None


class Sockets(dict):
    """Makes a socket for each name or number that is asked for."""

    def __init__(self, node):
        self.node = node

    def __missing__(self, key):
        self[key] = NodeSocket(self.node)
        return self[key]

    def __iter__(self):
        return (self[key] for key in range(3))


def white_noise(vector, w):
    """Returns three numbers from 0 to 1."""
    return np.modf(np.abs(np.sin(np.array([[12.9898, 78.233, 1], [39.346, 11.135, 2], [73.156, 52.235, 3]]) @ vector + w)) * 43758.5453)[0]


ADD, MULTIPLY = (lambda a, b, c: a + b), (lambda a, b, c: a * b)
OPERATIONS = {"ADD": ADD, "MULTIPLY": MULTIPLY, "MULTIPLY_ADD": lambda a, b, c: a * b + c, "SUBTRACT": lambda a, b, c: a - b,
              "MINIMUM": lambda a, b, c: np.minimum(a, b), "MAXIMUM": lambda a, b, c: np.maximum(a, b),
              "COSINE": lambda a, b, c: np.cos(a), "SINE": lambda a, b, c: np.sin(a), "FRACT": lambda a, b, c: a - np.floor(a),
              "FLOOR": lambda a, b, c: np.floor(a), "SQRT": lambda a, b, c: np.sqrt(a), "ABSOLUTE": lambda a, b, c: np.abs(a),
              "ARCTAN2": lambda a, b, c: np.arctan2(a, b), "DOT_PRODUCT": lambda a, b, c: (a * b).sum(0)}


class Node:
    def __init__(self, kind):
        self.kind, self.inputs, self.outputs = kind.removeprefix("ShaderNode"), Sockets(self), Sockets(self)

    def value(self, output, given):
        """Returns an output, where `given` are the inputs of the group."""
        def read(key):
            put = self.inputs[key]
            if put.source:
                name = next(name for name, socket in put.source.node.outputs.items() if socket is put.source)
                return put.source.node.value(name, given)
            return np.array(put.default_value)[:, None] if isinstance(put.default_value, tuple) else put.default_value
        if self.kind == "NodeGroupInput":
            return given[output]
        if self.kind == "Group":
            return self.node_tree.value(output, {name: read(name) for name in self.inputs.keys()})
        if self.kind == "TexWhiteNoise":
            return white_noise(read("Vector"), read("W"))
        if self.kind == "SeparateXYZ":
            return read(0)[output]
        if self.kind == "CombineXYZ":
            return np.array(np.broadcast_arrays(*map(read, range(3)))).reshape(3, -1)
        if self.kind == "Clamp":
            return np.clip(read(0), 0, 1)
        if self.operation == "SCALE":
            return read(0) * read("Scale")
        return OPERATIONS[self.operation](*map(read, range(3)))


class Tree:
    def __init__(self, *_):
        self.nodes = self
        self.all = []
        self.links = types.SimpleNamespace(new=lambda source, put: setattr(put, "source", source))
        self.sockets = []
        self.interface = types.SimpleNamespace(new_socket=self.new_socket, items_tree=self)

    def new_socket(self, name, in_out, socket_type):
        self.sockets.append(types.SimpleNamespace(name=name, in_out=in_out, socket_type=socket_type))
        return self.sockets[-1]

    def __getitem__(self, name):
        return next(each for each in self.sockets if each.name == name)

    def new(self, kind):
        self.all.append(Node(kind))
        return self.all[-1]

    def __iter__(self):
        return iter(self.all)

    def value(self, output, given):
        result, = (node for node in self.all if node.kind == "NodeGroupOutput")
        put = result.inputs[output]
        name = next(name for name, socket in put.source.node.outputs.items() if socket is put.source)
        return put.source.node.value(name, given)


class Groups(dict):
    def new(self, name, kind):
        self[name] = Tree()
        return self[name]


bpy = sys.modules["bpy"] = types.ModuleType("bpy")
bpy.data = types.SimpleNamespace(node_groups=Groups())
bpy.types = types.SimpleNamespace(NodeSocket=NodeSocket, Operator=object)
