"""The program as it is started: arguments, screenshot, start-up report, small windows, themes, what is remembered."""

from __future__ import annotations

import json
import os
import subprocess
import sys

import numpy as np
import pytest
from brdf_qt.program import theme
from brdf_qt.program.settings import settings
from brdf_viewer import command_line as program
from brdf_viewer.documents import first_view, view_files
from brdf_viewer.documents.remembered import recall, remember
from brdf_viewer.paint import control
from PySide6.QtCore import QCoreApplication, QEvent, Qt
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QApplication, QLabel, QScrollArea

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.store import save_paint, save_view
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Sparkle
from brdf_suite.errors import FileError
from brdf_suite.pipeline.scene import default_view


def run(*arguments: str, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "brdf_viewer", *arguments],
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        timeout=240,
        check=False,
    )


def test_a_screenshot_of_a_complete_window(tmp_path, lights) -> None:
    file = tmp_path / "window.png"
    result = run(
        "red",
        "--environment",
        str(lights["bright"]),
        "--surface",
        "sphere",
        "--size",
        "900x600",
        "--theme",
        "booth",
        "--report-startup",
        "--screenshot",
        str(file),
    )
    assert result.returncode == 0, result.stderr
    times = json.loads(result.stdout)
    assert 0 < times["ready_s"] <= times["complete_s"] <= times["finished_s"]
    image = QImage(str(file))
    assert (image.width(), image.height()) == (900, 600)
    centre = image.pixelColor(280, 330)  # on the sphere
    assert centre.red() > centre.blue() + 20
    edge = image.pixelColor(895, 60)  # on the window
    assert edge.red() == edge.green() == edge.blue() == theme.grey(50).red()


def test_twice_the_pixels_at_twice_the_scale(tmp_path, lights) -> None:
    file = tmp_path / "window.png"
    # Without flakes a frame takes half the time.
    remember(settings("Viewer"), View(sparkle=Sparkle(mode="off")))
    arguments = ("--environment", str(lights["dim"]), "--surface", "sphere", "--size", "720x520")
    result = run(*arguments, "--screenshot", str(file), QT_SCALE_FACTOR="2")
    assert result.returncode == 0, result.stderr
    image = QImage(str(file))
    assert (image.width(), image.height()) == (1440, 1040)


def test_a_file_that_cannot_be_read_ends_an_unattended_run(tmp_path) -> None:
    bad = tmp_path / "bad.exr"
    bad.write_bytes(b"\x76\x2f\x31\x01 and no more")
    result = run("--environment", str(bad), "--surface", "sphere", "--screenshot", str(tmp_path / "w.png"))
    assert result.returncode == 1
    assert str(bad) in result.stderr
    assert "Traceback" not in result.stderr


def test_help_says_the_gestures_and_a_bad_theme_is_refused(capsys) -> None:
    shown = run("--help")
    assert shown.returncode == 0
    assert "Alt drag turns the light" in " ".join(shown.stdout.split())
    for wrong in (("--theme", "pink"), ("--size", "huge")):
        with pytest.raises(SystemExit) as refused:
            program.main(wrong)
        assert refused.value.code == 2
    assert "1280x800" in capsys.readouterr().err


def test_an_unknown_start_falls_back_to_what_is_shipped(start, tmp_path) -> None:
    view = View(environment=str(tmp_path / "gone.exr"), surface=str(tmp_path / "gone.glb"))
    viewer = start(view=view, paint=str(tmp_path / "gone.brdfpaint"))
    messages = viewer.messages()
    assert all("gone" in messages[kind] for kind in ("environment", "surface", "paint"))
    assert (viewer.view.environment, viewer.view.surface) == ("photo_studio", "speed_form")
    assert np.ptp(viewer.pixels()) > 50


def test_a_small_window_keeps_its_picture_and_scrolls_its_inspector(start) -> None:
    viewer = start(size=(1, 1), fill=True)
    smallest = viewer.window.minimumSize()
    assert viewer.window.size() == smallest
    assert smallest.width() <= 800
    assert smallest.height() <= 600
    assert viewer.canvas.width() > 250
    assert viewer.canvas.height() > 250
    inspector = viewer.window.inspector
    assert isinstance(inspector, QScrollArea)
    viewer.window.panel.bring_in_sight(viewer.window.relief)
    QApplication.processEvents()
    assert inspector.verticalScrollBar().maximum() > 0
    assert inspector.widget().width() <= inspector.viewport().width()  # nothing is cut off sideways


@pytest.mark.parametrize("name", ["dark", "booth", "light"])
def test_every_theme_is_neutral(viewer, name, qapp) -> None:
    theme.apply(qapp, name, remember=False)
    try:
        QApplication.processEvents()
        image = viewer.window.environment.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)
        flat = np.frombuffer(image.constBits(), np.uint8).reshape(-1, 4)[:, :3].astype(int)
        assert np.ptp(flat, axis=1).max() <= 2
        grey = viewer.window.surround()
        assert (
            grey[0]
            == grey[1]
            == grey[2]
            == pytest.approx(theme.grey({"dark": 20, "booth": 50, "light": 85}[name]).redF())
        )
    finally:
        theme.apply(qapp, theme.DEFAULT, remember=False)


def test_what_is_remembered_comes_back_and_what_is_gone_does_not(tmp_path, qapp) -> None:
    file = tmp_path / "light.exr"
    file.touch()
    view = View(
        environment=str(file), surface="sphere", tone_curve="linear", background="grey", fresnel="off"
    )
    remember(settings(), view)
    assert recall(settings()) == view
    file.unlink()
    ev = default_view().exposure_ev  # it starts afresh
    assert recall(settings()) == View(
        surface="sphere", exposure_ev=ev, tone_curve="linear", background="grey", fresnel="off"
    )
    settings().setValue("view/tone_curve", "sepia")
    settings().setValue("view/surface", "../../etc")
    assert recall(settings()) == View(exposure_ev=ev, background="grey", fresnel="off")


