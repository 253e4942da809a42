"""Layouts of environment images, their detection by shape, and their conversion to a latitude-longitude map.

All images are taken as seen from inside, not mirrored, unless the layout is a probe or a mirror ball, which are seen
from outside. The middle of the front is +z, what is right of it is -x, as in the suite's latitude-longitude maps; the
middle of a probe and of a mirror ball is -z. There all directions opposite to the middle share the rim, and the default
camera looks towards -z, so the rim lies behind it.

Cube faces are kept in the order right, left, up, down, front, back; each upright as seen from inside, up with the
front at its lower edge, down with the front at its upper edge.

Of the images that are a disc, for a direction d of unit length, the place in the disc of radius 1 (to the right, up):

- angular map (light probe): r = acos(-d_z)/π along (-d_x, d_y); P. Debevec, "Rendering Synthetic Objects into
  Real Scenes", SIGGRAPH 1998, and the page of his light probe gallery, whose middle is (0, 0, -1). It is what a mirror
  ball shows, evened out, so it is seen from outside as that is: -x is right.
- mirror ball, orthographic, the camera at -z: the place is the ball's normal there, halfway between d and -z.
- dome: r = acos(d_y)/(π/2) about the zenith, the front (+z) below, -x at the right: a fisheye picture taken
  upwards. What is below the horizon is black.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.view import ImageLayout
from brdf_suite.errors import ValueRangeError
from brdf_suite.lighting.latlong import column_angles, direction, ring_angles
from brdf_suite.progress import Progress, report

Layout = ImageLayout

LAYOUTS: Mapping[Layout, str] = MappingProxyType(
    {
        "latlong": "latitude-longitude map, twice as wide as high",
        "horizontal_cross": "cube unfolded to 4 × 3 faces: left, front, right, back; up and down at the front",
        "vertical_cross": "cube unfolded to 3 × 4 faces: left, front, right; up above, down and back (turned) below",
        "horizontal_strip": "six faces side by side: right, left, up, down, front, back",
        "vertical_strip": "six faces one below the other, in the same order",
        "exr_cube": "six faces one below the other as OpenEXR's cube maps have them",
        "angular": "light probe: the angle from the middle (-z) grows evenly with the radius",
        "mirror_ball": "photograph of a mirror ball from far away, the camera at -z",
        "dome": "fisheye of the upper half: the zenith in the middle, the horizon at the rim, the front below",
    }
)


MIN_HEIGHT = 4
_LEAST_FACE = 2
# Columns and rows of faces.
_FACES: dict[Layout, tuple[int, int]] = {
    "horizontal_cross": (4, 3),
    "vertical_cross": (3, 4),
    "horizontal_strip": (6, 1),
    "vertical_strip": (1, 6),
    "exr_cube": (1, 6),
}
_ROUND = ("angular", "mirror_ball", "dome")


def detect_layout(width: int, height: int) -> tuple[Layout, tuple[str, ...]]:
    """Return the layout of an image of ``width`` × ``height`` pixels, and what was assumed.

    A latitude-longitude map may miss twice its height by a pixel. A square image is taken as a light probe
    (angular map), because nothing in its shape distinguishes a mirror ball or a dome from one; the note says so.

    >>> detect_layout(1024, 768)[0]
    'horizontal_cross'

    Raises
    ------
    ValueRangeError
        No layout has this shape, or the image is too small for one.
    """
    if abs(width - 2 * height) <= 1 and height >= MIN_HEIGHT:
        return "latlong", ()
    for layout, (columns, rows) in _FACES.items():
        if width * rows == height * columns and width >= columns * _LEAST_FACE:
            return layout, (f"its shape is that of a {layout.replace('_', ' ')} of cube faces",)
    if width == height and height >= 2 * MIN_HEIGHT:
        note = "a square image is taken as a light probe (angular); a mirror ball or a dome must be named"
        return "angular", (note,)
    shapes = "2:1 (latitude-longitude), 4:3 or 3:4 (cross), 6:1 or 1:6 (strip), 1:1 (light probe)"
    raise ValueRangeError(
        "layout", f"cannot be determined: {width} × {height} pixels; the shapes that are read are {shapes}"
    )


def check_shape(layout: Layout, width: int, height: int) -> None:
    """Raise :class:`ValueRangeError` where an image of this shape cannot have the layout."""
    if layout == "latlong":
        sound, wanted = abs(width - 2 * height) <= 1 and height >= MIN_HEIGHT, "twice as wide as high"
    elif layout in _ROUND:
        sound, wanted = width == height and height >= 2 * MIN_HEIGHT, "square"
    else:
        columns, rows = _FACES[layout]
        sound = width * rows == height * columns and width >= columns * _LEAST_FACE
        wanted = f"{columns} × {rows} square faces"
    if not sound:
        size = f"{width} × {height} pixels"
        raise ValueRangeError("layout", f"is {layout}, which must be {wanted}, but the image is {size}")


def face_size(layout: Layout, width: int) -> int:
    """Return the pixels along a face of a cube layout."""
    return width // _FACES[layout][0]


# Direction of a face's pixel: axis + a·across + b·down; a to the right and b downwards in -1…1. Right of the
# front (+z) is -x.
_AXIS = np.array([[-1, 0, 0], [1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], np.float64)
_ACROSS = np.array([[0, 0, -1], [0, 0, 1], [-1, 0, 0], [-1, 0, 0], [-1, 0, 0], [1, 0, 0]], np.float64)
_DOWN = np.array([[0, -1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1], [0, -1, 0], [0, -1, 0]], np.float64)

# Row and column of each face in the unfolded cubes, and whether it lies upside down there.
_PLACES: dict[Layout, tuple[tuple[int, int, bool], ...]] = {
    "horizontal_cross": tuple((*at, False) for at in ((1, 2), (1, 0), (0, 1), (2, 1), (1, 1), (1, 3))),
    "vertical_cross": (*((*at, False) for at in ((1, 2), (1, 0), (0, 1), (2, 1), (1, 1))), (3, 1, True)),
    "horizontal_strip": tuple((0, column, False) for column in range(6)),
    "vertical_strip": tuple((row, 0, False) for row in range(6)),
}


def _cut_faces(pixels: NDArray[np.float32], layout: Layout) -> NDArray[np.float32]:
    """Return the faces (6, F, F, 3) of an unfolded cube (h, w, 3)."""
    size = face_size(layout, pixels.shape[1])
    if layout == "exr_cube":
        return _exr_faces(pixels.reshape(6, size, size, 3))
    faces = np.empty((6, size, size, 3), np.float32)
    for face, (row, column, turned) in enumerate(_PLACES[layout]):
        cut = pixels[row * size : (row + 1) * size, column * size : (column + 1) * size]
        faces[face] = cut[::-1, ::-1] if turned else cut
    return faces


def _look_up_faces(faces: NDArray[np.float32], directions: NDArray[np.float64]) -> NDArray[np.float32]:
    """Return radiance (n, 3) along directions (n, 3), bilinear, also over the edges of the cube."""
    size = faces.shape[1]
    bordered = _with_borders(faces)
    face, across, down = _project(directions)
    column = (across + 1.0) * (0.5 * size) + 0.5  # in the bordered face, whose first texel lies outside
    row = (down + 1.0) * (0.5 * size) + 0.5
    result = np.empty((len(directions), 3), np.float32)
    for number, image in enumerate(bordered):
        here = face == number
        result[here] = _bilinear(image, row[here], column[here])
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
        # The stored face, and the row and column in it: -X, +X, +Y, -Y, +Z, -Z.
        which, row, column = (
            (1, last - y, last - z),
            (0, last - y, z),
            (2, last - z, x),
            (3, z, x),
            (4, last - y, last - x),
            (5, last - y, x),
        )[face]
        faces[face] = _bilinear(stored[which], row, column)
    return faces


def _bilinear(
    image: NDArray[np.float32], row: NDArray[np.float64], column: NDArray[np.float64]
) -> NDArray[np.float32]:
    """Return (..., 3) of an image (n, n, 3) at places in steps from the centre of its first texel."""
    j, i = (np.clip(np.floor(place).astype(np.int64), 0, len(image) - 2) for place in (row, column))
    fj, fi = (row - j).astype(np.float32)[..., None], (column - i).astype(np.float32)[..., None]
    top = image[j, i] * (1.0 - fi) + image[j, i + 1] * fi
    bottom = image[j + 1, i] * (1.0 - fi) + image[j + 1, i + 1] * fi
    result: NDArray[np.float32] = top * (1.0 - fj) + bottom * fj
    return result


_TINY = 1e-12


def _look_up_disc(
    pixels: NDArray[np.float32], directions: NDArray[np.float64], layout: Layout
) -> NDArray[np.float32]:
    """Return radiance (n, 3) of a square image (h, h, 3) along unit directions (n, 3), bilinear."""
    right, up = {"angular": _angular, "mirror_ball": _mirror_ball, "dome": _dome}[layout](directions)
    size = pixels.shape[0]
    # The rim of a disc is cut by the corners of the square: places outside are held at the rim's texels.
    column = np.clip((right + 1.0) * (0.5 * size) - 0.5, 0.0, size - 1.0)
    row = np.clip((1.0 - up) * (0.5 * size) - 0.5, 0.0, size - 1.0)
    result = _bilinear(pixels, row, column)
    if layout == "dome":
        result[directions[:, 1] < 0.0] = 0.0
    return result


def _angular(d: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    across = np.hypot(d[:, 0], d[:, 1])
    # arctan2 keeps what arccos loses near the middle and opposite to it.
    radius = np.arctan2(across, -d[:, 2]) / np.pi
    scale = radius / np.maximum(across, _TINY)
    return _inside(-d[:, 0] * scale, d[:, 1] * scale, radius)


def _mirror_ball(d: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    # |d - z| = √(2 - 2 d_z); straight behind the ball every point of the rim shows the same.
    length = np.sqrt(np.maximum(2.0 - 2.0 * d[:, 2], _TINY))
    right, up = -d[:, 0] / length, d[:, 1] / length
    return _inside(right, up, np.hypot(right, up))


def _dome(d: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    across = np.hypot(d[:, 0], d[:, 2])
    radius = np.arctan2(across, d[:, 1]) / (0.5 * np.pi)
    scale = radius / np.maximum(across, _TINY)
    return _inside(-d[:, 0] * scale, -d[:, 2] * scale, radius)


def _inside(
    right: NDArray[np.float64], up: NDArray[np.float64], radius: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return places no farther than the rim."""
    shrink = 1.0 / np.maximum(radius, 1.0)
    return right * shrink, up * shrink


