"""Flakes move light about and add none: the mean radiance of a path-traced paint with and without them."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Sparkle
from brdf_suite.progress import Progress, report
from brdf_suite.tracing.reference.live import LiveReference

PAINTS = ("coarse_silver", "blue", "copper", "gunmetal")
SIZE = (160, 120)


@dataclass(frozen=True)
class SparkleEnergy:
    """``ratio``: the mean luminance over the object with flakes over that without; ``error``: its standard error."""

    ratio: float
    error: float


def sparkle_energy(
    paint: str = PAINTS[0],
    view: View | None = None,
    *,
    samples: int = 128,
    size: tuple[int, int] = SIZE,
    progress: Progress | None = None,
) -> SparkleEnergy:
    """Return how much light flakes add to a paint, a shipped one or a file, on a sphere in the sun.

    The error counts both what paths and what flakes lie there by chance: it is of the mean over pixels, which differ
    by both. Neighbours share some flakes where a pixel holds very many, so it is a little low then.
    Errors as :meth:`LiveReference.show`.
    """
    view = view or View(environment="sunny", surface="sphere", background="grey")
    live = LiveReference()
    means = []
    for step, mode in enumerate(("glints", "off")):
        report(progress, 0.5 * step, f"{paint}, flakes {mode}")
        live.show(paint, replace(view, sparkle=Sparkle(mode=mode)), size)  # type: ignore[arg-type]  # checked by it
        estimate = live.step()
        while estimate.samples < samples:
            estimate = live.step()
        means.append((estimate.radiance @ LUMINANCE)[estimate.coverage > 0.0])
    with_flakes, without = means
    # The paths are the same in both, so most of their noise is in both, and not in the difference.
    difference = with_flakes - without
    mean = float(without.mean())
    error = float(difference.std() / np.sqrt(len(difference)))
    return SparkleEnergy(1.0 + float(difference.mean()) / mean, error / mean)


def sparkle_energy_ratio(progress: Progress | None = None) -> float:
    """Return the mean of :func:`sparkle_energy` over four shipped paints: 1 where flakes add no light."""
    return float(np.mean([sparkle_energy(paint, progress=progress).ratio for paint in PAINTS]))
