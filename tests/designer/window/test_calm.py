"""Nothing moves while a paint is edited, and what is not as it was or should be is marked."""

from __future__ import annotations

from brdf_designer.assembly import Designer
from brdf_designer.session.edits import SetField, SetNumber
from brdf_qt.fields.marks import Mark
from PySide6.QtCore import QEvent, QObject, QPoint, QRect, Qt
from PySide6.QtGui import QPaintEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget


def places(designer: Designer) -> dict[str, QRect]:
    """Return where every shown widget of the window lies that does not float."""
    window = designer.window
    floating = (window.messages, window.progress)
    return {
        f"{type(widget).__name__} {widget.objectName() or widget.accessibleName()} {id(widget)}": QRect(
            widget.mapTo(window, QPoint(0, 0)), widget.size()
        )
        for widget in window.findChildren(QWidget)
        if widget.isVisible() and not any(one is widget or one.isAncestorOf(widget) for one in floating)
    }


def moved(before: dict[str, QRect], after: dict[str, QRect]) -> dict[str, tuple[QRect, QRect]]:
    """Return what lies elsewhere; what has come or gone moves nothing by itself."""
    return {name: (place, after[name]) for name, place in before.items() if after.get(name, place) != place}


def settle(designer: Designer, qtbot) -> None:
    plane = designer.window.editors.plane
    qtbot.waitUntil(lambda: designer.controller.is_idle and designer.session.is_quiet and plane.is_idle)
    qtbot.wait(60)


def test_a_fit_its_notices_and_a_refused_edit_move_nothing(program, qtbot) -> None:
    window = program.window
    for section in window.inspector.sections:
        section.set_open(
            section in (window.section("colour"), window.section("coat"), window.section("model"))
        )
    settle(program, qtbot)
    before = places(program)
    for edit in (
        SetNumber("gloss.gu_20", 5.0),
        SetNumber("near_specular", 2.0),
        SetField("interpolation", "polynomial"),
    ):
        program.session.edit(edit)
        settle(program, qtbot)
        assert moved(before, places(program)) == {}, edit
    window.coat.show_refusal("No coat has these readings: the gloss at 60° would have to be larger.")
    program.window.progress.set_job("fit", 0.5, "Looking for the closest paint", lambda: None)
    qtbot.wait(20)
    assert moved(before, places(program)) == {}
    program.window.progress.end_job("fit")
    window.coat.show_refusal("")


class Counter(QObject):
    """Counts events by the class of their widget; of painting the pixels about what was painted."""

    def __init__(self) -> None:
        super().__init__()
        self.layouts: list[str] = []
        self.painted: dict[str, list[int]] = {}

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - the name is Qt's
        name = f"{type(watched).__name__} {watched.objectName()}".strip()
        if event.type() == QEvent.Type.LayoutRequest:
            self.layouts.append(name)
        elif isinstance(event, QPaintEvent):
            size = event.region().boundingRect().size()
            self.painted.setdefault(name, []).append(size.width() * size.height())
        return False


def test_a_step_of_a_drag_fits_once_lays_nothing_out_and_paints_what_has_changed(program, qtbot) -> None:
    window, session = program.window, program.session
    slider = window.editors.plane.slider
    fits, steps = [], 8
    session.fit_changed.connect(fits.append)
    counter = Counter()
    press = QPoint(round(slider._x(slider.amount())), slider.height() // 2)
    QTest.mousePress(slider, Qt.MouseButton.LeftButton, pos=press)
    QTest.mouseMove(slider, press + QPoint(1, 0))  # now there is something to undo, which the window says
    settle(program, qtbot)
    fits.clear()
    QApplication.instance().installEventFilter(counter)
    try:
        for step in range(1, steps + 1):
            # One pixel to and fro: no mark, no bold number and no longer text comes of it.
            QTest.mouseMove(slider, press + QPoint(1 + step % 2, 0))
            # The numbers are painted, before any fit.
            QApplication.sendPostedEvents(window, QEvent.Type.UpdateRequest)
            assert len(fits) == step - 1
            qtbot.waitUntil(lambda: program.controller.is_idle)
            QApplication.sendPostedEvents(window, QEvent.Type.UpdateRequest)
        settle(program, qtbot)
    finally:
        QApplication.instance().removeEventFilter(counter)
        QTest.mouseRelease(slider, Qt.MouseButton.LeftButton)
    assert len(fits) == steps
    assert counter.layouts == []
    painted = counter.painted[f"ColourSlider {slider.objectName()}"]
    assert len(painted) == steps
    assert max(painted) < 0.2 * slider.width() * slider.height()


def test_a_changed_rule_is_marked_until_it_is_back(program, qtbot) -> None:
    window, line = program.window, program.window.status
    assert window.model.changed.isHidden()
    program.session.edit(SetField("interpolation", "polynomial"))
    settle(program, qtbot)
    assert not window.model.changed.isHidden()
    assert window.model.changed.mark is Mark.CHANGED
    assert "Flake tilts" in window.model.changed.text()
    assert line.cell("Model").mark is Mark.CHANGED
    assert "Polynomial" in line.cell("Model").toolTip()
    program.session.undo()
    settle(program, qtbot)
    assert window.model.changed.isHidden()
    assert line.cell("Model").text() == ""


def test_a_fit_that_misses_between_the_readings_is_marked(program, qtbot, monkeypatch) -> None:
    settle(program, qtbot)
    cell = program.window.status.cell("Fit")
    assert cell.mark is None
    program.session.edit(SetField("interpolation", "polynomial"))
    settle(program, qtbot)
    between = float(cell.text().split("≤")[2].split(",")[0])
    assert (cell.mark is Mark.BAD) == (between > 1.0)
    assert between > 1.0, "the example has a parabola that lobes cannot follow"


def test_colours_that_the_screen_cannot_show_are_marked(program, qtbot) -> None:
    settle(program, qtbot)
    cell = program.window.status.cell("Gamut")
    assert cell.text().startswith("Outside sRGB")
    assert cell.mark is Mark.OUTSIDE
