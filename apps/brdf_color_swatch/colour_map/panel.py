"""The map of what is shown, as a panel: in three dimensions, and in planes. pyqtgraph comes with its first showing."""

from __future__ import annotations

from typing import TYPE_CHECKING

from brdf_qt.fields.choice_button import ChoiceButton
from brdf_qt.fields.form import described, fill_column, row_of
from brdf_qt.fields.labels import PlainLabel
from brdf_qt.fields.quiet import QuietComboBox
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import mark, tr
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QOffscreenSurface, QOpenGLContext
from PySide6.QtWidgets import QStackedWidget, QWidget

from brdf_color_swatch.colour_map.points import MapPoints
from brdf_color_swatch.feature import SwatchFeature
from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow

if TYPE_CHECKING:
    from brdf_color_swatch.colour_map.plane import PlaneMap
    from brdf_color_swatch.colour_map.space import SpaceMap

_KEY = "map/kind"
_ROOM_PX = 1250
"""From this width of the window on, map and inspector have room beside each other."""
_HANDLES_PX = 24
"""For the handles between swatches, panels and the window's edges."""
_KINDS = {
    "space": (
        mark("a* b* L*"),
        mark("All swatches in three dimensions. Left drag rotates, Ctrl+left drag selects"),
    ),
    "flop": (mark("Flop over L*"), mark("Flop index over lightness at 45°. Left drag selects")),
    "ab": (mark("a* b*"), mark("b* over a* at 45°. Left drag selects")),
    "gloss": (mark("Gloss over flop"), mark("Gloss at 20° over flop index. Left drag selects")),
}


