"""Generated environments with radiances that can be: a light booth, a sunny day, an overcast day."""

from brdf_suite.lighting.procedural.booth import booth
from brdf_suite.lighting.procedural.overcast import overcast
from brdf_suite.lighting.procedural.panorama import ProceduralEnvironment
from brdf_suite.lighting.procedural.sunny import sunny

__all__ = ["ProceduralEnvironment", "booth", "overcast", "sunny"]
