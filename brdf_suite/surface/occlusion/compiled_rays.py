"""Kernels that follow rays through the tree: is anything hit, and how much of the light a place sees.

Places are sampled with cosine-distributed directions, so that a share of the directions is a share of the
irradiance: points of the R2 sequence (Roberts 2018), stratified in both coordinates, shifted for every place by a
hash of its number (Cranley and Patterson 1976) so that neighbours do not err alike.
"""

from __future__ import annotations

import math

import numpy as np

from brdf_suite.surface.occlusion.compiled_decorator import Array, compiled

_R2_X, _R2_Y = 0.7548776662466927, 0.5698402909980532
STACK = 256
_BELOW = 1e-3
"""A direction whose cosine to the triangle's plane is less looks into the body and is not counted."""


@compiled
def is_hit(
    boxes: Array,
    children: Array,
    corners: Array,
    stack: Array,
    ox: np.float32,
    oy: np.float32,
    oz: np.float32,
    dx: np.float32,
    dy: np.float32,
    dz: np.float32,
) -> bool:
    """Return whether a ray (float32 throughout) hits any triangle in front of its origin.

    ``corners`` (k, 9) float32: first corner and both edges of the triangles in the order of the leaves.
    """
    one = np.float32(1.0)
    zero = np.float32(0.0)
    # A direction along an axis would give 0 times infinity where the origin is in the plane of a box.
    tiny = np.float32(1e-20)
    ix = one / (dx if abs(dx) > tiny else tiny)
    iy = one / (dy if abs(dy) > tiny else tiny)
    iz = one / (dz if abs(dz) > tiny else tiny)
    depth = 1
    stack[0] = 0
    while depth > 0:
        depth -= 1
        node = stack[depth]
        for side in range(2):
            at = 6 * side
            t0 = (boxes[node, at] - ox) * ix
            t1 = (boxes[node, at + 3] - ox) * ix
            near = min(t0, t1)
            far = max(t0, t1)
            t0 = (boxes[node, at + 1] - oy) * iy
            t1 = (boxes[node, at + 4] - oy) * iy
            near = max(near, min(t0, t1))
            far = min(far, max(t0, t1))
            t0 = (boxes[node, at + 2] - oz) * iz
            t1 = (boxes[node, at + 5] - oz) * iz
            near = max(near, min(t0, t1))
            far = min(far, max(t0, t1))
            if far < zero or near > far:
                continue
            first = children[node, 2 * side]
            count = children[node, 2 * side + 1]
            if count == 0:
                stack[depth] = first
                depth += 1
                continue
            for k in range(first, first + count):
                # Moeller and Trumbore 1997.
                ax, ay, az = corners[k, 3], corners[k, 4], corners[k, 5]
                bx, by, bz = corners[k, 6], corners[k, 7], corners[k, 8]
                px, py, pz = dy * bz - dz * by, dz * bx - dx * bz, dx * by - dy * bx
                determinant = ax * px + ay * py + az * pz
                if determinant == zero:
                    continue
                inverse = one / determinant
                sx, sy, sz = ox - corners[k, 0], oy - corners[k, 1], oz - corners[k, 2]
                u = (sx * px + sy * py + sz * pz) * inverse
                if u < zero or u > one:
                    continue
                qx, qy, qz = sy * az - sz * ay, sz * ax - sx * az, sx * ay - sy * ax
                v = (dx * qx + dy * qy + dz * qz) * inverse
                if v < zero or u + v > one:
                    continue
                if (bx * qx + by * qy + bz * qz) * inverse > zero:
                    return True
    return False


@compiled
def shift(number: int) -> tuple[float, float]:
    """Return two numbers of 0…1 that belong to a whole number and look like chance (a 64-bit mixer)."""
    z = np.uint64(number) * np.uint64(0x9E3779B97F4A7C15) + np.uint64(0x9E3779B97F4A7C15)
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    z = z ^ (z >> np.uint64(31))
    scale = 1.0 / 4294967296.0
    return float(z >> np.uint64(32)) * scale, float(z & np.uint64(0xFFFFFFFF)) * scale


@compiled
def ground_share(ground: Array, frame: Array, x: float, z: float) -> float:
    """Return how much light the ground sees at (x, z), between its texels; 1 outside.

    ``ground`` (rows along z, columns along x); ``frame``: lowest x and z, texels per metre along each.
    """
    column = (x - frame[0]) * frame[2] - 0.5
    row = (z - frame[1]) * frame[3] - 0.5
    rows, columns = ground.shape
    if column < 0.0 or row < 0.0 or column >= columns - 1 or row >= rows - 1:
        return 1.0
    i, j = int(row), int(column)
    s, t = row - i, column - j
    upper = ground[i, j] * (1.0 - t) + ground[i, j + 1] * t
    lower = ground[i + 1, j] * (1.0 - t) + ground[i + 1, j + 1] * t
    return float(upper * (1.0 - s) + lower * s)


