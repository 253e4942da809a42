"""How the programs fit lobes: basis, number of lobes, sample weights, diffuse term; chosen in one, kept for all."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QFileDialog, QPushButton, QVBoxLayout, QWidget

from brdf_qt.fields.form import Form, fill_row
from brdf_qt.fields.labels import PlainLabel
from brdf_qt.fields.quiet import QuietComboBox, QuietSpinBox
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.settings import SHARED, settings
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.dialogs import without_icons
from brdf_qt.window.main_window import SuiteWindow
from brdf_qt.window.message_bar import message_of
from brdf_suite.errors import SuiteError
from brdf_suite.fitting.lobes.basis import MOST_LOBES, read_basis, shipped_basis
from brdf_suite.fitting.lobes.program import Weighting
from brdf_suite.fitting.lobes.settings import Diffuse, FitSettings
from brdf_suite.foreign_text import make_visible

_STORED, _MESSAGE = "fit/choice", "lobe fit"
_WEIGHTINGS: dict[Weighting, str] = {
    "absolute": mark("Absolute"),
    "relative": mark("Relative to the reflectance"),
    "solid angle": mark("By solid angle"),
}
_DIFFUSE: dict[Diffuse, str] = {
    "joint": mark("Fitted with the lobes"),
    "measured": mark("Measured off the mirror direction"),
}


@dataclass(frozen=True)
class FitChoice:
    """What can be chosen; ``file`` of `brdf-suite basis` (empty: the suite's own), ``count`` of lobes (0: its default).

    ``weighting`` and ``diffuse`` are those of :class:`~brdf_suite.fitting.lobes.settings.FitSettings`.
    """

    file: str = ""
    count: int = 0
    weighting: Weighting = "absolute"
    diffuse: Diffuse = "joint"

    def settings(self) -> FitSettings:
        """Return the settings of the fit; raise :class:`SuiteError`: no such file, no basis, none of so many lobes."""
        count = self.count or None
        basis = read_basis(Path(self.file), count) if self.file else shipped_basis(count)
        return FitSettings(basis, self.weighting, self.diffuse)

    def words(self) -> tuple[str, ...]:
        """Return the options of `brdf-suite render` that make the same choice."""
        options = ("basis", "lobe-count", "weighting", "diffuse")
        given = zip(options, vars(self).values(), vars(FitChoice()).values(), strict=True)
        return tuple(
            f"--{name}={str(value).replace(' ', '-') if name == 'weighting' else value}"
            for name, value, plain in given
            if value != plain
        )


def stored_choice() -> FitChoice:
    """Return the choice of the last time, in any of the programs; the default one where there is none."""
    try:
        kept = json.loads(str(settings(SHARED).value(_STORED, "{}")))
        known = vars(FitChoice())
        return FitChoice(**{name: type(known[name])(kept[name]) for name in known if name in kept})
    except (ValueError, TypeError, OverflowError, RecursionError):
        return FitChoice()  # a settings file that another version wrote


class FitDialog(QDialog):
    """Asks for a :class:`FitChoice`; ``chosen(choice)`` when OK is pressed and its basis can be read."""

    chosen = Signal(object)

    def __init__(self, choice: FitChoice, note: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Lobe Fit"))
        self.setObjectName("fit_dialog")
        self.basis = QuietComboBox()
        self.browse = QPushButton(tr("Choose…"))
        self.count = QuietSpinBox(minimum=0, maximum=MOST_LOBES)
        self.count.setSpecialValueText(tr("Default of the basis"))
        self.weighting, self.diffuse = _choices(_WEIGHTINGS), _choices(_DIFFUSE)
        self.message = PlainLabel(note, wordWrap=True)
        self.message.setObjectName("fit_note")
        kinds = QDialogButtonBox.StandardButton
        self.buttons = QDialogButtonBox(kinds.Ok | kinds.Cancel | kinds.RestoreDefaults)
        row, form = QWidget(), Form()
        fill_row(row, self.basis, self.browse)
        form.add_row(
            tr("Basis"), row, tr("Exponents of the lobes: the suite's own, or a file of brdf-suite basis")
        )
        form.add_row(
            tr("Number of lobes"), self.count, tr("One of the counts that the basis was searched for")
        )
        form.add_row(
            tr("Sample weights"), self.weighting, tr("Paints with layers: how much each sample counts")
        )
        form.add_row(
            tr("Diffuse term"), self.diffuse, tr("Paints with layers: where the diffuse term comes from")
        )
        form.add_wide(self.message)
        box = QVBoxLayout(self)
        box.addWidget(form)
        box.addStretch()
        box.addWidget(self.buttons)
        without_icons(self)
        self.browse.clicked.connect(self._browse)
        self.buttons.accepted.connect(self._accept)
        self.buttons.rejected.connect(self.close)
        self.buttons.button(kinds.RestoreDefaults).clicked.connect(lambda: self.show_choice(FitChoice()))
        self.show_choice(choice)

    @property
    def choice(self) -> FitChoice:
        """What the fields hold."""
        fields = self.basis, self.weighting, self.diffuse
        file, weighting, diffuse = (field.currentData() for field in fields)
        return FitChoice(file, self.count.value(), weighting, diffuse)

    def show_choice(self, choice: FitChoice) -> None:
        self.basis.clear()
        self.basis.addItem(tr("The suite's own"), "")
        self.add_file(choice.file)
        self.count.setValue(choice.count)
        for field, value in ((self.weighting, choice.weighting), (self.diffuse, choice.diffuse)):
            field.setCurrentIndex(field.findData(value))

    def add_file(self, file: str) -> None:
        """Offer the basis in a file, and choose it; nothing where there is none."""
        if file:
            self.basis.addItem(make_visible(Path(file).name), file)
            self.basis.setCurrentIndex(self.basis.count() - 1)

    def _browse(self) -> None:
        self.add_file(QFileDialog.getOpenFileName(self, tr("Open a Basis"), "", tr("Bases (*.json)"))[0])

    def _accept(self) -> None:
        choice = self.choice
        try:
            choice.settings()
        except SuiteError as error:
            self.message.setText(tr_core(str(error)))
            return
        self.chosen.emit(choice)
        self.close()


class FitCommand(QObject):
    """Lobe Fit… of the menu Edit. ``settings`` are how this program fits, ``choice`` what they were made of.

    ``changed(settings)`` is emitted when the user has chosen others. A ``choice`` that is given holds for this run
    alone and raises :class:`SuiteError` where its basis cannot be read; of a stored one a message says so, and the
    default is used. ``note`` stands in the dialog: when the program takes a choice up.
    """

    changed = Signal(object)

    def __init__(self, window: SuiteWindow, note: str, choice: FitChoice | None = None) -> None:
        super().__init__(window)
        self._window, self._note = window, note
        self.choice = choice or stored_choice()
        self.dialog: FitDialog | None = None
        try:
            self.settings = self.choice.settings()
        except SuiteError as error:
            if choice is not None:
                raise
            self.choice, self.settings = FitChoice(), FitSettings()
            todo = tr("The suite's own lobes are used. Choose another basis with Edit ▸ Lobe Fit.")
            window.show_message(message_of(error, _MESSAGE, todo=todo))

    def add_to_menu(self) -> None:
        """Add the command, after those that are there."""
        tip = mark("Choose the exponents and the number of lobes, and how they are fitted")
        self._window.add_command("edit", mark("Lobe Fit…"), None, self.ask, "lobe_fit", tip=tip)

    def ask(self) -> None:
        """Show the dialog."""
        if self.dialog is None:
            self.dialog = FitDialog(self.choice, self._note, self._window)
            self.dialog.chosen.connect(self.choose)
        self.dialog.show()
        self.dialog.raise_()

    def choose(self, choice: FitChoice) -> None:
        """Keep a choice whose basis can be read, for all programs, and report its settings."""
        chosen = choice.settings()
        settings(SHARED).setValue(_STORED, json.dumps(asdict(choice)))
        self._window.dismiss_message(_MESSAGE)
        self.changed.emit(chosen)


def _choices(titles: Mapping[Weighting, str] | Mapping[Diffuse, str]) -> QuietComboBox:
    field = QuietComboBox()
    for key, title in titles.items():
        field.addItem(tr(title), key)
    return field
