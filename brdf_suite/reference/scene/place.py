"""Surface point met by a path: its position in millimetres, and the footprint of a pixel.

Flakes, relief and masks ask for it. A pixel's footprint is known for places that the camera sees directly; at all
others, seen in a reflection, it is not known, and what depends on it is shown in its mean.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.reference.bsdfs.directions import TINY, Real, Square, Vector, number
from brdf_suite.reference.bsdfs.terms import Sampler
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reference.scene.camera import Pinhole

_SAME_DIRECTION = 1e-9
"""Squared distance of two unit directions that are one but for rounding: 0.002°."""


@dataclass(frozen=True, eq=False)
class Place:
    """A surface point met by a path.

    Attributes
    ----------
    uv
        Lengths on the surface, millimetres.
    position
        Metres, world.
    along_u, along_v
        Unit directions in which u and v grow, local.
    across, down
        How uv changes from pixel to pixel, millimetres.
    seen
        Whether the camera sees the place directly; ``across`` and ``down`` hold there only.
    frame, side
        The surface's frame, and 1 or -1: the side that is met.
    """

    uv: Any
    position: Any
    along_u: Vector
    along_v: Vector
    across: Any
    down: Any
    seen: Any
    frame: Any
    side: Any

    @classmethod
    def of(cls, si: Any, side: Real, camera: Pinhole) -> Place:
        """Return the place of an interaction."""
        n = si.sh_frame.n
        # The gradients of u and v: across the lines of the other one, on the plane.
        du, dv = dr.cross(si.dp_dv, n), dr.cross(n, si.dp_du)
        long_u, long_v = dr.dot(du, si.dp_du), dr.dot(dv, si.dp_dv)
        du, dv = du / _off_zero(long_u), dv / _off_zero(long_v)
        from_eye = si.p - camera.place
        ray = dr.normalize(from_eye)
        seen = dr.squared_norm(si.to_world(si.wi) + ray) < _SAME_DIRECTION
        across, down = camera.footprint(ray, dr.norm(from_eye), si.n)
        local_u, local_v = si.sh_frame.to_local(du), si.sh_frame.to_local(dv)
        return cls(
            si.uv,
            si.p,
            _unit(local_u),
            _unit(local_v),
            mi.Vector2f(dr.dot(du, across), dr.dot(dv, across)),
            mi.Vector2f(dr.dot(du, down), dr.dot(dv, down)),
            seen,
            si.sh_frame,
            side,
        )

    def to_world(self, direction: Vector) -> Vector:
        """Return a direction of the side that is met in the world."""
        return self.frame.to_world(mi.Vector3f(direction.x, direction.y, direction.z * self.side))

    def from_world(self, direction: Vector) -> Vector:
        """Return a direction of the world on the side that is met."""
        found = self.frame.to_local(direction)
        return mi.Vector3f(found.x, found.y, found.z * self.side)


def _off_zero(x: Real) -> Real:
    return dr.select(abs(x) < TINY, mi.Float(TINY), x)


def _unit(v: Vector) -> Vector:
    across = mi.Vector3f(v.x, v.y, 0.0)
    return across * dr.rsqrt(dr.maximum(dr.squared_norm(across), TINY))


def footprint_of_sample(pixel: float) -> float:
    """Return the reach of one sample, in pixels, so that samples even over a pixel make up a reach of ``pixel``.

    Standard deviations along an axis: that of an even pixel is 1/√12.

    >>> round(footprint_of_sample(0.5), 3)
    0.408
    """
    return math.sqrt(pixel * pixel - 1.0 / 12.0)


_LOWEST = 1e-3
"""The least cosine of the view to a tilted normal, as in the real-time picture."""
_TURN = (0.8090169943749475, 0.5877852522924731)
_STRETCH = 1.0352762
_BESIDE = (0.37, 0.61)


@dataclass(frozen=True, eq=False)
class Slopes:
    """A tiled relief: a :func:`texture` of slopes dh/du and dh/dv; ``tiles`` per millimetre; a factor on the slopes."""

    texture: Any
    tiles: tuple[float, float]
    strength: float

    def at(self, uv: Any) -> Any:
        """Return the slopes at a place, millimetres."""
        where = mi.Point2f(uv.x * number(self.tiles[0]), uv.y * number(self.tiles[1]))
        return look_up(self.texture, where) * number(self.strength)


@dataclass(frozen=True, eq=False)
class OrangePeelSlopes:
    """Orange peel: a tile of slopes of mean square 1, laid twice, the second time rotated, to avoid repetition.

    It is a :func:`texture`, ``tiles`` per millimetre, made a root mean square ``slope``.
    """

    texture: Any
    tiles: float
    slope: float

    def at(self, uv: Any) -> Any:
        """Return the slopes at a place, millimetres."""
        cos, sin = _TURN
        x, y = uv.x * number(self.tiles), uv.y * number(self.tiles)
        one = look_up(self.texture, mi.Point2f(x, y))
        turned = mi.Point2f(cos * x - sin * y, sin * x + cos * y)
        other = look_up(
            self.texture, mi.Point2f(turned.x * _STRETCH + _BESIDE[0], turned.y * _STRETCH + _BESIDE[1])
        )
        # Slopes along the turned axes, back to u and v.
        back = mi.Vector2f(cos * other.x + sin * other.y, cos * other.y - sin * other.x)
        return (one + back) * number(0.5**0.5 * self.slope)


def aligned(values: npt.ArrayLike, kind: type[np.generic] = np.float32) -> npt.NDArray[Any]:
    """Return a copy of an array whose memory begins at a multiple of 64 bytes.

    Dr.Jit uses numpy's memory as it is, and reads pairs by other instructions where it is not aligned: the same scene
    would need another program, seconds to compile, wherever chance puts an array.
    """
    array: npt.NDArray[Any] = np.asarray(values, kind)
    whole = np.empty(array.nbytes + 64, np.uint8)
    first = -whole.ctypes.data % 64
    found: npt.NDArray[Any] = whole[first : first + array.nbytes].view(kind).reshape(array.shape)
    found[...] = array
    return found


def texture(image: npt.NDArray[Any], *, repeat: bool = True) -> Any:
    """Return an image (h, w, c) for :func:`look_up`, which is bilinear; its first row is at v = 0."""
    wrap = dr.WrapMode.Repeat if repeat else dr.WrapMode.Clamp
    tensor = mi.TensorXf(aligned(image))
    kind: Any = mi.Texture2f
    return kind(tensor, use_accel=False, filter_mode=dr.FilterMode.Linear, wrap_mode=wrap)


def look_up(image: Any, at: Any) -> Any:
    """Return the first two channels of an image at coordinates of 1 per tile."""
    found = image.eval(at)
    return mi.Vector2f(found[0], found[1]) if len(found) > 1 else found[0]


Frame = Any
"""mi.Frame3f; its world is the surface."""


def tilted_frame(normal: Vector, slopes: Any, place: Place, view: Vector) -> Frame:
    """Return the frame of a surface with ``slopes`` over ``normal``; if it faces away it is bent to the view."""
    m = dr.normalize(normal - slopes.x * place.along_u - slopes.y * place.along_v)
    cosine = dr.dot(m, view)
    bent = dr.normalize(m + (_LOWEST - cosine) * view)
    n = dr.select(cosine >= _LOWEST, m, bent)
    # The axes stay those of the surface, but for the lean: flakes keep their tilts.
    s = dr.normalize(mi.Vector3f(1.0, 0.0, 0.0) - n * n.x)
    return mi.Frame3f(s, dr.cross(n, s), n)


@dataclass(frozen=True, eq=False)
class TiltedSampler:
    """A sampler evaluated in a tilted shading frame.

    Light from below the surface's own horizon, which a tilted facet would mirror, arrives by way of the neighbouring
    surface, modelled as a level mirror (after Schüssler et al. 2017): from the other side of the horizon.
    """

    sampler: Sampler
    frame: Frame

    def share(self, view: Vector) -> Real:
        """Return the share of a mixture."""
        return self.sampler.share(self.frame.to_local(view))

    def sample(self, view: Vector, u: Square) -> Vector:
        """Return directions to the light; those below the tilted horizon are lost."""
        light = self.sampler.sample(self.frame.to_local(view), u)
        found = self.frame.to_world(light)
        folded = mi.Vector3f(found.x, found.y, abs(found.z))
        return dr.select(light.z > 0.0, folded, mi.Vector3f(0.0))

    def pdf(self, light: Vector, view: Vector) -> Real:
        """Return the density per solid angle."""
        local_view = self.frame.to_local(view)
        total = mi.Float(0.0)
        for direction in folds(light):
            local = self.frame.to_local(direction)
            total += dr.select(local.z > 0.0, self.sampler.pdf(local, local_view), 0.0)
        return total


def folds(light: Vector) -> tuple[Vector, Vector]:
    """Return the two directions from which a tilted surface receives light of direction ``light``."""
    return light, mi.Vector3f(light.x, light.y, -light.z)


@dataclass(frozen=True, eq=False)
class WeightedSampler:
    """A sampler whose share of the mixture is scaled by a weight at each place."""

    sampler: Sampler
    weight: Real

    def share(self, view: Vector) -> Real:
        """Return the share of a mixture."""
        return self.weight * self.sampler.share(view)

    def sample(self, view: Vector, u: Square) -> Vector:
        """Return directions to the light."""
        return self.sampler.sample(view, u)

    def pdf(self, light: Vector, view: Vector) -> Real:
        """Return the density per solid angle."""
        return self.sampler.pdf(light, view)
