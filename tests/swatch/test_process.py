"""The program itself, as a process: a picture of its window, and the errors for bad arguments."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from PySide6.QtGui import QImage


def run(*arguments: str, **variables: str) -> subprocess.CompletedProcess[str]:
    words = [sys.executable, "-m", "brdf_color_swatch", *arguments]
    return subprocess.run(
        words, env={**os.environ, **variables}, capture_output=True, text=True, timeout=240, check=False
    )


def test_a_picture_of_the_window_with_the_shipped_paints(tmp_path: Path) -> None:
    picture = tmp_path / "window.png"
    done = run(
        "shipped", "--form", "chips", "--size", "800x600", "--do", "sort=hue", "--report-startup",
        "--screenshot", str(picture),
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (0, "")
    assert '"ready_s"' in done.stdout
    image = QImage(str(picture))
    assert (image.width(), image.height()) == (800, 600)
    colours = {image.pixel(x, y) for x in range(160, 560, 9) for y in range(100, 500, 9)}
    assert len(colours) > 20


def test_an_unknown_action_ends_with_a_word() -> None:
    done = run("--do", "dance", "--quit-after", "60")
    assert done.returncode == 2
    assert "there is no such action" in done.stderr


def test_messages_of_qt_after_the_end_of_the_interpreter_harm_nothing() -> None:
    done = run(
        "--quit-after", "0", QT_DEBUG_PLUGINS="1", QT_QPA_PLATFORM="offscreen"
    )  # plug-ins report their end
    assert (done.returncode, done.stdout) == (0, "")


def test_swatches_that_are_on_the_clipboard_at_the_end_harm_nothing(tmp_path: Path) -> None:
    line = ("shipped", "--form", "chips", "--do", "select=0", "--do", "copy")
    done = run(*line, "--screenshot", str(tmp_path / "window.png"), QT_QPA_PLATFORM="offscreen")
    assert (done.returncode, done.stderr) == (0, "")
