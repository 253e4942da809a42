"""Fit of renderers' models to a paint, on spheres in several lights and at the paint's readings.

A model is fitted where it is seen: on spheres in the light of
:mod:`brdf_suite.reflectance.instruments.rendered_sphere`, with the sun where the losses are reported and in three other
places, so that every pair of directions counts by how much of a sphere shows it, the halo around the mirror direction
and the rim too. The readings count as an eighth of all. The error is the difference in L*, C* and h, each divided by
the weight of CIE94, whose squares are smooth; the losses are ΔE00.

The models are linear in all but few of their parameters: integrals of their terms over the light are made once for each
width of a lobe, and colours are found from them.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Generic, TypeVar

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
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.reflectance.designed.paint_reflectance import PaintReflectance
from brdf_suite.reflectance.instruments.rendered_sphere import (
    SUN_PLACE,
    RenderedSphere,
    exposure,
    rendered_sphere,
    sphere_difference,
)
from brdf_suite.reflectance.material import Material
from brdf_suite.reflectance.protocol import Reflectance

_SUNS = (SUN_PLACE, (20.0, 15.0), (100.0, 25.0), (-150.0, 30.0))
_POINTS, _DIRECTIONS = 80, 112
_READINGS_SHARE = 0.125
_STEPS = 12
_ORDINARY = 2.0
"""Differences beyond this many units count less than by their squares."""
_FLOOR = 0.02
"""Darkest values count in the first, linear fit as if they had this share of the median."""


M = TypeVar("M", bound=Reflectance)


@dataclass(frozen=True, eq=False)
class FitTarget:
    """What models are fitted to: pixels of spheres, then readings.

    Attributes
    ----------
    reflectance
        What is exported.
    coat
        The clearcoat of the models: that of the designed paint with the readings' gloss.
    spheres
        In one light each.
    wi, wo
        Directions (r, 3) of the readings.
    cos_o
        Cosine (n,) of the view from the normal, of all pixels and readings.
    value
        Linear Rec. 709 (n, 3), exposed: a pixel's 1 is the white of a screen, a reading's the perfect diffuser.
    scale
        What the models' values (n,) are multiplied by to compare.
    weight
        Weight (n,); 1 in all.
    limit
        Where light becomes white (n,): 1 for pixels, none for readings.
    """

    reflectance: Reflectance
    coat: PaintReflectance
    spheres: tuple[RenderedSphere, ...]
    wi: Floats
    wo: Floats
    cos_o: Floats
    value: Floats
    scale: Floats
    weight: Floats
    limit: Floats

    def integrals(self, terms: Callable[[Floats, Floats], Floats]) -> Floats:
        """Return terms of a model (n, k) of directions (n, 3), integrated over each pixel's light."""
        return np.concatenate([*(sphere.summed(terms) for sphere in self.spheres), terms(self.wi, self.wo)])

    def residuals(self, found: Floats) -> Floats:
        """Return the weighted differences (3 n,) in lightness, chroma and hue of a model's values (n, 3)."""
        lab, other = self._lab(self.value), self._lab(found * self.scale[:, None])
        chroma, other_chroma = (np.hypot(x[:, 1], x[:, 2]) for x in (lab, other))
        along = other_chroma - chroma
        # ΔH from Δa and Δb without a root: across the mean hue.
        both = np.sqrt(np.maximum(chroma * other_chroma, 1e-6))
        hue = (lab[:, 1] * other[:, 2] - lab[:, 2] * other[:, 1]) / np.maximum(both, 1.0)
        lightness = (other[:, 0] - lab[:, 0]) / (1.0 + 0.005 * np.abs(lab[:, 0] - 50.0))
        parts = (lightness, along / (1.0 + 0.045 * chroma), hue / (1.0 + 0.015 * chroma))
        return np.concatenate([part * np.sqrt(self.weight) for part in parts])

    def least(
        self, values: Callable[[Floats], Floats], start: Floats, low: Floats, high: Floats
    ) -> tuple[Floats, float]:
        """Return parameters between ``low`` and ``high`` near ``start`` whose values (n, 3) are nearest, and the error.

        Large differences count less than by their squares, since the figure that is reported is a mean.
        """
        from scipy.optimize import least_squares  # much to import, and only exports fit

        def differences(x: Floats) -> Floats:
            return self.residuals(values(x))

        found = least_squares(
            differences,
            np.clip(start, low + 1e-9, high - 1e-9),
            bounds=(low, high),
            x_scale="jac",
            max_nfev=_STEPS,
            loss="soft_l1",
            f_scale=_ORDINARY / math.sqrt(len(self.weight)),
        )
        return found.x, 2.0 * float(found.cost)

    def score(self, found: Floats) -> float:
        """Return the mean squared difference of a model's values (n, 3)."""
        return float(np.square(self.residuals(found)).sum())

    def readings(self, found: Floats) -> tuple[float, ...]:
        """Return ΔE00 of a model's values (n, 3) at each reading of the paint, in its order."""
        count = len(self.wi)
        own = self._lab(self.value)[-count:]
        return tuple(delta_e_2000(own, self._lab(found * self.scale[:, None])[-count:]).tolist())

    def _lab(self, value: Floats) -> Floats:
        shown = np.minimum(np.maximum(value, 0.0), self.limit[:, None])
        return working_to_lab(shown @ REC709_TO_WORKING.T)


