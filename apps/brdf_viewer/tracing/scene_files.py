"""Light and surface as they are on show, from one process to another: as files of arrays, each written once.

They are handed over, and not read anew by their names, because a light that is being edited has no file, and a file
may have changed since.
"""

from __future__ import annotations

import json
import threading
from pathlib import Path
from typing import Any

import numpy as np

from brdf_suite.errors import FileError
from brdf_suite.lighting.environment import Environment
from brdf_suite.surface.mesh import Mesh, PartGeometry

_ARRAYS = ("positions", "normals", "uvs", "triangles")
_FACTS = "facts"


def write_environment(environment: Environment, folder: Path) -> Path:
    """Write the light, named after its content; nothing is written where it is there already. FileError."""
    facts = {"name": environment.name, "notes": list(environment.notes)}
    path = folder / f"light-{environment.content_hash[:24]}.npz"
    return _write(path, facts, {"radiance": environment.radiance})


def read_environment_file(path: Path) -> Environment:
    """Return the light that :func:`write_environment` wrote. FileError."""
    facts, arrays = _read(path)
    return Environment(facts["name"], arrays["radiance"], tuple(facts["notes"]))


def write_surface(mesh: Mesh, folder: Path, number: int) -> Path:
    """Write the surface, the ``number``-th of this folder. FileError."""
    facts = {
        "name": mesh.name,
        "notes": list(mesh.notes),
        "parts": [[part.name, part.material] for part in mesh.parts],
    }
    arrays = {
        f"{name}_{index}": getattr(part, name) for index, part in enumerate(mesh.parts) for name in _ARRAYS
    }
    return _write(folder / f"surface-{number}.npz", facts, arrays)


def read_surface_file(path: Path) -> Mesh:
    """Return the surface that :func:`write_surface` wrote. FileError."""
    facts, arrays = _read(path)
    parts = [
        PartGeometry(name, material, *(arrays[f"{array}_{index}"] for array in _ARRAYS))
        for index, (name, material) in enumerate(facts["parts"])
    ]
    return Mesh(facts["name"], tuple(parts), tuple(facts["notes"]))


def _write(path: Path, facts: dict[str, Any], arrays: dict[str, Any]) -> Path:
    if path.exists():
        return path
    # Two threads may write the same thing, where the first was asked to stop and has not noticed.
    unfinished = path.with_name(f"unfinished-{threading.get_ident()}")
    words = np.frombuffer(json.dumps(facts).encode(), np.uint8)
    try:
        with unfinished.open("wb") as file:
            np.savez(file, allow_pickle=False, **{_FACTS: words, **arrays})
        unfinished.replace(path)
    except OSError as error:
        raise FileError(path, f"cannot be written ({error.strerror or error})") from error
    return path


def _read(path: Path) -> tuple[dict[str, Any], dict[str, Any]]:
    try:
        with np.load(path, allow_pickle=False) as file:
            arrays = {name: file[name] for name in file.files}
        return json.loads(arrays.pop(_FACTS).tobytes()), arrays
    except (OSError, ValueError, KeyError) as error:
        raise FileError(path, f"is no scene of this program ({error})") from error
