"""What the shader is given of single lights: the block, and a material's lobes over the angle."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.appearance.flakes.tilt import tilt_bell
from brdf_suite.appearance.flakes.visible import LARGEST_SHARE, flake_coverage
from brdf_suite.documents.paint import Flakes
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Lamp, LightColour, Sparkle
from brdf_suite.realtime.lights.block import (
    BLOCK_SIZE,
    DistantLights,
    column_angles,
    light_block,
    light_lobes,
    seen_tilts,
    visible_flake_lobe,
)
from brdf_suite.reflectance.designed.rules import squared_tilt


def rows(block):
    return np.frombuffer(block, np.float32).reshape(-1, 4)


def two_lights():
    return DistantLights(
        np.array([[0.0, 0.6, 0.8], [1.0, 0.0, 0.0]]),
        np.array([[3.0, 2.0, 1.0], [0.5] * 3]),
        np.array([0.01, 0.03]),
    )


def test_lights_turn_with_the_environment_and_lamps_do_not():
    lamps = (
        Lamp("point", (1.0, 2.0, 3.0), strength=2.0),
        Lamp("directional", azimuth_deg=90, elevation_deg=30),
    )
    block = rows(light_block(View(rotation_deg=90, lamps=lamps), two_lights()))
    assert block.nbytes == BLOCK_SIZE
    assert block[0, :2].tolist() == [2, 4]
    # From above, counter-clockwise: +z goes to +x, +x to -z.
    np.testing.assert_allclose(block[1], [0.8, 0.6, 0, 0], atol=1e-6)
    np.testing.assert_allclose(block[2], [3, 2, 1, 0.01], atol=1e-6)
    np.testing.assert_allclose(block[3], [0, 0, -1, 0], atol=1e-6)
    np.testing.assert_allclose(block[5], [1, 2, 3, 2])
    # Its strength is illuminance over pi.
    assert block[6, :3] @ LUMINANCE == pytest.approx(2 * np.pi, rel=1e-4)
    np.testing.assert_allclose(block[7], [np.cos(np.pi / 6), 0.5, 0, 1], atol=1e-6)


def test_a_broad_light_is_left_to_the_maps_where_flakes_are_a_population():
    lights = replace(two_lights(), spreads=np.array([0.01, 0.2]))
    assert rows(light_block(View(), lights))[0, 0] == 1
    assert rows(light_block(View(sparkle=Sparkle("texture")), lights))[0, 0] == 2


def test_as_many_lights_as_the_view_says_and_none_without_sparkle():
    one = rows(light_block(View(sparkle=Sparkle(light_count=1)), two_lights()))
    assert one[0, :2].tolist() == [1, 1]
    off = rows(light_block(View(sparkle=Sparkle("off"), lamps=(Lamp(),)), two_lights()))
    assert off[0, :2].tolist() == [0, 1]
    assert off[1, 3] == 2


def test_lights_of_the_environment_take_the_lamp_colour():
    plain = rows(light_block(View(), two_lights()))[2]
    warm = rows(light_block(View(light_colour=LightColour("A", adapted=False)), two_lights()))[2]
    assert warm[0] / warm[2] > 2 * plain[0] / plain[2]


def test_the_table_holds_the_lobe_sums(scenes):
    weights = scenes.weights(kd=0.1, gloss=0.04, directional=0.3)
    table = light_lobes(weights)
    gamma = column_angles()
    exponents = np.asarray(weights.exponents)
    powers = np.cos(gamma)[:, None].clip(0) ** exponents
    np.testing.assert_allclose(table[0, :, :3], powers @ weights.kdd, rtol=1e-4, atol=1e-6)
    np.testing.assert_allclose(table[1, :, :3], powers @ weights.kg, rtol=1e-3, atol=1e-3)
    np.testing.assert_allclose(table[:3, 0, 3], weights.kd)
    assert not table[2, :, :3].any()
    assert not table[:2, -1, :3].any()


def test_visible_flakes_send_what_they_cover_and_never_most_of_the_base():
    gamma = np.linspace(0, np.pi / 2, 2000)
    base = np.tile([1.0, 0.8, 0.5], (2000, 1))
    flakes = Flakes(60.0, 30.0, 0.16)
    lobe = visible_flake_lobe(flakes, gamma, base, 0.0, 1.5)
    # What mirrors send in all, at normal incidence: cover times reflectance times the coat twice.
    sent = np.trapezoid(lobe[:, 0] * np.cos(gamma) * np.sin(gamma), gamma) * 2 * np.pi
    through = 0.96**2
    # Light that flakes tilted beyond about 21 degrees send is held back by the coat.
    tilt = np.linspace(0, np.arcsin(1 / 1.5) / 2, 2000)
    out = np.trapezoid(tilt_bell(np.tan(tilt) ** 2, 0.16) * np.sin(tilt), tilt) * 2.0 / 0.16**2
    assert sent == pytest.approx(flake_coverage(flakes) * 0.9 * through * out, rel=0.15)
    np.testing.assert_allclose(lobe / lobe[:, :1], base / base[:, :1], rtol=1e-9)
    strong = visible_flake_lobe(flakes, gamma, base, 0.0, 1.5, strength=1e6)
    np.testing.assert_allclose(strong, LARGEST_SHARE * base)
    assert flake_coverage(Flakes(1e5, 2000.0)) == pytest.approx(1.0)


def test_the_tilts_seen_are_those_of_the_flake_rule_and_of_the_shader():
    gamma = np.linspace(0, np.pi / 2, 50)
    want = tilt_bell(squared_tilt(gamma, np.pi / 4, 1.5), 0.16)
    np.testing.assert_allclose(seen_tilts(gamma, np.pi / 4, 1.5, 0.16), want, rtol=1e-12)
