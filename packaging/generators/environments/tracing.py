"""Path-traced panoramas: the lights of a scene, and passes of samples.

A scene is the sum of its lights (:class:`Light`): each is traced alone, with all samples going where its light comes
from, and the pictures are added (:mod:`environments.sums`). Nothing is filtered; noise is what is left after the
samples.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.reference.mitsuba_modules import dr, mi
from environments.stage import Panel


@dataclass(frozen=True, eq=False)
class Light:
    """One of the lights of a scene, as a scene of Mitsuba; ``prepare(scene, number)`` may move it for a pass.

    ``panels`` are its luminous rectangles: what is seen gets light from a place on each of them. ``directions`` counts
    the samples of the emitters as a whole instead, for a sky. ``cap``
    (kcd/m²) bounds what a single path brings to a surface that is no mirror: without it, a few paths that end beside a
    lamp would stay visible as white specks.
    """

    name: str
    scene: Any
    depth: int
    cap: float
    panels: tuple[Panel, ...] = ()
    directions: int = 0
    prepare: Callable[[Any, int], None] | None = None


@dataclass(frozen=True, eq=False)
class TracedScene:
    """A scene: its lights, and ``finish(picture)``, which adds what is not traced, such as the sun's disc."""

    name: str
    description: str
    lights: tuple[Light, ...]
    eye: tuple[float, float, float]
    finish: Callable[[Floats], Floats] = field(default=lambda traced: traced)


_STEPS = (3242174889, 2447445414)
"""1/ρ and 1/ρ² as fractions of 2³², ρ = 1.3247…: the additive sequence R2 (M. Roberts 2018), even in two dimensions."""


class _Sequence:
    """Numbers that are even over the samples of a pixel, with an offset of their own for each pixel and each use."""

    def __init__(self, pixel: Any, number: Any, seed: int) -> None:
        self._pixel, self._number = pixel, number
        self._use = 1000 * seed

    def next(self) -> Any:
        """Return the next two numbers, 0…1."""
        self._use += 1
        use: Any = mi.UInt32(self._use)
        offsets = mi.sample_tea_32(self._pixel, use)
        pair = [offset + self._number * mi.UInt32(step) for offset, step in zip(offsets, _STEPS, strict=True)]
        return mi.Point2f(*(mi.Float(value >> 8) * 2.0**-24 for value in pair))


def _panel_light(scene: Any, panel: Panel, surface: Any, bsdf: Any, pair: Any) -> Any:
    """Return what a surface sends back of the light of one place on a panel, over the density of that place.

    Across the panel places are even; along it they are even in the angle seen from the surface (C. Kulla and
    M. Fajardo, "Importance Sampling Techniques for Path Tracing in Participating Media", EGSR 2012).
    """
    half, side = float(np.linalg.norm(panel.along)), float(np.linalg.norm(panel.across))
    axis = mi.Vector3f((panel.along / half).tolist())
    facing = mi.Vector3f((np.cross(panel.along, panel.across) / (half * side)).tolist())
    middle = mi.Point3f(panel.centre.tolist()) + mi.Vector3f(panel.across.tolist()) * (2.0 * pair.y - 1.0)
    offset = surface.p - middle
    nearest = dr.dot(offset, axis)
    apart = dr.maximum(dr.norm(offset - axis * nearest), 1e-3)
    low, high = dr.atan((-half - nearest) / apart), dr.atan((half - nearest) / apart)
    tangent = dr.tan(dr.lerp(low, high, pair.x))
    place = middle + axis * (nearest + apart * tangent)
    density = 1.0 / ((high - low) * apart * (1.0 + tangent * tangent) * 2.0 * side)
    toward = place - surface.p
    distance = dr.norm(toward)
    direction = toward / distance
    cosine = dr.abs(dr.dot(facing, direction))
    local = surface.to_local(direction)
    back = bsdf.eval(mi.BSDFContext(), surface, local)
    wanted = surface.is_valid() & dr.any(back > 0.0)
    seen = scene.ray_intersect(surface.spawn_ray(direction), wanted)
    wanted &= seen.is_valid() & (seen.t > 0.998 * distance)
    radiance = seen.emitter(scene, wanted).eval(seen, wanted)
    return dr.select(wanted, back * radiance * (cosine / (distance * distance * density)), 0.0)


def _sky_light(scene: Any, surface: Any, bsdf: Any, pair: Any, count: int) -> Any:
    """Return what a surface sends back of the light of one of ``count`` directions that the emitters choose.

    The direction in which the path goes on may meet the sky as well: both share its light by the balance heuristic
    (E. Veach and L. Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering", SIGGRAPH 1995).
    """
    context = mi.BSDFContext()
    sample, light = scene.sample_emitter_direction(surface, pair, True, surface.is_valid())
    local = surface.to_local(sample.d)
    back = bsdf.eval(context, surface, local)
    other = dr.select(sample.delta, 0.0, bsdf.pdf(context, surface, local))
    share = sample.pdf / (count * sample.pdf + other)
    return dr.select(surface.is_valid() & (sample.pdf > 0.0), back * light * share, 0.0)


