"""Prefiltering of an environment: one cube map per lobe exponent.

Method: convolution in spherical harmonics (:mod:`brdf_suite.lighting.filter.harmonics`), brought to the cube by
:mod:`brdf_suite.lighting.filter.ring_to_cube`. Exponents too sharp for the map's rings get the environment itself,
resampled.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from brdf_suite.errors import ValueRangeError
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.filter.face_array import FaceArray
from brdf_suite.lighting.filter.harmonics import BROAD_BANDLIMIT, largest_exponent, lobe_bandlimit
from brdf_suite.lighting.filter.lobe_filter import LobeFilter, ring_count
from brdf_suite.lighting.filter.texel_values import pack_background, pack_lobe
from brdf_suite.progress import Progress, report, subrange

ALGORITHM_VERSION = 5
"""Raised with every change of the numbers; part of the cache's key."""

DIFFUSE_EXPONENT = 1.0
MIN_FACE = 64
MAX_FACE = 2048
_TEXELS_PER_WIDTH = 9.2  # face size over √exponent: bilinear look-up errs by less than 1 % of the lobe's peak


@dataclass(frozen=True, eq=False)
class LobeMaps:
    """Prefiltered light of one environment, in the working space.

    Attributes
    ----------
    exponents
        The lobe exponents, as given.
    lobes
        One map per exponent, unit gain: where the light is 1 everywhere, so is the map. Exponents too sharp
        for the environment share the background's map.
    diffuse
        The map of exponent 1: irradiance over π for the normal in the texel's direction.
    through_coat
        The same for light that crosses a coat on its way in, see
        :func:`~brdf_suite.lighting.filter.harmonics.coated_coefficients`.
    background
        The environment itself.
    """

    exponents: tuple[float, ...]
    lobes: tuple[FaceArray, ...]
    diffuse: FaceArray
    through_coat: FaceArray
    background: FaceArray


Ready = Callable[[float | None, FaceArray], None]
"""Called with an exponent (1 for the diffuse map, None for the background) and its map, when that is done."""


