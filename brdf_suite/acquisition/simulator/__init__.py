"""Simulator of the measuring rig: photographs of a sphere of any paint as the camera would take them.

The test data of the reconstruction, which it shares no code with: of this suite only the reflectance models and the
description of a session are used here, by both.
"""

from brdf_suite.acquisition.simulator.folder import simulate
from brdf_suite.acquisition.simulator.rig import Simulator
from brdf_suite.acquisition.simulator.settings import SimulatorSettings

__all__ = ["Simulator", "SimulatorSettings", "simulate"]
