"""Directional lights: they keep all the light, find the sun, turn with the map, and approach it with their number."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.errors import ValueRangeError
from brdf_suite.files.images.environments import write_exr
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.latlong import column_angles, direction, ring_angles
from brdf_suite.lighting.lights import METHODS, DirectionalLights, directional_lights
from brdf_suite.lighting.lights.cells import sum_cells
from brdf_suite.lighting.lights.extract import lights_from_labels
from brdf_suite.lighting.lights.structured import farthest_points
from brdf_suite.lighting.procedural.sun import Sun, add_disc
from brdf_suite.pipeline.environments import read_environment
from brdf_suite.pipeline.scene import environment_names, find_environment

every_method = pytest.mark.parametrize("method", METHODS)


def total(radiance: np.ndarray) -> np.ndarray:
    """∫L dω of a map whose texels are constant, by the solid angle between two parallels."""
    height, width = radiance.shape[:2]
    cosines = np.cos(np.linspace(0.0, np.pi, height + 1))
    rows = (cosines[:-1] - cosines[1:]) * (2.0 * np.pi / width)
    return np.einsum("h,hwk->k", rows, radiance.astype(np.float64))


def check(environment: Environment, lights: DirectionalLights, count: int) -> None:
    """What holds for any map and any method."""
    assert len(lights) == count
    whole = total(environment.radiance)
    np.testing.assert_allclose(lights.strengths.sum(axis=0), whole, rtol=1e-9, atol=1e-12 * whole.max())
    assert lights.solid_angles.sum() == pytest.approx(4.0 * np.pi, rel=1e-9)
    assert lights.solid_angles.min() > 0.0
    np.testing.assert_allclose(np.linalg.norm(lights.directions, axis=1), 1.0, atol=1e-12)
    assert (np.diff(lights.strengths @ LUMINANCE) <= 0.0).all()


@pytest.fixture(scope="module")
def yard() -> Environment:
    """A sky that brightens to one side, clouds without symmetry, a dark floor, a lamp over the seam."""
    rng = np.random.default_rng(8)
    towards = direction(ring_angles(128)[:, None], column_angles(256)[None, :])
    bright = np.where(towards[..., 1] > 0.0, 1.0 + 0.8 * (towards @ [0.5, 0.7, 0.5]), 0.0)
    pixels = bright[..., None] * [0.7, 0.9, 1.3]
    pixels *= 0.6 + 0.4 * np.repeat(np.repeat(rng.random((16, 32, 1)), 8, 0), 8, 1)
    pixels[40:46, 250:] += 60.0
    pixels[40:46, :7] += 60.0
    return Environment("yard", pixels.astype(np.float32))


@every_method
@pytest.mark.parametrize("count", [1, 2, 3, 16, 257, 1024])
def test_no_light_is_lost(yard: Environment, method: str, count: int) -> None:
    check(yard, directional_lights(yard, count, method), count)


@settings(max_examples=settings.default.max_examples // 2)
@given(
    st.integers(4, 14),
    st.integers(8, 30),
    st.integers(1, 300),
    st.sampled_from(sorted(METHODS)),
    st.sampled_from([0.0, 1.0, 30.0]),
    st.integers(0, 10_000),
)
def test_any_small_map(rows: int, columns: int, count: int, method: str, spread: float, seed: int) -> None:
    rng = np.random.default_rng(seed)
    radiance = np.exp(spread * rng.normal(size=(rows, columns, 3))) * (rng.random((rows, columns, 1)) < 0.7)
    environment = Environment("any", np.minimum(radiance, 1e30).astype(np.float32))
    check(environment, directional_lights(environment, count, method), min(count, rows * columns))


def test_real_maps(shared_data: Path) -> None:
    files = sorted((shared_data / "environments").glob("*.*r"))
    assert files
    for path in files:
        whole = read_environment(path).radiance
        step = -(-whole.shape[1] // 256)
        rows, columns = (size // step * step for size in whole.shape[:2])
        blocks = whole[:rows, :columns].reshape(rows // step, step, columns // step, step, 3)
        environment = Environment(path.stem, blocks.mean(axis=(1, 3)))  # so few texels decide the same
        for method in METHODS:
            check(environment, directional_lights(environment, 64, method), 64)


@every_method
def test_a_large_map_is_joined_without_loss(method: str) -> None:
    """4,100 columns do not divide evenly into cells; the sun of one texel keeps its direction."""
    pixels = np.ones((65, 4100, 3), dtype=np.float32)
    pixels[20, 1234] = 1e6
    environment = Environment("wide", pixels)
    lights = directional_lights(environment, 32, method)
    check(environment, lights, 32)
    towards = direction(ring_angles(65)[20], column_angles(4100)[1234])
    assert np.linalg.norm(lights.directions[0] - towards) < 2.0 * np.pi / 4100


@every_method
def test_the_sun_is_found_to_a_texel(method: str) -> None:
    sun = Sun(height_deg=33.0, azimuth_deg=-118.0)
    towards = direction(ring_angles(256)[:, None], column_angles(512)[None, :])
    sky = np.where(towards[..., 1:2] > 0.0, 3.0, 0.8) * [0.8, 1.0, 1.4]  # in kcd/m², with a grey ground
    environment = Environment("sun", add_disc(sky, sun).astype(np.float32))
    for count in (16, 64, 512):
        found = directional_lights(environment, count, method).directions[0]
        assert np.linalg.norm(found - sun.direction) < np.pi / 256, count


@pytest.mark.parametrize("method", ["structured", "median-cut"])
def test_few_lights_keep_the_sun_apart(method: str) -> None:
    """For flakes eight lights must do: the sun's cell is then its texel, and no sky dims its colour."""
    pixels = np.full((64, 128, 3), [0.5, 0.7, 1.0], dtype=np.float32)
    pixels[20, 90] = [30000.0, 28000.0, 20000.0]
    lights = directional_lights(Environment("sun", pixels), 8, method)
    np.testing.assert_allclose(lights.strengths[0] / lights.solid_angles[0], pixels[20, 90], rtol=1e-6)


