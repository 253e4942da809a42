"""Baked occlusion, from disk where it has been baked before (:mod:`brdf_suite.files.cache.disk_cache`).

An entry is named by what it was made from: positions, normals and triangles of the parts, and the version of the
baking. That of the surface which a new user sees first is packaged, so that the first picture waits for no baking
(``packaging/generators/resources.py occlusion`` writes it).

In the file (:mod:`brdf_suite.files.array_file`) the header holds ``"ground": [height, x0, z0, x1, z1]``. The arrays are
``ground``, and of each part only what is not in the mesh itself: ``0.light``, of both sides where it is no solid, and
``0.triangles`` and the vertices on its edges where it was cut.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping

import numpy as np

from brdf_suite.arrays import AnyArray
from brdf_suite.documents.view_settings import PANE_IOR, TRANSMITTANCE
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.array_file import Layout, encode_arrays, read_arrays
from brdf_suite.files.cache.disk_cache import DiskCache
from brdf_suite.progress import Progress, report
from brdf_suite.resources import resource_root
from brdf_suite.surface.mesh import Mesh, PartGeometry
from brdf_suite.surface.occlusion.bake import ALGORITHM_VERSION, bake
from brdf_suite.surface.occlusion.rays import BakedMesh, BakedPart, GroundLight

LAYOUT = Layout(b"BRDFOCCL", 4, "baked occlusion", ("<f2", "<f4", "<u4"), level=1, smallest=0, most=1 << 16)

_CUT = ("positions", "normals", "uvs")


def encode_baked(mesh: Mesh, baked: BakedMesh) -> list[bytes | memoryview]:
    """Return the parts of a file with what was baked for ``mesh``, to be written one after the other."""
    ground = baked.ground
    arrays: dict[str, AnyArray] = {"ground": ground.transfer.astype("<f2")}
    for number, (part, original) in enumerate(zip(baked.parts, mesh.parts, strict=True)):
        arrays[f"{number}.light"] = part.light.astype("<f2")
        if len(part.triangles) > len(original.triangles):
            arrays[f"{number}.triangles"] = part.triangles.astype("<u4")
            for name in _CUT:
                added = getattr(part, name)[len(original.positions) :]
                arrays[f"{number}.{name}"] = added.astype("<f4")
    header = {"ground": [ground.height, *ground.low, *ground.high]}
    return encode_arrays(LAYOUT, LAYOUT.name, header, arrays)


def read_baked(path: PathLike, mesh: Mesh) -> BakedMesh:
    """Return what was baked for ``mesh``.

    Raises :class:`FileError`: it is not there, damaged, of another version, or was baked for another mesh.
    """
    header, arrays = read_arrays(LAYOUT, path)
    try:
        height, x0, z0, x1, z1 = (float(number) for number in header["ground"])
        transfer = arrays["ground"].astype(np.float32)
        parts = tuple(_part(original, number, arrays) for number, original in enumerate(mesh.parts))
    except (ValueError, KeyError, TypeError, IndexError, OverflowError) as error:
        raise FileError(path, f"does not fit the mesh ({error})") from error
    return BakedMesh(parts, GroundLight(height, (x0, z0), (x1, z1), transfer))


def _part(original: PartGeometry, number: int, arrays: Mapping[str, AnyArray]) -> BakedPart:
    values = {name: getattr(original, name) for name in (*_CUT, "triangles")}
    if f"{number}.triangles" in arrays:
        values["triangles"] = arrays[f"{number}.triangles"]
        for name in _CUT:
            values[name] = np.concatenate([values[name], arrays[f"{number}.{name}"]])
    light = arrays[f"{number}.light"]
    if light.shape[1:] not in ((8,), (16,)) or len(light) != len(values["positions"]):
        raise ValueError(f"part {number} has {len(values['positions'])} vertices, not {len(light)}")
    return BakedPart(**values, light=light)


ENDING = ".occlusion"
PACKAGED = "occlusion"
"""The folder of the packaged entry among the resources."""


def occlusion_cache() -> DiskCache:
    """Return the cache of baked occlusion, with the limit and in the place that the environment names."""
    return DiskCache("occlusion", "baked surfaces", LAYOUT, ENDING)


def baked_occlusion(mesh: Mesh, progress: Progress | None = None) -> BakedMesh:
    """Return the occlusion of ``mesh``, baked now or before.

    Raises :class:`Cancelled`: ``progress`` asked for it; nothing is kept.
    """
    key = occlusion_key(mesh)
    cache = occlusion_cache()
    shipped = resource_root() / PACKAGED / f"{key}{ENDING}"
    found = cache.packaged(shipped, lambda path: read_baked(path, mesh)) or cache.get_or_make(
        key,
        lambda path: read_baked(path, mesh),
        lambda watched: bake(mesh, watched),
        lambda baked: encode_baked(mesh, baked),
        progress,
    )
    report(progress, 1.0, "occlusion")
    return found


def occlusion_key(mesh: Mesh) -> str:
    """Return the name of what is baked for a mesh: 64 hexadecimal digits of its shape and its panes."""
    content = hashlib.sha256(f"{ALGORITHM_VERSION} {LAYOUT.version} {len(mesh.parts)}".encode())
    for part in mesh.parts:
        if part.material in TRANSMITTANCE:
            content.update(f"{TRANSMITTANCE[part.material]} {PANE_IOR[part.material]}".encode())
        for array in (part.positions, part.normals, part.uvs, part.triangles):
            content.update(str(array.shape).encode())
            content.update(np.ascontiguousarray(array).data)
    return content.hexdigest()
