"""The strip of long work."""

from __future__ import annotations

from brdf_qt.progress_strip import ProgressStrip
from brdf_qt.theme import palette
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QProgressBar


def test_the_bar_is_grey_in_every_theme(qtbot):
    strip = ProgressStrip()
    qtbot.addWidget(strip)
    bar = strip.findChild(QProgressBar)
    for name in ("dark", "booth", "light"):
        strip.setPalette(palette(name))
        colour = bar.palette().color(QPalette.ColorRole.Highlight)
        assert colour.red() == colour.green() == colour.blue()
        assert colour == palette(name).color(QPalette.ColorRole.PlaceholderText)


def test_cancel_calls_once_and_hides(qtbot):
    strip = ProgressStrip()
    qtbot.addWidget(strip)
    calls = []
    strip.begin("filtering", lambda: calls.append(1))
    assert strip.isVisible()
    with qtbot.waitSignal(strip.cancelled):
        strip._cancel.click()
    assert calls == [1]
    assert not strip.isVisible()
