"""Models in the window: sliders of the selected one, a text that is edited by keys, errors, files and undo."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from brdf_lobe_visualizer.model_text.section import WORDS, NumberSlider, decimals_of, to_share, to_value
from brdf_lobe_visualizer.model_text.starts import STARTS
from brdf_qt.window.dialogs import Answer, Overwrite
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QCloseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QCheckBox, QPushButton

from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.adjusting import adjustables
from brdf_suite.reflectance.live.text import read_model_text
from brdf_suite.reflectance.registry import ENTRIES

CTRL = Qt.KeyboardModifier.ControlModifier


class Dialogs:
    """Answers the questions for files as set, and counts those about unsaved changes."""

    def __init__(self) -> None:
        self.opened: Path | None = None
        self.saved: Path | None = None
        self.answer = Answer.CANCEL
        self.asked: list[str] = []
        self.suggested: Path | None = None
        self.overwrite = Overwrite.CANCEL

    def changed_file(self, path: Path) -> Overwrite:
        self.asked.append(f"changed {path.name}")
        return self.overwrite

    def open_path(self, _folder: Path, _filters: str) -> Path | None:
        return self.opened

    def save_path(self, suggested: Path, _filters: str) -> Path | None:
        self.suggested = suggested
        return self.saved

    def unsaved(self, name: str) -> Answer:
        self.asked.append(name)
        return self.answer


@pytest.fixture
def models(program):
    """The part, with a script for its questions and its panel hidden."""
    part = program.models
    part.dialogs = Dialogs()
    part.dock.hide()
    return part


@pytest.fixture
def settle(program, qtbot):
    """Wait for everything that follows."""

    def wait(condition=lambda: True) -> None:
        qtbot.waitUntil(lambda: condition() and program.is_idle, timeout=120_000)

    return wait


@pytest.fixture
def started(program, models, settle):
    """Start a model of a notation, and wait for it."""

    def start(language: str):
        count = len(program.session.subjects)
        models.start_text(language)
        settle(lambda: len(program.session.subjects) == count + 1)
        return program.session.front

    return start


def value(program) -> np.ndarray:
    return program.session.front.reflectance.eval(spherical(0.3, 0.0), spherical(0.4, 2.9))


def select(editor, words: str) -> None:
    """Select words of the text, as a double click would."""
    editor.setTextCursor(editor.document().find(words))


def test_the_starts_are_one_model_in_two_notations(program, started) -> None:
    found = [value(program) for language in STARTS if started(language)]
    np.testing.assert_allclose(found[0], found[1], rtol=1e-4)


def test_a_slider_changes_a_model_that_is_built_in(program, models, opened, settle) -> None:
    opened("ggx")
    rows = models.section.rows
    assert list(rows) == ["kd.r", "kd.g", "kd.b", "f0.r", "f0.g", "f0.b", "alpha"]
    alpha = rows["alpha"]
    assert isinstance(alpha, NumberSlider)
    assert alpha.number.value() == pytest.approx(0.3)
    before = value(program)
    alpha.slider.setFocus()
    QTest.keyClick(alpha.slider, Qt.Key.Key_PageUp)
    settle(lambda: not np.array_equal(value(program), before))
    assert program.session.front.reflectance.alpha == pytest.approx(alpha.number.value())
    assert alpha.number.value() > 0.35
    # The number moves the slider, and both show what the selected one has.
    alpha.number.setFocus()
    alpha.number.selectAll()
    QTest.keyClicks(alpha.number, "0.5")
    QTest.keyClick(alpha.number, Qt.Key.Key_Return)
    settle(lambda: program.session.front.reflectance.alpha == 0.5)
    assert alpha.slider.value() == pytest.approx(500, abs=2)
    opened("phong")
    assert list(models.section.rows)[-1] == "exponent"
    program.session.set_front(program.session.subjects[0].key)
    settle(lambda: "alpha" in models.section.rows)
    assert models.section.rows["alpha"].number.value() == 0.5


def test_a_paint_has_no_sliders(program, models, opened) -> None:
    opened("blue")
    assert models.inspector_section.isHidden()
    assert not models.panel.save.isEnabled()
    assert models.panel.nothing.text()


def test_a_text_is_edited_by_keys_and_undone(program, models, started, settle) -> None:
    started("python")
    editor = models.panel.editor
    before = value(program)
    select(editor, "(lobe if")
    QTest.keyClicks(editor, "(2 * lobe if")
    settle(lambda: value(program)[2] > 1.5 * before[2])
    assert models.panel.state.text() == "No errors."
    assert models.panel.file.text().endswith("•")
    for _ in range(20):
        QTest.keyClick(editor, Qt.Key.Key_Z, CTRL)
    settle(lambda: np.array_equal(value(program), before))
    assert editor.toPlainText() == STARTS["python"]


@pytest.mark.parametrize(
    ("language", "words", "line"), [("python", "schlick(0.04", 17), ("glsl", "schlick(0.04", 26)]
)
def test_an_error_is_marked_on_its_line_and_the_picture_stays(
    program, models, started, settle, language: str, words: str, line: int
) -> None:
    started(language)
    editor = models.panel.editor
    before = value(program)
    select(editor, words)
    QTest.keyClicks(editor, "shlick(0.04")
    settle(lambda: editor.error_line == line)
    assert f"Line {line}: " in models.panel.state.text()
    np.testing.assert_array_equal(value(program), before)
    (mark,) = editor.extraSelections()
    assert mark.cursor.blockNumber() == line - 1
    # Another model, and back: the error is where it was.
    key, fit = program.session.front.key, program.session.front.fit
    started("python")
    assert editor.error_line is None
    program.session.set_front(key)
    settle(lambda: editor.error_line == line)
    assert program.session.front.fit is fit
    select(editor, "shlick(0.04")
    QTest.keyClicks(editor, words)
    settle(lambda: editor.error_line is None)
    assert models.panel.state.text() == "No errors."


def test_declared_parameters_become_sliders_at_once(program, models, started, settle) -> None:
    started("python")
    editor = models.panel.editor
    rows = models.section.rows
    assert list(rows) == ["base.r", "base.g", "base.b", "roughness", "clearcoat"]
    assert isinstance(rows["clearcoat"], QCheckBox)
    rows["roughness"].number.setFocus()
    rows["roughness"].number.selectAll()
    QTest.keyClicks(rows["roughness"].number, "0.6")
    QTest.keyClick(rows["roughness"].number, Qt.Key.Key_Return)
    box = QPoint(8, rows["clearcoat"].height() // 2)
    QTest.mouseClick(rows["clearcoat"], Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, box)
    settle(lambda: program.session.front.reflectance.values["clearcoat"] == 0.0)
    assert program.session.front.reflectance.values["roughness"] == 0.6
    select(editor, "clearcoat=switch(1)):")
    QTest.keyClicks(editor, "clearcoat=switch(1), gain=number(0, 2, 1)):")
    select(editor, "return base")
    QTest.keyClicks(editor, "return gain * base")
    settle(lambda: "gain" in models.section.rows)
    # What was set stays.
    assert program.session.front.reflectance.values["roughness"] == 0.6
    before = value(program)
    gain = models.section.rows["gain"]
    gain.slider.setFocus()
    QTest.keyClick(gain.slider, Qt.Key.Key_Home)
    settle(lambda: program.session.front.reflectance.values["gain"] == 0.0)
    assert before.all()
    assert not value(program).any()


def test_a_new_default_in_the_text_is_shown(program, models, started, settle) -> None:
    started("glsl")
    editor = models.panel.editor
    select(editor, "roughness .02 1 .25")
    QTest.keyClicks(editor, "roughness .02 1 .75")
    settle(lambda: program.session.front.reflectance.values["roughness"] == 0.75)
    assert models.section.rows["roughness"].number.value() == 0.75


def test_values_are_written_into_the_text_as_one_step(program, models, started, settle) -> None:
    started("glsl")
    models.section.edited.emit("roughness", 0.5)
    models.section.edited.emit("base.g", 1.0)
    settle(lambda: program.session.front.reflectance.values["base.g"] == 1.0)
    editor = models.panel.editor
    models.panel.values.click()
    settle()
    assert read_model_text(editor.toPlainText()).defaults["roughness"] == 0.5
    assert program.session.front.reflectance.values["base.g"] == 1.0
    editor.undo()
    assert editor.toPlainText() == STARTS["glsl"]
    settle()


def test_a_text_is_saved_opened_and_asked_about(program, models, started, settle, tmp_path: Path) -> None:
    path = tmp_path / "mine.brdf"
    started("glsl")
    select(models.panel.editor, "color base .6 .1 .05")
    QTest.keyClicks(models.panel.editor, "color base 1 1 1")
    settle(lambda: program.session.front.reflectance.values["base.g"] == 1.0)
    question = QCloseEvent()
    program.window.close_requested.emit(question)
    assert not question.isAccepted()
    assert models.dialogs.asked == [program.session.front.title]
    models.dialogs.saved = path
    QTest.keyClick(models.panel.editor, Qt.Key.Key_S, CTRL)
    assert models.dialogs.suggested.suffix == ".brdf"
    assert path.read_text(encoding="utf-8") == models.panel.editor.toPlainText()
    assert program.session.front.title == "mine.brdf"
    assert models.panel.file.text() == "mine.brdf"
    question = QCloseEvent()
    program.window.close_requested.emit(question)
    assert question.isAccepted()
    program.session.set_subjects(())
    models.dialogs.opened = path
    models.panel.open.click()
    settle(lambda: len(program.session.subjects) == 1)
    assert models.panel.editor.toPlainText() == path.read_text(encoding="utf-8")
    assert models.section.rows["base.g"].number.value() == 1.0
    assert path in program.sources.recent()


def change_in_another_program(path: Path, text: str) -> None:
    code = "import pathlib, sys; pathlib.Path(sys.argv[1]).write_text(sys.argv[2], encoding='utf-8')"
    subprocess.run([sys.executable, "-c", code, str(path), text], check=True)


@pytest.mark.parametrize(("language", "ending"), [("python", ".py"), ("glsl", ".brdf")])
def test_a_text_that_another_program_has_changed_is_asked_about(
    program, models, opened, settle, tmp_path: Path, language: str, ending: str
) -> None:
    path, sign = tmp_path / f"mine{ending}", "#" if language == "python" else "//"
    path.write_text(STARTS[language], encoding="utf-8")
    opened(path)
    models.show_panel()
    editor = models.panel.editor
    settle(lambda: editor.toPlainText() == STARTS[language])

    def add_line_and_save(text: str) -> None:
        editor.moveCursor(editor.textCursor().MoveOperation.End)
        QTest.keyClick(editor, Qt.Key.Key_Return)
        QTest.keyClicks(editor, f"{sign} {text}")
        settle()
        QTest.keyClick(editor, Qt.Key.Key_S, CTRL)

    add_line_and_save("first")
    assert models.dialogs.asked == []
    assert path.read_text(encoding="utf-8") == editor.toPlainText()

    theirs = f"{STARTS[language]}\n{sign} theirs\n"
    change_in_another_program(path, theirs)
    add_line_and_save("second")
    assert models.dialogs.asked == [f"changed mine{ending}"]
    assert path.read_text(encoding="utf-8") == theirs
    assert models.panel.file.text().endswith("•")

    models.dialogs.overwrite, models.dialogs.saved = Overwrite.SAVE_AS, tmp_path / f"other{ending}"
    QTest.keyClick(editor, Qt.Key.Key_S, CTRL)
    assert path.read_text(encoding="utf-8") == theirs
    assert models.dialogs.saved.read_text(encoding="utf-8") == editor.toPlainText()

    change_in_another_program(models.dialogs.saved, theirs)
    models.dialogs.overwrite = Overwrite.OVERWRITE
    add_line_and_save("third")
    assert models.dialogs.saved.read_text(encoding="utf-8") == editor.toPlainText()
    assert len(models.dialogs.asked) == 3
    # What was written here is no change by another program.
    add_line_and_save("fourth")
    assert len(models.dialogs.asked) == 3


def test_a_text_that_was_changed_before_its_first_save_is_asked_about(
    program, models, opened, settle, tmp_path: Path
) -> None:
    path = tmp_path / "mine.py"
    path.write_text(STARTS["python"], encoding="utf-8")
    opened(path)
    change_in_another_program(path, "# theirs\n")
    models.show_panel()
    QTest.keyClicks(models.panel.editor, " ")
    settle()
    QTest.keyClick(models.panel.editor, Qt.Key.Key_S, CTRL)
    assert models.dialogs.asked == ["changed mine.py"]
    assert path.read_text(encoding="utf-8") == "# theirs\n"


def test_a_text_that_was_removed_unsaved_can_be_restored(program, models, started, settle) -> None:
    subject = started("python")
    QTest.keyClicks(models.panel.editor, "# mine")
    settle()
    program.session.remove(subject.key)
    (key,) = [key for key in program.window.messages.shown() if key.startswith("removed ")]
    button = next(b for b in program.window.messages.findChildren(QPushButton) if b.text() == "Restore")
    button.click()
    settle(lambda: program.session.subject(subject.key) is not None)
    assert "# mine" in models.panel.editor.toPlainText()
    program.window.dismiss_message(key)


def test_keys_of_the_editor(program, models, started, settle) -> None:
    started("python")
    editor = models.panel.editor
    editor.selectAll()
    QTest.keyClicks(editor, "def brdf(L, V, N, X, Y):")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    QTest.keyClicks(editor, "return 0.1")
    assert editor.toPlainText() == "def brdf(L, V, N, X, Y):\n    return 0.1"
    QTest.keyClick(editor, Qt.Key.Key_Home)
    QTest.keyClick(editor, Qt.Key.Key_Home)
    settle(lambda: not models.section.rows or models.inspector_section.isHidden())
    np.testing.assert_allclose(value(program), 0.1)


def test_the_scale_of_sliders() -> None:
    for low, high in ((0.0, 1.0), (-2.0, 2.0), (0.0, 1e6), (1.0, 1e5), (0.001, 1.0)):
        for share in (0.0, 0.2, 0.7, 1.0):
            assert to_share(to_value(share, low, high), low, high) == pytest.approx(share, abs=1e-9)
        assert round(low, decimals_of(low, high)) == low


def test_the_words_of_built_in_models_are_translated() -> None:
    numbers = [one.parameter for entry in ENTRIES.built_in for one in adjustables(entry.default).values()]
    assert {word for one in numbers for word in (one.label, one.meaning)} == set(WORDS)
