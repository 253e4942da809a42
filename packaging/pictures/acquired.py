"""Draw docs/images/acquired.jpg: a paint, the table acquired of it, and the lobes fitted to the table, side by side.

    python packaging/pictures/acquired.py [FOLDER] [--paint table1_polaris_silver] [--size 320x320]

Runs the commands as a user would: acquire --simulate, acquire, fit-cook-torrance, render; FOLDER keeps what they write
(default: a temporary one), and what is there already is not made again.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import matplotlib as mpl

mpl.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from PIL import Image

from brdf_suite.files.measured.brdftable import read_brdftable
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.pipeline.material import load_material

IMAGES = Path(__file__).resolve().parents[2] / "docs" / "images"
TILE = (480, 320)
TITLES = ("the paint", "its table, from 2,880 photographs", "three lobes fitted to the table")


def main() -> None:
    """Make what is missing and draw."""
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("folder", nargs="?", type=Path)
    arguments.add_argument("--paint", default="table1_polaris_silver")
    arguments.add_argument("--size", default="320x320")
    options = arguments.parse_args()
    if options.folder is not None:
        draw(options.folder, options.paint, options.size)
        return
    with tempfile.TemporaryDirectory() as folder:
        draw(Path(folder), options.paint, options.size)


def command(*words: object) -> None:
    """Run ``brdf-suite`` and show what it says."""
    print("brdf-suite", *words, file=sys.stderr)
    subprocess.run([sys.executable, "-m", "brdf_suite", *map(str, words)], check=True)


def draw(folder: Path, paint: str, size: str) -> None:
    """Take the whole road in ``folder``, and put three pictures beside each other."""
    rig, table, fitted = folder / "rig", folder / "acquired.brdftable", folder / "fitted.brdfpaint"
    folder.mkdir(parents=True, exist_ok=True)
    if not (rig / "session.json").exists():
        command("acquire", "--simulate", paint, rig, "--size", size)
    if not table.exists():
        command("acquire", rig, "-o", table)
    if not fitted.exists():
        command("fit-cook-torrance", table, "-o", fitted)
    pictures = []
    for n, shown in enumerate((paint, table, fitted)):
        picture = folder / f"picture-{n}.png"
        command("render", shown, "-o", picture, "--size", f"{TILE[0]}x{TILE[1]}")
        with Image.open(picture) as image:
            pictures.append(image.convert("RGB"))
    figure, axes = plt.subplots(1, 3, figsize=(14.4, 3.6), constrained_layout=True)
    for panel, picture, title in zip(axes, pictures, TITLES, strict=True):
        panel.imshow(picture)
        panel.set_title(title, fontsize=11)
        panel.set_axis_off()
    figure.savefig(IMAGES / "acquired.jpg", dpi=100, pil_kwargs={"quality": 88})
    plt.close(figure)
    print_differences(paint, table, fitted)


def print_differences(paint: str, table: Path, fitted: Path) -> None:
    """Print how far table and fit are from the paint at the trade's angles, light at 45°."""
    truth = load_material(paint).reflectance
    angles = np.array([-15.0, 15.0, 25.0, 45.0, 75.0, 110.0])
    wi, wo = illumination(45.0), aspecular_view(45.0, angles)
    wanted = truth.eval(wi, wo)
    found = {
        name: np.abs(reflectance.eval(wi, wo) / wanted - 1.0).max(axis=1).round(4).tolist()
        for name, reflectance in (
            ("table", read_brdftable(table)),
            ("lobes", load_material(str(fitted)).reflectance),
        )
    }
    print(json.dumps({"aspecular_deg": angles.tolist(), "largest_relative_error": found}))


if __name__ == "__main__":
    main()
