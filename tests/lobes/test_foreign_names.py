"""Names from files are plain text all over the Lobe Visualizer, and a wheel over its fields changes nothing."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from brdf_lobe_visualizer.assembly import LobeVisualizer
from PySide6.QtCore import QCoreApplication, QEvent

from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.documents.store import save_paint
from brdf_suite.pipeline.material import load_document, load_shipped_paint


@pytest.fixture
def whole(qapp, own_session):
    """The program with all of its parts; without OpenGL the view in three dimensions says that it cannot be."""
    program = LobeVisualizer()
    program.window.resize(1400, 900)
    program.window.show()
    yield program
    program.close()
    program.window.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


def test_names_are_plain_text_in_the_whole_window(whole, walks, qtbot, tmp_path: Path) -> None:
    paint = tmp_path / f"{walks.HOSTILE_FILE}.brdfpaint"
    lobes = tmp_path / f"{walks.HOSTILE_FILE} lobes.brdfpaint"
    palette = tmp_path / f"{walks.HOSTILE_FILE}.brdfpalette"
    copper = replace(load_shipped_paint("copper"), name=walks.HOSTILE)
    save_paint(copper, paint)
    save_paint(replace(load_document("table1_blue"), name=walks.HOSTILE), lobes)
    save_palette(
        Palette(walks.HOSTILE, (Entry(copper), Entry(replace(copper, name=f"{walks.HOSTILE} 2")))), palette
    )
    for path in (paint, lobes, palette, tmp_path / f"{walks.HOSTILE_FILE} none.brdfpaint"):
        with qtbot.waitSignal(whole.sources.idle):
            whole.sources.open(path)
    for key in whole.window.plots.plots:
        whole.window.plots.set_shown(key, True)
    whole.panel_dock.show()
    whole.numbers.dock.show()
    qtbot.waitUntil(lambda: whole.is_idle)
    whole.window.show_recent([paint])
    assert whole.window.messages.shown()
    wrong, seen = walks.drawn_as_html()
    assert wrong == []
    assert seen > 10


def test_a_wheel_changes_nothing_in_the_window(whole, walks, qtbot) -> None:
    with qtbot.waitSignal(whole.sources.idle):
        whole.sources.open("copper")
    whole.panel_dock.show()
    whole.numbers.dock.show()
    qtbot.waitUntil(lambda: whole.is_idle)
    options = whole.session.options
    changed, count = walks.changed_by_wheel(whole.window)
    assert changed == []
    assert count > 10
    assert whole.session.options == options