def _sky_share(light: Light, surface: Any, met: Any, density: Any, active: Any) -> Any:
    """Return the share of the light met by the path that goes on, chosen with a density: 1 less the emitters' share."""
    if not light.directions:
        return mi.Float(0.0)
    sample = mi.DirectionSample3f(light.scene, met, surface)
    chosen = light.scene.pdf_emitter_direction(surface, sample, active)
    return dr.select(density > 0.0, density / (density + light.directions * chosen), 0.0)


def _radiance(light: Light, ray: Any, sampler: Any, sequence: _Sequence) -> Any:
    """Return the radiance along rays: of what is seen, of its direct light, and of all paths that go on from there.

    Where lamps are panels, what is met next gets light from all of them too; further on paths choose one at random.
    """
    scene = light.scene
    surface = scene.ray_intersect(ray)
    total = surface.emitter(scene).eval(surface)
    beyond, weight = mi.Color3f(0.0), mi.Color3f(1.0)
    is_mirror = mi.Bool(False)
    vertices = 2 if light.panels else 1
    for vertex in range(vertices):
        bsdf = surface.bsdf(ray)
        direct = mi.Color3f(0.0)
        for panel in light.panels:
            direct += _panel_light(scene, panel, surface, bsdf, sequence.next())
        for _ in range(light.directions):
            direct += _sky_light(scene, surface, bsdf, sequence.next(), light.directions)
        if vertex == 0:
            total += direct
        else:
            beyond += weight * direct
        chosen, part = bsdf.sample(
            mi.BSDFContext(), surface, sampler.next_1d(), sequence.next(), surface.is_valid()
        )
        going = surface.is_valid() & dr.any(part > 0.0)
        weight *= dr.select(going, part, 0.0)
        ray = mi.RayDifferential3f(surface.spawn_ray(surface.to_world(chosen.wo)))
        before, surface = surface, scene.ray_intersect(ray, going)
        mirrored = going & mi.has_flag(chosen.sampled_type, mi.BSDFFlags.Delta)
        is_mirror = mirrored if vertex == 0 else is_mirror
        # A lamp that is met next has been counted as direct light, except in a mirror, and a sky in part.
        share = dr.select(mirrored, 1.0, _sky_share(light, before, surface, chosen.pdf, going))
        met = share * dr.select(going, surface.emitter(scene, going).eval(surface, going), 0.0)
        if vertex == 0:
            total += weight * met
        else:
            beyond += weight * met
    paths = mi.load_dict({"type": "path", "max_depth": light.depth - vertices, "rr_depth": 4})
    arriving, _, _ = paths.sample(scene, sampler, ray, active=going)
    arriving -= surface.emitter(scene, going).eval(surface, going)
    beyond += dr.select(going, weight * arriving, 0.0)
    return total + dr.select(is_mirror, beyond, dr.clip(beyond, 0.0, light.cap))


def trace_pass(
    light: Light,
    eye: tuple[float, float, float],
    height: int,
    pixels: npt.NDArray[np.uint32],
    earlier: npt.NDArray[np.uint32],
    samples: int,
    number: int,
    half: int,
) -> Floats:
    """Return the sums (n, 3) of ``samples`` paths for each of the named pixels of a panorama, kcd/m².

    Parameters
    ----------
    pixels, earlier
        Indices (n,) into rows of 2·height, and how many paths each had before in this half of all, 0 or 1.
    number
        Of the pass, among those of its half.
    """
    width = 2 * height
    if light.prepare is not None:
        light.prepare(light.scene, 2 * number + half)
    count = len(pixels) * samples
    sampler = mi.load_dict({"type": "independent"})
    sampler.seed((65537 * (2 * number + half) + int(pixels[0])) % 2**32, count)
    index = dr.arange(mi.UInt32, count)
    which = index // samples
    pixel = dr.gather(mi.UInt32, mi.UInt32(pixels), which)
    sequence = _Sequence(pixel, index % samples + dr.gather(mi.UInt32, mi.UInt32(earlier), which), half)
    inside = sequence.next()
    theta = (mi.Float(pixel // width) + inside.y) * (np.pi / height)
    phi = ((mi.Float(pixel % width) + inside.x) / width - 0.5) * (2.0 * np.pi)
    across = dr.sin(theta)
    toward = mi.Vector3f(-across * dr.sin(phi), dr.cos(theta), across * dr.cos(phi))
    ray = mi.RayDifferential3f(mi.Point3f(*eye), toward)
    radiance = _radiance(light, ray, sampler, sequence)
    total = dr.zeros(mi.Float, len(pixels) * 3)
    for channel in range(3):
        value = dr.select(dr.isfinite(radiance[channel]), radiance[channel], 0.0)
        dr.scatter_reduce(dr.ReduceOp.Add, total, value, which * 3 + channel)
    return np.array(total, dtype=np.float64).reshape(-1, 3)
