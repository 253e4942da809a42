"""The tone section: curves, marks, what the screen cannot show, and the monitor's profile."""

from __future__ import annotations

import ctypes
import ctypes.util
import os
import shutil
import subprocess
import sys
import time
from collections.abc import Callable
from types import ModuleType

import numpy as np
import pytest
from brdf_qt.program import monitor_profile
from brdf_qt.program.application import declared_colour_space
from brdf_qt.program.monitor_profile import monitor_of
from brdf_qt.window.view_titles import TONE_TITLES
from brdf_viewer.tone.section import describe_clipping
from PIL import Image
from PySide6.QtGui import QSurfaceFormat
from PySide6.QtWidgets import QWidget

from brdf_suite.appearance.colour.colorimetry import srgb_decode
from brdf_suite.appearance.colour.spaces import DISPLAY_P3_SPACE, SRGB_SPACE
from brdf_suite.documents.view import TONE_CURVES
from brdf_suite.files.images.icc import profile_bytes
from brdf_suite.realtime.pictures.display import Unshowable


def choose(viewer, key: str) -> None:
    box = viewer.window.tone.curve
    box.activated.emit(box.findData(key))


def test_every_curve_has_its_title_and_its_picture(viewer) -> None:
    assert set(TONE_TITLES) == set(TONE_CURVES)
    viewer.state.change_view(exposure_ev=2.0)  # some of it is above 0.8
    seen = []
    for key in TONE_CURVES:
        choose(viewer, key)
        assert viewer.view.tone_curve == key
        assert viewer.window.tone.curve.currentData() == key
        seen.append(viewer.pixels().astype(int))
    for i, one in enumerate(seen):
        assert all(np.abs(one - other).max() > 3 for other in seen[i + 1 :])


def test_linear_comes_with_its_clipping_marked_and_takes_the_marks_along(viewer) -> None:
    choose(viewer, "linear")
    assert viewer.view.clipping_marks
    assert viewer.window.tone.clipping.isChecked()
    choose(viewer, "faithful")
    assert not viewer.view.clipping_marks
    viewer.window.tone.clipping.click()
    choose(viewer, "linear")
    choose(viewer, "faithful")
    assert viewer.view.clipping_marks  # the user's own


def test_marks_and_count(viewer) -> None:
    viewer.window.panel.bring_in_sight(viewer.window.tone)  # what is not seen is not counted
    choose(viewer, "linear")
    viewer.window.tone.clipping.click()
    viewer.state.change_view(exposure_ev=5.0, background="grey")
    plain = viewer.pixels()
    tone = viewer.controller.tone

    def reports_bright() -> bool:
        # Counted again after every frame: a count from before the exposure, or none yet, may still be there.
        seen = tone.counted
        return (
            seen is not None
            and seen.too_bright > 0
            and viewer.window.tone.counted.text() == describe_clipping(seen)
        )

    viewer.qtbot.waitUntil(reports_bright)
    counted = tone.counted
    assert "of the object" in viewer.window.tone.counted.text()
    viewer.window.tone.clipping.click()
    box = viewer.window.tone.style_box
    box.activated.emit(box.findData("colour"))
    marked = viewer.pixels()
    orange = (np.abs(marked.astype(int) - [213, 94, 0]).max(axis=-1) <= 1).mean()
    assert orange > 0.5 * counted.too_bright / counted.pixels * (plain != marked).any(axis=-1).mean()
    assert orange > 0.01


def test_words_of_the_count() -> None:
    assert describe_clipping(Unshowable(0, 0, 0)) == "The object is outside the picture"
    assert describe_clipping(Unshowable(1000, 0, 0)) == "Clipped highlights: none; out of gamut: none"
    assert "less than 0.1 % of the object" in describe_clipping(Unshowable(100_000, 3, 70_000))
    assert "70.0 %" in describe_clipping(Unshowable(100_000, 3, 70_000))


class RootProperty:
    """A property of the X server's root window, as colord sets it; it stays while this connection is open."""

    def __init__(self, name: str, data: bytes) -> None:
        self._x11 = ctypes.CDLL(ctypes.util.find_library("X11"))
        self._x11.XOpenDisplay.restype = ctypes.c_void_p
        self._x11.XInternAtom.restype = ctypes.c_ulong
        self._x11.XDefaultRootWindow.restype = ctypes.c_ulong
        self._display = ctypes.c_void_p(self._x11.XOpenDisplay(None))
        self._root = ctypes.c_ulong(self._x11.XDefaultRootWindow(self._display))
        self._atom = ctypes.c_ulong(self._x11.XInternAtom(self._display, name.encode(), 0))
        cardinal = ctypes.c_ulong(6)
        self._x11.XChangeProperty(self._display, self._root, self._atom, cardinal, 8, 0, data, len(data))
        self._x11.XSync(self._display, 0)

    def __enter__(self) -> RootProperty:
        return self

    def __exit__(self, *_: object) -> None:
        self._x11.XDeleteProperty(self._display, self._root, self._atom)
        self._x11.XSync(self._display, 0)
        self._x11.XCloseDisplay(self._display)


