"""Compiled kernels of :mod:`brdf_suite.acquisition.table.samples`. Importing this module imports numba.

Arithmetic is in double precision throughout, arrays are kept in single precision: a direction then holds to 6e-8,
a tenth of what a pixel's corner needs.
"""

from __future__ import annotations

import math

from brdf_suite.compilation import Array, compiled

_BASE = 0.95
"""Of the darkest neighbour, where the neighbours differ most: a little of a lobe is left for its logarithm."""


@compiled
def intensity(cosine: float, angles: Array, values: Array) -> float:
    """Return the lamp's relative intensity at the cosine of the angle off its axis, linear between ``angles``."""
    angle = math.acos(min(1.0, max(-1.0, cosine)))
    count = len(angles)
    if angle >= angles[count - 1]:
        return float(values[count - 1])
    k = 0
    while angles[k + 1] <= angle:
        k += 1
    share = (angle - angles[k]) / (angles[k + 1] - angles[k])
    return float(values[k] + share * (values[k + 1] - values[k]))


@compiled
def reading(
    point: Array, normal: Array, tangent: Array, view: Array, lamp: Array, lamp_table: Array, out: Array
) -> float:
    """Fill ``out`` (9,) with wi, wo, θh, θd, φd in the local frame; return cosθi · irradiance facing the light.

    Irradiance is relative to that at the axis. 0: the light does not reach the surface.

    ``lamp`` (7,): its place, the direction of its axis, its squared distance to the axis. ``lamp_table`` (2, n): angles
    and intensities relative to that along the lamp's axis.
    """
    wx, wy, wz = lamp[0] - point[0], lamp[1] - point[1], lamp[2] - point[2]
    square = wx * wx + wy * wy + wz * wz
    inverse = 1.0 / math.sqrt(square)
    wx, wy, wz = wx * inverse, wy * inverse, wz * inverse
    cos_i = wx * normal[0] + wy * normal[1] + wz * normal[2]
    cos_o = view[0] * normal[0] + view[1] * normal[1] + view[2] * normal[2]
    if cos_i <= 0.0 or cos_o <= 0.0:
        return 0.0
    along = wx * tangent[0] + wy * tangent[1] + wz * tangent[2]
    bx = normal[1] * tangent[2] - normal[2] * tangent[1]
    by = normal[2] * tangent[0] - normal[0] * tangent[2]
    bz = normal[0] * tangent[1] - normal[1] * tangent[0]
    across = wx * bx + wy * by + wz * bz
    vx = view[0] * tangent[0] + view[1] * tangent[1] + view[2] * tangent[2]
    vy = view[0] * bx + view[1] * by + view[2] * bz
    out[0], out[1], out[2] = along, across, cos_i
    out[3], out[4], out[5] = vx, vy, cos_o
    hx, hy, hz = along + vx, across + vy, cos_i + cos_o
    level = math.sqrt(hx * hx + hy * hy)
    length = math.sqrt(level * level + hz * hz)
    out[6] = math.atan2(level, hz)
    dx, dy, dz = along - vx, across - vy, cos_i - cos_o
    out[7] = math.atan2(math.sqrt(dx * dx + dy * dy + dz * dz), length)
    cos_p, sin_p = (hx / level, hy / level) if level > 0.0 else (1.0, 0.0)
    cos_t, sin_t = hz / length, level / length
    turned = math.atan2(
        cos_p * across - sin_p * along, cos_t * (cos_p * along + sin_p * across) - sin_t * cos_i
    )
    # Light and camera change places by a turn of π: one half circle holds all.
    if turned < 0.0:
        turned += math.pi
    out[8] = turned if turned < math.pi else 0.0
    irradiance = lamp[6] / square
    if lamp_table.shape[1] > 1:
        irradiance *= intensity(-(wx * lamp[3] + wy * lamp[4] + wz * lamp[5]), lamp_table[0], lamp_table[1])
    return float(cos_i * irradiance)


@compiled
def is_occluded(point: Array, view: Array, lamp: Array, down: Array, housing: float, post: float) -> bool:
    """Return whether the lamp's housing, or the post below it, stands between the camera and a point."""
    reach = math.sqrt(point[0] * point[0] + point[1] * point[1] + point[2] * point[2])
    along = -(lamp[0] * view[0] + lamp[1] * view[1] + lamp[2] * view[2])
    if housing > 0.0 and 0.0 < along < reach:
        square = lamp[0] * lamp[0] + lamp[1] * lamp[1] + lamp[2] * lamp[2] - along * along
        if square < housing * housing:
            return True
    if post > 0.0:
        # Nearest points of the ray -view·s and of the line lamp + down·t.
        slant = -(down[0] * view[0] + down[1] * view[1] + down[2] * view[2])
        lower = down[0] * lamp[0] + down[1] * lamp[1] + down[2] * lamp[2]
        level = 1.0 - slant * slant
        if level > 1e-12:
            t = (along * slant - lower) / level
            if t < 0.0:
                t = 0.0
            s = along + t * slant
            if 0.0 < s < reach:
                x = lamp[0] + t * down[0] + s * view[0]
                y = lamp[1] + t * down[1] + s * view[1]
                z = lamp[2] + t * down[2] + s * view[2]
                return bool(x * x + y * y + z * z < post * post)
    return False


