"""Whatever is done to paints, as many undos give the identical ones: over every kind of edit that there is."""

from __future__ import annotations

from dataclasses import replace
from unittest.mock import create_autospec

import pytest
from brdf_designer.assembly import paint_format
from brdf_designer.controller import Controller, View
from brdf_designer.documents.tabs import Documents
from brdf_designer.session.fields import _EDITS, apply_edit
from brdf_designer.session.paint_session import Fitter, PaintSession
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from brdf_suite.appearance.geometries import GEOMETRY_SETS, Geometry
from brdf_suite.documents.paint import Flakes, OrangePeel
from brdf_suite.errors import UnreachableError
from brdf_suite.pipeline.material import load_shipped_paint

ODD = st.one_of(st.floats(-5, 120).map(lambda x: round(x, 2)), st.just(-1000.0), st.just(1e-9))
"""Numbers of a hand, and some that must be refused."""
FITTER_IS_NOT_ASKED = UnreachableError("What the paint is fitted to does not matter here.")


def of_reading(kind, fields):
    return lambda draw, paint: (
        (kind, draw(st.integers(0, len(paint.measurements) - 1)), *(draw(f) for f in fields))
    )


def labs(draw):
    return (draw(ODD), draw(ODD), draw(ODD))


def lab(draw, paint):
    return of_reading("lab", [st.integers(0, 2)])(draw, paint), draw(ODD)


def lch(draw, paint):
    return of_reading("lch", [st.integers(0, 2)])(draw, paint), (paint, draw(ODD), draw(ODD))


def together(draw, paint):
    key = ("together", draw(st.sampled_from(["lab", "lch"])), draw(st.integers(0, 2)))
    return key, (paint, draw(st.integers(0, len(paint.measurements) - 1)), draw(ODD), draw(ODD))


def flop(draw, paint):
    return ("flop", draw(st.sampled_from(["index", "lightness", "chroma", "hue"]))), (paint, draw(ODD))


def angles(draw, paint):
    what = draw(st.sampled_from(["set", "add", "remove"]))
    value = {
        "set": st.sampled_from(sorted(GEOMETRY_SETS)),
        "add": st.builds(Geometry, st.just(45.0), st.sampled_from([-15.0, 20.0, 25.0, 60.0, 75.0])),
        "remove": st.integers(0, len(paint.measurements) - 1),
    }[what]
    return ("angles", what), draw(value)


DRAWN = {
    "lab": lab,
    "lch": lch,
    "together": together,
    "flop": flop,
    "angles": angles,
    "colour": lambda draw, paint: (of_reading("colour", [])(draw, paint), labs(draw)),
    "gloss": lambda draw, _: (("gloss", draw(st.sampled_from(["gu_20", "gu_60"]))), draw(ODD)),
    "coat": lambda draw, _: (
        ("coat", draw(st.sampled_from(["ior", "roughness"]))),
        (draw(st.floats(1.3, 1.8)), draw(st.floats(0.001, 0.3))),
    ),
    "orange_peel": lambda draw, _: draw(
        st.sampled_from(
            [
                (("orange_peel",), None),
                (("orange_peel",), OrangePeel()),
                (("orange_peel", "amplitude_um"), 0.7),
                (("orange_peel", "wavelength_mm"), 9.0),
            ]
        )
    ),
    "flakes": lambda draw, _: draw(
        st.sampled_from([(("flakes",), None), (("flakes",), Flakes()), (("flakes", "size_um"), 33.0)])
    ),
    "solid": lambda draw, paint: (("solid",), draw(st.integers(0, len(paint.measurements) - 1))),
    "nearest": lambda draw, paint: (("nearest",), replace(paint, near_specular=draw(st.floats(0.5, 2.0)))),
    "interpolation": lambda draw, _: (
        ("interpolation",),
        draw(st.sampled_from(["flake", "monotone", "polynomial"])),
    ),
    "near_specular": lambda draw, _: (("near_specular",), draw(ODD)),
    "name": lambda draw, _: (("name",), draw(st.text("ab ", max_size=3))),
    "notes": lambda draw, _: (("notes",), draw(st.text("ab\n", max_size=3))),
    "source": lambda draw, _: (("source",), draw(st.text("ab\n", max_size=3))),
}
OTHERS = ("part", "undo", "redo", "go", "next_tab", "move_tab", "end")


@pytest.fixture
def desk(qapp, dialogs):
    fitter = create_autospec(Fitter, instance=True)
    fitter.fit.side_effect = FITTER_IS_NOT_ASKED
    view = create_autospec(View, instance=True)
    documents = Documents(load_shipped_paint("blue"), paint_format(), dialogs, pytest.fail)
    documents.add(load_shipped_paint("red"))
    documents.add(load_shipped_paint("copper"))
    desk = PaintSession(documents, fitter, lambda *_: None, view)
    desk.controller = Controller(view, desk)
    yield desk
    documents.keep_unsaved()


def test_every_kind_of_edit_is_drawn():
    assert set(DRAWN) == set(_EDITS)


def test_each_kind_can_change_the_paint(desk):
    """What is drawn below is no row of refusals."""
    for kind, value in (
        (("lch", 0, 1), (desk.paint, 20.0, 0.0)),
        (("together", "lab", 0), (desk.paint, 0, 70.0, 0.0)),
        (("flop", "index"), (desk.paint, 9.0)),
        (("angles", "add"), Geometry(45.0, 25.0)),
        (("coat", "ior"), (1.52, 0.01)),
    ):
        assert apply_edit(desk.paint, kind, value) != desk.paint, kind


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.data())
def test_any_edits_and_as_many_undos_give_the_identical_paints(desk, data):
    documents = desk.documents
    for document in documents.row:
        document.store.replace(document.original, None)
    before = {document.key: document.store.value for document in documents.row}
    for _ in range(data.draw(st.integers(1, 10))):
        act(desk, data.draw)
    after = {document.key: document.store.value for document in documents.row}
    assert set(after) == set(before)
    places = {document.key: document.store.stack.index() for document in documents.row}
    for document in documents.row:
        documents.show(document)
        for _ in range(places[document.key]):
            desk.undo()
        assert document.store.value == before[document.key]
        assert document.store.is_clean
        for _ in range(places[document.key]):
            desk.redo()
        assert document.store.value == after[document.key]


def act(desk, draw) -> None:
    """Do something that a user can do; now and then in the middle of a gesture."""
    what = draw(st.sampled_from([*DRAWN, *OTHERS]))
    if what in DRAWN:
        key, value = DRAWN[what](draw, desk.paint)
        if draw(st.booleans()):
            desk.controller.begin_gesture(key)
        desk.controller.edit(key, value)
    elif what == "part":
        # Another part of the desk edits by a step of its own, in a gesture or not.
        if draw(st.booleans()):
            desk.begin_gesture("Take")
        desk.edit(load_shipped_paint(draw(st.sampled_from(["champagne", "silver_metallic"]))), "Take")
    elif what == "go":
        desk.go_to(draw(st.integers(0, desk.documents.front.store.stack.count())))
    elif what == "move_tab":
        desk.documents.move(draw(st.integers(0, 1)), draw(st.integers(0, 1)))
    else:
        {
            "undo": desk.undo,
            "redo": desk.redo,
            "next_tab": lambda: desk.documents.step(1),
            "end": desk.end_gesture,
        }[what]()
