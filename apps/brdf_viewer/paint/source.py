"""Which paint is shown: Designer's while it is followed, otherwise a shipped one or a file."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QObject, Signal

from brdf_suite.documents.paint import Paint
from brdf_suite.documents.store import AnyPaint, paint_from_json

DESIGNER = "designer:"
"""The key of the paint that Designer holds; no file and no shipped paint has a name with a colon at its end."""


class PaintSource(QObject):
    """Emits ``changed(paint, key)``, a paint of any kind, and ``following_changed(bool)``."""

    changed = Signal(object, str)
    following_changed = Signal(bool)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._following = True
        self._of_designer: Paint | None = None

    @property
    def following(self) -> bool:
        """Whether Designer's paint is shown as soon as there is one."""
        return self._following

    @property
    def of_designer(self) -> Paint | None:
        """The newest paint that Designer has published; it stays when Designer closes."""
        return self._of_designer

    def set_following(self, following: bool) -> None:
        """Follow Designer or not; its newest paint is shown at once."""
        if following == self._following:
            return
        self._following = following
        self.following_changed.emit(following)
        if following and self._of_designer is not None:
            self.changed.emit(self._of_designer, DESIGNER)

    def received(self, value: dict[str, Any]) -> None:
        """Take what Designer has published; ``value`` has passed the link's check."""
        self._of_designer = paint_from_json(value, "Designer")
        if self._following:
            self.changed.emit(self._of_designer, DESIGNER)

    def start_with(self, paint: AnyPaint, key: str) -> None:
        """Show a paint; where Designer is followed, until it has another."""
        self.changed.emit(paint, key)

    def show(self, paint: AnyPaint, key: str) -> None:
        """Show this paint and stop following Designer."""
        self.set_following(False)
        self.changed.emit(paint, key)
