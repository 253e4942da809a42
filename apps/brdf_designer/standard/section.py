"""The Standard section: which standard, by which formula and tolerances, and what came of it."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from brdf_qt.fields.form import Form
from brdf_qt.fields.labels import PlainLabel, plain_tip
from brdf_qt.fields.number import NumberField
from brdf_qt.fields.quiet import QuietComboBox
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.section import Section
from PySide6.QtCore import Qt, Signal, SignalInstance
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QHBoxLayout,
    QLabel,
    QMenu,
    QPushButton,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from brdf_designer.standard.settings import ToleranceSettings
from brdf_designer.standard.state import StandardState
from brdf_designer.standard.tables import BatchTable, ResultTable, ToleranceTable

OWN_CMC = "cmc"
FORMULAS = (
    ("2000", mark("CIEDE2000")),
    ("cmc21", mark("CMC (2:1), acceptability")),
    ("cmc11", mark("CMC (1:1), perceptibility")),
    (OWN_CMC, mark("CMC (l:c), custom weights")),
    ("cam02ucs", mark("CAM02-UCS")),
    ("76", mark("CIELAB ΔE*ab")),
)
_EMPTY = mark(
    "No standard. Use the current state, or load a paint, a palette, CxF3 or a "
    "measured BRDF. The edited paint is then the batch that is compared with it."
)


class StandardSection(QWidget):
    """The body of the section.

    Intents: ``take_requested``, ``load_requested``, ``known_list_requested`` and ``known_requested(key)`` for the
    entries of :meth:`show_known`, ``swap_requested``, ``remove_requested``, ``chosen(index)`` among the standards
    of a file, ``formula_chosen(name)``, ``limit_edited(angle | None, part, value | None)``, ``ellipsoid_chosen(on)``,
    ``add_batches_requested``, ``clear_batches_requested``, ``batch_opened(index)``, ``refused(text)``.
    """

    take_requested = Signal()
    load_requested = Signal()
    known_requested = Signal(str)
    known_list_requested = Signal()
    swap_requested = Signal()
    remove_requested = Signal()
    chosen = Signal(int)
    formula_chosen = Signal(str)
    limit_edited = Signal(object, str, object)
    ellipsoid_chosen = Signal(bool)
    add_batches_requested = Signal()
    clear_batches_requested = Signal()
    batch_opened = Signal(int)
    refused = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(8)
        self.take = _button(
            tr("This State"), tr("Use the current state as the standard"), self.take_requested
        )
        self.load = _button(
            tr("Load"),
            tr("Load an open tab, a sample paint, or a file: paint, palette, CxF3, measured BRDF"),
            None,
        )
        self.load_menu = QMenu(self.load)
        self.load_menu.aboutToShow.connect(self.known_list_requested)
        self.load.setMenu(self.load_menu)
        self.swap = _button(
            tr("Swap"), tr("Edit the standard and compare it with the current paint"), self.swap_requested
        )
        self.remove = _button(tr("Remove"), tr("Remove the standard"), self.remove_requested)
        box.addLayout(_row(self.take, self.load, self.swap, self.remove))
        self.empty = _wrapped(tr(_EMPTY))
        box.addWidget(self.empty)
        self.body = QWidget()
        box.addWidget(self.body)
        self._build_body()
        self.body.hide()
        self.swap.setEnabled(False)
        self.remove.setEnabled(False)

    def show_state(self, state: StandardState | None) -> None:
        """Show a comparison; ``None``: there is no standard."""
        there = state is not None
        if self.body.isHidden() == there:
            self.body.setVisible(there)
            self.empty.setVisible(not there)
            self.swap.setEnabled(there)
            self.remove.setEnabled(there)
        if state is None:
            return
        _set_text(self.name, state.name)
        _set_text(self.origin, state.origin)
        self.origin.setVisible(bool(state.origin))
        _set_text(self.verdict, state.verdict)
        _set_text(self.sentence, state.sentence)
        _set_text(self.more, state.more)
        self.more.setVisible(bool(state.more))
        _set_text(self.notices, "\n".join(state.notices))
        self.notices.setVisible(bool(state.notices))
        self.results.show_rows(state.title, state.rows)

    def show_known(self, tabs: Sequence[tuple[str, str]], shipped: Sequence[tuple[str, str]]) -> None:
        """Fill the menu of the Load button: a file, (key, title) of the open tabs and of the shipped paints."""
        menu = self.load_menu
        menu.clear()
        menu.addAction(tr("From a &File…"), self.load_requested.emit)
        if tabs:
            menu.addSection(tr("Open tabs"))
        for key, title in tabs:
            menu.addAction(title.replace("&", "&&"), partial(self.known_requested.emit, key))
        inside = menu.addMenu(tr("&Sample Paint"))
        for key, title in shipped:
            inside.addAction(title, partial(self.known_requested.emit, key))

    def show_choices(self, names: Sequence[str], chosen: int) -> None:
        """Show the standards of the file that was loaded; a chooser only where there are several."""
        if [self.choices.itemText(k) for k in range(self.choices.count())] != list(names):
            self.choices.blockSignals(True)
            self.choices.clear()
            self.choices.addItems(list(names))
            self.choices.blockSignals(False)
        self.choices.blockSignals(True)
        self.choices.setCurrentIndex(chosen)
        self.choices.blockSignals(False)
        self.choices.setVisible(len(names) > 1)
        self.name.setVisible(len(names) <= 1)

    def show_settings(self, angles: Sequence[float], chosen: ToleranceSettings) -> None:
        """Show formula and tolerances."""
        own = chosen.difference.startswith("cmc:")
        self.formula.setCurrentIndex(self.formula.findData(OWN_CMC if own else chosen.difference))
        self.weights.setVisible(own)
        self.weights_label.setVisible(own)
        if own:
            lightness, chroma = chosen.difference.split(":")[1:]
            self.lightness.set_value(float(lightness))
            self.chroma.set_value(float(chroma))
        self.ellipsoid.setChecked(chosen.ellipsoid)
        self.tolerances.show_settings(angles, chosen)

    def _build_body(self) -> None:
        box = QVBoxLayout(self.body)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(8)
        self.choices = QuietComboBox()
        self.choices.setAccessibleName(tr("Standard"))
        self.choices.setToolTip(tr("Paint of this file that is the standard"))
        self.choices.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.choices.activated.connect(self.chosen)
        self.choices.hide()
        self.name, self.origin = _wrapped(""), _wrapped("")
        _embolden(self.name)
        self.verdict, self.sentence, self.more = _wrapped(""), _wrapped(""), _wrapped("")
        _embolden(self.verdict)
        self.sentence.setAccessibleName(tr("Differences in words"))
        self.results = ResultTable()
        self.results.setToolTip(
            tr("Batch minus standard at each aspecular angle, and the verdict of the tolerance")
        )
        self.notices = _wrapped("")
        for widget in (self.choices, self.name, self.origin, self.verdict, self.sentence, self.more):
            box.addWidget(widget)
        box.addWidget(self.results)
        box.addWidget(self.notices)
        box.addWidget(self._formula_form())
        box.addWidget(self._tolerance_section())
        box.addWidget(self._batch_section())

    def _formula_form(self) -> QWidget:
        form = Form()
        self.formula = QuietComboBox()
        for name, title in FORMULAS:
            self.formula.addItem(tr(title), name)
        self.formula.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.formula.activated.connect(lambda _index: self._choose_formula())
        form.add_row(tr("Difference"), self.formula, tr("Formula of ΔE and its tolerances"))
        self.lightness = NumberField(tr("Weight l of the lightness"), "", 0.1, 10.0, 0.1, 2, 2.0)
        self.chroma = NumberField(tr("Weight c of the chroma"), "", 0.1, 10.0, 0.1, 2, 1.0)
        for field in (self.lightness, self.chroma):
            field.setToolTip(
                tr("CMC(l:c) divides the lightness difference by l and the chroma difference by c")
            )
        self.weights = QWidget()
        row = QHBoxLayout(self.weights)
        row.setContentsMargins(0, 0, 0, 0)
        for text, weight in (("l", self.lightness), ("c", self.chroma)):
            row.addWidget(PlainLabel(text))
            row.addWidget(weight, 1)
            weight.edited.connect(lambda _value: self._choose_formula())
        tip = tr("A larger weight permits a larger difference")
        self.weights_label = form.add_row("l : c", self.weights, tip)
        self.weights.hide()
        self.weights_label.hide()
        return form

    def _choose_formula(self) -> None:
        name = str(self.formula.currentData())
        if name == OWN_CMC:
            name = f"cmc:{self.lightness.value():g}:{self.chroma.value():g}"
        self.formula_chosen.emit(name)

    def _tolerance_section(self) -> Section:
        section = Section(tr("Tolerances"), "standard_tolerances", is_open=False)
        self.tolerances = ToleranceTable()
        self.tolerances.setToolTip(
            tr("Permitted difference at each aspecular angle, in units of the formula above")
        )
        self.tolerances.limit_edited.connect(self.limit_edited)
        self.tolerances.refused.connect(self.refused)
        self.ellipsoid = QCheckBox(tr("ΔL*, ΔC*, ΔH* as one ellipsoid"))
        self.ellipsoid.setToolTip(
            tr(
                "Evaluate the three components together, with their tolerances as half axes; "
                "otherwise separately"
            )
        )
        self.ellipsoid.clicked.connect(self.ellipsoid_chosen)
        section.add(self.tolerances)
        section.add(self.ellipsoid)
        return section

    def _batch_section(self) -> Section:
        section = Section(tr("Batches"), "standard_batches", is_open=False)
        self.batches = BatchTable()
        self.batches.setToolTip(tr("Paints compared with this standard; Return or a double click opens one"))
        self.batches.opened.connect(self.batch_opened)
        section.add(self.batches)
        add = _button(tr("Add…"), tr("Compare more paints with this standard"), self.add_batches_requested)
        self.clear_batches = _button(
            tr("Clear"), tr("Remove the added paints; the tabs remain"), self.clear_batches_requested
        )
        self.add_batches = add
        row = QWidget()
        row.setLayout(_row(add, self.clear_batches))
        section.add(row)
        self.batch_section = section
        return section


def _button(text: str, tip: str, signal: SignalInstance | None) -> QPushButton:
    button = QPushButton(text)
    button.setToolTip(plain_tip(tip))
    button.setAccessibleDescription(tip)
    button.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
    button.setMinimumWidth(48)
    if signal is not None:
        button.clicked.connect(lambda _=False: signal.emit())
    return button


def _row(*widgets: QWidget) -> QHBoxLayout:
    row = QHBoxLayout()
    row.setContentsMargins(0, 0, 0, 0)
    row.setSpacing(4)
    for widget in widgets:
        row.addWidget(widget, 1)
    return row


def _wrapped(text: str) -> QLabel:
    label = PlainLabel(text)
    label.setWordWrap(True)
    label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    label.setMinimumWidth(80)
    return label


def _set_text(label: QLabel, text: str) -> None:
    if label.text() != text:
        label.setText(text)


def _embolden(label: QLabel) -> None:
    font = label.font()
    font.setBold(True)
    label.setFont(font)
