"""A line of text that has a shorter form for where there is less room; it never asks for more width."""

from __future__ import annotations

from brdf_qt.fields.labels import DrawnLabel
from brdf_qt.fields.marks import Mark
from PySide6.QtCore import QSize
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QSizePolicy


class Caption(DrawnLabel):
    """Shows the first of its forms that fits; the last one always."""

    def __init__(self, *forms: str) -> None:
        super().__init__()
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        # Filled, it is drawn without all that lies behind it.
        self.setAutoFillBackground(True)
        self._forms: tuple[str, ...] = ("",)
        self.set_forms(*forms)

    def set_forms(self, *forms: str) -> None:
        """Give the text in forms from the longest to the shortest."""
        if forms == self._forms:
            return
        self._forms = forms or ("",)
        self._choose()
        self.setAccessibleName(self._forms[0])

    def sizeHint(self) -> QSize:
        return QSize(0, self.fontMetrics().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._choose()

    def set_mark(self, what: Mark | None) -> None:
        super().set_mark(what)
        self._choose()

    def _choose(self) -> None:
        wide = self.contentsRect().width()
        self.setText(next((form for form in self._forms if self.text_width(form) <= wide), self._forms[-1]))
