"""The description of a folder of photographs: read, written, and refused with the place of what is wrong."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from brdf_suite.acquisition.session.session import (
    Board,
    FlatField,
    Lens,
    Light,
    Position,
    Session,
    SessionCamera,
    Sphere,
    WhiteReference,
)
from brdf_suite.acquisition.session.store import (
    read_session,
    session_from_json,
    session_to_json,
    write_session,
)
from brdf_suite.errors import DocumentError, FileError, ValueRangeError

TIMES = (0.001, 0.002, 0.004)


def _files(stem: str) -> tuple[str, ...]:
    return tuple(f"{stem}/{k}.png" for k in range(3))


def _session() -> Session:
    return Session(
        "Grey ball",
        SessionCamera(
            2.0,
            0.1,
            16,
            "srgb",
            -2.5,
            ((0.9, 0.1, 0.0), (0.0, 1.0, 0.0), (0.0, 0.1, 0.9)),
            Lens(900.0, 901.0, 320.5, 240.25, -0.1),
            Board(9, 6, 0.025, ("board/0.png", "board/1.png")),
        ),
        Sphere(0.05, (0.0, 0.001, 0.0)),
        Light(0.7, 0.02, (3.0, 4.0, 5.0), ((0.0, 1.0), (20.0, 0.8)), 0.25, 0.01, 0.005),
        TIMES,
        (Position(0.0, _files("a")), Position(1.5, _files("b"), "b/mask.png")),
        WhiteReference(_files("white"), (10, 20, 30, 40)),
        _files("dark"),
        FlatField(("flat.png",), (0.01,)),
        "mask.png",
        "two lines\nof notes",
        "2026-11-21",
    )


def test_what_is_written_is_read_again(tmp_path: Path) -> None:
    path = write_session(_session(), tmp_path)
    assert path == tmp_path / "session.json"
    assert read_session(tmp_path) == _session()
    assert read_session(path) == _session()


def test_what_is_absent_is_left_out_of_the_file() -> None:
    least = Session("x", SessionCamera(2.0), Sphere(0.05), Light(0.7), TIMES, (Position(0.0, _files("a")),))
    written = session_to_json(least)
    assert set(written) == {
        "format",
        "version",
        "name",
        "camera",
        "sphere",
        "light",
        "exposures_s",
        "positions",
    }
    assert session_from_json(json.loads(json.dumps(written))) == least


def test_the_lamp_stands_where_the_angle_says() -> None:
    session = _session()
    assert session.light_m(0) == pytest.approx((0.7 * 0.00436331, 0.02, 0.7), abs=1e-5)  # an offset of 0.25°
    assert session.light_m(89.75) == pytest.approx((0.7, 0.02, 0.0), abs=1e-9)


def _broken(change: dict[str, object]) -> dict[str, object]:
    value = json.loads(json.dumps(session_to_json(_session())))
    for place, item in change.items():
        at = value
        *path, last = [int(step) if step.isdigit() else step for step in place.split(".")]
        for step in path:
            at = at[step]
        if item is None:
            del at[last]
        else:
            at[last] = item
    return value


@pytest.mark.parametrize(
    ("change", "place", "words"),
    [
        ({"format": "brdfpaint"}, "format", "expected"),
        ({"version": 2}, "version", "newer than this program"),
        ({"camera": None}, "the top level", '"camera" is missing'),
        ({"camera.distance_m": "2 m"}, "camera.distance_m", "expected a number"),
        ({"camera.bit_depth": 32}, "camera.bit_depth", "outside the range 8 to 16"),
        ({"camera.bit_depth": 12.5}, "camera.bit_depth", "a whole number"),
        ({"camera.response": "gamma"}, "camera.response", "unknown, linear, srgb"),
        ({"camera.lens": "50 mm"}, "camera", "'lens' is unknown"),
        ({"camera.to_working.1.1": 2.0}, "camera.to_working[1]", "sums to 2"),
        ({"camera.intrinsics.fx": -5.0}, "camera.intrinsics.fx", "outside the range"),
        ({"camera.board.columns": 1}, "camera.board.columns", "outside the range"),
        ({"sphere.radius_m": float("nan")}, "sphere.radius_m", "finite"),
        ({"sphere.radius_m": 3.0}, "camera.distance_m", "inside the sphere"),
        ({"light.distance_m": 0.02, "light.height_m": 0.0}, "light.distance_m", "inside the sphere"),
        ({"light.profile.1.0": 0.0}, "light.profile[1][0]", "not beyond"),
        ({"light.profile.0.0": 3.0}, "light.profile[0][0]", "starts at 0°"),
        ({"exposures_s.1": 0.0005}, "exposures_s[1]", "from the shortest to the longest"),
        ({"positions.1.angle_deg": -4.0}, "positions[1].angle_deg", "in order of their angles"),
        ({"positions.1.photographs.2": None}, "positions[1].photographs", "2 photographs for 3 exposures"),
        ({"positions.1.photographs.2": "a/0.png"}, "positions[1].photographs[2]", "the file of positions[0]"),
        ({"positions.0.photographs.0": "../a.png"}, "positions[0].photographs[0]", "outside the folder"),
        ({"positions.0.photographs.0": "/etc/passwd"}, "positions[0].photographs[0]", "outside the folder"),
        ({"positions.0.photographs.0": "a\\b.png"}, "positions[0].photographs[0]", "folders with /"),
        ({"positions.0.photographs": "a.png"}, "positions[0].photographs", "a list"),
        ({"white.region": [1, 2, 0, 4]}, "white.region[2]", "outside the range"),
        ({"white.photographs.0": None}, "white.photographs", "2 photographs for 3 exposures"),
        ({"flat_field.exposures_s": None}, "flat_field.photographs", "1 photographs for 3"),
        ({"dark.0": None}, "dark", "2 photographs for 3 exposures"),
    ],
)
def test_a_bad_field_is_named(change: dict[str, object], place: str, words: str) -> None:
    with pytest.raises(DocumentError, match=r"session\.json") as caught:
        session_from_json(_broken(change), "session.json")
    assert caught.value.place == place
    assert words in caught.value.reason


def test_a_folder_without_a_session_says_how_to_get_one(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="acquire --template"):
        read_session(tmp_path)
    with pytest.raises(FileError, match="not a folder"):
        read_session(tmp_path / "absent")


def test_a_session_has_positions() -> None:
    with pytest.raises(ValueRangeError, match="positions"):
        replace(_session(), positions=())
