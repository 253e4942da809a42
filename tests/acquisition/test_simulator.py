"""The simulated rig: its geometry, its light, its sensor, and that it shares no code with the reconstruction."""

from __future__ import annotations

import ast
import math
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import brdf_suite.acquisition
from brdf_suite.acquisition.session.session import Lens
from brdf_suite.acquisition.simulator import Simulator, SimulatorSettings
from brdf_suite.acquisition.simulator.optics import distort, first_hits, undistort
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.errors import ValueRangeError
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1

ALBEDO = 0.4
MATT = CookTorrance(CookTorrancePaint("matt", (ALBEDO, ALBEDO, ALBEDO)))
POLARIS = CookTorrance(TABLE_1["table1_polaris_silver"])
SMALL = SimulatorSettings(size=(48, 40), angles_deg=(0.0, 45.0, 90.0), exposures=4, distortion=0.0)


@pytest.fixture(scope="module")
def matt() -> Simulator:
    return Simulator(MATT, SMALL, "matt")


def _irradiance(rig: Simulator) -> np.ndarray:
    stated = rig.truth["irradiance_rgb"]
    return np.array(stated)


def test_a_matt_sphere_is_as_bright_as_the_inverse_square_says(matt: Simulator) -> None:
    # The point of the sphere that the lamp at 45° sees first: its distance is known, and its cosine is 1.
    settings = matt.settings
    angle = math.radians(45.0)
    normal = np.array([math.sin(angle), 0.0, math.cos(angle)])
    (pixel,) = matt.optics.project(settings.radius_m * normal[None])
    nearer = settings.light_distance_m / (settings.light_distance_m - settings.radius_m)
    expected = ALBEDO / math.pi * nearer**2 * _irradiance(matt)
    found = matt.radiance(1)[round(pixel[1]), round(pixel[0])]
    assert found == pytest.approx(expected, rel=5e-3)


def test_the_half_that_looks_away_from_the_lamp_is_dark(matt: Simulator) -> None:
    picture = matt.radiance(2)[20]  # the lamp at 90°, to the right
    seen = np.flatnonzero(picture[:, 1] > 0.0)
    # The lamp is near: the shadow's edge lies before the middle, at the cosine radius over distance.
    edge = matt.optics.project(_terminator(matt))[0, 0]
    assert abs(seen.min() - edge) <= 1.0
    assert seen.max() > 40


def _terminator(rig: Simulator) -> np.ndarray:
    radius, distance = rig.settings.radius_m, rig.settings.light_distance_m
    sine = radius / distance
    return radius * np.array([[sine, 0.0, math.sqrt(1.0 - sine * sine)]])


def test_the_outline_is_where_perspective_puts_it(matt: Simulator) -> None:
    settings = matt.settings
    tangent = math.asin(settings.radius_m / settings.camera_distance_m)
    angles = tangent + np.array([-1e-6, 1e-6])
    rays = np.stack([np.sin(angles), np.zeros(2), -np.cos(angles)], axis=-1)
    hits = first_hits(matt.optics.centre, rays, np.zeros(3), settings.radius_m)
    assert np.isfinite(hits[0])
    assert np.isnan(hits[1])
    # What a ray meets first is the near side.
    away = math.sqrt(settings.camera_distance_m**2 - settings.radius_m**2)
    assert hits[0] == pytest.approx(away, abs=1e-3)
    assert hits[0] < away


def test_the_highlight_is_where_the_mirror_puts_it() -> None:
    rig = Simulator(
        POLARIS, replace(SMALL, size=(160, 160), angles_deg=(70.0,), distortion=-0.004, noise=False)
    )
    radius, lamp, camera = rig.settings.radius_m, rig.lamp(0).place, rig.optics.centre
    angles = np.radians(np.linspace(0.0, 70.0, 70_001))
    normals = np.stack([np.sin(angles), np.zeros_like(angles), np.cos(angles)], axis=-1)
    to_lamp, to_camera = lamp - radius * normals, camera - radius * normals
    halves = to_lamp / np.linalg.norm(to_lamp, axis=1, keepdims=True)
    halves += to_camera / np.linalg.norm(to_camera, axis=1, keepdims=True)
    halves /= np.linalg.norm(halves, axis=1, keepdims=True)
    mirror = normals[np.argmax(np.einsum("ij,ij->i", halves, normals))]
    (expected,) = rig.optics.project(radius * mirror[None])
    picture = rig.radiance(0)[..., 1].astype(float)
    weights = np.where(picture > 0.25 * picture.max(), picture, 0.0)
    rows, columns = np.mgrid[0:160, 0:160]
    found = [(weights * part).sum() / weights.sum() for part in (columns, rows)]
    np.testing.assert_allclose(found, expected, atol=0.1)


