"""Cube map directions against OpenGL's own table of the major axis."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.geometry.cube_map import texel_directions


def gl_look_up(direction: np.ndarray, size: int) -> tuple[int, int, int]:
    """Return face, row and column of a direction: OpenGL 3.3, section 3.8.10, table 3.19, word for word."""
    x, y, z = direction
    table = {
        "+x": (0, -z, -y, x),
        "-x": (1, z, -y, x),
        "+y": (2, x, z, y),
        "-y": (3, x, -z, y),
        "+z": (4, x, -y, z),
        "-z": (5, -x, -y, z),
    }
    axis = int(np.argmax(np.abs(direction)))
    face, sc, tc, ma = table[("+" if direction[axis] >= 0 else "-") + "xyz"[axis]]
    s, t = 0.5 * (sc / abs(ma) + 1.0), 0.5 * (tc / abs(ma) + 1.0)
    return face, int(t * size), int(s * size)


@given(st.sampled_from([1, 2, 6, 16]), st.data())
def test_texel_is_found_where_gl_looks(size: int, data: st.DataObject) -> None:
    face, row, column = (data.draw(st.integers(0, n - 1)) for n in (6, size, size))
    direction = texel_directions(size)[face, row, column]
    assert (
        np.linalg.norm(direction) == np.float64(1.0).astype(float)
        or abs(np.linalg.norm(direction) - 1) < 1e-12
    )
    assert gl_look_up(direction, size) == (face, row, column)
