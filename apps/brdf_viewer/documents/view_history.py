"""The view's undo history: one step per gesture, whatever changed the view.

Changes of the same fields are one step while they follow closely or while a mouse button is held, so no slider has
to know when a drag begins. Callers that know it call :meth:`ViewHistory.begin`.
"""

from __future__ import annotations

from dataclasses import fields
from typing import Any

from brdf_qt.documents.open_document import DocumentStore
from brdf_qt.program.translation import mark, tr
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QGuiApplication

from brdf_suite.documents.view import PARTS, View

PAUSE_MS = 500
_NAMES = {
    "camera": mark("Move Camera"),
    "rotation_deg": mark("Turn Light"),
    "exposure_ev": mark("Change Exposure"),
    "lamps": mark("Change Lamps"),
    "turntable_deg_s": mark("Change Turntable"),
    "surface_look.materials": mark("Change Materials"),
    "compare.divider": mark("Move Divider"),
}
STEPS = (
    mark("Change Background"),
    mark("Change Background Colour"),
    mark("Change Clipping Marks"),
    mark("Change Compare"),
    mark("Change Environment"),
    mark("Change Environment Layout"),
    mark("Change Exposure Mode"),
    mark("Change Fresnel"),
    mark("Change Gamut Marks"),
    mark("Change Lamp Shading"),
    mark("Change Light Colour"),
    mark("Change Look Up"),
    mark("Change Mark Style"),
    mark("Change Lens"),
    mark("Change Relief"),
    mark("Change Sparkle"),
    mark("Change Surface"),
    mark("Change Surface Look"),
    mark("Change Tone Curve"),
    mark("Change Two Tone"),
)
"""What :func:`step_name` makes of the other fields."""


class ViewHistory(DocumentStore[View]):
    """Holds the view; a change names its step itself."""

    def __init__(self, view: View, parent: QObject | None = None) -> None:
        super().__init__(view, parent)
        self._pause = make_timer(self, self._paused, PAUSE_MS)
        self._merged: tuple[str, ...] = ()
        self._held = False
        self._running = ""
        self._running_from: tuple[View, int] | None = None

    @property
    def undo_text(self) -> str:
        """What Undo would take back; empty where there is nothing."""
        return self._running or self.stack.undoText()

    @property
    def redo_text(self) -> str:
        """What Redo would do again; empty where there is nothing."""
        return self.stack.redoText()

    @property
    def steps(self) -> int:
        """How many steps can be taken back."""
        return self.stack.index()

    def set(self, value: View, name: str = "") -> bool:
        """Make this the view, undone as ``name``, by default what was changed; False where it is the same already."""
        names = changed_fields(self.value, value)
        if not names:
            return False
        step = name or step_name(names)
        if self._held:
            if not self.in_gesture:
                self.begin_gesture(step)
        else:
            if names != self._merged or not self._pause.isActive():
                self.begin_gesture(step)
                self._merged = names
            self._pause.start()
        return super().set(value, step)

    def begin(self) -> None:
        """All changes until :meth:`end` are one step, called after the first."""
        self.end()
        self._held = True

    def end(self) -> None:
        """End the step that was begun, or that the last changes made; the next change begins another."""
        self._pause.stop()
        self._held = False
        self.end_gesture()

    def begin_running(self, name: str) -> None:
        """Something called ``name`` begins to change the view by itself, by :meth:`amend`."""
        self.end()
        self._running_from, self._running = (self.value, self.steps), name
        self.history_changed.emit()

    def end_running(self) -> None:
        """It has stopped: all that it did is one step, unless there were others in between."""
        name, self._running = self._running, ""
        before, self._running_from = self._running_from, None
        self.history_changed.emit()
        if before is None or before[1] != self.steps or before[0] == self.value:
            return
        after = self.value
        self.amend(before[0])
        super().set(after, name)

    def undo(self) -> None:
        self.end()
        super().undo()

    def redo(self) -> None:
        self.end()
        super().redo()

    def _paused(self) -> None:
        if QGuiApplication.mouseButtons() != Qt.MouseButton.NoButton:
            self._pause.start()
        elif not self._held:
            self.end_gesture()


def changed_fields(old: View, new: View) -> tuple[str, ...]:
    """Return the names of the fields that differ, those of a view's parts as in ``compare.mode``.

    >>> changed_fields(View(), View(exposure_ev=1.0))
    ('exposure_ev',)
    """
    names: list[str] = []
    for name in _differing(old, new):
        if name in PARTS and name != "camera":
            names += [f"{name}.{inner}" for inner in _differing(getattr(old, name), getattr(new, name))]
        else:
            names.append(name)
    return tuple(names)


def _differing(old: Any, new: Any) -> list[str]:
    names = [field.name for field in fields(old)]
    return [name for name in names if getattr(old, name) != getattr(new, name)]


def step_name(names: tuple[str, ...]) -> str:
    """Return what Undo calls a change of these fields.

    >>> step_name(("tone_curve",)), step_name(("camera", "rotation_deg")), step_name(("relief.orange_peel_mm",))
    ('Change Tone Curve', 'Move Camera', 'Change Relief')
    """
    if not names:
        return ""
    first = names[0]
    if first in _NAMES:
        return tr(_NAMES[first])
    words = first.partition(".")[0].removesuffix("_deg").removesuffix("_ev").replace("_", " ")
    step = f"Change {words.title()}"
    return tr(step)
