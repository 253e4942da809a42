"""A hand on the mouse and the keyboard of a running program: presses what is visible, types, and counts.

The hand works in a thread of its own, as a person beside the program does, so that it can also answer a dialog that
holds the program's loop. Events go to the real widgets at their real places; what is hidden, disabled, or covered by
another widget cannot be pressed, and a task that needs it fails.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from threading import Event
from typing import TypeVar

from PySide6.QtCore import (
    QAbstractItemModel,
    QAbstractProxyModel,
    QMimeData,
    QModelIndex,
    QObject,
    QPoint,
    QPointF,
    QRect,
    Qt,
    Signal,
)
from PySide6.QtGui import QAction, QDragEnterEvent, QDragMoveEvent, QDropEvent, QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractScrollArea,
    QAbstractSpinBox,
    QApplication,
    QCheckBox,
    QComboBox,
    QFileDialog,
    QLabel,
    QLineEdit,
    QMainWindow,
    QMenu,
    QMenuBar,
    QRadioButton,
    QScrollArea,
    QWidget,
)
from shiboken6 import isValid

Answer = TypeVar("Answer")
SomeWidget = TypeVar("SomeWidget", bound=QWidget)
PATIENCE_S = 900.0
_SIGN = 8
_TURN_S = 0.05
_POPUP_S = 0.6
"""A list takes no press sooner after it has opened: that might be a double click."""
_SETTLE_S = 0.25


class MissingError(Exception):
    """What a step needs is not there to be pressed; a user would not find it either."""


@dataclass
class Count:
    """What a task took: presses of a button or of keys that invoke a command, typed characters, turns of a wheel."""

    clicks: int = 0
    keys: int = 0
    scrolls: int = 0


class _Loop(QObject):
    """Runs calls in the thread of the windows, also while a dialog holds their loop."""

    called = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self.called.connect(lambda call: call(), Qt.ConnectionType.QueuedConnection)


class Hand:
    """The hand; make it in the thread of the windows, and use it from another."""

    def __init__(self) -> None:
        self.count = Count()
        self.log: list[str] = []
        self._loop = _Loop()

    # What is seen.

    def ask(self, what: Callable[[], Answer]) -> Answer:
        """Return what a call gives in the thread of the windows, or raise what it raises."""
        answers: list[Answer] = []
        errors: list[BaseException] = []
        done = Event()

        def call() -> None:
            try:
                answers.append(what())
            except BaseException as error:  # noqa: BLE001 - raised again in the thread that asked
                errors.append(error)
            done.set()

        self._loop.called.emit(call)
        if not done.wait(PATIENCE_S):
            raise MissingError("The program did not answer.")
        if errors:
            raise errors[0]
        return answers[0]

    def wait(self, until: Callable[[], bool], patience_s: float = PATIENCE_S) -> None:
        """Wait until something is so, as a user does who looks at the window."""
        end = time.monotonic() + patience_s
        while not self.ask(until):
            if time.monotonic() > end:
                raise MissingError("What was waited for did not come.")
            time.sleep(_TURN_S)

    def reads(self, part: str) -> bool:
        """Whether a label that is visible holds this text."""
        return self.ask(lambda: any(part in label.text() for label in _widgets(QLabel) if label.isVisible()))

    # What is pressed.

    def press(self, text: str, kind: type[QWidget] = QAbstractButton) -> None:
        """Press the button with this text, name for screen readers, or object name."""
        self.click(lambda: _named(kind, text), text)

    def click(
        self, find: Callable[[], QWidget | None], what: str = "", *, place: QPoint | None = None
    ) -> None:
        """Press a place of a widget, by default its middle."""
        widget = self._visible(find, what)
        self._press(widget, place or self.ask(lambda: _middle(widget)), what)

    def in_menu_of(self, find: Callable[[], QWidget | None], place: QPoint, *path: str) -> None:
        """Press a place of a widget with the right button, and choose in the menu that opens."""
        self._press(self._visible(find, path[-1]), place, "with the right button", right=True)
        self.wait(lambda: bool(_open_menus()), 5.0)
        self._in_menu(self.ask(lambda: _open_menus()[-1]), path)

    def drop(
        self,
        find: Callable[[], QAbstractItemView],
        text: str,
        target: Callable[[], QWidget],
        place: QPoint,
        *,
        ctrl: bool = False,
    ) -> None:
        """Drag a row of a view to a place of another widget: one press. Given are what the view itself carries."""
        view, onto = self._visible(find, text), self._visible(target, text)
        self.count.clicks += 1
        self.log.append(f"drag {text}")

        def carried() -> QMimeData | None:
            model = view.model()
            while isinstance(model, QAbstractProxyModel):
                model = model.sourceModel()
            return model.mimeData([one for one in _rows(model) if str(one.data() or "") == text])

        def scroll() -> None:
            model = view.model()
            view.scrollTo(next(one for one in _rows(model) if str(one.data() or "") == text))

        self._do(scroll)
        self.count.scrolls += 1
        self.wait(lambda: carried() is not None, 20.0)  # a tile without its picture yet cannot be dragged

        def let_go() -> None:
            data = carried()
            assert data is not None
            copy, left = Qt.DropAction.CopyAction, Qt.MouseButton.LeftButton
            held = Qt.KeyboardModifier.ControlModifier if ctrl else Qt.KeyboardModifier.NoModifier
            for event in (
                QDragEnterEvent(place, copy, data, left, held),
                QDragMoveEvent(place, copy, data, left, held),
                QDropEvent(QPointF(place), copy, data, left, held),
            ):
                QApplication.sendEvent(onto, event)

        self._do(let_go)
        time.sleep(_SETTLE_S)

    def menu(self, *path: str) -> None:
        """Choose a command of the menu bar: a press for the menu, none for a submenu, one for the command."""
        bar = self._visible(lambda: _first(QMenuBar), path[0])
        title = self.ask(lambda: _action(bar.actions(), path[0]))
        self._press(bar, self.ask(lambda: bar.actionGeometry(title).center()), path[0])
        self._in_menu(self.ask(lambda: _open_menus()[-1]), path[1:])

    def take(self, menu_of: str, *path: str) -> None:
        """Press a button with a menu, and choose in it."""
        self.press(menu_of)
        self.wait(lambda: bool(_open_menus()), 5.0)
        self._in_menu(self.ask(lambda: _open_menus()[-1]), path)

    def _in_menu(self, menu: QMenu, path: Sequence[str]) -> None:
        """Choose in an open menu; what leads to another menu opens under the pointer."""
        name, *rest = path
        action = self.ask(lambda: _action(menu.actions(), name))
        if not rest:
            self._press(menu, self.ask(lambda: menu.actionGeometry(action).center()), name)
            return
        self._do(lambda: menu.setActiveAction(action))
        inside = self.ask(action.menu)
        assert isinstance(inside, QMenu)
        self.wait(inside.isVisible, 5.0)
        self._in_menu(inside, rest)

    def choose(self, find: Callable[[], QComboBox], text: str) -> None:
        """Choose a row of a list: a press opens it, another takes the row."""
        box = self._visible(find, text)
        self._press(box, self.ask(lambda: box.rect().center()), f"list with {text}")
        self.wait(lambda: box.view().isVisible(), 5.0)
        if self.ask(lambda: box.findText(text)) < 0:
            raise MissingError(f"There is no row {text!r}.")
        time.sleep(_POPUP_S)
        self.count.clicks += 1
        self.log.append(f"press {text}")

        def pick() -> None:
            view = box.view()
            index = view.model().index(box.findText(text), box.modelColumn())
            view.scrollTo(index)
            place = view.visualRect(index).center()
            QTest.mouseMove(view.viewport(), place)
            QTest.mouseClick(view.viewport(), Qt.MouseButton.LeftButton, pos=place)

        self._do(pick)
        self.wait(lambda: box.currentText() == text, 20.0)

    def row(
        self,
        find: Callable[[], QAbstractItemView],
        text: str,
        *,
        ctrl: bool = False,
        where: Callable[[QRect], QPoint] = QRect.center,
    ) -> None:
        """Press a row or a tile of a view; ``where`` of its box, in the middle where not said otherwise."""
        view = self._visible(find, text)

        def place() -> QPoint:
            model, pending = view.model(), [view.rootIndex()]
            while pending:
                parent = pending.pop()
                for number in range(model.rowCount(parent)):
                    index = model.index(number, 0, parent)
                    if str(index.data() or "").partition("\n")[0] == text:
                        view.scrollTo(index)
                        return where(view.visualRect(index))
                    pending.append(index)
            raise MissingError(f"There is no row {text!r}.")

        self._press(view.viewport(), self.ask(place), text, ctrl=ctrl)

    # What is typed.

    def keys(self, sequence: str, *, invokes: bool = True) -> None:
        """Press keys; they count as a press where they invoke a command, and as typing where they move on."""
        if invokes:
            self.count.clicks += 1
        else:
            self.count.keys += 1
        self.log.append(f"keys {sequence}")
        self._do(lambda: QTest.keySequence(_focused(), QKeySequence(sequence)))
        time.sleep(_SETTLE_S)

    def type(self, *texts: str) -> None:
        """Type into the field with the focus; Tab follows each text."""
        if self.ask(_activate_main):
            self.wait(lambda: QApplication.activeWindow() is not None, 5.0)
        for text in texts:
            self.count.keys += len(text) + 1
            self._do(partial(_type, text))
            self._do(lambda: QTest.keyClick(_focused(), Qt.Key.Key_Tab))

    def file(self, path: Path) -> None:
        """Answer the question for a file or a folder: its name is typed, and Enter taken."""

        def name() -> QLineEdit | None:
            for dialog in _widgets(QFileDialog):
                if dialog.isVisible():
                    return dialog.findChild(QLineEdit, "fileNameEdit")
            return None

        self.wait(lambda: name() is not None, 20.0)
        self.count.keys += len(str(path))
        self.count.clicks += 1
        self.log.append("Enter in the question for a file")

        def answer() -> None:
            line = name()
            if line is not None:
                line.selectAll()
                QTest.keyClicks(line, str(path))

        def enter() -> None:
            line = name()
            if line is None:
                return
            try:
                QTest.keyClick(line, Qt.Key.Key_Return)
            except RuntimeError:
                if isValid(line):  # the question may go with the Enter that answers it
                    raise

        self._do(answer)
        self._do(enter)
        time.sleep(_SETTLE_S)

    def _visible(self, find: Callable[[], SomeWidget | None], what: str) -> SomeWidget:
        end = time.monotonic() + 20.0
        while True:
            widget = self.ask(find)
            if widget is not None and self.ask(partial(_usable, widget)):
                return widget
            if time.monotonic() > end:
                raise MissingError(f"{what!r} is not there, or cannot be used.")
            time.sleep(_TURN_S)

    def _press(
        self, widget: QWidget, place: QPoint, what: str, *, ctrl: bool = False, right: bool = False
    ) -> None:
        if self.ask(lambda: _bring_in_sight(widget, place)):
            self.count.scrolls += 1
            time.sleep(_SETTLE_S)
        if not self.ask(lambda: _reaches(widget, place)):
            raise MissingError(f"{what!r} is covered by something else.")
        if self.ask(lambda: _activate(widget.window())):
            self.wait(lambda: QApplication.activeWindow() is not None, 5.0)
        self.count.clicks += 1
        self.log.append(f"press {what}")
        button = Qt.MouseButton.RightButton if right else Qt.MouseButton.LeftButton
        held = Qt.KeyboardModifier.ControlModifier if ctrl else Qt.KeyboardModifier.NoModifier

        def click() -> None:
            # What lies there takes the press, as the line in a number field does.
            top = widget.window()
            met = top.childAt(widget.mapTo(top, place)) or widget
            here = met.mapFrom(top, widget.mapTo(top, place))
            QTest.mouseMove(met, here)
            QTest.mouseClick(met, button, held, here)

        self._do(click)
        time.sleep(_SETTLE_S)

    def _do(self, what: Callable[[], object]) -> None:
        """Do something in the thread of the windows; a dialog that it opens does not hold the hand."""
        errors: list[BaseException] = []

        def call() -> None:
            try:
                what()
            except BaseException as error:  # noqa: BLE001 - raised again in the thread of the hand
                errors.append(error)

        self._loop.called.emit(call)
        self.ask(lambda: None)
        if errors:
            raise errors[0]


def _activate(window: QWidget) -> bool:
    """Give a window the keys where none has them, as a window manager does after a dialog; True where it was needed."""
    if QApplication.activeWindow() is not None or QApplication.activePopupWidget() is not None:
        return False
    window.activateWindow()
    return True


def _activate_main() -> bool:
    """Give the program's window the keys where none has them; True where it was needed."""
    return any(_activate(one) for one in _widgets(QMainWindow) if one.isVisible())


