"""The section that hands the paint over: which formats, what they hold, what they lose, and the button."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from brdf_qt.fields.form import described, fill_column
from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.section import Section
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QWidget

from brdf_designer.window.widgets import button, wrapped

TITLES = {
    "cxf": mark("CxF3, one specification per angle"),
    "csv": mark("CSV table, one row per paint"),
    "json": mark("JSON, with computed values"),
    "luxcore": mark("LuxCore car paint"),
    "openpbr": mark("MaterialX, OpenPBR surface"),
    "gltf": mark("glTF, clearcoat"),
    "usd": mark("USD Preview Surface"),
    "rgl": mark("RGL measured material"),
    "html": mark("Report, HTML"),
    "pdf": mark("Report, PDF"),
}
REPORTS = ("html", "pdf")
DAILY = ("cxf", "csv", "html", "pdf")
"""For instruments, tables and people; the others, for renderers and programs, are in a fold."""


@dataclass(frozen=True)
class FormatState:
    """What a format holds of a paint and loses of it; ``refusal``: why it cannot have this paint, "" where it can."""

    name: str
    holds: str
    losses: tuple[str, ...]
    refusal: str = ""

    @property
    def words(self) -> str:
        """What is lost, or why it cannot be exported."""
        if self.refusal:
            return tr_core(self.refusal)
        return (
            "\n".join([tr("Losses:"), *(f"– {tr_core(loss)}" for loss in self.losses)])
            if self.losses
            else tr("No losses.")
        )


class HandoverSection(QWidget):
    """The body of the section.

    Intents: ``formats_chosen()``, others are ticked; ``export_requested()``.
    """

    formats_chosen = Signal()
    export_requested = Signal()

    def __init__(self, names: Sequence[tuple[str, str]], parent: QWidget | None = None) -> None:
        """``names``: each format's name and ending, in the order of the list."""
        super().__init__(parent)
        tip = tr("File format; properties of this paint that it cannot store are listed below")
        self.formats: dict[str, QCheckBox] = {}
        for name, ending in names:
            box = self.formats[name] = described(QCheckBox(tr(TITLES[name])), name=f"format_{name}")
            box.setToolTip(plain_tip(f"{ending}\n{tip}"))
            box.clicked.connect(lambda _on: self.formats_chosen.emit())
        self.holds = described(wrapped(lines=2), name="format_contents", spoken=tr("Contents of the format"))
        self.losses = described(wrapped(lines=4), name="format_losses", spoken=tr("Losses of the format"))
        self.losses.setTextInteractionFlags(
            Qt.TextInteractionFlag.TextSelectableByMouse | Qt.TextInteractionFlag.TextSelectableByKeyboard
        )
        self.pictures = QCheckBox(tr("With pictures"))
        self.pictures.setToolTip(
            tr("Rendered pictures of the speed form in the booth and a sphere in the sun")
        )
        self.pictures.setChecked(True)
        self.compared = QCheckBox(tr("Compare with standard"))
        self.compared.setToolTip(
            tr("Include the differences, words and tolerances of the section Standard in the report")
        )
        self.compared.setChecked(True)
        tip = tr("Export the current paint to a file of each format that is ticked")
        self.export = button(tr("Export…"), tip, self.export_requested.emit)
        ticks = QWidget()
        daily = [box for name, box in self.formats.items() if name in DAILY]
        self.rest = Section(tr("More formats"), "more_formats", is_open=False)
        for name, box in self.formats.items():
            if name not in DAILY:
                self.rest.add(box)
        fill_column(ticks, *daily, self.rest, spacing=2)
        fill_column(self, ticks, self.pictures, self.compared, self.export, self.holds, self.losses)
        self.show_options(has_standard=False)
        self.export.setEnabled(False)

    @property
    def chosen(self) -> tuple[str, ...]:
        """The names of the formats that are ticked, in their order."""
        return tuple(name for name, box in self.formats.items() if box.isChecked())

    def choose(self, *names: str) -> None:
        """Show these formats as ticked, without an intent; none of them stays hidden."""
        for name, box in self.formats.items():
            box.setChecked(name in names)
        if not set(names) <= set(DAILY):
            self.rest.set_open(True)

    def show_options(self, *, has_standard: bool) -> None:
        """Offer what belongs to the formats: pictures and standard to reports alone. Their places stay."""
        reports = any(name in REPORTS for name in self.chosen)
        self.pictures.setEnabled(reports)
        self.compared.setEnabled(reports and has_standard)

    def show_formats(self, found: Sequence[FormatState] | None) -> None:
        """Show what the ticked formats hold and lose; ``None`` while that is found out: nothing is exported then."""
        if found is None:
            self.losses.setText(tr("Determining losses…"))
        elif not found:
            self.holds.setText("")
            self.losses.setText(tr("Tick the formats to export."))
        elif len(found) == 1:
            self.holds.setText(tr_core(found[0].holds))
            self.losses.setText(found[0].words)
        else:
            self.holds.setText("")
            self.losses.setText("\n\n".join(f"{tr(TITLES[one.name])}\n{one.words}" for one in found))
        self.export.setEnabled(bool(found) and not any(one.refusal for one in found or ()))