@lru_cache(maxsize=8)
def target_of(paint: Paint, material: Material | None) -> FitTarget:
    """Return what models are fitted to.

    Parameters
    ----------
    paint
        The readings and, by its gloss, the coat: :attr:`ExportItem.modelled`.
    material
        What reflects; None where that is ``paint``.

    Raises
    ------
    UnreachableError
        No paint has these readings.
    """
    coat = build_paint(paint)
    reflectance = coat if material is None else material.reflectance
    spheres = tuple(rendered_sphere(sun, _POINTS, _DIRECTIONS) for sun in _SUNS)
    pixels = [sphere.pixels(reflectance) for sphere in spheres]
    exposures = [exposure(one) for one in pixels]
    angles = np.array([(m.illumination_deg, m.aspecular_deg) for m in paint.measurements])
    wi, wo = illumination(angles[:, 0]), aspecular_view(angles[:, 0], angles[:, 1])
    read = lab_to_working([m.lab for m in paint.measurements])
    value = np.concatenate([*(one * factor for one, factor in zip(pixels, exposures, strict=True)), read])
    many, few = _POINTS * len(spheres), len(read)
    return FitTarget(
        reflectance,
        coat,
        spheres,
        wi,
        wo,
        np.concatenate([*(sphere.cos_o for sphere in spheres), wo[:, 2]]),
        value @ WORKING_TO_SRGB.T,
        np.concatenate([np.repeat(exposures, _POINTS), np.full(few, math.pi)]),
        np.concatenate([np.full(many, (1.0 - _READINGS_SHARE) / many), np.full(few, _READINGS_SHARE / few)]),
        np.concatenate([np.ones(many), np.full(few, math.inf)]),
    )


def first_weights(columns: Floats, target: FitTarget, rest: Floats) -> Floats:
    """Return weights (k, 3), 0 to 1, of ``columns`` (n, k) whose sum is nearest to ``rest`` (n, 3), relatively.

    ``rest`` is in the model's own scale, what its fixed parts leave of the target.
    """
    from scipy.optimize import nnls  # much to import, and only exports fit

    found = np.empty((columns.shape[1], 3))
    floor = _FLOOR * 0.18
    for channel in range(3):
        scaled = np.maximum(target.value[:, channel], 0.0)
        share = np.sqrt(target.weight) / (np.minimum(scaled, target.limit) + floor)
        # A white pixel need not be as bright as it is.
        share = np.where(scaled > target.limit, 0.2 * share, share) * target.scale
        found[:, channel] = nnls(columns * share[:, None], rest[:, channel] * share)[0]
    return np.minimum(found, 1.0)


@dataclass(frozen=True, eq=False)
class Fitted(Generic[M]):
    """A fitted model, ΔE00 at the paint's readings, the mean ΔE00 on the sphere, and whether a colour is clipped."""

    model: M
    differences: tuple[float, ...]
    on_sphere: float
    clipped: bool


def fitted(target: FitTarget, model: M, found: Floats) -> Fitted[M]:
    """Return a model and its values (n, 3) with its differences from what was fitted to."""
    count = len(target.wi)
    return Fitted(
        model,
        target.readings(found),
        sphere_difference(target.reflectance, model),
        bool(target.value[-count:].min() < -1e-6),
    )


def format_differences(paint: Paint, differences: tuple[float, ...], on_sphere: float, what: str) -> str:
    """Return the sentence that states how far a model is from the paint on a sphere and at its readings."""
    at = ", ".join(
        f"{difference:.1f} at {m.aspecular_deg:g}°"
        + ("" if m.illumination_deg == 45.0 else f" (light {m.illumination_deg:g}°)")
        for m, difference in zip(paint.measurements, differences, strict=True)
    )
    return f"{what}: mean ΔE00 {on_sphere:.1f} on a sphere in the sun; {at}."


def fitted_losses(item: ExportItem, what: str, found: Fitted[M]) -> tuple[str, ...]:
    """Return what is lost of a paint in a format that holds a fitted model and nothing beside it."""
    return (
        *shape_losses(item, what, found),
        *flake_loss(item),
        "Gloss readings, notes and source are left out.",
    )


def shape_losses(item: ExportItem, what: str, found: Fitted[M]) -> tuple[str, ...]:
    """Return what is lost of a paint's colours in a fitted model."""
    losses = [
        *model_loss(item),
        format_differences(item.paint, found.differences, found.on_sphere, what),
    ]
    if found.clipped:
        losses.append(
            "A colour lies outside Rec. 709, in which the parameters are kept; it is moved to the edge."
        )
    return tuple(losses)


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
