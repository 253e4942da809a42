"""Which form carries the paint, how it is taken, what its parts are made of, and what is baked for it."""

from __future__ import annotations

from brdf_qt.fields.form import Form
from brdf_qt.fields.number import NumberField
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.section import Section
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QPushButton, QWidget

from brdf_suite.documents.view_settings import PARAMETERS, SurfaceLook
from brdf_viewer.fields.choice_box import ChoiceBox
from brdf_viewer.fields.note import note
from brdf_viewer.fields.source_chooser import SourceChooser
from brdf_viewer.surface.parts_section import SurfaceParts

UNIT_TITLES = {
    "file": mark("From file"),
    "m": mark("Metres"),
    "cm": mark("Centimetres"),
    "mm": mark("Millimetres"),
    "in": mark("Inches"),
}
NORMALS_TITLES = {"file": mark("From file"), "smooth": mark("Smooth, edges above 40°"), "flat": mark("Flat")}


class SurfaceSection(Section):
    """Emits ``edited(field, value)`` with a field of :class:`SurfaceLook`; setters are silent."""

    edited = Signal(str, object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Surface"), "surface", parent)
        self.chooser = SourceChooser(tr("Open a mesh (.glb, .gltf, .obj, .stl, .ply)"))
        self.facts = note()
        self.occlusion = self._check("occlusion", tr("Occlusion"))
        self.occlusion.setToolTip(tr("Darkens recesses; computed once per surface in the background"))
        self.ground = self._check("ground", tr("Ground with contact shadow"))
        self.ground.setToolTip(
            tr("Ground at the lowest point of the surface, with its shadow in the environment's light")
        )
        self.baking = note()
        self.again = QPushButton(tr("Compute"))
        self.again.setToolTip(tr("Restart the cancelled computation"))
        self.again.hide()
        self.parts = SurfaceParts()
        self.unit = self._list("unit", UNIT_TITLES)
        scale = PARAMETERS["surface.scale"]
        self.scale = NumberField(tr("Scale"), "", scale.low, scale.high, 0.1, 4, scale.default)
        self.scale.edited.connect(lambda value: self.edited.emit("scale", value))
        self.recentre = self._check("recentre", tr("Centre on ground"))
        self.normals = self._list("normals", NORMALS_TITLES)
        self.flip_normals = self._check("flip_normals", tr("Flip normals"))
        form = Form()
        form.add_row(tr("Form"), self.chooser, tr("Surface to which the paint is applied"))
        form.add_wide(self.facts)
        form.add_row("", self.occlusion)
        form.add_row("", self.ground)
        form.add_wide(self.baking)
        form.add_wide(self.again)
        form.add_wide(self.parts)
        form.add_row(tr("Unit"), self.unit, tr("Unit of length in the file"))
        form.add_row(tr("Scale"), self.scale, tr(scale.meaning))
        form.add_row(
            tr("Place"),
            self.recentre,
            tr("Moves the centre over the origin and the lowest point to height 0"),
        )
        form.add_row(tr("Normals"), self.normals, tr("Read from the file, or recomputed"))
        form.add_row("", self.flip_normals, tr("For files whose triangles and normals point inwards"))
        self.add(form)

    def set_look(self, look: SurfaceLook) -> None:
        """Show the present settings."""
        for name in ("occlusion", "ground", "recentre", "flip_normals"):
            getattr(self, name).setChecked(getattr(look, name))
        for name in ("unit", "normals"):
            getattr(self, name).show_choice(getattr(look, name))
        self.scale.set_value(look.scale)
        self.parts.set_chosen({item.part: item.material for item in look.materials})

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
