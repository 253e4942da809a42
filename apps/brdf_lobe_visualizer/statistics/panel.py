"""The panel of figures, as a table, and the plot of the albedo: shown, copied and exported."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from brdf_qt.fields.choice_button import ChoiceButton
from brdf_qt.fields.form import described, fill_column, icon_button, row_of
from brdf_qt.fields.labels import PlainLabel, plain_tip
from brdf_qt.fields.quiet import QuietComboBox
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.feature import Feature
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import decimal, mark, tr
from brdf_qt.window.dialogs import QtDialogs
from brdf_qt.window.message_bar import Message, message_of
from PySide6.QtCore import (
    QAbstractTableModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    Qt,
    QTimer,
    Signal,
)
from PySide6.QtGui import QGuiApplication, QHideEvent, QIcon, QKeyEvent, QKeySequence, QShowEvent
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableView, QWidget

from brdf_lobe_visualizer.cuts.pens import line_icon
from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.statistics.plot import AlbedoLine, AlbedoPlot
from brdf_lobe_visualizer.statistics.work import FiguresWork
from brdf_lobe_visualizer.verdict import DELTA_E_LIMITS, verdict_of
from brdf_lobe_visualizer.window import LobeWindow
from brdf_suite.appearance.geometries import DEFAULT_SET, GEOMETRY_SETS
from brdf_suite.errors import SuiteError
from brdf_suite.foreign_text import guard_cell, make_visible
from brdf_suite.inspection.figures.text import Group, figure_rows, figures_text, save_figures

if TYPE_CHECKING:
    # What measures is much to import, and the panel is not seen at a first start.
    from brdf_suite.inspection.figures.figures import ReflectanceFigures
    from brdf_suite.inspection.figures.text import FigureRow

_NOTHING = 1e-9
_Index = QModelIndex | QPersistentModelIndex


@dataclass(frozen=True, eq=False)
class Column:
    """A reflectance: its title, its line, and whether its figures are of what it was before."""

    title: str
    line: QIcon
    stale: bool


class FiguresModel(QAbstractTableModel):
    """Rows and columns as they were given last."""

    def __init__(self) -> None:
        super().__init__()
        self._rows: Sequence[FigureRow] = ()
        self._columns: Sequence[Column] = ()

    def show(self, columns: Sequence[Column], rows: Sequence[FigureRow]) -> None:
        if len(rows) == len(self._rows) and len(columns) == len(self._columns):
            # The place that is scrolled to and the selection stay while a paint is dragged.
            self._rows, self._columns = rows, columns
            if not rows:
                return
            self.dataChanged.emit(self.index(0, 0), self.index(self.rowCount() - 1, self.columnCount() - 1))
            self.headerDataChanged.emit(Qt.Orientation.Horizontal, 0, self.columnCount() - 1)
        else:
            self.beginResetModel()
            self._rows, self._columns = rows, columns
            self.endResetModel()

    def rowCount(self, _parent: _Index = QModelIndex()) -> int:  # noqa: B008 - Qt's own signature
        return len(self._rows)

    def columnCount(self, _parent: _Index = QModelIndex()) -> int:  # noqa: B008 - Qt's own signature
        return 1 + len(self._columns)

    def data(self, index: _Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        row = self._rows[index.row()]
        if role == Qt.ItemDataRole.DisplayRole:
            return make_visible(self.text(index.row(), index.column()))
        if role == Qt.ItemDataRole.DecorationRole and index.column() > 0:
            value = row.values[index.column() - 1]
            if value is None or not row.name.startswith("ΔE00"):
                return None
            return verdict_of(value, DELTA_E_LIMITS).icon
        if role == Qt.ItemDataRole.TextAlignmentRole and index.column() > 0:
            return Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        if role == Qt.ItemDataRole.AccessibleTextRole and index.column() > 0:
            title = self._columns[index.column() - 1].title
            return f"{title}, {_named(row)}: {self.text(index.row(), index.column())}"
        return None

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if orientation != Qt.Orientation.Horizontal:
            return None
        if section == 0:
            return tr("Figure") if role == Qt.ItemDataRole.DisplayRole else None
        column = self._columns[section - 1]
        if role == Qt.ItemDataRole.DisplayRole:
            return make_visible(f"({column.title})" if column.stale else column.title)
        if role == Qt.ItemDataRole.DecorationRole:
            return column.line
        if role == Qt.ItemDataRole.ToolTipRole:
            stale = tr("{title}: outdated, being recomputed").format(title=column.title)
            return plain_tip(stale if column.stale else column.title)
        return None

    def text(self, row: int, column: int) -> str:
        shown = self._rows[row]
        if column == 0:
            return _named(shown)
        value = shown.values[column - 1]
        if value is None:
            return "–"
        # What rounding leaves of a difference of equals is none.
        return "0" if abs(value) < _NOTHING else decimal(f"{value:.4g}").replace("-", "−")


class FiguresTable(QTableView):
    """The table; Ctrl+C copies the selected cells, with tabs between them."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.figures = FiguresModel()
        self.setModel(self.figures)
        self.setAccessibleName(tr("Figures of the reflectances"))
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setAlternatingRowColors(True)
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 6)
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.matches(QKeySequence.StandardKey.Copy):
            self.copy_selected()
        else:
            super().keyPressEvent(event)

    def copy_selected(self) -> None:
        lines: dict[int, list[str]] = {}
        for row, column in sorted({(index.row(), index.column()) for index in self.selectedIndexes()}):
            lines.setdefault(row, []).append(guard_cell(self.figures.text(row, column)))
        if lines:
            QGuiApplication.clipboard().setText("\n".join("\t".join(line) for line in lines.values()))


