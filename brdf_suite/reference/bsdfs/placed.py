"""Spatially varying BSDFs: a layered paint with relief and flakes, and two paints with a mask.

``at(place, view)`` returns the BSDF at a place: samplers, and the reflected light per incident light, f_r times the
cosine, which differs between a tilted coat and the base below it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.reference.bsdfs.directions import Colour, Vector, number
from brdf_suite.reference.bsdfs.terms import Sampler, SumTerm
from brdf_suite.reference.flakes.population import FlakeLayer
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reference.scene.place import (
    Frame,
    OrangePeelSlopes,
    Place,
    Slopes,
    TiltedSampler,
    WeightedSampler,
    folds,
    look_up,
    texture,
    tilted_frame,
)


@dataclass(frozen=True, eq=False)
class LocalBsdf:
    """The BSDF at one place: ``reflected`` returns f_r times the cosine, in 1/sr, of light and view."""

    samplers: Sequence[Sampler]
    reflected: Callable[[Vector, Vector], Colour]


@dataclass(frozen=True, eq=False)
class LayeredPaintBsdf:
    """A paint of base and coat with relief, orange peel and flakes; without any of them, the sum of base and coat.

    Attributes
    ----------
    base, coat
        Terms; ``coat`` None: the base is all.
    shape
        A normal map that tilts base and coat.
    peel
        Orange peel that tilts the coat; the whole paint where it has no coat.
    flakes
        The visible flakes of the base.
    """

    base: Any
    coat: Any | None = None
    shape: Slopes | None = None
    peel: OrangePeelSlopes | None = None
    flakes: FlakeLayer | None = None

    @property
    def samplers(self) -> Sequence[Sampler]:
        """Those of base and coat on a plain surface."""
        return tuple(self._plain.samplers)

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr on a plain surface: the mean over its flakes."""
        return self._plain.eval(light, view)

    @property
    def is_plain(self) -> bool:
        """Whether it is the same everywhere."""
        return self.shape is None and self.peel is None and self.flakes is None

    @property
    def _plain(self) -> Any:
        return self.base if self.coat is None else SumTerm((self.base, self.coat))

    def at(self, place: Place, view: Vector) -> LocalBsdf:
        """Return the paint at a place."""
        up = mi.Vector3f(0.0, 0.0, 1.0)
        level = mi.Vector2f(0.0)
        below = tilted_frame(up, level if self.shape is None else self.shape.at(place.uv), place, view)
        above = below
        if self.peel is not None:
            above = tilted_frame(below.n, self.peel.at(place.uv), place, view)
            if self.coat is None:
                below = above
        tilted = self.shape is not None or self.peel is not None
        layer = self.flakes
        there = None if layer is None else layer.at(place, _frame_of_flakes(place, below))

        def flaked(base: Colour, light: Vector, view: Vector) -> Colour:
            if layer is None or there is None:
                return base
            return base + layer.visible_part(base, light, view) * (there.ratio(light, view) - 1.0)

        def reflected(light: Vector, view: Vector) -> Colour:
            total = mi.Color3f(0.0)
            for direction in folds(light) if tilted else (light,):
                total += _of_layer(self.base, below, direction, view, flaked)
                if self.coat is not None:
                    total += _of_layer(self.coat, above, direction, view, None)
            return total

        of_base = list(self.base.samplers)
        if there is not None:
            of_base += there.samplers(self.base.samplers)
        if not tilted:
            return LocalBsdf((*of_base, *(() if self.coat is None else self.coat.samplers)), reflected)
        samplers: list[Sampler] = [TiltedSampler(sampler, below) for sampler in of_base]
        if self.coat is not None:
            samplers += [TiltedSampler(sampler, above) for sampler in self.coat.samplers]
        return LocalBsdf(samplers, reflected)


