"""Read environments of 16,384 × 8,192 pixels in a process of their own, and report their time and memory.

    python tools/attack/large_environment.py [--folder FOLDER]

Writes an OpenEXR (half, ZIP) and a Radiance file of noise, some 230 and 410 MB, and removes them afterwards.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

ROWS, COLUMNS = 8192, 16384
_READ = """
import sys, time
from pathlib import Path
from brdf_suite.pipeline.environments import read_environment

def peak_mb():
    # Of this program alone; getrusage would begin with what its parent held.
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(int(line.split()[1]) >> 10 for line in lines if line.startswith("VmHWM"))

before = peak_mb()
start = time.perf_counter()
radiance = read_environment(sys.argv[1]).radiance
seconds = time.perf_counter() - start
print(f"{radiance.shape[1]} x {radiance.shape[0]}; {seconds:.1f} s; {before} MB before, {peak_mb()} MB at most")
"""


def write_exr(path: Path) -> None:
    """Write noise as half floats, ZIP."""
    import OpenEXR

    noise = np.random.default_rng(0).random((64, COLUMNS)).astype(np.float16)
    planes = {name: np.tile(noise, (ROWS // 64, 1)) for name in "RGB"}
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File(header, planes).write(str(path))


def write_hdr(path: Path) -> None:
    """Write noise as RGBE, its mantissas as literals and its exponents in runs."""
    mantissas = np.random.default_rng(0).integers(1, 255, (3, COLUMNS), dtype=np.uint8)
    line = bytearray(b"\2\2" + bytes([COLUMNS >> 8, COLUMNS & 255]))
    for plane in mantissas:
        for first in range(0, COLUMNS, 128):
            line += bytes([128]) + plane[first : first + 128].tobytes()
    for first in range(0, COLUMNS, 127):
        line += bytes([128 + min(127, COLUMNS - first), 128])
    with path.open("wb") as stream:
        stream.write(f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {ROWS} +X {COLUMNS}\n".encode())
        for _ in range(ROWS):
            stream.write(line)


def main() -> int:
    """Measure both."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--folder", type=Path, help="where there is room for the files")
    folder = parser.parse_args().folder
    with tempfile.TemporaryDirectory(dir=folder) as scratch:
        for name, write in (("large.exr", write_exr), ("large.hdr", write_hdr)):
            path = Path(scratch) / name
            write(path)
            done = subprocess.run(
                [sys.executable, "-c", _READ, str(path)], capture_output=True, text=True, check=True
            )
            print(f"{name}: {path.stat().st_size >> 20} MB; {done.stdout.strip()}", flush=True)
            path.unlink()
    return 0


if __name__ == "__main__":
    sys.exit(main())
