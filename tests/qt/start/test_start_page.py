"""The start page: its gallery, what it asks for, recent work, and that nothing heavy is imported for it."""

from __future__ import annotations

import subprocess
import sys

import pytest
from brdf_qt.documents.recent_files import RecentFiles, recent_projects
from brdf_qt.start.gallery import Gallery, gallery
from brdf_qt.start.page import StartWindow, is_wanted
from PIL import Image
from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QToolButton

from brdf_suite.pipeline.material import paint_titles
from brdf_suite.resources import resource


@pytest.fixture
def page(qtbot) -> StartWindow:
    page = StartWindow("Designer")
    qtbot.addWidget(page)
    with qtbot.waitSignal(page.painted):
        page.show()
    return page


def test_the_gallery_has_shipped_paints_by_their_titles_as_small_pictures():
    titles = paint_titles()
    assert 12 <= len(gallery()) <= 16
    for name, title in gallery().items():
        assert titles[name] == title
        file = resource("gallery", f"{name}.jpg")
        assert file.stat().st_size <= 15_000
        with Image.open(file) as picture:
            assert picture.size == (400, 250)


def test_each_part_asks_for_what_it_names(page, qtbot):
    with qtbot.waitSignal(page.paint_chosen) as asked:
        qtbot.mouseClick(page.gallery.tiles["pearl"], Qt.MouseButton.LeftButton)
    assert asked.args == ["pearl"]
    for key in ("New", "new_from_measurement", "acquire_sample", "open_project", "tour", "manual"):
        button = page.findChild(QToolButton, f"start_{key}")
        with qtbot.waitSignal(page.command_chosen) as asked:
            qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
        assert asked.args == [key]


def test_recent_projects_and_files_are_listed_and_opened(page, qtbot, tmp_path):
    project, paint = tmp_path / "spring.brdfproject", tmp_path / "red.brdfpaint"
    project.mkdir()
    paint.write_text("{}")
    RecentFiles().add(paint)
    recent_projects().add(project)
    page.refresh()
    assert [page.recent.item(n).text() for n in range(page.recent.count())] == [project.name, paint.name]
    place = page.recent.visualItemRect(page.recent.item(0)).center()
    with qtbot.waitSignal(page.file_chosen) as asked:
        qtbot.mouseClick(page.recent.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert asked.args == [project]
    paint.unlink()
    page.refresh()
    assert page.recent.count() == 1


def test_it_is_shown_at_start_until_that_is_unticked(page, qtbot):
    assert is_wanted()
    assert page.wanted.isChecked()
    page.wanted.click()
    assert not is_wanted()


def test_a_language_asks_for_a_start_in_it_and_the_one_in_use_for_nothing(page, qtbot):
    assert {code: button.text() for code, button in page.languages.items()} == {
        "en": "English",
        "de": "Deutsch",
    }
    assert page.languages["en"].isChecked()
    with qtbot.assertNotEmitted(page.language_chosen):
        qtbot.mouseClick(page.languages["en"], Qt.MouseButton.LeftButton)
    with qtbot.waitSignal(page.language_chosen) as asked:
        qtbot.mouseClick(page.languages["de"], Qt.MouseButton.LeftButton)
    assert asked.args == ["de"]


def test_it_has_the_keys_of_the_window(page, qtbot):
    for keys, key in (("Ctrl+N", "New"), ("Ctrl+Shift+N", "new_from_measurement")):
        with qtbot.waitSignal(page.command_chosen) as asked:
            QTest.keySequence(page, QKeySequence(keys))
        assert asked.args == [key]


def test_escape_puts_it_away(page, qtbot):
    qtbot.keyClick(page, Qt.Key.Key_Escape)
    assert not page.isVisible()


@pytest.mark.parametrize("width", [420, 700, 1100])
def test_tiles_fill_the_width_and_do_not_overlap(qtbot, width):
    shown = Gallery()
    qtbot.addWidget(shown)
    shown.resize(width, 600)
    shown.show()
    boxes = [tile.geometry() for tile in shown.tiles.values()]
    assert all(box.right() < width and box.left() >= 0 for box in boxes)
    assert not any(a.intersects(b) for n, a in enumerate(boxes) for b in boxes[:n])
    assert max(box.right() for box in boxes) > 0.9 * width
    assert shown.minimumHeight() >= max(box.bottom() for box in boxes)


def test_nothing_heavy_is_imported_for_it():
    code = "import brdf_qt.start.launch, sys; print('\\n'.join(sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    loaded = set(done.stdout.split())
    assert "brdf_qt.start.page" in loaded
    assert not loaded & {"numpy", "moderngl", "pyqtgraph", "brdf_designer", "brdf_suite.pipeline", "PIL"}
