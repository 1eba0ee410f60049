"""Compiles HLSL to SPIR-V with the DirectX shader compiler, whose library is at GABOR_DXC: dxc.py SHADER.hlsl SHADER.spv
OPTION..."""

import ctypes
import os
import pathlib
import sys
import uuid

COMPILER = uuid.UUID("73e22d93-e6ce-47f3-b5bf-f0664f39c1b0")
COMPILER_3 = uuid.UUID("228b4687-5a6a-4730-900c-9702b2203f54")
RESULT = uuid.UUID("58346cda-dde7-4497-9461-6f87af5e0659")


class Text(ctypes.Structure):
    _fields_ = [("start", ctypes.c_char_p), ("size", ctypes.c_size_t), ("encoding", ctypes.c_uint)]


def method(pointer, number, result, *types):
    """Returns an object's method by its index in the vtable, after the five common entries: IUnknown's three methods
    and, outside Windows, two destructors."""
    table = ctypes.cast(pointer, ctypes.POINTER(ctypes.POINTER(ctypes.c_void_p)))[0]
    call = ctypes.CFUNCTYPE(result, ctypes.c_void_p, *types)(table[5 + number])
    return lambda *arguments: call(pointer, *arguments)


def contents(blob):
    return ctypes.string_at(method(blob, 0, ctypes.c_void_p)(), method(blob, 1, ctypes.c_size_t)())


def compiled(library, source, options):
    """Compiles a compute shader to SPIR-V. Raises ValueError with the compiler's message."""
    compiler, result, part, status = ctypes.c_void_p(), ctypes.c_void_p(), ctypes.c_void_p(), ctypes.c_uint()
    ctypes.CDLL(library).DxcCreateInstance(COMPILER.bytes_le, COMPILER_3.bytes_le, ctypes.byref(compiler))
    options = ["-spirv", "-T", "cs_6_0", "-E", "main", "-Wall", "-Wextra", "-WX", *options]
    method(compiler, 0, ctypes.c_uint, *[ctypes.c_void_p] * 2, ctypes.c_uint, *[ctypes.c_void_p] * 3)(
        ctypes.byref(Text(source, len(source), 65001)), (ctypes.c_wchar_p * len(options))(*options), len(options), None,
        RESULT.bytes_le, ctypes.byref(result))
    method(result, 0, ctypes.c_uint, ctypes.c_void_p)(ctypes.byref(status))
    method(result, 2 if status.value else 1, ctypes.c_uint, ctypes.c_void_p)(ctypes.byref(part))
    if status.value:
        raise ValueError(contents(part).decode())
    return contents(part)


if __name__ == "__main__":
    shader, spirv, *options = sys.argv[1:]
    try:
        pathlib.Path(spirv).write_bytes(compiled(os.environ["GABOR_DXC"], pathlib.Path(shader).read_bytes(), options))
    except ValueError as error:
        sys.exit(str(error))
