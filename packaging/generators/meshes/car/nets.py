"""A triangle mesh on a field: surface nets, Newton steps on to the surface, refinement where it bends.

Surface nets put one vertex in each grid cell that the surface crosses. The vertices are then moved exactly on
to the surface, and normals are the field's own gradient, so shading does not depend on the grid.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats, Integers
from meshes.car.blends import Field

_STEP = 2e-4
_BLOCK = 1 << 13
"""Points at once: the many intermediate arrays of a field stay in the processor's cache."""


@dataclass(frozen=True)
class Soup:
    """Points (n, 3) metres and triangles (k, 3), counter-clockwise from outside."""

    points: Floats
    triangles: Integers

    def keep(self, chosen: NDArray[np.bool_]) -> Soup:
        """Return the chosen triangles with the points that they use."""
        return compact(self.points, self.triangles[chosen])[0]


def find_turned_over(soup: Soup, normals: Floats) -> NDArray[np.bool_]:
    """Return which triangles (k,) face away from the mean of the normals (n, 3) at their corners."""
    a, b, c = (soup.points[soup.triangles[:, i]] for i in range(3))
    mean = normals[soup.triangles].sum(axis=1)
    result: NDArray[np.bool_] = np.einsum("ij,ij->i", np.cross(b - a, c - a), mean) < 0.0
    return result


def compact(points: Floats, triangles: Integers) -> tuple[Soup, Integers]:
    """Return a soup without unused points, and the old index of each point."""
    used, inverse = np.unique(triangles, return_inverse=True)
    return Soup(points[used], inverse.reshape(-1, 3).astype(np.int64)), used.astype(np.int64)


def gradient(field: Field, points: Floats) -> Floats:
    """Return the gradient (n, 3) by central differences."""
    result = np.empty_like(points)
    for start in range(0, len(points), _BLOCK):
        part: list[Floats] = list(points[start : start + _BLOCK].T.copy())
        for axis in range(3):
            # Both ends as (2, n) beside two coordinates (n,): what depends on those only is computed once.
            moved = part.copy()
            moved[axis] = part[axis] + np.array([[_STEP], [-_STEP]])
            ends = field(*moved)
            result[start : start + _BLOCK, axis] = (ends[0] - ends[1]) / (2.0 * _STEP)
    return result


def normals(field: Field, points: Floats) -> Floats:
    """Return unit normals (n, 3), pointing to growing values."""
    g = gradient(field, points)
    result: Floats = g / np.linalg.norm(g, axis=1, keepdims=True)
    return result


def project(field: Field, points: Floats, steps: int = 4) -> Floats:
    """Return the points moved along the gradient on to the field's zero."""
    for _ in range(steps):
        g = gradient(field, points)
        value = field(points[:, 0], points[:, 1], points[:, 2])
        step = value / np.maximum(np.einsum("ij,ij->i", g, g), 1e-3)
        points = points - np.clip(step, -0.05, 0.05)[:, None] * g
    return points


def extract(field: Field, xs: Floats, ys: Floats, zs: Floats) -> Soup:
    """Return the surface of a field on a grid of increasing coordinates, open where the grid cuts it."""
    value = field(xs[:, None, None], ys[None, :, None], zs[None, None, :])
    inside = value < 0.0
    shape = tuple(n - 1 for n in value.shape)
    axes = (xs, ys, zs)
    total = np.zeros((*shape, 3))
    count = np.zeros(shape)
    for axis in range(3):
        low = tuple(slice(None, -1) if a == axis else slice(None) for a in range(3))
        high = tuple(slice(1, None) if a == axis else slice(None) for a in range(3))
        crossing = np.argwhere(inside[low] != inside[high])
        a = value[low][tuple(crossing.T)]
        b = value[high][tuple(crossing.T)]
        at = np.stack([axes[k][crossing[:, k]] for k in range(3)], axis=1)
        length = np.diff(axes[axis])[crossing[:, axis]]
        at[:, axis] += length * (a / (a - b))
        others = [k for k in range(3) if k != axis]
        for shift in ((0, 0), (0, 1), (1, 0), (1, 1)):
            cell = crossing.copy()
            cell[:, others[0]] -= shift[0]
            cell[:, others[1]] -= shift[1]
            valid = np.all((cell >= 0) & (cell < shape), axis=1)
            index = tuple(cell[valid].T)
            np.add.at(total, index, at[valid])
            np.add.at(count, index, 1.0)
    active = count > 0
    number = np.full(shape, -1, dtype=np.int64)
    number[active] = np.arange(int(active.sum()))
    points = total[active] / count[active][:, None]
    quads = [_quads(inside, number, axis) for axis in range(3)]
    quad = np.concatenate(quads)
    return Soup(points, _split_quads(points, quad))


