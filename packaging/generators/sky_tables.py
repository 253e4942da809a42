"""Write the coefficients of the Hosek-Wilkie sky and sun, from the data file that comes with Mitsuba 3.

    python packaging/generators/sky_tables.py [--source FILE] [--output resources/sky]

The file is ``mitsuba/data/sunsky/sunsky_datasets.bin`` of the installed package (``pip install mitsuba``), which holds
the authors' tables of the spectral model as named arrays; its licence is copied beside the result.
"""

from __future__ import annotations

import argparse
import importlib.util
import shutil
import struct
import sys
from pathlib import Path

import numpy as np

RESOURCES = Path(__file__).resolve().parents[2] / "resources"
FIELDS = {
    "sky_params_spec": (10, 2, 6, 11, 9),
    "sky_rad_spec": (10, 2, 6, 11),
    "sun_rad_spec": (10, 45, 11, 4),
    "sun_ld_spec": (11, 6),
}
"""Arrays that are taken, with their shapes: turbidity, albedo, control point or segment, wavelength, coefficient."""


def read_tensors(path: Path) -> dict[str, np.ndarray]:
    """Return the float64 arrays of a Mitsuba tensor file by name."""
    data = path.read_bytes()
    if not data.startswith(b"tensor_file\0"):
        raise SystemExit(f"{path}: is no tensor file")
    (count,) = struct.unpack_from("<I", data, 14)
    at, found = 18, {}
    for _ in range(count):
        (length,) = struct.unpack_from("<H", data, at)
        name = data[at + 2 : at + 2 + length].decode()
        at += 2 + length
        dimensions, kind, offset = struct.unpack_from("<HBQ", data, at)
        shape = struct.unpack_from(f"<{dimensions}Q", data, at + 11)
        at += 11 + 8 * dimensions
        if kind == 11:  # float64
            found[name] = np.frombuffer(data, "<f8", int(np.prod(shape)), offset).reshape(shape)
    return found


def main() -> int:
    """Write the tables."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--source", type=Path, help="the data file (default: of the installed Mitsuba)")
    parser.add_argument("--output", type=Path, default=RESOURCES / "sky")
    arguments = parser.parse_args()
    source = arguments.source
    if source is None:
        found = importlib.util.find_spec("mitsuba")
        if found is None or found.origin is None:
            parser.error("Mitsuba is not installed; give --source")
        source = Path(found.origin).parent / "data" / "sunsky" / "sunsky_datasets.bin"
    tensors = read_tensors(source)
    for name, shape in FIELDS.items():
        if name not in tensors or tensors[name].shape != shape:
            parser.error(f"{source}: has no array {name} of shape {shape}")
    arguments.output.mkdir(parents=True, exist_ok=True)
    path = arguments.output / "hosek_wilkie.npz"
    np.savez_compressed(path, **{name: tensors[name].astype(np.float32) for name in FIELDS})
    shutil.copyfile(source.parent / "LICENSE", arguments.output / "LICENSE_hosek_wilkie.txt")
    print(f"{path.name}: {path.stat().st_size / 1024:,.0f} KiB")
    return 0


if __name__ == "__main__":
    sys.exit(main())
