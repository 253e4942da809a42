"""The scenes by name, and their way from samples to a file."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.files.images.exr.image import write_exr
from brdf_suite.lighting.procedural.panorama import ProceduralEnvironment, finish, solid_angles
from brdf_suite.reference.variant import start
from environments.photo_studio import photo_studio
from environments.street import street
from environments.sums import accumulate, relative_noise, whole
from environments.tracing import TracedScene
from environments.tunnel import light_tunnel

SCENES: dict[str, Callable[[], TracedScene]] = {
    "photo_studio": photo_studio,
    "street": street,
    "light_tunnel": light_tunnel,
}


@dataclass(frozen=True, eq=False)
class TracedPicture:
    """A map so far: mean ``samples`` a pixel over all lights, and the relative deviation that is left of their noise.

    Half of the sphere stays below ``noise``, and 95 % of it below ``most_noise``.
    """

    environment: ProceduralEnvironment
    samples: float
    noise: float
    most_noise: float
    is_last: bool

    @property
    def comment(self) -> str:
        """What it shows, how it was made and how noisy it is."""
        return (
            f"{self.environment.comment} {self.samples:.0f} paths a pixel in the mean, unfiltered; noise of a pixel "
            f"below {100.0 * self.noise:.1f} % on half of the sphere, {100.0 * self.most_noise:.1f} % on 95 % of it."
        )

    def write(self, path: Path) -> None:
        """Write it as half floats, compressed by DWA."""
        pixels = within_half(self.environment.radiance.astype(np.float64))
        # What is darker is black to any eye, and the compression would let it fall below 0 here and there.
        pixels = np.maximum(pixels, _DARKEST).astype(np.float16)
        for level in _LEVELS:  # a map with much noise left needs a coarser one
            write_exr(path, pixels, metadata={"comments": self.comment}, dwa_level=level)
            if path.stat().st_size <= _LARGEST_FILE:
                return


_LEVELS = (15.0, 30.0, 60.0, 120.0)
"""Of DWA; at 15, errors are below .1 % in most pixels and .3 % in one of a hundred."""
_LARGEST_FILE = 4_000_000
_DARKEST = 1e-3
_BRIGHTEST = 65000.0


def within_half(pixels: Floats) -> Floats:
    """Return a map (h, w, 3) in which nothing exceeds half floats; the other half-bright places get what that takes.

    Only the middle of a sun's disc is too bright, by a few percent: its light stays, a little more even over the disc.
    """
    result = pixels.copy()
    weights = np.broadcast_to(solid_angles(len(pixels)), pixels.shape[:2])
    for channel in range(3):
        values = result[..., channel]
        for _ in range(8):
            over = values > _BRIGHTEST
            excess = float(((values[over] - _BRIGHTEST) * weights[over]).sum())
            if excess <= 0.0:
                break
            values[over] = _BRIGHTEST
            takers = (values > 0.3 * _BRIGHTEST) & (values < _BRIGHTEST)
            values[takers] *= 1.0 + excess / max(float((values[takers] * weights[takers]).sum()), 1e-300)
    return result


def trace(
    name: str, height: int, samples: float, noise: float = 0.0, kept: Path | None = None
) -> Iterator[TracedPicture]:
    """Yield the map after each round of passes; parameters as :func:`environments.sums.accumulate` has them."""
    start()
    scene = SCENES[name]()
    for sums, is_last in accumulate(scene, height, samples, noise, kept):
        environment = finish(scene.name, whole(scene, sums), scene.description)
        paths = sum(own.paths for own in sums.values())
        typical, most = relative_noise(sums, 0.5, 0.95)
        yield TracedPicture(environment, paths, typical, most, is_last)
