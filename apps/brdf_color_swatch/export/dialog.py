"""The question where a palette is exported to, under which name, and in which format: a line's or the ending's."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from brdf_qt.fields.quiet import quieten
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import tr
from brdf_qt.window.dialogs import QtDialogs
from PySide6.QtWidgets import QFileDialog

if TYPE_CHECKING:
    # With it come the parsers of every format, which a start need not wait for.
    from brdf_suite.files.palettes.format import PaletteFormat


@dataclass(frozen=True)
class Choice:
    """A line of the dialog's list of formats. Without ``form`` the name's ending says which it is.

    ``ending`` is what a name without one gets.
    """

    line: str
    ending: str
    form: PaletteFormat | None = None


class QtExportDialogs(QtDialogs):
    """What this program asks about its files, as dialogs over ``window``."""

    def export_path(
        self, suggested: Path, choices: Sequence[Choice], chosen: Choice
    ) -> tuple[Path, Choice] | None:
        """Ask for a file to write and its format; ``None`` where the user gives up."""
        by_line = {choice.line: choice for choice in choices}
        dialog = QFileDialog(self._window, tr("Export Palette"), str(suggested.parent), ";;".join(by_line))
        dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
        # Added by the dialog and not afterwards, so that it asks about the file that is really written.
        dialog.filterSelected.connect(
            lambda line: dialog.setDefaultSuffix(by_line[line].ending if line in by_line else "")
        )
        dialog.selectNameFilter(chosen.line)
        dialog.setDefaultSuffix(chosen.ending)
        dialog.selectFile(suggested.name)
        quieten(dialog)
        accepted = dialog.exec() == QFileDialog.DialogCode.Accepted
        names, line = dialog.selectedFiles(), dialog.selectedNameFilter()
        dialog.deleteLater()
        return (Path(names[0]), by_line.get(line, chosen)) if accepted and names else None


def choices_of(formats: Sequence[PaletteFormat], usual: str) -> tuple[Choice, ...]:
    """Return the lines of a dialog: all formats together, named by the ending, and each that is written."""
    written = [known for known in formats if known.write is not None]
    every = " ".join(dict.fromkeys(f"*{ending}" for known in written for ending in known.endings))
    lines = [Choice(tr("All palette formats ({endings})").format(endings=every), usual)]
    for known in written:
        endings = " ".join(f"*{ending}" for ending in known.endings)
        title = tr_core(known.title).replace("(", "[").replace(")", "]")
        lines.append(Choice(f"{title} ({endings})", known.endings[0], known))
    return tuple(lines)


def with_ending(path: Path, choice: Choice, formats: Sequence[PaletteFormat]) -> Path:
    """Return ``path`` with an ending of the chosen format: in the place of another format's, or behind the name.

    Where all formats were chosen, an ending stays as it is.
    """
    ending = path.suffix.lower()
    if choice.form is None:
        return path if ending else path.with_name(path.name + choice.ending)
    if ending in choice.form.endings:
        return path
    if any(ending in known.endings for known in formats):
        return path.with_suffix(choice.ending)
    return path.with_name(path.name + choice.ending)


def open_filters() -> str:
    """Return the filter line of a dialog that opens palettes of any format."""
    from brdf_suite.files.palettes import FORMATS

    every = " ".join(sorted({f"*{ending}" for known in FORMATS for ending in known.endings}))
    return tr("Palettes ({endings})").format(endings=every) + ";;" + tr("All files (*)")
