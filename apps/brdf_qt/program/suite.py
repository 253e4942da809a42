"""The programs of the suite: what each is called, and how one opens another."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from PySide6.QtCore import QProcess, QRect

from brdf_qt.program.translation import tr
from brdf_suite.processes import child_command


@dataclass(frozen=True)
class Member:
    """A program: its name, its package, the command that starts it, and its icon."""

    name: str
    package: str
    command: str
    icon: str


MEMBERS = {
    "designer": Member("Designer", "brdf_designer", "brdf-designer", "paint-brush"),
    "viewer": Member("Viewer", "brdf_viewer", "brdf-viewer", "monitor"),
    "lobes": Member("Lobe Visualizer", "brdf_lobe_visualizer", "brdf-lobes", "cube"),
    "swatch": Member("Color Swatch", "brdf_color_swatch", "brdf-swatch", "swatches"),
}
"""The programs by their roles on the live link."""


def start_member(role: str, place: QRect | None = None, *arguments: str) -> bool:
    """Start a program, with its window at ``place`` of the screen where one is given; False where it cannot be.

    ``arguments`` are those of its command line. It shows what it is asked for at once, and no start page.
    """
    at = [] if place is None else [f"--place={place.x()},{place.y()},{place.width()},{place.height()}"]
    program, *given = child_command(MEMBERS[role].package, "--no-start-page", *at, *arguments)
    started, _ = QProcess.startDetached(program, given)
    return started


def start_again(name: str) -> bool:
    """Start the program of this name once more, with its start page; False where it cannot be."""
    package = next(one.package for one in MEMBERS.values() if one.name == name)
    program, *given = child_command(package, "--start-page")
    started, _ = QProcess.startDetached(program, given)
    return started


def connected_words(roles: Iterable[str]) -> str:
    """Return how a status bar names the programs that are on the link."""
    names = ", ".join(MEMBERS[role].name if role in MEMBERS else role for role in roles)
    return tr("Connected: {programs}").format(programs=names) if names else tr("Not connected")
