"""One Viewer for the tests of a run: brought back to its start between them, or replaced where it cannot be.

To bring a Viewer back takes a fifth of the time of a start. What a user sees of it and what its parts hold is noted
when it has started, and again before each later test: it is used only where all of that is the same. So no test sees
what another one did, in whatever order they run.
"""

from __future__ import annotations

import dataclasses
import os
from collections import Counter, deque
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
from brdf_qt.choosing.picker import SourceChooser, SourceTiles
from brdf_qt.choosing.sources import Source
from brdf_qt.program.settings import settings
from PySide6.QtCore import QCoreApplication, QEvent, QMetaMethod, QObject, SignalInstance
from PySide6.QtGui import QAction, QUndoStack
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSlider,
    QApplication,
    QComboBox,
    QDockWidget,
    QLabel,
    QLineEdit,
    QMenu,
    QProgressBar,
    QWidget,
)

from brdf_suite.documents.store import view_to_json

CHANGING = {
    *("_frames", "_losses", "_settled", "counted", "frame_ms", "reading"),  # by the time that something takes
    *("_generation", "_gesture", "_latest", "generation", "newest"),  # counts of what was done
    *("_button", "_last", "_merged"),  # of a gesture that is over; the next one begins by setting them
    *("_tallest", "_widest"),  # the place that the longest text so far is given
    *("_encoded", "_widths"),  # what was worked out of a document and of texts, to be looked up again
    "_bounds",  # of the surface, which is compared
}
"""Attributes that are not compared: they say nothing of what a Viewer will do."""
CHANGING_CELLS = ("frame", "readout")
PLAIN = ("brdf_suite.documents", "brdf_suite.lighting.statistics", "PySide6")
"""Where the values are from that are compared as such; of others it is compared which object they are."""
PICTURES = ("brdf_qt.choosing.thumbnails", "brdf_qt.choosing.scenes", "brdf_qt.work.pictures")
"""Where the parts are from that keep small pictures once they are made; they and their threads are not compared."""


class Same:
    """Equal to the very same object only, which it keeps."""

    __hash__ = None

    def __init__(self, value: object) -> None:
        self.value = value

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Same) and self.value is other.value


def noted(value: Any, depth: int = 3) -> object:
    """Return what is compared of an attribute: plain values, the inside of containers, or which object it is."""
    kind = type(value)
    if value is None or kind in (bool, int, float, str, bytes):
        return value
    if kind.__module__.startswith(PLAIN) and not isinstance(value, QObject):
        return value
    if depth and isinstance(value, list | tuple | set | frozenset | deque):
        return kind, [noted(inner, depth - 1) for inner in value]
    if depth and isinstance(value, dict):
        return [(noted(key, depth - 1), noted(inner, depth - 1)) for key, inner in value.items()]
    if (
        depth
        and kind.__module__.startswith(("brdf_viewer", "brdf_qt.choosing"))
        and dataclasses.is_dataclass(value)
    ):
        inside = {field.name: getattr(value, field.name) for field in dataclasses.fields(value)}
        return kind, noted(inside, depth - 1)
    return Same(value)


def attributes(owner: object) -> dict[str, object]:
    """Return what is compared of an object's own attributes."""
    own = vars(owner).items()
    return {
        k: noted(value) for k, value in own if k not in CHANGING and not isinstance(value, SignalInstance)
    }


def listeners(source: QObject) -> list[tuple[str, int]]:
    """Return how many listen to each signal of an object."""
    meta = source.metaObject()
    methods = (meta.method(i) for i in range(meta.methodOffset(), meta.methodCount()))
    signals = [method for method in methods if method.methodType() == QMetaMethod.MethodType.Signal]
    names = [bytes(method.methodSignature().data()).decode() for method in signals]
    return [(name, source.receivers(f"2{name}")) for name in names]


def shown(widget: QWidget) -> list[object]:
    """Return what a user sees of a widget."""
    seen: list[object] = [type(widget), widget.isHidden(), widget.isEnabled(), widget.toolTip()]
    seen.append(widget.accessibleDescription())
    if isinstance(widget, QDockWidget | QOpenGLWidget):
        seen += [widget.size(), widget.pos()]
    elif isinstance(widget, QLabel | QLineEdit):
        seen += [widget.text(), widget.font().bold()]
    elif isinstance(widget, QAbstractButton):
        seen += [widget.text(), widget.isChecked(), widget.isDown()]
    elif isinstance(widget, QComboBox):
        seen += [widget.currentIndex(), [widget.itemText(i) for i in range(widget.count())]]
    elif isinstance(widget, QAbstractSlider | QProgressBar):
        seen.append(widget.value())
    return seen


def changing_widgets(window) -> set[QWidget]:
    """Return the widgets that show how long something took, or what is counted when the picture rests."""
    return {window.tone.counted, *(window.status.cell(name) for name in CHANGING_CELLS)}


def seen_of(controller) -> dict[str, object]:
    """Return what a user sees of a Viewer, by names that say where two differ."""
    window, state, changing = controller.window, controller.state, changing_widgets(controller.window)
    found: dict[str, object] = {
        "window": (window.size(), window.windowState(), window.windowTitle()),
        "status": window.status.currentMessage(),
        "history": (state.history.steps, state.history.undo_text, state.history.redo_text),
    }
    counts: Counter[str] = Counter()
    for part in window.findChildren(QObject):
        if isinstance(part, QWidget | QAction):
            name = f"{type(part).__name__} {part.objectName()}"
            counts[name] += 1
            place = f"{name} {counts[name]}"
            if isinstance(part, QAction):
                found[place] = (
                    part.text(),
                    part.isChecked(),
                    part.isEnabled(),
                    part.isVisible(),
                    part.toolTip(),
                )
            elif part not in changing:
                found[place] = shown(part)
    return found


