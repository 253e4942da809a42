"""Path-traced panoramas: what a scene is made of, and passes of samples that add up to a map.

Radiance is in kcd/m² and linear Rec. 2020 throughout: Mitsuba's three channels are taken as such, so that colours pass
unconverted. A scene is the sum of its lights (:class:`Light`): each is traced alone, with all samples going where its
light comes from, and the pictures are added. Nothing is filtered; noise is what is left after the samples.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from brdf_suite.arrays import Floats
from brdf_suite.lighting.procedural.panorama import solid_angles
from brdf_suite.reference.mitsuba_modules import dr, mi
from environments.solids import Solid, join

PATHS_IN_A_PASS = 1 << 22


def colour_of(value: ArrayLike) -> dict[str, Any]:
    """Return one colour (3,) as Mitsuba has it."""
    return {"type": "rgb", "value": [float(v) for v in np.asarray(value)]}


def picture(pixels: Floats, wide: float = 1.0, high: float = 1.0) -> dict[str, Any]:
    """Return a bitmap (h, w, 3) that repeats after ``wide`` by ``high`` metres of uv, its row 0 on top."""
    bitmap = mi.Bitmap(np.ascontiguousarray(pixels[::-1], dtype=np.float32))
    scale = mi.ScalarTransform4f().scale([1.0 / wide, 1.0 / high, 1.0])
    return {"type": "bitmap", "bitmap": bitmap, "raw": True, "to_uv": scale, "wrap_mode": "repeat"}


FACE_COLOUR: dict[str, Any] = {"type": "palette"}
"""Stands for the colours of the faces themselves; they become a bitmap with one pixel for each."""


def matt(reflectance: Mapping[str, Any] = FACE_COLOUR) -> dict[str, Any]:
    """Return a matt surface, the same from both sides."""
    return {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": dict(reflectance)}}


def glazed(reflectance: Mapping[str, Any] = FACE_COLOUR, roughness: float = 0.0) -> dict[str, Any]:
    """Return a body colour below a clear coat, polished or of a GGX roughness."""
    kind: dict[str, Any] = {"type": "roughplastic", "distribution": "ggx", "alpha": roughness}
    made = kind if roughness > 0.0 else {"type": "plastic"}
    return {"type": "twosided", "bsdf": made | {"diffuse_reflectance": dict(reflectance), "nonlinear": True}}


def metal(reflectance: ArrayLike, roughness: float) -> dict[str, Any]:
    """Return brushed or painted metal of one colour."""
    base = {"type": "roughconductor", "material": "none", "distribution": "ggx", "alpha": roughness}
    return {"type": "twosided", "bsdf": base | {"specular_reflectance": colour_of(reflectance)}}


def mesh(
    solid: Solid, material: Mapping[str, Any], radiance: Mapping[str, Any] | None = None, power: float = 1.0
) -> Any:
    """Return a mesh of Mitsuba; a palette in its material is that of its faces."""
    normals = _normals(solid) if solid.smooth else None
    points, faces, uv = solid.points, solid.faces, solid.uv
    if _has_palette(material):
        colours, which = np.unique(np.round(solid.colours, 4), axis=0, return_inverse=True)
        palette = {
            "type": "bitmap",
            "bitmap": mi.Bitmap(np.ascontiguousarray(colours[None], dtype=np.float32)),
            "raw": True,
            "filter_type": "nearest",
            "wrap_mode": "clamp",
        }
        material = _with_palette(material, palette)
        # Each face has corners of its own, which lie in its pixel.
        normals = None if normals is None else normals[faces].reshape(-1, 3)
        points, faces = points[faces].reshape(-1, 3), np.arange(faces.size).reshape(-1, 3)
        middle = (which.reshape(-1) + 0.5) / len(colours)
        uv = np.stack([np.repeat(middle, 3), np.full(faces.size, 0.5)], axis=-1)
    properties = mi.Properties()
    properties["mesh_bsdf"] = mi.load_dict(dict(material))
    if radiance is not None:
        properties["mesh_emitter"] = mi.load_dict(
            {"type": "area", "radiance": dict(radiance), "sampling_weight": power}
        )
    made = mi.Mesh(
        "solid",
        len(points),
        len(faces),
        props=properties,
        has_vertex_texcoords=True,
        has_vertex_normals=normals is not None,
    )
    values = mi.traverse(made)
    values["vertex_positions"] = points.astype(np.float32).ravel()
    values["faces"] = faces.astype(np.uint32).ravel()
    values["vertex_texcoords"] = uv.astype(np.float32).ravel()
    if normals is not None:
        values["vertex_normals"] = normals.astype(np.float32).ravel()
    values.update()
    return made


def _has_palette(description: Mapping[str, Any]) -> bool:
    return description == FACE_COLOUR or any(
        _has_palette(v) for v in description.values() if isinstance(v, dict)
    )


def _with_palette(description: Mapping[str, Any], palette: dict[str, Any]) -> dict[str, Any]:
    if description == FACE_COLOUR:
        return palette
    return {key: _with_palette(v, palette) if isinstance(v, dict) else v for key, v in description.items()}


def _normals(solid: Solid) -> Floats:
    corners = solid.points[solid.faces]
    facing = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    # Points in one place share a normal, so that a closed ring has no seam.
    _, same = np.unique(np.round(solid.points, 5), axis=0, return_inverse=True)
    same = same.reshape(-1)
    total = np.zeros((int(same.max()) + 1, 3))
    for i in range(3):
        np.add.at(total, same[solid.faces[:, i]], facing)
    total /= np.maximum(np.linalg.norm(total, axis=1, keepdims=True), 1e-12)
    return np.asarray(total[same])


@dataclass(frozen=True, eq=False)
class Panel:
    """A luminous rectangle: its centre (3,), half its longer side and half its shorter side as vectors (3,)."""

    centre: Floats
    along: Floats
    across: Floats


@dataclass
class Stage:
    """Geometry by material, while a scene is being built."""

    materials: dict[str, dict[str, Any]] = field(default_factory=dict)
    solids: dict[str, list[Solid]] = field(default_factory=dict)
    lamps: list[tuple[Solid, dict[str, Any], float]] = field(default_factory=list)
    panels: list[Panel] = field(default_factory=list)

    def material(self, name: str, bsdf: dict[str, Any]) -> None:
        """Declare a material."""
        self.materials[name] = bsdf

    def add(self, name: str, *solids: Solid) -> None:
        """Put solids of a material there."""
        self.solids.setdefault(name, []).extend(solids)

    def lamp(self, solid: Solid, radiance: dict[str, Any], power: float = 1.0) -> None:
        """Put a luminous surface there; it shines from its front, and of the paths' samples gets its share of power."""
        self.lamps.append((solid, radiance, power))

    def objects(self) -> dict[str, Any]:
        """Return the meshes: one for each material and smoothness, one for each lamp."""
        made: dict[str, Any] = {}
        for name, solids in self.solids.items():
            for smooth in (False, True):
                chosen = [s for s in solids if s.smooth == smooth]
                if chosen:
                    made[f"{name}_{int(smooth)}"] = mesh(join(chosen), self.materials[name])
        for number, (solid, radiance, power) in enumerate(self.lamps):
            made[f"lamp_{number}"] = mesh(solid, matt(colour_of((0.6, 0.6, 0.6))), radiance, power)
        return made


