"""What can be opened: by name and by the content of files, and the messages for what cannot."""

from __future__ import annotations

import shutil
from pathlib import Path
from threading import Event

import numpy as np
import pytest
from brdf_lobe_visualizer.subjects import sources
from brdf_lobe_visualizer.subjects.sources import MOST_AT_ONCE, MeasuredBins, names, open_source
from brdf_qt.window.dialogs import QtDialogs
from PySide6.QtCore import QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent
from PySide6.QtWidgets import QPushButton, QTreeWidgetItemIterator, QWidget

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.documents.project import Project, load_project, save_project
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.files.measured import write_measured
from brdf_suite.geometry.directions import illumination, mirror
from brdf_suite.pipeline import material
from brdf_suite.pipeline.material import file_kind
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.registry import MODELS
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
from brdf_suite.reflectance.tabulated.isotropic import Coverage, IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples
from brdf_suite.resources import resource


def only(name: str | Path):
    (subject,) = open_source(str(name)).subjects
    return subject


@pytest.fixture(scope="module")
def holed_table(tmp_path_factory) -> Path:
    """A small table of which one bin of θd in the middle was not measured."""
    grid = HalfAngleGrid(12, 12, 24)
    table = IsotropicTable.from_reflectance(Lambertian((0.4, 0.4, 0.4)), grid)
    holes = np.array(table.holes)
    holes[:, 5] = True
    path = tmp_path_factory.mktemp("tables") / "holed.brdftable"
    write_measured(IsotropicTable(table.values, holes), path)
    return path


def palette_of(count: int, path: Path) -> Path:
    entries = tuple(Entry(solid_paint(f"Grey {k}", (20.0 + k, 0.0, 0.0))) for k in range(count))
    save_palette(Palette("Greys", entries), path)
    return path


@pytest.mark.parametrize("name", ["blue", "table1_ford_f8", *MODELS])
def test_every_name_that_is_listed_can_be_opened(name: str) -> None:
    subject = only(name)
    light = illumination(45.0)
    assert np.isfinite(subject.reflectance.eval(light, mirror(light))).all()
    listed = {origin for group in names().values() for _title, origin in group}
    assert {subject.material.origin, name} <= listed


@pytest.mark.parametrize(
    ("file", "samples", "isotropic"),
    [
        ("cayman.brdf", True, True),
        ("paper_white_rgb.bsdf", False, True),
        ("retro-gray-tape.dat", True, True),
    ],
)
def test_measured_files_are_known_by_their_content(shared_data, tmp_path, file, samples, isotropic) -> None:
    renamed = tmp_path / "measured.xyz"
    shutil.copy(shared_data / "brdf" / file, renamed)
    subject = only(renamed)
    assert subject.title == "measured.xyz"
    assert (subject.samples is not None, subject.isotropic) == (samples, isotropic)
    if samples:
        assert subject.samples.wi.shape == subject.samples.values.shape
        assert any("interpolated" in note for note in subject.notes)


def test_a_paint_under_another_name_is_still_a_paint(tmp_path) -> None:
    renamed = tmp_path / "paint.json"
    shutil.copy(resource("paints", "copper.brdfpaint"), renamed)
    assert file_kind(renamed) == "paint"
    assert only(renamed).material.document.name == "Copper"


def test_a_file_that_is_removed_while_its_kind_is_looked_at_is_reported(tmp_path, monkeypatch) -> None:
    path = tmp_path / "a.csv"
    path.touch()
    with pytest.raises(FileError, match="is empty"):
        file_kind(path)
    path.unlink()
    monkeypatch.setattr(material, "is_file", lambda _text: True)  # it was there at the first look
    with pytest.raises(FileError, match="No such file"):
        file_kind(path)


def test_a_brushed_metal_is_anisotropic_and_a_table_is_not(holed_table) -> None:
    assert not only("poulin_fournier").isotropic
    assert only(holed_table).isotropic


def test_the_holes_of_a_table_are_distinguished_from_what_was_measured(holed_table) -> None:
    subject = only(holed_table)
    light = illumination(40.0)
    # θd is 45° between light and mirror direction of 45°, in bin 6 of 12 (each 7.5° wide); bin 5 is 37.5° to 45°.
    for incidence, known in ((30.0, True), (41.0, False), (50.0, True)):
        light = illumination(incidence)
        assert bool(subject.measured(light, mirror(light))) is known
    many = subject.measured(light, np.stack([mirror(light)] * 3).reshape(3, 1, 3))
    assert many.shape == (3, 1)


