"""Runs a script with gabor_noise, whose native module is a library made of native.cpp, because the wheel's needs nanobind:
native.py LIBRARY PACKAGE SCRIPT [ARGUMENT...], where PACKAGE is a folder that tools/package pypi --stage wrote."""

import ast
import ctypes
import runpy
import sys
import types

import numpy as np

library, folder = ctypes.CDLL(sys.argv[1]), sys.argv[2]
library.gabor_attributes.restype = ctypes.c_char_p
library.gabor_seed_derived.restype = ctypes.c_uint32


def pointer(array):
    return ctypes.c_void_p(array.ctypes.data)


def evaluate(name, arrays, out, workers):
    assert out.flags.c_contiguous and all(array.dtype == np.float64 for array in arrays)
    count = len(arrays)
    strides = np.array([[stride // 8 for stride in array.strides] for array in arrays], np.int64)
    outs = [pointer(out), None] if out.dtype == np.float32 else [None, pointer(out)]
    library.gabor_evaluate(name.encode(), ctypes.c_size_t(count), (ctypes.c_void_p * count)(*(array.ctypes.data for array in arrays)),
                           ctypes.c_size_t(arrays[0].ndim), pointer(np.array(arrays[0].shape, np.uintp)), pointer(strides), *outs,
                           ctypes.c_size_t(out.size), ctypes.c_size_t(workers))


def fill_grid(out, first, waves, seeds, period, evolution, workers):
    assert out.dtype == np.float32 and out.flags.c_contiguous
    waves, seeds = np.array(waves, float), np.array(seeds, np.uint32)
    library.gabor_fill_grid(pointer(out), *map(ctypes.c_size_t, out.shape), pointer(np.array(first, float)), ctypes.c_size_t(len(waves)),
                            pointer(waves), pointer(seeds), pointer(np.array(period, np.float32)), ctypes.c_double(evolution),
                            ctypes.c_size_t(workers))


native = sys.modules["gabor_noise._native"] = types.ModuleType("gabor_noise._native")
vars(native).update(ast.literal_eval(library.gabor_attributes().decode()), evaluate=evaluate, fill_grid=fill_grid,
                    derived_seed=lambda seed, index: library.gabor_seed_derived(ctypes.c_uint32(seed), ctypes.c_int(index)))
sys.path.insert(0, folder)
sys.argv[:3] = []
runpy.run_path(sys.argv[0], run_name="__main__")
