"""Draw the pictures of docs/method/shading.md: the three Fresnel modes, and the two forms of the look-up.

.venv/bin/python packaging/plots/shading.py
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Sparkle, SurfaceLook
from brdf_suite.files.images.environments import write_png
from brdf_suite.output.still import loaded_scene
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_material

IMAGES = Path(__file__).resolve().parents[2] / "docs" / "images"
SIZE = (420, 300)
VIEW = View(
    camera=Camera(35.0, 7.0),
    environment="sunny",
    background="grey",
    sparkle=Sparkle("off"),
    surface_look=SurfaceLook(occlusion=False),
)


def row(views: list[View], paint: str, path: Path) -> None:
    """Draw views of one surface and light beside each other."""
    fit = fit_material(load_material(paint))
    with loaded_scene(views[0]) as loaded:
        loaded.scene.set_material(fit)
        pictures = [loaded.scene.image(loaded.composed(view, SIZE), SIZE) for view in views]
    write_png(path, np.concatenate(pictures, axis=1))


def main() -> None:
    """Draw both."""
    modes = [replace(VIEW, fresnel=mode) for mode in ("off", "raised", "multi_angle")]
    row(modes, "midnight_blue", IMAGES / "shading_fresnel.png")
    ball = replace(VIEW, surface="sphere")
    row(
        [replace(ball, look_up=form) for form in ("paper", "shifted")],
        "copper",
        IMAGES / "shading_look_ups.png",
    )


if __name__ == "__main__":
    main()
