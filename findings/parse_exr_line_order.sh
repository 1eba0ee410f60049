#!/bin/sh
# The npm package parse-exr shifts the picture of an EXR file that is stored from bottom to top: 40 rows with ZIP
# compression come back 7 rows lower, with 7 rows of ones at the top and without their last 7 rows; 48 rows lose 15.
# Versions: parse-exr 1.0.2 (npm); OpenEXR 3.5.3, numpy 2.2.6 (PyPI). Node.js 18 or newer, Python 3.11.
# Surprise: each block in the file names its first row, so the order of blocks should not matter. The package counts
# blocks from the bottom, and takes a block's last row for its first. Uncompressed files, whose blocks have one row, are
# right. three.js, whose loader the package began as, no longer does this.
# Who is hit: web viewers of pictures from programs that write from bottom to top.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
python3 -m pip install --quiet --target "$dir/py" OpenEXR==3.5.3 numpy==2.2.6
(cd "$dir" && npm init -y >/dev/null && npm install --silent parse-exr@1.0.2)
PYTHONPATH=$dir/py python3 - "$dir" <<'PY'
import sys
import numpy as np
import OpenEXR

for height in (40, 48):
    rows = np.repeat(np.arange(height, dtype=np.float32)[:, None], 4, axis=1)
    path = f"{sys.argv[1]}/{height}.exr"
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "lineOrder": OpenEXR.DECREASING_Y}
    OpenEXR.File(header, {channel: rows for channel in "RGB"}).write(path)
    if not np.array_equal(OpenEXR.File(path, separate_channels=True).channels()["R"].pixels, rows):
        sys.exit("OpenEXR itself reads other rows")
PY
cat >"$dir/read.cjs" <<'JS'
const fs = require("fs");
const parse = require("parse-exr");
const seen = [40, 48].map(height => {
    const bytes = fs.readFileSync(`${height}.exr`);
    const { data } = (parse.default || parse)(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), 1015);
    const rows = Array.from({ length: height }, (_, y) => data[16 * (height - 1 - y)]); // the package returns the last row first
    console.info(`parse-exr 1.0.2, ${height} rows: expected 0 1 2 ... ${height - 1}, seen ${rows.join(" ")}`);
    return rows;
});
const shifted = (rows, by) => rows.every((row, y) => row === (y < by ? 1 : y - by));
if (!shifted(seen[0], 7) || !shifted(seen[1], 15)) {
    console.info("the behaviour has changed");
    process.exit(1);
}
JS
cd "$dir"
node read.cjs