def _named(row: FigureRow) -> str:
    name = tr_core(row.name)
    return f"{name}, {row.unit}" if row.unit else name


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
    """The table with its choices. Signals: ``group_chosen(str)``, ``copy_requested()``, ``export_requested()``,
    ``seen(bool)``.
    """

    group_chosen = Signal(str)
    copy_requested = Signal()
    export_requested = Signal()
    seen = Signal(bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("numbers")
        self.table = FiguresTable()
        self.note = PlainLabel()
        self.buttons = {key: ChoiceButton(tr(title)) for key, title in _GROUPS.items()}
        tip = tr("Geometries of the L*a*b* values (D65, 10° observer)")
        self.angles = described(QuietComboBox(), spoken=tr("Colour geometries"), tip=tip)
        for key, title in _ANGLES.items():
            self.angles.addItem(tr(title), key)
        for key, button in self.buttons.items():
            button.setAccessibleName(tr("Show {name}").format(name=button.text()))
            button.clicked.connect(lambda _=False, key=key: self.group_chosen.emit(key))
        head = row_of(
            *self.buttons.values(),
            self.angles,
            self.note,
            None,
            icon_button("copy", tr("Copy the table"), self.copy_requested.emit, flat=True),
            icon_button("export", tr("Export all figures as CSV"), self.export_requested.emit, flat=True),
        )
        fill_column(self, head, self.table, grows=self.table, spacing=4, margins=(8, 4, 8, 8))

    def show_choices(self, group: str, angles: str) -> None:
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
        filters = tr("Comma-separated values (*.csv)")
        self._ask_path = ask_path or (lambda suggested: QtDialogs(window).save_path(suggested, filters))
        # Nothing is worked out or imported before the window is painted, also where the panel was left open.
        self._ready = self._closed = False
        self.work = FiguresWork(session, window)
        self.panel, self.plot = NumbersPanel(), AlbedoPlot()
        self.dock = window.add_dock("numbers", mark("Numbers"), self.panel)
        window.plots.add("albedo", tr("Albedo"), self.plot)
        group = str(settings().value(_GROUP_KEY, "overview"))
        self._group: Group = _known_group(group) or "overview"
        angles = str(settings().value(_ANGLES_KEY, DEFAULT_SET))
        self.work.set_angles(angles if angles in _ANGLES else DEFAULT_SET)
        self.panel.show_choices(self._group, self.work.angles.name)
        self.panel.group_chosen.connect(self.choose_group)
        angles_field = self.panel.angles
        angles_field.activated.connect(lambda place: self.choose_angles(angles_field.itemData(place)))
        self.panel.copy_requested.connect(self.copy)
        self.panel.export_requested.connect(self.export)
        self.panel.seen.connect(lambda _seen: self._look())
        self.plot.seen.connect(lambda _seen: self._look())
        self.work.changed.connect(self._show)
        session.subjects_changed.connect(self._show_lines)
        session.front_changed.connect(self._show_lines)
        session.visibility_changed.connect(self._show)
        window.first_painted.connect(lambda: QTimer.singleShot(0, self, self._begin))
        tip = mark("Show or hide the figures")
        self.action = window.add_command(
            "view",
            mark("&Numbers"),
            "numbers",
            lambda: self.dock.setVisible(self.dock.isHidden()),
            icon="table",
            tip=tip,
        )
        tip = mark("Copy the visible table")
        window.add_command("edit", mark("&Copy Figures"), "copy_figures", self.copy, icon="copy", tip=tip)
        window.add_command("file", mark("&Export Figures…"), "export", self.export, icon="export")

    @property
    def is_idle(self) -> bool:
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
        self._group = group
        settings().setValue(_GROUP_KEY, group)
        self.panel.show_choices(group, self.work.angles.name)
        self._show()

    def choose_angles(self, name: str) -> None:
        settings().setValue(_ANGLES_KEY, name)
        self.work.set_angles(name)
        self.panel.show_choices(self._group, name)
        self._show()

    def copy(self) -> None:
        named = self._named()
        if named:
            QGuiApplication.clipboard().setText(figures_text(named, (self._group,)))

    def export(self) -> None:
        """Write all figures of the visible subjects as CSV."""
        named = self._named()
        if not named:
            text = tr("There are no figures to export yet.")
            todo = tr("Open the panel Numbers (F5) and wait until they are computed.")
            self._window.show_message(Message("figures", text, todo=todo))
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
        lines = []
        for subject in self._session.visible:
            figures = self.work.figures(subject.key)
            if figures is not None:
                curve, stale = figures.curve, self.work.is_stale(subject.key)
                front = subject is self._session.front
                lines.append(AlbedoLine(subject, curve.incidence_deg, curve.luminous, stale, front))
        self.plot.show_lines(lines)


def _known_group(text: str) -> Group | None:
    return next((group for group in _GROUPS if group == text), None)
