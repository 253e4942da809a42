"""Cook-Torrance lobes, and those of GGX, fitted to samples of a reflectance (Günther et al. 2005, section 4.2)."""

from brdf_suite.fitting.cook_torrance.fit import KeptStarts, fit_checked, fit_lobes
from brdf_suite.fitting.cook_torrance.result import CookTorranceFit
from brdf_suite.fitting.cook_torrance.samples import LobeSamples, checked_samples, even_weights
from brdf_suite.fitting.cook_torrance.settings import LOSSES, MODELS, Settings
from brdf_suite.fitting.cook_torrance.uncertainty import StandardErrors

__all__ = [
    "LOSSES",
    "MODELS",
    "CookTorranceFit",
    "KeptStarts",
    "LobeSamples",
    "Settings",
    "StandardErrors",
    "checked_samples",
    "even_weights",
    "fit_checked",
    "fit_lobes",
]
