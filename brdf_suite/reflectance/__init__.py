"""Every reflectance behind one ``eval``: models, Fresnel coats, building one from a paint, measuring it."""

from brdf_suite.reflectance.measure import measure_lab

__all__ = ["measure_lab"]
