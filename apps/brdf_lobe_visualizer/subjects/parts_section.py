"""The section Parts of the inspector: target and fit, and the fit's lobes, each with a switch."""

from __future__ import annotations

from brdf_qt.fields.form import described, fill_column
from brdf_qt.fields.labels import ElidedLabel, PlainLabel
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QIcon, QPixmap
from PySide6.QtWidgets import QCheckBox, QGridLayout, QPushButton, QWidget

from brdf_lobe_visualizer.option_form import OptionForm
from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.view3d.section import SpaceState
from brdf_lobe_visualizer.words import PART_TITLES, lobe_weight, number
from brdf_suite.inspection.lobe_surface.parts import FIT_PARTS, PART_CODES, FitLobe, FitPart, fit_lobes

_SHOWN = {
    "target": mark("Target"),
    "fit": mark("Fit"),
    "both": mark("Fit over target"),
    "side by side": mark("Side by side"),
    "difference": mark("Difference"),
}
_STYLES = {"lines": mark("Lines"), "glass": mark("Transparent"), "solid": mark("Solid")}
_VIEWS = {
    "sum": mark("Sum"),
    "parts": mark("Three parts"),
    "stacked": mark("Stacked"),
    "apart": mark("Separate lobes"),
}


class PartsSection(QWidget):
    """Sets what is shown of target and fit, and which lobes are on."""

    def __init__(self, session: LobeSession, state: SpaceState, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("parts_section")
        self._session, self._state = session, state
        self._listed: tuple[FitLobe, ...] | None = None
        form = self._form = OptionForm(state, session)
        tip = tr(
            "What all views show of each reflectance. Differences are against the legend's reference, "
            "or else between fit and target."
        )
        form.choice("shown", _SHOWN, tr("Show"), tip)
        tip = tr("Style of the fit where it overlays its target")
        self.style_ = form.choice("fit_style", _STYLES, tr("Fit style"), tip)
        tip = tr("How the lobes of a fit are shown")
        form.choice("lobes", _VIEWS, tr("Lobes"), tip, self._choose_lobes)
        self.gloss = described(
            form.tick("gloss", tr("Gloss")),
            tip=tr("Show the gloss of targets and fits; without it the base alone, where a paint has layers"),
        )
        self.switches: dict[tuple[FitPart, int], QCheckBox] = {}
        self._list = QWidget()
        self._grid = QGridLayout(self._list)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(8)
        self._grid.setVerticalSpacing(4)
        self._grid.setColumnStretch(1, 1)
        self.none = PlainLabel(tr("The selected reflectance has no fit."), wordWrap=True)
        tip = tr("Switch all lobes on and restore the default display")
        self.reset = described(QPushButton(tr("Reset Parts")), tip=tip)
        self.reset.clicked.connect(self._reset)
        fill_column(self, form, self.gloss, self._list, self.none, self.reset)
        for signal in (
            session.options_changed,
            session.subjects_changed,
            session.front_changed,
            state.changed,
        ):
            signal.connect(self.show_now)
        self.show_now()

    def show_now(self) -> None:
        shared = self._session.options
        self._form.show_now()
        self.style_.setEnabled(shared.shown == "both")
        front = self._session.front
        lobes = () if front is None or front.fit is None else fit_lobes(front.fit.weights)
        if lobes != self._listed:
            self._list_lobes(lobes)
        for key, switch in self.switches.items():
            switch.setChecked(key not in shared.lobes_off)
        self.none.setVisible(not lobes)
        self._list.setVisible(bool(lobes))

    def _list_lobes(self, lobes: tuple[FitLobe, ...]) -> None:
        while self._grid.count():
            taken = self._grid.takeAt(0)
            widget = None if taken is None else taken.widget()
            if widget is not None:
                widget.deleteLater()
        self.switches = {}
        self._listed = lobes
        row = 0
        for part in FIT_PARTS:
            of_part = [lobe for lobe in lobes if lobe.part == part]
            if not of_part:
                continue
            tip = tr("Switch all lobes of this part on or off")
            whole = described(QPushButton(_swatch(part), tr(PART_TITLES[part]), flat=True), tip=tip)
            whole.clicked.connect(lambda _on=False, rows=tuple(of_part): self._switch_part(rows))
            self._grid.addWidget(whole, row, 0, 1, 2, Qt.AlignmentFlag.AlignLeft)
            row += 1
            for lobe in of_part:
                text = tr("KD")
                if lobe.exponent is not None:
                    text = tr("E = {exponent}").format(exponent=number(lobe.exponent))
                switch = self.switches[lobe.key] = QCheckBox(text)
                switch.setAccessibleName(f"{tr(PART_TITLES[part])} {text}")
                switch.clicked.connect(lambda on, key=lobe.key: self._session.switch_lobe(key[0], key[1], on))
                tip = lobe_weight(lobe) + "\n" + tr("Weight (linear Rec. 2020 red, green, blue)")
                weight = described(ElidedLabel(lobe_weight(lobe)), tip=tip)
                self._grid.addWidget(switch, row, 0)
                self._grid.addWidget(weight, row, 1)
                row += 1

    def _switch_part(self, lobes: tuple[FitLobe, ...]) -> None:
        off = self._session.options.lobes_off
        keys = frozenset(lobe.key for lobe in lobes)
        self._session.set_options(lobes_off=off - keys if keys & off else off | keys)

    def _choose_lobes(self, key: str) -> None:
        self._state.set(lobes=key)
        # Lobes are of the fit: who wants to see them wants to see it.
        if key != "sum" and self._session.options.shown not in ("fit", "side by side"):
            self._session.set_options(shown="fit")

    def _reset(self) -> None:
        self._state.reset("fit_style", "lobes")
        self._session.reset_options("shown", "lobes_off", "gloss")


def _swatch(part: FitPart) -> QIcon:
    pixmap = QPixmap(12, 12)
    pixmap.fill(QColor(*PART_CODES[part]))
    return QIcon(pixmap)
