"""How much of the light that falls on it a term sends back: more than all is no paint that can be."""

from __future__ import annotations

from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from brdf_suite.reference import terms

_VIEWS_DEG = (0.0, 45.0, 65.0, 80.0)
_SAMPLES = 4096
TOLERANCE = 0.005
"""What so few samples may err by."""


def largest_albedo(term: Any) -> float:
    """Return the largest directional albedo of any channel at four angles, sampled; 1 is all light."""
    theta = np.radians(np.repeat(_VIEWS_DEG, _SAMPLES))
    index = np.tile(np.arange(_SAMPLES), len(_VIEWS_DEG))
    u = np.modf(0.5 + index[:, None] * np.array([0.8191725134, 0.6710436067, 0.5497004779]))[0]
    choice, a, b = (mi.Float(np.ascontiguousarray(x, np.float32)) for x in u.T)
    sine, cosine = (mi.Float(f(theta).astype(np.float32)) for f in (np.sin, np.cos))
    view = mi.Vector3f(sine, 0.0, cosine)
    light = terms.draw(term.samplers, view, choice, mi.Point2f(a, b))
    pdf = terms.density(term.samplers, light, view)
    above = (light.z > 0.0) & (pdf > 0.0)
    weight = dr.select(above, term.value(light, view) * (light.z / pdf), 0.0)
    means = np.array(weight, np.float64).reshape(3, len(_VIEWS_DEG), _SAMPLES).mean(axis=2)
    return float(means.max())
