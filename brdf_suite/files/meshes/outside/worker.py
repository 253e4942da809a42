"""The child process that reads a mesh by a library: ``worker LIBRARY FILE ANSWER OPTIONS``.

It limits its own memory and writes an answer as :mod:`brdf_suite.files.meshes.outside.child` describes it. A status
other than 0 means that the library broke down.
"""

from __future__ import annotations

import contextlib
import importlib
import json
import os
import re
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from brdf_suite.errors import ExtraError
from brdf_suite.files.bounded_reading import most_made_bytes
from brdf_suite.files.meshes.outside.child import HEADER_BYTES, import_library, needs_more_memory
from brdf_suite.files.meshes.outside.values import ReadMesh, Refused

_READERS = {
    "draco": "brdf_suite.files.meshes.outside.draco",
    "usd": "brdf_suite.files.meshes.outside.usd",
    "assimp": "brdf_suite.files.meshes.outside.assimp",
    "step": "brdf_suite.files.meshes.outside.step",
}


def main(arguments: list[str]) -> int:
    """Read the file that the arguments name and write the answer; return the exit status."""
    if len(arguments) != 4:
        print(__doc__, flush=True)
        return 0 if "--help" in arguments else 2
    library, file, answer, options = arguments
    np.seterr(all="ignore")  # what is not finite is left out, and said, by the parent
    try:
        read: Callable[[Path, dict[str, Any]], ReadMesh] = importlib.import_module(_READERS[library]).read
        import_library(library)
        _limit()
        found = read(Path(file), json.loads(options))
    except MemoryError:
        found = ReadMesh([], refused=needs_more_memory())
    except Refused as refusal:
        said = str(refusal)
        # What C++ calls an allocation that failed; a library passes it on as its own message.
        found = ReadMesh([], refused=needs_more_memory() if "bad_alloc" in said else said)
    except ExtraError as error:
        found = ReadMesh([], refused=error.reason)
    _write(Path(answer), found)
    return 0


def _limit() -> None:
    """Limit the memory that reading takes beside the libraries, and what is written, where the system can."""
    allowed = most_made_bytes()
    with contextlib.suppress(ImportError):  # Windows has none
        resource = importlib.import_module("resource")
        for what, most in (
            # What is written to, and not the address space: a library reserves much of that and uses little.
            (resource.RLIMIT_DATA, _data_bytes() + allowed),
            (resource.RLIMIT_FSIZE, allowed + (1 << 20)),
            (resource.RLIMIT_CORE, 0),
        ):
            with contextlib.suppress(ValueError, OSError):  # a lower limit is set already
                resource.setrlimit(what, (most, most))


def _data_bytes() -> int:
    """Return the private memory of this process that can be written to; 0 where the system does not report it."""
    try:
        status = Path("/proc/self/status").read_text("ascii", "replace")
    except OSError:
        return 0
    found = re.search(r"^VmData:\s*(\d+) kB", status, re.MULTILINE)
    return 0 if found is None else int(found[1]) << 10


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
