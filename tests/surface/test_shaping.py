from __future__ import annotations

import numpy as np
import pytest
from meshes.forms.sphere import sphere

from brdf_suite.documents.view_settings import SurfaceLook
from brdf_suite.surface.mesh import Mesh, PartGeometry
from brdf_suite.surface.repair import shape_mesh


def cube() -> Mesh:
    """A cube of edge 2 about (1, 5, 1), its eight vertices shared by its faces, with no sensible normals."""
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = np.array([t for a, b, c, d in faces for t in ((a, b, c), (a, c, d))])
    normals = corners / np.sqrt(3.0)
    part = PartGeometry(
        "cube", "paint", corners + np.array([1.0, 5.0, 1.0]), normals, corners[:, :2] * 1000.0, triangles
    )
    return Mesh("cube", (part,))


def test_nothing_to_do_gives_the_same_object() -> None:
    mesh = cube()
    assert shape_mesh(mesh, SurfaceLook()) is mesh
    resting = shape_mesh(mesh, SurfaceLook(recentre=True))
    assert shape_mesh(resting, SurfaceLook(recentre=True)) is resting


def test_scale_takes_the_texture_along() -> None:
    found = shape_mesh(cube(), SurfaceLook(scale=0.25)).parts[0]
    np.testing.assert_allclose(found.positions, cube().parts[0].positions * 0.25, rtol=1e-6)
    np.testing.assert_allclose(found.uvs, cube().parts[0].uvs * 0.25, rtol=1e-6)


def test_recentred_it_stands_on_the_ground() -> None:
    low, high = shape_mesh(cube(), SurfaceLook(recentre=True)).bounds()
    np.testing.assert_allclose(low, [-1, 0, -1], atol=1e-6)
    np.testing.assert_allclose(high, [1, 2, 1], atol=1e-6)


def test_flipped_normals_and_triangles_agree() -> None:
    found = shape_mesh(cube(), SurfaceLook(flip_normals=True)).parts[0]
    np.testing.assert_array_equal(found.normals, -cube().parts[0].normals)
    np.testing.assert_array_equal(found.triangles, cube().parts[0].triangles[:, ::-1])


@pytest.mark.parametrize("normals", ["flat", "smooth"])
def test_a_cube_gets_edges(normals: str) -> None:
    found = shape_mesh(cube(), SurfaceLook(normals=normals)).parts[0]  # type: ignore[arg-type] # both are choices
    assert len(found.positions) == 24
    assert (np.abs(np.abs(found.normals).max(axis=1) - 1.0) < 1e-6).all()
    outwards = np.einsum("ij,ij->i", found.normals, found.positions - np.float32([1.0, 5.0, 1.0]))
    np.testing.assert_allclose(outwards, 1.0, atol=1e-5)


def test_flat_and_smooth_spheres() -> None:
    original = sphere()
    smooth = shape_mesh(original, SurfaceLook(normals="smooth")).parts[0]
    centre = np.float32([0.0, 0.1, 0.0])
    radial = (smooth.positions - centre) / np.linalg.norm(smooth.positions - centre, axis=1, keepdims=True)
    np.testing.assert_allclose(smooth.normals, radial, atol=0.02)
    flat = shape_mesh(original, SurfaceLook(normals="flat")).parts[0]
    corners = flat.normals[flat.triangles]
    np.testing.assert_allclose(corners[:, 0], corners[:, 2], atol=1e-6)
    assert flat.triangles.shape == original.parts[0].triangles.shape


def test_normals_made_anew_stay_on_their_side() -> None:
    (part,) = cube().parts
    wound_inwards = Mesh(
        "cube",
        (
            PartGeometry(
                "cube", "paint", part.positions, part.normals, part.uvs, part.triangles[:, ::-1].copy()
            ),
        ),
    )
    found = shape_mesh(wound_inwards, SurfaceLook(normals="smooth")).parts[0]
    outwards = np.einsum("ij,ij->i", found.normals, found.positions - np.float32([1.0, 5.0, 1.0]))
    np.testing.assert_allclose(outwards, 1.0, atol=1e-5)
