"""Opens a program's window in the language that is stored, and prints what it shows as JSON.

Its arguments: the program's name, and the code of a language to choose in the menu, where one is to be chosen.
Run as a process of its own: a translation belongs to the whole application.
"""

from __future__ import annotations

import importlib.util
import json
import os
import sys
from collections.abc import Callable
from pathlib import Path

from brdf_qt.fields.labels import ElidedLabel
from brdf_qt.fields.number import NumberField
from brdf_qt.program.application import create_application
from brdf_qt.program.program import Program
from brdf_qt.window.main_window import SuiteWindow
from brdf_qt.window.section import Section
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QShortcut
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QComboBox,
    QDockWidget,
    QLabel,
    QLineEdit,
    QMenu,
    QTabBar,
    QToolButton,
    QWidget,
)

SIZE = (1280, 720)


def designer() -> Program:
    """Make Designer."""
    from brdf_designer.assembly import Designer

    return Designer()


def lobe_visualizer() -> Program:
    """Make Lobe Visualizer."""
    from brdf_lobe_visualizer.assembly import LobeVisualizer

    return LobeVisualizer()


def color_swatch() -> Program:
    """Make Color Swatch."""
    from brdf_color_swatch.assembly import ColorSwatch

    return ColorSwatch()


def viewer() -> Program:
    """Make Viewer with a sphere in a plain light, as the first start does otherwise."""
    from brdf_viewer.controller import ViewerController

    from brdf_suite.documents.view import View

    return ViewerController(View(environment="booth", surface="sphere"), "blue")


PROGRAMS: dict[str, Callable[[], Program]] = {
    "Designer": designer,
    "Lobe Visualizer": lobe_visualizer,
    "Color Swatch": color_swatch,
    "Viewer": viewer,
}


def main() -> int:
    """Open, walk, print."""
    name, *chosen = sys.argv[1:]
    app = create_application(name)
    program = PROGRAMS[name]()
    window = program.window
    window.resize(*SIZE)
    program.start_when_painted()
    window.show()
    for dock in window.findChildren(QDockWidget):
        dock.show()
    for section in window.findChildren(Section):
        section.set_open(True)
    painted = []
    window.first_painted.connect(lambda: painted.append(True))
    # Without OpenGL nothing is baked for a surface, and that of the Viewer is never complete.
    awaited = [feature for feature in program.features if type(feature).__name__ != "SurfaceControl"]
    while not painted or not all(feature.is_idle for feature in awaited):
        QTest.qWait(20)
    QTest.qWait(50)  # layouts follow what has come
    for code in chosen:
        window.findChild(object, f"language_{code}").trigger()
    walks = _load(Path(__file__).parent.parent / "window_walks.py")
    found = {
        "language": app.property("language"),
        "texts": [*walks.all_texts(window), *_names(walks.widgets_of(window))],
        "entries": [
            action.text() for menu in window.findChildren(QMenu) for action in menu.actions() if action.text()
        ],
        "cut": list(_cut_off(window)),
        "keys": _keys(window),
        "numbers": [field.text() for field in window.findChildren(NumberField)],
    }
    print(json.dumps(found))
    sys.stdout.flush()
    os._exit(0)  # nothing that is on its way is awaited


def _keys(window: SuiteWindow) -> list[tuple[str, list[str]]]:
    """Return every command with keys: its name in the table of keys, and the keys; also where it has no name."""
    found = [(str(action.property("command")), action.shortcuts()) for action in window.findChildren(QAction)]
    found += [("QShortcut", [shortcut.key()]) for shortcut in window.findChildren(QShortcut)]
    return [(command, [one.toString() for one in keys]) for command, keys in found if keys]


def _names(widgets: list[QWidget]) -> list[tuple[str, str]]:
    """Return what the widgets are called: for screen readers, as titles, as hints in empty lines."""
    found = []
    for widget in widgets:
        place = f"{type(widget).__name__} {widget.objectName()!r}"
        found += [(place, widget.accessibleName()), (place, widget.windowTitle())]
        if isinstance(widget, QLineEdit):
            found.append((place, widget.placeholderText()))
        if isinstance(widget, QAbstractButton):
            found.append((place, widget.text()))
    return [pair for pair in found if pair[1]]


def _cut_off(window: SuiteWindow) -> list[str]:
    """Return the labels, buttons and lists that are on show and narrower than their own text."""
    wrong = []
    inspector = window.inspector
    if inspector.widget().width() > inspector.viewport().width():
        wrong.append(f"inspector: {inspector.widget().width()} in {inspector.viewport().width()} pixels")
    for widget in window.findChildren(QWidget):
        if not widget.isVisible():
            continue
        if isinstance(widget, ElidedLabel):  # its tip has the whole text
            continue
        if isinstance(widget, QLabel) and not widget.wordWrap() and type(widget).sizeHint is QLabel.sizeHint:
            ignored = widget.sizePolicy().horizontalPolicy() == widget.sizePolicy().Policy.Ignored
            short = not ignored and widget.width() < widget.sizeHint().width()
            text = widget.text()
        elif (
            isinstance(widget, QToolButton)
            and widget.toolButtonStyle() == Qt.ToolButtonStyle.ToolButtonIconOnly
        ):
            if widget.icon().isNull() and widget.width() < widget.fontMetrics().horizontalAdvance(
                widget.text()
            ):
                wrong.append(f"{widget.objectName()!r}: {widget.text()!r} in {widget.width()} pixels")
            continue
        elif isinstance(widget, QAbstractButton):
            text = widget.text().replace("&", "")
            beside = not isinstance(widget, QToolButton) or (
                widget.toolButtonStyle() is not Qt.ToolButtonStyle.ToolButtonTextUnderIcon
            )
            mark = widget.iconSize().width() if beside and not widget.icon().isNull() else 0
            short = widget.width() < mark + widget.fontMetrics().horizontalAdvance(text)
        elif isinstance(widget, QComboBox):
            text = widget.currentText()
            room = widget.width() - 26
            short = widget.fontMetrics().horizontalAdvance(text) > room
        elif isinstance(widget, QTabBar):
            text = ", ".join(widget.tabText(place) for place in range(widget.count()))
            short = (
                widget.elideMode() != Qt.TextElideMode.ElideNone
                and widget.width() < widget.sizeHint().width()
            )
        else:
            continue
        if short:
            wrong.append(
                f"{type(widget).__name__} {widget.objectName()!r}: {text!r} in {widget.width()} pixels"
            )
    return wrong


def _load(path: Path):
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


if __name__ == "__main__":
    sys.exit(main())
