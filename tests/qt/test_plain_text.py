"""Words from elsewhere are drawn as they are: labels, tips and questions."""

from __future__ import annotations

import ast
from html.parser import HTMLParser
from pathlib import Path

import pytest
from brdf_qt.fields.labels import ElidedLabel, PlainLabel, plain_tip
from brdf_qt.window import dialogs
from brdf_qt.window.message_bar import Message, MessageBar
from hypothesis import given
from hypothesis import strategies as st
from PySide6 import QtGui
from PySide6.QtCore import Qt
from PySide6.QtGui import QTextDocument
from PySide6.QtWidgets import QMessageBox, QWidget

from brdf_suite.foreign_text import make_visible

APPS = Path(__file__).resolve().parent.parent.parent / "apps"
RICH_ON_PURPOSE = {
    "brdf_qt/fields/labels.py",
    "brdf_qt/window/help_windows.py",
    "brdf_lobe_visualizer/cuts/crosshair.py",
}


def calls(path: Path) -> list[ast.Call]:
    return [node for node in ast.walk(ast.parse(path.read_text("utf-8"))) if isinstance(node, ast.Call)]


def is_of_ours(node: ast.expr) -> bool:
    """Whether a text is a constant, a translated one, or was made plain."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
        return node.func.id in ("tr", "plain_tip")
    if isinstance(node, ast.BinOp):
        return is_of_ours(node.left) and is_of_ours(node.right)
    if isinstance(node, ast.IfExp):
        return is_of_ours(node.body) and is_of_ours(node.orelse)
    return isinstance(node, ast.Constant)


@pytest.mark.parametrize("path", sorted(APPS.rglob("*.py")), ids=lambda path: path.stem)
def test_labels_are_plain_and_tips_are_made_so(path: Path) -> None:
    if path.relative_to(APPS).as_posix() not in RICH_ON_PURPOSE:
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.ClassDef):
                assert "QLabel" not in {ast.unparse(base) for base in node.bases}, node.name
    for call in calls(path):
        name = call.func.attr if isinstance(call.func, ast.Attribute) else ast.unparse(call.func)
        if name == "QLabel":
            assert path.relative_to(APPS).as_posix() in RICH_ON_PURPOSE, ast.unparse(call)
        elif name in ("setToolTip", "setTabToolTip"):
            assert is_of_ours(call.args[-1]), ast.unparse(call)
        elif name == "showText" or (
            name in ("setItemData", "setData") and "ToolTipRole" in ast.unparse(call)
        ):
            assert is_of_ours(call.args[1]), ast.unparse(call)


class Words(HTMLParser):
    """The words of HTML, and its tags."""

    def __init__(self, text: str) -> None:
        super().__init__(convert_charrefs=True)
        self.words, self.tags = "", set()
        self.feed(text)
        self.close()

    def handle_data(self, data: str) -> None:
        self.words += data

    def handle_starttag(self, tag: str, attrs: object) -> None:
        self.tags.add(tag)
        if tag == "br":
            self.words += "\n"


@given(st.text(alphabet="<>/&;abimgp \n\"'=ltquo#3Ä", max_size=60) | st.text())
def test_a_tip_shows_its_text(text: str) -> None:
    tip = plain_tip(text)
    if QtGui.Qt.mightBeRichText(tip):
        shown = Words(tip)
        assert shown.tags <= {"p", "br"}
        assert shown.words == make_visible(text)
    else:
        assert tip == make_visible(text)


def test_qt_shows_the_tip_as_it_was_meant(walks, qapp) -> None:
    document = QTextDocument()
    document.setHtml(plain_tip(f"{walks.HOSTILE}\nsecond line"))
    assert document.toPlainText().splitlines() == [make_visible(walks.HOSTILE), "second line"]


def test_labels_and_messages_are_plain(walks, qtbot) -> None:
    parent = QWidget()
    qtbot.addWidget(parent)
    for label in (PlainLabel(walks.HOSTILE, parent), ElidedLabel(walks.HOSTILE, parent)):
        assert label.textFormat() is Qt.TextFormat.PlainText
    bar = MessageBar(parent)
    bar.show_message(
        Message(
            "one",
            walks.HOSTILE,
            where=walks.HOSTILE,
            todo=walks.HOSTILE,
            actions=((walks.HOSTILE, lambda: None),),
        )
    )
    bar.show_message(Message("two", walks.HOSTILE))
    parent.show()
    wrong, seen = walks.drawn_as_html()
    assert wrong == []
    assert seen >= 8


def test_questions_are_plain(walks, qtbot, monkeypatch) -> None:
    found = []

    def look(box: QMessageBox) -> int:
        box.show()
        found.append(walks.drawn_as_html())
        box.hide()
        return QMessageBox.StandardButton.Cancel.value

    monkeypatch.setattr(QMessageBox, "exec", look)
    window = QWidget()
    qtbot.addWidget(window)
    asking = dialogs.QtDialogs(window)
    assert asking.unsaved(walks.HOSTILE) is dialogs.Answer.CANCEL
    assert asking.changed_file(Path(walks.HOSTILE_FILE)) is dialogs.Overwrite.CANCEL
    assert [wrong for wrong, _ in found] == [[], []]
    assert [seen for _, seen in found] >= [1, 2]
