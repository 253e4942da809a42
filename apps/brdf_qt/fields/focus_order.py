"""The order in which Tab goes through a window whose parts are made in any order."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget


class Ordered:
    """Base of a part that knows better than the order in which its widgets were made."""

    def focus_order(self) -> Sequence[QWidget]:
        """Return what Tab stops at, one after the other."""
        raise NotImplementedError


def order_focus(parts: Sequence[QWidget]) -> None:
    """Let Tab go through ``parts`` one after the other; within a part in its own order, or as its widgets were made.

    To be called again where widgets have come: a new one is the last of its window.
    """
    for first, second in pairwise(widget for part in parts for widget in _inside(part)):
        QWidget.setTabOrder(first, second)


def _inside(part: QWidget) -> Iterator[QWidget]:
    """The widgets that Tab stops at, but for those of windows of their own, as the list of a combo box is.

    By the tree and not by QWidget.nextInFocusChain: Python takes what that returns for a child of the widget that was
    asked. Once that one is deleted, Python holds all that follow for deleted too, down to the window's menus.
    """
    if isinstance(part, Ordered):
        yield from part.focus_order()
        return
    if part.focusPolicy() & Qt.FocusPolicy.TabFocus:
        yield part
    for child in part.children():
        if isinstance(child, QWidget) and not child.isWindow():
            yield from _inside(child)
