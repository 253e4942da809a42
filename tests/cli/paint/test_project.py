"""``brdf-suite project``: packed, listed, collected and unpacked, from files to files."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from brdf_suite.cli.main import main
from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.project import load_project, project_references
from brdf_suite.documents.store import save_paint, save_view
from brdf_suite.documents.view import View

Capture = pytest.CaptureFixture[str]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with a paint, an environment, and a view that names it."""
    save_paint(solid_paint("Sea", (30.0, 0.0, -30.0)), tmp_path / "sea.brdfpaint")
    (tmp_path / "sky.exr").write_bytes(b"sky")
    (tmp_path / "blue.binary").write_bytes(b"table")
    save_view(View(environment=str(tmp_path / "sky.exr")), tmp_path / "day.brdfview")
    return tmp_path


def pack(folder: Path, *more: str) -> Path:
    out = folder / "spring.brdfproject"
    words = [
        "--paint", str(folder / "sea.brdfpaint"), "--paint", "red", "--standard", "blue", "--view",
        str(folder / "day.brdfview"), "--source", str(folder / "blue.binary"), "--picture", "day:800x600",
    ]  # fmt: skip
    assert main(["project", "pack", "-o", str(out), *words, *more]) == 0
    return out


def test_a_project_is_packed_listed_and_collected(folder: Path, capsys: Capture) -> None:
    out = pack(folder)
    assert "2 paints, 1 views, 0 lights, 1 pictures, 0 files collected" in capsys.readouterr().out
    assert main(["project", "list", str(out)]) == 0
    listed = capsys.readouterr().out
    for words in ("spring", "Sea", "Red", "standard  Blue", "day, 800×600 of day", str(folder / "sky.exr")):
        assert words in listed
    whole = folder / "whole.brdfproject"
    assert main(["project", "collect", str(out), "-o", str(whole), "--json"]) == 0
    assert sorted(json.loads(capsys.readouterr().out)["collected"]) == ["blue.binary", "sky.exr"]
    (folder / "sky.exr").unlink()
    unpacked = folder / "unpacked"
    assert main(["project", "unpack", str(whole), "-o", str(unpacked)]) == 0
    project = load_project(unpacked)
    assert [Path(name).read_bytes() for name in project_references(project)] == [b"sky", b"table"]
    assert all(Path(name).is_relative_to(unpacked) for name in project_references(project))
    # A folder that is moved is still whole.
    moved = unpacked.rename(folder / "moved")
    assert all(Path(name).is_file() for name in project_references(load_project(moved)))
    capsys.readouterr()
    assert main(["project", "list", str(whole), "--json"]) == 0
    assert {one["name"] for one in json.loads(capsys.readouterr().out)["files"]} == {"blue.binary", "sky.exr"}


def test_what_cannot_be_packed_is_said(folder: Path, capsys: Capture) -> None:
    out = folder / "bad.brdfproject"
    (folder / "sky.exr").unlink()
    words = ["--view", str(folder / "day.brdfview")]
    assert main(["project", "pack", "-o", str(out), *words, "--collect"]) == 1
    assert "sky.exr" in capsys.readouterr().err
    assert main(["project", "pack", "-o", str(out), *words, "--picture", "night:10x10"]) == 1
    assert "night" in capsys.readouterr().err
    assert main(["project", "pack", "-o", str(out), "--picture", "day"]) == 1
    assert not out.exists()
    assert main(["project", "unpack", str(folder / "sea.brdfpaint"), "-o", str(folder)]) == 1
    assert "not an empty folder" in capsys.readouterr().err
