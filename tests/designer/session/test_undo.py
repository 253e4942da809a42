"""Whatever is done to paints, as many undos give the identical ones: over every kind of edit that there is."""

from __future__ import annotations

from unittest.mock import create_autospec

import pytest
from brdf_designer.assembly import paint_format
from brdf_designer.controller import Controller
from brdf_designer.documents.tabs import Documents
from brdf_designer.session.edits import (
    AddAngle,
    Edit,
    MakeSolid,
    MoveAll,
    MoveInPlane,
    PickColour,
    RemoveAngle,
    SetCoat,
    SetField,
    SetFlop,
    SetLab,
    SetLch,
    SetNumber,
    TurnHues,
    UseAngles,
)
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.window.window import DesignerWindow
from brdf_qt.documents.file_reading import FileReading
from brdf_qt.window.progress_strip import ProgressStrip
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from brdf_suite.appearance.geometries import GEOMETRY_SETS, Geometry
from brdf_suite.documents.paint import Flakes, OrangePeel, Paint
from brdf_suite.errors import UnreachableError
from brdf_suite.pipeline.lobe_fit import PaintFitter
from brdf_suite.pipeline.material import load_shipped_paint

ODD = st.one_of(st.floats(-5, 120).map(lambda x: round(x, 2)), st.just(-1000.0), st.just(1e-9))
"""Numbers of a hand, and some that must be refused."""
FITTER_IS_NOT_ASKED = UnreachableError("What the paint is fitted to does not matter here.")


def edits(paint: Paint) -> dict[type[Edit], st.SearchStrategy[Edit]]:
    """Return what draws each kind of edit of a paint."""
    readings, components = st.integers(0, len(paint.measurements) - 1), st.integers(0, 2)
    return {
        SetLab: st.builds(SetLab, readings, components, ODD),
        SetLch: st.builds(SetLch, readings, components, ODD, ODD),
        MoveAll: st.builds(MoveAll, st.sampled_from(["lab", "lch"]), readings, components, ODD, ODD),
        SetFlop: st.builds(SetFlop, st.sampled_from(["index", "lightness", "chroma", "hue"]), ODD),
        PickColour: st.builds(PickColour, readings, st.tuples(ODD, ODD, ODD)),
        MoveInPlane: st.builds(MoveInPlane, readings, ODD, ODD, st.booleans()),
        TurnHues: st.builds(TurnHues, ODD),
        UseAngles: st.builds(UseAngles, st.sampled_from(sorted(GEOMETRY_SETS))),
        AddAngle: st.builds(
            AddAngle, st.builds(Geometry, st.just(45.0), st.sampled_from([-15.0, 20.0, 25.0, 60.0, 75.0]))
        ),
        RemoveAngle: st.builds(RemoveAngle, readings),
        SetNumber: st.one_of(
            st.builds(SetNumber, st.sampled_from(["gloss.gu_20", "gloss.gu_60", "near_specular"]), ODD),
            st.sampled_from(
                [
                    SetNumber("orange_peel.amplitude_um", 0.7),
                    SetNumber("orange_peel.wavelength_mm", 9.0),
                    SetNumber("flakes.size_um", 33.0),
                ]
            ),
        ),
        SetCoat: st.builds(
            SetCoat, st.sampled_from(["ior", "roughness"]), st.floats(1.3, 1.8), st.floats(0.001, 0.3)
        ),
        MakeSolid: st.builds(MakeSolid, readings),
        SetField: st.one_of(
            st.builds(SetField, st.sampled_from(["name", "notes", "source"]), st.text("ab \n", max_size=3)),
            st.builds(
                SetField, st.just("interpolation"), st.sampled_from(["flake", "monotone", "polynomial"])
            ),
            st.builds(SetField, st.just("orange_peel"), st.sampled_from([None, OrangePeel()])),
            st.builds(SetField, st.just("flakes"), st.sampled_from([None, Flakes()])),
        ),
    }


OTHERS = ("part", "undo", "redo", "go", "next_tab", "move_tab", "end")


@pytest.fixture
def session(qapp, dialogs):
    fitter = create_autospec(PaintFitter, instance=True)
    fitter.fit.side_effect = FITTER_IS_NOT_ASKED
    view = create_autospec(DesignerWindow, instance=True)
    documents = Documents(
        load_shipped_paint("blue"), paint_format(), dialogs, FileReading(ProgressStrip()), pytest.fail
    )
    documents.add(load_shipped_paint("red"))
    documents.add(load_shipped_paint("copper"))
    session = PaintSession(documents, fitter, lambda *_: None, view)
    Controller(view, session, session)
    yield session
    documents.keep_unsaved()


def test_every_kind_of_edit_is_drawn():
    assert set(edits(load_shipped_paint("blue"))) == set(Edit.__subclasses__())


def test_each_kind_can_change_the_paint(session):
    """What is drawn below is no row of refusals."""
    for edit in (
        SetLch(0, 1, 20.0, 0.0),
        MoveAll("lab", 0, 0, 70.0, 0.0),
        SetFlop("index", 9.0),
        MoveInPlane(0, 30.0, 10.0),
        TurnHues(40.0),
        AddAngle(Geometry(45.0, 25.0)),
        SetCoat("ior", 1.52, 0.01),
    ):
        assert edit.apply(session.paint) != session.paint, edit


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.data())
def test_any_edits_and_as_many_undos_give_the_identical_paints(session, data):
    documents = session.documents
    for document in documents.row:
        document.store.replace(document.original, None)
    before = {document.key: document.store.value for document in documents.row}
    for _ in range(data.draw(st.integers(1, 10))):
        act(session, data.draw)
    after = {document.key: document.store.value for document in documents.row}
    assert set(after) == set(before)
    places = {document.key: document.store.stack.index() for document in documents.row}
    for document in documents.row:
        documents.show(document)
        for _ in range(places[document.key]):
            session.undo()
        assert document.store.value == before[document.key]
        assert document.store.is_clean
        for _ in range(places[document.key]):
            session.redo()
        assert document.store.value == after[document.key]


def act(session, draw) -> None:
    """Do something that a user can do; now and then in the middle of a gesture."""
    what = draw(st.sampled_from([*Edit.__subclasses__(), *OTHERS]))
    if what not in OTHERS:
        if draw(st.booleans()):
            session.begin_gesture()
        session.edit(draw(edits(session.paint)[what]))
    elif what == "part":
        # Another part of Designer edits by a step of its own, in a gesture or not.
        if draw(st.booleans()):
            session.begin_gesture()
        session.set_paint(load_shipped_paint(draw(st.sampled_from(["champagne", "silver_metallic"]))), "Take")
    elif what == "go":
        session.go_to(draw(st.integers(0, session.documents.front.store.stack.count())))
    elif what == "move_tab":
        session.documents.move(draw(st.integers(0, 1)), draw(st.integers(0, 1)))
    else:
        {
            "undo": session.undo,
            "redo": session.redo,
            "next_tab": lambda: session.documents.step(1),
            "end": session.end_gesture,
        }[what]()
