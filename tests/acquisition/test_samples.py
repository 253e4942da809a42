"""Readings of a simulated sphere against the paint that was put on it."""

from dataclasses import asdict, replace

import numpy as np
import pytest

from brdf_suite.acquisition.geometry.lens import lens_pixels
from brdf_suite.acquisition.geometry.sphere.placement import (
    RigGeometry,
    in_rig,
    nominal_geometry,
    unit,
)
from brdf_suite.acquisition.radiance.white_reference import irradiance_from_white, with_refined_white
from brdf_suite.acquisition.session.session import Session, WhiteReference
from brdf_suite.acquisition.simulator import Simulator, SimulatorSettings
from brdf_suite.acquisition.table.samples import PositionSamples, SphereSampler
from brdf_suite.arrays import triple
from brdf_suite.errors import AcquisitionError, ValueRangeError
from brdf_suite.geometry.directions import half_angle_coordinates
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1

_SIDE = 160
_PAINT = CookTorrance(TABLE_1["table1_polaris_silver"])
_ANGLES = (0.0, 40.0, 130.0)


def _simulated(**changes: object) -> Simulator:
    settings = SimulatorSettings(
        size=(_SIDE, _SIDE), angles_deg=_ANGLES, board=False, white=False, light_height_m=0.05
    )
    return Simulator(_PAINT, replace(settings, **changes))


@pytest.fixture(scope="module")
def rig() -> Simulator:
    return _simulated(profile=True)


@pytest.fixture(scope="module")
def geometry(rig: Simulator) -> RigGeometry:
    return nominal_geometry(rig.session, (_SIDE, _SIDE))


@pytest.fixture(scope="module")
def radiance(rig: Simulator) -> np.ndarray:
    return rig.radiance(1)


@pytest.fixture(scope="module")
def samples(geometry: RigGeometry, radiance: np.ndarray) -> PositionSamples:
    return SphereSampler(geometry).samples(1, radiance, np.full_like(radiance, 4.0))


def _errors(samples: PositionSamples) -> np.ndarray:
    truth = _PAINT.eval(samples.wi.astype(float), samples.wo.astype(float))
    errors: np.ndarray = samples.value / truth - 1.0
    return errors


def test_samples_are_the_paint_with_inverse_square_profile_and_cosine(
    samples: PositionSamples, geometry: RigGeometry
) -> None:
    assert geometry.profile
    errors = _errors(samples)
    assert len(samples) > 4000
    assert np.median(np.abs(errors)) < 2e-3
    # The peak is less than a pixel wide here; everywhere else every single sample is right.
    assert np.abs(errors[samples.half_angle[:, 0] > np.radians(3.0)]).max() < 0.02
    # Each part of the rig's light matters: none of them can be left out for this to hold.
    flat = SphereSampler(replace(geometry, profile=())).samples(1, _simulated(profile=True).radiance(1))
    assert np.median(np.abs(_errors(flat))) > 5e-3


def test_directions_are_unit_in_the_frame_of_the_normal(samples: PositionSamples) -> None:
    for directions in (samples.wi, samples.wo):
        np.testing.assert_allclose(np.linalg.norm(directions, axis=-1), 1.0, atol=1e-6)
        assert directions[:, 2].min() > np.cos(np.radians(80.0)) - 1e-3
    np.testing.assert_allclose(samples.wo[:, 1], 0.0, atol=1e-6)
    assert samples.wo[:, 0].min() > -1e-6


def test_half_angles_are_those_of_the_directions(samples: PositionSamples) -> None:
    theta_h, _, theta_d, phi_d = half_angle_coordinates(samples.wi, samples.wo)
    np.testing.assert_allclose(samples.half_angle[:, 0], theta_h, atol=1e-6)
    np.testing.assert_allclose(samples.half_angle[:, 1], theta_d, atol=1e-6)
    assert samples.half_angle[:, 2].min() >= 0.0
    assert samples.half_angle[:, 2].max() < np.pi + 1e-6
    clear = (theta_h > 0.02) & (theta_d > 0.02)
    turn = np.abs(samples.half_angle[clear, 2] - phi_d[clear] % np.pi)
    assert np.minimum(turn, np.pi - turn).max() < 1e-4


def test_variance_goes_as_the_square_of_the_scale(samples: PositionSamples, radiance: np.ndarray) -> None:
    row, column = np.divmod(samples.pixel, _SIDE)
    whole = samples.weight == 1.0
    scale = samples.value[whole] / radiance[row[whole], column[whole]]
    np.testing.assert_allclose(samples.variance[whole], 4.0 * scale**2, rtol=1e-4)


