"""Simulated sensor: electrons with noise, full wells, the response curve, and codes.

A pixel's exposure of 1 fills its well. Electrons are shot (Poisson), dark current adds its own, reading adds noise;
the well clips; the response curve gives a code between the black level and full scale.
"""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brdf_suite.acquisition.simulator.curves import curve_table, exposure_at
from brdf_suite.acquisition.simulator.noise import expose
from brdf_suite.acquisition.simulator.settings import SimulatorSettings
from brdf_suite.arrays import Codes, Floats

_BLACK_OF_12_BITS = 64
_HOT_SHARE = 2e-5
_HOT_FACTOR = 1000.0
"""The dark current of a hot pixel over the mean."""


@dataclass(frozen=True, eq=False)
class Sensor:
    """A sensor of ``shape`` (h, w); ``gain`` and ``dark_rate`` (h, w) float32 differ from pixel to pixel."""

    settings: SimulatorSettings
    gain: NDArray[np.float32]
    dark_rate: NDArray[np.float32]

    @classmethod
    def made(cls, settings: SimulatorSettings) -> Sensor:
        """Return the sensor of this seed."""
        width, height = settings.size
        gain, dark = np.ones((height, width)), np.zeros((height, width))
        if settings.noise:
            random = np.random.default_rng([settings.seed, 1])
            gain += settings.gain_spread * random.standard_normal(gain.shape)
            dark = settings.dark_current * random.gamma(4.0, 0.25, gain.shape)
            dark[random.random(gain.shape) < _HOT_SHARE] = _HOT_FACTOR * settings.dark_current
        return cls(settings, gain.astype(np.float32), dark.astype(np.float32))

    @property
    def black(self) -> int:
        """The code without light; 0 of a camera that writes sRGB pictures."""
        bits = self.settings.bit_depth
        return 0 if self.settings.curve == "srgb" else round(_BLACK_OF_12_BITS * 2.0 ** (bits - 12))

    def unit_rgb(self) -> Floats:
        """Return the full well's exposure in the photographs' unit, (3,): half of full scale counts as 0.5."""
        white = 2**self.settings.bit_depth - 1
        middle = (2 ** (self.settings.bit_depth - 1) - self.black) / (white - self.black)
        return 0.5 / exposure_at(self.settings.curve, middle)

    def expose(self, rate: NDArray[np.float32], exposures_s: tuple[float, ...], shot: int) -> Codes:
        """Return the codes (e, h, w, 3) of a picture (h, w, 3), full wells per second, at each exposure time.

        ``shot`` distinguishes photographs, so that each has noise of its own.
        """
        settings = self.settings
        codes = np.empty((len(exposures_s), *rate.shape), np.uint16)
        table = curve_table(settings.curve)
        read = settings.read_noise if settings.noise else 0.0
        white = float(2**settings.bit_depth - 1)

        def one(k: int) -> None:
            key = np.uint64((settings.seed << 32) ^ (shot << 8) ^ k)
            sensor = (self.gain, self.dark_rate, exposures_s[k], settings.full_well, read, settings.noise)
            expose(rate, *sensor, table, float(self.black), white, key, codes[k])

        with ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(one, range(len(exposures_s))))
        return codes.astype(np.uint8) if settings.bit_depth == 8 else codes
