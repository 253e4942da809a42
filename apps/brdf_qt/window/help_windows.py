"""Help ▸ Keyboard Shortcuts and Help ▸ About, as windows of their own that never stop the work."""

from __future__ import annotations

from PySide6.QtCore import Qt, qVersion
from PySide6.QtGui import QKeySequence, QPalette
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QHeaderView,
    QLabel,
    QLineEdit,
    QMainWindow,
    QTreeWidget,
    QTreeWidgetItem,
)

import brdf_suite
from brdf_qt.fields.form import fill_column
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.command_palette import commands
from brdf_qt.window.shortcuts import PRESETS, SHORTCUTS, sequences

GESTURES = (
    (mark("Drag a number sideways"), mark("Change it; Shift fine, Ctrl coarse")),
    (mark("Double click a number"), mark("Reset it")),
    (mark("Wheel on a focused number or slider"), mark("Step it")),
    (mark("Left drag in a picture"), mark("Orbit")),
    (mark("Middle or Shift drag in a picture"), mark("Pan")),
    (mark("Wheel in a picture"), mark("Zoom to the cursor")),
    (mark("Right or Alt drag in a picture"), mark("Rotate the light")),
    (mark("Hold Ctrl"), mark("Ten times finer")),
)


class ShortcutsWindow(QDialog):
    """The table of keys: what this window has, the gestures of mouse and wheel, and what other programs have."""

    def __init__(self, window: QMainWindow) -> None:
        super().__init__(window)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("Keyboard Shortcuts"))
        self.resize(680, 600)
        rows = QTreeWidget()
        rows.setHeaderLabels([tr("Command"), tr("Keys")])
        rows.setRootIsDecorated(False)
        rows.setAlternatingRowColors(True)
        rows.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        here: set[str] = set()
        for text, action in commands(window, also_disabled=True):
            if action.shortcuts():
                rows.addTopLevelItem(QTreeWidgetItem([text, keys_text(action.shortcuts())]))
                here.add(str(action.property("command")))
        for gesture, meaning in GESTURES:
            rows.addTopLevelItem(QTreeWidgetItem([tr(gesture), tr(meaning)]))
        elsewhere: dict[str, list[QKeySequence]] = {}
        for command, shortcut in SHORTCUTS.items():
            if command not in here:
                elsewhere.setdefault(shortcut.meaning, []).extend(sequences(command))
        for meaning, keys in elsewhere.items():
            row = QTreeWidgetItem([tr("Other programs: {what}").format(what=tr(meaning)), keys_text(keys)])
            row.setForeground(0, rows.palette().brush(QPalette.ColorRole.PlaceholderText))
            rows.addTopLevelItem(row)
        find = QLineEdit()
        find.setPlaceholderText(tr("Search"))
        find.setAccessibleName(tr("Search"))
        find.setClearButtonEnabled(True)
        find.textChanged.connect(lambda text: _keep(rows, text))
        rows.header().setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        rows.header().setSectionResizeMode(1, QHeaderView.ResizeMode.ResizeToContents)
        rows.header().setStretchLastSection(False)
        fill_column(self, find, rows).setContentsMargins(8, 8, 8, 8)


def keys_text(keys: list[QKeySequence]) -> str:
    """Return keys as they are written on this system; of a row of digits the first and the last."""
    texts = [one.toString(QKeySequence.SequenceFormat.NativeText) for one in keys]
    if len(texts) == PRESETS and all(text.endswith(str(n)) for n, text in enumerate(texts, 1)):
        return f"{texts[0]} … {texts[-1]}"
    return ", ".join(texts)


def _keep(rows: QTreeWidget, text: str) -> None:
    """Show the rows that have a text in either column."""
    for number in range(rows.topLevelItemCount()):
        row = rows.topLevelItem(number)
        if row is not None:
            row.setHidden(text.casefold() not in f"{row.text(0)} {row.text(1)}".casefold())


class AboutWindow(QDialog):
    """What this program is, its version and licence."""

    def __init__(self, window: QMainWindow, program: str) -> None:
        super().__init__(window)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("About {program}").format(program=f"BRDF Suite {program}"))
        what = tr(
            "Design the appearance of automotive paint and see it, while editing,<br>on a car-like surface in a "
            "real environment."
        )
        licence = tr("Apache License 2.0. Qt {version} under the LGPL.").format(version=qVersion())
        text = QLabel(f"<h3>BRDF Suite {program} {brdf_suite.__version__}</h3><p>{what}</p><p>{licence}</p>")
        text.setTextFormat(Qt.TextFormat.RichText)
        text.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        fill_column(self, text).setContentsMargins(24, 16, 24, 16)
