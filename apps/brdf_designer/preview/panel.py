"""The small picture beside the plot, with its light; where nothing can be drawn it says so in its place."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from brdf_qt.fields.form import described, fill_column, row_of
from brdf_qt.fields.labels import PlainLabel
from brdf_qt.fields.quiet import QuietComboBox
from brdf_qt.program.names import title_of
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QFrame, QLabel, QSizePolicy, QWidget

from brdf_designer.preview.scene import LIGHTS
from brdf_designer.window.caption import Caption

if TYPE_CHECKING:
    from brdf_qt.gl.surface import GlSurface

_TIP = mark(
    "The paint on the speed form, drawn by the renderer of Viewer. Drag orbits, "
    "wheel zooms, Alt drag or right drag rotates the light, F frames."
)
_NO_GL_PLATFORMS = ("offscreen", "minimal", "linuxfb", "vnc")


def can_draw() -> bool:
    """Whether this Qt platform can show OpenGL in a widget at all; whether the driver can is found out by trying."""
    return QGuiApplication.platformName() not in _NO_GL_PLATFORMS


class PreviewPanel(QWidget):
    """Caption, choice of light and picture; ``light_chosen(name)`` where another light is wanted.

    ``make_surface`` makes the widget that draws; where the platform has no OpenGL it is not asked, and a text stands
    in the picture's place.
    """

    light_chosen = Signal(str)

    def __init__(self, make_surface: Callable[[], GlSurface], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("preview")
        self.setMinimumSize(180, 120)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.caption = Caption("")
        self.light = QuietComboBox()
        self.light.setAccessibleName(tr("Light of the preview"))
        self.light.setToolTip(tr("Light of the preview"))
        for name in LIGHTS:
            self.light.addItem(title_of(name), name)
        # No taller than the caption of the plot beside it, so that plot and picture begin at one height.
        self.light.setFixedHeight(self.fontMetrics().height() + 4)
        self.light.activated.connect(lambda row: self.light_chosen.emit(self.light.itemData(row)))
        head = row_of(self.caption, self.light, grows=self.caption)
        self._box = fill_column(self, head, spacing=4)
        self.surface: GlSurface | None = None
        self.notice: QLabel | None = None
        if can_draw():
            self.surface = described(make_surface(), spoken=tr("The paint on the speed form"), tip=tr(_TIP))
            self._box.addWidget(self.surface, 1)
        else:
            self._say_why_not()
        self.show_state(stale=False)

    def show_light(self, name: str) -> None:
        """Show which light is chosen; nothing is emitted."""
        self.light.setCurrentIndex(self.light.findData(name))

    def show_state(self, *, stale: bool) -> None:
        """Say whether the picture is of the paint as it is now."""
        if stale:
            self.caption.set_forms(tr("Speed form: last possible paint"), tr("Speed form (earlier)"))
        else:
            self.caption.set_forms(tr("On the speed form"), tr("Speed form"))

    def grey(self) -> tuple[float, float, float]:
        """Return the surround, for the picture while there is nothing to draw."""
        level = self.palette().window().color().redF()
        return (level, level, level)

    def _say_why_not(self) -> None:
        text = tr(
            "No preview: OpenGL is not available on this screen. Numbers, patches and "
            "curves are complete. Open the paint file in Viewer on another computer to see "
            "it."
        )
        self.notice = described(PlainLabel(text), spoken=text)
        self.notice.setWordWrap(True)
        self.notice.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.notice.setFrameShape(QFrame.Shape.StyledPanel)
        self.notice.setMargin(16)
        self.light.setEnabled(False)
        self._box.addWidget(self.notice, 1)
