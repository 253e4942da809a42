"""Draw the pictures of the start page: shipped paints on the car, drawn by the real-time renderer as JPEG files.

Run with the folder to write to; without one they go to ``resources/gallery`` of this checkout::

    python packaging/generators/gallery.py [FOLDER]

Each file has the name of its paint. ``gallery.json`` has names and titles in the order of the start page, so that the
page is shown before anything that reads paints is imported.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from PIL import Image

from brdf_suite.output.still import loaded_scene
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_material, paint_titles
from brdf_suite.pipeline.scene import default_view

PAINTS = (
    "blue_metallic",
    "candy_red",
    "fine_silver",
    "racing_green",
    "burnt_orange",
    "midnight_blue",
    "champagne",
    "magenta_gold_shift",
    "coarse_silver",
    "gold_green_shift",
    "pearl",
    "emerald_pearl",
    "gunmetal",
    "ice_blue",
    "lime_green",
    "satin_graphite",
)
SIZE = (400, 250)
DRAWN = 2
"""Each pixel is the mean of so many squared."""
MOST_BYTES = 15_000
_QUALITIES = range(86, 40, -4)


def generate(folder: Path) -> Iterator[Path]:
    """Draw every picture into ``folder``; yield each file written."""
    view = replace(default_view(), surface="car")
    large = (DRAWN * SIZE[0], DRAWN * SIZE[1])
    with loaded_scene(view) as loaded:
        shown = loaded.composed(view, large)
        for name in PAINTS:
            loaded.scene.set_material(fit_material(load_material(name)), view=shown)
            picture = Image.fromarray(loaded.scene.image(shown, large)[..., :3])
            path = folder / f"{name}.jpg"
            _write(picture.resize(SIZE, Image.Resampling.BOX), path)
            yield path
    path = folder / "gallery.json"
    titles = paint_titles()
    path.write_text(json.dumps({name: titles[name] for name in PAINTS}, indent=2) + "\n", "utf-8")
    yield path


def _write(picture: Image.Image, path: Path) -> None:
    """Write a JPEG file of at most :data:`MOST_BYTES`, as good as fits."""
    for quality in _QUALITIES:
        picture.save(path, quality=quality, optimize=True, progressive=True)
        if path.stat().st_size <= MOST_BYTES:
            return
    raise ValueError(f"{path}: larger than {MOST_BYTES} bytes at every quality")


def main() -> int:
    """Write the pictures and print what was written."""
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[2] / "resources" / "gallery"
    folder.mkdir(parents=True, exist_ok=True)
    for path in generate(folder):
        print(f"{path.name}: {path.stat().st_size:,} bytes", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
