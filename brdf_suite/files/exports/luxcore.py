"""LuxCore: the paint as a material of type ``carpaint``, a text of properties for a scene (``.scn``).

A scene takes the lines over with ``Scene.Parse``; an object is painted by ``scene.objects.NAME.material``. Colours are
linear Rec. 709.

The model (checked against LuxCore's own renderer to six digits) is a sum of a diffuse layer and three lobes,

    f_r = kd / π + Σ ks_i D(h; m_i) G(wi; m_i) G(wo; m_i) F(wo·h; R_i) / (4 cosθi cosθo),

D = m² / (π (m² cos²θh + 1 - cos²θh)²) of Schlick 1994 (that of Trowbridge and Reitz),
G(w) = cosθ / (cosθ (1 - m²) + m²), F = R + (1 - R)(1 - wo·h)^5; the absorption of its coat is switched off (ka 0, d 0).
The structure is that of Günther et al. 2005.

Lobe 3 is the clearcoat: ks3 = 1, R3 the reflectance along the normal, m3 its roughness α, at which the peak of D is
that of the paint's Beckmann lobe. kd, ks1 and ks2 are found with R1 = R2 = 1 by non-negative least squares of relative
errors for each pair m1 > m2 of a grid; the pair with the smallest mean square of ΔE00 is refined on finer ones.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.documents.atomic import write_atomically
from brdf_suite.documents.paint import Paint
from brdf_suite.errors import PathLike
from brdf_suite.files.exports.format import ExportFormat, ExportItem
from brdf_suite.files.exports.model_fit import (
    ModelFitSamples,
    fitted_losses,
    ggx,
    half_vector,
    leaves_rec_709,
    material_names,
    normal_reflectance,
    sample_paint,
    schlick,
)
from brdf_suite.progress import Progress
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.release import __version__

_NARROWEST, _WIDEST = 0.06, 1.0
_GRID, _FINER = 13, 7
_ROUNDS = 3
# Darkest values count as if they had this share of the lightest, so that noise in black does not lead the fit.
_FLOOR = 0.01
_BLACK = (0.0, 0.0, 0.0)

Rgb = tuple[float, float, float]


@dataclass(frozen=True)
class CarPaint:
    """Fitted car paint parameters, colours in linear Rec. 709; ``differences`` are ΔE00 at the paint's readings."""

    kd: Rgb
    ks: tuple[Rgb, Rgb, Rgb]
    r: Rgb
    m: Rgb
    differences: tuple[float, ...]
    clipped: bool

    def eval(self, wi: Floats, wo: Floats) -> Floats:
        """Return f_r (n, 3) in 1/sr, linear Rec. 709, without the cosine, at directions above the horizon."""
        value = np.asarray(self.kd) / math.pi + np.zeros((len(wi), 1))
        for ks, r, m in zip(self.ks, self.r, self.m, strict=True):
            value = value + lobe(wi, wo, m, r)[:, None] * np.asarray(ks)
        return np.asarray(value)


def lobe(wi: Floats, wo: Floats, m: float, r: float) -> Floats:
    """Return one lobe (n,) of weight 1."""
    cos_h, cos_d = half_vector(wi, wo)
    cos_i, cos_o = wi[:, 2], wo[:, 2]
    rough = m * m
    shadowed = cos_i / (cos_i * (1.0 - rough) + rough) * cos_o / (cos_o * (1.0 - rough) + rough)
    return np.asarray(ggx(cos_h, m) * shadowed * schlick(cos_d, r) / (4.0 * cos_i * cos_o))


@lru_cache(maxsize=32)
def fit_carpaint(paint: Paint) -> CarPaint:
    """Return the car paint that is nearest to a designed paint.

    Raises :class:`~brdf_suite.errors.UnreachableError` where there is no such paint.
    """
    layers = build_paint(paint)
    samples = sample_paint(paint, layers)
    r3, m3 = normal_reflectance(layers.ior), min(layers.roughness, 1.0)
    left = np.maximum(samples.f - lobe(samples.wi, samples.wo, m3, r3)[:, None], 0.0)
    first = second = np.geomspace(_NARROWEST, _WIDEST, _GRID)
    ratio = float(first[1] / first[0])
    best = (math.inf, CarPaint(_BLACK, (_BLACK,) * 3, (1.0, 1.0, r3), (1.0, 0.5, m3), (), False))
    for _ in range(_ROUNDS):
        for m1, m2 in ((m1, m2) for m1 in first for m2 in second if m2 < 0.999 * m1):
            kd, ks1, ks2 = ((float(r), float(g), float(b)) for r, g, b in _weights(samples, left, m1, m2))
            widths = (float(m1), float(m2), float(m3))
            found = CarPaint(kd, (ks1, ks2, (1.0, 1.0, 1.0)), (1.0, 1.0, r3), widths, (), False)
            best = min(
                best, (samples.score(found.eval(samples.wi, samples.wo)), found), key=lambda pair: pair[0]
            )
        first, second = (
            np.clip(np.geomspace(m / ratio, m * ratio, _FINER), _NARROWEST, _WIDEST) for m in best[1].m[:2]
        )
        ratio **= 2.0 / (_FINER - 1)
    value = best[1].eval(samples.wi, samples.wo)
    return replace(best[1], differences=samples.at_readings(value), clipped=leaves_rec_709(samples))


def _weights(samples: ModelFitSamples, left: Floats, m1: float, m2: float) -> Floats:
    """Return weights (3 columns kd, ks1, ks2; 3 channels), between 0 and 1, of the least relative error to ``left``."""
    from scipy.optimize import nnls  # much to import, and only these exports fit

    columns = np.stack(
        [np.full(len(left), 1.0 / math.pi), *(lobe(samples.wi, samples.wo, m, 1.0) for m in (m1, m2))],
        axis=-1,
    )
    found = np.empty((3, 3))
    for channel in range(3):
        target = left[:, channel]
        scale = np.sqrt(samples.weight) / (target + _FLOOR * max(float(left.max()), 1e-6))
        found[:, channel] = nnls(columns * scale[:, None], target * scale)[0]
    return np.minimum(found, 1.0)


def losses(item: ExportItem) -> tuple[str, ...]:
    """Return what the car paint of LuxCore cannot hold of a paint; it is fitted for this."""
    found = fit_carpaint(item.modelled)
    return fitted_losses(
        item, "LuxCore's car paint (two lobes under a coat)", found.differences, found.clipped
    )


def write(items: Sequence[ExportItem], path: PathLike, _progress: Progress | None = None) -> tuple[str, ...]:
    """Write the materials of paints; raise :class:`FileError`, or :class:`UnreachableError` of a paint."""
    names = material_names([item.name for item in items])
    blocks = [
        _block(item, name, fit_carpaint(item.modelled)) for item, name in zip(items, names, strict=True)
    ]
    write_atomically(path, "\n".join(blocks).encode("utf-8"))
    return ()


def _block(item: ExportItem, name: str, paint: CarPaint) -> str:
    differences = ", ".join(f"{value:.2f}" for value in paint.differences)
    lines = [
        f"# {' '.join(item.name.split())}, by BRDF Suite {__version__}",
        f"# dE00 to the paint at its readings: {differences}",
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
    holds="A diffuse layer, two coloured lobes and a clearcoat, fitted to the readings.",
    losses=losses,
    write=write,
    many=True,
)
