"""Fit targets for the simpler models of renderers: a designed paint at many directions, and the error measure.

Where a format holds a model of its own (car paint of LuxCore, OpenPBR, the clearcoat of glTF), its parameters are those
that come nearest to the paint, coat included: at the paint's own readings first, then between them in the same plane,
and with less weight under a steeper and a shallower light, where the paint itself is only a model.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from brdf_suite.appearance.colour.colorimetry import (
    REC709_TO_WORKING,
    WORKING_TO_SRGB,
    lab_to_working,
    working_to_lab,
)
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Paint
from brdf_suite.files.exports.format import ExportItem, flake_loss, model_loss
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.reflectance.designed.paint_reflectance import PaintReflectance

_STEP_DEG = 10.0
_BETWEEN, _OTHER_LIGHTS = 0.05, 0.005
"""Weights of what lies between the readings, and of other lights; a reading counts 1."""
_LIGHTS_DEG = (20.0, 65.0)
_LOWEST_VIEW_DEG = 75.0


@dataclass(frozen=True, eq=False)
class ModelFitSamples:
    """Directions (n, 3), f_r of the paint (n, 3) in linear Rec. 709, and weights (n,); the ``readings`` come first."""

    wi: Floats
    wo: Floats
    f: Floats
    weight: Floats
    readings: int

    def difference(self, f: Floats) -> Floats:
        """Return ΔE00 (n,) of another model's f_r (n, 3), linear Rec. 709, from the paint."""
        return delta_e_2000(_lab(self.f), _lab(np.maximum(f, 0.0)))

    def score(self, f: Floats) -> float:
        """Return the weighted mean of squared ΔE00: what a fit makes small."""
        return float(self.weight @ self.difference(f) ** 2 / self.weight.sum())

    def at_readings(self, f: Floats) -> tuple[float, ...]:
        """Return ΔE00 at each reading of the paint, in its order."""
        return tuple(self.difference(f)[: self.readings].tolist())


def sample_paint(paint: Paint, layers: PaintReflectance) -> ModelFitSamples:
    """Return what the models are fitted to: the paint's readings, and directions between and beyond them."""
    read = [(m.illumination_deg, m.aspecular_deg) for m in paint.measurements]
    usual = read[0][0]
    sides = [abs(aspecular) for _, aspecular in read]
    nearest, farthest = min(sides), max(sides)
    between = [(usual, float(angle)) for angle in np.arange(nearest, farthest + 1e-6, _STEP_DEG)]
    beyond = [
        (light, float(angle))
        for light in _LIGHTS_DEG
        for angle in np.arange(
            max(nearest, 15.0), min(farthest, light + _LOWEST_VIEW_DEG) + 1e-6, 2.0 * _STEP_DEG
        )
    ]
    angles = np.array([*read, *between, *beyond])
    wi, wo = illumination(angles[:, 0]), aspecular_view(angles[:, 0], angles[:, 1])
    f = layers.eval(wi, wo)
    # At its own readings the paint is what was read, to the last bit.
    f[: len(read)] = lab_to_working([m.lab for m in paint.measurements]) / math.pi
    weight = np.concatenate(
        [np.ones(len(read)), np.full(len(between), _BETWEEN), np.full(len(beyond), _OTHER_LIGHTS)]
    )
    return ModelFitSamples(wi, wo, f @ WORKING_TO_SRGB.T, weight, len(read))


def leaves_rec_709(samples: ModelFitSamples) -> bool:
    """Return whether a reading of the paint is more saturated than Rec. 709, in which the models are written."""
    return bool(samples.f[: samples.readings].min() < -1e-6)


def format_differences(paint: Paint, differences: tuple[float, ...], what: str) -> str:
    """Return the sentence that states how far a model is from the paint at its readings."""
    at = ", ".join(
        f"{difference:.1f} at {m.aspecular_deg:g}°"
        + ("" if m.illumination_deg == 45.0 else f" (light {m.illumination_deg:g}°)")
        for m, difference in zip(paint.measurements, differences, strict=True)
    )
    return f"{what} comes as near as ΔE00 {at}."


def fitted_losses(
    item: ExportItem, what: str, differences: tuple[float, ...], clipped: bool
) -> tuple[str, ...]:
    """Return what is lost of a paint in a format that holds a fitted model and nothing beside it."""
    losses = [*model_loss(item), format_differences(item.paint, differences, what)]
    if clipped:
        losses.append(
            "A colour lies outside Rec. 709, in which the parameters are kept; it is moved to the edge."
        )
    return (*losses, *flake_loss(item), "Gloss readings, notes and source are left out.")


def half_vector(wi: Floats, wo: Floats) -> tuple[Floats, Floats]:
    """Return cos θh (n,) and cos θd (n,) of directions (n, 3)."""
    total = wi + wo
    length = np.linalg.norm(total, axis=-1)
    return total[..., 2] / length, 0.5 * length


def ggx(cos_h: Floats, alpha: float | Floats) -> Floats:
    """Return D of Trowbridge and Reitz, α² / (π (cos²θh (α² - 1) + 1)²)."""
    alpha2 = np.square(alpha)
    return np.asarray(alpha2 / (math.pi * (cos_h * cos_h * (alpha2 - 1.0) + 1.0) ** 2))


def schlick(cos_d: Floats, at_normal: float | Floats) -> Floats:
    """Return Fresnel's reflectance after Schlick 1994."""
    return np.asarray(at_normal + (1.0 - at_normal) * (1.0 - cos_d) ** 5)


def normal_reflectance(ior: float) -> float:
    """Return ((n - 1) / (n + 1))²."""
    return ((ior - 1.0) / (ior + 1.0)) ** 2


def _lab(f: Floats) -> Floats:
    return working_to_lab(math.pi * f @ REC709_TO_WORKING.T)


_NOT_A_NAME = re.compile(r"[^A-Za-z0-9_]+")


def material_names(names: Sequence[str]) -> list[str]:
    """Return a material's name for each paint, no two alike: letters, digits and underscores only.

    >>> material_names(["Blue, dark", "Blue dark"])
    ['Blue_dark', 'Blue_dark_2']
    """
    found: list[str] = []
    for name in names:
        wanted = base = _NOT_A_NAME.sub("_", name).strip("_") or "paint"
        number = 1
        while wanted in found:
            number += 1
            wanted = f"{base}_{number}"
        found.append(wanted)
    return found
