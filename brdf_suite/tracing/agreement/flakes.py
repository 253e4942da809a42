"""Paints with single flakes in both renderers, by means over blocks of pixels and over populations of flakes.

A real-time pixel is one soft spot in a few lights, a traced one the mean of many small spots in all light: single
pixels differ by which flakes they hold. Their means must not, so means over 16×16 pixels and over eight populations
are compared, after the same tone curve. Both renderers place flakes by the texture coordinates; another population is
the same surface with its texture coordinates moved.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import asdict, dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats
from brdf_suite.documents.atomic import make_folder
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import SurfaceLook
from brdf_suite.errors import ValueRangeError
from brdf_suite.pipeline.exposure import ev_of
from brdf_suite.pipeline.lobe_fit import LobeFit, fit_material
from brdf_suite.pipeline.material import load_material
from brdf_suite.pipeline.picture import OffscreenScene
from brdf_suite.pipeline.scene import PreparedEnvironment, load_environment
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.surface.mesh import Mesh
from brdf_suite.surface.occlusion.rays import BakedMesh
from brdf_suite.tracing.agreement.comparison import (
    OTHER_SEED,
    WHOLE,
    Order,
    delta_e_of,
    displayed,
    load_baked,
    pixel_means,
    trace_kept,
)
from brdf_suite.tracing.reference.scene import build_reference

BLOCK = 16
POPULATIONS = 8
_FEWEST = BLOCK * BLOCK // 4
"""A block at the object's edge counts with so many pixels of the object."""
_SCALE = 0.05
"""Of the surface: with its own size a pixel holds hundreds of flakes, and means know nothing of them."""
_APART_MM = np.array([1013.0, 677.0], np.float32)


@dataclass(frozen=True)
class FlakeCase:
    """Errors of one paint with flakes in one environment.

    ``de00_mean`` and ``de00_worst``: ΔE00 between the means of blocks, over all blocks and the worst one's;
    ``noise``: the mean of the same between two independent traces, of whose mean the errors are. ``luminance``: a
    block's in the real-time picture over that in the traced one, median. ``contrast_drawn`` and ``contrast_traced``:
    the root mean square over pixels of how a pixel's luminance varies over the populations, as a share of its mean.
    """

    paint: str
    environment: str
    surface: str
    de00_mean: float
    de00_worst: float
    noise: float
    luminance: float
    contrast_drawn: float
    contrast_traced: float

    def to_json(self) -> dict[str, object]:
        """Return the figures as plain values."""
        return asdict(self)


def check_size(size: tuple[int, int]) -> None:
    """Raise :class:`ValueRangeError` for pictures of (width, height) that are smaller than a block."""
    if min(size) < BLOCK:
        raise ValueRangeError("size", f"flakes are compared by blocks of {BLOCK}×{BLOCK} pixels")


def compare_flakes(order: Order, progress: Progress | None = None) -> Iterator[FlakeCase]:
    """Yield the cases of an order's paints that have flakes, one environment after the other.

    The populations share ``samples`` evenly; ``forms`` and ``lobes`` are not used.

    Raises
    ------
    ValueRangeError
        The pictures are smaller than a block.
    SuiteError
        As :func:`~brdf_suite.tracing.agreement.comparison.compare`.
    """
    check_size(order.size)
    every = {paint: fit_material(load_material(paint), order.fitting) for paint in order.paints}
    fits = {paint: fit for paint, fit in every.items() if fit.flakes is not None}
    if order.keep is not None:
        make_folder(order.keep)
    view = View(surface=order.surface, surface_look=SurfaceLook(scale=_SCALE))
    mesh, baked = load_baked(view)
    count, done = len(order.environments) * len(fits), 0
    with OffscreenScene() as scene:
        for environment in order.environments:
            prepared = load_environment(environment, basis=order.fitting.basis)
            scene.set_environment(prepared)
            for paint, fit in fits.items():
                step = subrange(progress, done / count, (done + 1) / count)
                done += 1
                pictures: list[tuple[Floats, Floats, Floats, Floats]] = []
                for population in range(POPULATIONS):
                    part = subrange(step, population / POPULATIONS, (population + 1) / POPULATIONS)
                    moved, moved_light = with_population(mesh, baked, population)
                    traced = _traces(order, view, paint, fit, prepared, moved, population, part)
                    scene.set_surface(moved, moved_light)
                    scene.set_material(fit, view=traced[0])
                    pictures.append((pixel_means(scene, traced[0], order.size), *traced[1:]))
                yield _case(order, view, fit, prepared, pictures)
    report(progress, 1.0, "done")


