"""Reflectances in the adaptive parameterization of Dupuy & Jakob (2018)."""

from brdf_suite.reflectance.tensor.tensor_reflectance import TensorReflectance

__all__ = ["TensorReflectance"]
