"""The speed form: a hand-sized drop, 36 cm long, on which stylists judge a paint.

A sphere is stretched along ``z`` (nose at +z) and shaped by smooth functions of two parameters, the polar
angle from the nose and the angle around the axis. What an eye looks for in a paint is all there: a crown that
light runs along, a rounded nose, a tapering tail, a crisp but rounded character line along the flank that
fades towards the nose, and below it a hollow that turns into a full sill.

Every ingredient has continuous curvature. At nose and tail, where the angle around the axis has no meaning,
what makes a section other than an ellipse fades with the square of the section's radius or faster, so that
the curvature is continuous there too. Reflections therefore flow without a kink.
"""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.surface.mesh import Mesh, PartGeometry
from meshes.forms.grid import grid_normals, grid_triangles, lengths_along, smooth_step, with_area

ROWS, COLUMNS_ABOVE, COLUMNS_BELOW = 172, 48, 76

# Millimetres and radians; t is +1 at the nose and -1 at the tail.
_HALF_LENGTH = 180.0
_LINE_RADIUS = 0.030
_LINE_CLUSTER, _LINE_DENSITY = 0.06, 6.0


def line_elevation(t: Floats) -> Floats:
    """Return where the character line is: its angle above the widest place of the section, radians."""
    return np.asarray(0.471 - 0.10 * t - 0.12 * t * t)


def speed_form_point(polar: Floats, around: Floats) -> Floats:
    """Return points (..., 3), millimetres.

    Parameters
    ----------
    polar
        Angle from the nose, 0 to π.
    around
        Angle about the axis, 0 at the +x side, π/2 at the crown, -π/2 and 3π/2 below.
    """
    t, radius = np.cos(polar), np.sin(polar)
    cosine, sine = np.cos(around), np.sin(around)
    body = 1.0 - t**8  # 0 at nose and tail: sections are ellipses there
    half_width = 80.0 * (1.0 + 0.27 * t - 0.20 * t * t)
    above = 74.0 * (1.0 + 0.10 * t - 0.22 * t * t)
    below = 33.0 * (1.0 - 0.05 * t)
    height = 0.5 * (above + below) + body * (above - below) * (smooth_step(sine, -0.6, 0.6) - 0.5)
    middle = 36.0 + 14.0 * smooth_step(-t, 0.0, 1.15) - 9.0 * smooth_step(t, 0.1, 1.2)
    # Towards the superellipse of degree four: fuller shoulders, and a fuller sill.
    square = (cosine**4 + sine**4) ** -0.25 - 1.0
    fullness = 1.0 + body * (0.40 - 0.20 * smooth_step(sine, -0.5, 0.6)) * square
    tumblehome = 1.0 - 0.12 * body * smooth_step(sine, 0.0, 1.2)
    cut = _character_line(t, sine)
    x = half_width * radius * cosine * fullness * tumblehome * (1.0 + cut)
    y = middle + height * radius * sine * fullness * (1.0 + 0.3 * cut)
    return np.stack([x, y, _HALF_LENGTH * t], axis=-1)


def _character_line(t: Floats, sine: Floats) -> Floats:
    """Return how far the section is drawn in, relative to its radius, on both sides of the line.

    On each side a ramp begins at the line, with a rounded start, and runs out: a shallow one above, a deep one
    below that makes the hollow.
    """
    strength = smooth_step(t, -1.02, -0.30) * (1.0 - smooth_step(t, 0.28, 0.97))
    from_line = np.arcsin(np.clip(sine, -1.0, 1.0)) - line_elevation(t)
    upper = 0.16 * _ramp(from_line) * _window(from_line, 0.95)
    lower = 0.56 * _ramp(-from_line) * _window(from_line, 1.40)
    return np.asarray(-strength * (upper + lower))


def _ramp(x: Floats) -> Floats:
    """Return max(0, x) with its corner rounded."""
    return np.asarray(0.5 * (np.sqrt(x * x + _LINE_RADIUS**2) + x))


def _window(x: Floats, width: float) -> Floats:
    return np.asarray((1.0 - np.minimum((x / width) ** 2, 1.0)) ** 4)


def _elevations(t: Floats) -> Floats:
    """Return the angles of one side's columns, from below to the crown, (rows, columns).

    One column runs along the character line, and they crowd towards it as its small radius needs.
    """
    line = line_elevation(t)[:, None]

    def spread(distance: Floats) -> Floats:
        return np.asarray(distance + _LINE_DENSITY * _LINE_CLUSTER * np.arctan(distance / _LINE_CLUSTER))

    def distances(limit: Floats, count: int) -> Floats:
        wanted = spread(limit) * np.linspace(0.0, 1.0, count + 1)
        low, high = np.zeros_like(wanted), np.broadcast_to(limit, wanted.shape)
        for _ in range(50):
            middle = 0.5 * (low + high)
            beyond = spread(middle) > wanted
            low, high = np.where(beyond, low, middle), np.where(beyond, middle, high)
        result = 0.5 * (low + high)
        result[:, 0], result[:, -1] = 0.0, limit[:, 0]
        return result

    up = line + distances(0.5 * np.pi - line, COLUMNS_ABOVE)
    down = line - distances(0.5 * np.pi + line, COLUMNS_BELOW)
    return np.concatenate([down[:, :0:-1], up], axis=1)


def speed_form_grid() -> tuple[Floats, Floats]:
    """Return the angles ``polar`` and ``around`` of the mesh's vertices, (rows, columns) each."""
    polar = np.linspace(0.0, np.pi, ROWS + 1)
    right = _elevations(np.cos(polar))
    around = np.concatenate([right, np.pi - right[:, -2::-1]], axis=1)
    return np.broadcast_to(polar[:, None], around.shape), around


def speed_form() -> Mesh:
    """Return the speed form, 0.36 m long, nose along +z, standing on y = 0, one painted part.

    Texture coordinates are lengths on the surface: ``u`` along the body from its middle, ``v`` around it from
    the crown, so that areas keep their size, as flakes need.
    """
    polar, around = speed_form_grid()
    points = speed_form_point(polar, around)
    normals = np.zeros_like(points)
    normals[1:-1] = grid_normals(speed_form_point, polar[1:-1], around[1:-1])
    normals[0], normals[-1] = [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]
    crown = around.shape[1] // 2
    uvs = np.stack([lengths_along(points, 0, ROWS // 2), lengths_along(points, 1, crown)], axis=-1)
    points[..., 1] -= points[..., 1].min()
    flat = points.reshape(-1, 3)
    triangles = with_area(flat, grid_triangles(*around.shape))
    part = PartGeometry(
        "speed form", "paint", flat / 1000.0, normals.reshape(-1, 3), uvs.reshape(-1, 2), triangles
    )
    return Mesh("speed_form", (part,))
