"""The order in which Tab goes through a window whose parts are made in any order."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget


def order_focus(window: QWidget, parts: Sequence[QWidget]) -> None:
    """Let Tab go through ``parts`` one after the other; within a part the order stays as it is.

    To be called again where widgets have come: a new one is the last of its window.
    """
    inside: dict[QWidget, list[QWidget]] = {part: [] for part in parts}
    widget = window.nextInFocusChain()
    while widget is not window:
        part = next((part for part in parts if part is widget or part.isAncestorOf(widget)), None)
        if part is not None and widget.focusPolicy() & Qt.FocusPolicy.TabFocus:
            inside[part].append(widget)
        widget = widget.nextInFocusChain()
    for first, second in pairwise(widget for part in parts for widget in inside[part]):
        QWidget.setTabOrder(first, second)
