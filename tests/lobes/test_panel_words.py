"""The words over small panels: title, caption and note on lines of their own, whatever room there is."""

from __future__ import annotations

from itertools import combinations

import pytest
from brdf_lobe_visualizer.verdict import DELTA_E_LIMITS, RMS_LIMITS, verdict_of
from brdf_lobe_visualizer.view3d.frame import Bar, Label, Panel
from brdf_lobe_visualizer.view3d.overlay import Overlay
from brdf_qt.fields.marks import Mark
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QFont, QImage, QPainter

from brdf_suite.inspection.lobe_surface.colour import value_map

PANEL = Panel(
    "Ford Polaris, a measured car paint",
    "Target\nmaximum 1234.5 1/sr, cut off in the picture",
    note="Outdated: computing the new values…\nNo sample within 2.5° of this incidence; the nearest is at 12.0°.",
    colour=(0.8, 0.2, 0.2),
)
BAR = Bar(value_map(), ((1.0, "0.30"), (0.5, "0.1"), (0.0, "0")), "Y  f_r·cosθi (1/sr)")


@pytest.fixture(scope="module")
def overlay(qapp):
    image = QImage(600, 500, QImage.Format.Format_RGB32)
    painter = QPainter(image)
    font = QFont("DejaVu Sans", 10)
    yield Overlay(painter, font, QColor("white"), QColor("black"))
    painter.end()


@given(st.integers(40, 500), st.integers(30, 400), st.booleans())
def test_no_line_lies_over_another_or_over_the_scale_bar(
    overlay: Overlay, wide: int, high: int, barred: bool
) -> None:
    room = QRectF(20.0, 10.0, wide, high)
    taken = [overlay.bar_room(BAR, room)] if barred else []
    words = overlay.words_of(PANEL, room, taken)
    boxes = [*(one.box for one in words), *taken]
    for first, second in combinations(boxes, 2):
        common = first.intersected(second)
        assert common.isEmpty() or min(common.width(), common.height()) < 0.5
    assert all(room.contains(one.box) for one in words)


def test_the_note_stays_where_there_is_room_for_one_line_only(overlay: Overlay) -> None:
    room = QRectF(0.0, 0.0, 260.0, 62.0)
    texts = [one.text for one in overlay.words_of(PANEL, room)]
    assert texts[0].startswith("Ford")
    assert any("Outdated" in text for text in texts)
    whole = [one.text for one in overlay.words_of(PANEL, QRectF(0.0, 0.0, 560.0, 400.0))]
    assert "maximum 1234.5 1/sr, cut off in the picture" in whole


def test_labels_of_the_frame_keep_off_the_words(overlay: Overlay, monkeypatch: pytest.MonkeyPatch) -> None:
    room = QRectF(0.0, 0.0, 300.0, 200.0)
    words = overlay.words_of(PANEL, room)
    drawn: list[str] = []
    monkeypatch.setattr(overlay, "_halo", lambda _box, text, *_: drawn.append(text))
    middle = words[1].box.center()
    labels = [Label((0.0, 0.0, 0.0), "N"), Label((1.0, 0.0, 0.0), "L")]
    places = {0.0: middle, 1.0: QPointF(150.0, 100.0)}
    boxes = [one.box for one in words]
    overlay.labels(labels, lambda place: places[place[0]], room, [False, False], boxes)
    assert drawn == ["L"]


def test_an_error_is_good_visible_or_bad() -> None:
    found = [verdict_of(value, DELTA_E_LIMITS) for value in (0.4, 2.0, 22.78, float("nan"))]
    assert found == [Mark.GOOD, Mark.WARNING, Mark.BAD, Mark.BAD]
    assert verdict_of(0.97, RMS_LIMITS) == Mark.BAD
