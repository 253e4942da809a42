"""The desk: patches, strip and plot in the middle, the numbers at the right. Intents out, setters in."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from brdf_qt.main_window import SuiteWindow
from brdf_qt.message_bar import Message
from brdf_qt.number_field import NumberField
from brdf_qt.section import Section
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QCloseEvent, QColor, QDragEnterEvent, QDropEvent, QKeySequence
from PySide6.QtWidgets import QColorDialog, QMenu, QSplitter, QVBoxLayout, QWidget

from brdf_designer.angle_plot import AnglePlot
from brdf_designer.colour_section import ColourEditors
from brdf_designer.desk_state import Colours, FitState
from brdf_designer.fields import Key
from brdf_designer.paint_sections import CoatSection, FlakesSection, ModelSection, TextSection
from brdf_designer.patches import FlopStrip, PatchRow
from brdf_designer.status import DeskStatus
from brdf_suite.appearance.colorimetry import display_to_lab


class DesignerWindow(SuiteWindow):
    """The window of Designer.

    Intents: ``edited(key, value)``, ``gesture_started(key)``, ``gesture_finished()`` as
    :mod:`brdf_designer.fields` names them; ``new_asked``, ``open_asked(Path | None)``, ``shipped_asked(name)``,
    ``save_asked``, ``save_as_asked``, ``undo_asked``, ``redo_asked``, ``viewer_asked``, ``recent_cleared``;
    ``close_asked(QCloseEvent)``, to be ignored where the window must stay.
    """

    edited = Signal(object, object)
    gesture_started = Signal(object)
    gesture_finished = Signal()
    new_asked = Signal()
    open_asked = Signal(object)
    shipped_asked = Signal(str)
    save_asked = Signal()
    save_as_asked = Signal()
    undo_asked = Signal()
    redo_asked = Signal()
    viewer_asked = Signal()
    recent_cleared = Signal()
    close_asked = Signal(QCloseEvent)

    def __init__(self, shipped: Sequence[str]) -> None:
        super().__init__("Designer")
        self.setAcceptDrops(True)
        self._colours: Colours | None = None
        self._pickers: dict[int, QColorDialog] = {}
        self.strip, self.patches, self.plot = FlopStrip(), PatchRow(), AnglePlot()
        self._build_centre()
        self._build_inspector()
        self.desk_status = DeskStatus(self.status)
        self._build_menus(shipped)
        self.restore_layout()

    # What the controller shows.

    def show_colours(self, colours: Colours) -> None:
        """See :class:`brdf_designer.controller.View`."""
        self._colours = colours
        self.patches.show_colours(colours)
        self.editors.show_colours(colours)
        for section in (self.coat, self.flakes, self.model, self.texts):
            section.show_paint(colours.paint)
        self.plot.show_colours(colours)
        self.desk_status.show_colours(colours)
        self._show_pick_actions(colours)

    def show_fit(self, state: FitState) -> None:
        """See :class:`brdf_designer.controller.View`."""
        assert self._colours is not None
        self.strip.show_curves(state.curves)
        self.plot.show_curves(state.curves)
        differences = [state.delta_e[angle.index] for angle in self._colours.angles]
        self.patches.show_differences(
            differences, time_limited=state.time_limited, exact_follows=state.exact_follows
        )
        self.coat.show_fit(state)
        self.model.show_notices(state.notices)
        self.desk_status.show_fit(state)

    def mark_fit_stale(self) -> None:
        """See :class:`brdf_designer.controller.View`."""
        for part in (self.strip, self.plot, self.coat, self.desk_status):
            part.mark_stale()
        self.patches.show_differences(None)

    def show_document(self, title: str, path: Path | None, clean: bool) -> None:
        """See :class:`brdf_designer.controller.View`."""
        self.setWindowTitle(f"{title}[*]")
        self.setWindowFilePath(str(path) if path else "")
        self.setWindowModified(not clean)

    def show_message(self, message: Message) -> None:
        """See :class:`brdf_designer.controller.View`."""
        self.messages.show_message(message)

    def dismiss_message(self, key: str) -> None:
        """See :class:`brdf_designer.controller.View`."""
        self.messages.dismiss(key)

    def show_recent(self, paths: Sequence[Path]) -> None:
        """Fill File ▸ Open Recent."""
        self.recent_menu.clear()
        for number, path in enumerate(paths, 1):
            text = f"&{number % 10} {path.name}"
            action = self.recent_menu.addAction(text)
            action.setToolTip(str(path))
            action.triggered.connect(lambda _=False, path=path: self.open_asked.emit(path))
        self.recent_menu.addSeparator()
        self.recent_menu.addAction("&Clear", self.recent_cleared.emit)
        self.recent_menu.setEnabled(bool(paths))

    def show_history(self, undo: str, redo: str, *, can_undo: bool, can_redo: bool) -> None:
        """Show what Undo and Redo would do, by name."""
        for action, word, name, can in (
            (self.undo_action, "&Undo", undo, can_undo),
            (self.redo_action, "&Redo", redo, can_redo),
        ):
            action.setText(f"{word} {name}".rstrip())
            action.setIconText(word.replace("&", ""))
            action.setToolTip(f"{action.text().replace('&', '')} ({action.shortcut().toString()})")
            action.setEnabled(can)

    # How it is built.

    def _build_centre(self) -> None:
        top = QWidget()
        box = QVBoxLayout(top)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(8)
        box.addWidget(self.strip)
        box.addWidget(self.patches, 1)
        split = QSplitter(Qt.Orientation.Vertical)
        split.setHandleWidth(8)
        split.addWidget(top)
        split.addWidget(self.plot)
        split.setStretchFactor(0, 3)
        split.setStretchFactor(1, 2)
        split.setChildrenCollapsible(False)
        split.setSizes([560, 360])
        split.setObjectName("centre_split")
        centre = QWidget()
        outer = QVBoxLayout(centre)
        outer.setContentsMargins(8, 8, 8, 8)
        outer.addWidget(split)
        self.set_centre(centre)
        self.plot.drag_started.connect(lambda index: self.gesture_started.emit(("lab", index, 0)))
        self.plot.lightness_edited.connect(lambda index, value: self.edited.emit(("lab", index, 0), value))
        self.plot.drag_finished.connect(self.gesture_finished)

    def _build_inspector(self) -> None:
        self.editors = ColourEditors()
        self.editors.edited.connect(lambda index, c, value: self.edited.emit(("lab", index, c), value))
        self.editors.gesture_started.connect(lambda index, c: self.gesture_started.emit(("lab", index, c)))
        self.editors.gesture_finished.connect(self.gesture_finished)
        self.editors.pick_asked.connect(self.pick_colour)
        self.coat, self.flakes, self.model, self.texts = (
            CoatSection(),
            FlakesSection(),
            ModelSection(),
            TextSection(),
        )
        for title, body in (
            ("Colour", self.editors),
            ("Coat", self.coat),
            ("Flakes", self.flakes),
            ("Model", self.model),
            ("Paint", self.texts),
        ):
            section = Section(title)
            section.add(body)
            self.inspector.add_section(section)
        for body in (self.coat, self.flakes, self.model, self.texts):
            body.edited.connect(self.edited)
            body.gesture_started.connect(self.gesture_started)
            body.gesture_finished.connect(self.gesture_finished)

    def _build_menus(self, shipped: Sequence[str]) -> None:
        keys = QKeySequence.StandardKey
        file = self.file_menu
        new = self.add_action(file, "&New", self.new_asked.emit, keys.New, "file-plus")
        opened = self.add_action(file, "&Open…", lambda: self.open_asked.emit(None), keys.Open, "folder-open")
        shipped_menu = file.addMenu("Open S&hipped Paint")
        for name in shipped:
            action = shipped_menu.addAction(name.replace("_", " ").capitalize())
            action.triggered.connect(lambda _=False, name=name: self.shipped_asked.emit(name))
        self.recent_menu: QMenu = file.addMenu("Open &Recent")
        self.recent_menu.setToolTipsVisible(True)
        file.addSeparator()
        save = self.add_action(file, "&Save", self.save_asked.emit, keys.Save, "floppy-disk")
        self.add_action(file, "Save &As…", self.save_as_asked.emit, "Ctrl+Shift+S")
        self.add_quit()
        self.undo_action = self.add_action(
            self.edit_menu, "&Undo", self.undo_asked.emit, keys.Undo, "arrow-counter-clockwise"
        )
        self.redo_action = self.add_action(
            self.edit_menu, "&Redo", self.redo_asked.emit, "Ctrl+Shift+Z", "arrow-clockwise"
        )
        self.redo_action.setShortcuts([QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")])
        self.pick_menu = self.paint_menu.addMenu("&Pick Colour")
        self.solid_menu = self.paint_menu.addMenu("Make &Solid From")
        viewer = self.add_action(self.window_menu, "Open &Viewer", self.viewer_asked.emit, icon="monitor")
        for action in (new, opened, save, None, self.undo_action, self.redo_action, None, viewer):
            if action is None:
                self.toolbar.addSeparator()
            else:
                self.toolbar.addAction(action)

    def _show_pick_actions(self, colours: Colours) -> None:
        texts = [(angle.index, angle.text) for angle in colours.angles]
        if texts == getattr(self, "_pick_texts", None):
            return
        self._pick_texts = texts
        self.pick_menu.clear()
        self.solid_menu.clear()
        for number, (index, text) in enumerate(texts, 1):
            pick = self.pick_menu.addAction(f"At {text}…", lambda index=index: self.pick_colour(index))
            pick.setShortcut(QKeySequence(f"Ctrl+{number}") if number < 10 else QKeySequence())
            self.solid_menu.addAction(text, lambda index=index: self.edited.emit(("solid",), index))

    # The picker, drops and the end.

    def pick_colour(self, index: int) -> None:
        """Open the colour picker of a measurement beside the desk; all its changes are one step."""
        assert self._colours is not None
        if index in self._pickers:
            self._pickers[index].activateWindow()
            return
        colour = next(angle for angle in self._colours.angles if angle.index == index)
        key: Key = ("colour", index)
        dialog = QColorDialog(QColor(*colour.rgb), self)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.setWindowTitle(f"Colour at {colour.text}")
        dialog.setOptions(
            QColorDialog.ColorDialogOption.NoButtons | QColorDialog.ColorDialogOption.DontUseNativeDialog
        )
        self._pickers[index] = dialog

        def picked(code: QColor) -> None:
            lab = display_to_lab([code.redF(), code.greenF(), code.blueF()])
            # An sRGB code has a step of about 0.4 units; two decimals keep all of it.
            self.edited.emit(key, tuple(round(float(value), 2) + 0.0 for value in lab))

        def ended() -> None:
            self._pickers.pop(index, None)
            self.gesture_finished.emit()

        self.gesture_started.emit(key)
        dialog.currentColorChanged.connect(picked)
        dialog.finished.connect(ended)
        dialog.show()

    def keep_opened(self) -> None:
        """Take what is shown for what the document had when it was opened: a double click goes back to it."""
        for field in self.inspector.findChildren(NumberField):
            field.set_default(field.value())

    def close_pickers(self) -> None:
        """Close every picker: another document has come, and its readings are others."""
        for dialog in tuple(self._pickers.values()):
            dialog.close()

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if len(event.mimeData().urls()) == 1 and event.mimeData().urls()[0].isLocalFile():
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        event.acceptProposedAction()
        self.open_asked.emit(Path(event.mimeData().urls()[0].toLocalFile()))

    def may_close(self) -> bool:
        """See :meth:`SuiteWindow.may_close`: the controller answers through ``close_asked``."""
        question = QCloseEvent()
        self.close_asked.emit(question)
        return question.isAccepted()
