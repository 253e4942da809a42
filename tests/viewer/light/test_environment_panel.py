"""The environment panel: figures counted in the background, studios that are edited, layouts that are chosen."""

from __future__ import annotations

import json
import os
import threading
from pathlib import Path

import numpy as np
from brdf_qt.documents.watch import FileWatch
from brdf_qt.work import scene_loading as loading
from brdf_viewer.documents.file_kinds import ENDINGS, kind_of
from brdf_viewer.documents.remembered import recall, remember
from brdf_viewer.light.environment_section import LAYOUT_TITLES, HistogramBars, lines
from PySide6.QtCore import QSettings

from brdf_suite.documents.studio import Sky, save_light
from brdf_suite.documents.view import ENVIRONMENT_LAYOUTS, View
from brdf_suite.files.images.environments import write_exr
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.statistics import Histogram, environment_statistics


def figures(viewer):
    return viewer.window.environment.figures


def shown(viewer, qtbot) -> str:
    viewer.wait_idle()
    qtbot.waitUntil(lambda: not figures(viewer).isHidden())
    return figures(viewer).text.text()


def test_the_figures_of_the_light_are_shown(viewer, lights, qtbot) -> None:
    first = shown(viewer, qtbot)
    viewer.controller.open_file(str(lights["bright"]))
    viewer.wait_idle()
    qtbot.waitUntil(lambda: not figures(viewer).isHidden() and figures(viewer).text.text() != first)
    expected = environment_statistics(viewer.state.environment.value.environment)
    assert figures(viewer).text.text().splitlines() == lines(expected)
    assert figures(viewer).bars.histogram == expected.histogram
    assert "%" in figures(viewer).bars.accessibleDescription()


def test_they_are_counted_off_the_interface_thread(viewer, lights, qtbot, monkeypatch) -> None:
    shown(viewer, qtbot)
    threads = []
    count = loading.environment_statistics

    def noted(environment: Environment):
        threads.append(threading.current_thread() is threading.main_thread())
        return count(environment)

    monkeypatch.setattr(loading, "environment_statistics", noted)
    viewer.controller.open_file(str(lights["bright"]))
    viewer.wait_idle()
    qtbot.waitUntil(lambda: bool(threads))
    assert threads == [False]


def test_an_even_and_a_black_light_have_figures_too(qtbot) -> None:
    bars = HistogramBars()
    qtbot.addWidget(bars)
    for value in (0.0, 1.0):
        environment = Environment("x", np.full((8, 16, 3), value, np.float32))
        statistics = environment_statistics(environment)
        assert any("No dominant" in line for line in lines(statistics))
        bars.set_histogram(statistics.histogram)
        assert not bars.grab().isNull()
    bars.set_histogram(Histogram(-3.0, (0.5, 0.0, 0.5), 0.0))
    bars.resize(300, bars.height())
    image = bars.grab().toImage()
    columns = [image.pixelColor(x, 30).lightness() for x in (50, 150, 250)]
    assert columns[0] == columns[2] != columns[1]


def edited(path: Path, **fields: object) -> None:
    """Replace a document as an editor does: another file of the same name."""
    document = json.loads(path.read_text()) | fields
    other = path.with_suffix(".tmp")
    other.write_text(json.dumps(document))
    other.replace(path)


def is_another_whole_one(viewer, before) -> bool:
    now = viewer.state.environment.value
    return now is not before and now.is_final


def test_a_studio_is_drawn_again_when_it_is_edited(viewer, tmp_path, qtbot) -> None:
    path = tmp_path / "mine.brdfstudio"
    save_light(Sky("s", "overcast", ground_albedo=0.05), path)
    viewer.controller.open_file(str(path))
    viewer.wait_idle()
    assert viewer.view.environment == str(path)
    assert viewer.window.status.cell("environment").text() == "mine.brdfstudio"
    dark = viewer.state.environment.value
    assert not viewer.window.environment.layout_list.isEnabled()
    edited(path, ground_albedo=0.9)
    qtbot.waitUntil(lambda: is_another_whole_one(viewer, dark))
    bright = viewer.state.environment.value
    assert bright.environment.average()[1] > 1.2 * dark.environment.average()[1]

    edited(path, ground_albedo=9.0)  # a typing error: reported, and the picture stays
    qtbot.waitUntil(lambda: "environment" in viewer.window.messages.shown())
    assert viewer.state.environment.value is bright
    edited(path, ground_albedo=0.4)
    qtbot.waitUntil(lambda: is_another_whole_one(viewer, bright))
    assert "environment" not in viewer.window.messages.shown()


def test_only_another_content_counts_as_a_change(tmp_path, qtbot) -> None:
    path = tmp_path / "a.brdfstudio"
    path.write_text("one")
    watch = FileWatch()
    watch.watch(str(path))
    reported = []
    watch.changed.connect(reported.append)
    os.utime(path, (1, 1))
    (tmp_path / "other").write_text("beside it")
    qtbot.wait(500)
    assert reported == []
    path.unlink()
    qtbot.wait(300)
    path.write_text("two")
    qtbot.waitUntil(lambda: reported == [str(path)])
    watch.watch("")
    path.write_text("three")
    qtbot.wait(400)
    assert reported == [str(path)]


def test_another_layout_is_read_and_kept_in_the_view(viewer, tmp_path, qtbot) -> None:
    pixels = np.ones((64, 64, 3), np.float32)
    pixels[20:24, 40:44] = 4.0
    path = tmp_path / "ball.exr"
    write_exr(path, pixels)
    viewer.controller.open_file(str(path))
    viewer.wait_idle()
    probe = viewer.state.environment.value.environment
    viewer.window.environment.layout_list.picked.emit("mirror_ball")
    viewer.wait_idle()
    assert viewer.view.environment_layout == "mirror_ball"
    assert viewer.window.environment.layout_list.currentData() == "mirror_ball"
    assert viewer.state.environment.value.environment.content_hash != probe.content_hash
    viewer.window.environment.layout_list.picked.emit("vertical_cross")  # cannot be, by its shape
    qtbot.waitUntil(lambda: "environment" in viewer.window.messages.shown())
    assert viewer.view.environment_layout == "mirror_ball"
    assert viewer.window.environment.layout_list.currentData() == "mirror_ball"


def test_the_layout_is_remembered_with_its_file(tmp_path: Path) -> None:
    path = tmp_path / "ball.exr"
    write_exr(path, np.ones((16, 16, 3), np.float32))
    store = QSettings(str(tmp_path / "s.ini"), QSettings.Format.IniFormat)
    remember(store, View(environment=str(path), environment_layout="mirror_ball"))
    assert recall(store).environment_layout == "mirror_ball"
    path.unlink()
    assert recall(store).environment_layout == "auto"


def test_names_are_complete() -> None:
    assert tuple(LAYOUT_TITLES) == ENVIRONMENT_LAYOUTS
    assert kind_of("x.BRDFSTUDIO") == "environment"
    assert ".brdfstudio" in ENDINGS["environment"]
