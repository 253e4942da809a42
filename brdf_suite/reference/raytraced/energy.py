"""Albedo of a term: a paint that reflects more than all incident light is not physical."""

from __future__ import annotations

from typing import Any

import numpy as np

from brdf_suite.reference.bsdfs import terms
from brdf_suite.reference.mitsuba_modules import dr, mi
from brdf_suite.reference.raytraced.numbers import copy_to_device, in_cube

_VIEWS_DEG = (0.0, 45.0, 65.0, 80.0)
_SAMPLES = 4096
TOLERANCE = 0.005
"""What so few samples may err by."""


def largest_albedo(term: Any) -> float:
    """Return the largest directional albedo of any channel at four angles, sampled; 1 is all light."""
    lane = dr.arange(mi.UInt32, len(_VIEWS_DEG) * _SAMPLES)
    cosines = copy_to_device(np.cos(np.radians(_VIEWS_DEG)).astype(np.float32), mi.Float)
    cosine = dr.gather(mi.Float, cosines, lane // _SAMPLES)
    view = mi.Vector3f(dr.sqrt(dr.maximum(1.0 - dr.square(cosine), 0.0)), 0.0, cosine)
    choice, u = in_cube(lane % _SAMPLES, mi.UInt32(0))
    light = terms.sample(term.samplers, view, choice, u)
    pdf = terms.pdf(term.samplers, light, view)
    above = (light.z > 0.0) & (pdf > 0.0)
    weight = dr.select(above, term.eval(light, view) * (light.z / pdf), 0.0)
    means = np.array(weight, np.float64).reshape(3, len(_VIEWS_DEG), _SAMPLES).mean(axis=2)
    return float(means.max())