def test_between_the_readings_of_photographs_a_table_counts_as_measured() -> None:
    full = IsotropicTable.from_reflectance(Lambertian((0.5, 0.5, 0.5)), HalfAngleGrid(12, 12, 36))
    samples = np.zeros(full.values.shape[:3], np.float32)
    samples.reshape(-1)[::3] = 1.0
    samples[:, 9:] = 0.0
    measured = MeasuredBins(
        IsotropicTable(full.values, samples == 0.0, coverage=Coverage(samples, 0.0 * samples))
    )
    light = illumination(np.array([20.0, 30.0, 50.0, 80.0]))
    assert measured(light, mirror(light)).tolist() == [True, True, True, False]


def test_a_palette_shows_its_first_paints_and_lists_them_all(tmp_path) -> None:
    found = open_source(str(palette_of(MOST_AT_ONCE + 3, tmp_path / "greys.json")))
    assert [subject.title for subject in found.subjects] == [f"Grey {k}" for k in range(MOST_AT_ONCE)]
    assert len(found.entries) == MOST_AT_ONCE + 3
    name, origin = found.entries[-1]
    assert only(origin).title == name


@pytest.mark.parametrize("file", ["ase/nord.ase", "aco/nord.aco", "gpl/base16.gpl"])
def test_palettes_of_other_programs_are_solid_paints(shared_data, tmp_path, file) -> None:
    renamed = tmp_path / "colours"
    shutil.copy(shared_data / "palettes" / file, renamed)
    found = open_source(str(renamed))
    assert len(found.entries) > len(found.subjects) == MOST_AT_ONCE
    assert "flat colour" in found.subjects[0].notes[0]
    name, origin = found.entries[-1]
    assert only(origin).title == name


def test_what_was_assumed_of_a_palette_is_reported_apart_from_what_cannot_be_shown(
    program, opened, tmp_path
) -> None:
    path = tmp_path / "few.gpl"
    path.write_bytes(b"GIMP Palette\nName: Few\nColumns: many\n255 0 0 Zinnober\n10 20 30 Nacht\n")
    found = open_source(str(path))
    assert any("count of columns" in note for note in found.notes)
    assert (found.refused, len(found.subjects)) == ((), 2)
    opened(path)
    shown = program.window.messages.shown()
    assert [key for key in shown if "few.gpl" in key]
    message = program.window.messages.shown()[f"open {path}"]
    assert "count of columns" in message.where
    assert "cannot be shown" not in message.what


def test_nothing_and_a_narrow_lobe_are_reported(tmp_path) -> None:
    path = tmp_path / "black.brdftable"
    write_measured(IsotropicTable.from_reflectance(Lambertian((0.0, 0.0, 0.0)), HalfAngleGrid(4, 4, 8)), path)
    assert any("zero in every" in note for note in only(path).notes)
    assert not any("narrow lobe" in note for note in only("blue").notes)


@pytest.mark.parametrize(
    ("content", "place"),
    [(b"", "byte 0"), (b"this is no measurement\n", "byte 0"), (b'{"format": "brdfpaint"}', "")],
)
def test_what_cannot_be_read_is_reported_with_its_file(tmp_path, content, place) -> None:
    path = tmp_path / "odd.txt"
    path.write_bytes(content)
    with pytest.raises(FileError) as raised:
        open_source(str(path))
    assert str(path) in str(raised.value)
    assert not place or raised.value.place == place


def test_an_unknown_name_is_reported_with_the_nearest_or_the_way_to_the_list() -> None:
    with pytest.raises(SuiteError, match="did you mean copper"):
        open_source("coper")
    with pytest.raises(SuiteError, match="brdf-suite list paints"):
        open_source("no such paint")


# In the window.


def test_files_keep_the_order_in_which_they_were_asked_for(program, qtbot, shared_data) -> None:
    with qtbot.waitSignal(program.sources.idle, timeout=60_000):
        program.sources.open_many([shared_data / "brdf" / "bird_example.json", "blue", "table1_white"])
    assert [s.title for s in program.session.subjects] == ["bird_example.json", "Blue", "White"]
    assert program.session.front.title == "bird_example.json"
    lines = {(s.colour, s.dash) for s in program.session.subjects}
    assert len(lines) == 3


