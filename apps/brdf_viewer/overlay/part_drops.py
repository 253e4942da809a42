"""Paints dropped on the picture: the paint of all, or the second paint of a part."""

from __future__ import annotations

from dataclasses import dataclass

from brdf_qt.choosing.dropped_paint import dropped_paint, holds_paint
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QDragMoveEvent, QDropEvent
from PySide6.QtWidgets import QWidget

from brdf_suite.documents.view_settings import SECOND_PAINT
from brdf_suite.errors import SuiteError
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.overlay.part_control import PartControl
from brdf_viewer.overlay.seen_parts import SeenParts
from brdf_viewer.paint.control import PaintControl
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.surface.control import SurfaceControl
from brdf_viewer.window import ViewerWindow

_KEY = "dropped"
_ALL, _ALL_OR_ONE = mark("Paint"), mark("Paint – with Ctrl: second paint of {parts}")
_ONE = mark("Second paint of {parts}")


@dataclass(frozen=True)
class _Aim:
    """``parts`` get the second paint; none: all gets the paint. ``label`` says so."""

    parts: list[str]
    label: str


class PartDrops(ViewerFeature):
    """Takes paints that are dropped on the canvas; what else is dropped is the window's.

    On a part of the first paint, and beside the surface, the first paint is replaced. A part that is selected or not
    of the first paint gets the second paint, and so does any part while Ctrl is held.
    """

    def __init__(
        self,
        state: ViewerState,
        window: ViewerWindow,
        seen: SeenParts,
        parts: PartControl,
        surface: SurfaceControl,
        paint: PaintControl,
    ) -> None:
        super().__init__(state, window)
        self._seen, self._parts, self._surface, self._paint = seen, parts, surface, paint
        window.picture.canvas_changed.connect(self._watch)
        self._watch(window.picture.canvas)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kind = event.type()
        if kind == QEvent.Type.DragLeave:
            self._parts.end_proposal()
        elif isinstance(event, QDropEvent) and holds_paint(event.mimeData()):
            aim = self._aim(event)
            if kind == QEvent.Type.Drop:
                self._parts.end_proposal()
                self._drop(event, aim)
            else:
                self._parts.propose(aim.parts, aim.label)
            event.setDropAction(Qt.DropAction.CopyAction)
            event.accept()
            return True
        return super().eventFilter(watched, event)

    def _watch(self, canvas: QWidget) -> None:
        canvas.setAcceptDrops(True)
        canvas.installEventFilter(self)

    def _aim(self, event: QDropEvent | QDragMoveEvent) -> _Aim:
        name = self._seen.part_at(event.position())
        if not name:
            return _Aim([], tr(_ALL))
        picked = self._window.surface.parts.picked()
        names = picked if name in picked else [name]
        words = ", ".join(names) if len(names) <= 2 else tr("{count} parts").format(count=len(names))
        held = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        if name in picked or held or self._surface.materials_of([name]) != {"paint"}:
            return _Aim(names, tr(_ONE).format(parts=words))
        return _Aim([], tr(_ALL_OR_ONE).format(parts=words))

    def _drop(self, event: QDropEvent, aim: _Aim) -> None:
        try:
            paint = dropped_paint(event.mimeData())
        except SuiteError as error:
            self._report(error, _KEY, tr("The picture is unchanged."))
            return
        self._window.messages.dismiss(_KEY)
        if aim.parts:
            self._surface.give(aim.parts, SECOND_PAINT, second=paint)
        else:
            self._paint.open(paint)
