"""Lobe weights fitted at several incidences at once and interpolated over N·L."""

from brdf_suite.fitting.lobes.angles.fitter import AngleFit, AngleFitter
from brdf_suite.fitting.lobes.angles.program import AngleSamples
from brdf_suite.fitting.lobes.angles.weights import AngleGrid, AngleWeights

__all__ = ["AngleFit", "AngleFitter", "AngleGrid", "AngleSamples", "AngleWeights"]
