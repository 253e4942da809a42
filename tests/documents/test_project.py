"""Projects: all that is saved comes back, collected files go along, and damaged or hostile files are refused."""

from __future__ import annotations

import io
import json
import struct
import zipfile
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from brdf_suite.documents import project as module
from brdf_suite.documents.paint import Gloss, solid_paint
from brdf_suite.documents.project import (
    MANIFEST,
    NamedView,
    Project,
    ProjectPicture,
    load_project,
    project_from_json,
    project_parts,
    project_references,
    project_to_json,
    save_project,
)
from brdf_suite.documents.store import view_to_json
from brdf_suite.documents.studio import Sky
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Compare, Relief, TwoTone
from brdf_suite.errors import DocumentError, FileError, SuiteError, ValueRangeError

NAMES = st.text(st.characters(codec="utf-8", exclude_categories=("C", "Z")), min_size=1, max_size=30)
VIEW = view_to_json(View())
LAB = st.tuples(st.floats(0.0, 100.0), st.floats(-80.0, 80.0), st.floats(-80.0, 80.0))
PAINTS = st.builds(solid_paint, NAMES, LAB, st.builds(Gloss, st.floats(1.0, 90.0)))
VIEWS = st.builds(
    View,
    environment=st.sampled_from(["booth", "sunny", "/maps/a.exr", "C:\\maps\\b.hdr"]),
    rotation_deg=st.floats(-180.0, 180.0),
    exposure_ev=st.floats(-4.0, 4.0),
    two_tone=st.builds(TwoTone, mask=st.none() | st.just("/masks/m.png")),
)


@st.composite
def projects(draw: st.DrawFn) -> Project:
    names = draw(st.lists(NAMES, max_size=4, unique=True))
    views = tuple(NamedView(name, draw(VIEWS)) for name in names)
    pictures = st.builds(
        ProjectPicture, NAMES, st.sampled_from(names or ["x"]), st.integers(1, 9000), st.integers(1, 9000)
    )
    return Project(
        draw(NAMES),
        tuple(draw(st.lists(PAINTS, max_size=3))),
        draw(st.none() | PAINTS),
        views,
        tuple(draw(st.lists(st.builds(Sky, NAMES), max_size=2))),
        draw(st.sampled_from(["", "/data/blue.binary", "D:\\blue.binary"])),
        tuple(draw(st.lists(pictures, max_size=3))) if names else (),
        draw(st.text(st.sampled_from("ab \n"), max_size=20)),
    )


@given(projects(), st.booleans())
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_all_that_is_saved_comes_back(tmp_path_factory, project: Project, folder: bool) -> None:
    path = tmp_path_factory.mktemp("project") / "a.brdfproject"
    assert save_project(project, path, folder=folder) == ()
    assert path.is_dir() is folder
    assert load_project(path) == project
    assert project_parts(path) == ()
    plain = json.loads(json.dumps(project_to_json(project)))
    assert project_from_json(plain, path, path.parent, set()) == project


@pytest.fixture
def named(tmp_path: Path) -> Project:
    """A project that names five files, two of one name."""
    for name in ("one/map.exr", "two/map.exr", "one/Mesh é.glb", "one/mask.png", "one/blue.binary"):
        file = tmp_path / name
        file.parent.mkdir(exist_ok=True)
        file.write_bytes(name.encode() * 1000)
    at = {
        name: str(tmp_path / name)
        for name in ("one/map.exr", "two/map.exr", "one/Mesh é.glb", "one/mask.png")
    }
    first = View(environment=at["one/map.exr"], surface=at["one/Mesh é.glb"])
    second = View(
        environment=at["two/map.exr"],
        relief=Relief(normal_map=at["one/mask.png"]),
        two_tone=TwoTone("silver_metallic", at["one/mask.png"]),
        compare=Compare(paint="blue"),
    )
    paint = solid_paint("Blue", (30.0, 5.0, -40.0))
    return Project(
        "Spring",
        (paint,),
        views=(NamedView("Day", first), NamedView("Night", second)),
        source=str(tmp_path / "one/blue.binary"),
        pictures=(ProjectPicture("Poster", "Day"),),
    )


