"""What Designer does with a paint that a palette hands it."""

from __future__ import annotations

import time

import pytest
from brdf_designer.assembly import paint_format
from brdf_designer.documents.paint_offer import PaintOffer
from brdf_designer.documents.tabs import Documents
from brdf_qt.documents.file_reading import FileReading
from brdf_qt.window.progress_strip import ProgressStrip

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.store import paint_to_json

BLUE = solid_paint("Blue", (30.0, 5.0, -40.0))


@pytest.fixture
def documents(qapp, dialogs):
    """Designer's documents, with one that is worked at."""
    found = Documents(
        solid_paint("First", (50.0, 0.0, 0.0)),
        paint_format(),
        dialogs,
        FileReading(ProgressStrip()),
        lambda error: None,
    )
    found.front.store.set(solid_paint("Mine", (51.0, 0.0, 0.0)), "edit")
    yield found
    for document in found.row:
        document.recovery.close(keep=False)


def test_it_opens_beside_what_is_worked_at(documents) -> None:
    offer = {"to": "designer", "time": time.time(), "paint": paint_to_json(BLUE)}
    PaintOffer(documents).received("offer", offer)
    assert [document.store.value.name for document in documents.row] == ["Mine", "Blue"]
    assert documents.front.store.value == BLUE


@pytest.mark.parametrize("change", [{"to": "viewer"}, {"time": time.time() - 3600.0}])
def test_what_is_for_another_or_of_an_hour_ago_is_left(documents, change: dict) -> None:
    offer = {"to": "designer", "time": time.time(), "paint": paint_to_json(BLUE)}
    PaintOffer(documents).received("offer", {**offer, **change})
    PaintOffer(documents).received("paint", paint_to_json(BLUE))
    assert len(documents.row) == 1
