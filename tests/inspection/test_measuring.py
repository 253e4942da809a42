"""Errors over all directions, by hand."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import pytest

from brdf_suite.appearance.difference.tolerance import Tolerances
from brdf_suite.appearance.geometries import geometry_set
from brdf_suite.inspection.measuring import compare, measurement_json
from brdf_suite.pipeline.fit_errors import hemisphere_pairs
from brdf_suite.pipeline.material import Material, load_material
from brdf_suite.reflectance.instruments.aperture import WIDE
from brdf_suite.reflectance.instruments.spectrophotometer import measure


@dataclass(frozen=True)
class Diffuser:
    """f_r the same everywhere."""

    f: float

    def eval(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
        return np.full(np.broadcast_shapes(np.shape(wi), np.shape(wo)), self.f)


def test_the_angle_set_is_even_in_solid_angle() -> None:
    wi, wo, weight = hemisphere_pairs()
    assert len(wi) == len(wo) == len(weight) == 8 * 16 * 32
    assert weight.sum() == pytest.approx((2.0 * math.pi) ** 2)
    # Over a hemisphere the mean of cosθ is ½, of cos²θ ⅓ (the midpoint rule is 1/(12 n²) short).
    for directions, rings in ((wi, 8), (wo, 16)):
        assert directions[:, 2].mean() == pytest.approx(0.5)
        assert (directions[:, 2] ** 2).mean() == pytest.approx(1.0 / 3.0 - 1.0 / (12 * rings**2))
    np.testing.assert_allclose(np.linalg.norm(wi, axis=-1), 1.0)


def test_errors_by_hand() -> None:
    """f 0.3 against 0.1: cosine RMS is 0.2 √(mean cos²), cube roots likewise, the log of the two near 0.2 cosθ."""
    result = compare(Material("a", Diffuser(0.3)), Material("b", Diffuser(0.1)), geometry_set("e2194"))
    mean_square = math.sqrt(1.0 / 3.0 - 1.0 / (12 * 64))
    assert result.figures.cosine_rms == pytest.approx(0.2 * mean_square)
    assert result.figures.cube_root_rms == pytest.approx((0.3 ** (1 / 3) - 0.1 ** (1 / 3)) * mean_square)
    cosines = (np.arange(8) + 0.5) / 8
    logs = np.log((1 + 0.3 * cosines) / (1 + 0.1 * cosines))
    assert result.figures.log_rms == pytest.approx(math.sqrt((logs**2).mean()))
    assert result.metamerism is None
    assert result.away.cosine_rms == pytest.approx(result.figures.cosine_rms, rel=0.02)


def test_a_verdict_is_part_of_the_answer() -> None:
    pair = (Material("a", Diffuser(0.3)), Material("b", Diffuser(0.29)))
    answer = compare(*pair, geometry_set("e2194"), tolerances=Tolerances({45.0: 0.1}, 5.0)).to_json()
    assert [row["passes"] for row in answer["verdict"]["angles"]] == [True, False, True]
    assert answer["verdict"]["passes"] is False


def test_a_mirror_that_leaves_the_receptor_counts_only_near_the_mirror() -> None:
    blue = load_material("blue")
    glossless = Material("base", blue.reflectance.base)
    result = compare(blue, glossless)
    # The coat is all that differs, and it is a narrow lobe.
    assert result.away.cosine_rms < 1e-6
    assert max(result.differences["2000"]) < 0.05


def test_a_paint_is_solved_on_loading() -> None:
    plain, solved = load_material("copper"), load_material("copper", solved_through=WIDE)
    angles = geometry_set("e2194")
    wanted = np.array([m.lab for m in plain.paint.measurements])
    np.testing.assert_allclose(measure(solved.reflectance, angles, WIDE).lab, wanted, atol=0.05)
    assert np.abs(measure(plain.reflectance, angles, WIDE).lab - wanted).max() > 0.1


def test_a_flop_that_does_not_exist_is_null() -> None:
    item = Material("black", Diffuser(0.0))
    answer = measurement_json(item, measure(item.reflectance))
    assert answer["flop_index"] == 0.0
    assert measurement_json(item, measure(item.reflectance, geometry_set("45:45")))["flop_index"] is None
