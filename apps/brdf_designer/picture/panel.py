"""The picture's place in the middle of the window; where nothing can be drawn it says so there."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from brdf_qt.fields.form import described, fill_column, fill_row
from brdf_qt.fields.labels import PlainLabel
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QResizeEvent
from PySide6.QtWidgets import QFrame, QLabel, QWidget

from brdf_designer.picture.three_lights import LightName

if TYPE_CHECKING:
    from brdf_qt.gl.surface import GlSurface

_TIP = mark(
    "The paint, drawn by the renderer of Viewer. Drag orbits, Shift drag pans, wheel zooms, Alt drag or right drag "
    "rotates the light, F frames."
)
_NO_GL_PLATFORMS = ("offscreen", "minimal", "linuxfb", "vnc")
_MARGIN = 8
_BETWEEN = 2
_SHARE, _SIDE_SHARE = 3, 2
"""How the width is divided where there are more pictures beside the first."""


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
        self._box = fill_row(self, spacing=_BETWEEN)
        self._side = QWidget()
        self._side_box = fill_column(self._side, spacing=_BETWEEN)
        self._side.hide()
        self.surface: GlSurface | None = None
        self.notice: QLabel | None = None
        if can_draw():
            self.surface = described(make_surface(), spoken=tr("The paint on the form"), tip=tr(_TIP))
            self._box.addWidget(self.surface, _SHARE)
            self._box.addWidget(self._side, _SIDE_SHARE)
        else:
            self._say_why_not()
        self.word = described(PlainLabel("", self), name="picture_word")
        self.word.setAutoFillBackground(True)
        self.word.setFrameShape(QFrame.Shape.StyledPanel)
        self.word.setMargin(6)
        self.word.hide()
        self.light = LightName(self)
        self.light.hide()

    def show_beside(self, panes: Sequence[QWidget], light: str) -> None:
        """Show more pictures at the right, one above the other, and name the ``light`` of the first; () hides them."""
        for pane in panes:
            self._side_box.addWidget(pane, 1)
        self._side.setVisible(bool(panes))
        self.light.setVisible(bool(panes))
        self.show_light(light)
        self._box.activate()
        self._place()

    def show_light(self, name: str) -> None:
        """Name the light of the first picture."""
        self.light.show_light(name, self.height())

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
        right = self.width() if self._side.isHidden() else self._side.x() - _BETWEEN
        self.word.move(right - self.word.width() - _MARGIN, _MARGIN)
        self.word.raise_()
        self.light.move(self.light.x(), self.height() - self.light.height() - _MARGIN)

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
