"""Procedural environments with physical radiances: studios and skies from a description, and the shipped ones."""

from brdf_suite.lighting.procedural.daylight import overcast, sunny
from brdf_suite.lighting.procedural.panorama import ProceduralEnvironment
from brdf_suite.lighting.procedural.sky import sky
from brdf_suite.lighting.procedural.studio import BOOTH, booth, studio

__all__ = ["BOOTH", "ProceduralEnvironment", "booth", "overcast", "sky", "studio", "sunny"]
