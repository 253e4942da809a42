"""Baked occlusion, from disk where it has been baked before (:mod:`brdf_suite.files.cache.disk_cache`).

An entry is named by what it was made from: positions, normals and triangles of the parts, and the version of the
baking. That of the surface which a new user sees first is packaged, so that the first picture waits for no baking
(``packaging/generators/resources.py occlusion`` writes it).
"""

from __future__ import annotations

import hashlib

import numpy as np

from brdf_suite.files.cache.disk_cache import DiskCache
from brdf_suite.files.meshes.baked_occlusion import LAYOUT, encode_baked, read_baked
from brdf_suite.progress import Progress, report
from brdf_suite.resources import resource_root
from brdf_suite.surface.mesh import Mesh
from brdf_suite.surface.occlusion.bake import ALGORITHM_VERSION, bake
from brdf_suite.surface.occlusion.rays import BakedMesh

ENDING = ".occlusion"
PACKAGED = "occlusion"
"""The folder of the packaged entry among the resources."""


def occlusion_cache() -> DiskCache:
    """Return the cache of baked occlusion, with the limit and in the place that the environment names."""
    return DiskCache("occlusion", "baked surfaces", LAYOUT, ENDING)


def baked_occlusion(mesh: Mesh, progress: Progress | None = None) -> BakedMesh:
    """Return the occlusion of ``mesh``, baked now or before.

    Raises
    ------
    Cancelled
        ``progress`` asked for it; nothing is kept.
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
    """Return the name of what is baked for a mesh: 64 hexadecimal digits; materials and names do not matter."""
    content = hashlib.sha256(f"{ALGORITHM_VERSION} {LAYOUT.version} {len(mesh.parts)}".encode())
    for part in mesh.parts:
        for array in (part.positions, part.normals, part.uvs, part.triangles):
            content.update(str(array.shape).encode())
            content.update(np.ascontiguousarray(array).data)
    return content.hexdigest()