def test_pixels_near_the_peak_are_read_in_parts_that_keep_their_mean(
    samples: PositionSamples, geometry: RigGeometry, radiance: np.ndarray
) -> None:
    parts = samples.weight < 1.0
    assert np.count_nonzero(parts) >= 16 * 20
    assert set(np.unique(samples.weight).tolist()) == {1.0 / 16.0, 1.0}
    assert np.all(np.diff(samples.pixel) >= 0)
    numbers, counts = np.unique(samples.pixel[parts], return_counts=True)
    assert set(counts.tolist()) == {16}
    # A part's radiance is its value times what it receives; their mean is the pixel's.
    whole = SphereSampler(geometry, parts=1).samples(1, radiance)
    assert np.all(whole.weight == 1.0)
    one = np.searchsorted(whole.pixel, numbers)
    cosine = whole.value[one] * whole.wi[one, 2:]
    mean = (samples.value[parts] * samples.wi[parts, 2:]).reshape(-1, 16, 3).mean(axis=1)
    np.testing.assert_allclose(mean, cosine, rtol=2e-3)


def test_parts_are_nearer_to_a_narrow_peak_than_whole_pixels(
    samples: PositionSamples, geometry: RigGeometry, radiance: np.ndarray
) -> None:
    whole = SphereSampler(geometry, parts=1).samples(1, radiance)

    def bias(found: PositionSamples) -> float:
        near = found.half_angle[:, 0] < np.radians(0.9)
        error = _errors(found)[near, 1]
        return float(np.sqrt(np.average(error**2, weights=found.weight[near])))

    assert bias(samples) < 0.75 * bias(whole)


