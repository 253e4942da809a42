"""Environment look-up along a ray, as :func:`brdf_suite.lighting.latlong.sample`, rotated about y."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.reference.bsdfs.directions import Colour, Real, Vector
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reference.scene.camera import Pinhole


@dataclass(frozen=True, eq=False)
class TracedSky:
    """A map with a ring more at each end, and the same without its suns; ``cosine`` and ``sine`` of its turn."""

    texels: Any
    whole: Any
    width: Any
    height: Any
    cosine: Real
    sine: Real

    @classmethod
    def of(
        cls, radiance: npt.NDArray[np.float32], without_suns: npt.NDArray[np.float32] | None = None
    ) -> TracedSky:
        """Return the sky of a map (h, w, 3), not turned; the same map without its suns where it has any."""
        height, width = radiance.shape[:2]
        maps = [_padded(radiance)]
        if without_suns is not None and without_suns is not radiance:
            maps.append(_padded(without_suns))
        texels = mi.Float(np.ascontiguousarray(np.concatenate(maps), np.float32).ravel())
        dr.eval(texels)
        one, zero = (dr.opaque(mi.Float, v) for v in (1.0, 0.0))
        whole = dr.opaque(mi.UInt32, (len(maps) - 1) * (height + 2) * width)
        return cls(texels, whole, dr.opaque(mi.UInt32, width), dr.opaque(mi.UInt32, height), one, zero)

    def turned(self, degrees: float) -> TracedSky:
        """Return the sky turned about y, counter-clockwise seen from above."""
        turn = math.radians(degrees)
        cosine, sine = (dr.opaque(mi.Float, v) for v in (math.cos(turn), math.sin(turn)))
        return TracedSky(self.texels, self.whole, self.width, self.height, cosine, sine)

    def along(self, direction: Vector, active: Any, with_suns: Any = True) -> Colour:
        """Return the radiance from where unit ``direction`` points to; 0 where not ``active``."""
        x = self.cosine * direction.x - self.sine * direction.z
        z = self.sine * direction.x + self.cosine * direction.z
        theta = dr.atan2(dr.sqrt(x * x + z * z), direction.y)
        column = (dr.atan2(-x, z) + math.pi) * (mi.Float(self.width) * (0.5 / math.pi)) - 0.5
        # One ring more above, so that the row is never negative; the column may be.
        row = dr.maximum(theta * (mi.Float(self.height) / math.pi) + 0.5, 0.0)
        j = dr.minimum(mi.UInt32(row), self.height)
        fj = row - mi.Float(j)
        column = dr.select(column < 0.0, column + mi.Float(self.width), column)
        i = dr.minimum(mi.UInt32(column), self.width - 1)
        fi = column - mi.Float(i)
        after = dr.select(i + 1 >= self.width, mi.UInt32(0), i + 1)
        start = dr.select(with_suns, mi.UInt32(0), self.whole)
        top, bottom = (self._row(start + (j + k) * self.width, i, after, fi, active) for k in (0, 1))
        return dr.fma(fj, bottom - top, top)

    def _row(self, start: Any, i: Any, after: Any, part: Real, active: Any) -> Colour:
        first = dr.gather(mi.Color3f, self.texels, start + i, active)
        second = dr.gather(mi.Color3f, self.texels, start + after, active)
        return dr.fma(part, second - first, first)


def _padded(radiance: npt.NDArray[np.float32]) -> npt.NDArray[np.float32]:
    """Return the map with one more ring at each end: the pole's ring rotated by half a turn."""
    beyond = radiance.shape[1] // 2
    return np.concatenate([np.roll(radiance[:1], beyond, 1), radiance, np.roll(radiance[-1:], beyond, 1)])


_PLACES = 3
"""Looks along each edge of a pixel."""


def sky_behind(sky: TracedSky, camera: Pinhole, size: tuple[int, int]) -> npt.NDArray[np.float32]:
    """Return (h, w, 3): the mean radiance of the sky behind each pixel."""
    pixel = dr.arange(mi.UInt32, size[0] * size[1])
    column, row = pixel % camera.width, pixel // camera.width

    def one_more(k: mi.UInt32, total: mi.Color3f) -> tuple[mi.UInt32, mi.Color3f]:
        within = (mi.Point2f(mi.Float(k % _PLACES), mi.Float(k // _PLACES)) + 0.5) / _PLACES
        _, direction = camera.ray(column, row, within)
        return k + 1, total + sky.along(direction, mi.Bool(True))

    _, total = dr.while_loop(
        (mi.UInt32(0), mi.Color3f(0.0)), lambda k, _: k < _PLACES**2, one_more, label="places behind a pixel"
    )
    return np.asarray((np.array(total).T / _PLACES**2).reshape(size[1], size[0], 3), np.float32)