def test_a_file_that_cannot_be_read_leaves_what_was_shown_and_a_message(
    opened, program, qtbot, tmp_path
) -> None:
    with qtbot.waitSignal(program.sources.idle):
        program.sources.open("lambertian")
    bad = tmp_path / "bad.binary"
    bad.write_bytes(b"\0" * 64)
    with qtbot.waitSignal(program.sources.failed):
        program.sources.open(bad)
    (message,) = program.window.messages.shown().values()
    assert (message.severity, message.where) == ("error", f"Byte 0, in {tmp_path}")
    assert message.what.startswith("bad.binary: ")
    assert [s.title for s in program.session.subjects] == ["Matt"]
    assert program.window.progress.jobs == ()


def test_opened_files_are_recent_newest_first_and_can_be_forgotten(program, qtbot, tmp_path) -> None:
    paths = []
    for name in ("copper", "red"):
        paths.append(tmp_path / f"{name}.brdfpaint")
        shutil.copy(resource("paints", f"{name}.brdfpaint"), paths[-1])
    for name in (*paths, "lambertian", paths[0]):
        with qtbot.waitSignal(program.sources.idle):
            program.sources.open(name)
    assert list(program.sources.recent()) == [paths[0], paths[1]]
    texts = [action.text() for action in program.window.recent_menu.actions()]
    assert texts[:2] == ["&1 copper.brdfpaint", "&2 red.brdfpaint"]
    program.window.recent_menu.actions()[-1].trigger()
    assert program.sources.recent() == []
    assert not program.window.recent_menu.isEnabled()


def test_files_that_are_dropped_or_asked_for_are_opened(program, asked, qtbot, tmp_path) -> None:
    paths = []
    for name in ("copper", "red"):
        paths.append(tmp_path / f"{name}.brdfpaint")
        shutil.copy(resource("paints", f"{name}.brdfpaint"), paths[-1])
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    drop = QDropEvent(
        QPointF(10, 10),
        Qt.DropAction.CopyAction,
        data,
        Qt.MouseButton.LeftButton,
        Qt.KeyboardModifier.NoModifier,
    )
    with qtbot.waitSignal(program.sources.idle):
        program.window.dropEvent(drop)
    assert [s.title for s in program.session.subjects] == ["Copper", "Red"]
    asked.files = [str(paths[0])]
    with qtbot.waitSignal(program.sources.idle):
        program.window.open_requested.emit(None)
    assert [s.title for s in program.session.subjects] == ["Copper", "Red", "Copper"]


def test_the_list_finds_by_words_and_opens_on_enter(program, qtbot) -> None:
    program.show_list()
    panel = program.panel
    panel.query.setText("polaris")
    with qtbot.waitSignal(program.sources.idle):
        qtbot.keyClick(panel.query, Qt.Key.Key_Return)
    assert [s.title for s in program.session.subjects] == ["Polaris Silver"]
    panel.query.setText("no such thing")
    assert panel.no_match.isVisible()
    program.panel_dock.hide()


