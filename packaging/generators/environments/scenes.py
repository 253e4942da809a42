"""The scenes by name, and their way from samples to a file."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from brdf_suite.files.images.exr.image import write_exr
from brdf_suite.lighting.procedural.panorama import ProceduralEnvironment, finish
from brdf_suite.reference.variant import start
from environments.photo_studio import photo_studio
from environments.street import street
from environments.tracing import TracedScene, accumulate, relative_noise, whole
from environments.tunnel import light_tunnel

SCENES: dict[str, Callable[[], TracedScene]] = {
    "photo_studio": photo_studio,
    "street": street,
    "light_tunnel": light_tunnel,
}


@dataclass(frozen=True, eq=False)
class TracedPicture:
    """A map so far: ``samples`` a pixel over all lights, and the relative deviation that is left of their noise."""

    environment: ProceduralEnvironment
    samples: float
    noise: float
    is_last: bool

    @property
    def comment(self) -> str:
        """What it shows, how it was made and how noisy it is."""
        return (
            f"{self.environment.comment} {self.samples:.0f} paths a pixel, unfiltered; noise of a pixel "
            f"{100.0 * self.noise:.1f} % (median, from two halves of the samples)."
        )

    def write(self, path: Path) -> None:
        """Write it as half floats, compressed by DWA."""
        write_exr(path, self.environment.stored(), metadata={"comments": self.comment}, lossy=True)


def trace(name: str, height: int, samples: int, kept: Path | None = None) -> Iterator[TracedPicture]:
    """Yield the map after each round of passes; ``kept`` as :func:`environments.tracing.accumulate` has it."""
    start()
    scene = SCENES[name]()
    for sums in accumulate(scene, height, samples, kept):
        counts = {light.name: sum(sums[light.name].samples) for light in scene.lights}
        done = all(counts[light.name] >= samples * light.share for light in scene.lights)
        environment = finish(scene.name, whole(scene, sums), scene.description)
        yield TracedPicture(environment, float(sum(counts.values())), relative_noise(sums), done)
