"""The virtual instrument: gloss by integration, colours, flop and travel."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.appearance.clearcoat_gloss import black_glass, gloss_units
from brdf_suite.appearance.flop.travel import flop_index
from brdf_suite.appearance.geometries import GEOMETRY_SETS, geometry_set
from brdf_suite.documents.paint import Gloss
from brdf_suite.errors import FittingError
from brdf_suite.geometry.directions import illumination, spherical
from brdf_suite.pipeline.material import load_material, load_shipped_paint, paint_names
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.instruments.aperture import WIDE, Aperture
from brdf_suite.reflectance.instruments.glossmeter import gloss_reading
from brdf_suite.reflectance.instruments.spectrophotometer import measure
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples
from tools.evaluation.gloss_apertures import aperture_gloss


@dataclass(frozen=True)
class Diffuser:
    """A Lambertian reflectance factor per channel."""

    rho: float

    def eval(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
        shape = np.broadcast_shapes(np.shape(wi), np.shape(wo))
        return np.full(shape, self.rho / math.pi)


@dataclass(frozen=True)
class Broken:
    """Not a number where the view is steeper than ``beyond_deg``."""

    beyond_deg: float

    def eval(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
        wi, wo = np.broadcast_arrays(wi, wo)
        return np.where(wo[..., 2:] < math.cos(math.radians(self.beyond_deg)), math.nan, 1.0) * np.ones(3)


@pytest.mark.parametrize("roughness", [0.002, 0.003, 0.005, 0.01, 0.02, 0.05])
@pytest.mark.parametrize("ior", [1.45, 1.53, 1.65])
def test_the_integral_agrees_with_the_standard_formula(ior: float, roughness: float) -> None:
    """A microfacet lobe, integrated over the receptor, against Fresnel times the error functions."""
    coat = CoatLobe(ior, roughness)
    for angle, tolerance in ((20, 0.02), (60, 0.1), (85, 0.6)):
        assert gloss_reading(coat, angle) == pytest.approx(gloss_units(angle, ior, roughness), abs=tolerance)


@pytest.mark.parametrize("angle", [20, 60, 85])
@pytest.mark.parametrize("name", ["table1_polaris_silver", "satin_blue", "fine_silver"])
def test_gloss_is_that_of_the_standards_apertures(name: str, angle: int) -> None:
    """Against an integration that takes the source direction by direction."""
    reflectance = load_material(name).reflectance
    assert gloss_reading(reflectance, angle) == pytest.approx(aperture_gloss(reflectance, angle, 4), abs=0.05)


def test_the_source_image_is_a_rectangle() -> None:
    """Polaris Silver's 20° reading by an independent check of the apertures, which a blurred source misses by .7."""
    assert gloss_reading(load_material("table1_polaris_silver").reflectance, 20) == pytest.approx(
        50.49, abs=0.01
    )


def test_a_diffuser_by_hand() -> None:
    """ρ/π · cosθ · receptor / black glass, the receptor being 1.8° by 3.6° at 20° and 4.4° by 11.7° at 60°."""
    for angle, size in ((20, 1.8 * 3.6), (60, 4.4 * 11.7)):
        receptor = size * math.radians(1.0) ** 2
        expected = 100.0 * 0.5 / math.pi * math.cos(math.radians(angle)) * receptor / black_glass(angle)
        # Source and receptor convolved have the receptor's area; cosines vary by .35 % over the wide one.
        assert gloss_reading(Diffuser(0.5), angle) == pytest.approx(expected, rel=0.005)
    report = measure(Diffuser(0.18))
    for reading in report.readings:
        # 116 · .18^⅓ - 16.
        assert reading.lab == pytest.approx((116.0 * 0.18 ** (1 / 3) - 16.0, 0.0, 0.0), abs=1e-9)
        assert reading.factor == pytest.approx(0.18)
        assert reading.xyz[1] == pytest.approx(18.0)
    assert report.flop is not None
    assert report.flop.value == 0.0
    assert report.travel is not None
    assert report.travel.length == pytest.approx(0.0, abs=1e-9)