def test_closing_remembers_the_view(start, lights) -> None:
    viewer = start()
    viewer.state.change_view(tone_curve="characteristic", exposure_ev=3.0)
    viewer.close()
    view = recall(settings())
    assert view.tone_curve == "characteristic"
    assert view.environment == str(lights["dim"])
    assert view.exposure_ev == 0.0


def test_every_command_has_a_name_and_a_key_only_once(viewer) -> None:
    from brdf_qt.window.command_palette import commands

    keys = [a.shortcut().toString() for _, a in commands(viewer.window) if not a.shortcut().isEmpty()]
    assert len(keys) == len(set(keys))
    assert {"1", "2", "3", "4", "F", "Space", "Ctrl+E", "Ctrl+Shift+E", "Ctrl+Shift+U"} <= set(keys)


@pytest.mark.parametrize(
    ("arguments", "follows"),
    [((), True), (("red",), False), (("red", "--follow"), True), (("--follow",), True)],
)
def test_a_paint_on_the_command_line_is_kept_unless_designer_is_to_be_followed(
    monkeypatch, arguments, follows
) -> None:
    from brdf_qt.program import run as shared

    reported = []

    def made(_view, paint, *, follow):
        reported.append((paint, follow))
        raise SystemExit

    monkeypatch.setattr(shared, "create_application", lambda *_, **__: None)
    monkeypatch.setattr(program, "ViewerController", made)
    with pytest.raises(SystemExit):
        program.main(arguments)
    assert reported == [("red" if "red" in arguments else "blue", follows)]


@pytest.fixture
def own_paint(tmp_path):
    path = tmp_path / "mine.brdfpaint"
    save_paint(solid_paint("Mine", (40.0, 30.0, 20.0)), path)
    return path


@pytest.mark.parametrize("follow", [False, True])
def test_the_first_paint_is_read_off_the_windows_thread(start, own_paint, slow, follow: bool) -> None:
    reader = slow(control, "load_document")
    reader.go.set()
    viewer = start(paint=str(own_paint), follow=follow)
    assert viewer.state.fit.name == "Mine"
    assert viewer.state.paint_key == str(own_paint)
    assert viewer.controller.paint.following == follow


def test_a_slow_first_paint_keeps_no_picture_waiting_and_is_cancelled(start, own_paint, slow, qtbot) -> None:
    reader = slow(control, "load_document")
    viewer = start(paint=str(own_paint), wait=False)
    qtbot.waitUntil(reader.begun.is_set)
    qtbot.waitUntil(lambda: viewer.state.is_complete)
    default = viewer.state.fit.name
    assert default != "Mine"
    assert not viewer.controller.is_idle
    strip = viewer.window.progress
    qtbot.waitUntil(strip.isVisible)
    assert "mine" in strip_text(strip).lower()
    button = next(one for one in strip.findChildren(QAbstractButton) if one.isVisible())
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: viewer.controller.paint.is_idle)
    reader.go.set()
    qtbot.wait(100)
    assert viewer.state.fit.name == default
    # One that is not given up comes in its place.
    viewer.controller.open_file(str(own_paint))
    qtbot.waitUntil(lambda: viewer.state.fit.name == "Mine")


def test_a_first_paint_that_cannot_be_read_is_reported_with_its_file(start, tmp_path) -> None:
    path = tmp_path / "bad.brdfpaint"
    path.write_text("{}")
    viewer = start(paint=str(path))
    assert "bad.brdfpaint" in viewer.messages()["paint"]
    assert viewer.state.fit is not None


def test_a_view_of_the_start_that_takes_long_comes_later(lights, tmp_path, slow, qtbot, monkeypatch) -> None:
    path = tmp_path / "late.brdfview"
    save_view(View(environment=str(lights["bright"]), surface="sphere", exposure_ev=1.5), path)
    remember(settings(), View(environment=str(lights["dim"]), surface="sphere", sparkle=Sparkle(mode="off")))
    words = ["blue", "--view", str(path), "--environment", str(lights["dim"])]
    options = program.parser().parse_args(words)
    readers = slow(first_view, "load_view"), slow(view_files, "load_view")
    controller = program.make_viewer(options)
    try:
        assert controller.state.view.exposure_ev == 0.0
        assert not controller.views.is_idle
        for reader in readers:
            reader.go.set()
        qtbot.waitUntil(lambda: controller.views.is_idle)
        assert controller.state.view.exposure_ev == 1.5
        assert controller.state.view.environment == str(lights["dim"])
        # In time it is there from the beginning.
        await_first_views(monkeypatch)
        second = program.make_viewer(options)
        assert second.state.view.exposure_ev == 1.5
        assert not second.state.history.undo_text
        end(second)
    finally:
        end(controller)


def test_a_view_of_the_start_that_cannot_be_read_is_named(tmp_path, monkeypatch) -> None:
    await_first_views(monkeypatch)
    path = tmp_path / "bad.brdfview"
    path.write_text("{}")
    with pytest.raises(FileError, match=r"bad\.brdfview"):
        program.make_viewer(program.parser().parse_args(["--view", str(path)]))


def await_first_views(monkeypatch: pytest.MonkeyPatch) -> None:
    """Have a start wait for its view, however slow the machine is."""
    wait = first_view.FirstView.wait
    monkeypatch.setattr(first_view.FirstView, "wait", lambda self: wait(self, 120.0))


def end(controller) -> None:
    """Close a window as the user does, and take it away."""
    controller.window.close()
    controller.window.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


def strip_text(strip) -> str:
    return " ".join(label.text() for label in strip.findChildren(QLabel))
