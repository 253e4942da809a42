"""Texts of the windows: found where they are clipped or overlap, and none is in the states that are walked through."""

from __future__ import annotations

import importlib.util
import os
import subprocess
import sys
from pathlib import Path

import pytest
from PySide6.QtWidgets import QGraphicsScene, QGraphicsView, QLabel, QPushButton, QWidget


@pytest.fixture
def texts(checkout: Path):
    spec = importlib.util.spec_from_file_location(
        "texts", checkout / "packaging" / "screenshots" / "texts.py"
    )
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


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
