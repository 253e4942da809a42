"""Tracing loops: samples of a pixel, shadow rays to the lights, reflected rays.

For each sample k of a pixel's p (Günther et al. 2005, section 5.3):

- a ray through the pixel meets the surface, the ground, or nothing;
- there, of the l lights those numbered k, k + p, k + 2p … are looked at, each with p times its strength (equation 4):
  over the p samples every light is counted once, and no noise is left of the choice;
- s/p rays are reflected by the narrow lobes (equation 5). Where such a ray leaves the scene, it brings the
  environment's light; where it meets the surface again, a few lights are looked at there, drawn by their strength, and
  it is reflected on, a few times.

What is neglected, as in the paper: light that the broad part of one place sends to another place's broad part.

Everything is one program for all pixels. Radiance is added up within it and written once: nothing is splatted, and no
channel is traced apart.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from operator import or_
from types import MappingProxyType
from typing import Any

import numpy as np

from brdf_suite.documents.view_settings import Lamp
from brdf_suite.reference.bsdfs import directions as d
from brdf_suite.reference.bsdfs.directions import Colour, Real, Vector
from brdf_suite.reference.flakes.cells import scramble
from brdf_suite.reference.flakes.population import FlakeLayer
from brdf_suite.reference.flakes.texture import FlakesSeen, flakes_seen
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reference.raytraced.flakes import sparkling
from brdf_suite.reference.raytraced.light_set import ENVIRONMENT, NEAR_LAMP, SUN, LightSet
from brdf_suite.reference.raytraced.numbers import in_cube, in_pixel
from brdf_suite.reference.raytraced.quality import Quality
from brdf_suite.reference.raytraced.sky import TracedSky
from brdf_suite.reference.raytraced.surface import Surface, SurfaceHit
from brdf_suite.reference.scene.camera import Pinhole
from brdf_suite.reference.scene.lamps import LampAim, lamp_power

_GOLDEN = 0x9E3779B9
"""The golden ratio's part of 2³²: places of a sequence that fills the circle evenly."""
NONE_SEEN: Mapping[int, FlakesSeen] = MappingProxyType({})
"""No flakes are seen one by one."""
DEFAULT_DEPTH = 4
"""Reflections one after the other: between clearcoats each leaves a twentieth of the light, towards grazing more."""


@dataclass(frozen=True, eq=False)
class OpenLamp:
    """A lamp in the renderer's memory, without its extent: ``place`` in metres where it is ``near``, else direction."""

    place: Vector
    power: Colour
    near: bool

    @classmethod
    def of(cls, lamp: Lamp) -> OpenLamp:
        """Return a lamp of a view."""
        aim = LampAim.of(lamp)
        place = mi.Vector3f(*(d.number(x) for x in aim.place))
        return cls(place, d.colour(lamp_power(lamp).tolist()), aim.near)

    def on_level(self, place: Vector) -> Colour:
        """Return the irradiance of a level place that sees it."""
        way = self.place - place if self.near else self.place
        nearness = dr.rcp(dr.squared_norm(way))
        return self.power * (nearness * dr.sqrt(nearness) * dr.maximum(way.y, 0.0))


@dataclass(frozen=True, eq=False)
class LightArrays:
    """Lights in the renderer's memory; see :class:`~.light_set.LightSet`.

    ``entries`` (2 × 2^``entry_bits``) and ``factors`` (2 × n) are those of :meth:`~.light_set.LightSet.draws`;
    ``open_ground`` (3,) is the irradiance of a level ground with nothing on it by the environment, ``lamps`` what adds
    to it.
    """

    places: Any
    strengths: Any
    spreads: Any
    kinds: Any
    entries: Any
    entry_bits: Any
    factors: Any
    open_ground: Colour
    lamps: tuple[OpenLamp, ...]
    has_suns: bool

    @classmethod
    def of(cls, dealt: LightSet, lamps: Sequence[Lamp] = ()) -> LightArrays:
        """Return the arrays of a set that was dealt, and that has the lights of ``lamps``."""
        entries, factors = dealt.draws()
        places, strengths, spreads, drawn = (
            mi.Float(np.ascontiguousarray(a, np.float32).ravel())
            for a in (dealt.places, dealt.strengths, dealt.spreads, factors)
        )
        kinds, table = mi.UInt32(dealt.kinds), mi.UInt32(entries.ravel())
        dr.eval(places, strengths, spreads, drawn, kinds, table)
        ground = d.colour(np.maximum(dealt.ground_cosines() @ dealt.strengths, 1e-12).tolist())
        bits = dr.opaque(mi.UInt32, int(entries.shape[1]).bit_length() - 1)
        suns, alone = bool((dealt.kinds == SUN).any()), tuple(map(OpenLamp.of, lamps))
        return cls(places, strengths, spreads, kinds, table, bits, drawn, ground, alone, suns)

    def open_light(self, place: Vector) -> Colour:
        """Return the irradiance of a level ground at a place with nothing on it."""
        return sum((lamp.on_level(place) for lamp in self.lamps), start=self.open_ground)


