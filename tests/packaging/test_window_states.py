"""Texts of the windows: found where they are clipped or overlap, and none is in the states that are walked through."""

from __future__ import annotations

import importlib
import os
import subprocess
import sys
from pathlib import Path

import pytest
from PIL import Image, ImageDraw, ImageFont
from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QGraphicsScene,
    QGraphicsView,
    QLabel,
    QLineEdit,
    QPushButton,
    QScrollArea,
    QWidget,
)


def load(checkout: Path, name: str, monkeypatch):
    folder = checkout / "packaging" / "screenshots"
    monkeypatch.syspath_prepend(str(folder))
    return importlib.import_module(name)


@pytest.fixture
def texts(checkout: Path, monkeypatch):
    return load(checkout, "texts", monkeypatch)


@pytest.fixture
def sheets(checkout: Path, monkeypatch):
    return load(checkout, "sheets", monkeypatch)


@pytest.fixture
def window(qtbot) -> QWidget:
    window = QWidget()
    window.resize(600, 200)
    qtbot.addWidget(window)
    return window


def test_texts_with_room_are_no_fault(texts, window, qtbot) -> None:
    label, button = QLabel("A short text", window), QPushButton("Save", window)
    label.adjustSize()
    button.move(300, 0)
    button.adjustSize()
    window.show()
    assert texts.faults(window) == []


def test_a_label_narrower_than_its_text_is_found(texts, window) -> None:
    QLabel("A text that is much longer than its place", window).resize(40, 20)
    window.show()
    (fault,) = texts.faults(window)
    assert fault.text.startswith("A text that is much longer")
    assert fault.given == "40"


def test_a_button_narrower_than_its_text_is_found(texts, window) -> None:
    QPushButton("Open another folder", window).resize(30, 24)
    window.show()
    assert [fault.text for fault in texts.faults(window)] == ["Open another folder"]


def test_wrapped_lines_without_height_are_found(texts, window) -> None:
    label = QLabel("Several lines of text that need more height than there is", window, wordWrap=True)
    label.resize(100, 12)
    window.show()
    assert "high" in texts.faults(window)[0].needed


def test_texts_on_one_another_are_found(texts, window) -> None:
    for place in (0, 20):
        label = QLabel("One upon the other", window)
        label.adjustSize()
        label.move(place, 0)
    window.show()
    (fault,) = texts.faults(window)
    assert fault.needed == "overlap"


def test_a_text_beyond_its_frame_is_found(texts, window) -> None:
    frame = QWidget(window)
    frame.resize(60, 30)
    label = QLabel("Outside of the frame", frame)
    label.adjustSize()
    window.show()
    assert [fault.text for fault in texts.faults(window)] == ["Outside of the frame"]


def test_no_text_of_a_window_is_clipped(checkout: Path, tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, str(checkout / "packaging" / "screenshots" / "states.py"), "--program", "Color Swatch",
         "--theme", "light", "--language", "de", "--size", "1280x720", "--patience", "20", "--into", str(tmp_path)],
        env=os.environ | {"QT_QPA_PLATFORM": "offscreen", "BRDF_SUITE_CACHE": str(tmp_path / "cache")},
        capture_output=True,
        text=True,
        timeout=600,
        check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    assert len(list(tmp_path.glob("*.jpg"))) > 6


def test_texts_of_a_plot_that_lie_on_one_another_or_end_outside_are_found(texts, window) -> None:
    scene = QGraphicsScene(0.0, 0.0, 300.0, 100.0)
    view = QGraphicsView(scene, window)
    view.resize(320, 120)
    for text, x, y in (("one number", 10.0, 10.0), ("another", 30.0, 12.0), ("alone", 200.0, 60.0)):
        scene.addText(text).setPos(x, y)
    scene.addText("beyond the edge").setPos(260.0, 30.0)
    scene.addText("hidden").setPos(200.0, 62.0)
    scene.items()[0].setVisible(False)
    scene.setSceneRect(0.0, 0.0, 300.0, 100.0)
    window.show()
    found = [fault.text for fault in texts.faults(window)]
    assert sorted(found) == ["beyond the edge", "one number | another"] or sorted(found) == [
        "another | one number",
        "beyond the edge",
    ]


def test_a_part_wider_than_the_area_that_only_scrolls_down_is_found(texts, window) -> None:
    area = QScrollArea(window)
    area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    area.resize(200, 100)
    area.setWidget(QPushButton("A button that is wider than its place, by far wider"))
    window.show()
    assert "that scroll" in texts.faults(window)[0].given


def test_a_hint_longer_than_its_line_is_found(texts, window) -> None:
    QLineEdit(window, placeholderText="Search names, codes, tags and notes").resize(60, 24)
    window.show()
    assert [fault.text for fault in texts.faults(window)] == ["Search names, codes, tags and notes"]


def test_a_state_that_looks_different_from_its_sheet_is_found(sheets, tmp_path: Path) -> None:
    pytest.importorskip("flip_evaluator", reason="the extra reference is not installed")
    pictures = {state: picture_of(tmp_path / f"{state}.png", state) for state in ("start", "error", "busy")}
    path = sheets.write_sheet(tmp_path / "kept", "viewer_dark", pictures)
    assert path.stat().st_size < 100_000
    again = sheets.changes(tmp_path / "kept", "viewer_dark", pictures)
    assert list(again) == ["start", "error", "busy"]
    assert max(again.values()) < sheets.THRESHOLD
    pictures["error"] = picture_of(tmp_path / "new.png", "another text")
    del pictures["busy"]
    changed = sheets.changes(tmp_path / "kept", "viewer_dark", pictures | {"new": pictures["start"]})
    assert [state for state, error in changed.items() if error > sheets.THRESHOLD] == ["error", "busy", "new"]


def picture_of(path: Path, text: str) -> Path:
    """Save a picture of 1280 × 720 that has a text in it."""
    whole = Image.new("RGB", (1280, 720), (60, 60, 60))
    ImageDraw.Draw(whole).text((300, 200), text, (230, 230, 230), ImageFont.load_default(60))
    whole.save(path)
    return path
