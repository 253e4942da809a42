"""Lobe weights fitted at several incidences at once and interpolated over N·L."""

from brdf_suite.fitting.lobes.angles.fitter import AngleFit, AngleFitter
from brdf_suite.fitting.lobes.angles.grid import AngleGrid
from brdf_suite.fitting.lobes.angles.targets import AngleSamples
from brdf_suite.fitting.lobes.angles.weights import AngleWeights

__all__ = ["AngleFit", "AngleFitter", "AngleGrid", "AngleSamples", "AngleWeights"]