@dataclass(frozen=True, eq=False)
class SampleBudget:
    """How many lights each of the ``hands`` p samples gets, how many rays it reflects, how many lights such a ray."""

    hands: Any
    lights: Any
    rays: Any
    lights_a_ray: Any

    @classmethod
    def of(cls, quality: Quality, lights: int) -> SampleBudget:
        """Return the numbers for ``lights`` that were dealt; other numbers needs no recompilation."""
        hands, rays = quality.samples, quality.reflections_a_sample
        numbers = (hands, lights // hands, rays, -(-quality.lights_a_sample // rays))
        return cls(*(dr.opaque(mi.UInt32, n) for n in numbers))


@dataclass(frozen=True, eq=False)
class TracerScene:
    """The traced scene. ``materials`` are splits, by their numbers; the ground's ``height`` is None for none.

    ``sparkles`` are the flakes of those materials that have some, by their numbers.
    """

    surface: Surface
    materials: Sequence[Any]
    sky: TracedSky
    lights: LightArrays
    height: Real | None
    sparkles: Mapping[int, FlakeLayer]
    depth: int = DEFAULT_DEPTH


@dataclass
class TracedSums:
    """Sums over samples: radiance of the object, its coverage, and the ground's darkening."""

    radiance: Colour
    coverage: Real
    darkness: Colour


def trace(
    stage: TracerScene, camera: Pinhole, deal: SampleBudget, column: Any, row: Any, first: Any, count: Any
) -> TracedSums:
    """Return the sums over ``count`` samples from number ``first`` on, for pixels at ``column`` and ``row``.

    Sample numbers go on beyond p in later rounds.
    """
    turn = scramble(row * mi.UInt32(0x10001) + column)

    def one_more(k: Any, radiance: Colour, coverage: Real, darkness: Colour) -> tuple[Any, ...]:
        origin, direction = camera.ray(column, row, in_pixel(k))
        origin = stage.surface.beyond_panes(origin, direction, k, turn, mi.Bool(True))
        met, on_ground, hit = _meeting(stage, origin, direction, mi.Bool(True), coherent=True)
        seen = _flakes(stage, camera, direction, hit, met)
        hand = k % deal.hands

        def dealt(i: Any, _on_ground: Any) -> tuple[Any, Real]:
            return hand + i * deal.hands, mi.Float(deal.hands)

        light, shade = _lit(stage, hit, met, on_ground, dealt, deal.lights, seen, lamps_on_ground=True)
        light = light + _reflected(stage, deal, hit, met, k, turn)
        radiance = radiance + dr.select(met, light, 0.0)
        coverage = coverage + dr.select(met, 1.0, 0.0)
        darkness = darkness + dr.select(on_ground, 1.0 - shade, 0.0)
        return k + 1, radiance, coverage, darkness

    end = first + count
    state = (first + dr.zeros(mi.UInt32, dr.width(column)), mi.Color3f(0.0), mi.Float(0.0), mi.Color3f(0.0))
    _, radiance, coverage, darkness = dr.while_loop(
        state, lambda k, *_: k < end, one_more, label="samples of a pixel"
    )
    return TracedSums(radiance, coverage, darkness)


def _meeting(
    stage: TracerScene, origin: Vector, direction: Vector, active: Any, *, coherent: bool
) -> tuple[Any, Any, SurfaceHit]:
    """Whether rays meet the surface, whether else the ground, and where either is."""
    far, hit = stage.surface.meet(origin, direction, active, coherent=coherent)
    met = active & dr.isfinite(far)
    if stage.height is None:
        return met, mi.Bool(False), hit
    down = (stage.height - origin.y) / direction.y
    on_ground = active & (direction.y < 0.0) & (down > 0.0) & ~(met & (far < down))
    met &= ~on_ground
    place = dr.fma(down, direction, origin)
    up = mi.Vector3f(0.0, 1.0, 0.0)
    hit.place = dr.select(on_ground, place, hit.place)
    hit.off = dr.select(on_ground, place + 1e-4 * up, hit.off)
    hit.normal = dr.select(on_ground, up, hit.normal)
    hit.view = -direction
    return met, on_ground, hit


def _flakes(
    stage: TracerScene, camera: Pinhole, direction: Vector, hit: SurfaceHit, met: Any
) -> Mapping[int, FlakesSeen]:
    """Return the flakes of the pixel, by the number of the material that they are in."""
    if not stage.sparkles:
        return {}
    far = dr.norm(hit.place - camera.place)
    across, down = camera.footprint(direction, far, hit.normal)
    material = stage.surface.material(hit, met)
    painted = met & reduce(or_, (material == number for number in stage.sparkles))
    at, per_column, per_row = stage.surface.texture_place(hit, across, down, painted)
    return {
        number: flakes_seen(layer.flakes, at, per_column, per_row) for number, layer in stage.sparkles.items()
    }


Pick = Callable[[Any, Any], tuple[Any, Real]]
"""From a count to the number of a light, and the factor on its strength; whether for the ground."""


def _drawn_lights(lights: LightArrays, deal: SampleBudget, word: Any) -> Pick:
    """Return lights sampled in proportion to their power by systematic sampling from an offset given by ``word``.

    The few lights of a reflected ray represent all of them: dealt, most rays would miss the sun.
    """

    def pick(i: Any, on_ground: Any) -> tuple[Any, Real]:
        step = mi.UInt32(0xFFFFFFFF) // deal.lights_a_ray
        at = (word + i * step) >> (32 - lights.entry_bits)
        size = mi.UInt32(1) << lights.entry_bits
        count = dr.opaque(mi.UInt32, len(lights.kinds))
        which = dr.gather(mi.UInt32, lights.entries, at + dr.select(on_ground, size, 0))
        factor = dr.gather(mi.Float, lights.factors, which + dr.select(on_ground, count, 0))
        return which, factor / mi.Float(deal.lights_a_ray)

    return pick


def _lit(
    stage: TracerScene,
    hit: SurfaceHit,
    met: Any,
    on_ground: Any,
    pick: Pick,
    number: Any,
    seen: Mapping[int, FlakesSeen] = NONE_SEEN,
    *,
    lamps_on_ground: bool = False,
) -> tuple[Colour, Colour]:
    """Return the reflected light of ``number`` lights, and the fraction of an open ground's light that arrives.

    Lights that are drawn for the ground are those of the environment alone; where all are dealt, lamps count too.
    """
    lights = stage.lights
    lamps_on_ground = lamps_on_ground and bool(lights.lamps)
    open_ground = lights.open_light(hit.place) if lamps_on_ground else lights.open_ground
    frame = mi.Frame3f(hit.normal)
    view = frame.to_local(hit.view)
    material = stage.surface.material(hit, met)

    def one_more(i: Any, light: Colour, shade: Colour) -> tuple[Any, ...]:
        index, factor = pick(i, on_ground)
        place = dr.gather(mi.Vector3f, lights.places, index)
        strength = dr.gather(mi.Color3f, lights.strengths, index)
        towards, length, share = place, mi.Float(dr.inf), mi.Float(1.0)
        kind, for_ground = mi.UInt32(ENVIRONMENT), on_ground
        if lights.lamps or lights.has_suns:
            kind = dr.gather(mi.UInt32, lights.kinds, index)
        if lights.lamps:
            away = place - hit.off
            distance = dr.norm(away)
            close = kind == NEAR_LAMP
            towards = dr.select(close, away / distance, place)
            length = dr.select(close, distance, length)
            share = dr.select(close, dr.rcp(dr.square(distance)), share)
            if not lamps_on_ground:
                for_ground = on_ground & (kind <= SUN)
        cosine = dr.dot(hit.normal, towards)
        lit = (met | for_ground) & (cosine > 0.0) & (dr.max(strength) > 0.0)
        share = share * stage.surface.arriving(hit.off, towards, length, lit)
        lit &= share > 0.0
        local = frame.to_local(towards)
        arriving = strength * (cosine * share * factor)
        spread = dr.gather(mi.Float, lights.spreads, index)
        value = _value(stage, material, local, view, kind, seen, spread, met)
        light = light + dr.select(lit & met, value * arriving, 0.0)
        shade = shade + dr.select(lit & for_ground, arriving / open_ground, 0.0)
        return i + 1, light, shade

    state = (mi.UInt32(0), mi.Color3f(0.0), mi.Color3f(0.0))
    _, light, shade = dr.while_loop(
        state, lambda i, *_: (i < number) & (met | on_ground), one_more, label="lights"
    )
    return light, shade


def _value(
    stage: TracerScene,
    material: Any,
    light: Vector,
    view: Vector,
    kind: Any,
    seen: Mapping[int, FlakesSeen],
    spread: Real,
    active: Any,
) -> Colour:
    """Return f_r of the broad part.

    In a lamp's light, which no reflected ray finds, the whole; in a sun's the lobes whose rays leave suns out as well.
    """

    def of(split: Any) -> Any:
        def value(light: Vector, view: Vector, kind: Any, spread: Real, active: Any) -> Colour:
            above = active & (light.z > 0.0) & (view.z > 0.0)
            total = split.broad.lit(light, view, spread)
            if stage.lights.lamps and split.narrow:
                total = total + dr.select(kind > SUN, split.narrow_value(light, view), 0.0)
            if stage.lights.has_suns and split.sunlit:
                total = total + dr.select(kind == SUN, split.narrow_value(light, view, sunlit=True), 0.0)
            return dr.select(above, total, 0.0)

        return value

    values = [of(split) for split in stage.materials]
    if len(values) == 1:
        value = values[0](light, view, kind, spread, active)
    else:
        value = dr.switch(material, values, light, view, kind, spread, active)
    for number, flakes in seen.items():
        bright = sparkling(stage.sparkles[number], flakes, light, view, spread, value)
        value = dr.select(material == number, bright, value)
    return value


def _reflected(
    stage: TracerScene, deal: SampleBudget, hit: SurfaceHit, met: Any, k: Any, turn: Any
) -> Colour:
    """Return the light reflected by the narrow lobes of a sample."""
    if not any(split.narrow for split in stage.materials):
        return mi.Color3f(0.0)
    material = stage.surface.material(hit, met)

    def one_ray(j: Any, light: Colour) -> tuple[Any, ...]:
        number = k * deal.rays + j

        def one_bounce(
            bounce: Any,
            going: Any,
            weight: Colour,
            light: Colour,
            off: Vector,
            normal: Vector,
            view: Vector,
            material: Any,
        ) -> tuple[Any, ...]:
            frame = mi.Frame3f(normal)
            choice, u = in_cube(number, turn + bounce * mi.UInt32(0x85EBCA6B))
            local, factor, suns = _drawn(stage, material, frame.to_local(view), choice, u, going)
            weight = weight * factor
            direction = frame.to_world(local)
            going &= dr.max(weight) > 0.0
            start = stage.surface.beyond_panes(off, direction, number, turn + bounce + 1, going)
            met, on_ground, hit = _meeting(stage, start, direction, going, coherent=False)
            word = number * mi.UInt32(_GOLDEN) + scramble(turn + bounce)
            pick = _drawn_lights(stage.lights, deal, word)
            arriving, shade = _lit(stage, hit, met, on_ground, pick, deal.lights_a_ray)
            gone = going & ~met
            sky = stage.sky.along(direction, gone, suns > 0.5)
            arriving = dr.select(gone, dr.select(on_ground, sky * shade, sky), arriving)
            light = light + dr.select(going, weight * arriving, 0.0)
            going &= met
            material = stage.surface.material(hit, going)
            return bounce + 1, going, weight, light, hit.off, hit.normal, hit.view, material

        # Copies: a loop leaves its results in the very variables that it was given.
        places = (mi.Vector3f(vector) for vector in (hit.off, hit.normal, hit.view))
        colours = mi.Color3f(1.0), mi.Color3f(0.0)
        state: tuple[Any, ...] = (mi.UInt32(0), mi.Bool(met), *colours, *places, mi.UInt32(material))
        found = dr.while_loop(
            state, lambda bounce, going, *_: going & (bounce < stage.depth), one_bounce, label="reflections"
        )
        return j + 1, light + found[3]

    start = mi.UInt32(0), mi.Color3f(0.0)
    _, total = dr.while_loop(start, lambda j, *_: met & (j < deal.rays), one_ray, label="reflected rays")
    light: Colour = total
    return light / mi.Float(deal.rays)


def _drawn(
    stage: TracerScene, material: Any, view: Vector, choice: Real, u: Any, active: Any
) -> tuple[Vector, Colour, Real]:
    def of(split: Any) -> Any:
        def sample(view: Vector, choice: Real, u: Any, _active: Any) -> tuple[Vector, Colour, Real]:
            drawn: tuple[Vector, Colour, Real] = split.sample(view, choice, u)
            return drawn

        return sample

    draws = [of(split) for split in stage.materials]
    if len(draws) == 1:
        found: tuple[Vector, Colour, Real] = draws[0](view, choice, u, active)
    else:
        found = dr.switch(material, draws, view, choice, u, active)
    return found
