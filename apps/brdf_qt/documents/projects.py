"""Projects as programs open them: what a zip file has collected is unpacked once into the program's own folder."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from pathlib import Path

from brdf_qt.program.settings import state_folder
from brdf_suite.documents.atomic import make_folder
from brdf_suite.documents.project import MANIFEST, PROJECT_ENDING, Project, load_project
from brdf_suite.documents.store import PAINT_ENDING, save_paint
from brdf_suite.documents.studio import STUDIO_ENDING, save_light
from brdf_suite.regular_files import is_file


@dataclass(frozen=True)
class OpenedProject:
    """A project, and its paints and lights as files: for programs that open these by path and do not change them.

    ``path`` is the project's file or folder.
    """

    project: Project
    paints: tuple[Path, ...]
    lights: tuple[Path, ...]
    path: Path


def is_project(path: str | Path) -> bool:
    """Whether a file or folder is called as projects are, or is a folder with the manifest of one."""
    return Path(path).suffix.lower() == PROJECT_ENDING or is_file(Path(path) / MANIFEST)


def open_project(path: str | Path) -> OpenedProject:
    """Read a project with all that it needs to be drawn.

    Raises :class:`~brdf_suite.errors.FileError`: it is damaged, or cannot be unpacked.
    """
    source = Path(path).absolute()
    folder = _folder_of(source)
    return as_opened(load_project(source, folder), source)


def projects_folder() -> Path:
    """Return the folder into which this program unpacks projects."""
    return state_folder("projects")


def _folder_of(path: Path) -> Path:
    mark = hashlib.sha256(str(path).encode("utf-8", "surrogateescape")).hexdigest()[:12]
    folder = projects_folder() / mark
    make_folder(folder)
    return folder


def as_opened(project: Project, path: Path) -> OpenedProject:
    """Return a project that was read from or written to ``path``, with its paints and lights as files.

    Raises :class:`~brdf_suite.errors.FileError`: they cannot be written.
    """
    folder = _folder_of(path)
    paints = []
    for number, paint in enumerate(project.paints):
        paints.append(folder / f"paint-{number}{PAINT_ENDING}")
        save_paint(paint, paints[-1])
    lights = []
    for number, light in enumerate(project.lights):
        lights.append(folder / f"light-{number}{STUDIO_ENDING}")
        save_light(light, lights[-1])
    return OpenedProject(project, tuple(paints), tuple(lights), path)
