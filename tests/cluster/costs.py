"""Measures the cost of textures and of pictures of 16384 x 16384 pixels, for the tables of docs/farm.md.

tools/test-long farm runs it. Needs what test_cluster.py needs, GNU time, and 4 GiB of disk; each method's picture is
compared with the first one's. CPU seconds include all processes, also Slurm's own, and depend little on other load.
"""

import contextlib
import ctypes
import filecmp
import os
import pathlib
import statistics
import subprocess
import tempfile
import time

import slurm

CLUSTER = pathlib.Path(__file__).parents[2] / "tools" / "cluster"
PROGRAM = os.environ["GABOR_PROGRAM"]
SIDE, STRIPS = 16384, 16
OPTIONS = "--scale=32 --frequency=4 --seed=7"
SLURM = ["--executor", "slurm", "--jobs", "20", "--default-resources", "slurm_partition=farm", "mem_mb=400", "runtime=30",
         "--slurm-status-command", "squeue", "--slurm-init-seconds-before-status-checks", "5", "--latency-wait", "30"]
ADOPTS_ORPHANS = 36 # PR_SET_CHILD_SUBREAPER of Linux's prctl


def cost(work, within=contextlib.nullcontext()):
    """The seconds that `work` takes, and the CPU seconds of all its processes, including orphans."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        ctypes.CDLL(None).prctl(ADOPTS_ORPHANS, 1)
        with within:
            began = time.monotonic()
            work()
            os.write(writing, str(time.monotonic() - began).encode())
        with contextlib.suppress(ChildProcessError):
            while True:
                os.wait()
        os._exit(0)
    os.close(writing)
    _, status, usage = os.wait4(child, 0)
    assert status == 0, "the work failed"
    with open(reading) as elapsed:
        return float(elapsed.read()), usage.ru_utime + usage.ru_stime


def sh(*command, **environment):
    with open("log", "a") as log:
        subprocess.run(list(map(str, command)), check=True, stdout=log, stderr=log, env=os.environ | environment)


def gabor(*arguments):
    """Writes the peak memory in KiB to the file `memory`."""
    sh("time", "-a", "-o", "memory", "-f", "%M", PROGRAM, *arguments)


def memory():
    kibibytes = max(map(int, pathlib.Path("memory").read_text().split()))
    pathlib.Path("memory").unlink()
    assert kibibytes < 512 << 10, "memory grows with the picture"
    return f"{kibibytes / 1024:.0f} MiB"


def render(window, output):
    gabor("render", f"--size={SIDE}x{SIDE}", *OPTIONS.split(), f"--region={','.join(map(str, window))}", "-o", output)


def tiles(across, down):
    width, height = SIDE // across, SIDE // down
    return [(x * width, y * height, width, height) for y in range(down) for x in range(across)]


def pieces(across, down):
    for window in tiles(across, down):
        render(window, f"piece{window[0]}.{window[1]}.exr")


def join():
    gabor("join", *sorted(map(str, pathlib.Path().glob("piece*.exr"))), "-o", "grain.exr")


def snakemake(*options):
    sh(CLUSTER / "run", "farm.yaml", *options)


def killed_and_resumed():
    with open("log", "a") as log:
        run = subprocess.Popen([CLUSTER / "run", "farm.yaml", *SLURM], stdout=log, stderr=log)
    slurm.wait_for(lambda: len(list(pathlib.Path("strips").glob("*.exr"))) >= 5, 600)
    run.kill()
    run.wait()
    snakemake(*SLURM)


def compared():
    """Checks that the output is the picture, and removes it."""
    first, made = pathlib.Path("first.exr"), pathlib.Path("grain.exr")
    if not first.exists():
        made.rename(first)
    assert not made.exists() or filecmp.cmp(first, made, shallow=False)
    for path in (made, *pathlib.Path().glob("piece*.exr")):
        path.unlink(missing_ok=True)


def row(*columns):
    print("| " + " | ".join(columns) + " |", flush=True)


def by_hand():
    row("by hand", "elapsed", "CPU", "memory")
    row(*["---"] * 4)
    for name, across, down in (("at once", 1, 1), ("16 strips", 1, STRIPS), ("4 quadrants", 2, 2)):
        if across * down == 1:
            elapsed, cpu = cost(lambda: render((0, 0, SIDE, SIDE), "grain.exr"))
            row(name, f"{elapsed:.1f} s", f"{cpu:.1f} s", memory())
        else:
            for step, work in ((name, lambda: pieces(across, down)), ("and join them", join)):
                elapsed, cpu = cost(work)
                row(step, f"{elapsed:.1f} s", f"{cpu:.1f} s", memory())
        compared()


def textures():
    """Times the texture with all levels and the filtered flat picture alternately, so that other load affects both."""
    row("texture", "CPU", "the filtered picture alone", "ratio", "memory")
    row(*["---"] * 5)
    for side, rounds in ((1024, 5), (4096, 3), (16384, 1)):
        noise = f"--size={side}x{side}", "--scale=32", "--frequency=2", "--tileable", "-o"
        flat, whole = zip(*((cost(lambda: gabor("render", "--filter", *noise, "flat.exr"))[1],
                             cost(lambda: gabor("render", "--texture", *noise, "texture.exr"))[1]) for _ in range(rounds)))
        flat, whole = statistics.median(flat), statistics.median(whole)
        row(f"{side} x {side}", f"{whole:.1f} s", f"{flat:.1f} s", f"{whole / flat:.2f}", memory())
        pathlib.Path("flat.exr").unlink()
        pathlib.Path("texture.exr").unlink()


def by_engines():
    pathlib.Path("farm.yaml").write_text(
        f"gabor: {PROGRAM}\npictures: {{grain: {{size: {SIDE}x{SIDE}, strips: {STRIPS}, options: {OPTIONS}}}}}\n")
    row("16 strips, and join them", "elapsed", "CPU")
    row(*["---"] * 3)
    array = [CLUSTER / "array", f"{SIDE}x{SIDE}", STRIPS, "grain.exr", *OPTIONS.split()]
    for name, work, on_slurm in (("Snakemake, on one machine", lambda: snakemake("--cores", "2"), False),
                                 ("an array of Slurm", lambda: sh(*array, GABOR=PROGRAM), True),
                                 ("Snakemake on Slurm", lambda: snakemake(*SLURM), True),
                                 ("killed after five, and again", killed_and_resumed, True)):
        with tempfile.TemporaryDirectory(prefix="gabor-") as state:
            elapsed, cpu = cost(work, slurm.cluster(pathlib.Path(state)) if on_slurm else contextlib.nullcontext())
        row(name, f"{elapsed:.1f} s", f"{cpu:.1f} s")
        compared()

    empty = pathlib.Path("empty")
    empty.write_text('#!/bin/sh\nfor output; do :; done\n: >"$output"\n')
    empty.chmod(0o755)
    pathlib.Path("farm.yaml").write_text("gabor: ./empty\nframes: {none: {size: 1x1, frames: 200, options: ''}}\n")
    elapsed, cpu = cost(lambda: snakemake("--cores", "2"))
    assert len(list(pathlib.Path().glob("none.*.exr"))) == 200
    row("Snakemake on one machine, 200 empty tasks", f"{elapsed:.1f} s", f"{cpu:.1f} s")


def main():
    if missing := slurm.missing():
        print(f"costs: {missing}")
        return
    with tempfile.TemporaryDirectory(prefix="gabor-") as name:
        os.chdir(name)
        os.environ["GABOR_VALIDATION"] = "0"
        print(f"{os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}\n")
        by_hand()
        print()
        textures()
        print()
        by_engines()
        print(f"\nload {os.getloadavg()[0]:.1f}")


main()
