"""The slices in the real window: lines where ``eval`` has them, readouts, holes, differences, CSV."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import numpy as np
import pytest
from brdf_lobe_visualizer.cuts.panel import HALF_ANGLE, POLAR, UNROLLED
from brdf_lobe_visualizer.cuts.pens import colour_of
from brdf_lobe_visualizer.cuts.section import SliceOptions, SliceState
from brdf_lobe_visualizer.subjects.subjects import DASHES, LINE_COLOURS, PlottedMaterial, SamplePoints
from pyqtgraph import TextItem
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QColor, QGuiApplication, QMouseEvent, QPalette
from PySide6.QtWidgets import QApplication

from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.geometry.directions import illumination, mirror, spherical
from brdf_suite.inspection.slices.cuts import light_at, view_at
from brdf_suite.pipeline.lobe_fit import LobeFit
from brdf_suite.pipeline.material import Material
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.models.poulin_fournier import PoulinFournier


class Spike:
    """Exponent 10⁵ about the mirror direction, 10,000 high."""

    def eval(self, wi, wo):
        dot = np.einsum("...i,...i", mirror(wi), wo)
        return np.repeat((1e4 * np.maximum(dot, 0.0) ** 1e5)[..., None], 3, axis=-1)


class Zero:
    def eval(self, wi, wo):
        return np.zeros(np.broadcast_shapes(wi.shape, wo.shape))


class Nothing:
    def eval(self, wi, wo):
        return np.full(np.broadcast_shapes(wi.shape, wo.shape), np.nan)


def fit_of(kd: float) -> LobeFit:
    zero = np.zeros((1, 3))
    return LobeFit(
        Material("fit", LobeWeights(np.array([9.0]), np.full(3, kd), zero, zero, np.pi / 4.0, 1.0)),
        "measured",
        LobeWeights(np.array([9.0]), np.full(3, kd), zero, zero, np.pi / 4.0, 1.0),
        {},
        (),
        0.0,
    )


def subject(key: str, reflectance: object, number: int = 0, **more: object) -> PlottedMaterial:
    return PlottedMaterial(
        key, key, Material(key, reflectance), LINE_COLOURS[number], DASHES[number % len(DASHES)], **more
    )


@pytest.fixture
def session(slices, window_with_slices):
    return window_with_slices.session


def hover(plot, x: float, y: float) -> None:
    """Move the mouse over a place of a plot's numbers."""
    box = plot.getPlotItem().vb
    place = QPointF(plot.mapFromScene(box.mapViewToScene(QPointF(x, y))))
    move(plot.viewport(), place)


def move(widget, place: QPointF) -> None:
    none = Qt.MouseButton.NoButton
    event = QMouseEvent(
        QEvent.Type.MouseMove, place, widget.mapToGlobal(place), none, none, Qt.KeyboardModifier.NoModifier
    )
    QApplication.sendEvent(widget, event)


def line(lines, key: str, kind: str = "target"):
    return next(one for one in lines.lines if (one.key, one.kind) == (key, kind))


def test_the_lines_are_eval_at_those_directions(slices, session, qtbot) -> None:
    paint = PoulinFournier(kd=0.3)
    session.add(subject("metal", paint))
    session.set_options(cosine="light", channel="g")
    session.set_incidence(35.0, 70.0)
    qtbot.waitUntil(lambda: slices.is_idle)
    wanted = paint.eval(light_at(35.0, 70.0), view_at(20.0, 70.0))[1] * np.cos(np.radians(35.0))
    polar, curves = slices.polar.lines, slices.curves.lines
    assert np.interp(20.0, polar.cut.angle_deg, line(polar, "metal").value) == pytest.approx(wanted, rel=1e-2)
    assert np.interp(15.0, curves.cut.angle_deg, line(curves, "metal").value) == pytest.approx(
        wanted, rel=1e-2
    )
    session.set_incidence(35.0, 0.0)  # the azimuth matters
    qtbot.waitUntil(lambda: slices.is_idle)
    other = np.interp(20.0, slices.polar.lines.cut.angle_deg, line(slices.polar.lines, "metal").value)
    assert abs(other - wanted) > 0.01 * wanted


def redness(colour: QColor) -> int:
    return colour.red() - colour.green()


