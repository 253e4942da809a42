"""Draw the pictures of docs/method/surfaces.md: occlusion and ground, orange peel and normal map, two-tone paint.

.venv/bin/python packaging/plots/surfaces.py
"""

from __future__ import annotations

import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np

from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Relief, SurfaceLook, TwoTone
from brdf_suite.files.images.environments import write_png
from brdf_suite.output.still import loaded_scene
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_material
from brdf_suite.pipeline.surface_images import ImageRequest, load_surface_images

IMAGES = Path(__file__).resolve().parents[2] / "docs" / "images"
SIZE = (480, 300)
PLAIN = SurfaceLook(occlusion=False)
LIT = SurfaceLook(occlusion=True)
GROUNDED = SurfaceLook(occlusion=True, ground=True)


def row(views: list[View], paint: str, path: Path) -> None:
    """Draw views of one surface and light beside each other."""
    fit = fit_material(load_material(paint))
    with loaded_scene(views[-1]) as loaded:
        loaded.scene.set_material(fit)
        pictures = []
        for view in views:
            loaded.scene.set_surface_images(load_surface_images(ImageRequest.of(view)))
            pictures.append(loaded.scene.image(loaded.composed(view, SIZE), SIZE))
    write_png(path, np.concatenate(pictures, axis=1))


def occlusion(environment: str, path: Path) -> None:
    """Draw the car without occlusion, with it, and on the ground."""
    view = View(camera=Camera(35.0, 9.0), environment=environment, surface="car", background="grey")
    row([replace(view, surface_look=look) for look in (PLAIN, LIT, GROUNDED)], "fine_silver", path)


def relief(path: Path, folder: Path) -> None:
    """Draw a panel smooth, with orange peel, and under a normal map of ribs."""
    across = np.sin(2.0 * np.pi * np.arange(64) / 64.0)
    normals = np.stack([-0.6 * across, np.zeros(64), np.ones(64)], axis=-1)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    ribs = np.round((np.tile(normals, (8, 1, 1)) + 1.0) * 127.5).astype(np.uint8)
    write_png(folder / "ribs.png", ribs)
    view = View(environment="booth", surface="panel", background="grey", surface_look=LIT)
    mapped = Relief(normal_map=str(folder / "ribs.png"), normal_width_mm=25.0, normal_strength=0.6)
    reliefs = (Relief(), Relief(orange_peel=0.35, orange_peel_mm=6.0), mapped)
    row([replace(view, relief=relief) for relief in reliefs], "blue", path)


def two_tone(path: Path, folder: Path) -> None:
    """Draw the car with a mask from the side and from above."""
    side = np.zeros((256, 512, 1), np.uint8)
    side[150:] = 255
    write_png(folder / "side.png", np.repeat(side, 3, axis=-1))
    stripes = np.zeros((64, 256, 3), np.uint8)
    stripes[:, 108:124] = stripes[:, 132:148] = 255
    write_png(folder / "stripes.png", stripes)
    view = View(environment="booth", surface="car", background="grey", surface_look=GROUNDED)
    views = [
        replace(
            view,
            camera=camera,
            two_tone=TwoTone(paint="fine_silver", mask=str(folder / name), projection=projection),
        )
        for camera, name, projection in (
            (Camera(60.0, 8.0), "side.png", "side"),
            (Camera(20.0, 25.0), "stripes.png", "top"),
        )
    ]
    row(views, "red", path)


def main() -> None:
    """Draw all of them."""
    occlusion("booth", IMAGES / "surface_occlusion.png")
    occlusion("sunny", IMAGES / "surface_occlusion_sunny.png")
    with tempfile.TemporaryDirectory() as folder:
        relief(IMAGES / "surface_relief.png", Path(folder))
        two_tone(IMAGES / "surface_two_tone.png", Path(folder))


if __name__ == "__main__":
    main()
