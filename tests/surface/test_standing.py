"""Which way up a mesh is, and in which unit."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.files.meshes.reading import read_mesh, write_mesh_glb
from brdf_suite.pipeline.scene import load_surface, surface_names
from brdf_suite.surface.mesh import Mesh, PartGeometry
from brdf_suite.surface.standing import Standing, find_standing, find_unit, lies_on_its_side


def turned(mesh: Mesh) -> Mesh:
    """The mesh with z up instead of y, as modelling programs write it."""

    def lay(v: np.ndarray) -> np.ndarray:
        return np.stack((v[:, 0], -v[:, 2], v[:, 1]), axis=1)

    parts = tuple(replace(p, positions=lay(p.positions), normals=lay(p.normals)) for p in mesh.parts)
    return replace(mesh, parts=parts)


@pytest.mark.parametrize("name", ["car", "speed_form"])
def test_shipped_forms_are_told_from_those_laid_down(name: str) -> None:
    mesh = load_surface(name)
    for shown, lies in ((mesh, False), (turned(mesh), True)):
        points = np.concatenate([part.positions for part in shown.parts])
        assert lies_on_its_side(points) is lies


def test_what_is_known_is_not_asked() -> None:
    assert all(find_standing(load_surface(name)) is None for name in surface_names())


@pytest.mark.parametrize(
    ("size", "unit", "sure"),
    [(1.0, "m", True), (4.5, "m", True), (4500.0, "mm", False), (20.0, "in", False), (0.001, "m", False)],
)
def test_the_unit_in_which_a_size_is_one_of_an_object(size: float, unit: str, sure: bool) -> None:
    assert find_unit(size) == (unit, sure)


def test_axes_with_z_up_are_turned_and_normals_with_them(tmp_path: Path) -> None:
    corner = np.array([[0.0, 0, 0], [1, 0, 0], [0, 2, 3]])
    normals = np.tile([0.0, 0.0, 1.0], (3, 1))
    mesh = Mesh("facet", (PartGeometry("facet", "paint", corner, normals, corner[:, :2], [[0, 1, 2]]),))
    write_mesh_glb(mesh, tmp_path / "facet.glb")
    upright = read_mesh(tmp_path / "facet.glb", up="z").parts[0]
    np.testing.assert_allclose(upright.positions[2], [0.0, 3.0, -2.0])
    np.testing.assert_allclose(upright.normals, np.tile([0.0, 1.0, 0.0], (3, 1)))
    for up in ("y", "file"):
        np.testing.assert_array_equal(read_mesh(tmp_path / "facet.glb", up=up).parts[0].positions, corner)


def test_a_file_in_millimetres_with_z_up(tmp_path) -> None:
    """Square sheets over each other on the ground, as a program writes them that knows no unit."""
    lines, faces = [], []
    for level in range(4):
        lines += [f"v {x} {y} {500 * level}" for x, y in ((-900, -800), (900, -800), (900, 800), (-900, 800))]
        faces.append("f " + " ".join(str(4 * level + corner) for corner in (1, 2, 3, 4)))
    path = tmp_path / "tower.obj"
    path.write_text("\n".join([*lines, *faces]))
    assert find_standing(read_mesh(path)) == Standing("z", "mm", is_doubtful=True)
    # In another unit the answer is the same: it is of the file, not of how it was taken.
    assert find_standing(read_mesh(path, "cm")) == Standing("z", "mm", is_doubtful=True)
