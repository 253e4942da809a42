"""What the library knows of a palette: a line of it, and what is in memory once it is read."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

from brdf_qt.documents.files import DocumentFiles
from brdf_qt.documents.open_document import DocumentStore
from brdf_qt.documents.recovery import Recovery
from brdf_qt.documents.watch import FileWatch

from brdf_color_swatch.grid.rows import Rows
from brdf_suite.documents.palette import Palette

State = Literal["closed", "reading", "open", "wrong"]


@dataclass(eq=False)
class OpenPalette:
    """A palette in memory. ``base`` is what its file held when it was read or written last, for a merge."""

    store: DocumentStore[Palette]
    files: DocumentFiles[Palette]
    recovery: Recovery[Palette]
    watch: FileWatch
    rows: Rows
    base: Palette
    origin: Path | None = None
    """The foreign file that it was imported from; it has none of its own then."""


@dataclass(eq=False)
class Item:
    """One line of the library. ``key`` is its own for the run of the program."""

    key: str
    path: Path | None
    name: str
    state: State = "closed"
    problem: str = ""
    palette: OpenPalette | None = None
    waiting: list[Callable[[], None]] = field(default_factory=list)

    def run_waiting(self) -> None:
        """Call those that wait for the palette."""
        waiting, self.waiting = self.waiting, []
        for then in waiting:
            then()

    @property
    def title(self) -> str:
        """The palette's name once it is known, and until then the file's."""
        return self.palette.store.value.name if self.palette is not None else self.name

    @property
    def is_clean(self) -> bool:
        """Whether all of it is in a file."""
        return self.palette is None or self.palette.store.is_clean
