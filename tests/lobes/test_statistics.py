"""The panel of figures: worked out when it is looked at, copied, exported; the plot of the albedo."""

from __future__ import annotations

import csv

import numpy as np
import pytest
from brdf_lobe_visualizer.statistics.panel import Column
from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QIcon
from PySide6.QtTest import QTest

from brdf_suite.inspection.figures.text import FigureRow
from brdf_suite.pipeline.material import Material
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.registry import MODELS


@pytest.fixture
def two(program, qtbot, monkeypatch):
    """Two matt reflectances, and the panel Numbers with their figures."""
    monkeypatch.setattr(program.fits, "_fit", lambda _subject: None)
    program.numbers.choose_group("overview")
    program.sources.add(PlottedMaterial("", "Grey", Material("Grey", Lambertian((0.5, 0.5, 0.5)))))
    program.sources.add(PlottedMaterial("", "Red", Material("Red", Lambertian((0.6, 0.1, 0.1)))))
    program.numbers.dock.show()
    wait(program, qtbot)
    return program


def wait(program, qtbot) -> None:
    qtbot.waitUntil(lambda: program.numbers.is_idle and _fresh(program), timeout=30_000)


def _fresh(program) -> bool:
    return not any(program.numbers.work.is_stale(s.key) for s in program.session.visible)


def shown(program) -> dict[str, list[str]]:
    model = program.numbers.panel.table.figures
    return {
        model.text(row, 0): [model.text(row, column) for column in range(1, model.columnCount())]
        for row in range(model.rowCount())
    }


def header(program) -> list[str]:
    model = program.numbers.panel.table.figures
    return [model.headerData(k, Qt.Orientation.Horizontal) for k in range(model.columnCount())]


def test_the_table_has_a_column_for_each_that_is_visible(two, qtbot) -> None:
    assert header(two) == ["Figure", "Grey", "Red"]
    grey, red = (float(text) for text in shown(two)["hemispherical albedo, red"])
    assert (grey, red) == (pytest.approx(0.5, abs=1e-3), pytest.approx(0.6, abs=1e-3))
    two.session.set_hidden(two.session.subjects[0].key, True)
    wait(two, qtbot)
    assert header(two) == ["Figure", "Red"]


def test_each_group_has_its_rows_and_the_angles_are_chosen(two, qtbot) -> None:
    two.numbers.choose_group("colours")
    two.numbers.choose_angles("e2194")
    wait(two, qtbot)
    rows = shown(two)
    assert {"L* 45as15", "L* 45as45", "L* 45as110"} <= set(rows)
    assert "L* 45as25" not in rows
    assert float(rows["L* 45as15"][0]) == pytest.approx(76.07, abs=0.01)
    two.numbers.choose_group("albedo")
    assert "albedo at 60°, blue" in shown(two)
    two.numbers.choose_angles("six")


def test_errors_come_with_a_reference(two, qtbot) -> None:
    two.numbers.choose_group("errors")
    assert shown(two) == {}
    assert "reference" in two.numbers.panel.note.text()
    two.session.set_reference(two.session.subjects[0].key)
    wait(two, qtbot)
    reference, other = shown(two)["difference, relative root mean square"]
    assert (reference, float(other) > 0.3) == ("–", True)


def test_figures_follow_a_subject_that_changes_and_are_stale_until_then(two, qtbot) -> None:
    key = two.session.subjects[0].key
    two.session.change(key, material=Material("Grey", Lambertian((0.9, 0.9, 0.9))))
    assert two.numbers.work.is_stale(key)
    wait(two, qtbot)
    assert float(shown(two)["hemispherical albedo, red"][0]) == pytest.approx(0.9, abs=2e-3)


def test_nothing_is_worked_out_while_nobody_looks(two) -> None:
    two.numbers.dock.hide()
    before = two.numbers.work.figures(two.session.subjects[0].key)
    two.session.change(two.session.subjects[0].key, material=Material("Grey", Lambertian((0.1, 0.1, 0.1))))
    assert two.numbers.is_idle
    assert two.numbers.work.figures(two.session.subjects[0].key) is before


