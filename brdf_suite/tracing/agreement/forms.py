"""The ways in which a picture is drawn to be compared, by what they change of the default one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Any

import numpy as np

from brdf_suite.documents.paint import Paint
from brdf_suite.errors import FittingError, UnreachableError
from brdf_suite.fitting.lobes.basis import shipped_basis
from brdf_suite.fitting.lobes.settings import FitSettings
from brdf_suite.inspection.representations import hold_out
from brdf_suite.lighting.filter.face_array import FaceArray
from brdf_suite.pipeline.lobe_fit import LobeFit, fit_material
from brdf_suite.pipeline.material import load_document, load_material, material_of
from brdf_suite.pipeline.scene import PreparedEnvironment
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

DEFAULT_FORM = "default"
HELD_OUT_FORM = "a fifth held out"
_EDGE_DEG = 5.0
"""Of measured directions; nearer to the steepest one none is held out."""

_NOTHING: Mapping[str, Any] = MappingProxyType({})


@dataclass(frozen=True)
class DrawingForm:
    """One way to draw.

    Attributes
    ----------
    effect
        The effect that is compared: the heading under which it is reported.
    view
        Fields of the view.
    lobes
        Number of lobes of the suite's own basis; None: the basis that is compared.
    halvings
        How often the edge of each prefiltered map is halved.
    paint
        Fields of a designed paint's document. The picture is then of another paint than the traced one: it shows how
        much the rule matters, not an error.
    held_out
        Whether the lobes know a part of the measured directions only (:func:`hold_out`), of which the traced paint has
        all.
    """

    effect: str
    view: Mapping[str, Any] = field(default_factory=lambda: _NOTHING)
    lobes: int | None = None
    halvings: int = 0
    paint: Mapping[str, Any] = field(default_factory=lambda: _NOTHING)
    held_out: bool = False

    @property
    def light(self) -> tuple[int | None, int]:
        """What of the light's maps it changes; forms of the same are drawn together."""
        return self.lobes, self.halvings


FORMS: Mapping[str, DrawingForm] = MappingProxyType(
    {
        DEFAULT_FORM: DrawingForm("–"),
        "paper look-up": DrawingForm("look-up", {"look_up": "paper"}),
        "Fresnel off": DrawingForm("Fresnel", {"fresnel": "off"}),
        "weights over the angle": DrawingForm("Fresnel", {"fresnel": "multi_angle"}),
        "5 lobes": DrawingForm("number of lobes", lobes=5),
        "7 lobes": DrawingForm("number of lobes", lobes=7),
        "9 lobes": DrawingForm("number of lobes", lobes=9),
        "maps of half the edge": DrawingForm("resolution", halvings=1),
        "maps of a quarter": DrawingForm("resolution", halvings=2),
        "monotone rule": DrawingForm("below 15°", paint={"interpolation": "monotone"}),
        "polynomial rule": DrawingForm("below 15°", paint={"interpolation": "polynomial"}),
        "near-specular × 0.7": DrawingForm("below 15°", paint={"near_specular": 0.7}),
        HELD_OUT_FORM: DrawingForm("measured directions", held_out=True),
    }
)
"""Ways in which the real-time picture is drawn, by name."""


def settings_of(form: DrawingForm, fitting: FitSettings) -> FitSettings:
    """Return how a form is fitted, of a comparison that is fitted as ``fitting`` says."""
    return fitting if form.lobes is None else replace(fitting, basis=shipped_basis(form.lobes))


def fit_for(form: DrawingForm, paint: str, fitting: FitSettings) -> LobeFit | None:
    """Return the lobes of a paint in a form; None where the form is not of its kind, or it cannot be so.

    ``fitting`` as for :func:`settings_of`. Errors as :func:`load_material` and :func:`fit_material`.
    """
    settings = settings_of(form, fitting)
    if form.held_out:
        material = load_material(paint)
        if not isinstance(material.reflectance, ScatteredSamples | IsotropicTable):
            return None
        try:
            seen = hold_out(material.reflectance).keep_edge(_EDGE_DEG).seen
        except FittingError:  # too few to be divided
            return None
        return fit_material(replace(material, reflectance=seen), settings)
    if not form.paint:
        return fit_material(load_material(paint), settings)
    document = load_document(paint)
    if not isinstance(document, Paint):
        return None
    try:
        return fit_material(material_of(replace(document, **form.paint), paint), settings)
    except UnreachableError:  # by another rule the same readings may be those of no paint
        return None


def coarser(prepared: PreparedEnvironment, halvings: int) -> PreparedEnvironment:
    """Return the environment with the edge of each lobe map halved so often, as means of 2 × 2 texels."""
    if not halvings:
        return prepared
    maps = prepared.maps
    lobes = tuple(_halved(lobe, halvings) for lobe in maps.lobes)
    return replace(prepared, maps=replace(maps, lobes=lobes, diffuse=_halved(maps.diffuse, halvings)))


def _halved(faces: FaceArray, times: int) -> FaceArray:
    values = faces.faces.astype(np.float32)
    for _ in range(times):
        size = values.shape[1]
        if size % 2 or size < 16:
            break
        values = values.reshape(6, size // 2, 2, size // 2, 2, 3).mean(axis=(2, 4))
    return FaceArray(np.ascontiguousarray(values, np.float16), faces.scale)