def test_the_lobe_is_drawn_where_the_mirror_direction_is(slices, session, qtbot) -> None:
    session.add(subject("spike", Spike(), 3))
    for theta, to_right in ((50.0, True), (0.0, None)):
        session.set_incidence(theta, 0.0)
        qtbot.waitUntil(lambda: slices.is_idle)
        plot = slices.polar.plot
        for item in plot.getPlotItem().items:
            if isinstance(item, TextItem):  # the edges of letters may have any colour
                item.hide()
        picture = plot.grab().toImage()
        colour = colour_of(LINE_COLOURS[3], slices.polar.palette().color(QPalette.ColorRole.Base))
        pixels = [(x, y) for x in range(picture.width()) for y in range(picture.height())]
        near = [
            at
            for at in pixels
            # The lines of the scale are grey, whatever the palette: the spike has a colour.
            if 2 * redness(picture.pixelColor(*at)) > redness(colour)
        ]
        ratio = picture.devicePixelRatio()
        box = plot.getPlotItem().vb
        spots = [
            box.mapSceneToView(plot.mapToScene(QPointF(x / ratio, y / ratio).toPoint())) for x, y in near
        ]
        assert spots, "the spike is not drawn"
        at = max(spots, key=lambda spot: np.hypot(spot.x(), spot.y()))
        assert np.degrees(np.arctan2(at.x(), at.y())) == pytest.approx(theta, abs=2.0)
        assert (at.x() > 0.3) is (to_right is True)


def test_curves_know_their_axes_logs_and_marks(slices, session, qtbot) -> None:
    session.add(subject("spike", Spike()))
    for axis in ("gamma", "theta_o", "theta_h", "theta_d"):
        slices.curves.axis_buttons[axis].click()
        qtbot.waitUntil(lambda: slices.is_idle)
        assert slices.curves.lines.cut.axis == axis
        assert slices.curves.plot.getAxis("bottom").labelText.split(" ")[-1] == "(°)"
        peak = slices.curves.lines.cut.angle_deg[np.nanargmax(line(slices.curves.lines, "spike").value)]
        assert peak == pytest.approx(
            {"gamma": 0.0, "theta_o": 45.0, "theta_h": 0.0}.get(axis, peak), abs=1e-9
        )
    slices.curves.axis_buttons["theta_h"].click()
    slices.curves.log_angle.click()
    assert slices.curves.logs == (True, True)
    qtbot.waitUntil(lambda: slices.is_idle)
    (low, high), (bottom, top) = slices.curves.plot.viewRange()
    assert (low, high) == pytest.approx((-2.0, np.log10(90.0)))
    assert top >= 4.0 + np.log10(np.cos(np.radians(45.0))) - 1e-6
    assert bottom == pytest.approx(top - 7.0)
    slices.curves.log_value.click()
    qtbot.waitUntil(lambda: slices.is_idle)
    assert slices.curves.plot.viewRange()[1][0] == 0.0


def test_numbers_of_a_logarithmic_axis_keep_apart(slices, session, qtbot) -> None:
    session.add(subject("one", Lambertian(0.5)))
    qtbot.waitUntil(lambda: slices.is_idle)
    axis = slices.curves.plot.getAxis("left")
    axis.setLogMode(y=True)
    ticks = np.log10(np.arange(1, 10) * 0.1)
    axis.setRange(-2.0, 0.0)
    assert [word for word in axis.logTickStrings(ticks, 1.0, None) if word] == ["0.1", "0.2", "0.5"]
    axis.setRange(-0.5, 0.0)
    assert all(axis.logTickStrings(ticks, 1.0, None))


def test_the_crosshair_shows_every_visible_value_with_its_unit(slices, session, qtbot) -> None:
    session.add(subject("bright", Lambertian(0.8), 0))
    session.add(subject("dark <b>", Lambertian(0.2), 1))
    session.set_options(cosine="none")
    slices.state.set(log_value=False)
    qtbot.waitUntil(lambda: slices.is_idle)
    hover(slices.curves.plot, 30.0, 0.1)
    shown_text = slices.curves.readout.text()
    assert slices.curves.readout.isVisible()
    # The line has an angle every 1.5°, the mouse a whole pixel.
    assert any(f"γ {angle}." in shown_text for angle in (28, 29, 30, 31))
    for words in ("bright", "0.2546", "dark &lt;b&gt;", "0.06366", "(1/sr)"):
        assert words in shown_text, shown_text
    session.set_hidden("bright", True)
    qtbot.waitUntil(lambda: slices.is_idle)
    hover(slices.polar.plot, 0.3, 0.5)
    assert "bright" not in slices.polar.readout.text()
    assert "θo 3" in slices.polar.readout.text()
    QApplication.sendEvent(slices.polar.plot, QEvent(QEvent.Type.Leave))
    assert not slices.polar.readout.isVisible()


