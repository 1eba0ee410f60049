"""Evaluates noises of public packages, which it installs in build/noises, for the pictures of tools/gallery."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[1]
FOLDER = ROOT / "build" / "noises"
PYTHON = "noise==1.2.2", "pyfastnoiselite==0.0.7"
NODE = "simplex-noise@4.0.3", "p5@1.11.2"

# For each noise, the language of its package, an expression of x and y in the noise's cells, its mean and deviation, and the
# centroid of its spectrum in cycles per cell.
NOISES = {
    "Perlin": ("py", "noise.pnoise2(x, y, base=7)", 0, 0.243, 0.615),
    "simplex": ("js", "simplex(x, y)", 0, 0.440, 1.02),
    "OpenSimplex2": ("py", "open_simplex.get_noise(x, y)", 0, 0.542, 1.02),
    "p5": ("js", "p5.noise(x, y)", 0.466, 0.125, 0.514),
    "Perlin fBm": ("py", "noise.pnoise2(x, y, octaves=5, base=7)", 0, 0.145, 0.90),
    "simplex fBm": ("js", "[0, 1, 2, 3, 4].reduce((sum, i) => sum + simplex(x * 2 ** i, y * 2 ** i) / 2 ** i, 0)", 0, 0.511, 1.47),
    "OpenSimplex2 fBm": ("py", "fractal.get_noise(x, y)", 0, 0.324, 1.47),
}

CODE = {"py": """
import sys
import numpy as np
import noise
from pyfastnoiselite.pyfastnoiselite import FastNoiseLite, FractalType, NoiseType
open_simplex, fractal = FastNoiseLite(7), FastNoiseLite(7)
for each in open_simplex, fractal:
    each.frequency, each.noise_type = 1.0, NoiseType.NoiseType_OpenSimplex2
fractal.fractal_type, fractal.fractal_octaves = FractalType.FractalType_FBm, 5
places = np.fromfile(sys.argv[1]).reshape(-1, 2)
np.array([NOISE for x, y in places]).tofile(sys.argv[2])
""", "js": """
const { readFileSync, writeFileSync } = require("fs");
const { createNoise2D } = require("simplex-noise");
let word = 7;
const simplex = createNoise2D(() => (word = (Math.imul(word, 1664525) + 1013904223) >>> 0) / 2 ** 32);
const source = readFileSync(require.resolve("p5/lib/p5.js"), "utf8");
const start = source.indexOf("var PERLIN_YWRAPB"), p5 = {};  // p5 needs a browser, and its module of noise does not
new Function("_main", source.slice(start, source.indexOf("var _default", start)))({ default: { prototype: p5 } });
p5.noiseSeed(7);
const places = new Float64Array(new Uint8Array(readFileSync(process.argv[2])).buffer);
const values = new Float64Array(places.length / 2);
for (let i = 0; i < values.length; ++i) {
    const x = places[2 * i], y = places[2 * i + 1];
    values[i] = NOISE;
}
writeFileSync(process.argv[3], new Uint8Array(values.buffer));
"""}


def install():
    """Installs the packages, once."""
    python = FOLDER / "venv" / "bin" / "python"
    if not (FOLDER / "node_modules").exists():
        if not shutil.which("npm"):
            sys.exit("gallery: pictures of other noises need npm, pip and the network")
        FOLDER.mkdir(parents=True, exist_ok=True)
        subprocess.run([sys.executable, "-m", "venv", FOLDER / "venv"], check=True)
        subprocess.run([python, "-m", "pip", "install", "-q", "--disable-pip-version-check", "numpy", *PYTHON], check=True)
        subprocess.run(["npm", "install", "--no-audit", "--no-fund", "--silent", "--prefix", FOLDER, *NODE], check=True)
    return python


def values(name, x, y):
    """Returns a noise, minus its mean and over its deviation, at places in its cells."""
    python = install()
    language, code, mean, deviation, _ = NOISES[name]
    with tempfile.TemporaryDirectory(prefix="gabor-") as folder:
        places, result = (pathlib.Path(folder) / each for each in ("places", "result"))
        np.stack([x, y], -1).astype(float).tofile(places)
        script = pathlib.Path(folder) / f"script.{language}"
        script.write_text(CODE[language].replace("NOISE", code))
        subprocess.run([python if language == "py" else "node", script, places, result], check=True, env={**os.environ, "NODE_PATH": FOLDER / "node_modules"})
        return (np.fromfile(result).reshape(x.shape) - mean) / deviation