@pytest.mark.parametrize("angle", [70.0, 160.0])
def test_a_peak_narrower_than_a_pixel_keeps_its_light(angle: float) -> None:
    # The same sphere in pictures of two sizes: the light in the peak is the same, however few pixels it falls into,
    # in the middle of the sphere and in the thin crescent of a lamp behind it.
    sums = []
    for side in (24, 192):
        bare = replace(SMALL, size=(side, side), angles_deg=(angle,), noise=False)
        rig = Simulator(POLARIS, bare)
        sums.append(float(rig.radiance(0)[..., 1].sum() / _irradiance(rig)[1]) / side**2)
    assert sums[0] == pytest.approx(sums[1], rel=0.005)


def test_the_lens_is_undone() -> None:
    lens = Lens(500.0, 500.0, 0.0, 0.0, -0.2, 0.05, 0.001, -0.002, 0.01)
    u, v = np.meshgrid(np.linspace(-0.4, 0.4, 9), np.linspace(-0.3, 0.3, 7))
    back = distort(lens, *undistort(lens, u, v))
    np.testing.assert_allclose(back, (u, v), atol=1e-9)


def test_codes_follow_the_curve_between_black_and_full_scale() -> None:
    rig = Simulator(MATT, replace(SMALL, noise=False, curve="linear", vignetting=0.0, bit_depth=16))
    codes, times = rig.position(1).astype(float), rig.session.exposures_s
    black, white = 1024, 65_535
    assert codes.min() == black
    assert codes.max() <= white
    radiance = rig.radiance(1)
    for k, seconds in enumerate(times):
        expected = np.minimum(radiance * seconds, 1.0 / (2.0 * (2**15 - black) / (white - black)) * 1.0)
        exposure = 0.5 * (codes[k] - black) / (2**15 - black)
        np.testing.assert_allclose(np.minimum(exposure, expected.max()), expected, atol=2e-5)


def test_noise_is_that_of_electrons_and_of_reading() -> None:
    settings = replace(
        SMALL, size=(200, 200), curve="linear", gain_spread=0.0, dark_current=0.0, vignetting=0.0
    )
    rig = Simulator(MATT, settings)
    rate = np.full((200, 200, 3), 0.25, np.float32)
    (codes,) = rig.sensor.expose(rate, (1.0,), 1)
    electrons = (codes.astype(float) - rig.sensor.black) / (4095 - rig.sensor.black) * settings.full_well
    expected = 0.25 * settings.full_well
    step = settings.full_well / (4095 - rig.sensor.black)
    variance = expected + settings.read_noise**2 + step * step / 12.0
    count = electrons.size
    assert electrons.mean() == pytest.approx(expected, abs=5.0 * math.sqrt(variance / count))
    assert electrons.var() == pytest.approx(variance, rel=5.0 * math.sqrt(2.0 / count))
    # Few electrons are Poisson's: as many as expected, and their variance is their mean.
    bare = replace(rig.sensor, settings=replace(settings, read_noise=0.0, bit_depth=16))
    (codes,) = bare.expose(np.full_like(rate, 4.0 / settings.full_well), (1.0,), 2)
    counts = np.round((codes.astype(float) - bare.black) / (65_535 - bare.black) * settings.full_well)
    assert counts.mean() == pytest.approx(4.0, abs=5.0 * math.sqrt(4.0 / count))
    assert counts.var() == pytest.approx(4.0, rel=5.0 * math.sqrt(2.25 / count))


def test_photographs_are_the_same_again_and_each_has_its_own_noise() -> None:
    rig, again = (Simulator(MATT, SMALL) for _ in range(2))
    np.testing.assert_array_equal(rig.position(1), again.position(1))
    assert not np.array_equal(rig.dark()[0], rig.dark()[1])
    assert not np.array_equal(rig.dark(), Simulator(MATT, replace(SMALL, seed=1)).dark())


def test_what_is_out_of_line_is_in_the_truth_and_not_in_the_session() -> None:
    off = replace(SMALL, light_offset_deg=0.5, centre_offset_px=(2.0, 0.0), moved=(2, 0.0, 3.0))
    rig, aligned = Simulator(MATT, off), Simulator(MATT, SMALL)
    assert rig.session == aligned.session
    lamps, centres = np.array(rig.truth["lamps_m"]), np.array(rig.truth["sphere_centres_m"])
    assert math.degrees(math.atan2(lamps[0, 0], lamps[0, 2])) == pytest.approx(0.5)
    shift = np.array(
        [rig.optics.project(c[None])[0] - rig.optics.project(np.zeros((1, 3)))[0] for c in centres]
    )
    np.testing.assert_allclose(shift, [[2.0, 0.0], [2.0, 0.0], [2.0, 3.0]], atol=1e-6)


