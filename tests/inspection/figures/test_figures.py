"""The figures of a reflectance against values that are known: Lambert's, a furnace, holes, one hot spike."""

from __future__ import annotations

import csv
import io
from dataclasses import dataclass

import numpy as np
import pytest

from brdf_suite.appearance.geometries import GEOMETRY_SETS
from brdf_suite.errors import Cancelled
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.inspection.figures.figures import (
    FiguresRequest,
    angle_readings,
    errors_between,
    reflectance_figures,
    turned,
)
from brdf_suite.inspection.figures.text import figure_rows, figures_csv, figures_text, save_figures
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.registry import MODELS

ANGLES = GEOMETRY_SETS["e2194"]


def figures(reflectance, **wanted):
    return reflectance_figures(FiguresRequest(reflectance, geometry_set=ANGLES, **wanted))


@dataclass(frozen=True)
class Holed:
    """Matt, with no number where the view leans to +x."""

    kd: float = 0.5

    def eval(self, wi, wo):
        wi, wo = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
        value = np.full(wi.shape, self.kd / np.pi)
        value[wo[..., 0] > 0.0] = np.nan
        return value


@pytest.fixture(scope="module")
def matt():
    return figures(Lambertian((0.8, 0.5, 0.2)))


def test_a_matt_surface_sends_back_its_own_share_at_every_incidence(matt) -> None:
    np.testing.assert_allclose(
        matt.curve.albedo, np.tile((0.8, 0.5, 0.2), (len(matt.curve.albedo), 1)), atol=2e-3
    )
    np.testing.assert_allclose(matt.curve.hemispherical, (0.8, 0.5, 0.2), atol=1e-3)
    assert matt.curve.largest[0] == pytest.approx(0.8, abs=2e-3)
    assert matt.curve.largest[2] == "red"
    assert (matt.reciprocity.worst, matt.missing) == (0.0, 0.0)


def test_a_perfect_diffuser_reads_l_100_at_every_angle() -> None:
    white = figures(Lambertian((1.0, 1.0, 1.0)))
    assert [reading.geometry.name for reading in white.readings] == ["45as15", "45as45", "45as110"]
    np.testing.assert_allclose([r.lab for r in white.readings], np.tile((100.0, 0.0, 0.0), (3, 1)), atol=0.01)


def test_a_model_that_is_not_reciprocal_is_found_out() -> None:
    assert figures(MODELS["phong_original"].default).reciprocity.worst == pytest.approx(
        MODELS["phong_original"].violations["reciprocity"], abs=2e-3
    )


def test_errors_of_two_matt_surfaces_are_those_of_their_cosines() -> None:
    found = errors_between(Lambertian((0.6, 0.6, 0.6)), Lambertian((0.3, 0.3, 0.3)))
    # f differs by 0.3/π everywhere; cos²θ of the 8 lights has the mean 0.332 (midpoints), 1/3 in the limit.
    mean = np.mean(((np.arange(8) + 0.5) / 8) ** 2)
    assert found.whole.rms == pytest.approx(0.3 / np.pi * np.sqrt(mean))
    assert found.whole.relative_rms == pytest.approx(0.5)
    assert found.whole.worst == pytest.approx(0.3 / np.pi * 15 / 16)
    cubes = np.cbrt(0.6 / np.pi) - np.cbrt(0.3 / np.pi)
    assert found.whole.cube_root_rms == pytest.approx(cubes * np.sqrt(mean))
    assert found.share == 1.0
    nothing = errors_between(Lambertian((0.6, 0.6, 0.6)), Lambertian((0.6, 0.6, 0.6)))
    assert (nothing.whole.worst, nothing.where) == (0.0, "")


def test_holes_are_left_out_and_counted() -> None:
    found = figures(Holed(), reference=Lambertian((0.5, 0.5, 0.5)))
    assert found.missing == pytest.approx(0.5, abs=0.05)
    assert np.isfinite(found.curve.albedo).all()
    # Under the light at 45° only the half of the views on its own side has numbers.
    at_45 = list(found.curve.incidence_deg).index(45.0)
    assert found.curve.albedo[at_45, 0] == pytest.approx(0.25, abs=0.01)
    assert found.reciprocity.worst == 0.0
    assert [reading.lab is None for reading in found.readings] == [True, False, False]
    assert found.reference.whole.worst == 0.0
    assert found.reference.share == pytest.approx(0.5, abs=0.02)


def test_nothing_and_one_hot_spike_have_figures() -> None:
    black = figures(Lambertian((0.0, 0.0, 0.0)), fit=Lambertian((0.0, 0.0, 0.0)))
    assert not black.curve.albedo.any()
    assert black.fit.whole.relative_rms == 0.0
    none, peak = np.zeros((1, 3)), np.full((1, 3), (1e5 + 1.0) / (2.0 * np.pi))
    spike = LobeWeights(np.array([1e5]), np.zeros(3), none, peak, 0.0, 1.0)
    # Normalised so that straight light comes back whole.
    assert figures(spike).curve.albedo[0] == pytest.approx(1.0, abs=0.01)


def test_a_brushed_metal_is_another_along_and_across_its_cylinders() -> None:
    metal = MODELS["poulin_fournier"].default
    along, across = (
        angle_readings(turned(metal, azimuth), None, None, ANGLES)[1].lab[0] for azimuth in (0.0, 90.0)
    )
    assert abs(along - across) > 5.0


def test_turning_by_the_azimuth_is_turning_the_plane_of_incidence() -> None:
    seen = []

    class Seen:
        def eval(self, wi, wo):
            seen.append(np.asarray(wi))
            return np.zeros(3)

    turned(Seen(), 90.0).eval([-1.0, 0.0, 0.0], [0.0, 0.0, 1.0])
    np.testing.assert_allclose(seen[0], [0.0, -1.0, 0.0], atol=1e-12)


def test_the_work_can_be_cancelled() -> None:
    def stop(_fraction: float, _what: str) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        reflectance_figures(FiguresRequest(Lambertian((0.5, 0.5, 0.5))), stop)


def test_text_and_csv_hold_every_figure_of_every_reflectance(matt, tmp_path) -> None:
    other = figures(Lambertian((0.1, 0.1, 0.1)), reference=Lambertian((0.8, 0.5, 0.2)))
    named = [("red, matt", matt), ("dark", other)]
    rows = list(csv.reader(io.StringIO(figures_csv(named))))
    assert rows[0] == ["figure", "unit", "red, matt", "dark"]
    values = {row[0]: row[1:] for row in rows[1:]}
    assert float(values["albedo at 45°, red"][1]) == pytest.approx(0.8, abs=2e-3)
    assert float(values["L* 45as15"][2]) == pytest.approx(other.readings[0].lab[0], rel=1e-5)
    assert values["difference, worst"][1] == ""  # the first has no reference
    assert float(values["difference, worst"][2]) > 0.0
    assert not any(name.startswith("fit,") for name in values)
    assert len(values) == len(rows) - 1 == len(figure_rows(named))
    assert figures_text(named).splitlines()[0].split("\t") == ["", "unit", "red, matt", "dark"]
    save_figures(named, tmp_path / "figures.csv")
    assert (tmp_path / "figures.csv").read_bytes().decode("utf-8") == figures_csv(named)
    assert figures_csv([]) == "figure,unit\r\n"
