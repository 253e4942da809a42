"""An editor of a model's text, with line numbers and a mark on the line of an error."""

from __future__ import annotations

from typing import cast

from brdf_qt.fields.form import described
from brdf_qt.program import theme
from PySide6.QtCore import QRect, QRegularExpression, QSize, Qt
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontDatabase,
    QKeyEvent,
    QPainter,
    QPaintEvent,
    QPalette,
    QResizeEvent,
    QSyntaxHighlighter,
    QTextCharFormat,
    QTextCursor,
    QTextDocument,
    QTextFormat,
)
from PySide6.QtWidgets import QPlainTextDocumentLayout, QPlainTextEdit, QTextEdit, QWidget

_INDENT = 4
_ROOM = 6
_WORDS = (
    *("def", "return", "if", "else", "and", "or", "not", "number", "switch", "color"),
    *(
        "analytic",
        "begin",
        "end",
        "parameters",
        "shader",
        "float",
        "bool",
        "int",
        "vec2",
        "vec3",
        "mat3",
        "const",
    ),
    *("for", "while", "uniform", "BRDF", "brdf"),
)


class _Highlighter(QSyntaxHighlighter):
    """Comments faint, words of the notations bold: the interface has no colour."""

    def __init__(self, document: QTextDocument, faint: QColor) -> None:
        super().__init__(document)
        self._bold, self._faint = QTextCharFormat(), QTextCharFormat()
        self._bold.setFontWeight(QFont.Weight.Bold)
        self._faint.setForeground(faint)
        self._rules = (
            (QRegularExpression(rf"\b(?:{'|'.join(_WORDS)})\b"), self._bold),
            (QRegularExpression(r"(?:#(?!define|if|ifdef|ifndef|else|endif|undef)|//).*$"), self._faint),
        )

    def highlightBlock(self, text: str) -> None:
        for pattern, form in self._rules:
            found = pattern.globalMatch(text)
            while found.hasNext():
                match = found.next()
                self.setFormat(match.capturedStart(), match.capturedLength(), form)


class _Margin(QWidget):
    """The line numbers."""

    def __init__(self, editor: ModelEditor) -> None:
        super().__init__(editor)
        self._editor = editor

    def sizeHint(self) -> QSize:
        return QSize(self._editor.margin_width(), 0)

    def paintEvent(self, event: QPaintEvent) -> None:
        self._editor.paint_margin(event)


class ModelEditor(QPlainTextEdit):
    """A plain text of one document at a time, each with its own undo; Tab indents, Escape then Tab leaves."""

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        described(self, name="model_text", spoken=name)
        self.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        self._margin = _Margin(self)
        self._error_line: int | None = None
        self._highlighter: _Highlighter | None = None
        self._leaving = False
        self.blockCountChanged.connect(lambda _count: self._make_room())
        self.updateRequest.connect(self._scrolled)
        self._make_room()

    def make_document(self, text: str) -> QTextDocument:
        """Return a document for :meth:`show_document`, which holds a text without an undo step."""
        document = QTextDocument(self)
        document.setDocumentLayout(QPlainTextDocumentLayout(document))
        document.setDefaultFont(self.font())
        document.setPlainText(text)
        return document

    def show_document(self, document: QTextDocument) -> None:
        """Edit another document from here on."""
        self.setDocument(document)
        self.setTabStopDistance(_INDENT * self.fontMetrics().horizontalAdvance(" "))
        faint = self.palette().color(QPalette.ColorRole.PlaceholderText)
        if document.findChild(QSyntaxHighlighter) is None:
            _Highlighter(document, faint)
        self.mark_line(None)
        self._make_room()

    @property
    def error_line(self) -> int | None:
        """The line that is marked, from 1."""
        return self._error_line

    def mark_line(self, line: int | None) -> None:
        """Mark a line, from 1, as the one with the error, or none."""
        self._error_line = line
        marks: list[QTextEdit.ExtraSelection] = []
        block = self.document().findBlockByNumber((line or 0) - 1)
        if line is not None and block.isValid():
            mark = QTextEdit.ExtraSelection()
            shade = QColor(theme.state_colour("bad", self.palette().color(QPalette.ColorRole.Base)))
            shade.setAlphaF(0.28)
            form = QTextCharFormat()
            form.setBackground(shade)
            form.setProperty(QTextFormat.Property.FullWidthSelection, True)
            cursor = QTextCursor(block)
            mark.format, mark.cursor = form, cursor
            marks.append(mark)
        self.setExtraSelections(marks)
        self._margin.update()

    def go_to(self, line: int) -> None:
        """Put the cursor at the beginning of a line, from 1, in sight."""
        block = self.document().findBlockByNumber(line - 1)
        if block.isValid():
            self.setTextCursor(QTextCursor(block))
            self.centerCursor()
            self.setFocus()

    def margin_width(self) -> int:
        digits = max(2, len(str(self.blockCount())))
        return 2 * _ROOM + digits * self.fontMetrics().horizontalAdvance("9")

    def paint_margin(self, event: QPaintEvent) -> None:
        """Draw the numbers of the lines in sight; that of the error in its colour."""
        painter = QPainter(self._margin)
        ground = self.palette().color(QPalette.ColorRole.Window)
        painter.fillRect(event.rect(), ground)
        painter.setFont(self.font())
        faint = self.palette().color(QPalette.ColorRole.PlaceholderText)
        block = self.firstVisibleBlock()
        top = self.blockBoundingGeometry(block).translated(self.contentOffset()).top()
        height = self.fontMetrics().height()
        while block.isValid() and top <= event.rect().bottom():
            line = block.blockNumber() + 1
            bad = line == self._error_line
            painter.setPen(QColor(theme.state_colour("bad", ground)) if bad else faint)
            room = QRect(0, round(top), self._margin.width() - _ROOM, height)
            painter.drawText(room, cast(int, Qt.AlignmentFlag.AlignRight), str(line))
            top += self.blockBoundingRect(block).height()
            block = block.next()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        inside = self.contentsRect()
        self._margin.setGeometry(QRect(inside.left(), inside.top(), self.margin_width(), inside.height()))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        leaving, self._leaving = self._leaving, event.key() == Qt.Key.Key_Escape
        if event.key() == Qt.Key.Key_Tab and leaving:
            self.focusNextChild()
        elif event.key() == Qt.Key.Key_Tab:
            cursor = self.textCursor()
            cursor.insertText(" " * (_INDENT - cursor.positionInBlock() % _INDENT))
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            cursor = self.textCursor()
            line = cursor.block().text()[: cursor.positionInBlock()]
            deeper = _INDENT if line.rstrip().endswith((":", "{")) else 0
            cursor.insertText("\n" + " " * (len(line) - len(line.lstrip(" ")) + deeper))
            self.ensureCursorVisible()
        else:
            super().keyPressEvent(event)

    def _make_room(self) -> None:
        self.setViewportMargins(self.margin_width(), 0, 0, 0)

    def _scrolled(self, area: QRect, down: int) -> None:
        if down:
            self._margin.scroll(0, down)
        else:
            self._margin.update(0, area.y(), self._margin.width(), area.height())
