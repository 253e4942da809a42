"""The four-angle table."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.tabulated.anisotropic import AnisotropicTable

THETA = np.radians([0.0, 15.0, 30.0, 45.0, 60.0, 75.0])


class Brushed:
    """Smooth, and another along x than along y."""

    def eval(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
        half = (wi + wo) / np.linalg.norm(wi + wo, axis=-1, keepdims=True)
        lobe = np.exp(-2.0 * half[..., 0] ** 2 - 0.5 * half[..., 1] ** 2)
        return lobe[..., None] * np.array([1.0, 0.5, 0.25])


def table() -> AnisotropicTable:
    return AnisotropicTable.from_reflectance(Brushed(), THETA, 48)


def test_the_nodes_are_met() -> None:
    rng = np.random.default_rng(1)
    a, b, c, d = (rng.integers(0, n, 100) for n in (6, 48, 6, 48))
    step = np.radians(7.5)
    wi, wo = spherical(THETA[a], b * step), spherical(THETA[c], d * step)
    here = table()
    assert np.allclose(here.eval(wi, wo), here.values[a, b, c, d], atol=1e-5)
    assert np.allclose(here.eval(wi, wo), Brushed().eval(wi, wo), atol=1e-5)


def test_between_nodes_it_is_near() -> None:
    rng = np.random.default_rng(2)
    wi = spherical(rng.uniform(0.0, 1.3, 2000), rng.uniform(-4.0, 4.0, 2000))
    wo = spherical(rng.uniform(0.0, 1.3, 2000), rng.uniform(-4.0, 4.0, 2000))
    assert np.abs(table().eval(wi, wo)[:, 0] - Brushed().eval(wi, wo)[:, 0]).max() < 0.03


def test_a_highlight_between_two_azimuths_of_the_light_keeps_its_height() -> None:
    values = np.zeros((6, 48, 6, 48, 3), np.float32)
    for k in range(48):
        values[:, k, :, (k + 24) % 48] = 1.0  # a ridge opposite the light
    ridge = AnisotropicTable(values, THETA, THETA)
    phi = np.radians(np.linspace(0.0, 30.0, 9))
    assert np.allclose(ridge.eval(spherical(0.6, phi), spherical(0.6, phi + np.pi)), 1.0, atol=1e-5)
    aside = ridge.eval(spherical(0.6, phi), spherical(0.6, phi + np.pi + np.radians(3.75)))
    assert np.allclose(aside, 0.5, atol=1e-5)


def test_beyond_the_last_node_the_value_is_held_and_below_the_horizon_it_is_zero() -> None:
    here = table()
    wo = spherical(0.4, 1.0)
    edge = here.eval(spherical(THETA[-1], 0.3), wo)
    assert np.allclose(here.eval(spherical(1.55, 0.3), wo), edge, rtol=1e-5)
    assert np.array_equal(here.eval(spherical(1.6, 0.3), wo), np.zeros(3))


def test_nodes_can_be_made_reciprocal() -> None:
    rng = np.random.default_rng(3)
    uneven = AnisotropicTable(rng.random((6, 8, 6, 8, 3)), THETA, THETA)
    even = uneven.made_reciprocal().values
    assert np.allclose(even, even.transpose(2, 3, 0, 1, 4))
    assert even[1, 2, 3, 4, 0] == pytest.approx(
        0.5 * (uneven.values[1, 2, 3, 4, 0] + uneven.values[3, 4, 1, 2, 0])
    )
    with pytest.raises(ValueRangeError, match="theta_o"):
        AnisotropicTable(rng.random((6, 8, 2, 8, 3)), THETA, [0.1, 0.2]).made_reciprocal()


@pytest.mark.parametrize(
    ("change", "place"),
    [
        ({"values": np.ones((6, 8, 6, 9, 3))}, "values"),
        ({"values": np.ones((6, 8, 5, 8, 3))}, "values"),
        ({"values": np.ones((6, 8, 6))}, "values"),
        ({"values": np.full((6, 8, 6, 8, 3), np.nan)}, "values"),
        ({"theta_i": THETA[::-1]}, "theta_i"),
        ({"theta_o": np.append(THETA[:-1], 2.0)}, "theta_o"),
        ({"theta_o": np.append(THETA[:-1], np.nan)}, "theta_o"),
    ],
)
def test_what_is_no_table_is_refused_by_name(change: dict[str, np.ndarray], place: str) -> None:
    sound = {"values": np.ones((6, 8, 6, 8, 3)), "theta_i": THETA, "theta_o": THETA}
    with pytest.raises(ValueRangeError, match=place):
        AnisotropicTable(**{**sound, **change})