def background_size(environment: Environment) -> int:
    """Return the face size of the environment itself: the power of two ≥ half the map's width, 64…2048."""
    half_width = max(1, environment.radiance.shape[1] // 2)
    return int(min(MAX_FACE, max(MIN_FACE, 1 << (half_width - 1).bit_length())))


def face_size(exponent: float) -> int:
    """Return the face size for an exponent: 2^k or 3·2^k, at least 9.2·√exponent, 64…2,048.

    A bilinear look-up in the middle of a face errs by E/(2F²) of the lobe's peak
    (:mod:`brdf_suite.lighting.filter.texel_values`), one at an edge of the cube by up to 0.9 %
    (:mod:`brdf_suite.lighting.filter.texel_values`).
    """
    wanted = _TEXELS_PER_WIDTH * np.sqrt(exponent)
    sizes = sorted(base << shift for base in (64, 96) for shift in range(6))
    return next((size for size in sizes if size >= wanted and size <= MAX_FACE), MAX_FACE)


def filtered_exponents(environment: Environment, exponents: Sequence[float]) -> list[float]:
    """Return the exponents that get a map of their own, the diffuse map's among them, in the order of the work.

    Sharper ones share the environment's own map.
    """
    sharpest = largest_exponent(ring_count(environment.radiance.shape[0]))
    return sorted({DIFFUSE_EXPONENT, *(float(e) for e in exponents if e <= sharpest)})


def prefilter(
    environment: Environment,
    exponents: Sequence[float],
    progress: Progress | None = None,
    ready: Ready | None = None,
) -> LobeMaps:
    """Filter an environment with the unit-gain cosine lobes of ``exponents`` (any order, each > 0).

    The diffuse map and the broad lobes come first, then the background, with which there is a picture to show,
    then the sharp lobes; ``ready`` hears of each map as it is done, and ``progress`` may cancel. Error before
    packing: below 1e-5 of the map's largest value (tests/lighting).

    >>> sky = Environment("white", np.ones((64, 128, 3), np.float32))
    >>> float(prefilter(sky, [20.0]).lobes[0].radiance().round(3).max())
    1.0

    Raises
    ------
    ValueRangeError
        An exponent is not a finite number above 0.
    """
    wanted = tuple(float(exponent) for exponent in exponents)
    for index, exponent in enumerate(wanted):
        if not np.isfinite(exponent) or exponent <= 0.0:
            raise ValueRangeError(f"exponents[{index}]", f"must be a finite number above 0, not {exponent}")
    report(progress, 0.0, "reading the environment's rings")
    lobe_filter = LobeFilter(environment.radiance, subrange(progress, 0.0, 0.0))
    smooth = filtered_exponents(environment, wanted)
    costs = np.array([600.0 * lobe_bandlimit(e) ** 2 + 100.0 * face_size(e) ** 2 for e in smooth])
    ends = 0.9 * np.cumsum(costs) / costs.sum()
    maps: dict[float, FaceArray] = {}
    limits = [lobe_bandlimit(e) for e in smooth]
    # In plain numpy two analyses: one for all broad lobes, so that they come soon, one for the rest.
    first = max(limits) if lobe_filter.compiled else max(n for n in limits if n <= BROAD_BANDLIMIT)
    last_broad = max(e for e, limit in zip(smooth, limits, strict=True) if limit <= BROAD_BANDLIMIT)
    largest = max(background_size(environment), *(face_size(e) for e in smooth))
    room = np.empty(18 * largest * largest, dtype=np.float32) if lobe_filter.compiled else None
    for index, exponent in enumerate(smooth):
        step = subrange(progress, float(ends[index - 1]) if index else 0.0, float(ends[index]))
        lobe_filter.analyse(first if limits[index] <= first else max(limits), subrange(step, 0.0, 0.5))
        faces = lobe_filter.lobe(exponent, face_size(exponent), subrange(step, 0.5, 1.0), room)
        maps[exponent] = pack_lobe(faces)
        if exponent == DIFFUSE_EXPONENT:
            through_coat = pack_lobe(lobe_filter.through_coat(face_size(exponent), room))
        report(step, 1.0, f"lobe {exponent:g} is filtered")
        if ready is not None:
            ready(exponent, maps[exponent])
        if exponent == last_broad:
            background = pack_background(lobe_filter.background(background_size(environment), room))
            if ready is not None:
                ready(None, background)
    report(progress, 1.0, "the environment is filtered")
    lobes = tuple(maps.get(exponent, background) for exponent in wanted)
    return LobeMaps(wanted, lobes, maps[DIFFUSE_EXPONENT], through_coat, background)


class PartialMaps:
    """Lobe maps while they are being filtered, in the order of :func:`prefilter`: what is there stands in for the rest.

    Attributes
    ----------
    wanted
        How many maps there will be: one for each lobe that the environment distinguishes from a sharper one, the
        diffuse map, and the background.
    """

    def __init__(self, environment: Environment, exponents: Sequence[float]) -> None:
        self._exponents = tuple(float(exponent) for exponent in exponents)
        # The background stands for the sharpest lobe that its rings distinguish from it.
        self._background_exponent = largest_exponent(ring_count(environment.radiance.shape[0]))
        self._made: dict[float, FaceArray] = {}
        self._background: FaceArray | None = None
        self.wanted = len(filtered_exponents(environment, exponents)) + 1

    @property
    def made(self) -> int:
        """How many maps are there."""
        return len(self._made) + (self._background is not None)

    def add(self, exponent: float | None, faces: FaceArray) -> None:
        """Take one map, as ``ready`` of the prefilter gives it."""
        if exponent is None:
            self._background = faces
        else:
            self._made[exponent] = faces

    def maps(self) -> LobeMaps | None:
        """Return maps to draw with; None while the broad lobes are not all there.

        A lobe without a map of its own gets the one that is nearest in sharpness, by the ratio of exponents; the
        arrays themselves are shared, so that no texture is made twice.
        """
        if self._background is None or DIFFUSE_EXPONENT not in self._made:
            return None
        there = [*self._made.items(), (self._background_exponent, self._background)]
        lobes = tuple(
            min(there, key=lambda known: abs(math.log(known[0] / exponent)))[1]
            for exponent in self._exponents
        )
        diffuse = self._made[DIFFUSE_EXPONENT]
        return LobeMaps(self._exponents, lobes, diffuse, diffuse, self._background)
