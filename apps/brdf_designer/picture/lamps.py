"""Lamps in Designer's picture: the right button puts a highlight on the form; handles move the lamps.

As in Viewer the handles are seen while the tab of the light is open, and a drag of the right button turns the light.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Protocol

from brdf_qt.gl.gestures import is_click
from brdf_qt.gl.lamp_handles import LampHandles, SeenPlace, ray_through
from brdf_qt.gl.surface import GlSurface
from brdf_qt.program.translation import tr
from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, QRectF, Qt, SignalInstance
from PySide6.QtGui import QContextMenuEvent, QMouseEvent
from PySide6.QtWidgets import QMenu, QWidget

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import MOST_LAMPS, Lamp
from brdf_suite.realtime.camera import Bounds
from brdf_suite.surface.picking import pick

if TYPE_CHECKING:
    from brdf_suite.surface.mesh import Mesh


class ShownView(Protocol):
    """The view of the picture."""

    view: View

    def move(self, view: View) -> None:
        """Draw another view."""


class PictureLamps(QObject):
    """The lamps of the picture's view; ``page`` is the tab of the light, ``form`` gives the mesh that is drawn.

    ``view_changed(old, new)``: another view is shown.
    """

    def __init__(
        self,
        picture: ShownView,
        view_changed: SignalInstance,
        surface: GlSurface,
        page: QWidget,
        form: Callable[[], Mesh | None],
        bounds: Callable[[], Bounds | None],
    ) -> None:
        super().__init__(surface)
        self._picture, self._surface, self._page = picture, surface, page
        self._form, self._bounds = form, bounds
        self._pressed: QPointF | None = None
        self._chosen = 0
        self.handles = LampHandles(surface, self)
        page.installEventFilter(self)
        surface.canvas_changed.connect(self._listen)
        self._listen(surface.canvas)
        view_changed.connect(self.handles.follow_view)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Notice clicks of the right button, and leave every event to the camera's gestures."""
        kind = event.type()
        if watched is self._page:
            if kind in (QEvent.Type.Show, QEvent.Type.Hide):
                self.handles.show()
        elif isinstance(event, QMouseEvent) and event.button() == Qt.MouseButton.RightButton:
            if kind == QEvent.Type.MouseButtonPress:
                self._pressed = event.position()
            elif kind == QEvent.Type.MouseButtonRelease:
                pressed, self._pressed = self._pressed, None
                if pressed is not None and is_click(pressed, event):
                    self._open_menu(event.position())
        elif isinstance(event, QContextMenuEvent) and event.reason() == QContextMenuEvent.Reason.Keyboard:
            self._open_menu(QPointF(self._surface.canvas.rect().center()))
        return super().eventFilter(watched, event)

    def make_menu(self, place: QPointF) -> QMenu | None:
        """Return what can be done at a place of the canvas; None: nothing."""
        handle, lamps = self.handles.handle_at(place), self.view.lamps
        on_form = self.seen_at(place) is not None
        if not on_form and not lamps:
            return None
        menu = QMenu(self._surface)
        menu.setObjectName("lamp_menu")
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        put = menu.addAction(tr("Put the Highlight Here"), lambda: self.handles.put(place))
        put.setEnabled(on_form)
        another = menu.addAction(tr("Put Another Highlight Here"), lambda: self._put_another(place))
        another.setEnabled(on_form and 0 < len(lamps) < MOST_LAMPS)
        menu.addSeparator()
        index = None if handle is None else handle.number - 1
        one = menu.addAction(tr("Remove Lamp"), lambda: self._remove(index))
        one.setEnabled(index is not None)
        menu.addAction(tr("Remove All Lamps"), lambda: self.set_lamps(())).setEnabled(bool(lamps))
        return menu

    def _open_menu(self, place: QPointF) -> None:
        menu = self.make_menu(place)
        if menu is not None:
            menu.popup(self._surface.canvas.mapToGlobal(QPoint(round(place.x()), round(place.y()))))

    def _put_another(self, place: QPointF) -> None:
        self._chosen = len(self.view.lamps)
        self.handles.put(place)

    def _remove(self, index: int | None) -> None:
        if index is not None:
            self._chosen = 0
            self.set_lamps(tuple(lamp for number, lamp in enumerate(self.view.lamps) if number != index))

    def _listen(self, canvas: QWidget) -> None:
        canvas.installEventFilter(self)

    # The scene of the handles.

    @property
    def view(self) -> View:
        return self._picture.view

    @property
    def chosen(self) -> int:
        return self._chosen

    @property
    def wants_handles(self) -> bool:
        return self._page.isVisible() and self._form() is not None

    @property
    def box(self) -> QRectF:
        return QRectF(0.0, 0.0, 1.0, 1.0)

    def seen_at(self, place: QPointF) -> SeenPlace | None:
        form, bounds, canvas = self._form(), self._bounds(), self._surface.canvas
        if form is None or bounds is None:
            return None
        share = QPointF(place.x() / max(1, canvas.width()), place.y() / max(1, canvas.height()))
        eye, ray = ray_through(self.view, bounds, self._surface.device_size, share)
        hit = pick(form, eye, ray)
        return None if hit is None else SeenPlace(hit.position, hit.normal, eye)

    def choose(self, index: int) -> None:
        self._chosen = index

    def begin_drag(self) -> None:
        """Nothing: the view has no history."""

    def end_drag(self) -> None:
        """Nothing: see :meth:`begin_drag`."""

    def set_lamps(self, lamps: tuple[Lamp, ...]) -> None:
        self._picture.move(replace(self.view, lamps=lamps))
