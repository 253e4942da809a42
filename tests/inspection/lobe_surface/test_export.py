"""Lobe surfaces as files: read back by another program's reader, whole, with colours and units."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
import trimesh

from brdf_suite.errors import FileError, ValueRangeError
from brdf_suite.geometry.directions import spherical
from brdf_suite.inspection.lobe_surface.export import surface_mesh, write_surface
from brdf_suite.inspection.lobe_surface.grid import lobe_grid
from brdf_suite.inspection.lobe_surface.parts import LobeSource
from brdf_suite.inspection.lobe_surface.surface import RadiusScale, greatest, lobe_surface
from brdf_suite.reflectance.registry import MODELS

ROWS, COLUMNS = 16, 24


@pytest.fixture(scope="module")
def surface():
    grid = lobe_grid(spherical(np.radians(50.0), np.radians(180.0)), ROWS, COLUMNS)
    values = LobeSource(MODELS["ggx"].default).brdf(grid)
    return lobe_surface(
        grid, values, RadiusScale("cbrt", greatest(values[..., 0])), channel="r", colouring="values"
    )


def read(path: Path) -> trimesh.Trimesh:
    with path.open("rb") as file:
        return trimesh.load(io.BytesIO(file.read()), file_type=path.suffix[1:], process=False)


@pytest.mark.parametrize("ending", ["obj", "ply"])
def test_a_surface_read_back(surface, tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"lobe.{ending}"
    write_surface(path, surface, ("Ggx\nat 50 degrees",), size=25.0)
    mesh = read(path)
    # One point for the mirror direction, none twice.
    assert len(mesh.vertices) == (ROWS - 1) * COLUMNS + 1
    assert len(mesh.faces) == COLUMNS + 2 * COLUMNS * (ROWS - 2)
    wanted = surface_mesh(surface, 25.0)
    np.testing.assert_allclose(mesh.vertices, wanted.points, atol=1e-6)
    np.testing.assert_allclose(mesh.vertex_normals, wanted.normals, atol=1e-5)
    assert np.array_equal(np.asarray(mesh.visual.vertex_colors)[:, :3], wanted.colours)
    assert np.linalg.norm(mesh.vertices, axis=1).max() == pytest.approx(25.0, rel=1e-5)
    # Its only rim is the horizon.
    _, uses = np.unique(mesh.edges_sorted, axis=0, return_counts=True)
    assert (uses == 1).sum() == COLUMNS
    head = path.read_bytes()[:600].decode("ascii", "replace")
    assert "a length of 25 is radius 1; full = " in head
    assert "Ggx at 50 degrees" in head


def test_values_go_with_the_points_of_a_ply(surface, tmp_path: Path) -> None:
    path = tmp_path / "lobe.ply"
    write_surface(path, surface)
    mesh = read(path)
    values = np.asarray(mesh.metadata["_ply_raw"]["vertex"]["data"]["value"]).reshape(-1)
    np.testing.assert_allclose(
        np.cbrt(values / surface.scale.full), np.linalg.norm(mesh.vertices, axis=1), atol=1e-5
    )


def test_holes_are_no_faces_and_nothing_is_not_written(surface, tmp_path: Path) -> None:
    grid = lobe_grid(spherical(0.5, 0.0), ROWS, COLUMNS)
    values = np.full((*grid.shape, 3), 0.2, np.float32)
    values[grid.directions[..., 1] > 0.3] = np.nan
    path = tmp_path / "lobe.ply"
    write_surface(path, lobe_surface(grid, values, RadiusScale("linear", 0.2)))
    mesh = read(path)
    assert mesh.vertices[:, 1].max() <= 0.3 + 1e-6
    before = path.read_bytes()
    values[:] = np.nan
    with pytest.raises(ValueRangeError, match="no value in any direction"):
        write_surface(path, lobe_surface(grid, values, RadiusScale("linear", 0.2)))
    assert path.read_bytes() == before
    with pytest.raises(ValueRangeError, match=r"\.stl"):
        write_surface(tmp_path / "lobe.stl", surface)
    with pytest.raises(FileError, match="cannot be written"):
        write_surface(tmp_path / "missing" / "lobe.obj", surface)
    assert [file.name for file in tmp_path.iterdir()] == ["lobe.ply"]