def _quads(inside: NDArray[np.bool_], number: Integers, axis: int) -> Integers:
    """Return the quads round all grid edges along ``axis`` whose ends differ, facing outwards."""
    one, two = (axis + 1) % 3, (axis + 2) % 3
    low = tuple(slice(None, -1) if a == axis else slice(1, -1) for a in range(3))
    high = tuple(slice(1, None) if a == axis else slice(1, -1) for a in range(3))
    starts = inside[low]
    edge = np.argwhere(starts != inside[high])
    outwards = starts[tuple(edge.T)]
    corners = []
    for shift_one, shift_two in ((0, 0), (1, 0), (1, 1), (0, 1)):
        cell = edge.copy()
        cell[:, one] += shift_one
        cell[:, two] += shift_two
        corners.append(number[tuple(cell.T)])
    quad = np.stack(corners, axis=1)
    quad[~outwards] = quad[~outwards][:, ::-1]
    return quad


def _split_quads(points: Floats, quad: Integers) -> Integers:
    """Return two triangles per quad, split along the shorter diagonal."""
    a, b, c, d = quad.T
    first = np.linalg.norm(points[a] - points[c], axis=1) <= np.linalg.norm(points[b] - points[d], axis=1)
    one = np.where(first[:, None], np.stack([a, b, c], 1), np.stack([a, b, d], 1))
    two = np.where(first[:, None], np.stack([a, c, d], 1), np.stack([b, c, d], 1))
    return np.concatenate([one, two])


def unique_edges(triangles: Integers) -> tuple[Integers, Integers]:
    """Return the unique edges (e, 2), lower index first, and the edge of each triangle side (k, 3).

    Side i of a triangle goes from its corner i to corner i + 1.
    """
    following = triangles[:, [1, 2, 0]]
    size = int(triangles.max(initial=0)) + 1
    key = np.minimum(triangles, following) * size + np.maximum(triangles, following)
    found, inverse = np.unique(key, return_inverse=True)
    return np.stack(np.divmod(found, size), axis=1), inverse.reshape(-1, 3).astype(np.int64)


def find_any(points: NDArray[np.bool_], triangles: Integers) -> NDArray[np.bool_]:
    """Return which triangles (k,) have a corner among the chosen points (n,)."""
    a, b, c = triangles.T
    result: NDArray[np.bool_] = points[a] | points[b] | points[c]
    return result


def border(triangles: Integers) -> Integers:
    """Return the directed edges (e, 2) that only one triangle has, as that triangle runs along them."""
    sides = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    low, high = sides.min(axis=1), sides.max(axis=1)
    key = low * (int(triangles.max()) + 1) + high
    _, inverse, count = np.unique(key, return_inverse=True, return_counts=True)
    result: Integers = sides[count[inverse.ravel()] == 1]
    return result


def split_edges(
    soup: Soup, touched: NDArray[np.bool_], edge_of_side: Integers, chosen: NDArray[np.bool_], middles: Floats
) -> Soup:
    """Return the soup with the chosen edges split at ``middles`` (one per chosen edge), without gaps.

    Edges are those of the ``touched`` triangles, among which is each one that a chosen edge belongs to.
    """
    number = np.full(len(chosen), -1, dtype=np.int64)
    number[chosen] = len(soup.points) + np.arange(int(chosen.sum()))
    points = np.concatenate([soup.points, middles])
    new = number[edge_of_side]
    some = new.max(axis=1, initial=-1) >= 0
    kept = ~touched
    kept[touched] = ~some
    tri, new = soup.triangles[touched][some], new[some]
    out = [soup.triangles[kept]]
    for turn in range(3):  # rotate so that each pattern is written once
        t, mm = np.roll(tri, -turn, axis=1), np.roll(new, -turn, axis=1)
        s = mm >= 0
        one = s[:, 0] & ~s[:, 1] & ~s[:, 2]
        a, b, c, ab = t[one, 0], t[one, 1], t[one, 2], mm[one, 0]
        out += [np.stack([a, ab, c], 1), np.stack([ab, b, c], 1)]
        two = s[:, 0] & s[:, 1] & ~s[:, 2]
        a, b, c, ab, bc = t[two, 0], t[two, 1], t[two, 2], mm[two, 0], mm[two, 1]
        out.append(np.stack([ab, b, bc], 1))
        short = np.linalg.norm(points[a] - points[bc], axis=1) < np.linalg.norm(
            points[ab] - points[c], axis=1
        )
        out.append(np.where(short[:, None], np.stack([a, ab, bc], 1), np.stack([a, ab, c], 1)))
        out.append(np.where(short[:, None], np.stack([a, bc, c], 1), np.stack([ab, bc, c], 1)))
    three = (new >= 0).all(axis=1)
    a, b, c = tri[three].T
    ab, bc, ca = new[three].T
    out += [np.stack(part, 1) for part in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))]
    return replace(soup, points=points, triangles=np.concatenate(out))


