"""The mesh value refuses what no renderer could draw, and names part and place."""

from __future__ import annotations

from dataclasses import FrozenInstanceError, replace

import numpy as np
import pytest

from brdf_suite.errors import SuiteError
from brdf_suite.surface.mesh import MATERIALS, Mesh, PartGeometry


def facet(**changes: object) -> PartGeometry:
    values: dict[str, object] = {
        "name": "door",
        "material": "paint",
        "positions": np.array([[0.0, 0, 0], [2, 0, 0], [0, 3, 0], [9, 9, 9]]),
        "normals": np.tile([0.0, 0.0, 1.0], (4, 1)),
        "uvs": np.zeros((4, 2)),
        "triangles": np.array([[0, 1, 2]]),
    }
    return PartGeometry(**(values | changes))  # type: ignore[arg-type]  # wrong values are the point


def test_arrays_become_the_stated_types_and_cannot_be_written() -> None:
    part = facet()
    kinds = [part.positions.dtype, part.normals.dtype, part.uvs.dtype, part.triangles.dtype]
    assert kinds == [np.float32, np.float32, np.float32, np.uint32]
    with pytest.raises(ValueError, match="read-only"):
        part.positions[0, 0] = 1.0
    with pytest.raises(FrozenInstanceError):
        part.name = "bonnet"  # type: ignore[misc]  # frozen is the point


def test_the_callers_array_stays_writeable() -> None:
    positions = np.zeros((4, 3), np.float32)
    facet(positions=positions)
    positions[0, 0] = 1.0


@pytest.mark.parametrize(
    ("changes", "place"),
    [
        ({"positions": np.zeros((4, 2))}, "positions"),
        ({"positions": np.array([[0, 0, 0], [1, 0, np.nan], [0, 1, 0], [1, 1, 1.0]])}, r"positions\[1\]"),
        ({"normals": np.zeros((4, 3))}, r"normals\[0\]"),
        ({"normals": np.tile([0.0, 0.0, 1.0], (3, 1))}, "positions"),
        ({"positions": np.full((4, 3), 1e300)}, r"positions\[0\]"),
        ({"uvs": np.full((4, 2), np.inf)}, r"uvs\[0\]"),
        ({"uvs": np.array([["a", "b"]] * 4)}, "uvs"),
        ({"triangles": np.array([[0, 1, 4]])}, r"triangles\[0\]"),
        ({"triangles": np.array([[0, 1, -1]])}, r"triangles\[0\]"),
        ({"triangles": np.array([[0.0, 1.0, 2.0]])}, "triangles"),
        ({"triangles": np.zeros((0, 3), int)}, "triangles"),
        ({"material": "wood"}, "material"),
    ],
)
def test_a_wrong_value_names_the_part_and_the_place(changes: dict[str, object], place: str) -> None:
    with pytest.raises(SuiteError, match=rf"part 'door', {place}:"):
        facet(**changes)


def test_bounds_leave_out_vertices_that_no_triangle_uses() -> None:
    low, high = Mesh("two", (facet(), facet(name="wing", positions=facet().positions - 1.0))).bounds()
    np.testing.assert_array_equal(low, [-1, -1, -1])
    np.testing.assert_array_equal(high, [2, 3, 0])


def test_a_mesh_needs_a_part() -> None:
    with pytest.raises(SuiteError, match="no part"):
        Mesh("empty", ())


def test_every_material_word_is_accepted() -> None:
    mesh = Mesh("all", tuple(replace(facet(), material=word) for word in MATERIALS))
    assert [part.material for part in mesh.parts] == list(MATERIALS)
    assert mesh.triangle_count == len(MATERIALS)
