"""Runs clang-tidy on host/ with the checks of .clang-tidy: test_tidy.py BUILD_FOLDER, which has compile_commands.json.

BUILD_FOLDER/tidy remembers the files that passed, by a digest of their contents and of every project header that they
include, so that only changed files are checked again."""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).parents[2]
BUILD = pathlib.Path(sys.argv[1])
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)


def contents(path, folders, seen):
    """Collects the contents of a file and of the project's headers that it includes."""
    if path in seen:
        return []
    seen.add(path)
    text = path.read_text()
    found = (folder / name for name in INCLUDE.findall(text) for folder in (path.parent, *folders))
    return [text] + [part for header in found if header.is_file() for part in contents(header.resolve(), folders, seen)]


def check(command, shared):
    path = pathlib.Path(command["file"])
    folders = [pathlib.Path(folder) for folder in re.findall(r"-I(\S+)", command["command"])]
    decides = "\0".join([shared, command["command"], *contents(path, folders, set())])
    stamp = BUILD / "tidy" / hashlib.sha256(decides.encode()).hexdigest()
    if stamp.exists():
        return ""
    result = subprocess.run(["clang-tidy", "-p", BUILD, "--quiet", path], capture_output=True, text=True)
    if result.returncode == 0:
        stamp.touch()
        return ""
    return result.stdout or result.stderr


version = subprocess.run(["clang-tidy", "--version"], capture_output=True, text=True, check=True).stdout
shared = version + (ROOT / ".clang-tidy").read_text()
host = [command for command in json.loads((BUILD / "compile_commands.json").read_text())
        if pathlib.Path(command["file"]).is_relative_to(ROOT / "host")]
assert len(host) > 20, "no compile commands for host/"
(BUILD / "tidy").mkdir(exist_ok=True)
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    found = list(filter(None, pool.map(lambda command: check(command, shared), host)))
print(*found, sep="\n")
print(f"{len(host)} files, {len(found)} with findings")
sys.exit(bool(found))
