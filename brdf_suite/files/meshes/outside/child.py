"""Reading a mesh in a child process, so that no fault of a library of others reaches the program.

The libraries decode what anyone may have made, in C++. A child that breaks down, hangs or asks for too much memory
costs the file and nothing else. Its answer is a file: the length of a JSON header, the header, and the arrays that it
describes; all of it is checked before it is used, as a file of a user would be.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite import variables
from brdf_suite.errors import ExtraError, FileError, PathLike
from brdf_suite.extras import check_extra, import_extra
from brdf_suite.files.bounded_reading import check_made, most_made_bytes
from brdf_suite.processes import child_command
from brdf_suite.regular_files import read_bytes
from brdf_suite.surface.repair import ForeignLook, RawPart

WORKER = "brdf_suite.files.meshes.outside.worker"
HEADER_BYTES = 8
SECONDS = 120.0
"""Of reading; the tessellation of a whole car's CAD surfaces takes about a minute."""
_KINDS = ("<f4", "<f8", "|i1", "|u1", "<i2", "<u2", "<i4", "<u4", "<i8")
_NO_WINDOW = 0x08000000
_NO_PART = "its answer is damaged"


@dataclass(frozen=True)
class OutsideLibrary:
    """What reads a kind of file: the module to import, and what it is needed for."""

    module: str
    purpose: str


LIBRARIES = {
    "draco": OutsideLibrary("DracoPy", "a mesh with Draco compression"),
    "usd": OutsideLibrary("pxr", "a USD file"),
    "assimp": OutsideLibrary("assimp_py", "a file of this kind (FBX, Collada, 3MF, X3D, AC3D, 3DS)"),
    "step": OutsideLibrary("cascadio", "a file of CAD surfaces (STEP, IGES)"),
}
_INSTEAD = "glTF, OBJ, STL and PLY need nothing more"


def import_library(library: str) -> ModuleType:
    """Return the module of a library, for the child process; errors as :func:`import_extra`."""
    needed = LIBRARIES[library]
    return import_extra(needed.module, purpose=needed.purpose, instead=_INSTEAD)


def needs_more_memory() -> str:
    """Return how a message says that reading took all the memory that it may take."""
    allowed = most_made_bytes() / 2**30
    return f"reading it takes more than {allowed:,.3g} GiB of memory ({variables.READ_MB} can allow more)"


@dataclass(frozen=True, eq=False)
class OutsidePart:
    """A part as a child gave it: names, look and arrays."""

    fields: dict[str, Any]
    arrays: dict[str, NDArray[Any]]


@dataclass(frozen=True, eq=False)
class OutsideMesh:
    """Parts in the axes and the unit of their file.

    ``up`` is the axis that points up, ``y`` or ``z``; ``metres`` the length of a unit; None where the file is silent.
    """

    parts: list[RawPart]
    up: str | None
    metres: float | None


def read_outside(path: PathLike, library: str, kind: str, tessellation_mm: float = 0.0) -> OutsideMesh:
    """Return the mesh of a file, by one of :data:`LIBRARIES`.

    Raises
    ------
    FileError
        The library is not installed, or it cannot read the file; the message says what to do.
    """
    options = {"kind": kind, "tessellation_mm": tessellation_mm}
    header, found = _run(path, library, str(Path(path).absolute()), options)
    with np.errstate(invalid="ignore"):  # of numbers that are none
        parts = _raw_parts(path, found)
    up, metres = header.get("up"), header.get("metres")
    if not isinstance(metres, int | float) or not 1e-9 <= metres <= 1e9:
        metres = None
    return OutsideMesh(parts, up if up in ("y", "z") else None, metres)


def _raw_parts(path: PathLike, found: list[OutsidePart]) -> list[RawPart]:
    parts = []
    for part in found:
        triangles = part.arrays["triangles"].astype(np.int64)
        positions = part.arrays["positions"].astype(np.float64)
        if triangles.ndim != 2 or triangles.shape[1] != 3 or positions.ndim != 2 or positions.shape[1] != 3:
            raise FileError(path, _NO_PART)
        positions[~(np.abs(positions) <= np.finfo(np.float32).max)] = np.nan
        given = (part.arrays.get(name) for name in ("normals", "uvs"))
        normals, uvs = (None if array is None else array.astype(np.float64) for array in given)
        if not len(triangles):
            continue
        name = str(part.fields.get("name") or "part")
        parts.append(RawPart(name, "", positions, triangles, normals, uvs, _look(part.fields)))
    return parts