@pytest.mark.screen
def test_the_monitors_profile_is_read_and_drawn_with(start, tmp_path) -> None:
    with RootProperty("_ICC_PROFILE", profile_bytes(DISPLAY_P3_SPACE)):
        asked = []
        viewer = start(ask_picture=lambda _window, name: asked.append(name) or str(tmp_path / "a.png"))
        tone = viewer.controller.tone
        viewer.qtbot.waitUntil(lambda: tone.display.space is not SRGB_SPACE)
        assert viewer.window.tone.profile_note.text() == "Monitor profile: Display P3"
        by_profile = viewer.pixels().astype(int)
        viewer.window.tone.profile.click()
        assert tone.display.space is SRGB_SPACE
        assert viewer.window.tone.profile_note.text().startswith("sRGB;")
        plain = viewer.pixels().astype(int)
        # Blue within sRGB is less than all of P3's blue, and has some of its red.
        difference = by_profile - plain
        assert np.abs(difference).max() > 5
        viewer.window.tone.profile.click()
        viewer.controller.save.save()
        with Image.open(tmp_path / "a.png") as image:
            saved = np.asarray(image.convert("RGB")).astype(int)
        assert np.abs(saved - plain).max() <= 1  # a file is in sRGB, whatever the monitor is
        assert np.array_equal(viewer.pixels(), by_profile)


@pytest.mark.screen
def test_a_profile_with_tables_is_drawn_with(start, load_helper: Callable[[str], ModuleType]) -> None:
    """Each pixel by the profile is what numpy makes of it without: the shader's and the core's tables are one."""
    made = load_helper("table_profiles.py")
    with RootProperty("_ICC_PROFILE", made.profile("mAB", "Lab", made.Screen(0.003))):
        viewer = start()
        tone = viewer.controller.tone
        viewer.qtbot.waitUntil(lambda: tone.display.space.table is not None)
        assert viewer.window.tone.profile_note.text() == "Monitor profile: Table screen (look-up tables)"
        assert monitor_of(viewer.window).space is tone.display.space  # read once
        by_profile = viewer.pixels().astype(float)
        viewer.window.tone.profile.click()
        plain = viewer.pixels()
        inside = ((plain > 8) & (plain < 250)).all(axis=-1)  # neither clipped nor so dark that a code is much
        assert inside.mean() > 0.2
        rho = srgb_decode(plain[inside] / 255.0) @ np.linalg.inv(SRGB_SPACE.from_working).T
        space = monitor_of(viewer.window).space
        wanted = 255.0 * space.encode(space.of_working(rho))
        assert np.abs(by_profile[inside] - wanted).mean() < 1.0  # both are dithered
        assert np.abs(plain[inside] - wanted).mean() > 2.0


@pytest.mark.screen
def test_without_a_profile_or_with_a_bad_one_srgb_is_assumed_and_said(qtbot) -> None:
    widget = QWidget()
    qtbot.addWidget(widget)
    monitor = monitor_of(widget)
    assert monitor.space is SRGB_SPACE
    assert monitor.description == "No monitor profile found; assuming sRGB"
    with RootProperty("_ICC_PROFILE", b"not a profile"):
        bad = monitor_of(widget)
    assert bad.space is SRGB_SPACE
    assert "is not an ICC profile" in bad.description


@pytest.mark.parametrize(("platform", "word"), [("cocoa", "macOS"), ("wayland-egl", "Wayland")])
def test_a_platform_that_manages_colour_is_named_where_it_took_the_declaration(
    qtbot, platform: str, word: str
) -> None:
    """A window's format has a colour space where the window system took it; another has none."""
    before = QSurfaceFormat.defaultFormat()
    declared = QSurfaceFormat(before)
    declared.setColorSpace(declared_colour_space(platform))
    widgets = []
    try:
        for form in (declared, before):
            QSurfaceFormat.setDefaultFormat(form)
            widgets.append(QWidget())
            qtbot.addWidget(widgets[-1])
            widgets[-1].winId()  # makes the window
    finally:
        QSurfaceFormat.setDefaultFormat(before)
    took, ignored = (monitor_of(widget, platform) for widget in widgets)
    assert word in took.description
    assert ignored.description == "sRGB; the window system does not manage colour"
    assert not took.is_measured
    assert not ignored.is_measured


def test_a_platform_without_colour_management_declares_nothing() -> None:
    assert not declared_colour_space("xcb").isValid()
    assert not declared_colour_space("windows").isValid()
    assert "assuming sRGB" in monitor_of(None, "offscreen").description


@pytest.mark.skipif(shutil.which("weston") is None, reason="weston is not installed")
def test_a_compositor_without_colour_management_is_reported(tmp_path) -> None:
    """Weston of before version 14 has no protocol for colour, and later ones need a setting: neither converts."""
    socket = "brdf-tone"
    surroundings = os.environ | {"XDG_RUNTIME_DIR": str(tmp_path), "LIBGL_ALWAYS_SOFTWARE": "1"}
    tmp_path.chmod(0o700)
    command = ["weston", "--backend=headless-backend.so", f"--socket={socket}", "--idle-time=0"]
    with subprocess.Popen(
        command, env=surroundings, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    ) as weston:
        try:
            while not (tmp_path / socket).exists():
                assert weston.poll() is None
                time.sleep(0.05)
            found = subprocess.run(
                [sys.executable, "-c", _ASK],
                env=surroundings | {"WAYLAND_DISPLAY": socket, "QT_QPA_PLATFORM": "wayland"},
                capture_output=True,
                text=True,
                check=True,
            )
        finally:
            weston.terminate()
    assert found.stdout.splitlines() == ["True", "sRGB; the window system does not manage colour"]


_ASK = """
from brdf_qt.program.application import create_application
from brdf_qt.program.monitor_profile import monitor_of
from PySide6.QtWidgets import QWidget

app = create_application("Viewer", language="en")
widget = QWidget()
widget.show()
app.processEvents()
print(widget.windowHandle().requestedFormat().colorSpace().isValid())
print(monitor_of(widget).description)
"""


def test_no_x_library_is_no_profile(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(monitor_profile.ctypes.util, "find_library", lambda _name: None)
    assert not monitor_of(None, "xcb").is_measured
