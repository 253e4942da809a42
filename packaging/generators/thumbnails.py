"""Write the pictures by which the packaged lights and forms are chosen.

Run with the folder to write to; without one they go to ``resources/thumbnails`` of this checkout::

    python packaging/generators/thumbnails.py [FOLDER]

A light is a crop of its image, a form is drawn in the photo studio with a neutral grey paint. Drawing needs OpenGL.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
from PySide6.QtGui import QImage

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.view_settings import SurfaceLook
from brdf_suite.lighting.thumbnail import light_thumbnail
from brdf_suite.output.still import loaded_scene
from brdf_suite.palettes.swatches.look import GROUND
from brdf_suite.pipeline.environments import read_environment
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import material_of
from brdf_suite.pipeline.scene import default_view, environment_names, find_environment, surface_names

SIZE = 128
_QUALITY = 85
_GREY = (60.0, 0.0, 0.0)
_OVER = 4
"""Pixels that are averaged, each way."""


def generate(folder: Path) -> Iterator[Path]:
    """Write all pictures, and yield their paths."""
    for name in environment_names():
        codes = light_thumbnail(read_environment(find_environment(name)[1]), SIZE)
        yield _write(codes, folder / "environments" / f"{name}.jpg")
    fit = fit_material(material_of(solid_paint("neutral", _GREY)))
    for name in surface_names():
        view = replace(
            default_view("photo_studio"),
            surface=name,
            background="colour",
            background_colour=GROUND,
            surface_look=SurfaceLook(ground=True),
        )
        large = (_OVER * SIZE, _OVER * SIZE)
        with loaded_scene(view) as loaded:
            loaded.scene.set_material(fit)
            picture = np.asarray(loaded.scene.image(loaded.composed(view, large), large), float)
        codes = picture.reshape(SIZE, _OVER, SIZE, _OVER, 3).mean(axis=(1, 3))
        yield _write(np.rint(codes).astype(np.uint8), folder / "meshes" / f"{name}.jpg")


def _write(codes: np.ndarray, path: Path) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    image = QImage(codes.tobytes(), SIZE, SIZE, 3 * SIZE, QImage.Format.Format_RGB888)
    if not image.save(str(path), b"JPEG", _QUALITY):
        raise OSError(f"{path} cannot be written")
    return path


def main() -> None:
    """Write the pictures and say where."""
    own = Path(__file__).resolve().parents[2] / "resources" / "thumbnails"
    for path in generate(Path(sys.argv[1]) if len(sys.argv) > 1 else own):
        print(f"{path} {path.stat().st_size} bytes")


if __name__ == "__main__":
    main()
