"""A lamp's colour on everything that the environment lights, and on nothing else."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import WORKING_TO_SRGB
from brdf_suite.appearance.light.matrix import light_matrix
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import LightColour

SIZE = (96, 96)
VIEW = View(Camera(azimuth_deg=20, elevation_deg=10), tone_curve="linear", exposure_ev=-1.0)


def encoded(rho: np.ndarray) -> np.ndarray:
    c = np.clip(WORKING_TO_SRGB @ rho, 0, 1)
    return 255 * np.where(c <= 0.0031308, 12.92 * c, 1.055 * c ** (1 / 2.4) - 0.055)


@pytest.mark.parametrize("lamp", ["A", "TL84", "D65", "environment"])
def test_surface_and_background_take_the_lamps_colour(renderer, scenes, lamp: str) -> None:
    renderer.set_environment(scenes.constant())
    renderer.set_mesh([scenes.sphere(rings=60)])
    renderer.set_material("paint", scenes.weights(kd=0.5, ior=1.0))
    picture = renderer.render_image(replace(VIEW, light_colour=LightColour(lamp, adapted=False)), SIZE)
    tint = light_matrix(lamp, adapted=False).sum(axis=1)
    assert np.abs(picture[48, 48] - encoded(0.25 * tint)).max() <= 1.5  # 0.5 of a light at -1 EV
    assert np.abs(picture[2, 2] - encoded(0.5 * tint)).max() <= 1.5
    grey = replace(VIEW, background="grey", light_colour=LightColour(lamp, adapted=False))
    assert np.ptp(renderer.render_image(grey, SIZE)[2, 2].astype(int)) <= 1  # a backdrop stays neutral


def test_to_an_adapted_eye_the_picture_stays(renderer, scenes) -> None:
    renderer.set_environment(scenes.constant())
    renderer.set_mesh([scenes.sphere(rings=60)])
    renderer.set_material("paint", scenes.weights(kd=0.5, ior=1.0))
    plain = renderer.render_image(VIEW, SIZE)
    seen = renderer.render_image(replace(VIEW, light_colour=LightColour("A", adapted=True)), SIZE)
    assert np.array_equal(plain, seen)
