"""Export in the formats of other programs: what would be lost is listed before anything is written."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from brdf_qt.message_bar import Message, message_of
from brdf_qt.translation import mark, tr

from brdf_color_swatch.desk import Desk
from brdf_color_swatch.window import SwatchWindow
from brdf_suite.documents.palette import Palette
from brdf_suite.errors import SuiteError
from brdf_suite.progress import Progress

_MOST_TOLD = 8
_KEY = "export"


@dataclass(frozen=True, eq=False)
class _Request:
    palette: Palette
    path: Path
    write: bool


class ExportPart:
    """Commands that write a palette, or what is selected of it, in any format by the ending of the name."""

    def __init__(self, desk: Desk, window: SwatchWindow) -> None:
        self._desk, self._window = desk, window
        self._all = window.add_command(
            "file", mark("&Export Palette…"), "Ctrl+Shift+E", self.export_all, "export", icon="export",
            tip=mark("Write the palette for another program: ASE, ACO, GPL, KPL, CxF, CSV and others"),
        )  # fmt: skip
        self._some = window.add_command(
            "file", mark("Export What Is Se&lected…"), None, self.export_selected, "export_selected"
        )
        desk.selection_changed.connect(lambda _pane: self._enable())
        desk.shown_changed.connect(lambda _pane: self._enable())
        desk.front_changed.connect(self._enable)
        self._enable()

    def export_all(self) -> None:
        """Ask for a file, and write the palette in front there."""
        palette = self._desk.palette
        if palette is not None:
            self.export(palette)

    def export_selected(self) -> None:
        """Ask for a file, and write what is selected there."""
        palette, chosen = self._desk.palette, set(self._desk.selected)
        if palette is not None and chosen:
            kept = tuple(entry for entry in palette.entries if entry.id in chosen)
            used = {entry.group[:depth] for entry in kept for depth in range(1, len(entry.group) + 1)}
            groups = tuple(group for group in palette.groups if group.path in used)
            self.export(replace(palette, entries=kept, groups=groups))

    def export(self, palette: Palette) -> None:
        """Ask for a file; what its format cannot hold is told, and only then is it written."""
        path = self._desk.library.dialogs.save_path(self._suggested(palette), _filters())
        if path is not None:
            self.begin(palette, path)

    def begin(self, palette: Palette, path: Path) -> None:
        """Look what would be lost in the format of ``path``; write where that is nothing, and ask where it is not."""
        request = _Request(palette, path.absolute(), write=False)
        self._submit(request, lambda lost: self._looked(request, lost))

    def _submit(self, request: _Request, done: Any) -> None:
        self._desk.library.tasks.submit(
            _KEY,
            _exported,
            request,
            done,
            lambda error: self._window.show_message(
                message_of(error, _KEY, todo=tr("Nothing was written; choose another name or format."))
            ),
        )

    def _looked(self, request: _Request, lost: tuple[str, ...]) -> None:
        if not lost:
            self._write(request)
            return
        more = len(lost) - _MOST_TOLD
        lines = [*lost[:_MOST_TOLD], *([tr("{count} more").format(count=more)] if more > 0 else [])]
        self._window.show_message(
            Message(
                _KEY,
                tr("“{name}” cannot hold all of the palette:").format(name=request.path.name),
                where=str(request.path),
                todo="\n".join(lines),
                severity="warning",
                actions=(
                    (tr("Write It"), lambda: self._write(request)),
                    (tr("Another Format…"), lambda: self.export(request.palette)),
                ),
            )
        )

    def _write(self, request: _Request) -> None:
        writing = replace(request, write=True)
        self._submit(writing, lambda _lost: self._written(writing))

    def _written(self, request: _Request) -> None:
        self._window.show_message(
            Message(_KEY, tr("Written: {name}").format(name=request.path.name), where=str(request.path))
        )

    def _suggested(self, palette: Palette) -> Path:
        item = self._desk.item
        folder = item.path.parent if item is not None and item.path is not None else Path.home()
        name = "".join(letter if letter.isalnum() or letter in " -_." else "_" for letter in palette.name)
        return folder / f"{name[:100].strip(' .') or 'palette'}.ase"

    def _enable(self) -> None:
        self._all.setEnabled(self._desk.palette is not None)
        self._some.setEnabled(bool(self._desk.selected))


def _filters() -> str:
    from brdf_suite.files.palettes import FORMATS

    written = [known for known in FORMATS if known.write is not None]
    every = " ".join(f"*{ending}" for known in written for ending in known.endings)
    lines = [tr("All palette formats ({endings})").format(endings=every)]
    for known in written:
        endings = " ".join(f"*{ending}" for ending in known.endings)
        lines.append(f"{known.title.replace('(', '[').replace(')', ']')} ({endings})")
    return ";;".join(lines)


def open_filters() -> str:
    """Return the filter line of a dialog that opens palettes of any format."""
    from brdf_suite.files.palettes import FORMATS

    every = " ".join(sorted({f"*{ending}" for known in FORMATS for ending in known.endings}))
    return tr("Palettes ({endings})").format(endings=every) + ";;" + tr("All files (*)")


def _exported(request: _Request, progress: Progress) -> tuple[str, ...]:
    """Return what is lost; where it is asked for, write as well."""
    from brdf_suite.files.palettes import format_for, losses, write_palette

    progress(0.0, request.path.name)
    known = format_for(request.path)
    if request.write:
        return write_palette(request.palette, request.path, known).losses
    if known.write is None:
        raise SuiteError(tr("{format} is only read here.").format(format=known.title))
    return losses(request.palette, known, request.path)