@pytest.mark.parametrize("folder", [False, True])
def test_what_is_named_is_collected_and_found_where_it_is_unpacked(
    named: Project, tmp_path: Path, folder: bool
) -> None:
    path = tmp_path / "out.brdfproject"
    collected = save_project(named, path, collect=True, folder=folder)
    assert len(set(collected)) == 5
    assert dict(project_parts(path)).keys() == set(collected)
    before = {Path(name).read_bytes() for name in project_references(named)}
    for name in project_references(named):
        Path(name).unlink()
    into = tmp_path / "elsewhere"
    back = load_project(path, into)
    after = project_references(back)
    assert {Path(name).read_bytes() for name in after} == before
    assert all(Path(name).is_relative_to(path if folder else into) for name in after)
    assert [view.name for view in back.views] == ["Day", "Night"]
    assert back.views[1].view.compare.paint == "blue"
    assert back.views[1].view.two_tone.paint == "silver_metallic"
    # Looked at without unpacking, it is the same project.
    listed = load_project(path)
    assert (listed.name, listed.paints, listed.pictures) == (named.name, named.paints, named.pictures)


def test_a_missing_file_is_named_and_nothing_is_written(named: Project, tmp_path: Path) -> None:
    (tmp_path / "one/mask.png").unlink()
    with pytest.raises(FileError, match="not there") as caught:
        save_project(named, tmp_path / "out.brdfproject", collect=True)
    assert caught.value.path.endswith("mask.png")
    assert not (tmp_path / "out.brdfproject").exists()
    full = tmp_path / "full"
    full.mkdir()
    (full / "mine.txt").write_text("mine")
    with pytest.raises(FileError, match="not empty"):
        save_project(named, full, folder=True)


def test_a_collected_file_that_has_gone_is_reported(named: Project, tmp_path: Path) -> None:
    folder = tmp_path / "out"
    save_project(named, folder, collect=True, folder=True)
    assert len(project_parts(folder)) > 1
    (folder / "files/gone.png").symlink_to(tmp_path / "nowhere")
    with pytest.raises(FileError, match="cannot be read: No such file"):
        project_parts(folder)


@pytest.mark.parametrize(
    ("change", "place", "words"),
    [
        ({"format": "brdfview"}, "format", 'expected "brdfproject"'),
        ({"version": 2}, "version", "newer than this program"),
        ({"name": 7}, "name", "expected a text"),
        ({"paints": {}}, "paints", "expected a list"),
        ({"paints": [{"format": "brdfpaint", "version": 5}]}, "paints[0]", "missing"),
        ({"paints": [0] * 1001}, "paints", "more than the 1000"),
        ({"standard": 3}, "standard", "expected an object"),
        ({"views": [{"name": "A"}]}, "views[0]", "missing"),
        ({"views": [{"name": "A", "view": {**VIEW, "rotation_deg": "x"}}]}, "views[0].view.rotation_deg", "number"),
        ({"pictures": [{"name": "P", "view": "none"}]}, "pictures[0].view", "no view"),
        ({"pictures": [{"name": "P", "view": "Day", "width": 0}]}, "pictures[0].width", "whole number"),
        ({"source": "data/x"}, "source", "absolute path"),
        ({"source": "project:files/../../etc"}, "source", "no collected file"),
        ({"surprise": 1}, "the top level", "unknown"),
    ],
)  # fmt: skip
def test_a_bad_field_is_named(named: Project, change: dict, place: str, words: str) -> None:
    plain = {**json.loads(json.dumps(project_to_json(named))), **change}
    if "views" in change or "paints" in change:
        plain["pictures"] = []
    with pytest.raises(DocumentError, match=words) as caught:
        project_from_json(plain, "a.brdfproject", Path("/nowhere"), set())
    assert caught.value.place == place


