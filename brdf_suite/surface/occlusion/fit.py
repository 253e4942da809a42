"""Least-squares vertex values whose interpolation approximates samples on the triangles.

Least squares with a gradient penalty (Kavan, Bargteil and Sloan 2011, "Least squares vertex baking"):

    minimize  Σ_s a_s (Σ_k b_sk x_k - y_s)² + λ Σ_t min(A_t, A) ∫_t |∇x|² dA

over the values x, with b the barycentric weights of place s, a_s the surface it represents and A_t the area of
triangle t: noise is smoothed over about √λ of a triangle's width, and never over more than √A. Places that see
no light at all cannot be seen either: they hardly count, so that the dark inside a body does not bleed along
triangles that reach into it.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy import sparse

from brdf_suite.arrays import Floats, Integers, Singles
from brdf_suite.surface.occlusion.places import Places

SMOOTHING = 0.5
_SMOOTHED = 0.01
"""√A as a share of the mesh's size: 4 cm on a car."""
_UNSEEN = 1e-3
_STEPS = 60
_TOLERANCE = 1e-3


def shared_places(positions: Singles, normals: Singles) -> Integers:
    """Number the vertices, equal where position and normal agree: seams of texture coordinates share a value."""
    size = float(np.ptp(positions, axis=0).max()) or 1.0
    cells = np.round((positions - positions.min(axis=0)) / (size * 1e-6)).astype(np.int64)
    turned = np.round(normals * 500.0).astype(np.int64)
    key = np.zeros(len(positions), np.uint64)
    for column in (*cells.T, *turned.T):
        # A 64-bit mixer: two of a million vertices agree by chance once in 10⁷ meshes.
        key ^= column.astype(np.uint64) + np.uint64(0x9E3779B97F4A7C15) + (key << np.uint64(6))
        key *= np.uint64(0xBF58476D1CE4E5B9)
        key ^= key >> np.uint64(29)
    return np.unique(key, return_inverse=True)[1].reshape(-1)


def vertex_values(
    positions: Singles,
    triangles: Integers,
    shared: Integers,
    places: Places,
    seen: Singles,
    smoothing: float = SMOOTHING,
) -> Floats:
    """Return (n, c) values at the vertices from those at places, ``seen`` (m, c), the first being a share of light.

    ``shared`` (n,) are the numbers of :func:`shared_places`.
    """
    count = int(shared.max()) + 1
    corner = shared[triangles[places.triangle]]
    weight = places.area * np.where(seen[:, 0] > 0.0, 1.0, _UNSEEN)
    rows = np.repeat(np.arange(len(corner)), 3)
    spread = sparse.csr_array(
        (places.weights.reshape(-1), (rows, corner.reshape(-1))), shape=(len(corner), count)
    )
    weighted = (sparse.diags_array(weight) @ spread).T.tocsr()
    matrix = weighted @ spread + smoothing * _stiffness(positions, triangles, shared, count)
    # A vertex without a place and without an area stays 0 instead of making the matrix singular.
    matrix = (matrix + sparse.eye_array(count) * (1e-9 * matrix.diagonal().max())).tocsr()
    return _solve(matrix, weighted @ seen.astype(np.float64))[shared]


def _stiffness(positions: Singles, triangles: Integers, shared: Integers, count: int) -> Any:
    """Return Σ min(A_t, A) ∫|∇x|² as a matrix.

    With e_i the edge opposite to corner i, ∫∇b_i·∇b_j = e_i·e_j / 4A_t.
    """
    corners = positions[triangles].astype(np.float64)
    opposite = np.roll(corners, 1, axis=1) - np.roll(corners, -1, axis=1)
    values = np.einsum("tid,tjd->tij", opposite, opposite) / 4.0
    area = 0.5 * np.linalg.norm(np.cross(opposite[:, 0], opposite[:, 1]), axis=1)
    largest = (_SMOOTHED * float(np.ptp(positions, axis=0).max())) ** 2
    values *= (largest / np.maximum(area, largest))[:, None, None]
    number = shared[triangles]
    rows = np.broadcast_to(number[:, :, None], values.shape)
    columns = np.broadcast_to(number[:, None, :], values.shape)
    return sparse.csr_array(
        (values.reshape(-1), (rows.reshape(-1), columns.reshape(-1))), shape=(count, count)
    )


def _solve(matrix: Any, right: Floats) -> Floats:
    """Solve for all columns at once by conjugate gradients, preconditioned by the diagonal."""
    inverse = (1.0 / matrix.diagonal())[:, None]
    x = inverse * right
    residual = right - matrix @ x
    z = inverse * residual
    direction = z.copy()
    power = (residual * z).sum(axis=0)
    goal = _TOLERANCE**2 * (right * inverse * right).sum(axis=0)
    for _ in range(_STEPS):
        if (power <= goal).all():
            break
        image = matrix @ direction
        step = power / np.maximum((direction * image).sum(axis=0), 1e-300)
        x += step * direction
        residual -= step * image
        z = inverse * residual
        new = (residual * z).sum(axis=0)
        direction *= new / np.maximum(power, 1e-300)
        direction += z
        power = new
    return np.asarray(x)
