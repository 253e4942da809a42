"""The time of a fit in a drag and over unrelated paints; a part of ``bench fit``."""

from __future__ import annotations

import numpy as np

from brdf_suite.documents.paint import Gloss, Measurement, Paint
from brdf_suite.errors import UnreachableError
from brdf_suite.fitting import LayersFit, LobeFitter
from brdf_suite.progress import Progress, report
from brdf_suite.reflectance.designed.build import build_paint

#: The progress message.
TITLE = "a drag, and unrelated paints"
#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float, str, str]] = {
    "drag_median_ms": ("<=", 0.25, "ms", "whole fit, 1,000 steps of a drag, median"),
    "drag_p99_ms": ("<=", 1.0, "ms", "whole fit, 1,000 steps of a drag, 99th percentile"),
    "unrelated_p99_ms": ("<=", 1.5, "ms", "whole fit, 1,000 unrelated paints, 99th percentile"),
    "time_limited_share": ("<=", 0.01, "", "share of the 1,000 unrelated paints that reached the time limit"),
}

STEPS = 1_000
SEED = 20_04


def _paint(lab15: np.ndarray, lab45: np.ndarray, lab110: np.ndarray, gu_20: float) -> Paint:
    angles = zip((15.0, 45.0, 110.0), (lab15, lab45, lab110), strict=True)
    measurements = tuple(Measurement(45.0, angle, (*map(float, lab),)) for angle, lab in angles)
    return Paint(name="bench", measurements=measurements, gloss=Gloss(gu_20), flakes=None)


def drag_paint(step: int, steps: int = STEPS) -> Paint:
    """Return the blue metallic paint at one step of a drag: L* at 15°, then hue at 45°, then L* at 110°."""
    lab15, lab45, lab110 = (np.array(v) for v in ((62.0, -4.0, -45.0), (25.0, 4.0, -38.0), (9.0, 8.0, -28.0)))
    third = steps / 3.0
    travelled = np.clip([step / third, step / third - 1.0, step / third - 2.0], 0.0, 1.0)
    lab15[0] += 30.0 * travelled[0]
    lab45[1] += 20.0 * travelled[1]
    lab110[0] += 6.0 * travelled[2]
    return _paint(lab15, lab45, lab110, 88.0)


def unrelated_paint(rng: np.random.Generator) -> Paint:
    """Return a paint that has nothing to do with the one before: any hue, flop and gloss of the trade."""
    light = rng.uniform(45.0, 130.0)
    middle = light * rng.uniform(0.35, 0.75)
    dark = middle * rng.uniform(0.2, 0.8)
    hue, chroma = rng.uniform(0.0, 2.0 * np.pi), rng.uniform(0.0, 0.5)
    turn = rng.normal(0.0, 0.3, 3)
    labs = [
        np.array([level, chroma * level * np.cos(hue + t), chroma * level * np.sin(hue + t)])
        for level, t in zip((light, middle, dark), turn, strict=True)
    ]
    return _paint(labs[0], labs[1], labs[2], rng.uniform(30.0, 92.0))


def measure(progress: Progress | None) -> tuple[list[LayersFit], list[LayersFit]]:
    """Return the fits of the drag and of the unrelated paints."""
    fitter = LobeFitter()
    drag = []
    for step in range(STEPS):
        drag.append(fitter.fit(build_paint(drag_paint(step))))
        report(progress, 0.5 * step / STEPS, "drag")
    rng = np.random.default_rng(SEED)
    unrelated: list[LayersFit] = []
    refused = 0
    while len(unrelated) < STEPS:
        try:
            reflectance = build_paint(unrelated_paint(rng))
        except UnreachableError:
            # Drawn at random, some readings belong to no physical coat.
            refused += 1
            if refused > STEPS:
                raise
            continue
        unrelated.append(fitter.fit(reflectance))
        report(progress, 0.5 + 0.5 * len(unrelated) / STEPS, "unrelated paints")
    return drag, unrelated


def run(progress: Progress | None = None) -> dict[str, float | None]:
    """Return the figures of :data:`BOUNDS`."""
    drag, unrelated = measure(progress)
    drag_ms = 1e3 * np.array([fit.seconds for fit in drag])
    unrelated_ms = 1e3 * np.array([fit.seconds for fit in unrelated])
    return {
        "drag_median_ms": float(np.median(drag_ms)),
        "drag_p99_ms": float(np.percentile(drag_ms, 99)),
        "unrelated_p99_ms": float(np.percentile(unrelated_ms, 99)),
        "time_limited_share": float(np.mean([fit.time_limited for fit in unrelated])),
    }
