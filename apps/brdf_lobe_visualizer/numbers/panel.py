"""The panel of figures and the plot of the albedo: what is shown of :mod:`numbers_work`, copied, and exported."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from brdf_qt.fields.choice_button import ChoiceButton
from brdf_qt.fields.labels import PlainLabel, plain_tip
from brdf_qt.fields.quiet import QuietComboBox
from brdf_qt.program.feature import Feature
from brdf_qt.program.icons import icon
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.dialogs import QtDialogs
from brdf_qt.window.message_bar import Message, message_of
from PySide6.QtCore import QObject, Qt, QTimer, Signal
from PySide6.QtGui import QGuiApplication, QHideEvent, QShowEvent
from PySide6.QtWidgets import QHBoxLayout, QToolButton, QVBoxLayout, QWidget

from brdf_lobe_visualizer.legend.line import line_icon
from brdf_lobe_visualizer.numbers.plot import AlbedoLine, AlbedoPlot
from brdf_lobe_visualizer.numbers.table import Column, FiguresTable
from brdf_lobe_visualizer.numbers.work import FiguresWork
from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.window import LobeWindow
from brdf_suite.appearance.geometries import DEFAULT_SET, GEOMETRY_SETS
from brdf_suite.errors import SuiteError
from brdf_suite.inspection.figures.text import Group, figure_rows, figures_text, save_figures

if TYPE_CHECKING:
    from brdf_suite.inspection.figures.figures import ReflectanceFigures

_GROUP_KEY, _ANGLES_KEY, _FOLDER_KEY = "lobes/figures", "lobes/angles", "folder/figures"
_GROUPS: dict[Group, str] = {
    "overview": mark("Overview"),
    "albedo": mark("Albedo"),
    "colours": mark("Colours"),
    "errors": mark("Errors"),
}
_ANGLES = {
    "e2194": mark("three angles, ASTM E2194"),
    "five": mark("five angles"),
    "six": mark("six angles"),
    "e2539": mark("two illumination angles, ASTM E2539"),
}

AskPath = Callable[[Path], Path | None]
"""Asks where to write a file of that suggested name; None where nowhere."""


class NumbersPanel(QWidget):
    """The table with its choices. Signals: ``group_chosen(str)``, ``angles_chosen(str)``, ``copy_requested()``,
    ``export_requested()``, ``seen(bool)``.
    """

    group_chosen = Signal(str)
    angles_chosen = Signal(str)
    copy_requested = Signal()
    export_requested = Signal()
    seen = Signal(bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("numbers")
        self.table = FiguresTable()
        self.note = PlainLabel()
        self.buttons = {key: ChoiceButton(tr(title)) for key, title in _GROUPS.items()}
        self.angles = QuietComboBox()
        self.angles.setAccessibleName(tr("Colour geometries"))
        self.angles.setToolTip(tr("Geometries of the L*a*b* values (D65, 10° observer)"))
        for key, title in _ANGLES.items():
            self.angles.addItem(tr(title), key)
        self.angles.activated.connect(lambda place: self.angles_chosen.emit(self.angles.itemData(place)))
        head = QHBoxLayout()
        head.setSpacing(8)
        for key, button in self.buttons.items():
            button.setAccessibleName(tr("Show {name}").format(name=button.text()))
            button.clicked.connect(lambda _=False, key=key: self.group_chosen.emit(key))
            head.addWidget(button)
        head.addWidget(self.angles)
        head.addWidget(self.note)
        head.addStretch(1)
        for name, text, signal in (
            ("copy", tr("Copy the table"), self.copy_requested),
            ("export", tr("Export all figures as CSV"), self.export_requested),
        ):
            tool = QToolButton()
            tool.setIcon(icon(name))
            tool.setAutoRaise(True)
            tool.setToolTip(plain_tip(text))
            tool.setAccessibleName(text)
            tool.clicked.connect(signal)
            head.addWidget(tool)
        box = QVBoxLayout(self)
        box.setContentsMargins(8, 4, 8, 8)
        box.setSpacing(4)
        box.addLayout(head)
        box.addWidget(self.table, 1)

    def show_choices(self, group: str, angles: str) -> None:
        """Show which group and which angles are chosen."""
        for key, button in self.buttons.items():
            button.setChecked(key == group)
        self.angles.setCurrentIndex(self.angles.findData(angles))
        self.angles.setVisible(group == "colours")

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.seen.emit(True)

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self.seen.emit(False)


class Numbers(Feature, QObject):
    """A part of the window: the panel Numbers at the bottom, and the plot Albedo in the row of plots."""

    def __init__(self, session: LobeSession, window: LobeWindow, *, ask_path: AskPath | None = None) -> None:
        super().__init__(window)
        self._session, self._window = session, window
        self._ask_path = ask_path or _asks(window)
        # Nothing is worked out or imported before the window is painted, also where the panel was left open.
        self._ready = self._closed = False
        self.work = FiguresWork(session, window)
        self.panel, self.plot = NumbersPanel(), AlbedoPlot()
        self.dock = window.add_dock(
            "numbers", mark("Numbers"), self.panel, Qt.DockWidgetArea.BottomDockWidgetArea
        )
        window.add_plot("albedo", tr("Albedo"), self.plot)
        group = str(settings().value(_GROUP_KEY, "overview"))
        self._group: Group = _known_group(group) or "overview"
        angles = str(settings().value(_ANGLES_KEY, DEFAULT_SET))
        self.work.set_angles(angles if angles in _ANGLES else DEFAULT_SET)
        self.panel.show_choices(self._group, self.work.angles.name)
        self.panel.group_chosen.connect(self.choose_group)
        self.panel.angles_chosen.connect(self.choose_angles)
        self.panel.copy_requested.connect(self.copy)
        self.panel.export_requested.connect(self.export)
        self.panel.seen.connect(lambda _seen: self._look())
        self.plot.seen.connect(lambda _seen: self._look())
        self.work.changed.connect(self._show)
        session.subjects_changed.connect(self._show_lines)
        session.front_changed.connect(self._show_lines)
        session.visibility_changed.connect(self._show)
        window.first_painted.connect(lambda: QTimer.singleShot(0, self, self._begin))
        self.action = window.add_command(
            "view",
            mark("&Numbers"),
            "Ctrl+N",
            self._toggle,
            icon="table",
            tip=mark("Show or hide the figures"),
        )
        window.add_command(
            "edit",
            mark("&Copy Figures"),
            "Ctrl+Shift+N",
            self.copy,
            icon="copy",
            tip=mark("Copy the visible table"),
        )
        window.add_command("file", mark("&Export Figures…"), "Ctrl+E", self.export, icon="export")

    @property
    def is_idle(self) -> bool:
        """Whether the figures that are looked at are there."""
        return self._ready and self.work.is_idle

    def close(self) -> None:
        """End the work; what is hidden while the window goes is shown no more."""
        self._closed = True
        self.work.close()

    def run_script(self, key: str, value: str) -> bool:
        """Take ``figures=GROUP`` and ``angles=SET`` from the command line."""
        group = _known_group(value)
        if key == "figures" and group is not None:
            self.choose_group(group)
        elif key == "angles" and value in GEOMETRY_SETS:
            self.choose_angles(value)
        else:
            return False
        return True

    def choose_group(self, group: Group) -> None:
        """Show the figures of a group, and remember it."""
        self._group = group
        settings().setValue(_GROUP_KEY, group)
        self.panel.show_choices(group, self.work.angles.name)
        self._show()

    def choose_angles(self, name: str) -> None:
        """Read the colours at another set of geometries, and remember it."""
        settings().setValue(_ANGLES_KEY, name)
        self.work.set_angles(name)
        self.panel.show_choices(self._group, name)
        self._show()

    def copy(self) -> None:
        """Copy the table that is shown, as text with tabs."""
        named = self._named()
        if named:
            QGuiApplication.clipboard().setText(figures_text(named, (self._group,)))

    def export(self) -> None:
        """Write all figures of the visible subjects as CSV."""
        named = self._named()
        if not named:
            self._window.show_message(
                Message(
                    "figures",
                    tr("There are no figures to export yet."),
                    todo=tr("Open the panel Numbers (Ctrl+N) and wait until they are computed."),
                )
            )
            return
        path = self._ask_path(Path(str(settings().value(_FOLDER_KEY, ""))) / "reflectances.csv")
        if path is None:
            return
        settings().setValue(_FOLDER_KEY, str(path.parent))
        try:
            save_figures(named, path)
        except SuiteError as error:
            self._window.show_message(message_of(error, "figures"))
        else:
            text = tr("Figures of {count} reflectances exported to {path}.").format(
                count=len(named), path=path
            )
            self._window.show_message(Message("figures", text))

    def _toggle(self) -> None:
        self.dock.setVisible(self.dock.isHidden())

    def _begin(self) -> None:
        self._ready = True
        self._look()

    def _look(self) -> None:
        if self._closed or not self._ready:
            return
        self.work.set_needed(self.panel.isVisible() or self.plot.isVisible())
        self._show()

    def _named(self) -> list[tuple[str, ReflectanceFigures]]:
        found = [(s.title, self.work.figures(s.key)) for s in self._session.visible]
        return [(title, figures) for title, figures in found if figures is not None]

    def _show(self) -> None:
        if self._closed or not self._ready:
            return
        self._show_lines()
        if not self.panel.isVisible():
            return
        shown = [s for s in self._session.visible if self.work.figures(s.key) is not None]
        rows = [row for row in figure_rows(self._named()) if row.group == self._group]
        ratio = self.panel.devicePixelRatioF()
        columns = [
            Column(s.title, line_icon(s.colour, s.dash, ratio), self.work.is_stale(s.key)) for s in shown
        ]
        self.panel.table.figures.show(columns, rows)
        self.panel.note.setText(self._note())

    def _note(self) -> str:
        visible = self._session.visible
        if not visible:
            return tr("No reflectance shown.")
        if not self.work.is_idle:
            fresh = sum(not self.work.is_stale(s.key) for s in visible)
            return tr("{fresh} of {count} computed").format(fresh=fresh, count=len(visible))
        if self._group == "errors" and self._session.reference is None:
            return tr("Set a reference in the legend (R) to see differences.")
        return ""

    def _show_lines(self) -> None:
        front = self._session.front
        lines = []
        for subject in self._session.visible:
            figures = self.work.figures(subject.key)
            if figures is not None:
                curve = figures.curve
                stale = self.work.is_stale(subject.key)
                lines.append(
                    AlbedoLine(subject, curve.incidence_deg, curve.luminous, stale, subject is front)
                )
        self.plot.show_lines(lines)


def _asks(window: LobeWindow) -> AskPath:
    return lambda suggested: QtDialogs(window).save_path(suggested, tr("Comma-separated values (*.csv)"))


def _known_group(text: str) -> Group | None:
    return next((group for group in _GROUPS if group == text), None)
