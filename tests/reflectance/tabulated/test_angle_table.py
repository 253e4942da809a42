"""Tables over four angles: azimuths that go round, symmetries, sampling, and what is refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.albedo import white_furnace
from brdf_suite.reflectance.tabulated.angle_table import AngleTable

POLAR = np.radians([0.0, 30.0, 60.0, 85.0])
ROUND = np.radians(np.arange(0.0, 360.0, 45.0))
ONE = np.zeros(1)


def table(**changes: Any) -> AngleTable:
    rng = np.random.default_rng(2)
    fields: dict[str, Any] = {
        "coordinates": "spherical",
        "axes": (POLAR, ONE, POLAR, ROUND),
        "values": rng.uniform(0.1, 1.0, (4, 1, 4, 8, 3)).astype(np.float32),
    }
    return AngleTable(**(fields | changes))


def test_an_isotropic_table_turns_with_the_sample() -> None:
    value = table()
    assert value.isotropic
    wi, wo = spherical(0.7, 0.3), spherical(0.4, 2.0)
    turned = value.eval(spherical(0.7, 1.5), spherical(0.4, 3.2))
    assert turned == pytest.approx(value.eval(wi, wo), rel=1e-5)


def test_between_the_last_azimuth_and_the_first_it_is_linear() -> None:
    value = table()
    at = [value.eval(spherical(0.7, 0.0), spherical(0.4, np.radians(phi))) for phi in (315.0, 337.5, 360.0)]
    assert at[1] == pytest.approx(0.5 * (at[0] + at[2]), rel=1e-5)


def test_a_mirrored_table_is_the_same_on_both_sides() -> None:
    half = np.radians([0.0, 60.0, 180.0])
    values = np.random.default_rng(3).uniform(0.1, 1.0, (4, 1, 4, 3, 1)).astype(np.float32)
    value = table(axes=(POLAR, ONE, POLAR, half), values=values, mirrored=True)
    wi = spherical(0.7, 0.2)
    found = [value.eval(wi, spherical(0.4, 0.2 + turn)) for turn in (1.1, -1.1)]
    assert found[0] == pytest.approx(found[1], rel=1e-5)
    assert np.ptp(found[0]) == 0.0  # grey


def test_a_reciprocal_table_gives_a_pair_and_its_swap_one_value() -> None:
    quarter = np.radians([0.0, 45.0, 90.0, 135.0])
    values = np.random.default_rng(4).uniform(0.1, 1.0, (4, 1, 4, 4, 3)).astype(np.float32)
    value = table(
        coordinates="half_difference", axes=(POLAR, ONE, POLAR, quarter), values=values, reciprocal=True
    )
    wi, wo = spherical(0.7, 0.2), spherical(0.4, 1.9)
    assert value.eval(wi, wo) == pytest.approx(value.eval(wo, wi), rel=1e-5)


def test_spectra_become_the_colour_of_their_observer() -> None:
    bands = np.array([450.0, 550.0, 650.0])
    grey = table(values=np.full((4, 1, 4, 8, 3), 0.25, np.float32), wavelengths_nm=bands, observer_deg=2)
    wi, wo = spherical(0.7, 0.2), spherical(0.4, 1.9)
    assert grey.eval_spectra(wi, wo) == pytest.approx([0.25] * 3)
    assert grey.eval(wi, wo) == pytest.approx([0.25] * 3, rel=1e-3)
    with pytest.raises(ValueRangeError, match="no spectra"):
        table().eval_spectra(wi, wo)


def test_below_the_horizon_there_is_nothing() -> None:
    value = table()
    up, down = spherical(0.4, 0.0), spherical(2.0, 0.0)
    assert not value.eval(np.stack((up, down)), np.stack((down, up))).any()
    assert value.eval(np.empty((0, 3)), up).shape == (0, 3)


def test_samples_follow_the_density_and_give_back_the_light() -> None:
    value = table()
    wo = spherical(0.6, 0.4)
    rng = np.random.default_rng(5)
    wi = value.sample(np.broadcast_to(wo, (40_000, 3)), rng.random((40_000, 3)))
    density = value.pdf(wi, wo)
    light = value.eval(wi, wo) * wi[:, 2:].clip(0.0) / density[:, None]
    expected = white_furnace(value, wo)
    deviation = light.std(axis=0) / np.sqrt(len(light))
    assert (np.abs(light.mean(axis=0) - expected) < 4.0 * deviation + 2e-3 * expected).all()


@pytest.mark.parametrize(
    ("change", "place"),
    [
        ({"axes": (POLAR[::-1], ONE, POLAR, ROUND)}, "axes"),
        ({"axes": (POLAR, np.zeros(0), POLAR, ROUND)}, "axes"),
        ({"values": np.ones((4, 1, 4, 7, 3))}, "values"),
        ({"values": np.ones((4, 1, 4, 8, 2))}, "values"),
        ({"values": np.full((4, 1, 4, 8, 3), -1.0)}, "values"),
        ({"values": np.full((4, 1, 4, 8, 3), np.nan)}, "values"),
        ({"wavelengths_nm": np.array([500.0])}, "values"),
    ],
)
def test_what_is_no_table_is_refused(change: dict[str, Any], place: str) -> None:
    with pytest.raises(ValueRangeError) as caught:
        table(**change)
    assert caught.value.place.startswith(place)
