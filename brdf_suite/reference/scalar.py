"""Fallback without LLVM or a graphics card: Mitsuba's scalar variant with its built-in plug-ins.

Every isotropic reflectance can be given to its plug-in ``measured``, as a table in the form of RGL's ``.bsdf`` files
(:mod:`brdf_suite.reflectance.tensor.tabulate`). The colours in it are those of the working space, as all light here is,
so nothing is lost to a gamut. Single flakes, relief and a second paint differ from place to place and are left out.
"""

from __future__ import annotations

import math
import tempfile
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING
from brdf_suite.arrays import Floats
from brdf_suite.errors import ReferenceUnavailableError, ValueRangeError
from brdf_suite.files.measured.rgl import write_rgl
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.reference.bsdfs.lobe_weights import LobeWeightsTerm
from brdf_suite.reference.mitsuba_modules import mi
from brdf_suite.reflectance.models.cosine_lobes import lobe_sums
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tensor.tabulate import tabulate
from brdf_suite.reflectance.tensor.tensor_reflectance import TensorReflectance

AS_A_TABLE = (
    "Rendered as a table by Mitsuba's own plug-in: within 0.1 % of the paint for light and view 17° and more above the "
    "surface, within percents below that."
)


def working_table(
    reflectance: Reflectance, *, incidences: int | None = None, resolution: int | None = None
) -> TensorReflectance:
    """Return the table of a reflectance with the channels of the working space in place of those of Rec. 709.

    Raises
    ------
    ReferenceUnavailableError
        The reflectance is not isotropic; the message names what to install.
    """
    try:
        table = tabulate(_Coloured(reflectance), incidences=incidences, resolution=resolution)
    except ValueRangeError as error:
        raise ReferenceUnavailableError(
            f"Without LLVM only isotropic reflectances can be path-traced: {error} Install libllvm19."
        ) from error
    values = np.einsum("picab,jc->pijab", table.values, REC709_TO_WORKING)
    return replace(table, values=np.ascontiguousarray(values, np.float32))


def table_bsdf(
    reflectance: Reflectance, *, incidences: int | None = None, resolution: int | None = None
) -> Any:
    """Return Mitsuba's ``measured`` with the table of a reflectance, seen from both sides; errors as working_table."""
    table = working_table(reflectance, incidences=incidences, resolution=resolution)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "table.bsdf"
        write_rgl(table, path)
        return mi.load_dict({"type": "twosided", "inner": {"type": "measured", "filename": str(path)}})


@dataclass(frozen=True, eq=False)
class _Coloured:
    """A three-channel reflectance with light and view exchanged, in Mitsuba's convention.

    Spectra have no place in a picture of three channels; and what the file calls incident is the view to Mitsuba.
    """

    reflectance: Reflectance

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr."""
        return self.reflectance.eval(wo, wi)


@dataclass(frozen=True, eq=False)
class LobesSeen:
    """Lobe weights with the gains of the view's angle, in numpy."""

    term: LobeWeightsTerm

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr; 0 below the horizon."""
        term = self.term
        matt, sharp = (weights.any(axis=1) for weights in (term.kdd, term.kg))
        kdd, kg = term.kdd[matt], term.kg[sharp]
        base = lobe_sums(wi, wo, term.exponents[matt], term.kd, kdd, 0.0 * kdd).brdf()
        gloss = lobe_sums(wi, wo, term.exponents[sharp], np.zeros(3), 0.0 * kg, kg).brdf()
        base_gain, gloss_gain = self._gains(np.asarray(wo, float)[..., 2:])
        return np.asarray(base * base_gain + gloss * gloss_gain)

    def _gains(self, cosine: Floats) -> tuple[Floats | float, Floats | float]:
        term = self.term
        if not term.raised or term.coat == "none":
            return 1.0, 1.0
        albedo = term.kg.T @ (2.0 * math.pi / (term.exponents + 1.0))
        if term.coat == "metal":
            rise = np.clip(1.0 - cosine, 0.0, 1.0) ** 5
            g = np.maximum(albedo, 1e-4)
            return 1.0, (g + np.maximum(1.0 - g, 0.0) * rise) / g
        f = fresnel_dielectric(np.clip(cosine, 0.0, 1.0), term.ior)
        at_fit = float(fresnel_dielectric(math.cos(term.theta_fit_rad), term.ior))
        limit = max(1.0 / float(albedo.max()), 1.0) if albedo.max() > 0.0 else 1.0
        gloss: Floats | float = np.minimum(f / at_fit, limit) if at_fit > 0.0 else 1.0
        return ((1.0 - f) / (1.0 - at_fit)) ** 2 if term.coat == "dielectric" else 1.0, gloss
