"""The hemisphere of views unrolled on the unit square, for three incidences: target above, fit below."""

from __future__ import annotations

import functools

import numpy as np
from brdf_qt.program.translation import tr
from PySide6.QtWidgets import QWidget

from brdf_lobe_visualizer.cuts.image_view import SliceImageView
from brdf_lobe_visualizer.subjects.subjects import SamplePoints
from brdf_lobe_visualizer.words import degrees
from brdf_suite.arrays import Floats
from brdf_suite.geometry.concentric import hemisphere_to_square
from brdf_suite.geometry.directions import angle_between, mirror
from brdf_suite.inspection.slices.cuts import light_at
from brdf_suite.inspection.slices.images import Pairs, unrolled_pairs, view_of

SIZE = 112
NEAR_DEG = 2.5
"""Samples are shown where their light is so near to a picture's."""


@functools.lru_cache(maxsize=12)
def pairs_of(theta_deg: float, phi_deg: float, size: int = SIZE) -> Pairs:
    """Return the pairs of one picture, the same object for the same angles."""
    return unrolled_pairs(theta_deg, phi_deg, size)


def sample_places(
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
