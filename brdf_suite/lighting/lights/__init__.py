"""Approximation of an environment by a few directional lights, for flakes, shadows and the path tracer.

>>> from brdf_suite.lighting.environment import Environment
>>> import numpy as np
>>> sky = Environment("white", np.ones((32, 64, 3), np.float32))
>>> lights = directional_lights(sky, 16)
>>> lights.strengths.sum(axis=0).round(6)  # radiance 1 from 4π steradians
array([12.566371, 12.566371, 12.566371])
"""

from brdf_suite.lighting.lights.extract import METHODS, DirectionalLights, directional_lights

__all__ = ["METHODS", "DirectionalLights", "directional_lights"]
