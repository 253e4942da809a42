"""The live link, with a second program on it: paints are sent, offered, and the edited one is taken."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from brdf_color_swatch.paint_exchange import PaintExchange
from brdf_qt.link.link import LiveLink
from brdf_qt.link.messages import OFFER, BadMessageError, document_checks

from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette import Entry
from brdf_suite.documents.store import paint_to_json
from brdf_suite.errors import SuiteError


@pytest.fixture
def part(swatch):
    found = swatch.feature(PaintExchange)
    found.edited = None
    found.started = []
    found.start_program = lambda role: found.started.append(role) or True
    return found


@pytest.fixture
def designer(part, qtbot) -> Iterator[LiveLink]:
    """Another program on the link of this module's program."""
    link = LiveLink("designer", name=part.link.name)
    link.start()
    qtbot.waitUntil(lambda: "designer" in part.link.peers)
    yield link
    link.close()
    qtbot.waitUntil(lambda: not part.link.peers)


def test_a_paint_is_offered_to_designer_and_shown_to_the_others(
    swatch, part, designer, select, command, qtbot
) -> None:
    heard: list[tuple[str, dict]] = []
    designer.received.connect(lambda topic, value: heard.append((topic, value)))
    select(swatch, "Blue")
    command(swatch, "to_designer")
    qtbot.waitUntil(
        lambda: any(topic == OFFER and value["paint"]["name"] == "Blue" for topic, value in heard)
    )
    assert part.started == []
    command(swatch, "to_viewer")
    qtbot.waitUntil(lambda: any(topic == "paint" and value["name"] == "Blue" for topic, value in heard))
    assert part.started == ["viewer"]
    assert "Starting Viewer" in swatch.window.messages.shown()["send"].what


def test_the_edited_paint_is_taken_and_searched_for(swatch, part, designer, command, names, qtbot) -> None:
    command(swatch, "take")
    assert "No paint is being edited" in swatch.window.messages.shown()["take"].what
    designer.publish("paint", paint_to_json(solid_paint("Fresh", (31.0, 5.0, -38.0))))
    qtbot.waitUntil(lambda: part.edited is not None)
    assert "take" not in swatch.window.messages.shown()
    command(swatch, "take")
    assert "Fresh" in names(swatch)
    assert swatch.session.selected_entries[0].name == "Fresh"
    command(swatch, "nearest_edited")
    assert names(swatch)[:2] == ["Fresh", "Blue"]


def test_a_paint_that_the_link_cannot_carry_is_reported(swatch, part, select, command) -> None:
    lobes = Entry(CookTorrancePaint("Lobes", (0.2, 0.1, 0.05)), id="lobes")
    swatch.session.edit("Add", lambda palette: type(palette)("L", (lobes,)))
    select(swatch, "Lobes")
    command(swatch, "to_lobes")
    assert "Cook-Torrance" in swatch.window.messages.shown()["send"].what
    assert part.started == []


@pytest.mark.parametrize(
    "value", [{}, {"to": "designer", "time": True, "paint": {}}, {"to": "designer", "time": 1.0, "paint": {}}]
)
def test_an_offer_that_is_none_is_refused(value: dict) -> None:
    with pytest.raises((SuiteError, ValueError)):
        document_checks()[OFFER](value)


@pytest.mark.parametrize("seconds", [True, "1", -1, 10**400, float("inf"), 2**41])
def test_an_offer_at_a_time_that_none_can_have_is_refused(seconds: object) -> None:
    offer = {"to": "designer", "time": 1.0, "paint": paint_to_json(solid_paint("Red", (50.0, 60.0, 40.0)))}
    document_checks()[OFFER](offer)
    with pytest.raises(BadMessageError, match="the time of an offer is a number of seconds"):
        document_checks()[OFFER](offer | {"time": seconds})