@every_method
@pytest.mark.parametrize("shift", [1, 37, 200])
def test_a_turned_map_gives_the_same_lights_turned(yard: Environment, method: str, shift: int) -> None:
    turned = Environment("turned", np.roll(yard.radiance, shift, axis=1))
    for count in (5, 64):
        one, other = directional_lights(yard, count, method), directional_lights(turned, count, method)
        # Growing columns go from +z towards -x, which seen from above is clockwise.
        expected = one.turned(-2.0 * np.pi * shift / 256)
        np.testing.assert_allclose(expected.directions, other.directions, atol=1e-9)
        np.testing.assert_allclose(one.strengths, other.strengths, rtol=1e-9)


def test_turning_is_counter_clockwise_from_above() -> None:
    lights = DirectionalLights(np.array([[0.0, 0.0, 1.0]]), np.ones((1, 3)), np.array([1.0]))
    np.testing.assert_allclose(lights.turned(0.5 * np.pi).directions, [[1.0, 0.0, 0.0]], atol=1e-15)


@pytest.mark.parametrize(
    ("method", "unevenness"), [("median-cut", 1.25), ("relaxed", 1.6), ("structured", 2.6)]
)
@pytest.mark.parametrize("count", [16, 256])
def test_even_light_gives_even_lights(method: str, unevenness: float, count: int) -> None:
    lights = directional_lights(Environment("white", np.full((128, 256, 3), 2.0, np.float32)), count, method)
    assert lights.strengths.max() < unevenness * lights.strengths.min()
    np.testing.assert_allclose(lights.strengths, 2.0 * lights.solid_angles[:, None] * np.ones(3), rtol=1e-6)
    # Spread all over: from no direction is the nearest light farther than two cells' radii.
    rng = np.random.default_rng(3)
    asked = rng.normal(size=(500, 3))
    asked /= np.linalg.norm(asked, axis=1, keepdims=True)
    assert (asked @ lights.directions.T).max(axis=1).min() > np.cos(2.0 * 2.0 / np.sqrt(count))