@settings(max_examples=settings.default.max_examples // 2)
@given(
    st.floats(0.0, 2.0),
    st.floats(0.0, 80.0),
    st.floats(-5.0, 150.0),
    st.floats(0.0, 6.0),
    st.floats(0.0, 6.0),
)
def test_a_diffuser_reads_the_same_everywhere(
    rho: float, light: float, angle: float, light_half: float, receptor_half: float
) -> None:
    if abs(light - angle) >= 89.0:
        return
    instrument = Aperture("any", light_half, receptor_half)
    report = measure(Diffuser(rho), geometry_set(f"{light:.3f}:{angle:.3f}"), instrument)
    assert report.readings[0].factor == pytest.approx(rho, abs=1e-9)


@pytest.mark.parametrize("name", paint_names())
def test_a_designed_paint_reads_its_own_gloss(name: str) -> None:
    paint = load_shipped_paint(name)
    report = measure(build_paint(paint), GEOMETRY_SETS["e2194"])
    assert report.gloss[20] == pytest.approx(paint.gloss.gu_20, abs=0.5)
    if paint.gloss.gu_60 is not None:
        assert report.gloss[60] == pytest.approx(paint.gloss.gu_60, abs=0.5)
    assert report.haze == pytest.approx(report.gloss[60] - report.gloss[20])
    asked = np.array([m.lab for m in paint.measurements if m.illumination_deg == 45.0])
    np.testing.assert_allclose(report.lab, asked, atol=0.02)
    assert report.flop == flop_index(*report.lab[:, 0].tolist())


def test_two_readings_of_gloss_are_read_back() -> None:
    paint = replace(load_shipped_paint("blue"), gloss=Gloss(70.0, 94.0))
    report = measure(build_paint(paint), GEOMETRY_SETS["e2194"])
    assert (report.gloss[20], report.gloss[60]) == (
        pytest.approx(70.0, abs=0.5),
        pytest.approx(94.0, abs=0.5),
    )
    assert report.haze == pytest.approx(24.0, abs=0.7)


def test_what_is_not_read_is_not_reported() -> None:
    reflectance = build_paint(load_shipped_paint("blue"))
    few = measure(reflectance, geometry_set("45:25,45"))
    assert few.flop is None
    assert few.travel is None
    assert len(measure(reflectance, geometry_set("e2539")).readings) == 8
    # Travel is that of the 45° light alone: a second light does not lengthen the path.
    assert (
        measure(reflectance, geometry_set("six")).travel == measure(reflectance, geometry_set("e2539")).travel
    )


def test_notices() -> None:
    reflectance = build_paint(load_shipped_paint("red_metallic"))
    texts = " ".join(measure(reflectance).notices)
    assert "flop index is uncertain" in texts
    near = measure(reflectance, geometry_set("45:3"), WIDE)
    assert any("mirror direction" in notice for notice in near.notices)
    assert any("uncertain by" in notice for notice in near.notices)
    assert not any("mirror" in n for n in measure(reflectance, aperture=Aperture("", 2.0, 4.0)).notices)


def test_not_a_number_is_refused_by_name() -> None:
    with pytest.raises(FittingError, match="45as-15"):
        measure(Broken(50.0))
    with pytest.raises(FittingError, match="gloss angle"):
        measure(Broken(70.0), geometry_set("45:45"))


def test_readings_are_the_same_on_every_run() -> None:
    reflectance = build_paint(load_shipped_paint("copper"))
    first, second = (measure(reflectance, geometry_set("six"), WIDE) for _ in range(2))
    assert first == second


def grid_of_samples() -> ScatteredSamples:
    """A grey diffuser by a goniometer of 10° steps in the plane of incidence."""
    light, view = (
        one.ravel() for one in np.meshgrid(np.arange(0.0, 81.0, 10.0), np.arange(-80.0, 81.0, 10.0))
    )
    wi, wo = illumination(light), spherical(np.radians(view), 0.0)
    return ScatteredSamples(wi, wo, np.full((len(wi), 3), 0.1))


def test_readings_say_how_far_the_nearest_sample_is() -> None:
    up = spherical([0.0], 0.0)
    single = measure(ScatteredSamples(up, up, np.full((1, 3), 0.1)))
    assert not any(reading.supported for reading in single.readings)
    # Light at 45°, view at 30° on the other side: √(45² + 30²) for small angles.
    assert single.readings[1].sample_deg == pytest.approx(53.2, abs=2.0)
    assert [single.gloss_supported(angle) for angle in (20, 60, 85)] == [False] * 3
    notices = " ".join(single.notices)
    assert "No sample lies within 10° of the readings at -15° (nearest" in notices
    assert "No sample lies in the glossmeter's receptor at 20° (nearest" in notices

    grid = measure(grid_of_samples())
    assert all(reading.supported for reading in grid.readings)
    assert max(reading.sample_deg for reading in grid.readings) == pytest.approx(
        5.0 * math.sqrt(2.0), abs=0.1
    )
    assert [grid.gloss_supported(angle) for angle in (20, 60, 85)] == [True, True, False]

    model = measure(Diffuser(0.5))
    assert {reading.sample_deg for reading in model.readings} == {0.0}
    assert set(model.gloss_sample_deg.values()) == {0.0}
    assert not any("sample" in notice for notice in model.notices)
