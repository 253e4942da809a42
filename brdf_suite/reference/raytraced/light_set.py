"""Lights of a picture: strata of the environment, optionally resampled for each round, and lamps.

The first round's lights are those of :func:`brdf_suite.lighting.lights.directional_lights`: each the mean direction of
its stratum, with all of its light (equation 4). What l lights leave out is then the same in every picture. For a
picture that is to converge, later rounds put each light at a place drawn from its stratum, as often as there is light,
with the strength that keeps the mean of all rounds the environment itself.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property, reduce

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats
from brdf_suite.documents.view_settings import Lamp
from brdf_suite.geometry.directions import about_y, from_horizon
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.latlong import direction
from brdf_suite.lighting.lights.cells import Cells, sum_cells
from brdf_suite.lighting.lights.extract import DEFAULT_METHOD, METHODS, lights_from_labels
from brdf_suite.reference.scene.lamps import lamp_power

_GOLDEN = 0.6180339887498949


ENVIRONMENT, SUN, FAR_LAMP, NEAR_LAMP = 0, 1, 2, 3
"""Kinds of light: of the environment; of it, small and strong; a lamp in one direction, or at one place."""
SMALL = 0.012
"""Radians: the spread up to which a light is a sun, much narrower than the lobes that it then lights."""
STRONG = 0.02
"""Of all light: weaker ones may be found by reflected rays as well."""


@dataclass(frozen=True, eq=False)
class LightSet:
    """Lights (n,): ``places`` (n, 3) towards them, unit, or where they are, metres; ``strengths`` (n, 3): the
    irradiance of a surface that faces them, at 1 m from a near lamp; ``spreads`` (n,) rad along one axis; ``kinds``.
    """

    places: Floats
    strengths: Floats
    spreads: Floats
    kinds: npt.NDArray[np.uint32]

    def __len__(self) -> int:
        return len(self.kinds)

    def turned(self, degrees: float) -> LightSet:
        """Return the set with the environment's lights turned about y, counter-clockwise seen from above."""
        turned = self.places @ about_y(math.radians(degrees)).T
        return replace(self, places=np.where((self.kinds <= SUN)[:, None], turned, self.places))

    def with_lamps(self, lamps: Sequence[Lamp], turn: int = 0) -> LightSet:
        """Return the set with the lamps of a view; those with an extent are :data:`PLACES` lights in each ``turn``."""
        return reduce(LightSet.joined, (lamp_lights(lamp, turn) for lamp in lamps), self)

    def joined(self, other: LightSet) -> LightSet:
        """Return both in one set."""
        pairs = (
            (getattr(self, name), getattr(other, name))
            for name in ("places", "strengths", "spreads", "kinds")
        )
        return LightSet(*(np.concatenate(pair) for pair in pairs))

    def dealt(self, hands: int) -> LightSet:
        """Return the set in the order in which ``hands`` take a light in turn, as many each.

        A light that has more than a hand's share of all light is cut into equal ones, so that it is seen by more
        than one sample of a pixel: an edge in the sun is then as smooth as any. Neighbours in strength go to
        hands that are far apart, so that the first few hands already have about the light of all.
        """
        luminous = self.strengths @ LUMINANCE
        total = float(luminous.sum())
        cuts = np.ones(len(self), np.intp)
        if total > 0.0:
            cuts = np.maximum(np.rint(hands * luminous / total), 1.0).astype(np.intp)
        each = np.repeat(np.arange(len(self)), cuts)
        rows = -(-len(each) // hands)
        turns = np.argsort(np.argsort((np.arange(hands) * _GOLDEN) % 1.0))
        place = np.arange(len(each))
        place = turns[place % hands] + hands * (place // hands)
        # The rest of the last row is black.
        source = np.full(rows * hands, -1)
        source[place] = each
        lit = source >= 0
        return LightSet(
            np.where(lit[:, None], self.places[source], [0.0, 1.0, 0.0]),
            np.where(lit[:, None], (self.strengths / cuts[:, None])[source], 0.0),
            np.where(lit, self.spreads[source], 0.0),
            np.where(lit, self.kinds[source], 0).astype(np.uint32),
        )

    def draws(self) -> tuple[npt.NDArray[np.uint32], Floats]:
        """Return which lights to draw, (2, K), as often as they have light, and the factors on their strengths, (2, n).

        The first row is for any surface, the second for a level ground, which lights from below do not reach. A place
        drawn from a row evenly gives the light of all on the average.
        """
        luminous = self.strengths @ LUMINANCE
        up = self.ground_cosines()
        size = 1 << max(10, math.ceil(math.log2(8 * max(len(self), 1))))
        entries, factors = zip(*(_entries(light, size) for light in (luminous, luminous * up)), strict=True)
        return np.stack(entries), np.stack(factors)

    def ground_cosines(self) -> Floats:
        """Return the cosine (n,) of the environment's lights to a level ground, 0 for lamps."""
        return np.where(self.kinds <= SUN, np.maximum(self.places[:, 1], 0.0), 0.0)


@dataclass(frozen=True, eq=False)
class Strata:
    """An environment cut into strata of about equal light: ``labels`` (h, w) of ``cells``."""

    cells: Cells
    labels: npt.NDArray[np.intp]
    tint: Floats

    @classmethod
    def of(cls, environment: Environment, count: int, tint: Floats, method: str = DEFAULT_METHOD) -> Strata:
        """Return the strata of ``count`` lights; ``tint`` (3, 3) is what their colours are multiplied by."""
        cells = sum_cells(environment.radiance)
        return cls(cells, METHODS[method](cells, count), tint)

    def tinted(self, tint: Floats) -> Strata:
        """Return the same strata in another light colour."""
        return replace(self, tint=tint)

    @cached_property
    def _order(self) -> tuple[npt.NDArray[np.intp], Floats, Floats]:
        at = self.labels.ravel()
        count = int(at.max()) + 1
        cells = self.cells
        luminous = np.asarray(np.bincount(at, cells.luminous.ravel(), count), np.float64)
        # Weighed by radiance once more: a sun in its piece of sky is as small as the sun, which has most of the light.
        peaks = (cells.luminous / cells.areas()).ravel()
        moments = cells.moments.reshape(-1, 3) * peaks[:, None]
        towards = np.stack([np.bincount(at, moments[:, k], count) for k in range(3)], axis=1)
        # Of directions about a mean, 1 - |mean| is the variance along one axis.
        weight = np.bincount(at, cells.luminous.ravel() * peaks, count)
        length = np.linalg.norm(towards, axis=1) / np.maximum(weight, 1e-300)
        spreads = np.sqrt(np.clip(1.0 - length, 0.0, 1.0))
        return np.argsort(-luminous, kind="stable"), luminous, np.asarray(spreads, np.float64)

    def middles(self) -> LightSet:
        """Return the lights in the mean directions of their strata, the strongest first."""
        lights = lights_from_labels(self.cells, self.labels)
        order, _, _ = self._order
        return self._set(lights.directions, lights.strengths, order)

    def drawn(self, seed: int) -> LightSet:
        """Return lights drawn from the strata: the mean over all seeds is the environment."""
        rng = np.random.default_rng(seed)
        order, luminous, _ = self._order
        at, light = self.labels.ravel(), self.cells.luminous.ravel()
        by_label = np.argsort(at, kind="stable")
        sums = np.cumsum(light[by_label])
        ends = np.cumsum(np.bincount(at, minlength=len(luminous)))
        before = np.concatenate([[0.0], sums])[np.concatenate([[0], ends[:-1]])]
        wanted = before + rng.random(len(luminous)) * luminous
        found = np.minimum(np.searchsorted(sums, wanted, side="right"), ends - 1)
        found = by_label[np.maximum(found, np.concatenate([[0], ends[:-1]]))]
        row, column = np.divmod(found, self.cells.shape[1])
        u, v = rng.random((2, len(found)))
        theta = self.cells.theta
        # Even in solid angle within the cell.
        cosine = np.cos(theta[row]) + u * (np.cos(theta[row + 1]) - np.cos(theta[row]))
        starts = np.concatenate([[0.0], np.cumsum(self.cells.widths)[:-1]]) - np.pi
        phi = starts[column] + v * self.cells.widths[column]
        towards = direction(np.arccos(np.clip(cosine, -1.0, 1.0)), phi)
        factor = np.divide(luminous, light[found], out=np.zeros(len(found)), where=light[found] > 0.0)
        strengths = self.cells.energy.reshape(-1, 3)[found] * factor[:, None]
        places = (towards @ about_y(self.cells.turn).T)[order]
        # Each is one direction of its stratum, and together they are as wide as it.
        return replace(self._set(places, strengths[order], order), spreads=np.zeros(len(order)))

    @cached_property
    def _suns(self) -> npt.NDArray[np.bool_]:
        """Return which strata are suns, by their labels."""
        _, luminous, spreads = self._order
        return np.asarray((spreads <= SMALL) & (luminous >= STRONG * max(float(luminous.sum()), 1e-300)))

    def without_suns(self, radiance: npt.NDArray[np.float32]) -> npt.NDArray[np.float32]:
        """Return a map (h, w, 3) of the size of the environment's, black where its strata are suns."""
        if not self._suns.any():
            return radiance
        height, width = radiance.shape[:2]
        columns = self.labels.shape[1]
        step = -(-width // columns)
        wide = np.repeat(np.repeat(self._suns[self.labels], step, axis=0)[:height], step, axis=1)[:, :width]
        # The cells begin at another column than the map.
        first = round(-self.cells.turn * width / (2.0 * math.pi))
        return np.where(np.roll(wide, first, axis=1)[..., None], np.float32(0.0), radiance)

    def _set(self, places: Floats, strengths: Floats, order: npt.NDArray[np.intp]) -> LightSet:
        coloured = np.maximum(strengths @ self.tint.T, 0.0)
        kinds = np.where(self._suns[order], SUN, ENVIRONMENT).astype(np.uint32)
        return LightSet(places, coloured, self._order[2][order], kinds)


def _entries(light: Floats, size: int) -> tuple[npt.NDArray[np.uint32], Floats]:
    """``size`` numbers of lights, each as often as it has light, at least once; what each then represents."""
    total = float(light.sum())
    if not total > 0.0:
        return np.zeros(size, np.uint32), np.zeros(len(light))
    lit = light > 0.0
    spare = size - int(lit.sum())
    exact = light / total * spare
    counts = np.where(lit, 1 + np.floor(exact).astype(np.intp), 0)
    rest = size - int(counts.sum())
    counts[np.argsort(-(exact - np.floor(exact)), kind="stable")[:rest]] += 1
    counts = np.where(lit | (counts == 0), counts, 0)
    entries = np.repeat(np.arange(len(light)), counts)
    entries = np.resize(entries, size)  # whole already, but where a black light was given one
    counts = np.bincount(entries, minlength=len(light))
    return entries.astype(np.uint32), np.divide(size, counts, out=np.zeros(len(light)), where=counts > 0)


PLACES = 48
"""Lights that a lamp with an extent is made of."""


def lamp_lights(lamp: Lamp, turn: int = 0) -> LightSet:
    """Return a lamp as lights: one, or :data:`PLACES` in its extent, other ones in each ``turn``.

    ``strength`` of a lamp is its illuminance over π, of a point lamp at 1 m.
    """
    power = lamp_power(lamp)
    near = lamp.kind == "point"
    middle = np.array(lamp.position, float) if near else from_horizon(lamp.azimuth_deg, lamp.elevation_deg)
    extent = 0.5 * lamp.diameter if near else math.radians(0.5 * lamp.angle_deg)
    count = PLACES if extent > 0.0 else 1
    places = middle[None].repeat(count, axis=0)
    if extent > 0.0:
        places = places + extent * (_in_ball(count, turn) if near else _on_disc(count, turn, middle))
    if not near:
        places /= np.linalg.norm(places, axis=1, keepdims=True)
    kinds = np.full(count, NEAR_LAMP if near else FAR_LAMP, np.uint32)
    return LightSet(places, np.tile(power / count, (count, 1)), np.zeros(count), kinds)


def _spiral(count: int, turn: int) -> tuple[Floats, Floats]:
    """Return even numbers (count,), 0 to 1, and angles (count,), radians, that fill a disc (Vogel 1979)."""
    number = np.arange(count) + (0.5 + turn * _GOLDEN) % 1.0
    return np.asarray(number / count), np.asarray(2.0 * math.pi * _GOLDEN * (np.arange(count) + count * turn))


def _on_disc(count: int, turn: int, facing: Floats) -> Floats:
    """Return places (count, 3) spread evenly over a disc of radius 1 that faces a unit direction (3,)."""
    even, angle = _spiral(count, turn)
    aside = np.array([1.0, 0.0, 0.0]) if abs(facing[0]) < 0.7 else np.array([0.0, 0.0, 1.0])
    right = np.cross(aside, facing)
    right /= np.linalg.norm(right)
    up = np.cross(facing, right)
    return np.asarray(np.sqrt(even)[:, None] * (np.cos(angle)[:, None] * right + np.sin(angle)[:, None] * up))


def _in_ball(count: int, turn: int) -> Floats:
    """Return places (count, 3) in a ball of radius 1 that are seen as an even disc from every side.

    Their density is as 1/√(1 - r²), Abel's transform of an even disc: with r = sin t, the share of those within is
    (2 t - sin 2t)/π.
    """
    even, angle = _spiral(count, turn)
    t = np.linspace(0.0, 0.5 * math.pi, 513)
    # Radii in another order than heights, so that the two go together in every way.
    radius = np.sin(
        np.interp((even + np.arange(count) * 0.7548776662) % 1.0, (2.0 * t - np.sin(2.0 * t)) / math.pi, t)
    )
    height = 1.0 - 2.0 * even
    level = np.sqrt(1.0 - height**2)
    towards = np.stack([level * np.cos(angle), height, level * np.sin(angle)], axis=1)
    return np.asarray(radius[:, None] * towards)
