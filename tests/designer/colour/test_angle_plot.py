"""L*, C* and h over the angle: points that are dragged or moved by keys, curves with units, hues that run on."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pyqtgraph as pg
import pytest
from brdf_designer.colour.angle_plot import AnglePlot
from brdf_designer.session.state import colours_of, curves_of
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from brdf_suite.appearance.colour.spaces import lab_to_lch, lch_to_lab
from brdf_suite.documents.paint import Gloss, Lab, Measurement, Paint
from brdf_suite.pipeline.lobe_fit import PaintFitter

LABS = ((62.0, -4.0, -45.0), (25.0, 4.0, -38.0), (9.0, 8.0, -28.0))


def paint(*labs: Lab) -> Paint:
    readings = tuple(Measurement(45.0, a, lab) for a, lab in zip((15.0, 45.0, 110.0), labs, strict=True))
    return Paint("Shown", readings, Gloss(90.0))


@pytest.fixture(scope="module")
def fitter():
    made = PaintFitter(time_limit_s=60.0)
    yield made
    made.close()


@pytest.fixture
def plot(qtbot, fitter) -> AnglePlot:
    made = AnglePlot()
    qtbot.addWidget(made)
    made.resize(500, 420)
    made.build()
    show(made, paint(*LABS), fitter)
    made.show()
    return made


def show(plot: AnglePlot, shown: Paint, fitter: PaintFitter) -> None:
    plot.show_colours(colours_of(shown))
    plot.show_curves(curves_of(fitter.fit(shown)))
    plot.draw_now()


def ys(plot: AnglePlot, component: int) -> list[float]:
    return [point.pos().y() for point in plot.plots[component].points]


def test_each_plot_has_its_points_two_lines_and_units(plot: AnglePlot) -> None:
    lch = lab_to_lch(LABS)
    for component, unit in enumerate(("L*", "C*", "°")):
        shown = plot.plots[component]
        assert ys(plot, component) == pytest.approx(lch[:, component], abs=1e-6)
        assert unit in shown.plot.getAxis("left").labelText
        (gamma, model), (_, fitted) = (line.getData() for line in shown.plot.listDataItems())
        # Both lines pass through what is asked at every reading of a paint that can be.
        for angle, value in zip((15.0, 45.0, 110.0), lch[:, component], strict=True):
            at = int(np.argmin(np.abs(gamma - angle)))
            assert model[at] == pytest.approx(value, abs=0.05)
            assert fitted[at] == pytest.approx(value, abs=0.3)
    assert "degrees" in plot.plots[2].plot.getAxis("bottom").labelText


class Drag:
    """A drag of a point as pyqtgraph reports it; the names are those of its event."""

    def __init__(self, point, x: float, y: float, *, start: bool = False, finish: bool = False) -> None:
        self._point, self._at, self._start, self._finish = point, QPointF(x, y), start, finish
        self._origin = point.pos()

    def button(self):
        return Qt.MouseButton.LeftButton

    def accept(self) -> None:
        pass

    def pos(self):
        return self._point.mapFromParent(self._at)

    def buttonDownPos(self):  # noqa: N802
        return self._point.mapFromParent(self._origin)

    def isStart(self) -> bool:  # noqa: N802
        return self._start

    def isFinish(self) -> bool:  # noqa: N802
        return self._finish


@pytest.mark.parametrize("component", [0, 1, 2])
def test_a_point_is_dragged_up_and_down(plot: AnglePlot, qtbot, component: int) -> None:
    reported: list[tuple] = []
    plot.drag_started.connect(lambda *what: reported.append(("start", *what)))
    plot.edited.connect(lambda *what: reported.append(what))
    plot.drag_finished.connect(lambda: reported.append(("end",)))
    point = plot.plots[component].points[1]
    y = point.pos().y()
    assert point.cursor().shape() == Qt.CursorShape.OpenHandCursor
    point.mouseDragEvent(Drag(point, 60.0, y + 1.0, start=True))
    assert point.cursor().shape() == Qt.CursorShape.ClosedHandCursor
    point.mouseDragEvent(Drag(point, 60.0, y + 8.0, finish=True))
    assert reported[0] == ("start", 1, component)
    assert reported[-1] == ("end",)
    assert reported[-2][:2] == (1, component)
    assert reported[-2][2] > y


def test_points_are_moved_by_keys(plot: AnglePlot, qtbot) -> None:
    reported: list[tuple] = []
    plot.edited.connect(lambda *what: reported.append(what))
    ends: list[str] = []
    plot.drag_started.connect(lambda index, c: ends.append(f"start {index} {c}"))
    plot.drag_finished.connect(lambda: ends.append("end"))
    chroma = plot.plots[1]
    chroma.setFocus()
    QApplication.processEvents()
    QTest.keyClick(chroma, Qt.Key.Key_Right)
    assert "45°" in chroma.accessibleDescription()
    before = ys(plot, 1)[1]
    QTest.keyClick(chroma, Qt.Key.Key_Up)
    QTest.keyClick(chroma, Qt.Key.Key_Down, Qt.KeyboardModifier.ShiftModifier)
    assert reported == [
        (1, 1, pytest.approx(before + 0.5, abs=0.01)),
        (1, 1, pytest.approx(before - 0.1, abs=0.01)),
    ]
    QTest.keyClick(chroma, Qt.Key.Key_Left)
    assert ends == ["start 1 1", "end"], "the keys on one point are one step"
    # Chroma does not fall below 0.
    QTest.keyClick(chroma, Qt.Key.Key_PageDown)
    assert reported[-1][2] >= 0.0


def test_hues_run_on_over_the_end_of_the_circle(plot: AnglePlot, fitter) -> None:
    hues = (350.0, 2.0, 14.0)
    labs = [
        tuple(map(float, lch_to_lab([light, 20.0, hue])))
        for light, hue in zip((60, 40, 30), hues, strict=True)
    ]
    show(plot, paint(*labs), fitter)
    assert ys(plot, 2) == pytest.approx([350.0, 362.0, 374.0], abs=1e-6)
    _, model = plot.plots[2].plot.listDataItems()[0].getData()
    measured = model[15:]
    assert np.abs(np.diff(measured[np.isfinite(measured)])).max() < 20.0, "no jump"
    low, high = plot.plots[2].plot.viewRange()[1]
    assert low < 350.0
    assert high > 374.0
    axis = plot.plots[2].plot.getAxis("left")
    assert axis.tickStrings([350.0, 370.0], 1.0, 10.0) == ["350", "10"]


def test_a_grey_has_no_point_in_the_plot_of_hues(plot: AnglePlot, fitter) -> None:
    show(plot, paint(LABS[0], (25.0, 0.0, 0.0), LABS[2]), fitter)
    assert [point.isVisible() for point in plot.plots[2].points] == [True, False, True]
    assert all(point.isVisible() for point in plot.plots[1].points)


def test_a_reading_beyond_the_mirror_direction_is_in_sight(plot: AnglePlot, fitter) -> None:
    shown = paint(*LABS)
    beyond = replace(shown, measurements=(Measurement(45.0, -15.0, LABS[0]), *shown.measurements))
    show(plot, beyond, fitter)
    assert len(plot.plots[0].points) == 4
    assert plot.plots[0].plot.viewRange()[0][0] < -15.0


def test_plots_are_shown_and_hidden_and_one_always_stays(plot: AnglePlot, fitter) -> None:
    plot.buttons[1].click()
    assert [shown.isVisible() for shown in plot.plots] == [True, False, True]
    show(plot, paint((70.0, 30.0, 0.0), *LABS[1:]), fitter)
    plot.buttons[1].click()
    assert ys(plot, 1)[0] == pytest.approx(30.0), "brought up to date when it is shown again"
    for button in plot.buttons:
        button.click()
    assert sum(shown.isVisible() for shown in plot.plots) == 1


def test_in_a_low_window_the_buttons_are_tabs(plot: AnglePlot, fitter) -> None:
    plot.resize(500, 130)
    assert [shown.isVisible() for shown in plot.plots] == [True, False, False]
    assert [button.isChecked() for button in plot.buttons] == [True, False, False]
    plot.buttons[2].click()
    assert [shown.isVisible() for shown in plot.plots] == [False, False, True]
    assert [button.isChecked() for button in plot.buttons] == [False, False, True]
    plot.buttons[2].click()
    assert plot.plots[2].isVisible(), "one always stays"
    assert "degrees" in plot.plots[2].plot.getAxis("bottom").labelText
    show(plot, paint((70.0, 30.0, 0.0), *LABS[1:]), fitter)
    plot.resize(500, 600)
    assert all(shown.isVisible() for shown in plot.plots)
    assert ys(plot, 1)[0] == pytest.approx(30.0), "brought up to date when there is room again"


def test_points_of_a_grey_are_seen_whole_at_no_chroma(plot: AnglePlot, fitter) -> None:
    assert plot.plots[1].plot.viewRange()[1][0] == 0.0
    show(plot, paint((50.0, 0.0, 0.0), (50.0, 0.0, 0.0), (50.0, 0.0, 0.0)), fitter)
    low, high = plot.plots[1].plot.viewRange()[1]
    assert low < -0.05 * high
    (note,) = (item for item in plot.plots[2].plot.getPlotItem().items if isinstance(item, pg.TextItem))
    assert note.isVisible()
    assert note.toPlainText() == "A grey has no hue."
    show(plot, paint(*LABS), fitter)
    assert not note.isVisible()
