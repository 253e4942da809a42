"""Reflectances behind one ``eval``: models, clearcoats, construction from paints, virtual measurement."""

from brdf_suite.reflectance.instruments.measure import measure_lab

__all__ = ["measure_lab"]
