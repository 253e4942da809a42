"""Lobe maps while they are being filtered: what is there already stands in for what is not."""

from __future__ import annotations

import math
from collections.abc import Sequence

from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.filter.face_array import FaceArray
from brdf_suite.lighting.filter.lobe_filter import ring_count
from brdf_suite.lighting.filter.prefilter import DIFFUSE_EXPONENT, LobeMaps, filtered_exponents
from brdf_suite.lighting.filter.zonal import largest_exponent


class PartialMaps:
    """Takes the maps in the order in which :func:`brdf_suite.lighting.filter.prefilter.prefilter` makes them.

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
        lobes = tuple(_nearest(there, exponent) for exponent in self._exponents)
        return LobeMaps(self._exponents, lobes, self._made[DIFFUSE_EXPONENT], self._background)


def _nearest(there: list[tuple[float, FaceArray]], exponent: float) -> FaceArray:
    return min(there, key=lambda known: abs(math.log(known[0] / exponent)))[1]
