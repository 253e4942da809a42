"""The half-angle slice: θh to the right, θd upwards, at one φd; target above, fit below or beside it."""

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
from brdf_suite.geometry.directions import half_angle_coordinates
from brdf_suite.inspection.slices.images import Pairs, half_angle_pairs, share_of_theta_h, theta_h_at

SIZE = 112
NEAR_DEG = 2.5
_ROOT_TICKS = (0, 5, 15, 30, 60, 90)
_EVEN_TICKS = (0, 30, 60, 90)


@functools.lru_cache(maxsize=4)
def pairs_of(phi_d_deg: float, phi_deg: float, by_root: bool, size: int = SIZE) -> Pairs:
    """Return the pairs of the picture, the same object for the same angles."""
    return half_angle_pairs(phi_d_deg, phi_deg, size, by_root=by_root)


def axes_of(by_root: bool) -> Axes:
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


def sample_places(phi_d_deg: float, phi_deg: float, by_root: bool, samples: SamplePoints) -> Floats:
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
