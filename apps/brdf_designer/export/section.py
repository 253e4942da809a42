"""The section that hands the paint over: which format, what it holds, what it loses, and the button."""

from __future__ import annotations

from collections.abc import Sequence

from brdf_qt.fields.form import Form, described, fill_column
from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QWidget

from brdf_designer.window.widgets import button, combo, wrapped

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


class HandoverSection(QWidget):
    """The body of the section.

    Intents: ``format_chosen(name)``, ``export_requested()``.
    """

    format_chosen = Signal(str)
    export_requested = Signal()

    def __init__(self, names: Sequence[tuple[str, str]], parent: QWidget | None = None) -> None:
        """``names``: each format's name and ending, in the order of the list."""
        super().__init__(parent)
        form = Form()
        self.formats = combo((tr(TITLES[name]), name) for name, _ in names)
        for place, (_, ending) in enumerate(names):
            self.formats.setItemData(place, plain_tip(ending), Qt.ItemDataRole.ToolTipRole)
        self.formats.activated.connect(lambda _index: self.format_chosen.emit(self.chosen))
        form.add_row(
            tr("Format"),
            self.formats,
            tr("File format; properties of this paint that it cannot store are listed below"),
        )
        self.holds = described(wrapped(), name="format_contents", spoken=tr("Contents of the format"))
        self.losses = described(wrapped(), name="format_losses", spoken=tr("Losses of the format"))
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
        tip = tr("Export the current paint to a file of this format")
        self.export = button(tr("Export…"), tip, self.export_requested.emit)
        fill_column(self, form, self.holds, self.losses, self.pictures, self.compared, self.export)
        self.show_options(self.chosen, has_standard=False)

    @property
    def chosen(self) -> str:
        """The name of the format that is chosen."""
        return str(self.formats.currentData())

    def choose(self, name: str) -> None:
        """Show a format as chosen, without an intent."""
        self.formats.setCurrentIndex(max(0, self.formats.findData(name)))

    def show_options(self, name: str, *, has_standard: bool) -> None:
        """Offer what belongs to a format: pictures and standard to reports alone."""
        self.pictures.setVisible(name in REPORTS)
        self.compared.setVisible(name in REPORTS and has_standard)

    def show_format(self, holds: str, losses: Sequence[str] | None, refusal: str = "") -> None:
        """Show what a format holds and loses; ``None`` while that is found out. A refusal takes the button away."""
        self.holds.setText(holds)
        text = "\n".join([tr("Losses:"), *(f"– {loss}" for loss in losses)]) if losses else tr("No losses.")
        self.losses.setText(refusal or (tr("Determining losses…") if losses is None else text))
        self.export.setEnabled(losses is not None and not refusal)
