"""What the readers of the child process share: the values that they return, and a file under another name."""

from __future__ import annotations

import contextlib
import os
import shutil
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from numpy.typing import NDArray


class Refused(Exception):  # noqa: N818 - a refusal in words, which the user reads
    """A file that cannot be read; the text says why, in lower case and without a full stop."""


@dataclass(frozen=True, eq=False)
class ReadPart:
    """``arrays``: positions (n, 3), triangles (k, 3), where there are any normals (n, 3) and uvs (n, 2).

    ``fields``: name, and of its material: material (its name), colour (linear, 3), metallic, roughness, passing.
    """

    arrays: Mapping[str, NDArray[Any]]
    fields: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class ReadMesh:
    """Parts, the axis that points up and the metres of a unit; or why there are none."""

    parts: list[ReadPart]
    up: str | None = None
    metres: float | None = None
    refused: str = ""


def named(file: Path, *kinds: str) -> Path:
    """Return the file under a name with an ending of ``kinds``, by which a library chooses its reader."""
    if file.suffix.lower().removeprefix(".") in kinds:
        return file
    other = Path(f"mesh.{kinds[0]}").absolute()
    with contextlib.suppress(OSError):
        os.link(file, other)
        return other
    shutil.copyfile(file, other)
    return other
