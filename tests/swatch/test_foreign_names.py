"""Names from files are plain text all over Color Swatch, and a wheel that passes over its fields changes nothing."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from brdf_color_swatch.paint_exchange import PaintExchange
from brdf_qt.link.link import LiveLink
from brdf_qt.window.message_bar import Message

from brdf_suite.documents.palette import Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.documents.store import paint_to_json


def hostile_of(palette: Palette, name: str) -> Palette:
    """The same palette with one name for all that has one."""
    entries = tuple(
        replace(
            entry,
            content=replace(entry.content, name=name),
            group=(name,),
            tags=(name,),
            code=name,
            notes=name,
        )
        for entry in palette.entries
    )
    return replace(palette, name=name, entries=entries, notes=name)


def test_names_are_plain_text_in_the_whole_window(swatch, command, walks, qtbot, tmp_path: Path) -> None:
    path = tmp_path / f"{walks.HOSTILE_FILE}.brdfpalette"
    palette = hostile_of(swatch.session.palette, walks.HOSTILE)
    save_palette(palette, path)
    swatch.open(str(path))
    qtbot.waitUntil(
        lambda: swatch.session.palette is not None and swatch.session.palette.name == walks.HOSTILE
    )
    pane = swatch.window.panes[swatch.session.front]
    pane.grid.select_rows([0, 1])
    command(swatch, "compare")
    command(swatch, "select_all")
    command(swatch, "list")
    command(swatch, "two_panes")
    swatch.window.show_message(Message("test", walks.HOSTILE, where=walks.HOSTILE))
    swatch.window.show_recent([path])
    link = swatch.feature(PaintExchange)
    designer = LiveLink("designer", name=link.link.name)
    designer.start()
    try:
        qtbot.waitUntil(lambda: "designer" in link.link.peers)
        designer.publish("paint", paint_to_json(palette.entries[0].content))
        qtbot.waitUntil(lambda: link.edited is not None)
        command(swatch, "take")
        command(swatch, "nearest_edited")
        wrong, seen = walks.drawn_as_html()
    finally:
        designer.close()
        qtbot.waitUntil(lambda: not link.link.peers)
    assert wrong == []
    assert seen > 20


def test_a_wheel_changes_nothing_in_the_window(swatch, command, walks) -> None:
    command(swatch, "two_panes")
    state, look, palette = swatch.session.state, swatch.session.look, swatch.session.palette
    changed, count = walks.changed_by_wheel(swatch.window)
    assert changed == []
    assert count > 5
    assert (swatch.session.state, swatch.session.look, swatch.session.palette) == (state, look, palette)