@compiled
def read_pixels(
    places: Array,
    surface: Array,
    pictures: Array,
    lamp: Array,
    least: float,
    irradiance: Array,
    scratch: Array,
    made: Array,
) -> int:
    """Fill the arrays ``made`` with what the pixels at ``places`` show; return how many do.

    ``places`` (n, 2): row and column in the ``pictures``: radiance (h, w, 3), its variance (h, w, 3), what is good
    (h, w); either of the last two may be empty. ``surface``: points, normals, tangents, ways to the camera (n, 3) and
    slopes (n, 6). ``lamp``: place and profile as of :func:`reading`, down (3,), radii of housing and post. ``made``:
    wi, wo, value, variance, half angles (n, 3), footprint (n,), and (n,) the number of the pixel in ``places``.
    """
    points, normals, tangents, views, slopes = surface
    radiance, variance, good = pictures
    light, profile, down, hiding = lamp
    wi, wo, value, noise, half_angle, footprint, index = made
    with_noise, with_good = variance.shape[0] > 0, good.shape[0] > 0
    count = 0
    for k in range(len(places)):
        row, column = places[k, 0], places[k, 1]
        if with_good and not good[row, column]:
            continue
        received = reading(points[k], normals[k], tangents[k], views[k], light, profile, scratch)
        if received <= 0.0 or scratch[2] < least:
            continue
        if is_occluded(points[k], views[k], light, down, hiding[0], hiding[1]):
            continue
        finite = True
        for c in range(3):
            finite = finite and math.isfinite(radiance[row, column, c])
        if not finite:
            continue
        for c in range(3):
            wi[count, c], wo[count, c], half_angle[count, c] = scratch[c], scratch[3 + c], scratch[6 + c]
            scale = 1.0 / (received * irradiance[c])
            value[count, c] = radiance[row, column, c] * scale
            if with_noise:
                noise[count, c] = variance[row, column, c] * scale * scale
        footprint[count] = spread(normals[k], tangents[k], slopes[k], scratch)
        index[count] = k
        count += 1
    return count


@compiled
def spread(normal: Array, tangent: Array, slope: Array, angles: Array) -> float:
    """Return half of the range of θh over a pixel, radians.

    Over one pixel the half vector stays and the normal turns by ``slope`` (6,), the normal's change to the next column
    and to the next row. θh changes by the part of it along h's own inclination.
    """
    bx = normal[1] * tangent[2] - normal[2] * tangent[1]
    by = normal[2] * tangent[0] - normal[0] * tangent[2]
    bz = normal[0] * tangent[1] - normal[1] * tangent[0]
    ax = slope[0] * tangent[0] + slope[1] * tangent[1] + slope[2] * tangent[2]
    ay = slope[0] * bx + slope[1] * by + slope[2] * bz
    cx = slope[3] * tangent[0] + slope[4] * tangent[1] + slope[5] * tangent[2]
    cy = slope[3] * bx + slope[4] * by + slope[5] * bz
    hx, hy = angles[0] + angles[3], angles[1] + angles[4]
    level = math.sqrt(hx * hx + hy * hy)
    whole = 0.5 * math.sqrt(ax * ax + ay * ay + cx * cx + cy * cy)
    if level < 1e-12 or angles[6] < whole:
        return whole
    return float(0.5 * (abs(ax * hx + ay * hy) + abs(cx * hx + cy * hy)) / level)


@compiled
def lobe_through(radiance: Array, row: int, column: int, channel: int, lobe: Array) -> bool:
    """Fill ``lobe`` (6,) with the shape of the radiance within a pixel; return whether its neighbours determine it.

    Slopes, bends and base: radiance = base + exp(c + g·x + ½ x·C x), from the pixel and its neighbours, each a mean
    over its square. The base, which a narrow peak stands on, is the darkest of 25 pixels, and less the more alike
    they are. Of the rest, were it a Gaussian of covariance Σ, such means have the covariance Σ + 1/12: the bends C of
    their logarithm become C (1 + C/12)⁻¹, its slopes g (1 + C/12)⁻¹ g, and that undoes the mean over the pixel.
    """
    if row < 2 or column < 2 or row > radiance.shape[0] - 3 or column > radiance.shape[1] - 3:
        return False
    base, top = math.inf, 0.0
    for y in range(-2, 3):
        for x in range(-2, 3):
            near = radiance[row + y, column + x, channel]
            if not (near > 0.0 and math.isfinite(near)):
                return False
            base, top = min(base, near), max(top, near)
    base *= _BASE * (1.0 - base / top)
    lobe[5] = base
    here = math.log(radiance[row, column, channel] - base)
    east = math.log(radiance[row, column + 1, channel] - base)
    west = math.log(radiance[row, column - 1, channel] - base)
    south = math.log(radiance[row + 1, column, channel] - base)
    north = math.log(radiance[row - 1, column, channel] - base)
    corners = (
        math.log(radiance[row + 1, column + 1, channel] - base)
        + math.log(radiance[row - 1, column - 1, channel] - base)
        - math.log(radiance[row + 1, column - 1, channel] - base)
        - math.log(radiance[row - 1, column + 1, channel] - base)
    )
    gx, gy = 0.5 * (east - west), 0.5 * (south - north)
    cxx, cyy, cxy = east + west - 2.0 * here, south + north - 2.0 * here, 0.25 * corners
    lowest = 0.5 * (cxx + cyy) - math.sqrt(0.25 * (cxx - cyy) ** 2 + cxy * cxy)
    # A highlight narrower than a third of a pixel cannot be distinguished from one pixel: no sharper than that.
    if lowest < -8.0:
        shrink = -8.0 / lowest
        cxx, cyy, cxy = cxx * shrink, cyy * shrink, cxy * shrink
    mxx, myy, mxy = 1.0 + cxx / 12.0, 1.0 + cyy / 12.0, cxy / 12.0
    determinant = mxx * myy - mxy * mxy
    ixx, iyy, ixy = myy / determinant, mxx / determinant, -mxy / determinant
    lobe[0] = ixx * gx + ixy * gy
    lobe[1] = ixy * gx + iyy * gy
    lobe[2] = cxx * ixx + cxy * ixy
    lobe[3] = cxy * ixy + cyy * iyy
    lobe[4] = cxx * ixy + cxy * iyy
    return True


