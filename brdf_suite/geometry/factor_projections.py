"""Projections π of a direction pair to a factor's map (McCool, Ang and Ahmad 2001, section 3.2).

A projection takes unit directions ``wi``, ``wo`` (n, 3) above the horizon to places (n, d) in [0, 1]^d, d = 1 or 2, and
says how a map over them is laid out. Two-dimensional ones over a hemisphere are parabolic; the others are products of
cosines. Texel i of a map of n lies at (i + 1/2)/n; between two it is interpolated, and the outermost hold to the edge.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.geometry import warps
from brdf_suite.geometry.parabolic import parabolic_place


@dataclass(frozen=True)
class Projection:
    """A projection: its ``name``, the number of ``axes`` of its map, what it is, and ``places(wi, wo) -> (n, axes)``.

    ``hemisphere``: the map is a parabolic one over directions.
    """

    name: str
    axes: int
    what: str
    places: Callable[[Floats, Floats], Floats]
    hemisphere: bool = False


def _parabolic(w: Floats) -> Floats:
    return np.stack([0.5 * (place + 1.0) for place in parabolic_place(w)], axis=-1)


def _dot(a: Floats, b: Floats) -> Floats:
    return np.asarray(np.einsum("...i,...i->...", a, b))


def _half(wi: Floats, wo: Floats) -> Floats:
    return warps.half_vector(wi, wo)


def _across(wi: Floats, wo: Floats) -> Floats:
    """Return the azimuth from light to view as cosine, from -1 to 1, in [0, 1]."""
    return np.asarray(0.5 * (_dot(wi, wo) + 1.0))[:, None]


def _difference(wi: Floats, wo: Floats) -> Floats:
    """The cosine from the half vector to the light (and to the view): no pair above the horizon is past 90°."""
    return np.clip(_dot(wi, _half(wi, wo)), 0.0, 1.0)[:, None]


def _half_pair(wi: Floats, wo: Floats) -> Floats:
    h = _half(wi, wo)
    return np.stack((np.clip(_dot(wi, h), 0.0, 1.0), np.clip(h[:, 2], 0.0, 1.0)), axis=-1)


def _radius(w: Floats) -> Floats:
    """How far from the middle of a parabolic map a direction lies, tan(θ/2), 1 at the horizon."""
    s, t = parabolic_place(w)
    return np.clip(np.hypot(s, t), 0.0, 1.0)[:, None]


def _fine_radius(wi: Floats, wo: Floats) -> Floats:
    """Return the root of the half vector's radius: texels are finer near the normal, where peaks are."""
    return np.sqrt(_radius(_half(wi, wo)))


def _elevations(wi: Floats, wo: Floats) -> Floats:
    """Return both cosines from the normal, the smaller first, so that light and view are exchangeable."""
    both = np.stack((wi[:, 2], wo[:, 2]), axis=-1)
    return np.sort(np.clip(both, 0.0, 1.0), axis=-1)


PROJECTIONS: Mapping[str, Projection] = MappingProxyType(
    {
        one.name: one
        for one in (
            Projection("wi", 2, "direction to the light", lambda wi, _wo: _parabolic(wi), hemisphere=True),
            Projection("wo", 2, "direction to the viewer", lambda _wi, wo: _parabolic(wo), hemisphere=True),
            Projection("h", 2, "half vector", lambda wi, wo: _parabolic(_half(wi, wo)), hemisphere=True),
            Projection("wi.wo", 1, "cosine between light and view", _across),
            Projection("w.h", 1, "cosine between light and half vector", _difference),
            Projection("|wi|", 1, "radius of the light on a parabolic map", lambda wi, _wo: _radius(wi)),
            Projection("|wo|", 1, "radius of the view on a parabolic map", lambda _wi, wo: _radius(wo)),
            Projection("|h|", 1, "radius of the half vector there", lambda wi, wo: _radius(_half(wi, wo))),
            Projection("sqrt|h|", 1, "root of that radius, fine at a peak", _fine_radius),
            Projection("w.h,h.n", 2, "cosines light to half vector, half vector to normal", _half_pair),
            Projection("wi.n,wo.n", 2, "cosines of light and view, the smaller first", _elevations),
        )
    }
)
"""Every projection by its name."""
