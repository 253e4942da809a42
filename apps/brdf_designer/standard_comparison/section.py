"""The Standard section: which standard, by which formula and tolerances, and what came of it."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from brdf_qt.fields.form import Form, fill_column, fill_row
from brdf_qt.fields.labels import PlainLabel
from brdf_qt.fields.marks import verdict_mark
from brdf_qt.fields.number import NumberField
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.section import Section
from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtWidgets import QCheckBox, QMenu, QWidget

from brdf_designer.standard_comparison.settings import ToleranceSettings
from brdf_designer.standard_comparison.state import StandardState
from brdf_designer.standard_comparison.tables import BatchTable, ResultTable, ToleranceTable
from brdf_designer.window.widgets import button, combo, make_row, set_font, wrapped
from brdf_suite.foreign_text import make_visible

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
    of a file, ``formula_chosen(name)``, ``ellipsoid_chosen(on)``, ``add_batches_requested``,
    ``clear_batches_requested``; and those of the tables ``tolerances`` and ``batches``.
    """

    take_requested = Signal()
    load_requested = Signal()
    known_requested = Signal(str)
    known_list_requested = Signal()
    swap_requested = Signal()
    remove_requested = Signal()
    chosen = Signal(int)
    formula_chosen = Signal(str)
    ellipsoid_chosen = Signal(bool)
    add_batches_requested = Signal()
    clear_batches_requested = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        tip = tr("Use the current state as the standard")
        self.take = button(tr("This State"), tip, self.take_requested.emit)
        tip = tr("Load an open tab, a sample paint, or a file: paint, palette, CxF3, measured BRDF")
        self.load = button(tr("Load"), tip)
        self.load_menu = QMenu(self.load)
        self.load_menu.aboutToShow.connect(self.known_list_requested)
        self.load.setMenu(self.load_menu)
        tip = tr("Edit the standard and compare it with the current paint")
        self.swap = button(tr("Swap"), tip, self.swap_requested.emit)
        self.remove = button(tr("Remove"), tr("Remove the standard"), self.remove_requested.emit)
        self.empty, self.body = wrapped(tr(_EMPTY)), QWidget()
        fill_column(
            self, make_row(self.take, self.load, self.swap, self.remove, spacing=4), self.empty, self.body
        )
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
        for label, text in (
            (self.name, state.name),
            (self.origin, tr_core(state.origin)),
            (self.verdict, state.verdict),
            (self.sentence, state.sentence),
            (self.more, state.more),
            (self.notices, tr_core("\n".join(state.notices))),
        ):
            if label.text() != text:
                label.setText(text)
            if label in (self.origin, self.more, self.notices):
                label.setVisible(bool(text))
        self.verdict.set_mark(verdict_mark(state.passes))
        self.results.show_rows(state.title, state.rows)

    def show_known(self, tabs: Sequence[tuple[str, str]], shipped: Sequence[tuple[str, str]]) -> None:
        """Fill the menu of the Load button: a file, (key, title) of the open tabs and of the shipped paints."""
        menu = self.load_menu
        menu.clear()
        menu.addAction(tr("From a &File…"), self.load_requested.emit)
        if tabs:
            menu.addSection(tr("Open tabs"))
        for key, title in tabs:
            menu.addAction(make_visible(title).replace("&", "&&"), partial(self.known_requested.emit, key))
        inside = menu.addMenu(tr("&Sample Paint"))
        for key, title in shipped:
            inside.addAction(title, partial(self.known_requested.emit, key))

    def show_choices(self, names: Sequence[str], chosen: int) -> None:
        """Show the standards of the file that was loaded; a chooser only where there are several."""
        with QSignalBlocker(self.choices):
            shown = [make_visible(name) for name in names]
            if [self.choices.itemText(k) for k in range(self.choices.count())] != shown:
                self.choices.clear()
                self.choices.addItems(shown)
            self.choices.setCurrentIndex(chosen)
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
        self.choices = combo((), tr("Standard"), tr("Paint of this file that is the standard"))
        self.choices.activated.connect(self.chosen)
        self.choices.hide()
        self.name, self.origin, self.verdict, self.sentence, self.more, self.notices = (
            wrapped() for _ in range(6)
        )
        for label in (self.name, self.verdict):
            label.setFont(self.font())  # results, not remarks
            set_font(label, bold=True)
        self.sentence.setAccessibleName(tr("Differences in words"))
        self.results = ResultTable()
        self.results.setToolTip(
            tr("Batch minus standard at each aspecular angle, and the verdict of the tolerance")
        )
        heads = (self.choices, self.name, self.origin, self.verdict, self.sentence, self.more)
        parts = (self._formula_form(), self._tolerance_section(), self._batch_section())
        fill_column(self.body, *heads, self.results, self.notices, *parts)

    def _formula_form(self) -> QWidget:
        form = Form()
        self.formula = combo((tr(title), name) for name, title in FORMULAS)
        self.formula.activated.connect(lambda _index: self._choose_formula())
        form.add_row(tr("Difference"), self.formula, tr("Formula of ΔE and its tolerances"))
        self.lightness = NumberField(tr("Weight l of the lightness"), "", 0.1, 10.0, 0.1, 2, 2.0)
        self.chroma = NumberField(tr("Weight c of the chroma"), "", 0.1, 10.0, 0.1, 2, 1.0)
        for field in (self.lightness, self.chroma):
            field.setToolTip(
                tr("CMC(l:c) divides the lightness difference by l and the chroma difference by c")
            )
        self.weights = QWidget()
        weights = fill_row(self.weights)
        for text, weight in (("l", self.lightness), ("c", self.chroma)):
            weights.addWidget(PlainLabel(text))
            weights.addWidget(weight, 1)
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
        section.add(self.batches)
        tip = tr("Compare more paints with this standard")
        self.add_batches = button(tr("Add…"), tip, self.add_batches_requested.emit)
        tip = tr("Remove the added paints; the tabs remain")
        self.clear_batches = button(tr("Clear"), tip, self.clear_batches_requested.emit)
        section.add(make_row(self.add_batches, self.clear_batches, spacing=4))
        self.batch_section = section
        return section