def test_target_fit_and_difference(slices, session, qtbot) -> None:
    session.add(subject("one", Lambertian(0.5), fit=fit_of(0.1)))
    session.add(subject("two", Lambertian(0.2), 1))
    session.set_options(cosine="none", shown="both")
    qtbot.waitUntil(lambda: slices.is_idle)
    lines = slices.curves.lines
    assert {(one.key, one.kind) for one in lines.lines} == {
        ("one", "target"),
        ("one", "fit"),
        ("two", "target"),
    }
    assert lines.errors["one"].rms == pytest.approx(0.5 / np.pi - 0.1)
    assert "Fit: RMS " in slices.curves.note.text()
    assert "one: RMS " in slices.curves.note.toolTip()
    session.set_options(shown="difference")
    qtbot.waitUntil(lambda: slices.is_idle)
    assert [(one.key, one.kind) for one in slices.curves.lines.lines] == [("one", "difference")]
    assert np.nanmax(line(slices.curves.lines, "one", "difference").value) == pytest.approx(0.1 - 0.5 / np.pi)
    session.set_reference("two")
    qtbot.waitUntil(lambda: slices.is_idle)
    against = line(slices.curves.lines, "one", "difference").value
    assert np.nanmax(np.abs(against - 0.3 / np.pi)) < 1e-12
    low, high = slices.curves.plot.viewRange()[1]
    assert low == -high
    # A lobe that is switched off is missing in the fit.
    session.set_options(shown="fit", lobes_off=frozenset({("diffuse", 0)}))
    qtbot.waitUntil(lambda: slices.is_idle)
    assert np.nanmax(line(slices.curves.lines, "one", "fit").value) == 0.0


def test_zero_nothing_and_holes_are_reported_and_no_exception(slices, session, qtbot) -> None:
    def measured(wi, wo):
        return np.asarray(np.broadcast_arrays(wi, wo)[1][..., 0] < 0.5)

    session.add(subject("holes", Lambertian(0.5), measured=measured))
    session.add(subject("zero", Zero(), 1))
    session.add(subject("nothing", Nothing(), 2))
    for key in (UNROLLED, HALF_ANGLE):
        slices.window.plots.set_shown(key, True)
    session.set_options(shown="both")
    qtbot.waitUntil(lambda: slices.is_idle)
    note = slices.curves.note.text()
    for words in ("hatched: not measured", "zero: 0 everywhere", "nothing: no values here"):
        assert words in note
    assert slices.curves.bands.isVisible()
    holes = slices.unrolled.grid.pictures[0, 0].holes
    assert holes[:, -1].all()
    assert not holes[:, 0].any()
    for key in ("zero", "nothing"):
        session.set_front(key)
        qtbot.waitUntil(lambda: slices.is_idle)
        slices.unrolled.grab()
    session.set_subjects(())
    qtbot.waitUntil(lambda: slices.is_idle)
    assert not slices.polar.plot.isVisible()
    assert slices.polar.empty.isVisible()
    assert slices.unrolled.empty.isVisible()


def test_a_model_that_fails_is_reported_and_the_others_are_drawn(slices, session, qtbot) -> None:
    class Broken:
        def eval(self, wi, wo):
            raise ZeroDivisionError("nothing to divide by")

    session.add(subject("broken", Broken()))
    session.add(subject("matt", Lambertian(0.5), 1))
    qtbot.waitUntil(lambda: slices.is_idle)
    assert "slices broken target" in slices.window.messages.shown()
    for plot in (slices.polar, slices.curves):
        assert np.isnan(line(plot.lines, "broken").value).all()
        assert np.isfinite(line(plot.lines, "matt").value).any()
    assert "broken: no values" in slices.curves.note.text()
    for key in list(slices.window.messages.shown()):
        slices.window.dismiss_message(key)