def refine(
    field: Field,
    soup: Soup,
    angle_deg: float,
    shortest: float,
    creases: Sequence[tuple[Callable[[Floats], Floats], float]] = (),
) -> Soup:
    """Return the soup with edges halved (on the surface) whose end normals differ by more than the angle.

    Edges of at most ``shortest`` (m) stay. An edge whose ends lie on a crease (function, how near its zero) is
    halved on the crease: the middle of a chord lies beside it, where the normal is already another.
    """
    edge, edge_of_side = unique_edges(soup.triangles)
    n = normals(field, soup.points)
    cosine = np.einsum("ij,ij->i", n[edge[:, 0]], n[edge[:, 1]])
    length = np.linalg.norm(soup.points[edge[:, 0]] - soup.points[edge[:, 1]], axis=1)
    chosen = (cosine < np.cos(np.radians(angle_deg))) & (length > shortest)
    middles = project(field, soup.points[edge[chosen]].mean(axis=1), steps=3)
    one, two = soup.points[edge[chosen]].swapaxes(0, 1)
    for function, near in creases:
        along = np.flatnonzero((np.abs(function(one)) < near) & (np.abs(function(two)) < near))
        if len(along):
            middles[along] = slide_points(field, middles[along], function)
    return split_edges(soup, np.ones(len(soup.triangles), dtype=bool), edge_of_side, chosen, middles)


def slide_points(field: Field, points: Floats, function: Callable[[Floats], Floats]) -> Floats:
    """Return the points moved along the surface, by at most 3 mm, to the zero of a function."""
    slope = gradient(lambda x, y, z: function(np.stack(np.broadcast_arrays(x, y, z), axis=-1)), points)
    n = normals(field, points)
    slope -= np.einsum("ij,ij->i", slope, n)[:, None] * n
    step = (function(points) / np.maximum(np.einsum("ij,ij->i", slope, slope), 1e-6))[:, None] * slope
    close = np.linalg.norm(step, axis=1) < 0.003  # not so where the function has no value
    moved = points.copy()
    moved[close] = project(field, points[close] - step[close], steps=1)
    return moved


def refine_near(
    field: Field, soup: Soup, near: Callable[[Floats], Floats], reach: float, longest: float
) -> Soup:
    """Return the soup with edges longer than ``longest`` halved where |near(points)| is below ``reach``, m.

    Cuts follow a curve only where edges cross it: bands must not be narrower than the triangles.
    """
    value = np.abs(near(soup.points))
    for _ in range(4):
        touched = find_any(value < reach, soup.triangles)
        edge, edge_of_side = unique_edges(soup.triangles[touched])
        a, b = soup.points[edge[:, 0]], soup.points[edge[:, 1]]
        length = np.linalg.norm(a - b, axis=1)
        chosen = (np.minimum(value[edge[:, 0]], value[edge[:, 1]]) < reach) & (length > longest)
        if not chosen.any():
            break
        middles = project(field, 0.5 * (a + b)[chosen], steps=3)
        soup = split_edges(soup, touched, edge_of_side, chosen, middles)
        value = np.concatenate([value, np.abs(near(middles))])
    return soup


def refine_bends(field: Field, soup: Soup, region: Field, reach: float, shortest: float) -> Soup:
    """Return the soup with edges halved, down to ``shortest`` (m), where a region's border turns a corner.

    An edge near the border (within ``reach``, m) is too long if the region's gradient turns by more than
    20° along it: a cut through its triangle would cut the corner off.
    """
    value = np.abs(region(*soup.points.T))
    corners = soup.points[soup.triangles.T]
    longest = max(float(np.abs(one - two).sum(axis=1).max()) for one, two in combinations(corners, 2))
    for _ in range(4):
        # Halves of edges, and lines to their middles, are no longer than the longest edge was.
        touched = find_any(value < max(reach, longest), soup.triangles)
        edge, edge_of_side = unique_edges(soup.triangles[touched])
        a, b = soup.points[edge[:, 0]], soup.points[edge[:, 1]]
        length = np.linalg.norm(a - b, axis=1)
        nearest = np.minimum(value[edge[:, 0]], value[edge[:, 1]])
        close = np.flatnonzero((nearest < np.maximum(reach, 0.7 * length)) & (length > shortest))
        ends, number = np.unique(edge[close], return_inverse=True)
        one, two = gradient(region, soup.points[ends])[number.reshape(-1, 2).T]
        turn = np.einsum("ij,ij->i", one, two)
        turn /= np.maximum(np.linalg.norm(one, axis=1) * np.linalg.norm(two, axis=1), 1e-12)
        chosen = np.zeros(len(edge), dtype=bool)
        chosen[close[turn < 0.94]] = True
        if not chosen.any():
            break
        middles = project(field, 0.5 * (a + b)[chosen], steps=3)
        soup = split_edges(soup, touched, edge_of_side, chosen, middles)
        value = np.concatenate([value, np.abs(region(*middles.T))])
    return soup
