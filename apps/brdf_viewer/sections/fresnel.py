"""How the coat follows the angle."""

from __future__ import annotations

from brdf_qt.section import Section
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QWidget


class FresnelSection(Section):
    """Whether the coat brightens towards grazing angles."""

    fresnel_edited = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("Fresnel", "fresnel", parent)
        self.on = QCheckBox("Coat brightens towards grazing")
        self.on.setToolTip("Exact dielectric Fresnel on the sharp lobes; off shows the fit as it is at 45°")
        self.on.clicked.connect(lambda on: self.fresnel_edited.emit("raised" if on else "off"))
        self.add(self.on)

    def set_mode(self, mode: str) -> None:
        """Show the present mode."""
        self.on.setChecked(mode != "off")
