"""The texture instrument: its pictures against their expectation and a mosaic drawn place by place, and its inverse."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter
from scipy.spatial import cKDTree

from brdf_suite.appearance.flakes.visible import full_density
from brdf_suite.appearance.texture import (
    NO_TEXTURE,
    VISIBLE_CONTRAST,
    Grain,
    PaintLight,
    Speckle,
)
from brdf_suite.documents.paint import Flakes
from brdf_suite.errors import ValueRangeError
from brdf_suite.inspection.texture.camera import (
    grain_picture,
    measure_texture,
    read_sparkle,
    sparkle_picture,
)
from brdf_suite.inspection.texture.expectation import (
    expected_contrast,
    expected_graininess,
    expected_scales,
    expected_sparkle,
)
from brdf_suite.inspection.texture.inverse import find_flakes
from brdf_suite.inspection.texture.readings import paint_light, texture_of
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_material
from brdf_suite.reflectance.registry import MODELS


def light_of(name: str) -> PaintLight:
    return paint_light(fit_material(load_material(name)).weights)


@pytest.fixture(scope="module")
def blue() -> PaintLight:
    return light_of("blue")


def mean_sparkle(seen: Speckle, seeds: int = 3) -> np.ndarray:
    rows = []
    for seed in range(seeds):
        found = read_sparkle(sparkle_picture(seen, np.random.default_rng(seed)), seen.share, 45.0)
        rows.append((found.area, found.grade))
    return np.mean(rows, axis=0)


@pytest.mark.parametrize("per_mm2", [0.3, 3.0, 30.0, 300.0])
def test_pictures_have_the_expected_area_grade_and_variance(per_mm2: float) -> None:
    seen = Speckle(0.6, per_mm2, 0.065)
    assert mean_sparkle(seen) == pytest.approx(np.array(expected_sparkle(seen)), rel=0.05)
    picture = sparkle_picture(seen, np.random.default_rng(9))
    assert picture.mean() == pytest.approx(1.0, abs=0.03)
    assert seen.share * picture.std() == pytest.approx(expected_contrast(seen), rel=0.05)


def test_a_rare_flake_is_a_point_of_its_own_brightness() -> None:
    """Where images do not meet, points follow from one flake: the oracle of their density and mean contrast."""
    seen = Speckle(0.4, 0.2, 0.065)
    rng = np.random.default_rng(3)
    light = rng.gamma(1 / 0.152, 0.152, 400_000) * 2.5 * rng.uniform(size=400_000) ** 1.5
    light *= 3.0 * rng.uniform(size=400_000) ** 2
    peak = seen.share * (light / (seen.per_mm2 * 2.0 * math.pi * seen.spread_mm**2) - 1.0)
    bright = peak >= VISIBLE_CONTRAST
    found = read_sparkle(sparkle_picture(seen, rng), seen.share, 45.0)
    assert found.points_per_mm2 == pytest.approx(seen.per_mm2 * bright.mean(), rel=0.05)
    # The brightest pixel lies up to half of one beside the flake.
    assert found.intensity == pytest.approx(peak[bright].mean() * 0.91, rel=0.08)


@pytest.mark.parametrize(("size_um", "coverage"), [(20.0, 1.0), (40.0, 1.0), (40.0, 0.2)])
def test_grain_is_that_of_a_mosaic_drawn_place_by_place(size_um: float, coverage: float) -> None:
    """Cells of one flake's area, a flake somewhere in each; a place shows the nearest, if it is there."""
    rng = np.random.default_rng(5)
    spread = 0.0636
    cell = 1.0 / math.sqrt(full_density(size_um))
    count, fine = round(9.0 / cell), 4
    at = (np.indices((count, count)).reshape(2, -1).T + rng.uniform(size=(count**2, 2))) * fine
    side = count * fine
    places = np.indices((side, side)).reshape(2, -1).T + 0.5
    nearest = cKDTree(at, boxsize=side).query(places)[1]
    light = 2.5 * rng.uniform(size=count**2) ** 1.5 * (rng.uniform(size=count**2) < coverage) / coverage
    drawn = gaussian_filter(light[nearest].reshape(side, side), spread / cell * fine, mode="wrap")
    seen = Grain(1.0, full_density(size_um), coverage, math.hypot(spread, 0.25e-3 * size_um))
    assert expected_graininess(seen) == pytest.approx(drawn.std() / drawn.mean(), rel=0.12)
    picture = grain_picture(seen, rng)
    assert picture.std() / picture.mean() == pytest.approx(expected_graininess(seen), rel=0.04)