_MIN_HEIGHT = 8
_MAX_HEIGHT = 4096
# Samples along a side of a texel, and rows done at a time: about 30 MB of directions for a 4k map.
_SAMPLES = 2
_STRIP = 32


def as_latlong(
    pixels: NDArray[np.float32], layout: Layout, progress: Progress | None = None
) -> NDArray[np.float32]:
    """Return a latitude-longitude map (H, 2H, 3) float32 of an image (h, w, 3) in another layout.

    H is two faces of a cube, the diameter of a probe, or two diameters of a dome (whose picture is half the
    sphere), so that nothing of the image is lost; at most 4,096. Each texel is the mean of four bilinear samples.
    A latitude-longitude map is returned as it is.

    >>> as_latlong(np.ones((96, 128, 3), np.float32), "horizontal_cross").shape
    (64, 128, 3)

    Raises
    ------
    ValueRangeError
        The image cannot have this layout; the message says what it should look like.
    """
    rows, columns = pixels.shape[:2]
    check_shape(layout, columns, rows)
    if layout == "latlong":
        return pixels
    if layout in ("angular", "mirror_ball", "dome"):
        natural = 2 * rows if layout == "dome" else rows
        faces = None
    else:
        natural = 2 * face_size(layout, columns)
        faces = _cut_faces(pixels, layout)
    height = int(np.clip(natural, _MIN_HEIGHT, _MAX_HEIGHT))
    theta, phi = ring_angles(height * _SAMPLES), column_angles(2 * height * _SAMPLES)
    result = np.empty((height, 2 * height, 3), np.float32)
    for first in range(0, height, _STRIP):
        report(progress, first / height, "laying the environment out")
        last = min(first + _STRIP, height)
        towards = direction(theta[first * _SAMPLES : last * _SAMPLES, None], phi[None, :])
        flat = towards.reshape(-1, 3)
        along = _look_up_disc(pixels, flat, layout) if faces is None else _look_up_faces(faces, flat)
        cells = along.reshape(last - first, _SAMPLES, 2 * height, _SAMPLES, 3)
        result[first:last] = cells.mean(axis=(1, 3))
    return result
