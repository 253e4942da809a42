"""Parts selected in the picture: a click takes one, the right button opens what can be done with it."""

from __future__ import annotations

from functools import partial

from brdf_qt.gl.gestures import is_click
from brdf_qt.program.names import title_of
from brdf_qt.program.translation import mark, tr
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, Qt, Signal
from PySide6.QtGui import QContextMenuEvent, QGuiApplication, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QMenu

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import MATERIALS, SECOND_PAINT
from brdf_suite.foreign_text import make_visible
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.overlay.part_layer import PartLayer
from brdf_viewer.overlay.seen_parts import SeenParts
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.surface.control import SurfaceControl
from brdf_viewer.surface.section import MATERIAL_TITLES
from brdf_viewer.window import ViewerWindow

_REST_MS = 80
_FIRST_BARE = "glass"
"""The first of the materials that are no paints."""
_NAMES_SHOWN = 3


class PartControl(ViewerFeature):
    """Keeps the selection of the list of parts and its outline in the picture together.

    ``highlight_wanted(place)``: a lamp is to be mirrored at a place of the canvas, QPointF in logical pixels.
    """

    highlight_wanted = Signal(QPointF)

    def __init__(
        self, state: ViewerState, window: ViewerWindow, surface: SurfaceControl, seen: SeenParts
    ) -> None:
        super().__init__(state, window)
        self._surface, self._seen = surface, seen
        self._parts = window.surface.parts
        self.layer = PartLayer(window.picture)
        self._pressed: tuple[Qt.MouseButton, QPointF] | None = None
        self._proposed: tuple[list[str], str] | None = None
        self._rest = make_timer(self, self._show, _REST_MS)
        self._parts.list.itemSelectionChanged.connect(self._rest.start)
        state.view_changed.connect(self._view_changed)
        state.contents_changed.connect(self._rest.start)
        window.picture.frame_drawn.connect(self._rest.start)
        window.picture.canvas_changed.connect(self._watch)
        self._watch(window.picture.canvas)

    def propose(self, names: list[str], label: str) -> None:
        """Mark these parts instead of the selected ones, with words of what is going to happen to them."""
        self._proposed = (names, label)
        self._show()

    def end_proposal(self) -> None:
        """Mark the selected parts again."""
        self._proposed = None
        self._show()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Notice clicks, and leave every event to the camera's gestures."""
        kind = event.type()
        if isinstance(event, QMouseEvent) and kind == QEvent.Type.MouseButtonPress:
            plain = not event.modifiers() & ~Qt.KeyboardModifier.ControlModifier
            self._pressed = (event.button(), event.position()) if plain else None
        elif isinstance(event, QMouseEvent) and kind == QEvent.Type.MouseButtonRelease:
            pressed, self._pressed = self._pressed, None
            if pressed is not None and pressed[0] == event.button() and is_click(pressed[1], event):
                self._clicked(event)
        elif isinstance(event, QContextMenuEvent) and event.reason() == QContextMenuEvent.Reason.Keyboard:
            self._open_menu(self._window.picture.canvas.rect().center())
        elif (
            isinstance(event, QKeyEvent) and kind == QEvent.Type.KeyPress and event.key() == Qt.Key.Key_Escape
        ):
            self._parts.list.clearSelection()
        return super().eventFilter(watched, event)

    def _watch(self, canvas: QObject) -> None:
        canvas.installEventFilter(self)

    def _clicked(self, event: QMouseEvent) -> None:
        surface, hit = self._state.surface, self._seen.hit_at(event.position())
        name = "" if surface is None or hit is None else surface.value.parts[hit.part].name
        if event.button() == Qt.MouseButton.LeftButton:
            held = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
            if name:
                self._parts.pick(name, add=held)
            elif not held:
                self._parts.list.clearSelection()
        elif event.button() == Qt.MouseButton.RightButton and name:
            if name not in self._parts.picked():
                self._parts.pick(name)
            self._open_menu(event.position().toPoint())

    def _open_menu(self, place: QPoint) -> None:
        names = self._parts.picked()
        if names:
            menu = self.make_menu(names)
            menu.addSeparator()
            put = partial(self.highlight_wanted.emit, QPointF(place))
            menu.addAction(tr("Put the Highlight Here"), put)
            menu.popup(self._window.picture.canvas.mapToGlobal(place))

    def make_menu(self, names: list[str]) -> QMenu:
        """Return the menu of these parts: paints, materials, and back to the file's own."""
        menu = QMenu(self._window.picture)
        menu.setObjectName("part_menu")
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        title = menu.addAction(make_visible(_words(names)))
        title.setEnabled(False)
        menu.addSeparator()
        given = self._surface.materials_of(names)
        second = self._state.view.two_tone.paint
        for material in MATERIALS:
            if material == _FIRST_BARE:
                menu.addSeparator()
            text = tr(MATERIAL_TITLES[material])
            if material == SECOND_PAINT and second is not None:
                text = tr("{material} ({paint})").format(material=text, paint=title_of(second))
            action = menu.addAction(text, partial(self._surface.give, names, material))
            action.setCheckable(True)
            action.setChecked(given == {material})
        menu.addSeparator()
        own = menu.addAction(tr("Reset to the File's Material"), partial(self._surface.give, names, ""))
        own.setEnabled(any(name in self._state.view.surface_look.chosen for name in names))
        return menu

    def _view_changed(self, old: View, new: View) -> None:
        if old.camera != new.camera and self.layer.marks:
            self.layer.show_marks((), "")  # it would stay behind
        self._rest.start()

    def _show(self) -> None:
        if self._proposed is not None:
            names, label = self._proposed
            self.layer.show_marks(self._seen.marks_of(names), label)
            return
        names = self._parts.picked()
        if not names:
            self.layer.show_marks((), "")
        elif QGuiApplication.mouseButtons() != Qt.MouseButton.NoButton:
            self._rest.start()
        else:
            given = self._surface.materials_of(names)
            label = _words(names)
            if len(given) == 1:
                label = tr(_LABEL).format(part=label, material=tr(MATERIAL_TITLES[given.pop()]))
            marks = self._seen.marks_of(names)
            self.layer.show_marks(marks, label if marks else "")


_LABEL = mark("{part} – {material}")


def _words(names: list[str]) -> str:
    """Return the names of parts, or how many they are."""
    if len(names) <= _NAMES_SHOWN:
        return ", ".join(names)
    return tr("{count} parts").format(count=len(names))
