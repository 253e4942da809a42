from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from brdf_suite.errors import FileError
from brdf_suite.files.meshes.occlusion_cache import encode_baked, read_baked
from brdf_suite.surface.mesh import Mesh, PartGeometry
from brdf_suite.surface.occlusion.rays import BakedMesh, BakedPart, GroundLight


def facet(name: str, count: int = 3) -> PartGeometry:
    rng = np.random.default_rng(count)
    positions = rng.normal(size=(count, 3))
    normals = np.tile([0.0, 1.0, 0.0], (count, 1))
    triangles = np.stack([np.arange(count - 2), np.arange(1, count - 1), np.arange(2, count)], axis=1)
    return PartGeometry(name, "paint", positions, normals, positions[:, :2], triangles)


@pytest.fixture
def mesh() -> Mesh:
    return Mesh("two", (facet("whole", 5), facet("cut", 3)))


@pytest.fixture
def baked(mesh: Mesh) -> BakedMesh:
    whole, cut = mesh.parts
    rng = np.random.default_rng(0)

    def light(count: int) -> np.ndarray:
        return rng.uniform(0, 1, (count, 8)).astype(np.float16)

    def longer(array: np.ndarray) -> np.ndarray:
        return np.concatenate([array, 0.5 * (array[:1] + array[1:2])])

    parts = (
        BakedPart(whole.positions, whole.normals, whole.uvs, whole.triangles, light(5)),
        BakedPart(
            longer(cut.positions),
            longer(cut.normals) * np.float32(0.7),
            longer(cut.uvs),
            np.array([[0, 3, 2], [3, 1, 2]], np.uint32),
            light(4),
        ),
    )
    # The vertices of the part itself are the mesh's own.
    parts[1].normals[:3] = cut.normals
    return BakedMesh(parts, GroundLight(-0.5, (-1.0, -2.0), (1.0, 2.0), np.ones((8, 4, 49), np.float32)))


def test_round_trip(mesh: Mesh, baked: BakedMesh, tmp_path: Path) -> None:
    path = tmp_path / "kept.occlusion"
    path.write_bytes(b"".join(encode_baked(mesh, baked)))
    found = read_baked(path, mesh)
    for one, other in zip(found.parts, baked.parts, strict=True):
        for name in ("positions", "normals", "uvs", "triangles", "light"):
            assert np.array_equal(getattr(one, name), getattr(other, name)), name
    assert (found.ground.height, found.ground.low, found.ground.high) == (-0.5, (-1.0, -2.0), (1.0, 2.0))
    assert np.array_equal(found.ground.transfer, baked.ground.transfer)


def test_every_damaged_byte_is_noticed(mesh: Mesh, baked: BakedMesh, tmp_path: Path) -> None:
    path = tmp_path / "kept.occlusion"
    path.write_bytes(b"".join(encode_baked(mesh, baked)))
    sound = path.read_bytes()
    for place in (0, 9, 13, 20, 60, len(sound) // 2, len(sound) - 1):
        damaged = bytearray(sound)
        damaged[place] ^= 1
        path.write_bytes(damaged)
        with pytest.raises(FileError):
            read_baked(path, mesh)
    for length in (0, 4, 40, len(sound) - 1):
        path.write_bytes(sound[:length])
        with pytest.raises(FileError):
            read_baked(path, mesh)


def test_another_mesh_is_refused(mesh: Mesh, baked: BakedMesh, tmp_path: Path) -> None:
    path = tmp_path / "kept.occlusion"
    path.write_bytes(b"".join(encode_baked(mesh, baked)))
    other = Mesh("other", (facet("whole", 7), mesh.parts[1]))
    with pytest.raises(FileError, match="does not fit"):
        read_baked(path, other)


def test_a_missing_file(mesh: Mesh, tmp_path: Path) -> None:
    with pytest.raises(FileError, match="cannot be read"):
        read_baked(tmp_path / "none.occlusion", mesh)