def decode_draco(path: PathLike, chunks: Sequence[bytes]) -> list[OutsidePart]:
    """Return what each chunk of Draco's bitstream holds: ``faces`` (k, 3), and each ``attribute N`` (n, width).

    Raises :class:`FileError` as :func:`read_outside`.
    """
    with tempfile.NamedTemporaryFile(suffix=".draco", delete=False) as together:
        together.write(b"".join(chunks))
    try:
        _, found = _run(path, "draco", together.name, {"lengths": [len(chunk) for chunk in chunks]})
    finally:
        Path(together.name).unlink(missing_ok=True)
    if len(found) != len(chunks):
        raise FileError(path, _NO_PART)
    return found


def _run(
    path: PathLike, library: str, file: str, options: dict[str, Any]
) -> tuple[dict[str, Any], list[OutsidePart]]:
    needed = LIBRARIES[library]
    try:
        check_extra(needed.module, purpose=needed.purpose, instead=_INSTEAD)
    except ExtraError as error:
        raise FileError(path, error.reason) from error
    with tempfile.TemporaryDirectory(prefix="brdf-suite-") as folder:
        answer = Path(folder) / "answer"
        command = child_command(WORKER, library, file, str(answer), json.dumps(options))
        try:
            done = subprocess.run(  # noqa: S603 - a module of ours
                command,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                timeout=SECONDS,
                check=False,
                cwd=folder,
                # On Windows a process of its own would show a window.
                creationflags=_NO_WINDOW if sys.platform == "win32" else 0,
            )
        except subprocess.TimeoutExpired as error:
            raise FileError(path, f"reading it takes more than {SECONDS:g} s; make it smaller") from error
        except OSError as error:
            raise FileError(
                path, f"no process could be started to read it ({error.strerror or error})"
            ) from error
        if done.returncode != 0 or not answer.is_file():
            why = f"the library that reads it broke down: it is damaged, or {needs_more_memory()}"
            raise FileError(path, why)
        check_made(path, answer.stat().st_size, "its triangles")
        content = read_bytes(answer)
    return _unpacked(path, content)


def _unpacked(path: PathLike, content: bytes) -> tuple[dict[str, Any], list[OutsidePart]]:
    length = int.from_bytes(content[:HEADER_BYTES], "little")
    try:
        header = json.loads(content[HEADER_BYTES : HEADER_BYTES + length])
        if "refused" in header:
            said = " ".join(str(header["refused"]).split())[:300]
            raise FileError(path, "".join(letter if letter.isprintable() else "?" for letter in said))
        at, parts = HEADER_BYTES + length, []
        for described in header["parts"]:
            arrays: dict[str, NDArray[Any]] = {}
            for name, (kind, shape) in described["arrays"].items():
                count = int(np.prod([int(edge) for edge in shape], dtype=np.int64))
                array = np.frombuffer(content, _known(kind), count, at).reshape(shape)
                arrays[name] = array
                at += array.nbytes
            parts.append(OutsidePart(described, arrays))
    except (ValueError, TypeError, LookupError, AttributeError, OverflowError) as error:
        raise FileError(path, _NO_PART) from error
    return header, parts


def _known(kind: object) -> np.dtype[Any]:
    if kind not in _KINDS:
        raise ValueError(kind)
    return np.dtype(str(kind))


def _look(fields: dict[str, Any]) -> ForeignLook:
    """Return the look of a part; what is no number of 0…1 is unknown."""

    def share(value: object) -> float | None:
        usable = isinstance(value, int | float) and 0.0 <= value <= 1.0
        return float(value) if usable and isinstance(value, int | float) else None

    given = fields.get("colour")
    channels = [share(value) for value in given] if isinstance(given, list) else []
    red, green, blue = channels if len(channels) == 3 else (None, None, None)
    colour = None if red is None or green is None or blue is None else (red, green, blue)
    metallic, roughness = share(fields.get("metallic")), share(fields.get("roughness"))
    return ForeignLook(
        str(fields.get("material") or ""), colour, metallic, roughness, share(fields.get("passing")) or 0.0
    )
