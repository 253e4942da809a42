"""Designer and Viewer as two processes: an edit there is a picture here."""

from __future__ import annotations

import gc
import os
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from brdf_qt.fields.marks import Mark
from brdf_qt.link.link import LiveLink
from brdf_viewer.paint.control import DESIGNER
from PySide6.QtWidgets import QPushButton

from brdf_suite.documents.paint import Gloss, solid_paint
from brdf_suite.documents.store import paint_to_json, save_paint, view_from_json
from brdf_suite.documents.view import Camera
from brdf_suite.fitting.lobes.highs_model import BlockSolver, SolverOutcome
from brdf_suite.pipeline.lobe_fit import PaintFitter, fit_material
from brdf_suite.pipeline.material import load_material

RED, GREY = solid_paint("red", (45.0, 60.0, 40.0)), solid_paint("grey", (50.0, 0.0, 0.0))
PROGRAM = Path(__file__).with_name("designer_program.py")


class Designer:
    def __init__(self) -> None:
        self.process = subprocess.Popen(
            [sys.executable, str(PROGRAM)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
        assert self.process.stdout.readline().strip() == "ready"

    def send_line(self, line: str) -> None:
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()

    def end(self) -> None:
        self.process.stdin.close()
        self.process.wait(120)
        self.process.stdout.close()


@pytest.fixture
def viewer(start):
    """A Viewer of its own: one that has met a Designer goes on to offer the Designer's paint."""
    return start()


@pytest.fixture
def designer() -> Iterator[Callable[[], Designer]]:
    opened: list[Designer] = []

    def opener() -> Designer:
        opened.append(Designer())
        return opened[-1]

    opener.opened = opened
    yield opener
    for one in opened:
        one.end()


def colour(viewer) -> np.ndarray:
    """Return the mean colour of the middle of the picture, where the sphere is."""
    pixels = viewer.pixels()
    h, w = pixels.shape[:2]
    return pixels[h // 3 : 2 * h // 3, w // 2 - h // 6 : w // 2 + h // 6].reshape(-1, 3).mean(axis=0)


def test_a_paint_of_another_process_is_drawn(viewer, designer, qtbot) -> None:
    link_cell = viewer.window.status.cell("link")
    assert link_cell.text() == "Not connected"
    other = designer()
    qtbot.waitUntil(lambda: link_cell.text() == "Connected: Designer")
    other.send_line("lab 45 60 40")
    qtbot.waitUntil(lambda: viewer.state.fit.paint.name == "test paint")
    red = colour(viewer)
    assert red[0] > red[2] + 30
    other.send_line("lab 45 -40 -30")
    qtbot.waitUntil(lambda: viewer.state.fit.paint.lab_at(45.0)[1] == -40.0)
    blue = colour(viewer)
    assert blue[2] > blue[0] + 30
    assert viewer.window.paint.chooser.list.currentData() == DESIGNER
    assert next(p.lab for p in viewer.window.paint.patches.patches) == (45.0, -40.0, -30.0)


def test_a_viewer_that_comes_later_shows_the_present_paint(start, designer, qtbot) -> None:
    other = designer()
    other.send_line("lab 45 60 40")
    viewer = start()
    qtbot.waitUntil(lambda: viewer.state.fit.paint.name == "test paint")


def test_a_drag_ends_with_the_last_paint(viewer, designer, qtbot) -> None:
    other = designer()
    other.send_line("drag 400")
    last = 20.0 + 60.0 * 399 / 400
    qtbot.waitUntil(lambda: viewer.state.fit.paint.lab_at(45.0)[0] == pytest.approx(last))


def test_designer_ends_and_the_paint_stays(viewer, designer, qtbot) -> None:
    other = designer()
    other.send_line("lab 45 60 40")
    qtbot.waitUntil(lambda: viewer.state.fit.paint.name == "test paint")
    other.process.kill()
    qtbot.waitUntil(lambda: viewer.window.status.cell("link").text() == "Not connected")
    assert viewer.state.fit.paint.name == "test paint"
    assert "not open" in viewer.window.paint.follow.text()
    assert viewer.window.paint.chooser.list.currentText() == "test paint (closed)"
    again = designer()
    again.send_line("lab 45 -40 -30")
    qtbot.waitUntil(lambda: viewer.state.fit.paint.lab_at(45.0)[1] == -40.0)
    assert viewer.window.paint.chooser.list.currentText() == "test paint (Designer)"


def test_a_paint_that_was_asked_for_is_shown_and_an_open_designer_is_offered(start, designer, qtbot) -> None:
    other = designer()
    other.send_line("lab 45 60 40")
    viewer = start(paint="copper", follow=False)
    qtbot.waitUntil(lambda: "follow" in viewer.messages())
    assert "Designer is open. Follow it" in viewer.messages()["follow"]
    qtbot.waitUntil(lambda: viewer.controller.paint.of_designer is not None)
    assert viewer.state.fit.paint.name == "Copper"
    assert not viewer.window.paint.follow.isChecked()
    assert not viewer.window.commands.follow.isChecked()
    assert viewer.window.status.cell("link").text() == "Connected: Designer (not following)"
    viewer.window.messages.findChild(QPushButton, "message_action_Follow Designer").click()
    assert viewer.state.fit.paint.name == "test paint"
    assert viewer.window.paint.follow.isChecked()
    assert "follow" not in viewer.messages()


def test_the_offer_to_follow_leaves_with_designer_and_comes_once(start, designer, qtbot) -> None:
    viewer = start(paint="copper", follow=False)
    assert "follow" not in viewer.messages()
    designer()
    qtbot.waitUntil(lambda: "follow" in viewer.messages())
    designer.opened[-1].process.kill()
    qtbot.waitUntil(lambda: "follow" not in viewer.messages())
    designer()
    qtbot.waitUntil(lambda: viewer.window.status.cell("link").text() == "Connected: Designer (not following)")
    assert "follow" not in viewer.messages()


def test_another_paint_ends_following_and_following_brings_designer_back(viewer, designer, qtbot) -> None:
    other = designer()
    other.send_line("lab 45 60 40")
    qtbot.waitUntil(lambda: viewer.state.fit.paint.name == "test paint")
    viewer.controller.paint.open("solid_white")
    assert not viewer.window.paint.follow.isChecked()
    white = viewer.state.fit
    other.send_line("lab 20 0 0")
    qtbot.waitUntil(lambda: viewer.controller.paint.of_designer.lab_at(45.0)[0] == 20.0)
    assert viewer.state.fit is white
    assert viewer.window.status.cell("link").text() == "Connected: Designer (not following)"
    viewer.window.paint.follow.click()
    assert viewer.state.fit.paint.lab_at(45.0)[0] == 20.0


def test_designers_paint_is_shown_while_it_is_followed(viewer) -> None:
    paint, state = viewer.controller.paint, viewer.state
    viewer.controller.link.received.emit("paint", paint_to_json(RED))
    paint.set_following(False)
    viewer.controller.link.received.emit("paint", paint_to_json(GREY))
    assert (state.fit.name, state.paint_key) == ("red", DESIGNER)
    paint.set_following(True)
    assert (state.fit.name, state.paint_key) == ("grey", DESIGNER)


def test_a_file_ends_following_and_a_bad_one_changes_nothing(viewer, tmp_path) -> None:
    paint, state, first = viewer.controller.paint, viewer.state, viewer.state.fit
    paint.open(str(tmp_path / "nowhere.brdfpaint"))
    viewer.wait_idle()
    assert "nowhere" in viewer.messages()["paint"]
    assert (paint.following, state.fit) == (True, first)
    file = tmp_path / "red.brdfpaint"
    save_paint(RED, file)
    paint.open(str(file))
    viewer.wait_idle()
    assert (paint.following, state.fit.name, state.paint_key) == (False, "red", str(file))


def test_a_time_limited_picture_says_so_and_becomes_exact_by_itself(viewer, qtbot) -> None:
    hurried = PaintFitter(time_limit_s=1e-6)
    viewer.controller.paint.fitter = hurried
    cell, shown = viewer.window.status.cell("fit"), []
    viewer.state.contents_changed.connect(lambda: shown.append((viewer.state.fit.time_limited, cell.text())))
    viewer.controller.paint.open("copper")
    qtbot.waitUntil(lambda: len(shown) >= 2)
    assert [limited for limited, _ in shown] == [True, False]
    assert "time-limited" in shown[1][1]  # what stood there until then
    assert "time-limited" not in cell.text()
    assert "time-limited" not in viewer.window.paint.fit.text()
    assert viewer.state.fit.worst_delta_e < 0.5
    hurried.close()


def test_an_optimum_that_is_not_found_is_no_longer_promised(viewer, qtbot, monkeypatch) -> None:
    hurried = PaintFitter(time_limit_s=1e-6)
    viewer.controller.paint.fitter = hurried
    cell, section = viewer.window.status.cell("fit"), viewer.window.paint
    with hurried.lobe_fitter.solver.background.lock:
        # No paint is known that loses the solver, and those that start afresh.
        monkeypatch.setattr(BlockSolver, "run", lambda *_: SolverOutcome.LOST)
        viewer.controller.paint.open("copper")
        for tip in (cell.toolTip(), section.fit.toolTip()):
            assert "follows automatically" in tip
        assert section.patches.exact_follows
    qtbot.waitUntil(lambda: "no exact" in cell.toolTip())
    assert "no exact" in section.fit.toolTip()
    assert "time-limited" in cell.text()
    assert not section.patches.exact_follows
    hurried.close()


def test_a_fit_without_an_angle_to_compare_at_claims_no_bound(viewer) -> None:
    fit = fit_material(load_material("table1_2k_acrylack"), errors=True)
    none = replace(fit, angles=tuple(replace(row, fitted=False) for row in fit.angles))
    assert none.worst_delta_e is None
    viewer.controller.paint.show_fit(none, "file")
    assert "ΔE" not in viewer.window.paint.fit.text()
    assert "no measured angles" in viewer.window.paint.fit.text()
    assert "ΔE" not in viewer.window.status.cell("fit").text()
    viewer.controller.paint.show_fit(fit, "file")
    assert "maximum ΔE00" in viewer.window.paint.fit.text()
    assert "ΔE00 0." in viewer.window.status.cell("fit").text()


def test_a_colour_that_the_lobes_do_not_reach_stands_out(viewer, qtbot) -> None:
    section, cell = viewer.window.paint, viewer.window.status.cell("fit")

    def show(paint) -> None:
        viewer.controller.link.received.emit("paint", paint_to_json(paint))
        qtbot.waitUntil(lambda: viewer.state.fit.paint == paint)

    solid = solid_paint("p", (50.0, 0.0, 0.0))
    show(solid)
    plain = section.patches.grab().toImage()
    assert not section.fit.text().startswith("!")
    assert not section.fit.font().bold()
    # Darker towards the mirror direction than away from it: lobes around the mirror direction cannot do that.
    show(solid.with_lab(45.0, (90.0, 0.0, 0.0)))
    assert section.fit.text().startswith("Fit: maximum ΔE00 3")
    assert section.fit.mark is Mark.BAD
    assert section.fit.font().bold()
    assert "no non-negative sum of the lobes" in section.fit.toolTip()
    assert "ΔE00 3" in cell.text()
    assert cell.mark is Mark.BAD
    assert cell.font().bold()
    assert "no non-negative sum of the lobes" in cell.toolTip()
    words = section.patches.accessibleDescription().split("; ")
    assert ["no non-negative sum" in text for text in words] == [False, True, False]
    assert section.patches.grab().toImage() != plain
    show(solid)
    assert not section.fit.font().bold()
    assert not cell.font().bold()


def test_a_paint_that_cannot_be_is_reported_and_leaves_when_the_next_can(viewer, designer, qtbot) -> None:
    other = designer()
    other.send_line("lab 45 60 40")
    qtbot.waitUntil(lambda: viewer.state.fit.paint.name == "test paint")
    first = viewer.state.fit
    other.send_line("gloss 195")
    qtbot.waitUntil(lambda: "paint" in viewer.messages())
    assert "test paint" in viewer.messages()["paint"]
    assert viewer.state.fit is first
    other.send_line("gloss 85")
    qtbot.waitUntil(lambda: "paint" not in viewer.messages())
    assert viewer.state.fit.paint.gloss == Gloss(85.0)


def test_the_view_is_published(viewer, qtbot) -> None:
    listener = LiveLink("designer")
    heard: list[object] = []
    listener.received.connect(lambda topic, value: heard.append(value) if topic == "view" else None)
    listener.start()
    qtbot.waitUntil(lambda: bool(heard))
    viewer.state.change_view(exposure_ev=1.5)
    qtbot.waitUntil(lambda: view_from_json(heard[-1], "test") == viewer.view)
    listener.close()


def test_a_paint_change_makes_nothing_new_and_nothing_grows(start, qtbot) -> None:
    """Paints as the link delivers them: no OpenGL object, no texture write, no memory, no new program.

    Rounds are repeated until one leaves everything as it was: what leaks grows in each round; what a thread, a library
    or the first picture at rest makes once, at a time that depends on the load of the machine, does not.
    """
    viewer = start(size=(640, 420))
    viewer.window.panel.bring_in_sight(viewer.window.tone)  # what is not seen is not counted
    viewer.state.change_view(
        background="grey", camera=Camera(distance=6.0)
    )  # a small sphere: frames cost less

    def change(step: int) -> None:
        paint = solid_paint("p", (30.0 + 40.0 * (step % 50) / 50, 5.0, -5.0))
        viewer.controller.link.received.emit("paint", paint_to_json(paint))
        with qtbot.waitSignal(viewer.window.picture.frame_drawn):
            pass

    fitter = viewer.controller.paint.fitter.lobe_fitter
    counters = viewer.controller.drawer.scene_renderer.renderer.counters
    programs = [id(program) for program in fitter.programs]
    for step in range(20):
        change(step)
    qtbot.waitUntil(lambda: viewer.controller.tone.counted is not None)
    rounds: list[tuple[int, int, int]] = []
    while len(rounds) < 12:
        gc.collect()
        memory, made = resident(), counters.total_created
        uploads, writes = counters.texture_uploads, counters.buffer_writes
        for step in range(40):
            change(step)
        gc.collect()
        assert counters.buffer_writes - writes <= 40
        rounds.append(
            (counters.total_created - made, counters.texture_uploads - uploads, resident() - memory)
        )
        if rounds[-1][:2] == (0, 0) and rounds[-1][2] < 0.6e6:
            break
    assert rounds[-1][:2] == (0, 0), rounds
    assert rounds[-1][2] < 0.6e6, rounds
    assert [id(program) for program in fitter.programs] == programs


def resident() -> int:
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def test_an_edit_opens_no_file_and_imports_nothing(start, qtbot) -> None:
    viewer = start(size=(640, 420))
    seen: list[tuple[str, object]] = []
    watching = [False]

    def hook(event: str, arguments: tuple) -> None:
        # What other threads do, such as the counting of the figures of a light, is no part of an edit.
        ours = threading.current_thread().name.startswith(("MainThread", "brdf-fit"))
        if watching[0] and ours and event in ("open", "import"):
            seen.append((event, arguments[0]))

    sys.addaudithook(hook)  # stays until the process ends, and does nothing unless it is set to watch
    for step in range(6):
        value = paint_to_json(solid_paint("p", (30.0 + step, 5.0, -5.0)))
        watching[0] = step > 0  # the first of all may still load something
        viewer.controller.link.received.emit("paint", value)
        viewer.pixels()
        watching[0] = False
    assert seen == []


def test_a_paint_that_breaks_the_schema_never_arrives(viewer, qtbot, caplog) -> None:
    other = LiveLink("designer")
    other.start()
    qtbot.waitUntil(lambda: "viewer" in other.peers)
    first = viewer.state.fit
    good = paint_to_json(solid_paint("good", (60.0, 0.0, 0.0)))
    for bad in ({}, {**good, "gloss": {"gu_20": "shiny"}}, {**good, "version": 99}, {**good, "extra": 1}):
        other.publish("paint", bad)
        qtbot.waitUntil(lambda: "dropped a paint" in caplog.text)
        caplog.clear()
    assert viewer.state.fit is first
    other.publish("paint", good)
    qtbot.waitUntil(lambda: viewer.state.fit.paint.name == "good")
    other.close()
