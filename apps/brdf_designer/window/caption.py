"""A line of text that has a shorter form for where there is less room; it never asks for more width."""

from __future__ import annotations

import re

from brdf_qt.fields.labels import PlainLabel
from brdf_qt.fields.marks import Mark
from PySide6.QtCore import QEvent
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QSizePolicy

_DIGIT = re.compile(r"\d")


class Caption(PlainLabel):
    """Shows the first of its forms that fits; the last one always."""

    def __init__(self, *forms: str) -> None:
        super().__init__()
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        # Filled, it is drawn without all that lies behind it.
        self.setAutoFillBackground(True)
        self._forms: tuple[str, ...] = ("",)
        self._widths: dict[str, int] = {}
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

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._widths.clear()

    def set_mark(self, what: Mark | None) -> None:
        super().set_mark(what)
        self._choose()

    def _wide(self, form: str) -> int:
        """Return the width of a form, px. Digits are as wide as each other, and numbers change in every drag."""
        key = _DIGIT.sub("0", form)
        if key not in self._widths:
            self._widths[key] = self.fontMetrics().horizontalAdvance(key)
        return self._widths[key]

    def _choose(self) -> None:
        fitting = (form for form in self._forms if self._wide(form) <= self.contentsRect().width())
        text = next(fitting, self._forms[-1])
        if text != self.text():
            self.setText(text)
