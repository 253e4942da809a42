"""Projects as programs open them: what a zip file has collected is unpacked once into the program's own folder."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from pathlib import Path

from brdf_qt.program.settings import state_folder
from brdf_suite.documents.project import PROJECT_ENDING, Project, load_project
from brdf_suite.documents.store import PAINT_ENDING, save_paint


@dataclass(frozen=True)
class OpenedProject:
    """A project, and its paints as files: for programs that open paints by path and do not change them."""

    project: Project
    paints: tuple[Path, ...]


def is_project(path: str | Path) -> bool:
    """Whether a file or folder is called as projects are."""
    return Path(path).suffix.lower() == PROJECT_ENDING


def open_project(path: str | Path) -> OpenedProject:
    """Read a project with all that it needs to be drawn.

    Raises :class:`~brdf_suite.errors.FileError`: it is damaged, or cannot be unpacked.
    """
    source = Path(path).absolute()
    mark = hashlib.sha256(str(source).encode("utf-8", "surrogateescape")).hexdigest()[:12]
    folder = state_folder("projects") / mark
    folder.mkdir(exist_ok=True)
    project = load_project(source, folder)
    paints = []
    for number, paint in enumerate(project.paints):
        paints.append(folder / f"paint-{number}{PAINT_ENDING}")
        save_paint(paint, paints[-1])
    return OpenedProject(project, tuple(paints))
