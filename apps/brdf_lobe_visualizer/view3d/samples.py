"""Measured samples as points: those whose light stands about where the session's does."""

from __future__ import annotations

import numpy as np
from brdf_qt.program.translation import tr

from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial, SamplePoints
from brdf_lobe_visualizer.view3d.options import SpaceOptions
from brdf_lobe_visualizer.view3d.scene import CUT, Points
from brdf_suite.arrays import Floats
from brdf_suite.geometry.directions import angle_between
from brdf_suite.inspection.lobe_surface.colour import light_codes, scalar_of
from brdf_suite.inspection.lobe_surface.surface import RadiusScale
from brdf_suite.inspection.slices.values import cosine_of


def sample_points(
    subject: PlottedMaterial, session: LobeSession, scale: RadiusScale, options: SpaceOptions
) -> tuple[Points | None, str]:
    """Return the points of a subject's samples near the session's incidence, and a note if there are none.

    Samples of an isotropic reflectance are turned about the normal into the session's plane of incidence, and stand on
    both sides of it: only the size of the azimuth between light and view matters. What is longer than the picture shows
    is at its end.
    """
    samples = subject.samples
    if samples is None:
        return None, ""
    wi, wo, values = samples_near(samples, session.light, options.within_deg)
    if not len(wi):
        polar = np.degrees(np.arccos(np.clip(samples.wi[:, 2], -1.0, 1.0)))
        nearest = polar[np.argmin(np.abs(polar - session.incidence[0]))]
        text = tr("No samples within {reach}° of this incidence; the nearest is at {angle}°.")
        return None, text.format(reach=f"{options.within_deg:g}", angle=f"{nearest:.1f}")
    values = values * np.maximum(cosine_of(session.options.cosine, wi, wo), 0.0)[:, None]
    shown = scalar_of(values.astype(np.float32), session.options.channel)
    places = wo * np.minimum(scale.radius(shown), CUT)[:, None]
    colours = np.ones((len(wo), 4), np.float32)
    colours[:, :3] = light_codes(values.astype(np.float32)) / 255.0
    return Points(places.astype(np.float32), colours), ""


def samples_near(samples: SamplePoints, light: Floats, within_deg: float) -> tuple[Floats, Floats, Floats]:
    """Return light, view and value, (n, 3) each, of samples whose light is within an angle of ``light`` (3,)."""
    wi, wo = samples.wi, samples.wo
    if not samples.isotropic:
        near = np.degrees(angle_between(wi, light)) <= within_deg
        return wi[near], wo[near], samples.values[near]
    polar = np.degrees(np.arctan2(np.hypot(wi[:, 0], wi[:, 1]), wi[:, 2]))
    wanted = np.degrees(np.arctan2(np.hypot(light[0], light[1]), light[2]))
    near = np.abs(polar - wanted) <= within_deg
    wi, wo, values = wi[near], wo[near], samples.values[near]
    # Into the plane of the x axis, where the other side is -y, then to the light's azimuth.
    back = -np.arctan2(wi[:, 1], wi[:, 0])
    wi, wo = _turned(wi, back), _turned(wo, back)
    other = wo * np.array([1.0, -1.0, 1.0])
    off = np.abs(wo[:, 1]) > 1e-6
    wi, wo = np.concatenate((wi, wi[off])), np.concatenate((wo, other[off]))
    turn = np.full(len(wi), np.arctan2(light[1], light[0]))
    return _turned(wi, turn), _turned(wo, turn), np.concatenate((values, values[off]))


def _turned(directions: Floats, angle: Floats) -> Floats:
    cosine, sine = np.cos(angle), np.sin(angle)
    x, y = directions[:, 0], directions[:, 1]
    return np.column_stack((cosine * x - sine * y, sine * x + cosine * y, directions[:, 2]))
