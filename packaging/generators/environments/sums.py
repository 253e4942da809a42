"""Samples that add up to a map, most of them where noise is seen: sums in two halves, kept from call to call."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.lighting.procedural.panorama import solid_angles
from environments.tracing import Light, TracedScene, trace_pass

PATHS_IN_A_ROUND, PATHS_AT_ONCE = 1 << 22, 1 << 20
_FIRST = 2
"""Paths of each half that all pixels get before their noise is looked at."""
_LONGEST = 16
_SHARE = 0.25
"""Of all squares, at most so many are traced on in a pass: the noisiest."""
_SQUARE = 16
_DARK = 0.05
"""Of the mean luminance: what is darker may be as noisy in light as that."""


@dataclass
class Sums:
    """The sums of the paths of one light, in two halves (2, h, w, 3), and the paths of each half at a pixel (h, w)."""

    halves: Floats
    samples: npt.NDArray[np.int64]
    passes: int = 0

    def mean(self) -> Floats:
        """Return the mean of all samples."""
        return np.asarray(self.halves.sum(axis=0) / np.maximum(2 * self.samples, 1)[..., None])

    def half(self, which: int) -> Floats:
        """Return the mean of one half."""
        return np.asarray(self.halves[which] / np.maximum(self.samples, 1)[..., None])

    @property
    def paths(self) -> float:
        """Mean number of paths a pixel."""
        return float(2.0 * self.samples.mean())


def accumulate(
    scene: TracedScene, height: int, samples: float, noise: float, kept: Path | None = None
) -> Iterator[tuple[dict[str, Sums], bool]]:
    """Trace until no square of the map is noisier than wanted, or every light has its paths.

    Yields the sums after each round of passes, and whether it was the last.

    Parameters
    ----------
    samples
        The most paths a pixel of a light, in the mean.
    noise
        Relative standard deviation of a pixel's luminance that is aimed at in all places.
    kept
        A folder in which the sums are kept after each round, so that a later call goes on from there.
    """
    sums = {light.name: _load(scene, light, height, kept) for light in scene.lights}
    while True:
        traced = False
        for light in scene.lights:
            own = sums[light.name]
            chosen = _chosen(sums, own, samples, noise / len(scene.lights) ** 0.5)
            if not len(chosen):
                continue
            _trace_on(scene, light, height, own, chosen, samples)
            _save(scene, light, height, own, kept)
            traced = True
        yield sums, not traced
        if not traced:
            return


def _trace_on(
    scene: TracedScene,
    light: Light,
    height: int,
    own: Sums,
    chosen: npt.NDArray[np.uint32],
    samples: float,
) -> None:
    wanted = _FIRST if own.passes == 0 else _LONGEST
    left = (samples - own.paths) / 2.0 * own.samples.size / len(chosen)
    step = int(max(1, min(PATHS_IN_A_ROUND // len(chosen), wanted, np.ceil(left))))
    counts = own.samples.reshape(-1)
    for part in np.array_split(chosen, -(-len(chosen) * step // PATHS_AT_ONCE)):
        for which in (0, 1):
            earlier = counts[part].astype(np.uint32)
            light_of = trace_pass(light, scene.eye, height, part, earlier, step, own.passes, which)
            own.halves[which].reshape(-1, 3)[part] += light_of
        counts[part] += step
    own.passes += 1


def _chosen(sums: Mapping[str, Sums], own: Sums, samples: float, noise: float) -> npt.NDArray[np.uint32]:
    """Return the pixels (n,) that a light's next pass traces: all at first, then those of the noisiest squares."""
    if own.paths >= samples:
        return np.zeros(0, np.uint32)
    if own.samples.min() < _FIRST:
        return np.flatnonzero(own.samples.reshape(-1) < _FIRST).astype(np.uint32)
    height, width = own.samples.shape
    edge = min(_SQUARE, height)
    shape = (height // edge, edge, width // edge, edge)
    light = np.asarray(sum(s.mean() for s in sums.values())).mean(axis=-1)
    mean = float(
        (light * solid_angles(height)).sum() / np.broadcast_to(solid_angles(height), light.shape).sum()
    )
    apart = np.abs(own.half(0) - own.half(1)).mean(axis=-1).reshape(shape).mean(axis=(1, 3))
    # Of a normal distribution |x| has the mean 0.798; the mean of both halves deviates half as much as they differ.
    found = apart / 2.0 / 0.798 / np.maximum(light.reshape(shape).mean(axis=(1, 3)), _DARK * mean)
    bound = max(noise, float(np.quantile(found, 1.0 - _SHARE)))
    squares = np.repeat(np.repeat(found > bound, edge, axis=0), edge, axis=1)
    return np.flatnonzero(squares.reshape(-1)).astype(np.uint32)


def _path(scene: TracedScene, light: Light, height: int, kept: Path) -> Path:
    return kept / f"{scene.name}_{light.name}_{height}.npz"


def _load(scene: TracedScene, light: Light, height: int, kept: Path | None) -> Sums:
    path = _path(scene, light, height, kept) if kept is not None else None
    if path is None or not path.exists():
        return Sums(np.zeros((2, height, 2 * height, 3)), np.zeros((height, 2 * height), np.int64))
    with np.load(path) as stored:
        return Sums(
            stored["halves"].astype(np.float64), stored["samples"].astype(np.int64), int(stored["passes"])
        )


def _save(scene: TracedScene, light: Light, height: int, own: Sums, kept: Path | None) -> None:
    if kept is None:
        return
    path = _path(scene, light, height, kept)
    temporary = path.with_suffix(".part.npz")
    np.savez(
        temporary,
        halves=own.halves.astype(np.float32),
        samples=own.samples.astype(np.int32),
        passes=np.array(own.passes),
    )
    temporary.replace(path)


def whole(scene: TracedScene, sums: Mapping[str, Sums]) -> Floats:
    """Return the picture of all lights, kcd/m²."""
    return scene.finish(np.asarray(sum(s.mean() for s in sums.values())))


def relative_noise(sums: Mapping[str, Sums], *shares: float) -> list[float]:
    """Return the relative standard deviation of a pixel's luminance by noise that shares of the sphere stay below.

    Taken in squares of 8 × 8 pixels; what is darker than a twentieth of the mean is left out. From the difference of
    two halves with independent samples: the mean of both deviates half as much as they differ, and the median of |x| of
    a normal distribution is 0.6745 deviations.
    """
    first = np.asarray(sum(s.half(0) for s in sums.values())).mean(axis=-1)
    second = np.asarray(sum(s.half(1) for s in sums.values())).mean(axis=-1)
    mean = 0.5 * (first + second)
    deviation = np.abs(first - second) / 2.0 / np.maximum(mean, 1e-9)
    areas = np.broadcast_to(solid_angles(len(mean)), mean.shape)
    dark = mean < _DARK * float((mean * areas).sum() / areas.sum())
    shape = (len(mean) // 8, 8, 2 * len(mean) // 8, 8)
    squares = np.median(deviation.reshape(shape).swapaxes(1, 2).reshape(shape[0], shape[2], 64), axis=-1)
    weights = np.where(dark, 0.0, areas).reshape(shape).sum(axis=(1, 3)).ravel()
    order = np.argsort(squares.ravel())
    reached = np.cumsum(weights[order])
    places = np.searchsorted(reached, np.array(shares) * reached[-1])
    return [float(found) / 0.6745 for found in squares.ravel()[order][places]]
