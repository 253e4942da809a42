"""Choosing by pictures: what is listed, found, taken by mouse and keys, dragged, and which pictures are made."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from brdf_color_swatch.editing.transfer import read_data
from brdf_qt.choosing.palettes import read_palette_sources
from brdf_qt.choosing.picker import SourceChooser
from brdf_qt.choosing.scenes import SceneThumbnails
from brdf_qt.choosing.sources import FilteredSources, Source, SourceModel
from brdf_qt.choosing.strip import PaintStrip
from brdf_qt.choosing.thumbnails import PaintThumbnails
from brdf_qt.work.pictures import Pictures
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest

from brdf_suite.documents.paint import Paint, solid_paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.documents.store import save_paint
from brdf_suite.errors import FileError
from brdf_suite.files.images.environments import write_exr
from brdf_suite.lighting.environment import Environment
from brdf_suite.pipeline.material import load_document
from brdf_suite.pipeline.scene import environment_names, surface_names
from brdf_suite.resources import resource_root

RED = solid_paint("Signal red", (45.0, 60.0, 40.0))


@pytest.fixture
def pictures(qtbot) -> Iterator[Pictures]:
    """The picture service without its process: what is asked for is still to come."""
    service = Pictures()
    service.program = []
    yield service
    service.close()


def load(key: str) -> Paint:
    """Read any key as a paint of its name; one is broken."""
    if key == "broken":
        raise FileError(key, "is broken")
    return solid_paint(key, (30.0, 0.0, 0.0))


def model_of(*sources: Source) -> SourceModel:
    model = SourceModel()
    model.set_sources(sources)
    return model


def titles(filtered: FilteredSources) -> list[str]:
    return [filtered.index(row, 0).data() for row in range(filtered.rowCount())]


@given(
    st.lists(st.text(st.sampled_from("abc "), max_size=5), max_size=8),
    st.text(st.sampled_from("abcA "), max_size=3),
)
def test_search_keeps_what_holds_every_word_in_its_order(names: list[str], text: str) -> None:
    filtered = FilteredSources(model_of(*(Source(f"{n}", name) for n, name in enumerate(names))))
    filtered.set_text(text)
    assert titles(filtered) == [name for name in names if all(word in name for word in text.lower().split())]


def test_groups_and_what_was_taken_last_comes_first(pictures) -> None:
    model = model_of(
        Source("blue", "Blue"),
        Source("red", "Red"),
        Source("/a.brdfpaint", "a", "recent"),
        Source("p:1", "p", "palette"),
    )
    thumbnails = PaintThumbnails(pictures, load)
    model.set_thumbnails(thumbnails)
    filtered = FilteredSources(model)
    for key in ("blue", "p:1", "red"):
        model.note_taken(key)
    found = {}
    for group in ("", "recent", "shipped", "palette"):
        filtered.set_group(group)
        found[group] = titles(filtered)
    assert found == {
        "": ["Blue", "Red", "a", "p"],
        "recent": ["Red", "Blue", "a"],
        "shipped": ["Blue", "Red"],
        "palette": ["p"],
    }
    again = model_of(Source("blue", "Blue"), Source("red", "Red"))  # of the next run
    again.set_thumbnails(PaintThumbnails(pictures, load))
    assert [again.rank(row) for row in (0, 1)] == [1, 0]


def test_only_what_is_in_sight_is_read_and_asked_for(qtbot, pictures) -> None:
    read: list[str] = []

    def note(key: str) -> Paint:
        read.append(key)
        return load(key)

    model = model_of(*(Source(f"paint {n}", f"Paint {n}") for n in range(5000)))
    thumbnails = PaintThumbnails(pictures, note)
    model.set_thumbnails(thumbnails)
    strip = PaintStrip(model)
    qtbot.addWidget(strip)
    strip.resize(900, strip.sizeHint().height())
    strip.show()
    qtbot.waitUntil(lambda: "strip" in thumbnails._asked)
    assert not read, "nothing is read before the start"
    thumbnails.start()
    qtbot.waitUntil(lambda: pictures.waiting > 0)
    seen = len(read)
    assert read[0] == "paint 0"
    assert 5 <= seen <= 20
    strip.view.horizontalScrollBar().setValue(strip.view.horizontalScrollBar().maximum())
    qtbot.waitUntil(lambda: "paint 4999" in read)
    assert len(read) <= 2 * seen + 5
    thumbnails.close()


def test_a_paint_that_cannot_be_read_stays_grey_and_the_others_come(qtbot, pictures) -> None:
    thumbnails = PaintThumbnails(pictures, load)
    thumbnails.start()
    with qtbot.waitSignal(thumbnails.arrived):
        thumbnails.request("test", [("broken", None), ("fine", None)])
    assert thumbnails.content("broken") is None
    assert thumbnails.content("fine") == load("fine")
    assert thumbnails.picture("broken").toImage() != thumbnails.picture("fine").toImage()
    thumbnails.close()


def test_the_strip_is_used_by_mouse_and_keys(qtbot, pictures) -> None:
    model = model_of(Source("blue", "Blue"), Source("red", "Red"), Source("dark", "Dark red"))
    strip = PaintStrip(model, second=True)
    qtbot.addWidget(strip)
    strip.resize(700, strip.sizeHint().height())
    strip.show()
    taken: list[tuple[str, str]] = []
    strip.taken.connect(lambda key: taken.append(("A", key)))
    strip.second_taken.connect(lambda key: taken.append(("B", key)))
    qtbot.waitExposed(strip)

    def click(row: int, *, on_mark: bool = False) -> None:
        box = strip.view.visualRect(strip.sources.index(row, 0))
        place = strip.view.mark_box(box).center() if on_mark else box.center()
        QTest.mouseClick(strip.view.viewport(), Qt.MouseButton.LeftButton, pos=place)

    click(1)
    model.set_present("red")
    click(0, on_mark=True)
    click(1, on_mark=True)  # that of the paint on show has none
    strip.search.setFocus()
    QTest.keyClicks(strip.search, "red")
    assert titles(strip.sources) == ["Red", "Dark red"]
    strip.view.setCurrentIndex(strip.sources.index(0, 0))
    QTest.keyClick(strip.search, Qt.Key.Key_Down)
    QTest.keyClick(strip.view, Qt.Key.Key_Right)
    QTest.keyClick(strip.view, Qt.Key.Key_Return)
    QTest.keyClick(strip.view, Qt.Key.Key_Return, Qt.KeyboardModifier.ShiftModifier)
    QTest.keyClick(strip.search, Qt.Key.Key_Return)
    assert taken == [("A", "red"), ("B", "blue"), ("A", "red"), ("A", "dark"), ("B", "dark"), ("A", "red")]


def test_the_mark_of_comparing_is_seen_under_the_pointer_and_where_it_is_done(qtbot, pictures) -> None:
    model = model_of(Source("blue", "Blue"), Source("red", "Red"))
    strip = PaintStrip(model, second=True)
    qtbot.addWidget(strip)
    strip.resize(700, strip.sizeHint().height())
    strip.show()
    qtbot.waitExposed(strip)
    view = strip.view
    box = view.visualRect(strip.sources.index(1, 0))

    def mark() -> QImage:
        return view.viewport().grab(view.mark_box(box)).toImage()

    plain = mark()
    QTest.mouseMove(view.viewport(), box.center())
    qtbot.waitUntil(lambda: mark() != plain)
    QTest.mouseMove(view.viewport(), QPoint(300, 10))
    qtbot.waitUntil(lambda: mark() == plain)
    view.show_second("red")
    assert mark() != plain
    view.show_second("")
    assert mark() == plain


def test_what_is_dragged_is_what_color_swatch_reads(tmp_path: Path, pictures) -> None:
    file = tmp_path / "red.brdfpaint"
    save_paint(RED, file)
    model = model_of(Source(str(file), "red", "recent", RED), Source("model", "A model"))
    model.set_thumbnails(PaintThumbnails(pictures, load))
    data = model.mimeData([model.index(0)])
    assert [entry.content for entry in read_data(data).entries] == [RED]
    assert [url.toLocalFile() for url in data.urls()] == [str(file)]
    assert model.mimeData([model.index(1)]) is None, "a reflectance without a document cannot be dropped"


def test_the_picker_opens_a_grid_that_is_searched_and_taken_from(qtbot) -> None:
    chooser = SourceChooser("Open")
    qtbot.addWidget(chooser)
    chooser.set_sources([Source("blue", "Blue"), Source("red", "Red")], [Source("/x/own.exr", "own.exr")])
    chooser.show_source("blue", "")
    chooser.show()
    chosen: list[str] = []
    chooser.chosen.connect(chosen.append)
    QTest.keyClick(chooser.list, Qt.Key.Key_Space)
    popup = chooser.list.popup
    assert popup is not None
    assert popup.isVisible()
    QTest.keyClick(popup, Qt.Key.Key_Escape)
    assert (popup.isVisible(), chosen) == (False, [])
    QTest.mousePress(chooser.list, Qt.MouseButton.LeftButton, pos=QPoint(5, 5))
    QTest.keyClicks(popup.search, "ow")
    QTest.keyClick(popup.search, Qt.Key.Key_Return)
    assert (popup.isVisible(), chosen, chooser.list.currentText()) == (False, ["/x/own.exr"], "own.exr")
    chooser.set_sources([Source("blue", "Blue")], [Source("/x/own.exr", "own.exr")])
    assert chooser.list.currentData() == "/x/own.exr"


def test_every_shipped_light_and_form_has_its_own_small_picture(pictures) -> None:
    for kind, names in (("environments", environment_names()), ("meshes", surface_names())):
        thumbnails = SceneThumbnails(kind, pictures)
        images = [thumbnails.picture(name).toImage() for name in names]
        assert all(image.width() == image.height() == 128 for image in images)
        assert all(image != other for image in images for other in images if image is not other)
    assert all(file.stat().st_size <= 10_000 for file in (resource_root() / "thumbnails").rglob("*.jpg"))


def test_a_light_of_the_users_gets_its_picture_on_a_thread(qtbot, pictures, tmp_path: Path) -> None:
    radiance = np.full((64, 128, 3), 0.1, np.float32)
    radiance[:32] = (0.2, 0.4, 1.0)
    file = tmp_path / "own.exr"
    write_exr(file, Environment("own", radiance).radiance)
    thumbnails = SceneThumbnails("environments", pictures)
    thumbnails.start()
    with qtbot.waitSignal(thumbnails.arrived, timeout=20_000):
        thumbnails.request("test", [(str(file), None)])
    image = thumbnails.picture(str(file)).toImage()
    sky, ground = image.pixelColor(64, 10), image.pixelColor(64, 120)
    assert sky.blue() > sky.red()
    assert abs(ground.blue() - ground.red()) < 40
    assert sky.blue() > ground.blue()
    thumbnails.close()


def test_a_palette_is_listed_with_its_paints(tmp_path: Path) -> None:
    file = tmp_path / "summer.brdfpalette"
    save_palette(Palette("Summer", (Entry(RED),)), file)
    (source,) = read_palette_sources(str(file))
    assert (source.title, source.group, source.content) == ("Signal red", "palette", RED)
    assert load_document(source.key) == RED