def test_only_an_anisotropic_one_is_worked_out_anew_where_the_azimuth_turns(two, qtbot) -> None:
    grey = two.numbers.work.figures(two.session.subjects[0].key)
    two.session.set_incidence(45.0, 90.0)
    wait(two, qtbot)
    assert two.numbers.work.figures(two.session.subjects[0].key) is grey
    metal = MODELS["poulin_fournier"].default
    wanted = [
        two.numbers.work.inputs_of(
            PlottedMaterial("m", "Metal", Material("Metal", metal), isotropic=isotropic)
        )
        for isotropic in (False, True)
    ]
    assert [w.azimuth_deg for w in wanted] == [90.0, 0.0]


def test_the_table_and_its_cells_are_copied_as_text(two) -> None:
    two.numbers.copy()
    lines = [line.split("\t") for line in QGuiApplication.clipboard().text().splitlines()]
    assert lines[0] == ["", "unit", "Grey", "Red"]
    copied = {line[0]: line[2:] for line in lines[1:]}["hemispherical albedo, red"]
    assert [float(text) for text in copied] == pytest.approx([0.5, 0.6], abs=1e-3)
    table = two.numbers.panel.table
    table.setCurrentIndex(table.figures.index(0, 1))
    table.copy_selected()
    assert QGuiApplication.clipboard().text() == table.figures.text(0, 1)


def test_what_is_copied_is_no_formula_and_stays_in_its_cell(two) -> None:
    first = two.session.subjects[0]
    two.session.change(first.key, title="=1+1\tgrey\n2")
    two.numbers.copy()
    lines = [line.split("\t") for line in QGuiApplication.clipboard().text().splitlines()]
    assert lines[0] == ["", "unit", "'=1+1 grey 2", "Red"]
    assert {len(line) for line in lines} == {4}
    table = two.numbers.panel.table
    rows = (FigureRow("overview", "@SUM(1)", "", (-0.5,)), FigureRow("overview", "-1+1", "", (None,)))
    table.figures.show([Column("Grey", QIcon(), stale=False)], rows)
    table.selectAll()
    QTest.keyClick(table, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    assert QGuiApplication.clipboard().text() == "'@SUM(1)\t−0.5\n'-1+1\t–"


def test_all_figures_are_exported(two, asked, tmp_path) -> None:
    asked.path = tmp_path / "out.csv"
    two.numbers.export()
    with asked.path.open(encoding="utf-8", newline="") as stream:
        rows = list(csv.reader(stream))
    assert rows[0] == ["figure", "unit", "Grey", "Red"]
    assert any(row[0].startswith("L*") for row in rows)
    assert str(asked.path) in two.window.messages.shown()["figures"].what
    asked.path = tmp_path / "no such folder" / "out.csv"
    two.numbers.export()
    assert two.window.messages.shown()["figures"].severity == "error"


def test_without_figures_the_export_says_how_to_get_some(program) -> None:
    program.numbers.export()
    assert "F5" in program.window.messages.shown()["figures"].todo


def test_the_plot_draws_the_albedo_of_each_that_is_visible(two, qtbot) -> None:
    plots = two.window.plots
    plots.set_shown("albedo", True)
    plot = two.numbers.plot
    qtbot.waitUntil(lambda: len(plot.lines) == 2 and plot.plot is not None)
    np.testing.assert_allclose(plot.lines[0].albedo, 0.5, atol=2e-3)
    assert [line.front for line in plot.lines] == [True, False]
    drawn = plot.curves[0].getData()
    np.testing.assert_allclose(drawn[1], plot.lines[0].albedo)
    two.session.set_subjects(())
    qtbot.waitUntil(lambda: plot.lines == ())
    assert plot.empty.isVisible()
    plots.set_shown("albedo", False)
