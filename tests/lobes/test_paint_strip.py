"""The paint strip of Lobe Visualizer: a click opens a paint, and one that is shown comes to the front."""

from __future__ import annotations


def test_a_click_opens_a_paint_once_and_brings_it_to_the_front(qtbot, program) -> None:
    program.start()
    session, strip = program.session, program.strip
    qtbot.waitUntil(lambda: len(session.subjects) == 1)
    assert strip.model.row_of("table1_ford_f8") >= 0
    for key in ("candy_red", "table1_ford_f8"):
        with qtbot.waitSignal(program.sources.opened, timeout=30_000):
            strip.strip.taken.emit(key)
        assert session.front.material.origin == strip.model.present == key
    strip.strip.taken.emit("candy_red")
    assert len(session.subjects) == 3
    assert session.front.material.origin == strip.model.present == "candy_red"
