"""LuxCore: the paint as a material of type ``carpaint``, a text of properties for a scene (``.scn``).

A scene takes the lines over with ``Scene.Parse``; an object is painted by ``scene.objects.NAME.material``. Colours are
linear Rec. 709. The model is :mod:`brdf_suite.reflectance.renderers.carpaint`, checked against LuxCore's own renderer.

Lobe 3 is the clearcoat: ks3 = 1, R3 the reflectance along the normal, m3 its roughness α, at which the peak of D is
that of the paint's Beckmann lobe. Lobe 1 is the flakes, with R1 = 1. Lobe 2 stays black: with three lobes LuxCore 2.11
draws the third twice as often as it counts it and never the second, so that a path-traced clearcoat is twice as
bright as its formula, and a second lobe too dark. With two lobes it draws what it counts. kd and ks1 are found by
linear least squares for each m1 of a grid; from the best few all parameters are refined together.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.documents.atomic import write_atomically
from brdf_suite.documents.paint import Paint
from brdf_suite.errors import PathLike
from brdf_suite.files.exports.format import ExportFormat, ExportItem
from brdf_suite.files.exports.model_fit import (
    FitTarget,
    Fitted,
    first_weights,
    fitted,
    fitted_losses,
    material_names,
    target_of,
)
from brdf_suite.progress import Progress
from brdf_suite.reflectance.material import Material
from brdf_suite.reflectance.renderers.carpaint import CarPaint, lobe
from brdf_suite.reflectance.renderers.facet_lobe import normal_reflectance
from brdf_suite.release import __version__

_WIDTHS = np.geomspace(0.04, 1.0, 11)
_NARROWEST, _WIDEST = 0.02, 1.0
_TRIED = 2
_BLACK, _WHITE = (0.0, 0.0, 0.0), (1.0, 1.0, 1.0)


def fit_carpaint(item: ExportItem) -> Fitted[CarPaint]:
    """Return the car paint that is nearest to what is exported.

    Raises :class:`~brdf_suite.errors.UnreachableError` where no paint has its readings.
    """
    return _fit(item.modelled, item.material)


@lru_cache(maxsize=32)
def _fit(paint: Paint, material: Material | None) -> Fitted[CarPaint]:
    target = target_of(paint, material)
    r3, m3 = normal_reflectance(target.coat.ior), min(max(target.coat.roughness, 1e-3), 1.0)
    start = CarPaint(_BLACK, (_BLACK, _BLACK, _WHITE), (1.0, 1.0, r3), (1.0, 1.0, m3))
    matt, coat = target.integrals(start.terms)[:, 0], _integral(target, m3, r3)
    rest = target.value / target.scale[:, None] - coat[:, None]
    trials = []
    for m1 in _WIDTHS:
        columns = np.stack((matt, _integral(target, float(m1), 1.0)), axis=-1)
        weights = first_weights(columns, target, rest)
        score = target.score(columns @ weights + coat[:, None])
        trials.append((score, _made(start, np.append(weights.ravel(), math.log(m1)))))
    trials.sort(key=lambda pair: pair[0])
    best, _ = min((_refine(model, target) for _, model in trials[:_TRIED]), key=lambda pair: pair[1])
    return fitted(target, best, best.sum_terms(target.integrals(best.terms)))


def _integral(target: FitTarget, m: float, r: float) -> Floats:
    """Return a lobe of weight 1 (n,), integrated over each pixel's light."""
    return target.integrals(lambda wi, wo: lobe(wi, wo, m, r))


def _made(model: CarPaint, x: Floats) -> CarPaint:
    """Return the model with kd, ks1 and the logarithm of m1 (7 numbers)."""
    kd, ks1 = ((float(r), float(g), float(b)) for r, g, b in x[:6].reshape(2, 3))
    return replace(model, kd=kd, ks=(ks1, *model.ks[1:]), m=(math.exp(x[6]), *model.m[1:]))


def _refine(model: CarPaint, target: FitTarget) -> tuple[CarPaint, float]:
    """Return the model of the least error near ``model``, and the error."""
    start = np.array([*model.kd, *model.ks[0], math.log(model.m[0])])
    low = np.array([*[0.0] * 6, math.log(_NARROWEST)])
    high = np.array([*[1.0] * 6, math.log(_WIDEST)])
    fixed = target.integrals(model.terms)
    kept: dict[float, Floats] = {}

    def values(x: Floats) -> Floats:
        m = float(x[6])
        if m not in kept:
            kept[m] = _integral(target, math.exp(m), 1.0)
        terms = np.concatenate((fixed[:, :1], kept[m][:, None], fixed[:, 2:]), axis=-1)
        return _made(model, x).sum_terms(terms)

    x, error = target.least(values, start, low, high)
    return _made(model, x), error


def losses(item: ExportItem) -> tuple[str, ...]:
    """Return what the car paint of LuxCore cannot hold of a paint; it is fitted for this."""
    return fitted_losses(item, "LuxCore's car paint (one lobe under a coat)", fit_carpaint(item))


def write(items: Sequence[ExportItem], path: PathLike, _progress: Progress | None = None) -> tuple[str, ...]:
    """Write the materials of paints; raise :class:`FileError`, or :class:`UnreachableError` of a paint."""
    names = material_names([item.name for item in items])
    blocks = [_block(item, name, fit_carpaint(item)) for item, name in zip(items, names, strict=True)]
    write_atomically(path, "\n".join(blocks).encode("utf-8"))
    return ()


def _block(item: ExportItem, name: str, found: Fitted[CarPaint]) -> str:
    differences = ", ".join(f"{value:.2f}" for value in found.differences)
    paint = found.model
    lines = [
        f"# {' '.join(item.name.split())}, by BRDF Suite {__version__}",
        f"# dE00 to the paint: {found.on_sphere:.2f} on a sphere; at its readings: {differences}",
        f'scene.materials.{name}.type = "carpaint"',
        f"scene.materials.{name}.kd = {_numbers(paint.kd)}",
    ]
    for index, (ks, r, m) in enumerate(zip(paint.ks, paint.r, paint.m, strict=True), start=1):
        lines += [
            f"scene.materials.{name}.ks{index} = {_numbers(ks)}",
            f"scene.materials.{name}.r{index} = {_numbers((r,))}",
            f"scene.materials.{name}.m{index} = {_numbers((m,))}",
        ]
    lines += [f"scene.materials.{name}.ka = 0 0 0", f"scene.materials.{name}.d = 0", ""]
    return "\n".join(lines)


def _numbers(values: Sequence[float]) -> str:
    return " ".join(f"{value:.9g}" for value in values)


FORMAT = ExportFormat(
    name="luxcore",
    title="LuxCore car paint",
    ending=".scn",
    holds="A diffuse layer, a coloured lobe and a clearcoat, fitted on a sphere.",
    losses=losses,
    write=write,
    many=True,
)