def test_the_list_shows_a_picture_of_each_paint(program, qtbot) -> None:
    """Its colour as soon as the paint is read; a model, which is no paint, stays grey."""
    program.start()
    program.show_list()
    tree = program.panel.tree

    def middle(key: str) -> tuple[int, int, int]:
        every = QTreeWidgetItemIterator(tree)
        while (item := every.value()).data(0, Qt.ItemDataRole.UserRole) != key:
            every += 1
        image = item.icon(0).pixmap(64, 64).toImage()
        colour = image.pixelColor(image.width() // 2, image.height() // 2)
        return colour.red(), colour.green(), colour.blue()

    program.panel.query.setText("burnt")
    qtbot.waitUntil(lambda: middle("burnt_orange")[0] > 2 * middle("burnt_orange")[2])
    program.panel.query.setText("lambertian")
    red, green, blue = middle("lambertian")
    assert red == green == blue
    program.panel.query.clear()
    program.panel_dock.hide()


def test_a_palette_stands_in_the_list_and_says_how_much_of_it_is_shown(program, qtbot, tmp_path) -> None:
    path = palette_of(MOST_AT_ONCE + 2, tmp_path / "greys.brdfpalette")
    with qtbot.waitSignal(program.sources.idle):
        program.sources.open(path)
    assert len(program.session.subjects) == MOST_AT_ONCE
    message = program.window.messages.shown()[f"open {path}"]
    assert f"has {MOST_AT_ONCE + 2} paints" in message.what
    groups = [program.panel.tree.topLevelItem(k) for k in range(program.panel.tree.topLevelItemCount())]
    greys = next(group for group in groups if group.text(0) == "Greys")
    assert greys.childCount() == MOST_AT_ONCE + 2


def test_reading_that_lasts_is_shown_and_can_be_cancelled(program, qtbot, monkeypatch) -> None:
    going, ended = Event(), Event()

    def slow(_name, progress):
        try:
            while not going.wait(0.01):
                progress(0.5, "reading")
        finally:
            ended.set()

    monkeypatch.setattr(sources, "open_source", slow)
    job = program.sources.open("slow.binary")
    strip = program.window.progress
    qtbot.waitUntil(lambda: job in strip.jobs)
    with qtbot.waitSignal(program.sources.failed):
        strip.findChild(QWidget, f"job_{job}").findChild(QPushButton).click()
    assert strip.jobs == ()
    assert program.sources.is_idle
    qtbot.waitUntil(ended.is_set)
    assert program.window.messages.shown() == {}
    assert program.session.subjects == ()


def test_every_kind_of_material_is_opened(materials) -> None:
    light = illumination(45.0)
    for asked in materials.values():
        assert np.isfinite(open_source(asked).subjects[0].reflectance.eval(light, light)).all(), asked


def test_the_representations_of_the_selected_reflectance_have_rows_of_their_own(opened, qtbot) -> None:
    program = opened("lambertian")
    front = program.session.front
    program.add_representations()
    qtbot.waitUntil(lambda: program.sources.is_idle, timeout=60_000)
    first, *rows = program.session.subjects
    assert first is program.session.subject(front.key)
    assert [one.title for one in rows] == [
        f"{first.title}: {kind}" for kind in ("cosine lobes", "Cook-Torrance lobes", "homomorphic factors")
    ]
    light, view = illumination(45.0), illumination(20.0)
    for one in rows:
        assert one.material.name == one.title
        assert np.allclose(one.reflectance.eval(light, view), first.reflectance.eval(light, view), rtol=0.05)


def test_a_reflectance_that_cannot_be_represented_is_named(opened, qtbot, tmp_path) -> None:
    path = tmp_path / "few.brdftable"
    light = np.tile(illumination(45.0), (12, 1))
    values = np.full((12, 3), 0.2)
    write_measured(ScatteredSamples(light, light, values), path)
    program = opened(path)
    program.add_representations()
    qtbot.waitUntil(lambda: program.is_idle, timeout=60_000)
    assert len(program.session.subjects) == 1
    assert any("12 samples" in str(message) for message in program.window.messages.shown().values())


def test_a_project_is_opened_by_its_paints_and_its_source(program, holed_table, tmp_path, qtbot) -> None:
    path = tmp_path / "spring.brdfproject"
    save_project(Project("Spring", (solid_paint("Sea", (30.0, 0.0, -30.0)),), source=str(holed_table)), path)
    with qtbot.waitSignal(program.sources.idle, timeout=60_000):
        program.window.open_requested.emit(path)
    qtbot.waitUntil(lambda: len(program.session.subjects) == 2, timeout=60_000)
    assert program.session.subjects[0].title == "Sea"


def test_a_saved_project_has_the_paints_that_were_added(
    program, holed_table, tmp_path, qtbot, monkeypatch
) -> None:
    path = tmp_path / "spring.brdfproject"
    sea = solid_paint("Sea", (30.0, 0.0, -30.0))
    save_project(Project("Spring", (sea,), source=str(holed_table), notes="Kept"), path)
    program.window.open_requested.emit(path)
    program.sources.open("copper")
    qtbot.waitUntil(lambda: len(program.session.subjects) == 3, timeout=60_000)
    monkeypatch.setattr(QtDialogs, "save_path", lambda *_asked: path)
    with qtbot.waitSignal(program.projects.saved):
        program.window.command("save_project").trigger()
    found = load_project(path)
    assert [one.name for one in found.paints] == ["Sea", "Copper"]
    assert (found.paints[0], found.source, found.notes) == (sea, str(holed_table), "Kept")
