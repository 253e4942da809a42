"""The panel Model Text: the text of the selected model, its file, and what is wrong in it."""

from __future__ import annotations

from functools import partial

from brdf_qt.fields.form import described, fill_column, icon_button, row_of
from brdf_qt.fields.labels import ElidedLabel, PlainLabel
from brdf_qt.program import theme
from brdf_qt.program.icons import icon
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.shortcuts import sequences
from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QPalette, QShortcut, QTextDocument
from PySide6.QtWidgets import QMenu, QPushButton, QStackedWidget, QToolButton, QWidget

from brdf_lobe_visualizer.model_text.editor import ModelEditor

_WIDTH = 360
NOTATIONS = {"glsl": mark("GLSL, as in the BRDF Explorer"), "python": mark("Formulas in Python's notation")}


class TextPanel(QWidget):
    """An editor with its commands.

    Signals: ``edited()`` by the user; ``new_requested(language)``; ``open_requested()``;
    ``save_requested(as_another)``; ``values_requested()`` to write the sliders' values into the text.
    """

    edited = Signal()
    new_requested = Signal(str)
    open_requested = Signal()
    save_requested = Signal(bool)
    values_requested = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("model_text_panel")
        self._showing = False
        self.new = described(QToolButton(), tip=tr("Start a model from an example"))
        self.new.setText(tr("New"))
        self.new.setIcon(icon("file-plus"))
        self.new.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.new.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        menu = QMenu(self.new)
        for language, title in NOTATIONS.items():
            menu.addAction(tr(title)).triggered.connect(partial(self._ask_new, language))
        self.new.setMenu(menu)
        self.open = icon_button(
            "folder-open", tr("Open a model's text (.brdf, .py)"), self.open_requested.emit
        )
        self.save = icon_button(
            "floppy-disk", tr("Save the text (Ctrl+S in the text)"), lambda: self.save_requested.emit(False)
        )
        tip = tr("Save the text under another name")
        self.save_as = described(QPushButton(tr("Save As…")), tip=tip)
        self.save_as.clicked.connect(lambda _on: self.save_requested.emit(True))
        tip = tr("Write the sliders' values into the text, as the defaults of its parameters")
        self.values = described(QPushButton(tr("Values to Text")), tip=tip)
        self.values.clicked.connect(lambda _on: self.values_requested.emit())
        self.file = ElidedLabel()
        head = row_of(self.new, self.open, self.save, self.save_as, self.values, None)
        self.editor = ModelEditor(tr("Text of the model"))
        self.editor.textChanged.connect(self._changed)
        self.state = described(PlainLabel(), name="model_state")
        self.state.setWordWrap(True)
        self.state.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.nothing = PlainLabel(alignment=Qt.AlignmentFlag.AlignCenter)
        self.nothing.setWordWrap(True)
        self.pages = QStackedWidget()
        self.pages.addWidget(self.nothing)
        self.pages.addWidget(self.editor)
        parts = (head, self.file, self.pages, self.state)
        fill_column(self, *parts, grows=self.pages, spacing=4, margins=(8, 4, 8, 8))
        for key, another in (("save", False), ("save_as", True)):
            for keys in sequences(key):
                shortcut = QShortcut(keys, self)
                shortcut.setContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
                shortcut.activated.connect(lambda another=another: self.save_requested.emit(another))
        self.show_document(None, "", tr("Start a model by New, or open a file."))
        self.setMinimumSize(max(_WIDTH, self.minimumSizeHint().width()), 160)

    def show_document(self, document: QTextDocument | None, name: str, why: str = "") -> None:
        """Edit a document with the name of its file, or say ``why`` there is none."""
        there = document is not None
        self._showing = True
        if document is not None and self.editor.document() is not document:
            self.editor.show_document(document)
        self._showing = False
        self.pages.setCurrentWidget(self.editor if there else self.nothing)
        self.nothing.setText(why)
        self.file.setText(name)
        for button in (self.save, self.save_as, self.values):
            button.setEnabled(there)
        if not there:
            self.state.setText("")

    def show_state(self, text: str, *, line: int | None = None, bad: bool = False) -> None:
        """Show a sentence under the text, and mark the line that it is about."""
        palette = self.palette()
        if bad:
            shade = theme.state_colour("bad", palette.color(QPalette.ColorRole.Window))
            palette.setColor(QPalette.ColorRole.WindowText, shade)
        self.state.setPalette(palette)
        self.state.setText(text)
        self.editor.mark_line(line)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self.editor.mark_line(self.editor.error_line)

    def _ask_new(self, language: str, _checked: bool) -> None:
        self.new_requested.emit(language)

    def _changed(self) -> None:
        if not self._showing:
            self.edited.emit()
