from __future__ import annotations

import numpy as np
import pytest
from meshes.forms.sphere import sphere

from brdf_suite.surface.mesh import Mesh, PartGeometry
from brdf_suite.surface.picking import pick


def sheet(name: str, z: float) -> PartGeometry:
    positions = np.array([[-1, -1, z], [1, -1, z], [1, 1, z], [-1, 1, z]], float)
    normals = np.tile([0.0, 0.0, 1.0], (4, 1))
    return PartGeometry(
        name, "paint", positions, normals, positions[:, :2] * 1000, np.array([[0, 1, 2], [0, 2, 3]])
    )


@pytest.fixture
def sheets() -> Mesh:
    return Mesh("sheets", (sheet("far", -1.0), sheet("near", 1.0), sheet("middle", 0.0)))


def test_the_nearest_part_is_met_and_its_place_interpolated(sheets: Mesh) -> None:
    hit = pick(sheets, np.array([0.3, -0.2, 5.0]), np.array([0.0, 0.0, -2.0]))
    assert hit is not None
    assert sheets.parts[hit.part].name == "near"
    assert hit.distance == pytest.approx(4.0)
    np.testing.assert_allclose(hit.position, [0.3, -0.2, 1.0], atol=1e-6)
    np.testing.assert_allclose(hit.uv, [300.0, -200.0], atol=1e-3)
    np.testing.assert_allclose(hit.normal, [0, 0, 1])


def test_from_behind_and_beside(sheets: Mesh) -> None:
    behind = pick(sheets, np.array([0.0, 0.0, -5.0]), np.array([0.0, 0.0, 1.0]))
    assert behind is not None
    assert sheets.parts[behind.part].name == "far"
    assert pick(sheets, np.array([1.5, 0.0, 5.0]), np.array([0.0, 0.0, -1.0])) is None
    assert pick(sheets, np.array([0.0, 0.0, 5.0]), np.array([0.0, 0.0, 1.0])) is None


def test_every_place_of_a_sphere_is_on_it() -> None:
    mesh = sphere()
    centre = np.array([0.0, 0.1, 0.0])
    rng = np.random.default_rng(1)
    for _ in range(20):
        origin = centre + rng.normal(size=3) * 3
        hit = pick(mesh, origin, centre - origin)
        assert hit is not None
        assert np.linalg.norm(hit.position - centre) == pytest.approx(0.1, rel=2e-3)
        np.testing.assert_allclose(hit.normal, (origin - centre) / np.linalg.norm(origin - centre), atol=0.01)
