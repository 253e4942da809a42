"""How radiance becomes the light of the screen."""

from __future__ import annotations

from brdf_qt.form import Form
from brdf_qt.section import Section
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QComboBox, QWidget

TONE_TITLES = {
    "faithful": "Faithful, soft highlights",
    "neutral": "Neutral (Khronos PBR)",
    "characteristic": "Characteristic curve",
    "linear": "Linear, clipped",
}
TONE_TIPS = {
    "faithful": "Shows the colours as they are; rolls off only what is brighter than 0.8",
    "neutral": "Takes 4 % of reflection off the darks, keeps hue and saturation, rolls highlights off",
    "characteristic": "A film's S-shaped response in log exposure",
    "linear": "No curve: the one for judging a colour; too bright is cut off",
}


class ToneSection(Section):
    """How radiance becomes the light of the screen."""

    tone_curve_edited = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("Tone", "tone", parent)
        self.curve = QComboBox()
        for key, title in TONE_TITLES.items():
            self.curve.addItem(title, key)
            self.curve.setItemData(self.curve.count() - 1, TONE_TIPS[key], Qt.ItemDataRole.ToolTipRole)
        self.curve.activated.connect(lambda index: self.tone_curve_edited.emit(self.curve.itemData(index)))
        form = Form()
        form.add_row("Tone curve", self.curve, "From radiance to the screen, before gamma")
        self.add(form)

    def set_curve(self, key: str) -> None:
        """Show the present curve."""
        self.curve.setCurrentIndex(self.curve.findData(key))
