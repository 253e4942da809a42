"""Packages with entry points, written into a folder as an installer would leave them, and commands that see them."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

HEAD = """\
from dataclasses import dataclass
from typing import ClassVar
import numpy as np
from brdf_suite.documents.palette import Palette
from brdf_suite.documents.parameter import Parameter
from brdf_suite.files.exports.format import ExportFormat
from brdf_suite.files.measured.format import MeasuredFormat
from brdf_suite.files.palettes.format import PaletteFormat
from brdf_suite.reflectance.registry import ModelEntry


@dataclass(frozen=True)
class Flat:
    level: float = 0.2
    parameters: ClassVar = {"level": Parameter("Level", "", 0.0, 1.0, 0.2, "Level")}
    reciprocal: ClassVar = True
    energy_conserving: ClassVar = True

    def eval(self, wi, wo):
        wi, wo = np.broadcast_arrays(wi, wo)
        return np.full(wi.shape, self.level / np.pi)


def model(name, make=Flat):
    return ModelEntry(name, "Flat", make, True, True, "a test")


def palette(name, sniff=lambda head, size: head.startswith(b"ODD"), read=None, write=None, endings=(".odd",)):
    return PaletteFormat(name, "Odd", endings, ("RGB",), "Nothing.", sniff, read, write)
"""


def install(folder: Path, name: str, code: str, groups: Mapping[str, Mapping[str, str]]) -> Path:
    """Write a package of one module, and its entry points by group and name; return the folder."""
    folder.mkdir(exist_ok=True)
    (folder / f"{name}.py").write_text(HEAD + code, encoding="utf-8")
    about = folder / f"{name}-1.0.dist-info"
    about.mkdir()
    (about / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n", encoding="utf-8")
    lines = [
        line
        for group, points in groups.items()
        for line in (f"[{group}]", *(f"{point} = {name}:{what}" for point, what in points.items()))
    ]
    (about / "entry_points.txt").write_text("\n".join(lines), encoding="utf-8")
    return folder


def environment(folder: Path) -> dict[str, str]:
    """Return the environment of a process that has the packages of a folder installed."""
    return os.environ | {"PYTHONPATH": str(folder)}


def command(folder: Path, *words: str | Path) -> subprocess.CompletedProcess[str]:
    """Run ``brdf-suite`` with the packages of a folder."""
    return subprocess.run(
        [sys.executable, "-m", "brdf_suite", *map(str, words)],
        env=environment(folder),
        capture_output=True,
        text=True,
        check=False,
        timeout=600,
        cwd=folder,
    )
