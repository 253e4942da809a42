"""Structured importance sampling: bright regions first, each divided into strata of even size.

Agarwal, Ramamoorthi, Belongie and Jensen, "Structured Importance Sampling of Environment Maps", ACM Trans.
Graph. 22(3), 2003. The map is cut into layers at multiples of its standard deviation (hierarchical thresholding);
a connected region of a layer gets its share of the lights by ``Γ = L·min(ΔΩ, ΔΩ₀)^¼``, the light that comes from
it times a measure of how much of it an occluder can hide independently; within a region, points are put farthest
from those before (Hochbaum and Shmoys), and each cell goes to the point nearest to it. Here the light of a stratum
is summed up exactly ("pre-integrated"). A region too faint for a light of its own joins the layer below it, and
where there is none, its cells go to the nearest point of any.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats, Indices
from brdf_suite.geometry.closed_surface import connected_components
from brdf_suite.lighting.lights.cells import Cells

LAYERS = 6
LARGEST_USEFUL = 0.01
"""ΔΩ₀ in steradians, the paper's: regions larger than that are not hidden as one."""
_LEAST_SHARE = 0.5  # of a light: a region with less belongs to the layer below
_ALL_ALIKE = 1e-6


def structured_strata(cells: Cells, count: int) -> Indices:
    """Return for each cell (h, w) which of ``count`` strata it belongs to; fewer where there are fewer cells."""
    areas = cells.areas()
    layers = _layers(cells, areas)
    regions, number = _regions(layers)
    shares = _shares(cells, areas, regions, number)
    least = _LEAST_SHARE * float(shares.sum()) / count
    for layer in range(int(layers.max()), 0, -1):
        parts, number = _connected(layers == layer)
        faint = np.append(_shares(cells, areas, parts, number) < least, False)
        layers[faint[parts]] = layer - 1
    regions, number = _regions(layers)
    at = regions.ravel()
    shares = _shares(cells, areas, regions, number)
    points = _share_out(shares, np.bincount(at, minlength=number), count)
    towards = cells.centres().reshape(-1, 3)
    order = np.argsort(at, kind="stable")  # row by row within each region
    ends = np.cumsum(np.bincount(at, minlength=number))
    luminance = (cells.luminous / areas).ravel()
    labels = np.full(at.size, -1, dtype=np.intp)
    centres = []
    made = 0
    for region in np.flatnonzero(points):
        mine = order[ends[region - 1] if region else 0 : ends[region]]
        start = int(np.argmax(luminance[mine]))
        owner, chosen = farthest_points(towards[mine], int(points[region]), start)
        labels[mine] = made + owner
        centres.append(towards[mine[chosen]])
        made += len(chosen)
    left = np.flatnonzero(labels < 0)
    if len(left):
        labels[left] = _nearest(np.concatenate(centres), towards[left])
    return labels.reshape(regions.shape)


def _nearest(centres: Floats, towards: Floats) -> Indices:
    """Return the index (n,) of the centre (k, 3) nearest to each direction (n, 3), the first of several."""
    nearest = np.zeros(len(towards), dtype=np.intp)
    least = np.full(len(towards), np.inf)
    for index, centre in enumerate(centres):
        distance = 1.0 - towards @ centre
        closer = distance < least
        nearest[closer] = index
        least[closer] = distance[closer]
    return nearest


def farthest_points(towards: Floats, count: int, start: int) -> tuple[Indices, Indices]:
    """Return the owner (n,) of each direction, 0…count-1, and the ``count`` directions chosen, as indices.

    ``towards`` (n, 3) are unit vectors in the order of their height, row by row; the first point is ``start``, each
    further one is farthest from those before, and owns what is nearest to it. The reach of a new point is the
    farthest distance so far, so that only the rows within it are looked at.
    """
    height = np.arccos(np.clip(towards[:, 1], -1.0, 1.0))
    points = np.ascontiguousarray(towards.T, dtype=np.float32)
    distance = np.full(len(towards), np.inf, dtype=np.float32)
    owner = np.zeros(len(towards), dtype=np.intp)
    chosen = np.empty(count, dtype=np.intp)
    place, reach = start, np.pi
    for index in range(count):
        chosen[index] = place
        first, last = np.searchsorted(height, [height[place] - reach - 1e-6, height[place] + reach + 1e-6])
        x, y, z = points[:, first:last] - points[:, place, None]
        apart = x * x + y * y + z * z
        nearer = apart < distance[first:last]
        np.copyto(distance[first:last], apart, where=nearer)
        np.copyto(owner[first:last], index, where=nearer)
        place = int(np.argmax(distance))
        reach = 2.0 * float(np.arcsin(min(1.0, 0.5 * float(np.sqrt(distance[place])) + 1e-6)))
    return owner, chosen


