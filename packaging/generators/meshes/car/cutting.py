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
from meshes.car.nets import Soup, gradient, normals, unique_edges

PointFunction: TypeAlias = Callable[[Floats], Floats]
"""A function of points (n, 3) -> (n,)."""

"""(n, m): point i lies on curve j."""

_ON_CURVE = 2e-5
_SNAP = 0.12


def at_points(field: Field) -> PointFunction:
    """Return a field of (x, y, z) as a function of points (n, 3)."""
    return lambda points: field(points[:, 0], points[:, 1], points[:, 2])


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
    return _cut(soup, function, snap)[0]


def cut_all(soup: Soup, functions: Sequence[PointFunction], marks: Bools) -> tuple[Soup, Bools]:
    """Return the soup cut along all functions, and which point lies on which curve.

    ``marks`` (n, m) has a column for each curve known before; the result has one more per function.
    """
    known = marks.shape[1]
    marks = np.concatenate([marks, np.zeros((len(marks), len(functions)), dtype=bool)], axis=1)
    for number, function in enumerate(functions):
        old = len(soup.points)
        soup, on_curve, parents = _cut(soup, function, snap=False)
        marks[:old, known + number] |= on_curve
        between = marks[parents[:, 0]] & marks[parents[:, 1]]
        between[:, known + number] = True
        marks = np.concatenate([marks, between])
    return soup, marks


def _cut(soup: Soup, function: PointFunction, snap: bool) -> tuple[Soup, NDArray[np.bool_], Integers]:
    """Return the cut soup, which old points lie on the zero, and the two old ends of each new point's edge."""
    value = function(soup.points)
    value[np.abs(value) < _ON_CURVE] = 0.0
    edge, edge_of_side = unique_edges(soup.triangles)
    a, b = edge.T
    crossing = value[a] * value[b] < 0.0
    if snap:
        soup, value = _snapped(soup, value, a[crossing], b[crossing])
        crossing = value[a] * value[b] < 0.0
    middle = _roots(function, soup.points, a[crossing], b[crossing], value)
    number = np.full(len(edge), -1, dtype=np.int64)
    number[crossing] = len(soup.points) + np.arange(int(crossing.sum()))
    points = np.concatenate([soup.points, middle])
    return Soup(points, _split(points, soup.triangles, number[edge_of_side])), value == 0.0, edge[crossing]


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


def _split(points: Floats, triangles: Integers, new: Integers) -> Integers:
    """Return the triangles with the sides split where ``new`` (k, 3) names a point; one or two sides each."""
    split = new >= 0
    out = [triangles[~split.any(axis=1)]]
    for turn in range(3):
        t, m, s = (np.roll(array, -turn, axis=1) for array in (triangles, new, split))
        one = s[:, 0] & ~s[:, 1] & ~s[:, 2]  # the curve passes through the opposite corner
        p, q, r, pq = t[one, 0], t[one, 1], t[one, 2], m[one, 0]
        out += [np.stack([p, pq, r], 1), np.stack([pq, q, r], 1)]
        two = s[:, 0] & s[:, 1] & ~s[:, 2]  # it cuts off corner q
        p, q, r, pq, qr = t[two, 0], t[two, 1], t[two, 2], m[two, 0], m[two, 1]
        out.append(np.stack([pq, q, qr], 1))
        short = np.linalg.norm(points[p] - points[qr], axis=1) < np.linalg.norm(
            points[pq] - points[r], axis=1
        )
        out.append(np.where(short[:, None], np.stack([p, pq, qr], 1), np.stack([p, pq, r], 1)))
        out.append(np.where(short[:, None], np.stack([p, qr, r], 1), np.stack([pq, qr, r], 1)))
    return np.concatenate(out)


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
