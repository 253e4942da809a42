"""The sphere that a file with a scene shows a paint on."""

from __future__ import annotations

import numpy as np

from brdf_suite.geometry.directions import spherical

RADIUS_M = 0.1


def unit_sphere(
    rings: int, sectors: int
) -> tuple[
    np.ndarray[tuple[int, int], np.dtype[np.float32]], np.ndarray[tuple[int, int], np.dtype[np.uint16]]
]:
    """Return unit vectors (n, 3), which are places and normals, and triangles (k, 3) facing outwards; y is up."""
    theta, phi = np.meshgrid(
        np.linspace(0.0, np.pi, rings + 1), np.linspace(0.0, 2.0 * np.pi, sectors + 1), indexing="ij"
    )
    # The frame of directions has z up; (x, y, z) to (x, z, -y) turns it without mirroring.
    up_z = spherical(theta.ravel(), phi.ravel())
    vertices = np.stack((up_z[:, 0], up_z[:, 2], -up_z[:, 1]), axis=-1).astype(np.float32)
    first = (np.arange(rings)[:, None] * (sectors + 1) + np.arange(sectors)).ravel()
    below = first + sectors + 1
    # The first triangle of a quad is none at the upper pole, the second at the lower.
    triangles = np.concatenate(
        (
            np.stack((first, below, first + 1), axis=-1)[sectors:],
            np.stack((first + 1, below, below + 1), axis=-1)[:-sectors],
        )
    )
    return vertices, triangles.astype(np.uint16)