@compiled
def read_parts(
    chosen: Array,
    places: Array,
    surface: Array,
    pictures: Array,
    lamp: Array,
    radius: float,
    parts: int,
    least: float,
    irradiance: Array,
    scratch: Array,
    made: Array,
) -> int:
    """As :func:`read_pixels` for the pixels ``chosen`` (m,) near the peak, each in ``parts``² parts.

    The parts' radiances follow :func:`lobe_through` and have the pixel's own mean. A pixel without good neighbours
    gives none: count them by their numbers. Footprints are left to the caller.
    """
    points, normals, tangents, _, slopes = surface
    radiance, variance, good = pictures
    light, profile, _, _ = lamp
    wi, wo, value, noise, half_angle, _, index = made
    with_noise, with_good = variance.shape[0] > 0, good.shape[0] > 0
    point, normal, tangent, view = scratch[9:12], scratch[12:15], scratch[15:18], scratch[18:21]
    lobe = scratch[21:27]
    share = scratch[32 : 32 + 3 * parts * parts].reshape((3, parts * parts))
    count = 0
    for m in range(len(chosen)):
        k = chosen[m]
        row, column = places[k, 0], places[k, 1]
        known = True
        if with_good:
            for y in range(max(row - 2, 0), min(row + 3, good.shape[0])):
                for x in range(max(column - 2, 0), min(column + 3, good.shape[1])):
                    known = known and good[y, x]
        for c in range(3):
            known = known and lobe_through(radiance, row, column, c, lobe)
            if not known:
                break
            total = 0.0
            for part in range(parts * parts):
                u = (part % parts + 0.5) / parts - 0.5
                v = (part // parts + 0.5) / parts - 0.5
                bright = math.exp(
                    lobe[0] * u + lobe[1] * v + 0.5 * (lobe[2] * u * u + lobe[3] * v * v) + lobe[4] * u * v
                )
                share[c, part] = bright
                total += bright
            base = lobe[5] / radiance[row, column, c]
            for part in range(parts * parts):
                share[c, part] = base + (1.0 - base) * share[c, part] * parts * parts / total
        if not known:
            continue
        for part in range(parts * parts):
            u = (part % parts + 0.5) / parts - 0.5
            v = (part // parts + 0.5) / parts - 0.5
            length = 0.0
            for axis in range(3):
                normal[axis] = normals[k, axis] + u * slopes[k, axis] + v * slopes[k, 3 + axis]
                length += normal[axis] ** 2
            length = 1.0 / math.sqrt(length)
            away = 0.0
            for axis in range(3):
                normal[axis] *= length
                point[axis] = points[k, axis] + radius * (normal[axis] - normals[k, axis])
                away += point[axis] ** 2
            away = 1.0 / math.sqrt(away)
            cosine = 0.0
            for axis in range(3):
                view[axis] = -point[axis] * away
                cosine += view[axis] * normal[axis]
            length = 0.0
            for axis in range(3):
                tangent[axis] = view[axis] - cosine * normal[axis]
                length += tangent[axis] ** 2
            if length > 1e-20:
                length = 1.0 / math.sqrt(length)
                for axis in range(3):
                    tangent[axis] *= length
            else:
                for axis in range(3):
                    tangent[axis] = tangents[k, axis]
            received = reading(point, normal, tangent, view, light, profile, scratch)
            if received <= 0.0 or scratch[2] < least:
                continue
            for c in range(3):
                wi[count, c], wo[count, c], half_angle[count, c] = scratch[c], scratch[3 + c], scratch[6 + c]
                scale = share[c, part] / (received * irradiance[c])
                value[count, c] = radiance[row, column, c] * scale
                if with_noise:
                    noise[count, c] = variance[row, column, c] * scale * scale
            index[count] = k
            count += 1
    return count
