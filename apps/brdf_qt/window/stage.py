"""The picture in the middle of a window, and drawers that slide over it from its edges.

Nothing around the picture moves when a drawer opens: it lies over the picture, which keeps its size.
"""

from __future__ import annotations

from typing import Literal

from PySide6.QtCore import QEasingCurve, QEvent, QRect, QSize, Qt, QVariantAnimation, Signal
from PySide6.QtGui import QAction, QResizeEvent
from PySide6.QtWidgets import QFrame, QSizePolicy, QToolButton, QWidget

from brdf_qt.fields.form import described, fill_column, icon_button, row_of
from brdf_qt.fields.labels import PlainLabel, set_bold
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import tr

Edge = Literal["left", "bottom"]
_SLIDE_MS = 120
_MARGIN = 8
_MOST_SHARE = 0.55
"""Of the width of the picture that drawers at its left may cover."""
_LEAST_HEIGHT = 140
"""Pixels below which a drawer at the left shows too little: those at the bottom leave it their place, then."""


class Drawer(QFrame):
    """A part that slides over the picture; whether it is open is remembered by its ``key``.

    ``toggled(open)`` where it was opened or closed.
    """

    toggled = Signal(bool)

    def __init__(self, key: str, title: str, widget: QWidget, edge: Edge, extent: int) -> None:
        super().__init__()
        self.edge, self.extent = edge, extent
        self._key = f"drawer/{key}"
        self.setObjectName(f"drawer_{key}")
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setAutoFillBackground(True)
        head = PlainLabel(title)
        set_bold(head, True)
        close = icon_button(
            "x", tr("Close {name}").format(name=title), lambda: self.set_open(False), flat=True
        )
        row = row_of(head, None, close)
        fill_column(self, row, widget, spacing=4, margins=(8, 4, 8, 8)).setStretchFactor(widget, 1)
        self.is_open = bool(settings().value(self._key, False, type=bool))
        self.reach = 1.0 if self.is_open else 0.0
        """How far it is over the picture: 0 beyond the edge, 1 open."""
        self._slide = QVariantAnimation(self)
        self._slide.setDuration(_SLIDE_MS)
        self._slide.setEasingCurve(QEasingCurve.Type.OutCubic)
        self._slide.valueChanged.connect(self._set_reach)
        self._slide.finished.connect(self._settle)
        self.setVisible(self.is_open)

    def set_open(self, is_open: bool) -> None:
        """Open or close it, and remember it."""
        if is_open == self.is_open:
            return
        self.is_open = is_open
        settings().setValue(self._key, is_open)
        if is_open:
            self.show()
            self.raise_()
        self._slide.stop()
        self._slide.setStartValue(self.reach)
        self._slide.setEndValue(1.0 if is_open else 0.0)
        self._slide.start()
        if not self.window().isVisible():
            self._slide.setCurrentTime(_SLIDE_MS)
        self.toggled.emit(is_open)

    def _set_reach(self, reach: float) -> None:
        self.reach = reach
        stage = self.parentWidget()
        if isinstance(stage, Stage):
            stage.place()

    def _settle(self) -> None:
        self.setVisible(self.is_open)
        stage = self.parentWidget()
        if isinstance(stage, Stage):
            stage.place()


class Stage(QWidget):
    """Holds the picture, at its upper left a bar with a button for each drawer, and the drawers."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("stage")
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(240, 160)
        self.drawers: dict[str, Drawer] = {}
        self._picture: QWidget | None = None
        self.bar = QFrame(self)
        self.bar.setObjectName("drawer_bar")
        self.bar.setAutoFillBackground(True)
        self._row = row_of(spacing=0)
        self.bar.setLayout(self._row)
        self.bar.hide()

    def set_picture(self, picture: QWidget) -> None:
        """Put ``picture`` under the drawers; it has all of the stage."""
        self._picture = picture
        picture.setParent(self)
        picture.lower()
        picture.show()
        self.place()

    def add_drawer(
        self, key: str, title: str, widget: QWidget, edge: Edge, extent: int, action: QAction
    ) -> Drawer:
        """Add a drawer with ``widget`` that ``action`` (checkable) opens and closes.

        One at the left is ``extent`` pixels wide; one at the bottom is as high as its widget wants.
        """
        drawer = self.drawers[key] = Drawer(key, title, widget, edge, extent)
        drawer.setParent(self)
        drawer.setVisible(drawer.is_open)
        action.setChecked(drawer.is_open)
        action.toggled.connect(drawer.set_open)
        drawer.toggled.connect(action.setChecked)
        self._add_button(title, action, len(self.drawers) - 1)
        return drawer

    def add_button(self, title: str, action: QAction) -> None:
        """Add a button for ``action`` at the end of the bar, behind those of the drawers."""
        self._add_button(title, action, self._row.count())

    def _add_button(self, title: str, action: QAction, place: int) -> None:
        button = described(QToolButton(), spoken=title)
        button.setDefaultAction(action)
        button.setText(title)
        button.setAutoRaise(True)
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        # The text of the action has the letter of a menu.
        action.changed.connect(lambda: button.setText(title))
        self._row.insertWidget(place, button)
        self.bar.show()
        self.place()

    def place(self) -> None:
        """Put picture, bar and drawers where they belong."""
        whole = self.rect()
        if self._picture is not None:
            self._picture.setGeometry(whole)
        self.bar.resize(self.bar.sizeHint())
        self.bar.move(_MARGIN, _MARGIN)
        left, bottom = self._at("left"), self._at("bottom")
        top = self.bar.geometry().bottom() + _MARGIN
        widths = [min(drawer.extent, round(_MOST_SHARE * whole.width())) for drawer in left]
        deep = sum(drawer.sizeHint().height() for drawer in bottom)
        is_crowded = whole.height() - deep - top < len(left) * _LEAST_HEIGHT
        begin = 0
        if is_crowded:
            begin = max(
                (round(drawer.reach * wide) for drawer, wide in zip(left, widths, strict=True)), default=0
            )
        low = whole.height()
        for drawer in bottom:
            deep = min(drawer.sizeHint().height(), whole.height())
            low -= round(drawer.reach * deep)
            drawer.setGeometry(begin, low, whole.width() - begin, deep)
        tall = max((whole.height() if is_crowded else low) - top, 80)
        for number, (drawer, wide) in enumerate(zip(left, widths, strict=True)):
            first = top + number * tall // len(left)
            last = top + (number + 1) * tall // len(left)
            drawer.setGeometry(QRect(round((drawer.reach - 1.0) * wide), first, wide, last - first))
        self.bar.raise_()

    def _at(self, edge: Edge) -> list[Drawer]:
        return [one for one in self.drawers.values() if one.edge == edge and not one.isHidden()]

    def sizeHint(self) -> QSize:
        return QSize(960, 640)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.place()

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.LayoutRequest:
            self.place()
        return super().event(event)
