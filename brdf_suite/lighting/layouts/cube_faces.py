"""Cube faces from an unfolded image, and look-up in them without seams.

Faces are kept in the order right, left, up, down, front, back; each upright as seen from inside, up with the
front at its lower edge, down with the front at its upper edge.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from brdf_suite.lighting.layouts.detect import face_size
from brdf_suite.lighting.layouts.names import Layout

# Direction of a face's pixel: axis + a·across + b·down; a to the right and b downwards in -1…1. Right of the
# front (+z) is -x.
_AXIS = np.array([[-1, 0, 0], [1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], np.float64)
_ACROSS = np.array([[0, 0, -1], [0, 0, 1], [-1, 0, 0], [-1, 0, 0], [-1, 0, 0], [1, 0, 0]], np.float64)
_DOWN = np.array([[0, -1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1], [0, -1, 0], [0, -1, 0]], np.float64)

# Row and column of each face in the unfolded cubes, and whether it lies upside down there.
_PLACES: dict[Layout, tuple[tuple[int, int, bool], ...]] = {
    "horizontal_cross": (
        (1, 2, False),
        (1, 0, False),
        (0, 1, False),
        (2, 1, False),
        (1, 1, False),
        (1, 3, False),
    ),
    "vertical_cross": (
        (1, 2, False),
        (1, 0, False),
        (0, 1, False),
        (2, 1, False),
        (1, 1, False),
        (3, 1, True),
    ),
    "horizontal_strip": tuple((0, column, False) for column in range(6)),
    "vertical_strip": tuple((row, 0, False) for row in range(6)),
}


def cut_faces(pixels: NDArray[np.float32], layout: Layout) -> NDArray[np.float32]:
    """Return the faces (6, F, F, 3) of an unfolded cube (h, w, 3)."""
    size = face_size(layout, pixels.shape[1])
    if layout == "exr_cube":
        return _exr_faces(pixels.reshape(6, size, size, 3))
    faces = np.empty((6, size, size, 3), np.float32)
    for face, (row, column, turned) in enumerate(_PLACES[layout]):
        cut = pixels[row * size : (row + 1) * size, column * size : (column + 1) * size]
        faces[face] = cut[::-1, ::-1] if turned else cut
    return faces


def look_up(faces: NDArray[np.float32], directions: NDArray[np.float64]) -> NDArray[np.float32]:
    """Return radiance (n, 3) along directions (n, 3), bilinear, also over the edges of the cube."""
    size = faces.shape[1]
    bordered = _with_borders(faces)
    face, across, down = _project(directions)
    column = (across + 1.0) * (0.5 * size) + 0.5  # in the bordered face, whose first texel lies outside
    row = (down + 1.0) * (0.5 * size) + 0.5
    i = np.clip(np.floor(column).astype(np.int64), 0, size)
    j = np.clip(np.floor(row).astype(np.int64), 0, size)
    fi = (column - i).astype(np.float32)[:, None]
    fj = (row - j).astype(np.float32)[:, None]
    top = bordered[face, j, i] * (1.0 - fi) + bordered[face, j, i + 1] * fi
    bottom = bordered[face, j + 1, i] * (1.0 - fi) + bordered[face, j + 1, i + 1] * fi
    result: NDArray[np.float32] = top * (1.0 - fj) + bottom * fj
    return result


def _project(
    directions: NDArray[np.float64],
) -> tuple[NDArray[np.int64], NDArray[np.float64], NDArray[np.float64]]:
    """Return the face (n,) that each direction meets, and its place on it, -1…1 to the right and down."""
    largest = np.abs(directions).argmax(axis=1)
    positive = np.take_along_axis(directions, largest[:, None], axis=1)[:, 0] > 0.0
    face = np.where(positive, np.array([1, 2, 4])[largest], np.array([0, 3, 5])[largest])
    depth = np.abs(np.take_along_axis(directions, largest[:, None], axis=1)[:, 0])
    across = np.einsum("nk,nk->n", directions, _ACROSS[face]) / depth
    down = np.einsum("nk,nk->n", directions, _DOWN[face]) / depth
    return face, across, down


def _with_borders(faces: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the faces (6, F+2, F+2, 3) with a border of the texels beyond each edge, from its neighbours."""
    size = faces.shape[1]
    bordered = np.zeros((6, size + 2, size + 2, 3), np.float32)
    bordered[:, 1:-1, 1:-1] = faces
    centres = (2.0 * np.arange(-1, size + 1) + 1.0) / size - 1.0
    rim = np.zeros((size + 2, size + 2), bool)
    rim[[0, -1]] = rim[:, [0, -1]] = True
    rows, columns = np.nonzero(rim)
    for face in range(6):
        directions = _AXIS[face] + centres[columns, None] * _ACROSS[face] + centres[rows, None] * _DOWN[face]
        there, across, down = _project(directions)
        i = np.clip(((across + 1.0) * 0.5 * size).astype(np.int64), 0, size - 1)
        j = np.clip(((down + 1.0) * 0.5 * size).astype(np.int64), 0, size - 1)
        bordered[face, rows, columns] = faces[there, j, i]
    return bordered


def _exr_faces(stored: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return faces in our order and orientation from those of an OpenEXR cube map (6, F, F, 3).

    OpenEXR's faces are +X, -X, +Y, -Y, +Z, -Z with pixel centres on the cube's edges; the place of a direction
    on each is that of ImfEnvmap (OpenEXR technical documentation, "Environment maps").
    """
    size = stored.shape[1]
    faces = np.empty_like(stored)
    centres = (2.0 * np.arange(size) + 1.0) / size - 1.0
    for face in range(6):
        directions = (
            _AXIS[face] + centres[None, :, None] * _ACROSS[face] + centres[:, None, None] * _DOWN[face]
        )
        directions = directions / np.abs(directions).max(axis=-1, keepdims=True)
        x, y, z = (((directions[..., k] + 1.0) / 2.0 * (size - 1)) for k in range(3))
        last = size - 1
        row_column = {
            1: (last - y, z),  # +X
            0: (last - y, last - z),  # -X
            2: (last - z, x),  # +Y
            3: (z, x),  # -Y
            4: (last - y, last - x),  # +Z
            5: (last - y, x),  # -Z
        }[face]
        which = {1: 0, 0: 1, 2: 2, 3: 3, 4: 4, 5: 5}[face]
        faces[face] = _bilinear(stored[which], *row_column)
    return faces


def _bilinear(
    image: NDArray[np.float32], row: NDArray[np.float64], column: NDArray[np.float64]
) -> NDArray[np.float32]:
    last = image.shape[0] - 1
    j = np.clip(np.floor(row).astype(np.int64), 0, max(last - 1, 0))
    i = np.clip(np.floor(column).astype(np.int64), 0, max(last - 1, 0))
    fj = (row - j).astype(np.float32)[..., None]
    fi = (column - i).astype(np.float32)[..., None]
    top = image[j, i] * (1.0 - fi) + image[j, i + 1] * fi
    bottom = image[j + 1, i] * (1.0 - fi) + image[j + 1, i + 1] * fi
    result: NDArray[np.float32] = top * (1.0 - fj) + bottom * fj
    return result