def packed(*parts: tuple[str, bytes]) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in parts:
            archive.writestr(name, content)
    return buffer.getvalue()


GOOD = json.dumps(project_to_json(Project("Good"))).encode()


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "damaged"),
        (b"PK\3\4nothing", "damaged"),
        (GOOD, "damaged"),
        (packed(("files/a.exr", b"a")), "without project.json"),
        (packed((MANIFEST, GOOD), ("files/../../evil", b"a")), "plain files"),
        (packed((MANIFEST, GOOD), ("/etc/passwd", b"a")), "plain files"),
        (packed((MANIFEST, GOOD), ("files/..", b"a")), "plain files"),
        (packed((MANIFEST, GOOD), ("files/.hidden", b"a")), "plain files"),
        (packed((MANIFEST, GOOD), ("files/a/b", b"a")), "plain files"),
        (packed((MANIFEST, GOOD), ("files/a", b"a"), ("files/A", b"b")), "there twice"),
        (packed((MANIFEST, b"[" * 100_000)), "nested too deep"),
        (packed((MANIFEST, b" " * (17 << 20))), "larger than"),
        (packed((MANIFEST, GOOD), *((f"files/{n}", b"") for n in range(2001))), "more than the 2,000"),
        (packed((MANIFEST, GOOD))[:-30], "damaged"),
    ],
)
def test_a_damaged_or_hostile_file_is_refused_and_nothing_is_unpacked(
    tmp_path: Path, content: bytes, words: str
) -> None:
    path, into = tmp_path / "bad.brdfproject", tmp_path / "into" / "deep"
    path.write_bytes(content)
    with pytest.raises(FileError, match=words) as caught:
        load_project(path, into)
    assert str(path) in str(caught.value)
    assert not any(file.is_file() for file in tmp_path.rglob("*") if file != path)


def test_a_bomb_is_stopped_where_it_unpacks_to_too_much(tmp_path: Path, monkeypatch) -> None:
    path = tmp_path / "bomb.brdfproject"
    content = packed((MANIFEST, GOOD), ("files/a.exr", bytes(1 << 20)))
    # The directory says that it is small.
    at = content.rindex(b"files/a.exr") - 46
    path.write_bytes(content)
    assert content[at : at + 4] == b"PK\1\2"
    assert struct.unpack_from("<I", content, at + 24)[0] == 1 << 20
    monkeypatch.setattr(module, "LARGEST_UNPACKED", 1 << 19)
    with pytest.raises(FileError, match="unpacks to more"):
        load_project(path, tmp_path / "into")
    assert not (tmp_path / "into" / "files" / "a.exr").exists()


@given(st.binary(max_size=300), st.integers(0, 2000))
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_no_content_makes_anything_but_an_error_of_ours(tmp_path_factory, noise: bytes, at: int) -> None:
    folder = tmp_path_factory.mktemp("noise")
    content = packed((MANIFEST, GOOD), ("files/a.exr", b"abc" * 50))
    at %= len(content)
    (folder / "x.brdfproject").write_bytes(content[:at] + noise + content[at + len(noise) :])
    with suppress(SuiteError):
        load_project(folder / "x.brdfproject", folder / "into")
    outside = [file for file in folder.rglob("*") if file.is_file() and file.parent.name != "files"]
    assert outside == [folder / "x.brdfproject"]


@pytest.mark.parametrize(
    "wrong",
    [
        {"name": ""}, {"paints": (3,)}, {"standard": "blue"}, {"source": "relative"}, {"lights": (View(),)},
        {"views": (NamedView("A", View()), NamedView("A", View()))}, {"notes": "\0"},
    ],
)  # fmt: skip
def test_what_no_project_can_have_is_refused(wrong: dict) -> None:
    with pytest.raises(ValueRangeError):
        replace(Project("Good"), **wrong)