def test_one_seed_is_one_picture_and_none_without_flakes(blue: PaintLight) -> None:
    flakes = Flakes()
    assert measure_texture(blue, flakes, 3) == measure_texture(blue, flakes, 3)
    assert measure_texture(blue, flakes, 3) != measure_texture(blue, flakes, 4)
    assert measure_texture(blue, None) == measure_texture(blue, Flakes(0.0)) == NO_TEXTURE
    assert texture_of(load_material("solid_red")) == NO_TEXTURE


def test_coarser_flakes_sparkle_more_and_denser_ones_in_more_places(blue: PaintLight) -> None:
    fine, coarse = (measure_texture(blue, Flakes(full_density(size), size, 0.16)) for size in (12.0, 36.0))
    assert coarse.graininess > 2.0 * fine.graininess
    for one, other in zip(fine.sparkle, coarse.sparkle, strict=True):
        assert other.intensity > one.intensity
        assert other.grade > one.grade
    few, many = (measure_texture(blue, Flakes(density, 15.0, 0.16)) for density in (50.0, 400.0))
    for one, other in zip(few.sparkle, many.sparkle, strict=True):
        assert other.points_per_mm2 > one.points_per_mm2
        assert other.area > one.area


@pytest.mark.parametrize(
    "flakes",
    [Flakes(1e5, 0.1, 0.17), Flakes(0.01, 2000.0, 0.001), Flakes(10.0, 500.0, 1.0), Flakes(1e5, 2000.0, 0.2)],
)
def test_any_flakes_have_finite_readings(flakes: Flakes, blue: PaintLight) -> None:
    found = measure_texture(blue, flakes)
    assert np.isfinite(found.scales()).all()
    assert all(0.0 <= one.area <= 1.0 and one.intensity >= 0.0 for one in found.sparkle)
    assert np.isfinite(expected_scales(blue, flakes)).all()


@pytest.mark.parametrize("name", ["fine_silver", "blue"])
def test_flakes_are_found_by_their_readings(name: str) -> None:
    light = light_of(name)
    wanted = expected_scales(light, Flakes(1500.0, 22.0, 0.165))
    found = find_flakes(light, wanted.tolist())
    assert found.reached
    assert found.sentence() == ""
    assert measure_texture(light, found.flakes).scales() == pytest.approx(wanted, rel=0.06)
    kept = find_flakes(light, [None, float(wanted[1]), None, None], Flakes(1500.0, 22.0, 0.165, 0.3))
    assert kept.flakes.colour_spread == 0.3
    assert kept.flakes.size_um == pytest.approx(22.0, rel=0.05), "others would do as well, but farther away"


@pytest.mark.parametrize(
    "flakes", [Flakes(0.005, 50.0, 0.17), Flakes(20.0, 900.0, 0.17), Flakes(0.0001, 2000.0, 0.17)]
)
def test_sparse_and_huge_flakes_have_readings(flakes: Flakes, blue: PaintLight) -> None:
    for seed in range(3):
        assert np.isfinite(measure_texture(blue, flakes, seed).scales()).all()


def test_what_no_flakes_have_is_said_with_the_nearest(blue: PaintLight) -> None:
    """Strong grain and no sparkle at all."""
    found = find_flakes(blue, [0.0, 0.0, 0.0, 0.2])
    assert not found.reached
    assert "Not reachable" in found.sentence()
    assert "graininess: nearest" in found.sentence()


@pytest.mark.parametrize("wanted", [[], [None] * 4, [0.1, -0.1, None, None], [math.nan, None, None, None]])
def test_wanted_readings_are_checked(wanted: list[float | None], blue: PaintLight) -> None:
    with pytest.raises(ValueRangeError):
        find_flakes(blue, wanted)


@pytest.mark.parametrize("name", sorted(MODELS))
def test_every_model_can_carry_flakes(name: str) -> None:
    material = load_material(name)
    assert texture_of(material) == NO_TEXTURE
    found = texture_of(replace(material, flakes=Flakes(1000.0, 30.0, 0.17)))
    assert np.isfinite(found.scales()).all()
    # The model of a coat alone has no base whose light flakes could send.
    assert found == NO_TEXTURE if name == "coat" else 0.0 < found.graininess < 1.0
