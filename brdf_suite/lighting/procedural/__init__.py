"""Procedural environments with physical radiances: studios and skies from a description, and the shipped ones."""

from brdf_suite.lighting.procedural.booth import BOOTH, booth
from brdf_suite.lighting.procedural.overcast import overcast
from brdf_suite.lighting.procedural.panorama import ProceduralEnvironment
from brdf_suite.lighting.procedural.sky import sky
from brdf_suite.lighting.procedural.studio import studio
from brdf_suite.lighting.procedural.sunny import sunny

__all__ = ["BOOTH", "ProceduralEnvironment", "booth", "overcast", "sky", "studio", "sunny"]
