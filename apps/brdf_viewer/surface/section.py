"""Which form carries the paint, how it is taken, the parts of its mesh with their materials, and what is baked."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from brdf_qt.choosing.picker import SourceTiles
from brdf_qt.fields.choices import ChoiceBox, note
from brdf_qt.fields.form import Form, described, fill_column
from brdf_qt.fields.labels import PlainLabel
from brdf_qt.fields.quiet import QuietComboBox
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.section import Section
from PySide6.QtCore import QItemSelectionModel, QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QCheckBox,
    QHBoxLayout,
    QHeaderView,
    QPushButton,
    QTreeWidget,
    QTreeWidgetItem,
    QWidget,
)

from brdf_suite.documents.view_settings import MATERIALS, PARAMETERS, SurfaceLook
from brdf_suite.foreign_text import make_visible

MATERIAL_TITLES = {
    "paint": mark("Paint"),
    "second_paint": mark("Second paint"),
    "glass": mark("Glass"),
    "lens": mark("Clear lens"),
    "rubber": mark("Rubber"),
    "chrome": mark("Chrome"),
    "lamp": mark("Lamp"),
    "tail_lamp": mark("Tail lamp"),
    "trim": mark("Trim, matt black"),
    "cavity": mark("Dark cavity"),
    "gap": mark("Gap between panels"),
    "neutral": mark("Neutral grey"),
}
_OWN = ""
_NAME = Qt.ItemDataRole.UserRole
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
        row.addWidget(PlainLabel(tr("Material of selected parts")))
        row.addWidget(self.material, 1)
        fill_column(self, self.list, spacing=4).addLayout(row)
        self._show_material()

    def set_parts(self, parts: Sequence[tuple[str, str]]) -> None:
        """Show the names of the parts and the materials of their own."""
        self._own = dict(parts)
        with QSignalBlocker(self.list):
            self.list.clear()
            self.list.addTopLevelItems([_item(name) for name in self._own])
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
        return [str(item.data(0, _NAME)) for item in self.list.selectedItems()]

    def pick(self, name: str, *, add: bool = False) -> None:
        """Pick a part, beside those picked already where ``add``."""
        rows = (self.list.topLevelItem(row) for row in range(self.list.topLevelItemCount()))
        for item in [row for row in rows if row is not None and row.data(0, _NAME) == name]:
            flag = QItemSelectionModel.SelectionFlag
            self.list.setCurrentItem(item, 0, flag.Toggle if add else flag.ClearAndSelect)
            self.list.scrollToItem(item)

    def _show_all(self) -> None:
        for row in range(self.list.topLevelItemCount()):
            item = self.list.topLevelItem(row)
            if item is None:
                continue
            name = str(item.data(0, _NAME))
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


UNIT_TITLES = {
    "file": mark("From file"),
    "m": mark("Metres"),
    "cm": mark("Centimetres"),
    "mm": mark("Millimetres"),
    "in": mark("Inches"),
}
UP_TITLES = {"file": mark("From file"), "y": mark("Y up"), "z": mark("Z up")}
NORMALS_TITLES = {"file": mark("From file"), "smooth": mark("Smooth, edges above 40°"), "flat": mark("Flat")}


def _item(name: str) -> QTreeWidgetItem:
    item = QTreeWidgetItem([make_visible(name), ""])
    item.setData(0, _NAME, name)
    return item


class SurfaceSection(Section):
    """Emits ``edited(field, value)`` with a field of :class:`SurfaceLook`; setters are silent.

    ``daily`` has the form, and the ground that it stands on.
    """

    edited = Signal(str, object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Surface"), "surface", parent)
        self.daily = Form()
        self.chooser = SourceTiles(
            "forms", tr("Open a mesh (glTF, FBX, USD, STEP, OBJ, STL, PLY and others)")
        )
        self.facts = note(lines=2)
        self.occlusion = self._check("occlusion", tr("Occlusion"))
        self.occlusion.setToolTip(tr("Darkens recesses; computed once per surface in the background"))
        self.ground = self._check("ground", tr("Ground with contact shadow"))
        self.ground.setToolTip(
            tr("Ground at the lowest point of the surface, with its shadow in the environment's light")
        )
        self.baking = note(lines=1)
        self.again = QPushButton(tr("Compute"))
        self.again.setToolTip(tr("Restart the cancelled computation"))
        self.again.hide()
        self.parts = SurfaceParts()
        self.unit = self._list("unit", UNIT_TITLES)
        self.up = self._list("up", UP_TITLES)
        self.recentre = self._check("recentre", tr("Centre on ground"))
        self.normals = self._list("normals", NORMALS_TITLES)
        self.flip_normals = self._check("flip_normals", tr("Flip normals"))
        described(self.chooser.view, spoken=tr("Form"), tip=tr("Surface to which the paint is applied"))
        self.daily.add_wide(self.chooser)
        self.daily.add_row("", self.ground)
        form = self.add(Form())
        form.add_wide(self.parts, self.facts)
        form.add_row("", self.occlusion)
        form.add_wide(self.baking, self.again)
        form.add_row(tr("Unit"), self.unit, tr("Unit of length in the file"))
        form.add_row(tr("Up axis"), self.up, tr("Axis that points up in the file"))
        self.fineness = form.add_number(tr("Fineness"), PARAMETERS["surface.tessellation_mm"], 0.05, 3)
        self.fineness.edited.connect(lambda value: self.edited.emit("tessellation_mm", value))
        self.scale = form.add_number(tr("Scale"), PARAMETERS["surface.scale"], 0.1, 4)
        self.scale.edited.connect(lambda value: self.edited.emit("scale", value))
        tip = tr("Moves the centre over the origin and the lowest point to height 0")
        form.add_row(tr("Place"), self.recentre, tip)
        form.add_row(tr("Normals"), self.normals, tr("Read from the file, or recomputed"))
        form.add_row("", self.flip_normals, tr("For files whose triangles and normals point inwards"))

    def set_look(self, look: SurfaceLook) -> None:
        for name in ("occlusion", "ground", "recentre", "flip_normals"):
            getattr(self, name).setChecked(getattr(look, name))
        for name in ("unit", "up", "normals"):
            getattr(self, name).show_choice(getattr(look, name))
        self.scale.set_value(look.scale)
        self.fineness.set_value(look.tessellation_mm)
        self.parts.set_chosen(look.chosen)

    def _check(self, field: str, title: str) -> QCheckBox:
        box = QCheckBox(title)
        box.setObjectName(f"surface_{field}")
        box.clicked.connect(lambda on: self.edited.emit(field, on))
        return box

    def _list(self, field: str, titles: dict[str, str]) -> ChoiceBox:
        box = ChoiceBox(titles)
        box.setObjectName(f"surface_{field}")
        box.picked.connect(lambda key: self.edited.emit(field, key))
        return box
