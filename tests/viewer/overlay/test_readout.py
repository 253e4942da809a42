"""The readout under the cursor, and the figures over the picture."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from brdf_viewer.light.dominant import dominant_light
from brdf_viewer.overlay.pixel_reading import (
    CursorReading,
    PixelReading,
    lab_words,
    long_lines,
    parts_at,
    short_words,
)
from brdf_viewer.overlay.readout import how
from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Compare, Lamp, Sparkle
from brdf_suite.geometry.polar import point_at
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.statistics import environment_statistics
from brdf_suite.realtime.pictures.probe import SurfacePoint


def hover(viewer, place: QPoint | None = None):
    """Rest the cursor on the picture and return what is read; None: in its middle."""
    place = place or viewer.canvas.rect().center()
    viewer.controller.readout.reading = None
    QTest.mouseMove(viewer.canvas, place)
    QTest.mouseMove(viewer.canvas, place + QPoint(1, 0))
    QTest.mouseMove(viewer.canvas, place)
    viewer.qtbot.waitUntil(lambda: viewer.controller.readout.reading is not None)
    return viewer.controller.readout.reading


def test_the_pixel_under_the_cursor(viewer) -> None:
    viewer.state.change_view(exposure_ev=0.5)
    viewer.qtbot.waitUntil(viewer.window.progress.isHidden)  # its strip takes height from the picture
    place = viewer.canvas.rect().center()
    reading = hover(viewer, place)
    (one,) = reading.readings
    ratio = viewer.canvas.devicePixelRatioF()
    light = []
    drawer, size = viewer.controller.drawer, viewer.window.picture.device_size

    def read() -> None:
        light.append(drawer.renderer.linear_image(viewer.view, size))

    viewer.window.picture.with_context(read, redraw=False)
    there = light[0][int(place.y() * ratio), int(place.x() * ratio), :3]
    np.testing.assert_allclose(one.radiance, there, rtol=5e-3)
    np.testing.assert_allclose(one.lab, working_to_lab(there * 2.0**0.5), atol=0.1)
    # In the middle of a framed sphere the surface looks at the viewer.
    assert reading.angles[0] == pytest.approx(0.0, abs=4.0)
    assert one.point.part
    assert np.linalg.norm(np.subtract(one.point.position, viewer.state.bounds.centre)) == pytest.approx(
        viewer.state.bounds.radius / math.sqrt(3.0), rel=0.02
    )
    cell = viewer.window.status.cell("readout")
    assert lab_words(one.lab) in cell.text()
    assert "radiance" in cell.toolTip()


def test_past_the_surface_there_is_a_colour_and_no_angle(viewer) -> None:
    reading = hover(viewer, QPoint(3, 3))
    assert reading.angles is None
    assert "background" in viewer.controller.readout.lines
    QApplication.sendEvent(viewer.canvas, QEvent(QEvent.Type.Leave))
    assert viewer.controller.readout.reading is None
    assert viewer.window.status.cell("readout").text() == ""


def test_the_readout_follows_the_picture_and_no_drag(viewer, qtbot) -> None:
    first = hover(viewer).readings[0]
    viewer.controller.paint.open("solid_white")
    qtbot.waitUntil(lambda: viewer.controller.readout.reading.readings[0].lab[0] > first.lab[0] + 10)


def test_it_says_whose_pixel_it_is_and_how_far_they_are_apart(viewer, qtbot) -> None:
    viewer.controller.compare.choose("solid_red")
    qtbot.waitUntil(lambda: viewer.state.second is not None)
    viewer.state.change_view(compare=replace(viewer.view.compare, mode="swipe"))
    width, height = viewer.canvas.width(), viewer.canvas.height()
    left = hover(viewer, QPoint(width // 2 - 20, height // 2)).readings[0]
    right = hover(viewer, QPoint(width // 2 + 20, height // 2)).readings[0]
    assert (left.which, right.which) == ("A", "B")
    assert left.lab[2] < right.lab[2] - 20
    assert viewer.window.status.cell("readout").text().startswith("B  L*")
    viewer.state.change_view(compare=replace(viewer.view.compare, mode="difference"))
    both = hover(viewer, QPoint(width // 2 + 20, height // 2))
    assert [one.which for one in both.readings] == ["A", "B"]
    assert both.readings[1].lab == pytest.approx(right.lab, abs=0.2)
    assert both.delta_e > 20
    assert viewer.window.status.cell("readout").text().startswith("ΔE00")


def test_h_shows_the_figures_and_hides_them(viewer, qtbot) -> None:
    overlay = viewer.window.overlay
    assert overlay.figures == ()
    viewer.canvas.setFocus()
    qtbot.waitUntil(viewer.canvas.hasFocus)
    QTest.keyClick(viewer.canvas, Qt.Key.Key_H)
    assert any("lobes" in line for line in overlay.figures)
    assert overlay.isVisible()
    hover(viewer)
    qtbot.waitUntil(lambda: any("L*" in line for line in overlay.figures))
    viewer.state.change_view(exposure_ev=-1.5)
    assert any("-1.5 EV" in line for line in overlay.figures)
    QTest.keyClick(viewer.canvas, Qt.Key.Key_H)
    assert overlay.figures == ()


def test_the_figures_are_remembered(start) -> None:
    viewer = start()
    viewer.window.commands.figures.trigger()
    viewer.close()
    again = start()
    again.qtbot.waitUntil(lambda: again.window.overlay.figures != ())
    assert again.window.commands.figures.isChecked()


@pytest.mark.parametrize(
    ("compare", "pixel", "parts"),
    [
        (Compare("off"), (9, 5), [("A", (101, 60), (9, 5))]),
        (Compare("side", "b"), (49, 5), [("A", (50, 60), (49, 5))]),
        (Compare("side", "b"), (50, 5), [("B", (51, 60), (0, 5))]),
        (Compare("swipe", "b", 0.25), (24, 5), [("A", (101, 60), (24, 5))]),
        (Compare("swipe", "b", 0.25), (25, 5), [("B", (101, 60), (25, 5))]),
        (Compare("blink", "b"), (9, 5), [("B", (101, 60), (9, 5))]),
        (Compare("difference", "b"), (9, 5), [("A", (101, 60), (9, 5)), ("B", (101, 60), (9, 5))]),
    ],
)
def test_whose_pixel_it_is(compare, pixel, parts) -> None:
    assert parts_at(View(compare=compare), (101, 60), pixel, shows_second=True) == parts


def sunny(azimuth_deg: float, elevation_deg: float):
    rows, columns = 64, 128
    pixels = np.full((rows, columns, 3), 0.1, np.float32)
    towards = np.asarray(point_at(azimuth_deg, elevation_deg, 1.0))
    from brdf_suite.lighting.latlong import column_angles, ring_angles
    from brdf_suite.lighting.latlong import direction as texel

    there = texel(ring_angles(rows)[:, None], column_angles(columns)[None, :])
    pixels[there @ towards > np.cos(0.05)] = 500.0
    return environment_statistics(Environment("sunny", pixels))


def test_the_strongest_light_is_the_sun_and_turns_with_the_environment() -> None:
    figures = sunny(40.0, 30.0)
    light = dominant_light(View(rotation_deg=25.0), figures)
    np.testing.assert_allclose(light.seen_from((1.0, 2.0, 3.0)), point_at(65.0, 30.0, 1.0), atol=0.05)
    assert f"elevation {figures.sun_elevation_deg:.0f}°" in light.words
    weak, strong = Lamp("directional", azimuth_deg=-90.0, strength=1e-3), Lamp("point", strength=1e4)
    assert dominant_light(View(lamps=(weak,)), figures).words == dominant_light(View(), figures).words
    lamp = dominant_light(View(lamps=(weak, strong)), figures)
    assert lamp.words == "point lamp 2"
    np.testing.assert_allclose(lamp.seen_from((1.0, 2.0, 0.0)), (0.0, 0.0, 1.0), atol=1e-12)
    assert "lamp 1" in dominant_light(View(lamps=(weak,)), None).words
    assert dominant_light(View(), None) is None
    even = environment_statistics(Environment("even", np.ones((32, 64, 3), np.float32)))
    assert dominant_light(View(), even) is None


def test_words() -> None:
    point = SurfacePoint((0.0123, 0.5, -1.0), (0.0, 1.0, 0.0), (0.0, 1.0, 0.0), "hood", "paint")
    one = PixelReading("A", (45.04, -3.26, 0.04), (0.1, 0.25, 3.0), point)
    figures = sunny(0.0, 30.0)
    reading = CursorReading((one,), None, dominant_light(View(), figures))
    aspecular = 90.0 - figures.sun_elevation_deg
    assert aspecular == pytest.approx(60.0, abs=3.0)
    assert short_words(reading) == f"A  L* 45.0  a* −3.3  b* 0.0  view 0°  aspecular {aspecular:.0f}°"
    lines = long_lines(reading)
    assert lines[0] == "A  L* 45.0  a* −3.3  b* 0.0   radiance 0.1  0.25  3"
    assert lines[1] == f"view 0.0°   aspecular {aspecular:.1f}°"
    assert lines[3] == "x 12.3  y 500.0  z −1000.0 mm on hood (paint)"
    past = CursorReading((replace(one, point=None),), None, None)
    assert short_words(past) == "A  L* 45.0  a* −3.3  b* 0.0"
    assert how(View(sparkle=Sparkle("off"), exposure_ev=1.0)).endswith("no sparkle")
