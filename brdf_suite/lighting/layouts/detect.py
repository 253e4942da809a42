"""Detection of an environment image's layout from its shape, where it is not stated."""

from __future__ import annotations

from brdf_suite.errors import ValueRangeError
from brdf_suite.lighting.layouts.names import Layout

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
    raise ValueRangeError("layout", _no_layout(width, height))


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


def _no_layout(width: int, height: int) -> str:
    shapes = "2:1 (latitude-longitude), 4:3 or 3:4 (cross), 6:1 or 1:6 (strip), 1:1 (light probe)"
    return f"cannot be determined: {width} × {height} pixels; the shapes that are read are {shapes}"
