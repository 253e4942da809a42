"""Which form carries the paint."""

from __future__ import annotations

from brdf_qt.form import Form
from brdf_qt.section import Section
from PySide6.QtWidgets import QWidget

from brdf_viewer.sections.note import note
from brdf_viewer.source_chooser import SourceChooser


class SurfaceSection(Section):
    """Which form carries the paint."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("Surface", "surface", parent)
        self.chooser = SourceChooser("Open a mesh (.glb, .gltf, .obj, .stl, .ply)")
        self.facts = note()
        form = Form()
        form.add_row("Form", self.chooser, "The surface on which the paint is judged")
        form.add_wide(self.facts)
        self.add(form)