@compiled
def gather(
    boxes: Array,
    children: Array,
    corners: Array,
    points: Array,
    normals: Array,
    planes: Array,
    first: int,
    rays: int,
    ground: Array,
    frame: Array,
    floor: float,
    result: Array,
) -> None:
    """Cast ``rays`` from each place and add up those that leave.

    Parameters
    ----------
    points, normals, planes
        (n, 3) float32: where, about which unit normal, and the unit normal of the plane there.
    first
        Number of the first place, for its own directions.
    ground, frame, floor
        Of :func:`ground_share`, and the ground's height; a ray that meets it counts by the light that it sees.
    result
        (n, 9) float32, written: share of directions that leave and the sum of those, over the number cast, alone (4)
        and with the ground (4); last the share of directions above the plane, 0 where the place is no use.
    """
    stack = np.empty(STACK, np.int32)
    for place in range(len(points)):
        shift_x, shift_y = shift(first + place)
        nx, ny, nz = float(normals[place, 0]), float(normals[place, 1]), float(normals[place, 2])
        # A frame about the normal (Duff et al. 2017).
        sign = math.copysign(1.0, nz)
        a = -1.0 / (sign + nz)
        b = nx * ny * a
        tx, ty, tz = 1.0 + sign * nx * nx * a, sign * b, -sign * nx
        ux, uy, uz = b, sign + ny * ny * a, -ny
        px, py, pz = float(points[place, 0]), float(points[place, 1]), float(points[place, 2])
        counted = 0
        alone = alone_x = alone_y = alone_z = 0.0
        both = both_x = both_y = both_z = 0.0
        for k in range(rays):
            # The first coordinate is stratified exactly, the second by the golden ratio.
            u = (k + shift_x) / rays
            v = (k * 0.6180339887498949 + shift_y) % 1.0
            radius = math.sqrt(u)
            x, y, z = (
                radius * math.cos(2.0 * math.pi * v),
                radius * math.sin(2.0 * math.pi * v),
                math.sqrt(1.0 - u),
            )
            dx = x * tx + y * ux + z * nx
            dy = x * ty + y * uy + z * ny
            dz = x * tz + y * uz + z * nz
            if dx * planes[place, 0] + dy * planes[place, 1] + dz * planes[place, 2] < _BELOW:
                continue
            counted += 1
            if is_hit(
                boxes,
                children,
                corners,
                stack,
                np.float32(px),
                np.float32(py),
                np.float32(pz),
                np.float32(dx),
                np.float32(dy),
                np.float32(dz),
            ):
                continue
            alone += 1.0
            alone_x += dx
            alone_y += dy
            alone_z += dz
            share = 1.0
            if dy < 0.0 and py > floor:
                distance = (py - floor) / -dy
                share = ground_share(ground, frame, px + distance * dx, pz + distance * dz)
            both += share
            both_x += share * dx
            both_y += share * dy
            both_z += share * dz
        over = 1.0 / max(counted, 1)
        result[place, 0] = alone * over
        result[place, 1] = alone_x * over
        result[place, 2] = alone_y * over
        result[place, 3] = alone_z * over
        result[place, 4] = both * over
        result[place, 5] = both_x * over
        result[place, 6] = both_y * over
        result[place, 7] = both_z * over
        result[place, 8] = counted / rays


@compiled
def leaves(
    boxes: Array,
    children: Array,
    corners: Array,
    points: Array,
    directions: Array,
    turns: Array,
    result: Array,
) -> None:
    """Write into ``result`` (n, m) uint8 whether rays from each point hit nothing.

    ``points`` (n, 3) float32; ``directions`` (m, 3) float64, turned about y by ``turns`` (n,), radians, for each
    point.
    """
    stack = np.empty(STACK, np.int32)
    for place in range(len(points)):
        cosine, sine = math.cos(turns[place]), math.sin(turns[place])
        for k in range(len(directions)):
            x, y, z = directions[k, 0], directions[k, 1], directions[k, 2]
            hit = is_hit(
                boxes,
                children,
                corners,
                stack,
                points[place, 0],
                points[place, 1],
                points[place, 2],
                np.float32(cosine * x + sine * z),
                np.float32(y),
                np.float32(cosine * z - sine * x),
            )
            result[place, k] = 0 if hit else 1
