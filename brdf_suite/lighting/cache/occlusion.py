"""Baked occlusion, from disk where it has been baked before.

An entry is named by what it was made from: positions, normals and triangles of the parts, and the version of the
baking. That of the surface which a new user sees first is packaged, so that the first picture waits for no baking
(``packaging/generators/resources.py occlusion`` writes it). The others lie beside the prefiltered
maps, in a folder of its own. Whatever happens to the folder, the caller gets
the occlusion; only time is lost.
"""

from __future__ import annotations

import contextlib
import hashlib
import logging
import os
from pathlib import Path

import numpy as np

from brdf_suite.errors import FileError
from brdf_suite.files.meshes.baked_occlusion import FORMAT_VERSION, check_baked, read_baked, write_baked
from brdf_suite.lighting.cache.maps import default_root
from brdf_suite.progress import Progress, report
from brdf_suite.resources import resource_root
from brdf_suite.surface.mesh import Mesh
from brdf_suite.surface.occlusion.bake import ALGORITHM_VERSION, bake
from brdf_suite.surface.occlusion.baked import BakedMesh

ENDING = ".occlusion"
PACKAGED = "occlusion"
"""The folder of the packaged entry among the resources."""
LIMIT_BYTES = 256 * 1024**2
"""What the entries may take together; those unused for longest go."""

_log = logging.getLogger(__name__)


def occlusion_folder() -> Path:
    """Return the folder of the entries."""
    return default_root() / "occlusion"


def occlusion_key(mesh: Mesh) -> str:
    """Return the name of what is baked for a mesh: 64 hexadecimal digits; materials and names do not matter."""
    content = hashlib.sha256(f"{ALGORITHM_VERSION} {FORMAT_VERSION} {len(mesh.parts)}".encode())
    for part in mesh.parts:
        for array in (part.positions, part.normals, part.uvs, part.triangles):
            content.update(str(array.shape).encode())
            content.update(np.ascontiguousarray(array).data)
    return content.hexdigest()


def baked_occlusion(mesh: Mesh, progress: Progress | None = None) -> BakedMesh:
    """Return the occlusion of ``mesh``, baked now or before.

    Raises
    ------
    Cancelled
        ``progress`` asked for it; nothing is kept.
    """
    name = f"{occlusion_key(mesh)}{ENDING}"
    path = occlusion_folder() / name
    found = _read(resource_root() / PACKAGED / name, mesh)
    if found is None:
        found = _read(path, mesh)
        if found is not None:
            with contextlib.suppress(OSError):  # a read-only folder still serves; only its ages stand still
                os.utime(path)
    if found is not None:
        report(progress, 1.0, "occlusion")
        return found
    baked = bake(mesh, progress)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        write_baked(path, mesh, baked)
        _make_room(path)
    except (OSError, FileError) as error:
        _log.warning("The occlusion is not kept: %s", error)
    return baked


def _read(path: Path, mesh: Mesh) -> BakedMesh | None:
    """Return what a file holds for a mesh; None where it is not there, or damaged."""
    if not path.exists():
        return None
    try:
        return read_baked(path, mesh)
    except FileError as error:
        _log.warning("The kept occlusion is baked anew: %s", error)
        return None


def kept_occlusion() -> list[tuple[Path, int]]:
    """Return the files of the folder with their sizes in bytes, the one unused for longest first."""
    entries = []
    for path in occlusion_folder().glob(f"*{ENDING}"):
        with contextlib.suppress(OSError):  # another program may have removed it
            state = path.stat()
            entries.append((state.st_mtime, path, state.st_size))
    return [(path, size) for _, path, size in sorted(entries)]


def damaged_occlusion() -> list[tuple[Path, str]]:
    """Read all that is kept, and return the files that are damaged, each with the reason."""
    damaged = []
    for path, _ in kept_occlusion():
        try:
            check_baked(path)
        except FileError as error:
            if path.exists():  # else another program made room
                damaged.append((path, str(error)))
    return damaged


def _make_room(newest: Path) -> None:
    """Remove the entries unused for longest until the others fit."""
    entries = kept_occlusion()
    excess = sum(size for _, size in entries) - LIMIT_BYTES
    for path, size in entries:
        if excess <= 0:
            break
        if path != newest:
            with contextlib.suppress(OSError):
                path.unlink()
                excess -= size
