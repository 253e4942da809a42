"""Figures of an environment: brightness, unevenness, and the direction of its main light."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import WORKING_TO_XYZ
from brdf_suite.arrays import triple
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.latlong import column_angles, direction, fejer_weights, ring_angles

HISTOGRAM_STOPS = 1.0
_MOST_STOPS = 40
# What counts as the sun, or a lamp: all that is at least so bright beside the brightest texel, this near to it.
_SUN_SHARE = 0.25
_SUN_RADIUS_RAD = np.deg2rad(3.0)
_FLOOR_PERCENTILE = 1.0
_ENOUGH_TEXELS = 2_000_000


@dataclass(frozen=True)
class Histogram:
    """Share of the sphere (sums to 1 with ``black``) by luminance in steps of one stop.

    ``lowest_stop`` is log2 of the lower edge of the first step; ``shares`` (n,) the share of each; ``black`` what
    gives no light, or lies more than forty stops below the brightest.
    """

    lowest_stop: float
    shares: tuple[float, ...]
    black: float


@dataclass(frozen=True)
class EnvironmentStatistics:
    """Figures of one environment; radiances in the file's own units, colours linear Rec. 2020.

    Attributes
    ----------
    average_radiance
        (3,) mean over the sphere.
    average_luminance
        Its luminance.
    horizontal_illuminance
        π times the diffuse map's value for a normal straight up, luminance: ``∫ L cosθ dω`` over the upper half.
    vertical_illuminance
        The same for normals towards +z, -x, -z, +x, in this order.
    brightest_luminance
        Of a texel.
    dynamic_range_stops
        log2 of the brightest over the luminance that 1 % of the sphere is below; ``None`` where that is black.
    sun_direction
        Unit vector (x, y, z), y up, of the brightest texel's lamp: the mean of what is near it and a quarter as
        bright; ``None`` for an even or black environment.
    sun_elevation_deg, sun_azimuth_deg
        The same as angles; the azimuth grows counter-clockwise seen from above, 0 along +z.
    sun_share
        Share of the sphere's whole flux that comes from within 3° of it.
    histogram
        Luminance over the sphere.
    """

    average_radiance: tuple[float, float, float]
    average_luminance: float
    horizontal_illuminance: float
    vertical_illuminance: tuple[float, float, float, float]
    brightest_luminance: float
    dynamic_range_stops: float | None
    sun_direction: tuple[float, float, float] | None
    sun_elevation_deg: float | None
    sun_azimuth_deg: float | None
    sun_share: float
    histogram: Histogram


def environment_statistics(environment: Environment) -> EnvironmentStatistics:
    """Return the figures of an environment.

    Integrals use the weights of Fejér's rule over the rings, as the prefilter does, so that the average is the
    diffuse map's mean to the last digit.

    >>> white = Environment("white", np.ones((64, 128, 3), np.float32))
    >>> round(environment_statistics(white).horizontal_illuminance, 3)
    3.142
    """
    radiance = environment.radiance
    rows, columns = radiance.shape[:2]
    theta, phi = ring_angles(rows), column_angles(columns)
    solid_angle = fejer_weights(rows) * (2.0 * np.pi / columns)
    luminance = radiance @ WORKING_TO_XYZ[1].astype(np.float32)
    average = environment.average()
    by_row = luminance.mean(axis=1, dtype=np.float64) * columns * solid_angle
    up = float((by_row * np.clip(np.cos(theta), 0.0, None)).sum())
    sideways = luminance.astype(np.float64) * (np.sin(theta) * solid_angle)[:, None]
    by_column = sideways.sum(axis=0)
    towards = [float((by_column * np.clip(np.cos(phi - turn), 0.0, None)).sum()) for turn in _TURNS]
    brightest = float(luminance.max())
    flux = float(by_row.sum())
    sun, share = _sun(luminance, theta, phi, solid_angle, flux)
    return EnvironmentStatistics(
        average_radiance=triple(average),
        average_luminance=flux / (4.0 * np.pi),
        horizontal_illuminance=up,
        vertical_illuminance=(towards[0], towards[1], towards[2], towards[3]),
        brightest_luminance=brightest,
        dynamic_range_stops=_range(luminance, solid_angle, brightest),
        sun_direction=None if sun is None else triple(sun),
        sun_elevation_deg=None if sun is None else float(np.degrees(np.arcsin(np.clip(sun[1], -1.0, 1.0)))),
        sun_azimuth_deg=None if sun is None else float(np.degrees(np.arctan2(sun[0], sun[2])) % 360.0),
        sun_share=share,
        histogram=_histogram(luminance, solid_angle, brightest),
    )


# Longitudes of +z, -x, -z, +x.
_TURNS = (0.0, 0.5 * np.pi, np.pi, -0.5 * np.pi)


def _sun(
    luminance: NDArray[np.float32],
    theta: NDArray[np.float64],
    phi: NDArray[np.float64],
    solid_angle: NDArray[np.float64],
    flux: float,
) -> tuple[NDArray[np.float64] | None, float]:
    """Return the direction of the brightest lamp and its share of the flux; none where all is even or black."""
    brightest = float(luminance.max())
    if flux <= 0.0 or brightest <= 1.5 * flux / (4.0 * np.pi):
        return None, 0.0
    row, column = np.unravel_index(int(luminance.argmax()), luminance.shape)
    peak = direction(theta[row], phi[column])
    near_rows = np.abs(theta - theta[row]) <= _SUN_RADIUS_RAD + theta[0]
    there = direction(theta[near_rows, None], phi[None, :])
    values = luminance[near_rows] * solid_angle[near_rows, None]
    near = there @ peak >= np.cos(max(_SUN_RADIUS_RAD, 1.5 * float(theta[0])))
    bright = near & (luminance[near_rows] >= _SUN_SHARE * brightest)
    mean = (there[bright] * values[bright][:, None]).sum(axis=0)
    return mean / np.linalg.norm(mean), float(values[near].sum() / flux)


def _range(
    luminance: NDArray[np.float32], solid_angle: NDArray[np.float64], brightest: float
) -> float | None:
    # Sorting 33 million texels of an 8k map takes seconds; each second or fourth row and column suffices.
    step = max(1, round((luminance.size / _ENOUGH_TEXELS) ** 0.5))
    luminance, solid_angle = luminance[::step, ::step], solid_angle[::step]
    order = np.argsort(luminance, axis=None)
    weights = np.broadcast_to(solid_angle[:, None], luminance.shape).ravel()[order]
    below = np.searchsorted(np.cumsum(weights), _FLOOR_PERCENTILE / 100.0 * weights.sum())
    floor = float(luminance.ravel()[order[below]])
    return float(np.log2(brightest / floor)) if floor > 0.0 else None


def _histogram(
    luminance: NDArray[np.float32], solid_angle: NDArray[np.float64], brightest: float
) -> Histogram:
    weights = np.broadcast_to(solid_angle[:, None] / (4.0 * np.pi), luminance.shape)
    if brightest <= 0.0:
        return Histogram(0.0, (), 1.0)
    top = int(np.floor(np.log2(brightest)))
    counted = luminance > 2.0 ** (top + 1 - _MOST_STOPS)
    stops = np.floor(np.log2(luminance[counted].astype(np.float64))).astype(np.int64)
    low = int(stops.min())
    shares = np.bincount(stops - low, weights=weights[counted], minlength=top - low + 1)
    return Histogram(
        low * HISTOGRAM_STOPS, tuple(float(s) for s in shares), float(max(0.0, 1.0 - shares.sum()))
    )