def _rows(model: QAbstractItemModel) -> list[QModelIndex]:
    return [model.index(row, 0) for row in range(model.rowCount())]


def _usable(widget: QWidget) -> bool:
    return widget.isVisible() and widget.isEnabled()


def _middle(widget: QWidget) -> QPoint:
    """Return where a widget is pressed: a box to tick at its sign, since beside its text a press does nothing."""
    middle = widget.rect().center()
    return QPoint(_SIGN, middle.y()) if isinstance(widget, QCheckBox | QRadioButton) else middle


def _widgets(kind: type[SomeWidget]) -> list[SomeWidget]:
    return [widget for widget in QApplication.allWidgets() if isValid(widget) and isinstance(widget, kind)]


def _first(kind: type[SomeWidget]) -> SomeWidget | None:
    return next((widget for widget in _widgets(kind) if widget.isVisible()), None)


def _named(kind: type[SomeWidget], text: str) -> SomeWidget | None:
    for widget in _widgets(kind):
        words = (widget.text() if isinstance(widget, QAbstractButton) else "", widget.accessibleName())
        if widget.isVisible() and (text in map(plain, words) or widget.objectName() == text):
            return widget
    return None


def field(name: str) -> Callable[[], QWidget | None]:
    """Return how a field is found by its name for screen readers or its object name."""
    return lambda: _named(QWidget, name)


