"""Exact cuts of a triangle mesh along the zero of any function of position.

A cut adds points where edges cross the zero, so that the border of a window or of a shut line is a smooth curve
however coarse the mesh is. Nothing is removed: pieces are identified afterwards by the sign at their middle.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Bools, Floats, Integers
from meshes.car.blends import Field
from meshes.car.nets import Soup, gradient, normals, split_edges, unique_edges

PointFunction: TypeAlias = Callable[[Floats], Floats]
"""A function of points (n, 3) -> (n,)."""

"""(n, m): point i lies on curve j."""

_ON_CURVE = 2e-5
_SNAP = 0.12


def at_points(field: Field) -> PointFunction:
    """Return a field of (x, y, z) as a function of points (..., 3)."""
    return lambda points: field(points[..., 0], points[..., 1], points[..., 2])


def surface_distance(region: Field, surface: Field, reach: float) -> PointFunction:
    """Return the distance, measured along the surface, to the zero of a region; beyond ``reach`` only its sign.

    To first order the distance is the value over the length of its gradient in the tangent plane, so a
    band of constant value has the same width on the side of the car and round a corner.
    """

    def distance(points: Floats) -> Floats:
        value = region(points[:, 0], points[:, 1], points[:, 2])
        near = np.abs(value) < reach
        if near.any():
            p = points[near]
            slope = gradient(region, p)
            n = normals(surface, p)
            slope -= np.einsum("ij,ij->i", slope, n)[:, None] * n
            value[near] /= np.maximum(np.linalg.norm(slope, axis=1), 0.2)
        return value

    return distance


def cut(soup: Soup, function: PointFunction, snap: bool = False) -> Soup:
    """Return the soup with every triangle on one side of the function's zero only.

    With ``snap``, points next to the zero are moved on to it instead of cutting off slivers; only for
    the first cuts, since a moved point would leave an earlier curve.
    """
    return _cut(soup, function, function(soup.points), snap)[0]


def offset(distance: PointFunction, at: float) -> PointFunction:
    """Return the function that is zero where ``distance`` is ``at``."""
    return lambda points: distance(points) - at


def cut_all(
    soup: Soup, functions: Sequence[tuple[PointFunction, Sequence[float]]], marks: Bools
) -> tuple[Soup, Bools]:
    """Return the soup cut along all curves, and which point lies on which curve.

    Each function is cut where it has each of its values; it is computed once a point. ``marks`` (n, m) has a column
    for each curve known before; the result has one more per value of a function.
    """
    column = marks.shape[1]
    more = sum(len(values) for _, values in functions)
    marks = np.concatenate([marks, np.zeros((len(marks), more), dtype=bool)], axis=1)
    for function, values in functions:
        held = function(soup.points)
        for at in values:
            old = len(soup.points)
            soup, on_curve, parents = _cut(soup, offset(function, at), held - at, snap=False)
            held = np.concatenate([held, function(soup.points[old:])])
            marks[:old, column] |= on_curve
            between = marks[parents[:, 0]] & marks[parents[:, 1]]
            between[:, column] = True
            marks = np.concatenate([marks, between])
            column += 1
    return soup, marks


def _cut(
    soup: Soup, function: PointFunction, value: Floats, snap: bool
) -> tuple[Soup, NDArray[np.bool_], Integers]:
    """Return the cut soup, which old points lie on the zero, and the two old ends of each new point's edge.

    ``value`` (n,) is the function's at the points.
    """
    value[np.abs(value) < _ON_CURVE] = 0.0
    p, q, r = value[soup.triangles.T]
    touched = (p * q < 0.0) | (q * r < 0.0) | (r * p < 0.0)
    triangles = soup.triangles[touched]
    edge, edge_of_side = unique_edges(triangles)
    a, b = edge.T
    crossing = value[a] * value[b] < 0.0
    if snap:
        soup, value = _snapped(soup, value, a[crossing], b[crossing])
        crossing = value[a] * value[b] < 0.0
    middle = _roots(function, soup.points, a[crossing], b[crossing], value)
    split = split_edges(soup, touched, edge_of_side, crossing, middle)
    return split, value == 0.0, edge[crossing]


def _roots(function: PointFunction, points: Floats, a: Integers, b: Integers, value: Floats) -> Floats:
    """Return where the function vanishes on the edges from a to b, by the Illinois form of false position."""
    low, high = points[a], points[b]
    f_low, f_high = value[a], value[b]
    middle = low
    for _ in range(4):
        t = f_low / (f_low - f_high)
        middle = low + t[:, None] * (high - low)
        f = function(middle)
        same = f * f_low > 0.0
        low = np.where(same[:, None], middle, low)
        high = np.where(same[:, None], high, middle)
        f_low, f_high = np.where(same, f, f_low * 0.5), np.where(same, f_high * 0.5, f)
    return middle


def _snapped(soup: Soup, value: Floats, a: Integers, b: Integers) -> tuple[Soup, Floats]:
    """Return the soup with points moved along a crossing edge on to the zero where it is near, and values."""
    points = soup.points.copy()
    value = value.copy()
    for one, two in ((a, b), (b, a)):
        span = value[one] - value[two]
        t = value[one] / np.where(span == 0.0, 1.0, span)
        near = (t < _SNAP) & (t > 0.0)
        chosen = one[near]
        target = points[chosen] + t[near][:, None] * (points[two[near]] - points[chosen])
        points[chosen] = target
        value[chosen] = 0.0
    return Soup(points, soup.triangles), value