class ColourMap(SwatchFeature):
    """Builds the panel when it is first shown, and keeps it in step with the pane in front."""

    def __init__(self, session: PaletteSession, window: SwatchWindow) -> None:
        super().__init__(session, window)
        self.space: SpaceMap | None = None
        self.plane: PlaneMap | None = None
        self._built = False
        self._beside: tuple[int, int] | None = None
        """While the panel stands beside them: the widths of library and inspector before it came."""
        kind = str(settings().value(_KEY, ""))
        self.chosen_kind = kind if kind in _KINDS else ""
        self.kind = self.chosen_kind or "flop"
        self.kinds = described(QuietComboBox(), name="map_kind", spoken=tr("Type of map"))
        for place, (key, (title, tip)) in enumerate(_KINDS.items()):
            self.kinds.addItem(tr(title), key)
            self.kinds.setItemData(place, tr(tip), Qt.ItemDataRole.ToolTipRole)
        self.kinds.activated.connect(lambda _place: self.choose(self.kinds.currentData()))
        tip = tr("Left drag selects swatches with a lasso. Ctrl adds to the selection, Alt removes")
        self.lasso = described(ChoiceButton(tr("Lasso")), name="map_lasso", tip=tip)
        self.lasso.toggled.connect(self._set_lasso)
        self.stack = QStackedWidget()
        self.stack.setMinimumSize(200, 160)
        self.note = PlainLabel(wordWrap=True, alignment=Qt.AlignmentFlag.AlignCenter)
        self.stack.addWidget(self.note)
        inside, head = QWidget(), row_of(self.kinds, None, self.lasso, spacing=4)
        fill_column(inside, head, self.stack, grows=self.stack, spacing=4, margins=(8, 4, 8, 8))
        self.dock = window.add_dock("map", mark("Map"), inside, Qt.DockWidgetArea.RightDockWidgetArea)
        self.action = window.add_command(
            "view", mark("Colour &Map"), "map", self.toggle, "map", icon="map-trifold"
        )
        self.action.setCheckable(True)
        window.toolbar.addAction(self.action)
        self.dock.visibilityChanged.connect(self._visible)
        self._soon = make_timer(window, self._show)
        session.shown_changed.connect(lambda _pane: self._later())
        session.front_changed.connect(self._later)
        session.selection_changed.connect(lambda _pane: self._show_chosen())
        window.add_command("view", mark("Fra&me All in Map"), "frame", self.frame, "frame_map")
        self.points: MapPoints | None = None

    @property
    def is_idle(self) -> bool:
        return self.dock.isHidden() or (self._built and not self._soon.isActive())

    def toggle(self) -> None:
        self._set_shown(self.dock.isHidden())

    def choose(self, kind: str) -> None:
        self.chosen_kind = kind
        settings().setValue(_KEY, kind)
        self._show()

    def run_script(self, key: str, value: str) -> bool:
        """Show a map by a script: ``map=flop``."""
        if key != "map" or value not in _KINDS:
            return False
        self._set_shown(True)
        self.choose(value)
        return True

    def _set_shown(self, shown: bool) -> None:
        if shown and self.dock.isHidden() and not self.dock.isFloating():
            self._place()
        self.dock.setVisible(shown)
        if shown:
            self.dock.raise_()

    def frame(self) -> None:
        view = self.space if self.kind == "space" else self.plane
        if view is not None:
            view.frame()

    def _place(self) -> None:
        """Put the panel between swatches and inspector; in a narrow window over the inspector, with a tab for each."""
        window = self._window
        if window.width() < _ROOM_PX:
            window.tabifyDockWidget(window.inspector_dock, self.dock)
            return
        # Before the panel is shown: it takes its first room from the inspector.
        library, inspector = window.library_dock.width(), window.inspector_dock.width()
        window.splitDockWidget(self.dock, window.inspector_dock, Qt.Orientation.Horizontal)
        self.dock.show()
        docks = [window.library_dock, self.dock, window.inspector_dock]
        # Taken from the swatches alone, and no more than they can spare: library and inspector keep theirs.
        centre = window.centralWidget()
        spared = centre.minimumSizeHint().width() if centre is not None else 0
        room = window.width() - library - inspector - spared
        wide = min(round(0.32 * window.width()), room - _HANDLES_PX)
        widths = [library, max(self.dock.minimumSizeHint().width(), wide), inspector]
        window.resizeDocks(docks, widths, Qt.Orientation.Horizontal)
        self._beside = library, inspector

    def _restore_widths(self) -> None:
        """Give the room of the panel back to the swatches, where Qt gives it to the inspector."""
        library, inspector = self._beside or (0, 0)
        self._beside = None
        window = self._window
        docks = [window.library_dock, window.inspector_dock]
        # As they stand now, or wider where the panel has pressed them together.
        widths = [max(library, window.library_dock.width()), max(inspector, window.inspector_dock.width())]
        window.resizeDocks(docks, widths, Qt.Orientation.Horizontal)

    def _visible(self, shown: bool) -> None:
        self.action.setChecked(not self.dock.isHidden())
        if self.dock.isHidden() and self._beside is not None:
            self._restore_widths()
        if shown:
            self._later()

    def _later(self) -> None:
        if not self.dock.isHidden() and not self._soon.isActive():
            self._soon.start()

    def _show(self) -> None:
        points = MapPoints.of(self._session.shown[self._session.front])
        # Until the user chooses: flat colours have no flop, and would lie in one line.
        self.kind = self.chosen_kind or ("ab" if points.are_flat else "flop")
        self.kinds.setCurrentIndex(self.kinds.findData(self.kind))
        self.kinds.setToolTip(tr(_KINDS[self.kind][1]))
        if self.dock.isHidden():
            return
        self._built = True
        self.points = points
        self.lasso.setEnabled(self.kind == "space")
        if not len(points):
            self._show_note(tr("No swatches to show."))
            return
        if self.kind == "space":
            view = self._space()
            if view is None:
                return
            view.show_points(points)
        else:
            view = self._plane()
            view.show_points(points, self.kind)
        self.stack.setCurrentWidget(view)
        self._show_chosen()

    def _show_note(self, text: str) -> None:
        self.note.setText(text)
        self.stack.setCurrentWidget(self.note)

    def _show_unavailable(self) -> None:
        self._show_note(
            tr("The three-dimensional map needs OpenGL, which is not available here. Use one of the planes.")
        )

    def _plane(self) -> PlaneMap:
        if self.plane is None:
            # A quarter of a second to import: not at the start of the program.
            from brdf_color_swatch.colour_map.plane import PlaneMap

            self.plane = PlaneMap()
            self.plane.chosen.connect(self._chosen)
            self.stack.addWidget(self.plane)
        return self.plane

    def _space(self) -> SpaceMap | None:
        if self.space is None:
            if QGuiApplication.platformName() in ("offscreen", "minimal") or not _has_gl():
                self._show_unavailable()
                return None
            from brdf_color_swatch.colour_map.space import SpaceMap

            self.space = SpaceMap()
            self.space.lasso = self.lasso.isChecked()
            self.space.chosen.connect(self._chosen)
            self.space.failed.connect(self._show_unavailable)
            self.stack.addWidget(self.space)
        return self.space

    def _set_lasso(self, on: bool) -> None:
        if self.space is not None:
            self.space.lasso = on
            self.space.setCursor(Qt.CursorShape.CrossCursor if on else Qt.CursorShape.ArrowCursor)

    def _show_chosen(self) -> None:
        if self.dock.isHidden() or self.points is None:
            return
        ids = set(self._session.selected)
        if self.kind == "space" and self.space is not None:
            self.space.show_chosen(ids)
        elif self.plane is not None:
            self.plane.show_chosen(ids)

    def _chosen(self, ids: tuple[str, ...], mode: str) -> None:
        """Select what was chosen in the map, in the pane."""
        before = self._session.selected
        if mode == "add":
            ids = tuple(dict.fromkeys((*before, *ids)))
        elif mode == "drop":
            ids = tuple(key for key in before if key not in set(ids))
        pane = self._window.panes[self._session.front]
        if ids:
            focused = self._window.focusWidget()
            self._session.reveal(ids)
            if focused is not None:
                focused.setFocus(Qt.FocusReason.OtherFocusReason)
        else:
            pane.grid.clearSelection()


def _has_gl() -> bool:
    """Whether a context of OpenGL can be made here."""
    context = QOpenGLContext()
    if not context.create():
        return False
    surface = QOffscreenSurface()
    surface.setFormat(context.format())
    surface.create()
    there = context.makeCurrent(surface)
    if there:
        context.doneCurrent()
    return bool(there)
