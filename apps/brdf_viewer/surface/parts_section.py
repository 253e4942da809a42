"""The parts of a mesh with the material of each; several can be picked, in the list or in the picture."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from brdf_qt.fields.labels import PlainLabel
from brdf_qt.fields.quiet import QuietComboBox
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import QItemSelectionModel, Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QHeaderView,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from brdf_suite.documents.view_settings import MATERIALS

MATERIAL_TITLES = {
    "paint": mark("Paint"),
    "glass": mark("Glass"),
    "rubber": mark("Rubber"),
    "chrome": mark("Chrome"),
    "lamp": mark("Lamp"),
    "tail_lamp": mark("Tail lamp"),
    "trim": mark("Trim, matt black"),
    "cavity": mark("Dark cavity"),
    "neutral": mark("Neutral grey"),
}
_OWN = ""
_ROWS_SHOWN = 7


class SurfaceParts(QWidget):
    """Emits ``material_edited(names, material)``; an empty material gives the parts back their own."""

    material_edited = Signal(list, str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._own: dict[str, str] = {}
        self._chosen: dict[str, str] = {}
        self.list = QTreeWidget()
        self.list.setAccessibleName(tr("Parts"))
        self.list.setHeaderLabels([tr("Part"), tr("Material")])
        self.list.setRootIsDecorated(False)
        self.list.setUniformRowHeights(True)
        self.list.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.list.setToolTip(
            tr("Click a part in the picture to select it; Ctrl and Shift select several in the list")
        )
        header = self.list.header()
        header.setStretchLastSection(False)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        header.setSectionResizeMode(1, QHeaderView.ResizeMode.ResizeToContents)
        self.list.itemSelectionChanged.connect(self._show_material)
        self.material = QuietComboBox()
        self.material.setAccessibleName(tr("Material of selected parts"))
        self.material.setToolTip(tr("Material of the parts selected above"))
        self.material.addItem(tr("From file"), _OWN)
        for word in MATERIALS:
            self.material.addItem(tr(MATERIAL_TITLES[word]), word)
        self.material.activated.connect(self._edited)
        row = QHBoxLayout()
        row.setSpacing(8)
        row.addWidget(PlainLabel(tr("Material of selected parts")))
        row.addWidget(self.material, 1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        layout.addWidget(self.list)
        layout.addLayout(row)
        self._show_material()

    def set_parts(self, parts: Sequence[tuple[str, str]]) -> None:
        """Show the names of the parts and the materials of their own."""
        self._own = dict(parts)
        self.list.blockSignals(True)
        self.list.clear()
        self.list.addTopLevelItems([QTreeWidgetItem([name, ""]) for name in self._own])
        self.list.blockSignals(False)
        rows = min(max(len(self._own), 1), _ROWS_SHOWN)
        height = self.list.sizeHintForRow(0) if self._own else self.list.fontMetrics().height() + 4
        self.list.setFixedHeight(self.list.header().sizeHint().height() + rows * height + 4)
        self._show_all()

    def set_chosen(self, chosen: Mapping[str, str]) -> None:
        """Show the materials that were chosen in place of the parts' own."""
        if chosen != self._chosen:
            self._chosen = dict(chosen)
            self._show_all()

    def picked(self) -> list[str]:
        """Return the names of the picked parts."""
        return [item.text(0) for item in self.list.selectedItems()]

    def pick(self, name: str, *, add: bool = False) -> None:
        """Pick a part, beside those picked already where ``add``."""
        for item in self.list.findItems(name, Qt.MatchFlag.MatchExactly, 0):
            flag = QItemSelectionModel.SelectionFlag
            self.list.setCurrentItem(item, 0, flag.Toggle if add else flag.ClearAndSelect)
            self.list.scrollToItem(item)

    def _show_all(self) -> None:
        for row in range(self.list.topLevelItemCount()):
            item = self.list.topLevelItem(row)
            if item is None:
                continue
            name = item.text(0)
            chosen = self._chosen.get(name)
            item.setText(1, tr(MATERIAL_TITLES[chosen or self._own[name]]))
            font = item.font(1)
            font.setBold(chosen is not None)  # what the user chose looks different from what the file says
            item.setFont(1, font)
        self._show_material()

    def _show_material(self) -> None:
        picked = self.picked()
        self.material.setEnabled(bool(picked))
        shown = {self._chosen.get(name, _OWN) for name in picked}
        self.material.setCurrentIndex(self.material.findData(shown.pop()) if len(shown) == 1 else -1)

    def _edited(self, index: int) -> None:
        self.material_edited.emit(self.picked(), self.material.itemData(index))
