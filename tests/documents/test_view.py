"""The view value."""

from __future__ import annotations

import pytest

from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import LightColour, Relief
from brdf_suite.errors import ValueRangeError


@pytest.mark.parametrize("name", ["booth", "speed_form", "/home/me/a b/sky.exr", "C:\\light\\sky.hdr"])
def test_names_and_absolute_paths_are_kept(name: str) -> None:
    assert View(environment=name).environment == name
    assert View(surface=name).surface == name


@pytest.mark.parametrize(
    ("build", "place", "words"),
    [
        (lambda: View(environment="maps/sky.exr"), "environment", "absolute path"),
        (lambda: View(surface=""), "surface", "empty"),
        (lambda: View(environment=None), "environment", "null"),
        (lambda: View(exposure_ev=float("nan")), "exposure_ev", "finite"),
        (lambda: View(tone_curve="filmic"), "tone_curve", "neutral, characteristic, aces, agx, linear"),
        (lambda: View(fresnel=1), "fresnel", "off, raised, multi_angle"),
        (lambda: View(lamp_shading="all"), "lamp_shading", "each, ball"),
        (lambda: LightColour(brightness=-1.0), "brightness", "range"),
        (lambda: Relief(tangent_map="grain.png"), "tangent_map", "absolute path"),
        (lambda: View(camera={}), "camera", "expected a camera"),
        (lambda: Camera(elevation_deg=91.0), "elevation_deg", "-90 to 90"),
        (lambda: Camera(distance=0.0), "distance", "range"),
        (lambda: Camera(target=(0.0, 0.0)), "target", "list of 2"),
        (lambda: Camera(target=(0.0, "a", 0.0)), "target[1]", "'a'"),
        (lambda: Camera(focal_length_mm=0.0), "focal_length_mm", "mm"),
    ],
)
def test_a_bad_value_is_refused_by_its_place(build, place: str, words: str) -> None:
    with pytest.raises(ValueRangeError) as caught:
        build()
    assert caught.value.place == place
    assert words in str(caught.value)
