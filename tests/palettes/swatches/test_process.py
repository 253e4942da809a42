"""The process that draws swatches: one that cannot be drawn costs no other its picture."""

from __future__ import annotations

import io
import json
from collections.abc import Sequence
from pathlib import Path

import pytest

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette import Entry
from brdf_suite.documents.palette_store import entry_to_json
from brdf_suite.errors import GraphicsError
from brdf_suite.palettes.swatches.look import Content, SwatchLook
from brdf_suite.palettes.swatches.pictures import SwatchPainter, SwatchPicture
from brdf_suite.palettes.swatches.process import serve
from brdf_suite.palettes.swatches.store import SwatchStore

LOOK = SwatchLook("flop_strip", size=16)
PAINTS = [solid_paint(name, (10.0 * at, 0.0, 0.0)) for at, name in enumerate(("odd", "one", "two"), 1)]


def answers(folder: Path, names: Sequence[str]) -> list[dict[str, object]]:
    """Return what is answered to a request for paints."""
    items = [
        {"key": paint.name, "paint": entry_to_json(Entry(paint, id="a"))["paint"]}
        for paint in PAINTS
        if paint.name in names
    ]
    out = io.StringIO()
    lines = json.dumps({"id": 5, "look": LOOK.to_json(), "items": items})
    serve(io.StringIO(lines + "\n"), out, SwatchStore(folder))
    return [json.loads(line) for line in out.getvalue().splitlines()]


def refuse(monkeypatch: pytest.MonkeyPatch, error: Exception, *names: str) -> None:
    """Have the painter raise where one of these is among what it draws."""
    draw = SwatchPainter.draw

    def refusing(self: SwatchPainter, contents: Sequence[Content], look: SwatchLook) -> list[SwatchPicture]:
        if {content.name for content in contents} & set(names):
            raise error
        return draw(self, contents, look)

    monkeypatch.setattr(SwatchPainter, "draw", refusing)


def test_an_unexpected_error_refuses_its_paint_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    refuse(monkeypatch, ZeroDivisionError("by nothing"), "odd")
    odd, one, two, done = answers(tmp_path, ["odd", "one", "two"])
    assert "ZeroDivisionError: by nothing" in str(odd["refused"])
    assert "Traceback" in str(odd["fault"])
    assert all("picture" in answer for answer in (one, two))
    assert done == {"id": 5, "done": True}


def test_an_item_that_cannot_be_known_is_refused_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from brdf_suite.palettes.swatches import process as swatch_process

    key = swatch_process.swatch_key

    def failing(content: Content, look: SwatchLook) -> str:
        if content.name == "odd":
            raise OverflowError("too much")
        return key(content, look)

    monkeypatch.setattr(swatch_process, "swatch_key", failing)
    odd, one, _done = answers(tmp_path, ["odd", "one"])
    assert "OverflowError" in str(odd["refused"])
    assert "picture" in one


def test_a_paint_alone_that_the_driver_refuses_says_nothing_of_the_machine(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    refuse(monkeypatch, GraphicsError("too many lobes"), "odd")
    assert answers(tmp_path, ["odd"]) == [
        {"id": 5, "key": "odd", "refused": "too many lobes"},
        {"id": 5, "done": True},
    ]
    refuse(monkeypatch, GraphicsError("no driver"), "odd", "grey")
    assert answers(tmp_path, ["odd"]) == [{"id": 5, "unavailable": "no driver"}]
