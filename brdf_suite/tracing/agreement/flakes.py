"""Paints with single flakes in both renderers, by means over blocks of pixels and over populations of flakes.

A real-time pixel is one soft spot in a few lights, a traced one the mean of many small spots in all light: single
pixels differ by which flakes they hold. Their means must not, so means over 16×16 pixels and over eight populations
are compared, after the same tone curve. Both renderers place flakes by the texture coordinates; another population is
the same surface with its texture coordinates moved.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict, dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats
from brdf_suite.documents.view import View
from brdf_suite.errors import ValueRangeError
from brdf_suite.pipeline.exposure import ev_of
from brdf_suite.pipeline.lobe_fit import LobeFit, fit_material
from brdf_suite.pipeline.material import load_material
from brdf_suite.pipeline.picture import OffscreenScene
from brdf_suite.pipeline.scene import PreparedEnvironment, load_environment
from brdf_suite.pipeline.surface import bake_or_explain, load_shaped
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.surface.mesh import Mesh
from brdf_suite.tracing.agreement.comparison import (
    OTHER_SEED,
    WHOLE,
    Order,
    delta_e_of,
    displayed,
    pixel_means,
    trace_kept,
)
from brdf_suite.tracing.reference.scene import build_reference

BLOCK = 16
POPULATIONS = 8
_FEWEST = BLOCK * BLOCK // 4
"""A block at the object's edge counts with so many pixels of the object."""
_APART_MM = np.array([1013.0, 677.0])


@dataclass(frozen=True)
class FlakeCase:
    """Errors of one paint with flakes in one environment.

    ``de00_mean`` and ``de00_worst``: ΔE00 between the means of blocks, over all blocks and the worst one's;
    ``noise``: the mean of the same between two independent traces, of whose mean the errors are. ``luminance``: a
    block's in the real-time picture over that in the traced one, median.
    """

    paint: str
    environment: str
    surface: str
    de00_mean: float
    de00_worst: float
    noise: float
    luminance: float

    def to_json(self) -> dict[str, object]:
        """Return the figures as plain values."""
        return asdict(self)


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
    if min(order.size) < BLOCK:
        raise ValueRangeError("size", f"flakes are compared by blocks of {BLOCK}×{BLOCK} pixels")
    every = (fit_material(load_material(paint), order.fitting) for paint in order.paints)
    fits = [fit for fit in every if fit.flakes is not None]
    if order.keep is not None:
        order.keep.mkdir(parents=True, exist_ok=True)
    view = View(surface=order.surface)
    mesh, baked = load_shaped(order.surface, view.surface_look), None
    if order.surface != "sphere":
        mesh, baked = bake_or_explain(mesh, view.surface_look)
    populations = [_moved(mesh, number * _APART_MM) for number in range(POPULATIONS)]
    count = len(order.environments) * len(fits)
    with OffscreenScene() as scene:
        for place, environment in enumerate(order.environments):
            prepared = load_environment(environment, basis=order.fitting.basis)
            scene.set_environment(prepared)
            for number, fit in enumerate(fits, place * len(fits)):
                step = subrange(progress, number / count, (number + 1) / count)
                pictures: list[tuple[Floats, Floats, Floats, Floats]] = []
                for at, moved in enumerate(populations):
                    report(step, at / POPULATIONS, f"{fit.name}, population {at + 1} of {POPULATIONS}")
                    traced = _traces(order, view, fit, prepared, moved, at)
                    scene.set_surface(moved, baked)
                    scene.set_material(fit, view=traced[0])
                    pictures.append((pixel_means(scene, traced[0], order.size), *traced[1:]))
                yield _case(order, view, fit, prepared, pictures)
    report(progress, 1.0, "done")


def _traces(
    order: Order, view: View, fit: LobeFit, prepared: PreparedEnvironment, mesh: Mesh, population: int
) -> tuple[View, Floats, Floats, Floats]:
    """Return the traced view, two traces of the whole picture (h, w, 3), and the object's coverage (h, w)."""
    scene = build_reference(fit.material, view, order.size, prepared.environment, mesh)
    few = replace(order, samples=max(8, order.samples // POPULATIONS))
    name = "__".join((Path(order.surface).stem, fit.name, Path(prepared.name).stem, f"flakes_{population}"))
    one = trace_kept(few, scene, name, None)
    other = trace_kept(few, scene, f"{name}__2", None, OTHER_SEED)
    return scene.view, scene.whole(one), scene.whole(other), 0.5 * (one.coverage + other.coverage)


def _case(
    order: Order,
    view: View,
    fit: LobeFit,
    prepared: PreparedEnvironment,
    pictures: list[tuple[Floats, Floats, Floats, Floats]],
) -> FlakeCase:
    drawn, one, other, coverage = (np.mean(parts, axis=0) for parts in zip(*pictures, strict=True))
    truth = 0.5 * (one + other)
    inside = coverage >= WHOLE
    seen = replace(view, exposure_ev=ev_of(np.concatenate((truth, coverage[..., None]), axis=-1)) or 0.0)
    means = [block_means(light, inside) for light in (drawn, truth, one, other)]
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
    )


def block_means(light: Floats, inside: NDArray[np.bool_]) -> Floats:
    """Return the means (n, 3) of ``light`` (h, w, 3) over the pixels ``inside`` (h, w) of each block of 16×16.

    Blocks with less than a quarter of their pixels inside are left out, and so are rows and columns beyond the last
    whole block.
    """
    rows, columns = (side // BLOCK for side in inside.shape)
    cut = slice(rows * BLOCK), slice(columns * BLOCK)
    shape = (rows, BLOCK, columns, BLOCK)
    count = inside[cut].reshape(shape).sum(axis=(1, 3))
    total = np.where(inside[..., None], light, 0.0)[cut].reshape(*shape, 3).sum(axis=(1, 3))
    enough = count >= _FEWEST
    return np.asarray(total[enough] / count[enough][:, None])


def _moved(mesh: Mesh, by_mm: Floats) -> Mesh:
    """Return the mesh with its texture coordinates moved, (2,) millimetres."""
    parts = tuple(replace(part, uvs=part.uvs + by_mm.astype(np.float32)) for part in mesh.parts)
    return replace(mesh, parts=parts)
