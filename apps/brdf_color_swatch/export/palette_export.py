"""Export in the formats of other programs: what would be lost is listed before anything is written."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.message_bar import Message, message_of

from brdf_color_swatch.export.dialog import choices_of, with_ending
from brdf_color_swatch.feature import SwatchFeature
from brdf_color_swatch.library.library import Item
from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Palette
from brdf_suite.errors import SuiteError
from brdf_suite.progress import Progress
from brdf_suite.regular_files import exists

if TYPE_CHECKING:
    # With it come the parsers of every format, which a start need not wait for.
    from brdf_suite.files.palettes.format import PaletteFormat

_MOST_LISTED = 8
_LONGEST = 100
_KEY = "export"
_USUAL = ".ase"


@dataclass(frozen=True, eq=False)
class _Request:
    palette: Palette
    path: Path
    form: PaletteFormat | None = None
    write: bool = False
    split: bool = False
    """Whether each paint becomes three colours, at 15, 45 and 110°."""


@dataclass(frozen=True)
class _Losses:
    """What a format cannot hold, sentences; ``can_split``: three swatches of each paint would hold more."""

    sentences: tuple[str, ...]
    can_split: bool = False


class PaletteExport(SwatchFeature):
    """Commands that write a palette, or what is selected of it, in the format chosen or that of the name's ending."""

    def __init__(self, session: PaletteSession, window: SwatchWindow) -> None:
        super().__init__(session, window)
        self._all = window.add_command(
            "file", mark("&Export Palette…"), "export", self.export_all, "export", icon="export",
            tip=mark("Export the palette for another program: ASE, ACO, GPL, KPL, CxF, CSV and others"),
        )  # fmt: skip
        self._some = window.add_command(
            "file", mark("Export Se&lection…"), None, self.export_selected, "export_selected"
        )
        self._enable_always()

    def export_all(self) -> None:
        palette = self._session.palette
        if palette is not None:
            self.export(palette)

    def export_selected(self) -> None:
        palette, chosen = self._session.palette, set(self._session.selected)
        if palette is not None and chosen:
            kept = tuple(entry for entry in palette.entries if entry.id in chosen)
            used = {entry.group[:depth] for entry in kept for depth in range(1, len(entry.group) + 1)}
            groups = tuple(group for group in palette.groups if group.path in used)
            self.export(replace(palette, entries=kept, groups=groups))

    def export(self, palette: Palette) -> None:
        from brdf_suite.files.palettes import FORMATS

        choices = choices_of(FORMATS, _USUAL)
        wanted, chosen = suggested_file(self._session.item, palette.name, _USUAL), choices[0]
        while True:
            answer = self._session.library.dialogs.export_path(wanted, choices, chosen)
            if answer is None:
                return
            named, chosen = answer
            wanted = with_ending(named, chosen, FORMATS)
            # The dialog has asked about the file of its own name alone: about another that is there, it asks again.
            if wanted == named or not exists(wanted):
                break
        self.begin(palette, wanted, chosen.form)

    def begin(self, palette: Palette, path: Path, form: PaletteFormat | None = None) -> None:
        """Look what would be lost; write where that is nothing, and ask where it is not.

        ``form`` is the format; without it the ending of ``path`` says which it is.
        """
        request = _Request(palette, path.absolute(), form)
        self._submit(request, lambda lost: self._on_losses(request, lost))

    def _submit(self, request: _Request, done: Any) -> None:
        todo = tr("Nothing was written. Choose another name or format.")
        self._session.library.tasks.submit(
            _KEY,
            _export_palette,
            request,
            done,
            lambda error: self._window.show_message(message_of(error, _KEY, todo=todo)),
        )

    def _on_losses(self, request: _Request, found: _Losses) -> None:
        lost = found.sentences
        if not lost:
            self._write(request)
            return
        more = len(lost) - _MOST_LISTED
        anyway = (tr("Export Anyway"), lambda: self._write(request))
        another = (tr("Another Format…"), lambda: self.export(request.palette))
        three = (tr("Three Swatches per Paint"), lambda: self._split(request))
        actions = (anyway, three, another) if found.can_split else (anyway, another)
        lines = [*lost[:_MOST_LISTED], *([tr("{count} more").format(count=more)] if more > 0 else [])]
        self._window.show_message(
            Message(
                _KEY,
                tr("“{name}” cannot store everything in the palette:").format(name=request.path.name),
                where=str(request.path),
                todo="\n".join(lines),
                severity="warning",
                actions=actions,
            )
        )

    def _split(self, request: _Request) -> None:
        """Look what is lost where the colours at 15°, 45° and 110° are written."""
        split = replace(request, split=True)
        self._submit(split, lambda lost: self._on_losses(split, lost))

    def _write(self, request: _Request) -> None:
        writing = replace(request, write=True)
        self._submit(writing, lambda _lost: self._written(writing))

    def _written(self, request: _Request) -> None:
        self._window.show_message(
            Message(_KEY, tr("Saved: {name}").format(name=request.path.name), where=str(request.path))
        )

    def _enable(self) -> None:
        self._all.setEnabled(self._session.palette is not None)
        self._some.setEnabled(bool(self._session.selected))


def _export_palette(request: _Request, progress: Progress) -> _Losses:
    """Return what is lost; where it is asked for, write as well."""
    from brdf_suite.files.palettes import format_for, losses, split_angles, write_palette

    progress(0.0, request.path.name)
    known = request.form or format_for(request.path)
    palette = request.palette
    lost: tuple[str, ...] = ()
    can_split = not (request.split or known.paints) and _paints(palette) > 0
    if request.split:
        palette = split_angles(palette)
        text = tr("Paints written as three colours each, without gloss and flakes: {count}.")
        lost = (text.format(count=_paints(request.palette)),)
    if request.write:
        return _Losses((*lost, *write_palette(palette, request.path, known).losses))
    if known.write is None:
        raise SuiteError(
            tr("{format} files cannot be exported. Choose another format.").format(
                format=tr_core(known.title)
            )
        )
    return _Losses((*lost, *losses(palette, known, request.path)), can_split)


def _paints(palette: Palette) -> int:
    return sum(not isinstance(entry.content, FlatColour) for entry in palette)


def suggested_file(item: Item | None, name: str, ending: str) -> Path:
    """Return a file beside the palette's own, or in the user's folder, called as the palette is.

    What no system takes in the name of a file, or takes for a folder, is an underscore there.
    """
    folder = item.path.parent if item is not None and item.path is not None else Path.home()
    clean = "".join(letter if letter.isalnum() or letter in " -_." else "_" for letter in name)
    return folder / f"{clean[:_LONGEST].strip(' .') or 'palette'}{ending}"