@dataclass(frozen=True, eq=False)
class Mask:
    """The fraction of the second paint: an image over tiles of uv, or projected in world space.

    ``tiles`` are per millimetre; where they are 0, the coordinates are rows (4,) times (x, y, z, 1), metres.
    """

    image: Any
    tiles: tuple[float, float]
    along_u: tuple[float, ...]
    along_v: tuple[float, ...]

    @classmethod
    def of(
        cls,
        share: npt.NDArray[Any],
        tiles: tuple[float, float],
        along_u: tuple[float, ...],
        along_v: tuple[float, ...],
    ) -> Mask:
        """Return the mask of an image (h, w), 0…1, its first row at v = 0."""
        tensor = np.asarray(share)[..., None]
        return cls(texture(tensor, repeat=tiles[0] != 0.0), tiles, along_u, along_v)

    def share(self, place: Place) -> Any:
        """Return the share, 0 to 1, at a place."""
        if self.tiles[0] != 0.0:
            at = mi.Point2f(place.uv.x * number(self.tiles[0]), place.uv.y * number(self.tiles[1]))
        else:
            at = mi.Point2f(*(self._along(row, place.position) for row in (self.along_u, self.along_v)))
        return dr.clip(look_up(self.image, at), 0.0, 1.0)

    @staticmethod
    def _along(row: tuple[float, ...], position: Any) -> Any:
        x, y, z, w = (number(value) for value in row)
        return x * position.x + y * position.y + z * position.z + w


@dataclass(frozen=True, eq=False)
class TwoToneBsdf:
    """A two-tone paint: the second paint where the mask is 1."""

    first: LayeredPaintBsdf
    second: LayeredPaintBsdf
    mask: Mask

    @property
    def samplers(self) -> Sequence[Sampler]:
        """Those of the first paint, on a plain surface."""
        return self.first.samplers

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr of the first paint, on a plain surface."""
        return self.first.eval(light, view)

    def at(self, place: Place, view: Vector) -> LocalBsdf:
        """Return the two at a place, by their shares."""
        share = self.mask.share(place)
        one, two = self.first.at(place, view), self.second.at(place, view)
        samplers: list[Sampler] = [WeightedSampler(sampler, 1.0 - share) for sampler in one.samplers]
        samplers += [WeightedSampler(sampler, share) for sampler in two.samplers]

        def reflected(light: Vector, view: Vector) -> Colour:
            return dr.lerp(one.reflected(light, view), two.reflected(light, view), share)

        return LocalBsdf(samplers, reflected)


def _of_layer(
    term: Any,
    frame: Frame,
    light: Vector,
    view: Vector,
    flaked: Callable[[Colour, Vector, Vector], Colour] | None,
) -> Colour:
    light, view = frame.to_local(light), frame.to_local(view)
    above = (light.z > 0.0) & (view.z > 0.0)
    value = term.eval(light, view)
    if flaked is not None:
        value = flaked(value, light, view)
    return dr.select(above, value * light.z, mi.Color3f(0.0))


def _frame_of_flakes(place: Place, below: Frame) -> Callable[..., Vector]:
    """Return the rotation of directions from the tilted frame to that of the flakes, fixed on the object, and ``back``.

    The tangents are those of the shader's ``local_frame`` (Duff et al., JCGT 6(1), 2017), of the normal in the world.
    """
    n = place.to_world(below.n)
    side = dr.select(n.z >= 0.0, mi.Float(1.0), mi.Float(-1.0))
    a = -1.0 / (side + n.z)
    b = n.x * n.y * a
    s = mi.Vector3f(1.0 + side * n.x * n.x * a, side * b, -side * n.x)
    t = mi.Vector3f(b, side + n.y * n.y * a, -n.y)

    def turned(direction: Vector, *, back: bool = False) -> Vector:
        if back:
            world = direction.x * s + direction.y * t + direction.z * n
            return below.to_local(place.from_world(world))
        world = place.to_world(below.to_world(direction))
        return mi.Vector3f(dr.dot(world, s), dr.dot(world, t), direction.z)

    return turned
