"""The lights of a ray-traced picture: dealt and drawn without gain or loss, and on the average the environment."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.documents.view_settings import Lamp
from brdf_suite.errors import ValueRangeError
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.lights import directional_lights
from brdf_suite.reference.raytraced.light_set import FAR_LAMP, NEAR_LAMP, LightSet, Strata
from brdf_suite.reference.raytraced.quality import PRESETS, Quality, find_quality


@pytest.fixture(scope="module")
def sky() -> Environment:
    """An uneven sky with a small sun that has about half of all light."""
    rng = np.random.default_rng(2)
    radiance = rng.random((32, 64, 3)).astype(np.float32)
    radiance[9, 21] += 3600.0
    return Environment("sky", radiance)


@pytest.fixture(scope="module")
def strata(sky: Environment) -> Strata:
    return Strata.of(sky, 48, np.eye(3))


def irradiance(lights: LightSet, normals: np.ndarray) -> np.ndarray:
    return np.maximum(normals @ lights.places.T, 0.0) @ lights.strengths


def test_the_first_rounds_lights_are_those_of_the_environment(sky, strata) -> None:
    wanted, found = directional_lights(sky, 48), strata.middles()
    np.testing.assert_allclose(found.places, wanted.directions)
    np.testing.assert_allclose(found.strengths, wanted.strengths)
    assert np.argmax(found.strengths.sum(axis=1)) == 0
    assert found.spreads[0] < 0.08 < np.median(found.spreads)


@pytest.mark.parametrize("hands", [1, 5, 16])
def test_dealing_keeps_all_light_and_cuts_the_strongest(strata, hands: int) -> None:
    lights = strata.middles()
    dealt = lights.dealt(hands)
    assert len(dealt) % hands == 0
    np.testing.assert_allclose(dealt.strengths.sum(axis=0), lights.strengths.sum(axis=0))
    normals = np.random.default_rng(3).normal(size=(20, 3))
    np.testing.assert_allclose(irradiance(dealt, normals), irradiance(lights, normals))
    each = dealt.strengths.reshape(-1, hands, 3).sum(axis=(0, 2))
    total = lights.strengths.sum()
    if hands > 1:
        # No hand has the sun alone: that one would have half of all light.
        assert lights.strengths[0].sum() > 0.4 * total
        assert each.max() < 2.6 / hands * total
        first_half = each[: hands // 2].sum() / (hands // 2) * hands
        assert first_half == pytest.approx(total, rel=0.5)


def test_drawn_lights_stand_for_all_exactly(strata) -> None:
    lights = strata.middles().with_lamps((Lamp("directional", strength=2.0),)).dealt(16)
    entries, factors = lights.draws()
    size = entries.shape[1]
    assert size == 1 << (size.bit_length() - 1)
    for row in (0, 1):
        mean = (lights.strengths * factors[row][:, None])[entries[row]].mean(axis=0)
        lit = np.bincount(entries[row], minlength=len(lights)) > 0
        np.testing.assert_allclose(mean, lights.strengths[lit].sum(axis=0), rtol=1e-9)
    # A level ground gets nothing from below, nor from lamps, whose light it is no picture of.
    ground = lights.places[np.unique(entries[1])]
    assert (ground[:, 1] > 0.0).all()
    lamps = np.flatnonzero(lights.kinds == FAR_LAMP)
    assert not np.isin(lamps, entries[1]).any()
    assert np.isin(lamps, entries[0]).all()


def test_lights_drawn_anew_are_the_environment_on_the_average(sky, strata) -> None:
    """A z-test of the irradiance over rounds, against the map's own sum."""
    from brdf_suite.lighting.lights.cells import sum_cells

    normals = np.random.default_rng(4).normal(size=(6, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    rounds = np.stack([irradiance(strata.drawn(seed), normals) for seed in range(1, 201)])
    fine = sum_cells(np.repeat(np.repeat(sky.radiance, 8, axis=0), 8, axis=1))
    turned = strata.cells.turn
    centres = fine.centres().reshape(-1, 3)
    c, s = np.cos(fine.turn), np.sin(fine.turn)
    world = centres @ np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]]).T
    wanted = np.maximum(normals @ world.T, 0.0) @ fine.energy.reshape(-1, 3)
    error = rounds.std(axis=0, ddof=1) / np.sqrt(len(rounds))
    assert np.isfinite(turned)
    assert (np.abs(rounds.mean(axis=0) - wanted) < 4.5 * error + 2e-4 * wanted).all()
    # What is drawn is one direction of its stratum, so no extent of it is left.
    assert strata.drawn(1).spreads.max() == 0.0
    # And no two rounds are the same.
    assert (rounds.std(axis=0) > 0.0).all()


def test_lamps_and_turns(strata) -> None:
    lamps = (
        Lamp("point", position=(1.0, 2.0, 3.0), strength=2.0),
        Lamp("directional", azimuth_deg=90.0, elevation_deg=0.0),
    )
    found = strata.middles().turned(90.0).with_lamps(lamps)
    assert found.kinds[-2:].tolist() == [NEAR_LAMP, FAR_LAMP]
    np.testing.assert_allclose(found.places[-2:], [[1.0, 2.0, 3.0], [1.0, 0.0, 0.0]], atol=1e-12)
    before = strata.middles().places[0]
    np.testing.assert_allclose(found.places[0], [before[2], before[1], -before[0]], atol=1e-12)
    # A turn of the light leaves lamps where they are.
    np.testing.assert_allclose(found.turned(30.0).places[-2:], found.places[-2:])


def test_a_black_environment_has_lights_without_light() -> None:
    black = Environment("black", np.zeros((8, 16, 3), np.float32))
    lights = Strata.of(black, 4, np.eye(3)).middles().dealt(4)
    assert lights.strengths.max() == 0.0
    entries, factors = lights.draws()
    assert factors.max() == 0.0
    assert entries.max() < len(lights)


def test_qualities() -> None:
    assert find_quality("medium") == Quality(128, 16, 16)
    assert [(q.lights_a_sample, q.reflections_a_sample) for q in PRESETS.values()] == [
        (16, 1),
        (8, 1),
        (16, 4),
    ]
    assert [q.mirrors for q in PRESETS.values()] == [True, False, False]
    assert Quality(16, 1, 1, mirror=False).mirrors is False
    with pytest.raises(ValueRangeError, match="one of fast, medium, high"):
        find_quality("best")
    for wrong in (0, 1025, True, 2.0):
        with pytest.raises(ValueRangeError, match="lights"):
            Quality(wrong, 1, 1)