def test_the_upper_half_alone_and_no_masked_or_clipped_pixel(
    geometry: RigGeometry, radiance: np.ndarray
) -> None:
    sampler = SphereSampler(geometry)
    rows = np.nonzero(sampler.used)[0]
    assert rows.max() <= lens_pixels(geometry.lens, geometry.centre)[1]
    assert SphereSampler(geometry, upper_half=False).used.sum() > 1.9 * sampler.used.sum()
    mask = np.ones((_SIDE, _SIDE), bool)
    mask[:, 90:] = False
    assert SphereSampler(geometry, mask).samples(1, radiance).pixel.max() % _SIDE < 160
    assert np.all(SphereSampler(geometry, mask).samples(1, radiance).pixel % _SIDE < 90)
    good = np.ones((_SIDE, _SIDE), bool)
    good[40] = False
    assert not np.any(sampler.samples(1, radiance, good=good).pixel // _SIDE == 40)
    dark = radiance.copy()
    dark[50] = np.nan
    assert not np.any(sampler.samples(1, dark).pixel // _SIDE == 50)


def test_the_grazing_limit_holds_for_light_and_camera(geometry: RigGeometry, radiance: np.ndarray) -> None:
    found = SphereSampler(geometry, grazing_deg=60.0).samples(1, radiance)
    assert np.degrees(np.arccos(found.wi[:, 2].min())) < 60.5
    assert np.degrees(np.arccos(found.wo[:, 2].min())) < 60.5
    for limit in (0.0, 90.0):
        with pytest.raises(ValueRangeError, match="grazing_deg"):
            SphereSampler(geometry, grazing_deg=limit)


def test_the_box_alone_gives_the_same_samples(
    geometry: RigGeometry, radiance: np.ndarray, samples: PositionSamples
) -> None:
    sampler = SphereSampler(geometry)
    crop = sampler.samples(1, radiance[sampler.box], np.full_like(radiance, 4.0)[sampler.box])
    for name in ("wi", "wo", "value", "variance", "weight", "half_angle", "footprint", "pixel"):
        assert np.array_equal(getattr(crop, name), getattr(samples, name)), name
    with pytest.raises(ValueRangeError, match="radiance"):
        sampler.samples(1, radiance[:10])
    with pytest.raises(ValueRangeError, match="mask"):
        SphereSampler(geometry, np.ones((3, 3), bool))


def test_lamp_and_post_hide_what_is_behind_them(geometry: RigGeometry, radiance: np.ndarray) -> None:
    # In front of the camera, a lamp 0.35 m before the sphere hides a disc, and its post a band below it.
    hiding = replace(geometry, housing_radius_m=0.012, post_radius_m=0.003, light_height_m=0.02)
    free = set(SphereSampler(replace(geometry, light_height_m=0.02)).samples(0, radiance).pixel.tolist())
    left = set(SphereSampler(hiding).samples(0, radiance).pixel.tolist())
    lamp = hiding.light(0.0)
    x, y = lens_pixels(hiding.lens, lamp)
    radius = 0.012 / lamp[2] * hiding.lens.fx
    hidden = np.array(sorted(free - left))
    rows, columns = np.divmod(hidden, _SIDE)
    inside = np.hypot(columns - x, rows - y) < radius * 1.05
    below = (np.abs(columns - x) < 0.003 / lamp[2] * hiding.lens.fx * 1.1) & (rows > y)
    assert np.all(inside | below)
    assert np.count_nonzero(inside) > 0.8 * np.pi * radius**2 * 0.5
    assert np.count_nonzero(below & ~inside) > 10
    # Beyond the sphere it hides nothing.
    assert len(SphereSampler(replace(hiding, angles_deg=(180.0,))).samples(0, radiance)) == len(
        SphereSampler(replace(geometry, light_height_m=0.02, angles_deg=(180.0,))).samples(0, radiance)
    )


def test_the_footprint_is_the_range_of_the_half_angle(geometry: RigGeometry, radiance: np.ndarray) -> None:
    found = SphereSampler(geometry, parts=1).samples(1, radiance)
    theta = np.full((_SIDE, _SIDE), np.nan)
    theta.flat[found.pixel] = found.half_angle[:, 0]
    step = 0.5 * (
        np.abs(theta[1:-1, 2:] - theta[1:-1, :-2]) / 2.0 + np.abs(theta[2:, 1:-1] - theta[:-2, 1:-1]) / 2.0
    )
    footprint = np.full((_SIDE, _SIDE), np.nan)
    footprint.flat[found.pixel] = found.footprint
    both = np.isfinite(step) & np.isfinite(footprint[1:-1, 1:-1]) & (theta[1:-1, 1:-1] > 0.05)
    # The half vector turns a little within a pixel, since light and camera are near.
    ratio = step[both] / footprint[1:-1, 1:-1][both]
    assert 0.9 < np.median(ratio) < 1.15


def test_nothing_seen_gives_no_samples(geometry: RigGeometry, radiance: np.ndarray) -> None:
    behind = replace(geometry, angles_deg=(180.0,), light_height_m=0.0)
    assert len(SphereSampler(behind, grazing_deg=60.0).samples(0, radiance)) == 0
    away = replace(geometry, centre_m=triple(geometry.centre + np.array((3.0, 0.0, 0.0))))
    assert len(SphereSampler(away)) == 0
    assert len(SphereSampler(away).samples(1, radiance)) == 0


def test_the_white_reference_gives_the_irradiance() -> None:
    rig = _simulated(white=True, profile=True)
    session: Session = rig.session
    assert session.white is not None
    assert session.light.irradiance_rgb is None
    lamp = np.array(session.light_m(float(session.white.angle_deg)))
    expected = np.array(rig.truth["irradiance_rgb"])
    way = lamp - np.array(session.white.centre_m)
    cosine = unit(way) @ unit(session.white.normal)
    # The tile stands on the axis and sends back ρ E cosθ / π.
    seen = np.array(session.white.reflectance) * expected * cosine / np.pi
    seen *= (lamp @ lamp) / (way @ way)
    np.testing.assert_allclose(irradiance_from_white(session, seen), expected, rtol=1e-6)
    # A lamp that stands 3° further from the tile's normal lights it less: the lamp itself is then the brighter.
    geometry = replace(nominal_geometry(session, (_SIDE, _SIDE)), angle_offset_deg=3.0)
    turned_by = np.radians(session.white.angle_deg)
    brighter = np.cos(turned_by) / np.cos(turned_by + np.radians(3.0))
    ratio = irradiance_from_white(session, seen, geometry)[1] / expected[1]
    assert ratio == pytest.approx(brighter, rel=2e-3)
    refined = with_refined_white(session, replace(geometry, irradiance_rgb=triple(expected)))
    np.testing.assert_allclose(refined.irradiance_rgb, expected * ratio, rtol=1e-12)
    with pytest.raises(AcquisitionError, match="dark"):
        irradiance_from_white(session, (1.0, 0.0, 1.0))
    turned: WhiteReference = replace(session.white, normal=(0.0, 0.0, -1.0))
    with pytest.raises(AcquisitionError, match=r"white\.normal"):
        irradiance_from_white(replace(session, white=turned), seen)
    with pytest.raises(AcquisitionError, match="no white reference"):
        irradiance_from_white(replace(session, white=None), seen)


def test_a_geometry_of_a_session_stands_as_it_says() -> None:
    session = _simulated(camera_height_m=0.25, light_offset_deg=0.0).session
    geometry = nominal_geometry(session, (_SIDE, _SIDE))
    for k in range(len(_ANGLES)):
        place = geometry.light(geometry.angles_deg[k])
        np.testing.assert_allclose(in_rig(geometry, place), session.light_m(k), atol=1e-9)
    # The camera looks at the sphere from above: its own place in the rig.
    np.testing.assert_allclose(
        in_rig(geometry, np.zeros(3)), (0.0, 0.25, session.camera.distance_m), atol=1e-9
    )
    assert RigGeometry.from_json(asdict(geometry)) == geometry
