"""The fit of a paint with spectra under another lamp of the light booth."""

from __future__ import annotations

from dataclasses import replace

from brdf_suite.appearance.light_matrix import ILLUMINANT_OF
from brdf_suite.documents.view_settings import LightColour
from brdf_suite.pipeline.any_fit import AnyFit, fit_reflectance
from brdf_suite.progress import Progress
from brdf_suite.reflectance.relit import relit
from brdf_suite.reflectance.under_light import has_spectra


def refit_under(fit: AnyFit, colour: LightColour, progress: Progress | None = None) -> AnyFit:
    """Return the fit of the same paint as it looks in a light to an adapted eye; the very fit where nothing differs.

    Without spectra nothing is known, and under D65 or in the environment's own light nothing changes. Raises as
    :func:`~brdf_suite.pipeline.any_fit.fit_reflectance`.
    """
    illuminant = ILLUMINANT_OF.get(colour.illuminant, "D65")
    if illuminant == "D65" or not has_spectra(fit.reflectance):
        return fit
    found = fit_reflectance(fit.name, relit(fit.reflectance, illuminant), progress=progress)
    return replace(found, notices=fit.notices, flakes=fit.flakes)