@every_method
def test_the_error_falls_with_the_number_of_lights(yard: Environment, method: str) -> None:
    rng = np.random.default_rng(5)
    normals = rng.normal(size=(60, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    towards = direction(ring_angles(128)[:, None], column_angles(256)[None, :]).reshape(-1, 3)
    cosines = np.diff(-np.cos(np.linspace(0.0, np.pi, 129))) * (2.0 * np.pi / 256)
    flux = yard.radiance.reshape(-1, 3) * np.repeat(cosines, 256)[:, None]
    truth = np.maximum(normals @ towards.T, 0.0) @ flux
    errors = [
        np.sqrt(np.mean((directional_lights(yard, count, method).irradiance(normals) - truth) ** 2))
        / truth.mean()
        for count in (4, 16, 64, 256, 1024)
    ]
    assert errors == sorted(errors, reverse=True)
    assert errors[2] < 0.02
    assert errors[4] < 0.001


def test_relaxed_errs_less_than_the_median_cut_that_it_starts_from() -> None:
    for name in environment_names():
        environment = read_environment(find_environment(name)[1])
        cells = sum_cells(environment.radiance, 256)
        towards = cells.centres().reshape(-1, 3)
        # What is lowered, as the share that is not explained: Σ Y·|ω - ω_light|² is least where Σ Y·ω·ω_light is most.
        explained = {}
        for method in ("median-cut", "relaxed"):
            lights = lights_from_labels(cells, METHODS[method](cells, 32)).turned(-cells.turn)
            nearest = (towards @ lights.directions.T).max(axis=1)
            explained[method] = float(nearest @ cells.luminous.ravel()) / float(cells.luminous.sum())
        assert 1.0 - explained["relaxed"] < 0.9 * (1.0 - explained["median-cut"]), name


@every_method
@pytest.mark.parametrize("count", [1, 16, 1024])
def test_black_maps_and_single_texels(method: str, count: int) -> None:
    black = np.zeros((32, 64, 3), dtype=np.float32)
    lights = directional_lights(Environment("black", black), count, method)
    check(Environment("black", black), lights, count)
    assert not lights.strengths.any()
    lit = black.copy()
    lit[0, 3] = [0.0, 0.0, 5.0]
    lights = directional_lights(Environment("lit", lit), count, method)
    check(Environment("lit", lit), lights, count)
    assert np.count_nonzero(lights.strengths[:, 2]) == 1
    towards = direction(ring_angles(32)[0], column_angles(64)[3])
    np.testing.assert_allclose(lights.directions[0], towards, atol=1e-9)


@every_method
def test_one_infinite_texel_is_repaired_on_reading(method: str, tmp_path: Path) -> None:
    pixels = np.ones((16, 32, 3), dtype=np.float32)
    pixels[4, 5] = np.inf
    path = tmp_path / "sun.exr"
    write_exr(path, pixels)
    environment = read_environment(path)
    lights = directional_lights(environment, 8, method)
    check(environment, lights, 8)
    assert any("infinite" in note for note in environment.notes)


def test_what_is_no_number_is_refused_by_name() -> None:
    pixels = np.ones((16, 32, 3), dtype=np.float32)
    pixels[2, 2, 1] = np.nan
    with pytest.raises(ValueRangeError, match="radiance"):
        directional_lights(Environment("nan", pixels), 8)


@pytest.mark.parametrize(
    ("count", "method", "named"), [(0, "relaxed", "count"), (1025, "relaxed", "1025"), (8, "x", "median-cut")]
)
def test_requests_out_of_range_are_refused(yard: Environment, count: int, method: str, named: str) -> None:
    with pytest.raises(ValueRangeError, match=named):
        directional_lights(yard, count, method)


def test_the_brightest_are_the_first(yard: Environment) -> None:
    lights = directional_lights(yard, 64)
    few = lights.brightest(8)
    assert len(few) == 8
    np.testing.assert_array_equal(few.directions, lights.directions[:8])
    assert (few.strengths @ LUMINANCE).min() >= (lights.strengths[8:] @ LUMINANCE).max()
    with pytest.raises(ValueRangeError, match="directions"):
        DirectionalLights(2.0 * few.directions, few.strengths, few.solid_angles)


def test_farthest_points_are_those_of_the_plain_method() -> None:
    """The look at nearby rows alone must change nothing."""
    rng = np.random.default_rng(12)
    towards = direction(ring_angles(40)[:, None], column_angles(80)[None, :]).reshape(-1, 3)
    towards = towards[np.sort(rng.choice(len(towards), 1500, replace=False))]
    owner, chosen = farthest_points(towards, 40, 7)
    plain = [7]
    for _ in range(39):
        apart = np.linalg.norm(towards[:, None] - towards[None, plain], axis=2).min(axis=1)
        plain.append(int(apart.argmax()))
    reached = [
        np.linalg.norm(towards[:, None] - towards[None, c], axis=2).min(axis=1).max() for c in (plain, chosen)
    ]
    assert reached[0] == pytest.approx(reached[1], rel=1e-5)
    apart = np.linalg.norm(towards[:, None] - towards[None, chosen], axis=2)
    np.testing.assert_allclose(apart[np.arange(1500), owner], apart.min(axis=1), atol=1e-6)
