"""The generated forms: closed where they should be, smooth, upright, and in millimetres."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from meshes.forms import panel, speed_form, sphere
from meshes.forms.grid import grid_normals
from meshes.forms.speed_form import line_elevation, speed_form_grid, speed_form_point

from brdf_suite.surface.mesh import Mesh, PartGeometry
from brdf_suite.surface.normals import is_inside_out, weld
from brdf_suite.surface.repair import stretch

FORMS = (speed_form, sphere, panel)


def arrays(part: PartGeometry) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    positions = part.positions.astype(np.float64)
    return positions, part.triangles.astype(np.int64), part.normals.astype(np.float64)


def open_edges(part: PartGeometry) -> int:
    positions, triangles, _ = arrays(part)
    places = weld(positions)[triangles]
    edges = np.sort(np.stack([places.reshape(-1), np.roll(places, -1, axis=1).reshape(-1)], axis=1), axis=1)
    return int((np.unique(edges, axis=0, return_counts=True)[1] == 1).sum())


@pytest.mark.parametrize("form", FORMS)
def test_it_stands_on_the_ground_and_normals_fit_its_triangles(form: Callable[[], Mesh]) -> None:
    mesh = form()
    low, high = mesh.bounds()
    assert low[1] == pytest.approx(0.0, abs=1e-3)
    assert low[0] == pytest.approx(-high[0], abs=1e-6)
    assert mesh.parts[0].material == "paint"
    for part in mesh.parts:
        positions, triangles, normals = arrays(part)
        a, b, c = (positions[triangles[:, k]] for k in range(3))
        facing = np.cross(b - a, c - a)
        facing /= np.linalg.norm(facing, axis=1, keepdims=True)
        mean = normals[triangles].mean(axis=1)
        assert np.einsum("ij,ij->i", facing, mean).min() > 0.99


@pytest.mark.parametrize("form", [speed_form, sphere])
def test_it_is_closed_and_the_right_side_out(form: Callable[[], Mesh]) -> None:
    (part,) = form().parts
    positions, triangles, _ = arrays(part)
    assert open_edges(part) == 0
    places = weld(positions)
    assert not is_inside_out(positions, triangles, places)
    assert is_inside_out(positions, triangles[:, ::-1], places)


@pytest.mark.parametrize(
    ("form", "low", "high"), [(speed_form, 0.45, 2.0), (sphere, 0.8, 1.35), (panel, 0.85, 1.15)]
)
def test_texture_coordinates_are_millimetres(form: Callable[[], Mesh], low: float, high: float) -> None:
    """A length of 1 mm on the surface is ``low`` to ``high`` in texture space on 95 % of the area each."""
    part = form().parts[0]
    positions, triangles, _ = arrays(part)
    smallest, largest, _ = stretch(positions * 1000.0, triangles, part.uvs.astype(np.float64))
    a, b, c = (positions[triangles[:, k]] for k in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    assert area[smallest < low].sum() < 0.05 * area.sum()
    assert area[largest > high].sum() < 0.05 * area.sum()
    assert (area * smallest * largest).sum() / area.sum() == pytest.approx(1.0, abs=0.08)


def test_the_speed_form_is_hand_sized_and_symmetric() -> None:
    mesh = speed_form()
    assert 60_000 <= mesh.triangle_count <= 100_000
    low, high = mesh.bounds()
    np.testing.assert_allclose(high - low, [0.146, 0.107, 0.36], atol=0.003)
    positions = mesh.parts[0].positions.astype(np.float64)
    mirrored = positions * [-1.0, 1.0, 1.0]
    order, mirror_order = (np.lexsort(np.round(p * 1e6).T) for p in (positions, mirrored))
    np.testing.assert_allclose(positions[order], mirrored[mirror_order], atol=2e-6)


def curvature(section: np.ndarray) -> np.ndarray:
    """Signed curvature, 1/mm, of a curve (n, 2) in the plane; positive where it bends to the left."""
    first = np.gradient(section, axis=0)
    second = np.gradient(first, axis=0)
    cross = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    return np.asarray(cross / np.linalg.norm(first, axis=1) ** 3)


def test_the_flank_has_a_crisp_rounded_line_and_a_hollow_below_it() -> None:
    around = np.linspace(-0.5 * np.pi, 0.5 * np.pi, 20_001)
    section = speed_form_point(np.full(around.shape, 0.5 * np.pi), around)[:, :2]
    bend = curvature(section)[5:-5]
    place = around[5:-5]
    line = float(line_elevation(np.zeros(1))[0])
    sharpest = np.argmax(bend)
    assert place[sharpest] == pytest.approx(line, abs=0.05)
    assert 1.5 < 1.0 / bend[sharpest] < 8.0, "radius of the line in mm"
    assert bend[(place > line - 0.6) & (place < line - 0.15)].min() < -1e-3, "the hollow"
    assert bend[place > line + 0.5].min() > 0.0, "the crown is convex"
    assert np.abs(np.diff(bend)).max() < 0.01 * bend.max(), "curvature does not jump"


@pytest.mark.parametrize("pole", [0.0, np.pi])
def test_curvature_is_continuous_through_nose_and_tail(pole: float) -> None:
    distances = np.linspace(1e-3, 4e-3, 4)
    limits = []
    for around in np.linspace(0.0, np.pi, 13):
        bends = []
        for distance in distances:
            steps = np.array([-2.0, -1.0, 0.0, 1.0, 2.0]) * 1e-4
            polar = np.abs(pole - (distance + steps))
            for side in (around, around + np.pi):
                points = speed_form_point(polar, np.full(5, side))
                first = (points[3] - points[1]) / 2e-4
                second = (points[3] - 2.0 * points[2] + points[1]) / 1e-8
                bends.append(np.linalg.norm(np.cross(first, second)) / np.linalg.norm(first) ** 3)
        assert np.ptp(bends) < 0.03 * np.mean(bends)
        limits.append(np.mean(bends))
    # Euler: the curvature over the direction has one maximum and one minimum in half a turn.
    assert ((np.diff(np.sign(np.diff([*limits, limits[1]]))) != 0).sum()) <= 2


def unit(vectors: np.ndarray) -> np.ndarray:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))


@pytest.mark.parametrize("axis", [0, 1])
def test_normals_between_vertices_are_exact_enough_for_reflections(axis: int) -> None:
    """Half-way between vertices the interpolated normal is within 0.3° of the true one, mostly far closer."""
    grid = [angle[3:-3] for angle in speed_form_grid()]
    before, after = ([np.delete(angle, end, axis) for angle in grid] for end in (-1, 0))
    true = grid_normals(speed_form_point, *(0.5 * (a + b) for a, b in zip(before, after, strict=True)))
    between = unit(grid_normals(speed_form_point, *before) + grid_normals(speed_form_point, *after))
    off = np.degrees(np.linalg.norm(true - between, axis=-1))
    assert off.max() < 0.3
    assert np.median(off) < 0.03


def test_the_spheres_normals_are_exact() -> None:
    (part,) = sphere().parts
    np.testing.assert_allclose((part.positions - [0.0, 0.1, 0.0]) / 0.1, part.normals, atol=1e-6)


def test_the_panel_has_a_painted_skin_and_a_back() -> None:
    skin, back = panel().parts
    assert (skin.material, back.material) == ("paint", "trim")
    low, high = skin.bounds()
    np.testing.assert_allclose(high[:2] - low[:2], [0.6, 0.4 * np.cos(np.radians(22.0))], atol=0.02)
    positions, triangles, normals = arrays(skin)
    assert normals[np.argmax(positions[:, 2])][2] > 0.9
    # One outline: as many open edges as corners on it, and they join.
    places = weld(positions)[triangles]
    directed = np.stack([places.reshape(-1), np.roll(places, -1, axis=1).reshape(-1)], axis=1)
    low_high = np.sort(directed, axis=1)
    _, index, count = np.unique(low_high, axis=0, return_index=True, return_counts=True)
    outline = dict(directed[index[count == 1]].tolist())
    start = here = next(iter(outline))
    length = 0
    while True:
        here, length = outline[here], length + 1
        if here == start:
            break
    assert length == len(outline)