def held_of(controller) -> dict[str, object]:
    """Return what the parts of a Viewer hold and who listens to them, by names that say where two differ."""
    window, drawer, changing = controller.window, controller.drawer, changing_widgets(controller.window)
    found: dict[str, object] = {
        "focus": Same(QApplication.focusWidget()),
        "uploads": noted(drawer.uploads),
        "renderer": list(vars(drawer.scene_renderer)),
    }
    counts: Counter[str] = Counter()
    for part in (window, *window.findChildren(QObject)):
        kind = type(part)
        kinds = {kind.__module__, type(part.parent()).__module__}
        if kind.__module__.startswith("brdf") and part not in changing and kinds.isdisjoint(PICTURES):
            counts[kind.__name__] += 1
            place = f"{kind.__name__} {counts[kind.__name__]}"
            found |= {f"{place}.{key}": value for key, value in attributes(part).items()}
            if not isinstance(part, QWidget) or part is window.picture:
                found[f"{place}, listeners"] = listeners(part)
    return found


def differences(one: dict[str, object], other: dict[str, object]) -> list[str]:
    """Return the names of all that differs."""
    missing = object()
    return sorted(
        name for name in one.keys() | other.keys() if one.get(name, missing) != other.get(name, missing)
    )


class LastingViewer:
    """A Viewer that is used again and again, and how it was when it had started."""

    def __init__(self, viewer) -> None:
        self.controller, self.view = viewer.controller, viewer.view
        self.link = os.environ["BRDF_SUITE_LINK"]
        self._fit, self._paint = viewer.state.fit, viewer.state.paint_key
        self._surface = viewer.state.surface
        self._show_paint()
        self._rest(viewer)
        window, store = viewer.window, settings()
        self._choosers = [
            getattr(window, kind).chooser for kind in ("environment", "surface", "paint", "compare")
        ]
        self._sources = [_sources(chooser) for chooser in self._choosers]
        self._recent = {kind: _texts(menu) for kind, menu in window.commands.recent_menus.items()}
        self._settings = {key: store.value(key) for key in store.allKeys()}
        self._seen, self._held = seen_of(self.controller), held_of(self.controller)
        self._pixels = viewer.pixels()

    def bring_back(self, viewer) -> list[str]:
        """Undo what a test did, by what a user or a part of the program can do; return what still differs."""
        controller, window, state = viewer.controller, viewer.window, viewer.state
        for widget in window.findChildren(QWidget):
            if widget.isWindow() and widget.isVisible():
                widget.close()
        controller.camera.turntable.set_running(False)
        controller.traced.set_renderer("realtime")
        state.history.end()
        state.set_view(self.view)
        state.history.end()
        state.metered_ev = None
        if state.fit is not self._fit:
            self._show_paint()
        viewer.wait_idle()
        if state.surface is not self._surface and state.surface.value is self._surface.value:
            state.surface = self._surface
        for key in list(window.messages.shown()):
            window.messages.dismiss(key)
        window.status.clearMessage()
        state.history.findChild(QUndoStack).clear()
        for kind, paths in self._recent.items():
            if paths != _texts(window.commands.recent_menus[kind]):
                window.commands.set_recent(kind, paths)
        for chooser, sources in zip(self._choosers, self._sources, strict=True):
            if sources != _sources(chooser):
                files = [source for source in sources if Path(source.key).is_absolute()]
                chooser.set_sources([source for source in sources if source not in files], files)
        store = settings()  # of the test that comes
        for key, value in self._settings.items():
            store.setValue(key, value)
        QApplication.sendEvent(viewer.canvas, QEvent(QEvent.Type.Leave))
        controller.link.publish("view", view_to_json(self.view))
        window.activateWindow()
        viewer.canvas.setFocus()
        self._rest(viewer)
        found = differences(self._seen, seen_of(controller)) + differences(self._held, held_of(controller))
        return found or ([] if np.array_equal(viewer.pixels(), self._pixels) else ["pixels"])

    def _show_paint(self) -> None:
        """Open the first paint, from which the next one is stepped to, and draw the very fit that was drawn first."""
        paint, state = self.controller.paint, self.controller.state
        paint.open(self._paint)
        state.set_fit(self._fit, self._paint)
        paint.show_fit(self._fit, self._paint)
        paint.set_following(True)

    def _rest(self, viewer) -> None:
        viewer.wait_idle()
        viewer.qtbot.waitUntil(lambda: viewer.state.light_figures is not None)
        viewer.qtbot.waitUntil(viewer.canvas.hasFocus)
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


def _texts(menu: QMenu) -> list[str]:
    return [action.text() for action in menu.actions()]


def _sources(chooser: SourceChooser | SourceTiles) -> list[Source]:
    every = [chooser.sources.source_at(row) for row in range(chooser.sources.rowCount())]
    return [source for source in every if source.title]


def lasting_viewers(close: Callable[[Any], None]) -> Iterator[Callable[..., Any]]:
    """Yield ``take(start, again)``, which returns a Viewer in its first state.

    ``again(controller)`` wraps the one that was used before; ``start()`` starts another where there is none, or where
    that one could not be brought back. With None for ``start`` no Viewer is returned: that one is brought back, or
    closed.
    """
    kept: list[LastingViewer] = []

    def take(start: Callable[[], Any] | None, again: Callable[[Any], Any]) -> Any:
        viewer = again(kept[-1].controller) if kept else None
        if viewer is not None and kept[-1].bring_back(viewer):
            close(kept.pop().controller)
        if start is None:
            return None
        if not kept:
            viewer = start()
            kept.append(LastingViewer(viewer))
        viewer.link = kept[-1].link
        return viewer

    yield take
    for one in kept:
        close(one.controller)
