"""Runs the Slang compiler from the library in the Python package slangpy: slangc.py FILE.slang ENTRY STAGE FILE.spv"""

import ctypes
import importlib.util
import pathlib
import struct
import sys

SPIRV, SLANG, STAGES = 6, 1, {"vertex": 1, "fragment": 5, "compute": 6} # values from slang.h


def library():
    """Returns the library's path, or None if slangpy is not installed."""
    found = importlib.util.find_spec("slangpy")
    return next(pathlib.Path(found.origin).parent.glob("libslang-compiler.so*"), None) if found else None


def main():
    source, entry, stage, output = sys.argv[1:]
    slang = ctypes.CDLL(str(library()))
    slang.spCreateSession.restype = slang.spCreateCompileRequest.restype = ctypes.c_void_p
    slang.spGetEntryPointCode.restype = ctypes.c_void_p
    slang.spGetDiagnosticOutput.restype = ctypes.c_char_p
    session = ctypes.c_void_p(slang.spCreateSession(None))
    request = ctypes.c_void_p(slang.spCreateCompileRequest(session))
    target = slang.spAddCodeGenTarget(request, SPIRV)
    slang.spSetTargetProfile(request, target, slang.spFindProfile(session, b"spirv_1_5"))
    unit = slang.spAddTranslationUnit(request, SLANG, None)
    slang.spAddTranslationUnitSourceFile(request, unit, source.encode())
    slang.spAddEntryPoint(request, unit, entry.encode(), STAGES[stage])
    failed = slang.spCompile(request) < 0
    print(slang.spGetDiagnosticOutput(request).decode(), end="", file=sys.stderr)
    if not failed:
        size = ctypes.c_size_t()
        code = slang.spGetEntryPointCode(request, 0, ctypes.byref(size))
        # OpSource names Slang, language 11, which the SPIRV-Tools of Debian 12 refuse: 0 is no language.
        named, unnamed = (struct.pack("<2I", 3 << 16 | 3, language) for language in (11, 0))
        pathlib.Path(output).write_bytes(ctypes.string_at(code, size.value).replace(named, unnamed))
    return failed


if __name__ == "__main__":
    sys.exit(main())