@dataclass(frozen=True, eq=False)
class Light:
    """One of the lights of a scene, as a scene of Mitsuba; ``prepare(scene, number)`` may move it for a pass.

    ``panels`` are its luminous rectangles: what is seen gets light from a place on each of them. ``directions`` counts
    the samples of the emitters as a whole instead, for a sky. ``share`` says how many of the paths it gets. ``cap``
    (kcd/m²) bounds what a single path brings to a surface that is no mirror: without it, a few paths that end beside a
    lamp would stay visible as white specks.
    """

    name: str
    scene: Any
    depth: int
    cap: float
    panels: tuple[Panel, ...] = ()
    directions: int = 0
    share: float = 1.0
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
    light: Light, eye: tuple[float, float, float], height: int, samples: int, first: int, half: int
) -> Floats:
    """Return the mean (height, 2·height, 3) of ``samples`` paths a pixel, kcd/m².

    ``first`` is the number of the first of them in their half of all samples, 0 or 1.
    """
    width = 2 * height
    if light.prepare is not None:
        light.prepare(light.scene, 2 * first + half)
    count = width * height * samples
    sampler = mi.load_dict({"type": "independent"})
    sampler.seed(2 * first + half, count)
    index = dr.arange(mi.UInt32, count)
    pixel = index // samples
    sequence = _Sequence(pixel, index % samples + dr.opaque(mi.UInt32, first), half)
    inside = sequence.next()
    theta = (mi.Float(pixel // width) + inside.y) * (np.pi / height)
    phi = ((mi.Float(pixel % width) + inside.x) / width - 0.5) * (2.0 * np.pi)
    across = dr.sin(theta)
    toward = mi.Vector3f(-across * dr.sin(phi), dr.cos(theta), across * dr.cos(phi))
    radiance = _radiance(light, mi.RayDifferential3f(mi.Point3f(*eye), toward), sampler, sequence)
    total = dr.zeros(mi.Float, width * height * 3)
    for channel in range(3):
        value = dr.select(dr.isfinite(radiance[channel]), radiance[channel], 0.0)
        dr.scatter_reduce(dr.ReduceOp.Add, total, value, pixel * 3 + channel)
    return np.asarray(np.array(total, dtype=np.float64).reshape(height, width, 3) / samples)


@dataclass
class Sums:
    """The sums of the passes of one light, in two halves (2, h, w, 3), with the samples a pixel in each."""

    halves: Floats
    samples: list[int]

    def mean(self) -> Floats:
        """Return the mean of all samples."""
        return np.asarray(self.halves.sum(axis=0) / max(sum(self.samples), 1))

    def half(self, which: int) -> Floats:
        """Return the mean of one half."""
        return np.asarray(self.halves[which] / max(self.samples[which], 1))


def accumulate(
    scene: TracedScene, height: int, samples: int, kept: Path | None = None
) -> Iterator[dict[str, Sums]]:
    """Trace until every light has its share of ``samples`` a pixel; yield the sums after each round of passes.

    Parameters
    ----------
    kept
        A folder in which the sums are kept after each round, so that a later call goes on from there.
    """
    sums: dict[str, Sums] = {}
    for light in scene.lights:
        path = kept / f"{scene.name}_{light.name}_{height}.npz" if kept is not None else None
        if path is not None and path.exists():
            with np.load(path) as stored:
                sums[light.name] = Sums(stored["halves"].astype(np.float64), stored["samples"].tolist())
        else:
            sums[light.name] = Sums(np.zeros((2, height, 2 * height, 3)), [0, 0])
    step = max(1, min(PATHS_IN_A_PASS // (2 * height * height), samples // 2))
    while left := [s for s in scene.lights if sum(sums[s.name].samples) < samples * s.share]:
        for light in left:
            own = sums[light.name]
            for which in (0, 1):
                traced = trace_pass(light, scene.eye, height, step, own.samples[which], which)
                own.halves[which] += traced * step
                own.samples[which] += step
            if kept is not None:
                path = kept / f"{scene.name}_{light.name}_{height}.npz"
                temporary = path.with_suffix(".part.npz")
                np.savez(temporary, halves=own.halves.astype(np.float32), samples=np.array(own.samples))
                temporary.replace(path)
        if any(sum(sums[s.name].samples) < samples * s.share for s in scene.lights):
            yield sums
    yield sums


def whole(scene: TracedScene, sums: Mapping[str, Sums]) -> Floats:
    """Return the picture of all lights, kcd/m²."""
    return scene.finish(np.asarray(sum(s.mean() for s in sums.values())))


def relative_noise(sums: Mapping[str, Sums]) -> float:
    """Return the relative standard deviation of a pixel's luminance by noise: its median over the sphere.

    What is darker than a fiftieth of the mean is left out. From the difference of two halves with independent samples:
    the mean of both deviates half as much as they differ. The median of |x| of a normal distribution is 0.6745
    deviations.
    """
    first = sum(s.half(0) for s in sums.values())
    second = sum(s.half(1) for s in sums.values())
    luminance = [np.asarray(half).mean(axis=-1) for half in (first, second)]
    mean = 0.5 * (luminance[0] + luminance[1])
    deviation = np.abs(luminance[0] - luminance[1]) / 2.0 / np.maximum(mean, 1e-9)
    areas = np.broadcast_to(solid_angles(len(mean)), mean.shape)
    dark = mean < 0.02 * float((mean * areas).sum() / areas.sum())
    weights = np.where(dark, 0.0, areas).ravel()
    order = np.argsort(deviation.ravel())
    reached = np.cumsum(weights[order])
    return float(deviation.ravel()[order][np.searchsorted(reached, 0.5 * reached[-1])] / 0.6745)
