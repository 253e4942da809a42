"""The packaged meshes are what the code makes, small, and read at once."""

from __future__ import annotations

import numpy as np
import pytest
from meshes.forms import panel, speed_form, sphere

from brdf_suite.files.meshes.reading import read_mesh
from brdf_suite.resources import resource, resource_names


@pytest.mark.parametrize("form", [speed_form, sphere, panel])
def test_the_packaged_form_is_what_the_code_makes(form: object) -> None:
    made = form()  # type: ignore[operator]  # a plain function
    read = read_mesh(resource("meshes", f"{made.name}.glb"))
    assert (read.name, len(read.parts)) == (made.name, len(made.parts))
    for one, other in zip(made.parts, read.parts, strict=True):
        assert (one.name, one.material) == (other.name, other.material)
        np.testing.assert_array_equal(one.triangles, other.triangles)
        for field, tolerance in (("positions", 1e-7), ("normals", 1e-5), ("uvs", 1e-3)):
            np.testing.assert_allclose(getattr(one, field), getattr(other, field), atol=tolerance)


def test_every_packaged_mesh_is_small_and_needs_no_repair() -> None:
    names = resource_names("meshes", ".glb")
    assert {"speed_form", "sphere", "panel"} <= set(names)
    for name in names:
        path = resource("meshes", f"{name}.glb")
        assert path.stat().st_size < 4 << 20
        assert read_mesh(path).notes == ()
