"""What a foreign part lacks is made, and said; what it has is kept."""

from __future__ import annotations

import tracemalloc

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from meshes.forms import sphere

from brdf_suite.surface.normals import corner_angles, corner_normals, face_normals, is_inside_out, weld
from brdf_suite.surface.repair import (
    RawPart,
    box_uvs,
    repair,
    repair_bytes,
    split_corners,
    stretch,
    uvs_in_millimetres,
)

CUBE = np.array([[x, y, z] for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
CUBE_TRIANGLES = np.array(
    [
        [0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
        [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3],
    ]
)  # fmt: skip


def ball() -> tuple[np.ndarray, np.ndarray]:
    part = sphere().parts[0]
    return part.positions.astype(np.float64), part.triangles.astype(np.int64)


def test_a_cube_keeps_its_edges_and_a_ball_loses_them() -> None:
    part, notes = repair(RawPart("cube", "paint", CUBE, CUBE_TRIANGLES))
    assert part is not None
    assert len(part.positions) == 24
    assert np.sort(np.abs(part.normals), axis=1)[:, 2] == pytest.approx(1.0)
    assert any("normals" in note for note in notes)
    positions, triangles = ball()
    round_part, _ = repair(RawPart("ball", "paint", positions, triangles))
    assert round_part is not None
    outwards = (round_part.positions - [0.0, 0.1, 0.0]) / 0.1
    assert np.einsum("ij,ij->i", outwards, round_part.normals).min() > 0.9999


def test_the_normal_of_a_corner_does_not_depend_on_how_its_sides_were_cut() -> None:
    # A cube's corner with a crease angle that joins everything: the diagonal, though sides have 1 or 2 triangles.
    corners = corner_normals(CUBE, CUBE_TRIANGLES, weld(CUBE), 100.0)
    expected = (CUBE[CUBE_TRIANGLES] - 0.5) / np.linalg.norm([0.5, 0.5, 0.5])
    np.testing.assert_allclose(corners, expected, atol=1e-12)


def test_a_body_inside_out_is_turned() -> None:
    assert not is_inside_out(CUBE, CUBE_TRIANGLES, weld(CUBE))
    assert is_inside_out(CUBE, CUBE_TRIANGLES[:, ::-1], weld(CUBE))
    assert not is_inside_out(CUBE, CUBE_TRIANGLES[1:, ::-1], weld(CUBE)), "an open surface has no inside"
    part, notes = repair(RawPart("cube", "paint", CUBE, CUBE_TRIANGLES[:, ::-1]))
    assert part is not None
    assert np.einsum("ij,ij->i", part.positions - 0.5, part.normals).min() > 0.0
    assert any("inside out" in note for note in notes)


def test_given_normals_are_kept_and_holes_in_them_filled() -> None:
    positions, triangles = ball()
    normals = (positions - [0.0, 0.1, 0.0]) * 70.0
    normals[5] = np.nan
    normals[9] = 0.0
    part, notes = repair(RawPart("ball", "paint", positions, triangles, normals, positions[:, :2]))
    assert part is not None
    exact = (part.positions - [0.0, 0.1, 0.0]) / 0.1
    assert np.einsum("ij,ij->i", exact, part.normals).min() > 0.9999
    assert any("made 2 normals" in note for note in notes)


def test_normals_that_are_no_use_are_made_afresh() -> None:
    part, notes = repair(RawPart("cube", "paint", CUBE, CUBE_TRIANGLES, np.zeros((8, 3))))
    assert part is not None
    assert any("had no normals" in note for note in notes)


def test_triangles_that_cannot_be_drawn_are_counted() -> None:
    positions = np.concatenate([CUBE, [[np.nan, 0, 0]]])
    extra = [[0, 1, 8], [0, 1, 99], [0, -1, 2], [3, 3, 4], [0, 0, 0]]
    part, notes = repair(RawPart("cube", "paint", positions, np.concatenate([CUBE_TRIANGLES, extra])))
    assert part is not None
    assert len(part.triangles) == 12
    text = " ".join(notes)
    assert "1 triangle with corners that are not finite" in text
    assert "2 triangles with corners that are not in the file" in text
    assert "2 triangles without area" in text


def test_nothing_left_gives_no_part_and_the_reason() -> None:
    part, notes = repair(RawPart("dust", "paint", np.full((3, 3), np.inf), np.array([[0, 1, 2]])))
    assert part is None
    assert "not finite" in notes[0]


def test_even_coordinates_are_scaled_to_millimetres() -> None:
    positions = np.array([[0.0, 0, 0], [0.5, 0, 0], [0.5, 0.5, 0], [0, 0.5, 0]])
    triangles = np.array([[0, 1, 2], [0, 2, 3]])
    uvs = uvs_in_millimetres(positions, triangles, positions[:, :2] * 0.037 + 0.4)
    assert uvs is not None
    smallest, largest, _ = stretch(positions, triangles, uvs)
    np.testing.assert_allclose([smallest, largest], 1000.0, rtol=1e-9)


@pytest.mark.parametrize("squeeze", [0.3, 0.0])
def test_uneven_coordinates_are_replaced(squeeze: float) -> None:
    positions = np.array([[0.0, 0, 0], [0.5, 0, 0], [0.5, 0.5, 0], [0, 0.5, 0]])
    triangles = np.array([[0, 1, 2], [0, 2, 3]])
    assert uvs_in_millimetres(positions, triangles, positions[:, :2] * [1.0, squeeze**2]) is None
    part, notes = repair(
        RawPart("wall", "paint", positions, triangles, None, positions[:, :2] * [1.0, squeeze**2])
    )
    assert part is not None
    np.testing.assert_allclose(np.ptp(part.uvs, axis=0), [500.0, 500.0])
    assert any("uneven" in note for note in notes)


def test_box_projection_stretches_by_at_most_root_three() -> None:
    positions, triangles = ball()
    uvs, kept, new = box_uvs(positions, triangles)
    smallest, largest, _ = stretch(positions[kept], new, uvs)
    assert largest.max() <= 1000.0 * (1.0 + 1e-9)
    assert smallest.min() >= 1000.0 / np.sqrt(3.0) * (1.0 - 1e-9)


@given(st.lists(st.floats(-5.0, 5.0), min_size=9, max_size=9))
def test_angles_of_a_triangle_sum_to_pi_and_its_normal_is_upright(values: list[float]) -> None:
    positions = np.array(values).reshape(3, 3)
    triangle = np.array([[0, 1, 2]])
    edges = positions - np.roll(positions, 1, axis=0)
    area = np.linalg.norm(np.cross(edges[0], edges[1]))
    if area < 1e-3:
        return
    assert corner_angles(positions, triangle).sum() == pytest.approx(np.pi)
    np.testing.assert_allclose(edges @ face_normals(positions, triangle)[0], 0.0, atol=1e-9)


def test_a_fan_of_a_hundred_thousand_triangles_is_no_trouble() -> None:
    angle = np.linspace(0.0, 2.0 * np.pi, 100_000, endpoint=False)
    rim = np.stack([np.cos(angle), np.zeros_like(angle), -np.sin(angle)], axis=1)
    positions = np.concatenate([rim, [[0.0, 0.1, 0.0]]])
    index = np.arange(100_000)
    triangles = np.stack([index, np.roll(index, -1), np.full(100_000, 100_000)], axis=1)
    part, _ = repair(RawPart("fan", "paint", positions, triangles))
    assert part is not None
    tip = np.flatnonzero(part.positions[:, 1] > 0.09)
    np.testing.assert_allclose(part.normals[tip], [[0.0, 1.0, 0.0]] * len(tip), atol=1e-4)


@pytest.mark.parametrize("shared", [0.01, 0.1, 0.5, 3.0, 8.0])
@pytest.mark.parametrize("given", ["", "n", "u", "nu", "zu"])
def test_no_part_takes_more_memory_than_is_counted(shared: float, given: str) -> None:
    """``shared`` vertices a triangle, at random places; normals, coordinates, or normals of which many are zero."""
    rng, count = np.random.default_rng(1), 100_000
    number = int(shared * count)
    corners = rng.integers(0, number, 3 * count) if shared < 3.0 else np.arange(3 * count)
    repair(RawPart("cube", "paint", CUBE, CUBE_TRIANGLES))  # imports what it needs
    tracemalloc.start()
    try:
        normals = None
        if set(given) & set("nz"):
            normals = rng.normal(size=(number, 3)) * (
                rng.random((number, 1)) < (0.7 if "z" in given else 1.0)
            )
        uvs = rng.random((number, 2)) if "u" in given else None
        waiting = [RawPart("a", "paint", rng.normal(size=(number, 3)), corners.reshape(-1, 3), normals, uvs)]
        del normals, uvs
        tracemalloc.reset_peak()
        part, _ = repair(waiting.pop())
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert part is not None
    assert peak <= repair_bytes(number, count)


def test_vertices_are_split_by_their_normals_in_their_order() -> None:
    rng = np.random.default_rng(5)
    positions = rng.normal(size=(40, 3))
    triangles = rng.integers(0, 38, (90, 3))
    directions = np.eye(3)
    corners = directions[rng.integers(0, 3, (90, 3)) * (triangles % 3 == 0)]
    made, indices, normals, kept = split_corners(positions, triangles, corners)
    assert np.array_equal(made, positions[kept])
    assert np.array_equal(kept[indices], triangles)
    assert np.array_equal(normals[indices], corners)
    pairs = np.column_stack([triangles.reshape(-1), corners.reshape(-1, 3)])
    assert len(kept) == len(np.unique(pairs, axis=0))
    assert np.array_equal(kept, np.sort(kept))


def test_edges_between_many_faces_join_them_in_turn() -> None:
    # Three faces in one plane about the edge 0-1, and one at a right angle.
    positions = np.array([[0, 0, 0], [0, 0, 1], [1, 0, 0], [2, 0, 0], [3, 0, 0], [0, 1, 0]], float)
    triangles = np.array([[0, 1, 2], [0, 1, 3], [0, 1, 4], [1, 0, 5]])
    normals = corner_normals(positions, triangles, np.arange(6), 40.0)
    assert normals[:3] == pytest.approx(np.tile([0.0, 1.0, 0.0], (3, 3, 1)))
    assert abs(normals[3, 0, 0]) == pytest.approx(1.0)
