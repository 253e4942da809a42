"""Kernels that build the tree of boxes around triangles.

A node holds the boxes of its two children, so that a ray reads one row to decide about both. Splits are chosen
among 16 equal bins along the widest axis of the centroids by the surface area heuristic (Wald 2007, "On fast
construction of SAH-based bounding volume hierarchies").
"""

from __future__ import annotations

import numpy as np

from brdf_suite.surface.occlusion.compiled_decorator import Array, compiled

_BINS = 16
LEAF = 4
"""A node of so many triangles or fewer is not split."""


@compiled
def build(low: Array, high: Array, order: Array, boxes: Array, children: Array) -> int:
    """Fill the tree; return how many nodes it has.

    Parameters
    ----------
    low, high
        (k, 3) float32: the box of each triangle.
    order
        (k,) int32: on entry 0 to k - 1; on return the triangles in the order of the leaves.
    boxes
        (k, 12) float32, written: lowest and highest corner of the first child, then of the second.
    children
        (k, 4) int32, written: first and count of the first child, then of the second. A count above 0 is a leaf of
        triangles ``order[first : first + count]``, a count of 0 the node ``first``, -1 no child.
    """
    count = len(order)
    # Open ranges: begin, end, the node and side that wait for the answer; node -1 is the root's own.
    stack = np.empty((128, 4), np.int32)
    costs = np.empty(_BINS, np.float64)
    bin_low = np.empty((_BINS, 3), np.float64)
    bin_high = np.empty((_BINS, 3), np.float64)
    bin_count = np.empty(_BINS, np.int64)
    corner_low = np.empty(3, np.float64)
    corner_high = np.empty(3, np.float64)
    nodes = 0
    depth = 1
    stack[0, 0], stack[0, 1], stack[0, 2], stack[0, 3] = 0, count, -1, 0
    while depth > 0:
        depth -= 1
        begin, end = stack[depth, 0], stack[depth, 1]
        parent, side = stack[depth, 2], stack[depth, 3]
        number = end - begin
        if parent >= 0 and (number <= LEAF or depth > 120):
            children[parent, 2 * side], children[parent, 2 * side + 1] = begin, number
            continue
        node = nodes
        nodes += 1
        if parent >= 0:
            children[parent, 2 * side], children[parent, 2 * side + 1] = node, 0
        if number <= 1:  # a mesh of one triangle
            children[node, 0], children[node, 1] = begin, number
            children[node, 2], children[node, 3] = 0, -1
            _bounds(low, high, order, begin, end, boxes, node, 0)
            boxes[node, 6:9] = np.inf
            boxes[node, 9:12] = -np.inf
            continue
        for axis in range(3):
            corner_low[axis], corner_high[axis] = np.inf, -np.inf
        for place in range(begin, end):
            triangle = order[place]
            for axis in range(3):
                middle = 0.5 * (np.float64(low[triangle, axis]) + np.float64(high[triangle, axis]))
                corner_low[axis] = min(corner_low[axis], middle)
                corner_high[axis] = max(corner_high[axis], middle)
        axis = 0
        for other in range(1, 3):
            if corner_high[other] - corner_low[other] > corner_high[axis] - corner_low[axis]:
                axis = other
        width = corner_high[axis] - corner_low[axis]
        middle_place = begin + number // 2
        if width > 0.0:
            split = _best_split(
                low,
                high,
                order,
                begin,
                end,
                axis,
                corner_low[axis],
                width,
                bin_low,
                bin_high,
                bin_count,
                costs,
            )
            left, right = begin, end - 1
            while left <= right:
                triangle = order[left]
                middle = 0.5 * (np.float64(low[triangle, axis]) + np.float64(high[triangle, axis]))
                if _bin(middle, corner_low[axis], width) <= split:
                    left += 1
                else:
                    order[left], order[right] = order[right], order[left]
                    right -= 1
            if begin < left < end:
                middle_place = left
        _bounds(low, high, order, begin, middle_place, boxes, node, 0)
        _bounds(low, high, order, middle_place, end, boxes, node, 1)
        stack[depth, 0], stack[depth, 1] = middle_place, end
        stack[depth, 2], stack[depth, 3] = node, 1
        depth += 1
        stack[depth, 0], stack[depth, 1] = begin, middle_place
        stack[depth, 2], stack[depth, 3] = node, 0
        depth += 1
    return nodes


@compiled
def _bin(middle: float, lowest: float, width: float) -> int:
    return min(_BINS - 1, int(_BINS * (middle - lowest) / width))


@compiled
def _half_area(box_low: Array, box_high: Array) -> float:
    x, y, z = box_high[0] - box_low[0], box_high[1] - box_low[1], box_high[2] - box_low[2]
    return float(max(0.0, x * y + y * z + z * x))


@compiled
def _best_split(
    low: Array,
    high: Array,
    order: Array,
    begin: int,
    end: int,
    axis: int,
    lowest: float,
    width: float,
    bin_low: Array,
    bin_high: Array,
    bin_count: Array,
    costs: Array,
) -> int:
    """Return the last bin of the left side."""
    bin_low[:] = np.inf
    bin_high[:] = -np.inf
    bin_count[:] = 0
    for place in range(begin, end):
        triangle = order[place]
        middle = 0.5 * (np.float64(low[triangle, axis]) + np.float64(high[triangle, axis]))
        which = _bin(middle, lowest, width)
        bin_count[which] += 1
        for k in range(3):
            bin_low[which, k] = min(bin_low[which, k], low[triangle, k])
            bin_high[which, k] = max(bin_high[which, k], high[triangle, k])
    box_low, box_high = np.empty(3, np.float64), np.empty(3, np.float64)
    box_low[:], box_high[:] = np.inf, -np.inf
    total = 0
    for which in range(_BINS - 1):
        total += bin_count[which]
        for k in range(3):
            box_low[k] = min(box_low[k], bin_low[which, k])
            box_high[k] = max(box_high[k], bin_high[which, k])
        costs[which] = total * _half_area(box_low, box_high) if total else np.inf
    box_low[:], box_high[:] = np.inf, -np.inf
    total = 0
    best, best_cost = 0, np.inf
    for which in range(_BINS - 1, 0, -1):
        total += bin_count[which]
        for k in range(3):
            box_low[k] = min(box_low[k], bin_low[which, k])
            box_high[k] = max(box_high[k], bin_high[which, k])
        cost = costs[which - 1] + total * _half_area(box_low, box_high) if total else np.inf
        if cost < best_cost:
            best, best_cost = which - 1, cost
    return best


@compiled
def _bounds(
    low: Array, high: Array, order: Array, begin: int, end: int, boxes: Array, node: int, side: int
) -> None:
    for axis in range(3):
        lowest, highest = np.float32(np.inf), np.float32(-np.inf)
        for place in range(begin, end):
            lowest = min(lowest, low[order[place], axis])
            highest = max(highest, high[order[place], axis])
        boxes[node, 6 * side + axis] = lowest
        boxes[node, 6 * side + 3 + axis] = highest