def test_samples_lie_on_the_line(slices, session, qtbot) -> None:
    matt = Lambertian(0.5)
    wi = illumination(np.array([45.0, 45.5, 10.0, 45.0]))
    wo = spherical(np.radians([30.0, 50.0, 20.0, 30.0]), np.radians([0.0, 180.0, 0.0, 60.0]))
    points = SamplePoints(wi, wo, matt.eval(wi, wo))
    session.add(subject("points", matt, samples=points))
    session.set_options(cosine="none")
    qtbot.waitUntil(lambda: slices.is_idle)
    found = slices.curves.lines.points["points"]
    assert np.sort(found.angle_deg) == pytest.approx(
        [15.0, 95.5]
    )  # the others are out of the plane or the light
    assert found.value == pytest.approx(0.5 / np.pi)
    slices.window.plots.set_shown(UNROLLED, True)
    slices.state.set(incidences_deg=(10.0, 45.0, 70.0))
    qtbot.waitUntil(lambda: slices.is_idle)
    shown = [slices.unrolled.grid.pictures[0, column].points for column in range(3)]
    # One light of 10°; three of 45°, and none of 70°; swapped pairs count where their light fits.
    assert [len(points) for points in shown] == [1, 3, 0]


def test_curves_are_copied_as_numbers(slices, session, qtbot, tmp_path: Path) -> None:
    session.add(subject("matt, grey", Lambertian(0.5)))
    session.set_options(cosine="none")
    slices.copy_curves()
    text = QGuiApplication.clipboard().text()
    rows = list(csv.reader(io.StringIO(text)))
    assert rows[0] == ["Aspecular angle γ (°)", "matt, grey: Y  f_r (1/sr)"]
    assert text.splitlines()[1] == "# Lobe Visualizer, incidence 45°, azimuth 0°"
    values = np.array(rows[2:], float)
    assert np.array_equal(values[:, 0], np.sort(values[:, 0]))
    assert values[:, 1] == pytest.approx(0.5 / np.pi)
    path = tmp_path / "curves.csv"
    slices.save_curves(path)
    assert path.read_text() == text
    slices.save_curves(tmp_path / "no folder" / "curves.csv")
    assert "curves" in slices.window.messages.shown()


def test_hidden_plots_are_drawn_when_they_are_shown(slices, session, qtbot) -> None:
    plots = slices.window.plots
    plots.set_shown(POLAR, False)
    session.add(subject("one", Lambertian(0.5)))
    qtbot.waitUntil(lambda: slices.is_idle)
    seen = slices.polar.lines
    assert seen is None or not seen.lines or seen.lines[0].key != "one"
    plots.set_shown(POLAR, True)
    qtbot.waitUntil(lambda: slices.is_idle)
    assert slices.polar.lines.lines[0].key == "one"


def test_a_drag_evaluates_each_subject_once_a_step(slices, session, qtbot) -> None:
    class Counted(Lambertian):
        calls = 0

        def eval(self, wi, wo):
            Counted.calls += 1
            return super().eval(wi, wo)

    session.add(subject("one", Counted(0.5)))
    qtbot.waitUntil(lambda: slices.is_idle)
    Counted.calls = 0
    session.set_incidence(30.0, 0.0)
    slices.draw_now()
    assert Counted.calls == 1  # polar plot and curves share what the plane has
    session.set_options(channel="r")
    slices.draw_now()
    assert Counted.calls == 1  # another channel is of the same values


def test_options_are_remembered_and_what_cannot_be_is_not(slices) -> None:
    slices.state.set(axis="theta_h", phi_d_deg=400.0, incidences_deg=(5.0, 20.0, 120.0))
    again = SliceState()
    assert (again.options.axis, again.options.phi_d_deg) == ("theta_h", 180.0)
    assert again.options.incidences_deg == (5.0, 20.0, 89.0)
    from brdf_qt.program.settings import settings

    for broken in ('{"axis": "up"}', "no json", '{"incidences_deg": [1]}', '{"ev": NaN}'):
        settings().setValue("lobes/slices", broken)
        assert SliceState().options == SliceOptions()
    assert slices.run_script("slices.tone", "gamma")
    assert slices.state.options.tone == "gamma"
    assert not slices.run_script("slices.tone", "bright")
    assert not slices.run_script("slices.nothing", "1")
    assert not slices.run_script("other.tone", "log")
