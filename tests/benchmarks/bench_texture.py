"""Texture of paint in pictures, the glare of its sparkles, and what the virtual texture instrument reads."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import numpy as np

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.documents.view import Camera, View
from brdf_suite.progress import Progress, report, subrange

_grain = load_module(Path(__file__).with_name("parts") / "texture_grain.py")
_readings = load_module(Path(__file__).with_name("parts") / "texture_readings.py")

NAME = "texture"

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = (
    {
        "glare_energy": (
            "<=",
            0.001,
            "",
            "light added or lost by glare over the light above white, sources in the middle of a wide picture, largest",
        ),
        "glare_error": (
            "",
            None,
            "",
            "glare of a drawn frame over that of the eye, minus 1, rings from 0.6° to 15°, largest",
        ),
    }
    | _grain.BOUNDS
    | _readings.BOUNDS
)

NOTES: dict[str, str] = {}
TABLES: dict[str, dict[str, object]] = {}

_RINGS_DEG = (0.6, 1.0, 2.0, 4.0, 8.0, 15.0)


def run(progress: Progress | None = None) -> dict[str, float | None]:
    """Measure."""
    from brdf_suite.realtime.gl.context import create_context, release_context
    from brdf_suite.realtime.gl.objects import GpuObjects

    context = create_context()
    objects = GpuObjects(context)
    try:
        report(progress, 0.0, "spreading light")
        found = {"glare_energy": _energy(objects), "glare_error": _error(objects)}
    finally:
        objects.release_all()
        release_context(context)
    found |= _readings.figures(NOTES, subrange(progress, 0.1, 0.3))
    return found | _grain.figures(NOTES, subrange(progress, 0.3, 1.0))


def _spread(objects, pixels, focal_length_mm):
    """Return what is spread over a picture (h, w, 3) of exposed light, per block of pixels, and its veil."""
    from brdf_suite.realtime.pictures.glare import GlarePass

    height, width = pixels.shape[:2]
    light = objects.texture((width, height), "f4")
    light.write(np.concatenate([pixels, np.ones((height, width, 1))], axis=-1).astype(np.float32).tobytes())
    veil = GlarePass(objects).spread(light, View(Camera(focal_length_mm=focal_length_mm)))
    size = veil.texture.size
    return np.frombuffer(veil.texture.read(), np.float32).reshape(size[1], size[0], 4)[..., :3], veil


def _energy(objects) -> float:
    """A few sources of different colours, farther than glare reaches from the edges of a picture of 257°."""
    pixels = np.full((512, 512, 3), 0.4)
    pixels[255, 250], pixels[240:244, 270:272] = (9000.0, 5000.0, 200.0), (30.0, 60.0, 90.0)
    excess = np.maximum(pixels - 1.0, 0.0).sum(axis=(0, 1))
    spread, veil = _spread(objects, pixels, 8.0)
    each = pixels[..., 0].size / spread[..., 0].size
    return float(np.abs(spread.sum(axis=(0, 1)) * each / excess - veil.share).max())


def _error(objects) -> float:
    """One source, seen with 50 mm: the frame's Gaussians against the function that they stand for."""
    from brdf_suite.appearance.glare import pixel_angle, spread_glare
    from brdf_suite.documents.view import SENSOR_WIDTH_MM

    pixels = np.zeros((360, 640, 3))
    pixels[180, 200] = 8000.0
    spread, _ = _spread(objects, pixels, 50.0)
    angle = pixel_angle(50.0, 640, SENSOR_WIDTH_MM)
    expected = spread_glare(pixels, angle).reshape(180, 2, 320, 2, 3).mean(axis=(1, 3))
    rows, columns = np.indices((180, 320))
    far = np.hypot(2.0 * rows + 0.5 - 180.0, 2.0 * columns + 0.5 - 200.0) * angle
    away = []
    for low, high in pairwise(_RINGS_DEG):
        ring = (far >= low) & (far < high)
        away.append(abs(float(spread[ring].mean() / expected[ring].mean()) - 1.0))
    return max(away)
