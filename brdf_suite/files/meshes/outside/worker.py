"""The child process that reads a mesh by a library: ``worker LIBRARY FILE ANSWER OPTIONS``.

It limits its own memory and writes an answer as :mod:`brdf_suite.files.meshes.outside.child` describes it. A status
other than 0 means that the library broke down.
"""

from __future__ import annotations

import contextlib
import importlib
import json
import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from brdf_suite.errors import ExtraError
from brdf_suite.files.meshes.outside.child import HEADER_BYTES
from brdf_suite.files.meshes.outside.values import ReadMesh, Refused

_READERS = {
    "draco": "brdf_suite.files.meshes.outside.draco",
    "usd": "brdf_suite.files.meshes.outside.usd",
    "assimp": "brdf_suite.files.meshes.outside.assimp",
    "step": "brdf_suite.files.meshes.outside.step",
}
_MEMORY = 6 << 30
_ANSWER = 1 << 30


def main(arguments: list[str]) -> int:
    """Read the file that the arguments name and write the answer; return the exit status."""
    if len(arguments) != 4:
        print(__doc__, flush=True)
        return 0 if "--help" in arguments else 2
    library, file, answer, options = arguments
    _limit()
    np.seterr(all="ignore")  # what is not finite is left out, and said, by the parent
    try:
        read: Callable[[Path, dict[str, Any]], ReadMesh] = importlib.import_module(_READERS[library]).read
        found = read(Path(file), json.loads(options))
    except Refused as refusal:
        found = ReadMesh([], refused=str(refusal))
    except ExtraError as error:
        found = ReadMesh([], refused=error.reason)
    _write(Path(answer), found)
    return 0


def _limit() -> None:
    """Limit memory and what is written, where the system can."""
    with contextlib.suppress(ImportError):  # Windows has none
        resource = importlib.import_module("resource")
        for what, most in (
            (resource.RLIMIT_AS, _MEMORY),
            (resource.RLIMIT_FSIZE, _ANSWER + (1 << 20)),
            (resource.RLIMIT_CORE, 0),
        ):
            with contextlib.suppress(ValueError, OSError):  # macOS has no limit of the address space
                resource.setrlimit(what, (most, most))


def _write(answer: Path, found: ReadMesh) -> None:
    described, content = [], []
    for part in found.parts:
        arrays: dict[str, Any] = {}
        for name, array in part.arrays.items():
            whole = np.ascontiguousarray(array)
            whole = whole.astype(whole.dtype.newbyteorder("<"), copy=False)
            arrays[name] = [whole.dtype.str, list(whole.shape)]
            content.append(whole.tobytes())
        described.append({**part.fields, "arrays": arrays})
    header: dict[str, Any] = {"parts": described, "up": found.up, "metres": found.metres}
    if found.refused:
        header["refused"] = found.refused
    text = json.dumps(header).encode()
    with answer.open("wb") as stream:
        stream.write(len(text).to_bytes(HEADER_BYTES, "little") + text)
        stream.writelines(content)


if __name__ == "__main__":
    status = main(sys.argv[1:])
    # Without the destructors of libraries, which may hang or break down.
    os._exit(status)
