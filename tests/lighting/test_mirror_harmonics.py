"""Functions about a mirror direction in harmonics: lobes by values and by formula agree, in place and in size."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from brdf_suite.lighting.filter.mirror_harmonics import BROAD_DEGREES, mirror_harmonics
from brdf_suite.lighting.filter.shading_table import typical_power


@pytest.mark.parametrize(
    ("turned", "exponent", "kind"),
    [
        (0.0, 1.5, {}),
        (0.0, 675.0, {}),
        (0.0, 116000.0, {}),
        (0.4, 20.0, {}),
        (-0.3, 20.0, {}),
        (0.0, 116000.0, {"orders": 24}),
        (0.1, 20.0, {"orders": 24}),
        (0.4, 20.0, {"sharp": False}),
        (-0.3, 80.0, {"sharp": False}),
    ],
)
def test_a_lobe_by_its_values_is_the_lobe_by_its_formula(
    turned: float, exponent: float, kind: dict[str, Any]
) -> None:
    sphere = mirror_harmonics(**kind)
    lights = sphere.lights(0.5)
    sine = np.sqrt(0.75)
    direction = np.cos(turned) * np.array([sine, 0.0, 0.5]) + np.sin(turned) * np.array([-0.5, 0.0, sine])
    values = (exponent + 1.0) / (2.0 * np.pi) * np.maximum(lights @ direction, 0.0) ** exponent
    (found,) = sphere.analyse(values[None, ..., None] * [1.0, 2.0, 0.0])
    wanted = sphere.lobes(np.array([turned]), np.array([exponent]))[:, 0]
    broad = sum(BROAD_DEGREES + 1 - order for order in range(kind.get("orders", BROAD_DEGREES) + 1))
    assert np.abs(found[:broad, 0] - wanted[:broad]).max() < 2e-4 * np.abs(wanted).max()
    assert np.abs(found[broad:, 0] - wanted[broad:]).max(initial=0.0) < 5e-4 * np.abs(wanted).max()
    np.testing.assert_allclose(found[:, 1], 2.0 * found[:, 0])
    assert not found[:, 2].any()


def test_away_from_the_mirror_direction_a_sharp_lobe_is_nothing_and_a_broad_one_nearly_whole() -> None:
    whole, away = mirror_harmonics(sharp=False), mirror_harmonics(sharp=False, away=True)
    sizes = [np.linalg.norm(of.lobes(np.zeros(2), np.array([2.0, 3000.0])), axis=0) for of in (whole, away)]
    assert 0.8 < sizes[1][0] / sizes[0][0] < 1.0
    assert sizes[1][1] < 0.02 * sizes[0][1]


def test_rings_are_a_whole_sphere_about_the_mirror_direction() -> None:
    sphere = mirror_harmonics()
    lights = sphere.lights(0.3)
    np.testing.assert_allclose(np.linalg.norm(lights, axis=-1), 1.0, rtol=1e-12)
    mirrored = np.array([np.sqrt(1.0 - 0.09), 0.0, 0.3])
    np.testing.assert_allclose(lights @ mirrored, np.cos(sphere.gamma)[:, None] * np.ones(48), atol=1e-12)
    # The first coefficient is the mean's; N·ω above the horizon holds π.
    cosine = np.maximum(lights[..., 2:], 0.0).repeat(3, axis=-1)
    assert sphere.analyse(cosine[None])[0, 0, 0] * np.sqrt(4.0 * np.pi) == pytest.approx(np.pi, rel=1e-3)


def test_the_squared_length_is_the_error_in_typical_light() -> None:
    """A cosine lobe's k_l are known: Σ C_l (2l+1)/4π k_l² is what its vector holds."""
    sphere = mirror_harmonics()
    vector = sphere.lobes(np.array([0.7]), np.array([1.0]))[:, 0]
    degrees = np.arange(3)
    k = np.array([1.0, 2.0 / 3.0, 0.25])
    low = float((typical_power(2) * (2 * degrees + 1) / (4 * np.pi) * k**2).sum())
    assert low < vector @ vector < 1.01 * low
