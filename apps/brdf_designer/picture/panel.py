"""The picture's place in the middle of the window; where nothing can be drawn it says so there."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from brdf_qt.fields.form import described, fill_column
from brdf_qt.fields.labels import PlainLabel
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QResizeEvent
from PySide6.QtWidgets import QFrame, QLabel, QWidget

if TYPE_CHECKING:
    from brdf_qt.gl.surface import GlSurface

_TIP = mark(
    "The paint, drawn by the renderer of Viewer. Drag orbits, Shift drag pans, wheel zooms, Alt drag or right drag "
    "rotates the light, F frames."
)
_NO_GL_PLATFORMS = ("offscreen", "minimal", "linuxfb", "vnc")
_MARGIN = 8


def can_draw() -> bool:
    """Whether this Qt platform can show OpenGL in a widget at all; whether the driver can is found out by trying."""
    return QGuiApplication.platformName() not in _NO_GL_PLATFORMS


class PicturePanel(QWidget):
    """The surface that draws, and over it a word where the picture is not of the paint as it is now.

    ``make_surface`` makes the surface; where the platform has no OpenGL it is not asked, and a text stands in the
    picture's place.
    """

    def __init__(self, make_surface: Callable[[], GlSurface], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("picture")
        self._box = fill_column(self, spacing=0)
        self.surface: GlSurface | None = None
        self.notice: QLabel | None = None
        if can_draw():
            self.surface = described(make_surface(), spoken=tr("The paint on the form"), tip=tr(_TIP))
            self._box.addWidget(self.surface, 1)
        else:
            self._say_why_not()
        self.word = described(PlainLabel("", self), name="picture_word")
        self.word.setAutoFillBackground(True)
        self.word.setFrameShape(QFrame.Shape.StyledPanel)
        self.word.setMargin(6)
        self.word.hide()

    def show_state(self, *, stale: bool) -> None:
        """Say whether the picture is of the paint as it is now."""
        if stale != self.word.isHidden():
            return  # it says so already
        self.word.setText(tr("⚠ Last possible paint") if stale else "")
        self.word.setVisible(stale)
        self._place()

    def grey(self) -> tuple[float, float, float]:
        """Return the surround, for the picture while there is nothing to draw."""
        level = self.palette().window().color().redF()
        return (level, level, level)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._place()

    def _place(self) -> None:
        self.word.adjustSize()
        self.word.move(self.width() - self.word.width() - _MARGIN, _MARGIN)
        self.word.raise_()

    def _say_why_not(self) -> None:
        text = tr(
            "No picture: OpenGL is not available on this screen. Numbers, patches and "
            "curves are complete. Open the paint file in Viewer on another computer to see "
            "it."
        )
        self.notice = described(PlainLabel(text), spoken=text)
        self.notice.setWordWrap(True)
        self.notice.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.notice.setFrameShape(QFrame.Shape.StyledPanel)
        self.notice.setMargin(16)
        self._box.addWidget(self.notice, 1)