def box(*rows: str) -> Callable[[], QComboBox | None]:
    """Return how a list is found by rows that it has."""
    return lambda: next(
        (
            one
            for one in _widgets(QComboBox)
            if one.isVisible() and all(one.findText(row) >= 0 for row in rows)
        ),
        None,
    )


def plain(text: str) -> str:
    """Return a text without the letters of menus and without dots at its end."""
    return text.replace("&&", "\0").replace("&", "").replace("\0", "&").rstrip("….")


def _action(actions: Sequence[QAction], name: str) -> QAction:
    for action in actions:
        if plain(action.text()) == name and action.isVisible() and action.isEnabled():
            return action
    raise MissingError(f"There is no command {name!r} that can be chosen.")


def _open_menus() -> list[QMenu]:
    return [menu for menu in _widgets(QMenu) if menu.isVisible()]


def _focused() -> QWidget:
    popup = QApplication.activePopupWidget() or QApplication.activeModalWidget()
    window = popup or QApplication.activeWindow()
    if window is None:
        window = next(one for one in QApplication.topLevelWidgets() if one.isVisible())
    return (popup or (QApplication.focusWidget() and window) or window).focusWidget() or window


def _type(text: str) -> None:
    target = _focused()
    if isinstance(target, QLineEdit | QAbstractSpinBox):
        target.selectAll()
    QTest.keyClicks(target, text)


def _bring_in_sight(widget: QWidget, place: QPoint) -> bool:
    """Scroll to a place of a widget; False where it is in sight already."""
    parent = widget.parentWidget()
    while parent is not None and not isinstance(parent, QScrollArea):
        parent = parent.parentWidget()
    if parent is None:
        return False
    at = widget.mapTo(parent.viewport(), place)
    if parent.viewport().rect().adjusted(0, 8, 0, -8).contains(at):
        return False
    parent.ensureWidgetVisible(widget)
    return True


def _reaches(widget: QWidget, place: QPoint) -> bool:
    """Whether a press at a place of the window meets the widget, one in it, or one that it is in."""
    top = widget.window()
    met = top.childAt(widget.mapTo(top, place)) or top
    area = widget.parentWidget()
    return (
        met is widget
        or widget.isAncestorOf(met)
        or (isinstance(area, QAbstractScrollArea) and area.isAncestorOf(met))
    )
