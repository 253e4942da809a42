"""What comes and goes over the picture: it lies on what is below, and moves nothing."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QPoint, QSize, Qt
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QWidget

WIDEST = 720
_MARGIN = 8


class Floating(QWidget):
    """A widget at the top or the bottom edge of another one, over it; as high as it needs, and in the middle.

    Made without a place it is a widget like others; :meth:`float_over` gives it one.
    """

    def __init__(self, edge: Qt.Edge, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._edge = edge
        self._below: QWidget | None = None
        self._bar: QWidget | None = None

    def float_over(self, below: QWidget, inside: QWidget, bar: QWidget | None = None) -> None:
        """Lie over ``below``, which is ``inside`` or in it; ``inside`` is a widget whose children can lie anywhere.

        At the top edge a ``bar``, a child of ``below`` along that edge, stays in sight.
        """
        self._bar = bar if self._edge == Qt.Edge.TopEdge else None
        for widget in (self._below, self.parentWidget()):
            if widget is not None:
                widget.removeEventFilter(self)
        shown = not self.isHidden()
        self._below = below
        self.setParent(inside)
        for widget in (below, inside):
            widget.installEventFilter(self)
        self.setVisible(shown)
        self._settle()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._settle()

    def event(self, event: QEvent) -> bool:
        done = super().event(event)
        if event.type() == QEvent.Type.LayoutRequest:
            self._settle()
        return done

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in (QEvent.Type.Resize, QEvent.Type.Move, QEvent.Type.Show):
            self._settle()
        return super().eventFilter(watched, event)

    def _settle(self) -> None:
        inside, layout = self.parentWidget(), self.layout()
        if self._below is None or inside is None or layout is None or self.isHidden():
            return
        taken = 0 if self._bar is None or self._bar.isHidden() else self._bar.geometry().bottom() + 1
        room = self._below.size() - QSize(2 * _MARGIN, 2 * _MARGIN + taken)
        width = max(self.minimumSizeHint().width(), min(room.width(), WIDEST))
        wanted = layout.heightForWidth(width) if layout.hasHeightForWidth() else self.sizeHint().height()
        height = min(wanted, max(room.height(), self.minimumSizeHint().height()))
        corner = self._below.mapTo(inside, QPoint(0, 0))
        x = corner.x() + (self._below.width() - width) // 2
        at_top = self._edge == Qt.Edge.TopEdge
        y = corner.y() + (taken + _MARGIN if at_top else self._below.height() - height - _MARGIN)
        self.setGeometry(x, y, width, height)
        self.raise_()