def _traces(
    order: Order,
    view: View,
    paint: str,
    fit: LobeFit,
    prepared: PreparedEnvironment,
    mesh: Mesh,
    population: int,
    progress: Progress | None,
) -> tuple[View, Floats, Floats, Floats]:
    """Return the traced view, two traces of the whole picture (h, w, 3), and the object's coverage (h, w)."""
    scene = build_reference(fit.material, view, order.size, prepared.environment, mesh)
    few = replace(order, samples=max(8, order.samples // POPULATIONS))
    stems = [Path(name).stem[:40] for name in (order.surface, paint, prepared.name)]
    name = "__".join((*stems, f"flakes_{population}"))
    # Seeds of their own, so that the noise of the mean is that of all samples.
    seed = 1000 * (population + 1)
    one = trace_kept(few, scene, name, subrange(progress, 0.0, 0.5), seed)
    other = trace_kept(few, scene, f"{name}__2", subrange(progress, 0.5, 1.0), OTHER_SEED + seed)
    return scene.view, scene.whole(one), scene.whole(other), 0.5 * (one.coverage + other.coverage)


def _case(
    order: Order,
    view: View,
    fit: LobeFit,
    prepared: PreparedEnvironment,
    pictures: list[tuple[Floats, Floats, Floats, Floats]],
) -> FlakeCase:
    populations = [np.array(parts) for parts in zip(*pictures, strict=True)]
    drawn, one, other, coverage = (parts.mean(axis=0) for parts in populations)
    truth = 0.5 * (one + other)
    inside = coverage >= WHOLE
    each = [parts[:, inside] @ LUMINANCE for parts in populations[:3]]
    seen = replace(view, exposure_ev=ev_of(np.concatenate((truth, coverage[..., None]), axis=-1)) or 0.0)
    means = [block_means(light, inside) for light in (drawn, truth, one, other)]
    if not len(means[0]):
        raise ValueRangeError(order.surface, "it covers no pixel whole; take a larger picture")
    ours, theirs, first, second = (displayed(light, seen)[None] for light in means)
    away = delta_e_of(ours, theirs)
    return FlakeCase(
        paint=fit.name,
        environment=Path(prepared.name).stem,
        surface=Path(order.surface).stem,
        de00_mean=float(away.mean()),
        de00_worst=float(away.max()),
        noise=float(delta_e_of(first, second).mean()),
        luminance=float(np.median((means[0] @ LUMINANCE) / (means[1] @ LUMINANCE))),
        contrast_drawn=_contrast(each[0], each[0]),
        contrast_traced=_contrast(each[1], each[2]),
    )


def _contrast(one: Floats, other: Floats) -> float:
    """Return the contrast of luminances (populations, pixels); two traces of one have no noise in common."""
    mean = 0.5 * (one + other).mean(axis=0)
    together = ((one - one.mean(axis=0)) * (other - other.mean(axis=0))).sum(axis=0) / (len(one) - 1)
    return math.sqrt(max(float(np.mean(together / np.maximum(mean * mean, 1e-12))), 0.0))


def block_means(light: Floats, inside: NDArray[np.bool_]) -> Floats:
    """Return the means (n, 3) of ``light`` (h, w, 3) over the pixels ``inside`` (h, w) of each block of 16×16.

    Blocks with less than a quarter of their pixels inside are left out, where others have more, and so are rows and
    columns beyond the last whole block.
    """
    rows, columns = (side // BLOCK for side in inside.shape)
    cut = slice(rows * BLOCK), slice(columns * BLOCK)
    shape = (rows, BLOCK, columns, BLOCK)
    count = inside[cut].reshape(shape).sum(axis=(1, 3))
    total = np.where(inside[..., None], light, 0.0)[cut].reshape(*shape, 3).sum(axis=(1, 3))
    enough = count >= max(1, min(_FEWEST, int(count.max())))
    return np.asarray(total[enough] / count[enough][:, None])


def with_population(mesh: Mesh, baked: BakedMesh | None, population: int) -> tuple[Mesh, BakedMesh | None]:
    """Return the mesh, and what is baked for it, with other flakes: with their texture coordinates moved.

    ``population`` is a number from 0, which leaves both as they are.
    """
    by = population * _APART_MM
    moved = replace(mesh, parts=tuple(replace(part, uvs=part.uvs + by) for part in mesh.parts))
    if baked is None:
        return moved, None
    return moved, replace(baked, parts=tuple(replace(part, uvs=part.uvs + by) for part in baked.parts))
