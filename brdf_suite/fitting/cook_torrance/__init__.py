"""Fit of Cook-Torrance and GGX lobes to samples of a reflectance (Günther et al. 2005, section 4.2)."""

from brdf_suite.fitting.cook_torrance.fit import StartsFile, fit_checked_samples, fit_lobes
from brdf_suite.fitting.cook_torrance.result import CookTorranceFit, StandardErrors
from brdf_suite.fitting.cook_torrance.samples import LobeSamples, check_samples, even_weights
from brdf_suite.fitting.cook_torrance.settings import LOSSES, MODELS, Settings

__all__ = [
    "LOSSES",
    "MODELS",
    "CookTorranceFit",
    "LobeSamples",
    "Settings",
    "StandardErrors",
    "StartsFile",
    "check_samples",
    "even_weights",
    "fit_checked_samples",
    "fit_lobes",
]
