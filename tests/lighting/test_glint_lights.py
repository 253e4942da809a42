"""The lights in which flakes glint: small, bright, each with its own extent."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.errors import ValueRangeError
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.latlong import column_angles, direction, ring_angles
from brdf_suite.lighting.lights.glinting import GlintLights, glint_lights

SUN = np.array([0.48, 0.64, 0.6])


def sky(radius_deg, radiance, size=(256, 512), towards=SUN):
    """An even sky of radiance 0.2 with an even disc of light in it."""
    way = direction(ring_angles(size[0])[:, None], column_angles(size[1])[None, :])
    disc = way @ towards > np.cos(np.radians(radius_deg))
    return Environment("sky", np.where(disc[..., None], radiance, np.full(3, 0.2)).astype(np.float32))


def test_a_sun_is_one_light_without_the_sky_around_it():
    found = glint_lights(sky(1.0, np.array([900.0, 800.0, 600.0])), 8)
    assert found.directions[0] @ SUN > np.cos(np.radians(0.5))
    disc = 2 * np.pi * (1 - np.cos(np.radians(1.0)))
    np.testing.assert_allclose(found.strengths[0], disc * np.array([900.0, 800.0, 600.0]), rtol=0.2)
    np.testing.assert_allclose(found.strengths[0] / found.strengths[0, 0], [1, 8 / 9, 2 / 3], rtol=1e-3)
    # An even disc of radius r has the standard deviation r / 2 along an axis.
    assert np.degrees(found.spreads[0]) == pytest.approx(0.5, rel=0.25)
    assert found.strengths[1].sum() < 0.08 * found.strengths[0].sum()


def test_what_is_small_comes_before_what_is_broad():
    """A window of fifty times the light of a lamp glints less than the lamp."""
    lamp, window = (
        sky(1.0, np.full(3, 300.0)),
        sky(25.0, np.full(3, 15.0), towards=np.array([-1.0, 0.0, 0.0])),
    )
    both = Environment("both", lamp.radiance + window.radiance)
    found = glint_lights(both, 8)
    assert found.directions[0] @ SUN > np.cos(np.radians(1.0))
    assert found.spreads[0] < np.radians(1.0) < found.spreads[1]


def test_lights_turn_with_the_environment():
    environment = sky(2.0, np.full(3, 900.0))
    quarter = Environment("turned", np.roll(environment.radiance, 128, axis=1))
    found, rolled = glint_lights(environment, 4), glint_lights(quarter, 4)
    angle = np.arctan2(rolled.directions[0, 0], rolled.directions[0, 2]) - np.arctan2(
        found.directions[0, 0], found.directions[0, 2]
    )
    np.testing.assert_allclose(found.turned(angle).directions, rolled.directions, atol=1e-9)
    assert abs(np.degrees(angle)) % 180 == pytest.approx(90, abs=1e-6)


def test_a_black_map_has_no_light_and_an_even_one_no_small_one():
    black = Environment("black", np.zeros((16, 32, 3), np.float32))
    assert len(glint_lights(black)) == 0
    even = glint_lights(Environment("even", np.ones((32, 64, 3), np.float32)), 16)
    assert len(even) == 16
    assert even.spreads.min() > 0.05


@pytest.mark.parametrize("count", [0, 17])
def test_too_few_and_too_many(count):
    with pytest.raises(ValueRangeError, match="count"):
        glint_lights(sky(2.0, np.full(3, 9.0)), count)


def test_wrong_numbers_are_refused():
    with pytest.raises(ValueRangeError, match="strengths"):
        GlintLights(np.eye(3), np.full((3, 3), -1.0), np.zeros(3))
    with pytest.raises(ValueRangeError, match="spreads"):
        GlintLights(np.eye(3), np.ones((3, 3)), np.full(3, np.nan))