def test_the_white_tile_gives_the_irradiance(matt: Simulator) -> None:
    white = matt.session.white
    assert white is not None
    left, top, width, height = white.region
    codes = matt.white()[:, top : top + height, left : left + width].astype(float)
    table = matt.truth["response"]
    assert isinstance(table, dict)
    k = int(np.argmax(codes[..., 1].mean(axis=(1, 2)) > 1000))
    exposure = np.interp(codes[k, ..., 1].mean(), table["codes"][1], table["exposures"][1])
    cosine = math.cos(math.radians(white.angle_deg))
    expected = 0.99 / math.pi * cosine * _irradiance(matt)[1] * matt.session.exposures_s[k]
    assert exposure == pytest.approx(expected, rel=0.01)


def test_the_arm_hides_the_sphere_and_the_coat_mirrors_the_table() -> None:
    rig = Simulator(MATT, replace(SMALL, arm=True))
    bare = Simulator(MATT, SMALL)
    middle = rig.optics.project(np.zeros((1, 3)))[0]
    row, column = round(middle[1]), round(middle[0])
    assert rig.radiance(0)[row, column, 1] == 0.0  # the housing stands before the middle
    assert rig.radiance(0)[row - 10, column, 1] > 0.0  # and nothing above it
    assert rig.radiance(1)[row + 12, column, 1] > bare.radiance(1)[row + 12, column, 1] * 0.9
    assert rig.session.light.housing_radius_m > 0.0


def test_the_stated_matrix_leads_back_to_the_working_space() -> None:
    blue = CookTorrance(TABLE_1["table1_blue"])
    plain, other = (Simulator(blue, replace(SMALL, colour_matrix=used)) for used in (False, True))
    matrix = np.array(other.session.camera.to_working)
    np.testing.assert_allclose(matrix.sum(axis=1), 1.0)
    expected = plain.radiance(1) / _irradiance(plain)
    found = (other.radiance(1) / _irradiance(other)) @ matrix.T
    np.testing.assert_allclose(found, expected, atol=1e-5 * expected.max())
    assert np.abs(other.radiance(1) / _irradiance(other) - expected).max() > 0.01 * expected.max()


def test_a_lamp_with_a_profile_falls_off_as_the_session_says() -> None:
    plain, narrow = (Simulator(MATT, replace(SMALL, size=(120, 120), profile=used)) for used in (False, True))
    lamp, centre = narrow.lamp(0).place, narrow.optics.centre
    ratio = (narrow.radiance(0) / _irradiance(narrow))[10:110, 60] / (plain.radiance(0) / _irradiance(plain))[
        10:110, 60
    ]
    rays = narrow.optics.rays(np.full(100, 60.0), np.arange(10.0, 110.0))
    points = centre + first_hits(centre, rays, np.zeros(3), narrow.settings.radius_m)[:, None] * rays
    off = np.degrees(
        np.arccos(
            np.clip(
                (lamp - points) @ lamp / np.linalg.norm(lamp - points, axis=1) / np.linalg.norm(lamp), -1, 1
            )
        )
    )
    lit = np.isfinite(ratio[:, 1])
    stated = np.array(narrow.session.light.profile)
    np.testing.assert_allclose(ratio[lit, 1], np.interp(off[lit], stated[:, 0], stated[:, 1]), rtol=2e-3)
    assert ratio[lit].min() < 0.97


def test_settings_out_of_range_are_named() -> None:
    with pytest.raises(ValueRangeError, match="bit_depth"):
        SimulatorSettings(bit_depth=20)
    with pytest.raises(ValueRangeError, match="longest_s"):
        SimulatorSettings(longest_s=1e-4)
    with pytest.raises(ValueRangeError, match="moved"):
        SimulatorSettings(positions=3, moved=(3, 1.0, 1.0))


def test_it_shares_no_code_with_the_reconstruction() -> None:
    asked = (
        "import sys, brdf_suite.acquisition.simulator, brdf_suite.acquisition.simulator.sensor\n"
        "print(*(m for m in sys.modules if m.startswith('brdf_suite.acquisition.')))"
    )
    found = subprocess.run([sys.executable, "-c", asked], check=True, capture_output=True, text=True).stdout
    inside = {name.removeprefix("brdf_suite.acquisition.") for name in found.split()}
    others = {name for name in inside if name.split(".")[0] != "simulator"}
    assert others == {"session", "session.session", "session.values", "session.store"}


def test_the_reconstruction_knows_no_simulator() -> None:
    room = Path(brdf_suite.acquisition.__file__).parent
    for file in set(room.rglob("*.py")) - set((room / "simulator").rglob("*.py")):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            if isinstance(node, ast.ImportFrom):
                names = [node.module or ""]
            assert not any("simulator" in name for name in names), file.name
