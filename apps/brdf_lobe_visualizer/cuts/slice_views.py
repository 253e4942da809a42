"""The images of slices: θh and θd at one φd, and the hemisphere of views unrolled, for three incidences.

The target stands above, its fit below or beside it.
"""

from __future__ import annotations

import functools

import numpy as np
from brdf_qt.program.translation import tr
from PySide6.QtWidgets import QWidget

from brdf_lobe_visualizer.cuts.image_view import SliceImageView
from brdf_lobe_visualizer.cuts.images import Axes
from brdf_lobe_visualizer.subjects.subjects import SamplePoints
from brdf_lobe_visualizer.words import degrees
from brdf_suite.arrays import Floats
from brdf_suite.geometry.concentric import hemisphere_to_square
from brdf_suite.geometry.directions import angle_between, half_angle_coordinates, mirror
from brdf_suite.inspection.slices.cuts import light_at
from brdf_suite.inspection.slices.images import (
    Pairs,
    half_angle_pairs,
    share_of_theta_h,
    theta_h_at,
    unrolled_pairs,
    view_of,
)

SIZE = 112
NEAR_DEG = 2.5
"""Samples are shown where their light, or their φd, is so near to a picture's."""
_ROOT_TICKS = (0, 5, 15, 30, 60, 90)
_EVEN_TICKS = (0, 30, 60, 90)


@functools.lru_cache(maxsize=4)
def half_angle_pairs_of(phi_d_deg: float, phi_deg: float, by_root: bool, size: int = SIZE) -> Pairs:
    """Return the pairs of the picture, the same object for the same angles."""
    return half_angle_pairs(phi_d_deg, phi_deg, size, by_root=by_root)


def half_angle_axes(by_root: bool) -> Axes:
    """Return names and ticks of the axes."""
    ticks = _ROOT_TICKS if by_root else _EVEN_TICKS
    return Axes(
        x=tr("Half angle θh (°)"),
        y=tr("Difference angle θd (°)"),
        x_ticks=tuple(
            (float(share_of_theta_h(np.radians(angle), by_root=by_root)), str(angle)) for angle in ticks
        ),
        y_ticks=tuple((angle / 90.0, str(angle)) for angle in _EVEN_TICKS),
    )


def half_angle_places(phi_d_deg: float, phi_deg: float, by_root: bool, samples: SamplePoints) -> Floats:
    """Return shares (k, 2) of width and height at which samples lie that are near to the slice."""
    wi = np.concatenate((samples.wi, samples.wo))
    wo = np.concatenate((samples.wo, samples.wi))
    theta_h, phi_h, theta_d, phi_d = half_angle_coordinates(wi, wo)
    tipped = np.sin(theta_h) * np.sin(theta_d)
    near = np.abs(tipped * (np.cos(phi_d) - np.cos(np.radians(phi_d_deg)))) <= np.sin(np.radians(NEAR_DEG))
    if not samples.isotropic:
        facing = np.abs((np.degrees(phi_h) - phi_deg + 180.0) % 360.0 - 180.0)
        near &= facing * np.sin(theta_h) <= NEAR_DEG
    x = share_of_theta_h(theta_h[near], by_root=by_root)
    return np.stack((x, 1.0 - theta_d[near] / (0.5 * np.pi)), axis=-1)


class HalfAngleView(SliceImageView):
    """Shows the picture, and value and angles under the mouse."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("half_angle_view", tr("Half-angle slice: θh and θd"), parent)
        self._by_root = True
        self._phi_d_deg = 90.0

    def set_slice(self, phi_d_deg: float, by_root: bool) -> None:
        self._phi_d_deg, self._by_root = phi_d_deg, by_root

    def head_at(self, _column: int, x: float, y: float) -> str:
        theta_h = float(np.degrees(theta_h_at(x, by_root=self._by_root)))
        return f"{degrees('theta_h', theta_h)}  {degrees('theta_d', 90.0 * (1.0 - y))}  φd {self._phi_d_deg:.0f}°"


@functools.lru_cache(maxsize=12)
def unrolled_pairs_of(theta_deg: float, phi_deg: float, size: int = SIZE) -> Pairs:
    """Return the pairs of one picture, the same object for the same angles."""
    return unrolled_pairs(theta_deg, phi_deg, size)


def unrolled_places(
    incidences_deg: tuple[float, ...], phi_deg: float, samples: SamplePoints, column: int
) -> Floats:
    """Return shares (k, 2) of width and height at which samples lie whose light is near to a column's."""
    theta = incidences_deg[column]
    wi = np.concatenate((samples.wi, samples.wo))
    wo = np.concatenate((samples.wo, samples.wi))
    light = light_at(theta, phi_deg)
    if samples.isotropic:
        flat = np.hypot(wi[:, 0], wi[:, 1]) > 1e-9
        turn = np.radians(phi_deg) - np.where(flat, np.arctan2(-wi[:, 1], -wi[:, 0]), 0.0)
        cos, sin = np.cos(turn), np.sin(turn)
        wo = np.stack((cos * wo[:, 0] - sin * wo[:, 1], sin * wo[:, 0] + cos * wo[:, 1], wo[:, 2]), axis=-1)
        near = np.abs(np.degrees(np.arccos(np.clip(wi[:, 2], -1.0, 1.0))) - theta) <= NEAR_DEG
    else:
        near = np.degrees(angle_between(wi, light)) <= NEAR_DEG
    square = hemisphere_to_square(wo[near])
    return np.stack((square[:, 0], 1.0 - square[:, 1]), axis=-1)


class UnrolledView(SliceImageView):
    """Shows the pictures, and values and angles under the mouse."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("unrolled_view", tr("Hemisphere of views on the unit square"), parent)
        self._incidences: tuple[float, ...] = ()
        self._phi_deg = 0.0

    def set_lights(self, incidences_deg: tuple[float, ...], phi_deg: float) -> None:
        self._incidences, self._phi_deg = incidences_deg, phi_deg

    def head_at(self, column: int, x: float, y: float) -> str:
        view = view_of(x, y)
        light = light_at(self._incidences[column], self._phi_deg)
        gamma = float(np.degrees(angle_between(mirror(light), view)))
        theta = float(np.degrees(np.arccos(min(1.0, view[2]))))
        phi = float(np.degrees(np.arctan2(view[1], view[0])))
        return f"{degrees('theta_o', theta)}  φo {phi:.0f}°  {degrees('gamma', gamma)}".replace("-", "−")