def _layers(cells: Cells, areas: Floats) -> Indices:
    """Return the layer (h, w) of each cell: how many standard deviations its luminance reaches, at most five."""
    luminance = cells.luminous / areas
    mean = float(cells.luminous.sum() / areas.sum())
    deviation = float(np.sqrt(np.sum(areas * (luminance - mean) ** 2) / areas.sum()))
    if deviation <= _ALL_ALIKE * mean:
        return np.zeros(luminance.shape, dtype=np.intp)
    return np.minimum(luminance / deviation, LAYERS - 1).astype(np.intp)


def _shares(cells: Cells, areas: Floats, regions: Indices, number: int) -> Floats:
    """Return Γ (number,) of regions; -1 in ``regions`` is none of them. Without any light, their sizes."""
    inside = regions >= 0
    light = np.bincount(regions[inside], cells.luminous[inside], number)
    size = np.bincount(regions[inside], areas[inside], number)
    shares = light * np.minimum(size, LARGEST_USEFUL) ** 0.25 if light.any() else size
    return np.asarray(shares, dtype=np.float64)


def _regions(layers: Indices) -> tuple[Indices, int]:
    """Return the connected region (h, w) of each cell within its layer, and how many there are."""
    regions = np.empty(layers.shape, dtype=np.intp)
    number = 0
    for layer in np.unique(layers):
        parts, found = _connected(layers == layer)
        inside = parts >= 0
        regions[inside] = parts[inside] + number
        number += found
    return regions, number


def _connected(mask: NDArray[np.bool_]) -> tuple[Indices, int]:
    """Return the connected part (h, w) of each cell of ``mask``, -1 elsewhere, and how many there are.

    Cells that share an edge or a corner are connected, over the map's seam too; at a pole all cells of the ring meet.
    """
    # Runs of cells along a row are joined, which are far fewer than the cells.
    rows = len(mask)
    begins = mask & ~np.pad(mask[:, :-1], ((0, 0), (1, 0)))
    runs = np.cumsum(begins).reshape(mask.shape) - 1
    wide = np.pad(mask[1:], ((0, 0), (1, 1)), mode="wrap")
    below = np.pad(runs[1:], ((0, 0), (1, 1)), mode="wrap")
    joins = []
    for shift in range(3):
        meet = mask[:-1] & wide[:, shift : shift + mask.shape[1]]
        pairs = np.stack([runs[:-1][meet], below[:, shift : shift + mask.shape[1]][meet]])
        # Cells side by side mostly lie in the same two runs.
        joins.append(pairs[:, np.append(True, np.any(np.diff(pairs), axis=0))[: pairs.shape[1]]])
    seam = mask[:, 0] & mask[:, -1]
    joins.append(np.stack([runs[seam, 0], runs[seam, -1]]))
    for ring in (0, rows - 1):
        seen = runs[ring][begins[ring]]
        joins.append(np.stack([seen, np.full(len(seen), seen[0] if len(seen) else 0)]))
    number, names = connected_components(int(begins.sum()), *np.concatenate(joins, axis=1))
    return np.where(mask, names[runs] if number else -1, -1), number


def _share_out(shares: Floats, room: Indices, count: int) -> Indices:
    """Return how many of ``count`` points each region gets: by its share, whole, no more than it has cells.

    What a small region cannot hold goes to the others, and to regions without a share only when all others are
    full. Fractions are settled by largest remainders.
    """
    count = min(count, int(room.sum()))
    wanted = np.zeros(len(shares))
    for weights in (shares, room.astype(np.float64)):
        free = (weights > 0.0) & (wanted < room)
        while free.any() and count - wanted.sum() > 1e-9 * count:
            rest = count - float(wanted[~free].sum())
            wanted[free] = rest * weights[free] / weights[free].sum()
            over = free & (wanted >= room)
            if not over.any():
                break
            wanted[over] = room[over]
            free &= ~over
            wanted[free] = 0.0
    # A sum that should be whole may come out a hair below it.
    points = np.floor(wanted + 1e-9).astype(np.intp)
    best = np.lexsort((-shares, points - wanted))
    best = best[(points < room)[best]][: count - int(points.sum())]
    points[best] += 1
    return points
