"""A line of text that has a shorter form for where there is less room; it never asks for more width."""

from __future__ import annotations

from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QLabel, QSizePolicy


class Caption(QLabel):
    """Shows the first of its forms that fits; the last one always."""

    def __init__(self, *forms: str) -> None:
        super().__init__()
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self._forms: tuple[str, ...] = ("",)
        self.set_forms(*forms)

    def set_forms(self, *forms: str) -> None:
        """Give the text in forms from the longest to the shortest."""
        if forms == self._forms:
            return
        self._forms = forms or ("",)
        self.setAccessibleName(self._forms[0])
        self._choose()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._choose()

    def _choose(self) -> None:
        metrics = self.fontMetrics()
        fitting = (form for form in self._forms if metrics.horizontalAdvance(form) <= self.width())
        text = next(fitting, self._forms[-1])
        if text != self.text():
            self.setText(text)
