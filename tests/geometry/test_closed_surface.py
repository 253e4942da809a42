"""Which triangles bound solids that are wound outward."""

from __future__ import annotations

import numpy as np
import pytest
from meshes.forms import speed_form, sphere

from brdf_suite.geometry.closed_surface import is_closed_outward

CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], np.float32)
SIDES = np.array(
    [
        [0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
        [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3],
    ]
)  # fmt: skip


def test_a_cube_anywhere_and_of_any_size_is_a_solid():
    for scale, shift in ((1.0, 0.0), (1e-3, 5e-3), (300.0, -700.0)):
        assert is_closed_outward(CUBE * np.float32(scale) + np.float32(shift), SIDES)


def test_vertices_of_their_own_for_each_side_are_merged():
    assert is_closed_outward(CUBE[SIDES.ravel()], np.arange(36).reshape(-1, 3))


@pytest.mark.parametrize("missing", range(12))
def test_a_hole_is_found(missing):
    assert not is_closed_outward(CUBE, np.delete(SIDES, missing, axis=0))


def test_one_triangle_wound_otherwise_is_found():
    mixed = SIDES.copy()
    mixed[3] = mixed[3][::-1]
    assert not is_closed_outward(CUBE, mixed)


def test_every_solid_must_be_wound_outward():
    # The larger one outweighs the one that is inside out.
    both = np.concatenate([CUBE * 5, CUBE - 3])
    assert is_closed_outward(both, np.concatenate([SIDES, SIDES + 8]))
    assert not is_closed_outward(both, np.concatenate([SIDES, SIDES[:, ::-1] + 8]))


def test_a_point_is_no_solid():
    assert not is_closed_outward(np.zeros((3, 3), np.float32), np.array([[0, 1, 2]]))


@pytest.mark.parametrize("form", [speed_form, sphere])
def test_shipped_forms_are_solids(form):
    parts = form().parts
    assert all(is_closed_outward(part.positions, part.triangles) for part in parts)
