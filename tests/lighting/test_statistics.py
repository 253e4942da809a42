"""Figures of environments whose figures are known."""

from pathlib import Path

import numpy as np
import pytest

from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.latlong import angles, column_angles, direction, ring_angles
from brdf_suite.lighting.statistics import environment_statistics
from brdf_suite.pipeline.environments import read_environment


def environment(values: np.ndarray) -> Environment:
    return Environment("test", np.repeat(values[..., None], 3, axis=2).astype(np.float32))


def test_white_light() -> None:
    figures = environment_statistics(environment(np.full((64, 128), 2.0)))
    assert figures.average_radiance == pytest.approx((2.0, 2.0, 2.0), rel=1e-6)
    assert figures.average_luminance == pytest.approx(2.0, rel=1e-6)
    assert figures.horizontal_illuminance == pytest.approx(2.0 * np.pi, rel=1e-3)
    assert figures.vertical_illuminance == pytest.approx([2.0 * np.pi] * 4, rel=1e-3)
    assert figures.dynamic_range_stops == pytest.approx(0.0, abs=1e-6)
    assert (figures.sun_direction, figures.sun_share) == (None, 0.0)
    assert figures.histogram.lowest_stop == 1.0
    assert figures.histogram.shares == pytest.approx([1.0])


def test_light_from_above_only() -> None:
    values = np.zeros((256, 512))
    values[:128] = 1.0
    figures = environment_statistics(environment(values))
    assert figures.horizontal_illuminance == pytest.approx(np.pi, rel=1e-4)
    assert figures.vertical_illuminance == pytest.approx([np.pi / 2] * 4, rel=1e-3)
    assert figures.average_luminance == pytest.approx(0.5, rel=1e-4)
    assert figures.histogram.black == pytest.approx(0.5, abs=1e-4)
    assert figures.dynamic_range_stops is None


@pytest.mark.parametrize(("elevation", "azimuth"), [(50.0, 30.0), (5.0, 200.0), (-20.0, 300.0), (88.0, 90.0)])
def test_the_sun_is_found(elevation: float, azimuth: float) -> None:
    e, a = np.radians([elevation, azimuth])
    sun = np.array([np.cos(e) * np.sin(a), np.sin(e), np.cos(e) * np.cos(a)])
    there = direction(ring_angles(256)[:, None], column_angles(512)[None, :])
    values = 1.0 + 1e4 * (there @ sun > np.cos(np.radians(1.5)))
    figures = environment_statistics(environment(values))
    assert np.degrees(np.arccos(np.clip(np.dot(figures.sun_direction, sun), -1, 1))) < 0.4
    assert figures.sun_elevation_deg == pytest.approx(elevation, abs=0.4)
    flux = 1e4 * 2 * np.pi * (1 - np.cos(np.radians(1.5)))
    assert figures.sun_share == pytest.approx(flux / (flux + 4 * np.pi), rel=0.1)
    assert figures.dynamic_range_stops == pytest.approx(np.log2(1e4 + 1), abs=1e-3)


def test_azimuth_follows_the_rotation_of_the_light() -> None:
    # A positive rotation turns the light counter-clockwise seen from above: from +z towards +x.
    theta, phi = angles(np.array([[1.0, 0.2, 0.0]]))
    values = np.ones((64, 128))
    values[int(theta[0] / np.pi * 64), int((phi[0] + np.pi) / (2 * np.pi) * 128)] = 1e3
    assert environment_statistics(environment(values)).sun_azimuth_deg == pytest.approx(90.0, abs=3.0)


def test_black_has_no_figures_that_lie() -> None:
    figures = environment_statistics(environment(np.zeros((8, 16))))
    assert figures.brightest_luminance == 0.0
    assert figures.sun_direction is None
    assert (figures.histogram.shares, figures.histogram.black) == ((), 1.0)


def test_real_environments(shared_data: Path) -> None:
    for file in sorted((shared_data / "environments").iterdir()):
        loaded = read_environment(file)
        figures = environment_statistics(loaded)
        assert sum(figures.histogram.shares) + figures.histogram.black == pytest.approx(1.0, abs=1e-9)
        # The mean over all normals of the irradiance is π times the average: four sides, up and down come near.
        assert figures.horizontal_illuminance > 0.0
        assert 0.0 <= figures.sun_share <= 1.0
        assert figures.average_luminance <= figures.brightest_luminance
