"""The strip of long work."""

from __future__ import annotations

from brdf_qt.fields.labels import ElidedLabel
from brdf_qt.program.theme import palette
from brdf_qt.window.progress_strip import ProgressStrip
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QProgressBar, QPushButton


def test_the_bar_is_grey_in_every_theme(qtbot):
    strip = ProgressStrip()
    qtbot.addWidget(strip)
    strip.set_job("light", 0.0, "filtering")
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
    strip.set_job("light", 0.0, "filtering", lambda: calls.append(1))
    assert strip.isVisible()
    with qtbot.waitSignal(strip.cancelled):
        strip.findChild(QPushButton).click()
    assert calls == [1]
    assert not strip.isVisible()


def test_each_job_has_a_line_and_ends_alone(qtbot):
    strip = ProgressStrip()
    qtbot.addWidget(strip)
    calls = []
    strip.set_job("light", 0.25, "Overcast: filtering", lambda: calls.append("light"))
    strip.set_job("surface", 0.5, "Car: reading", lambda: calls.append("surface"))
    strip.set_job("light", 0.75, "Overcast: filtering more", lambda: calls.append("another"))
    assert strip.jobs == ("light", "surface")
    assert [bar.value() for bar in strip.findChildren(QProgressBar)] == [750, 500]
    strip.findChildren(QPushButton)[0].click()
    assert calls == ["light"]
    assert strip.jobs == ("surface",)
    assert strip.isVisible()
    strip.end_job("surface")
    strip.end_job("surface")
    assert not strip.isVisible()


def test_a_text_gives_way_to_the_bar_and_the_button_and_says_so(qtbot):
    strip = ProgressStrip()
    qtbot.addWidget(strip)
    text = "a measured file with a long name.brdftable: fitting lobes to it, and looking for the best of them"
    strip.set_job("paint", 0.1, text, lambda: None)
    label = strip.findChild(ElidedLabel)
    strip.resize(1600, strip.sizeHint().height())
    assert label.shown_text == text
    strip.resize(320, strip.sizeHint().height())
    assert label.shown_text.endswith("…")
    assert label.toolTip() == text
    button, bar = strip.findChild(QPushButton), strip.findChild(QProgressBar)
    assert button.geometry().right() < strip.width()
    assert bar.width() >= 64
