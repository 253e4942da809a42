"""Menu entries, kinds of documents, icons and thumbnails on a desktop."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ET
from configparser import RawConfigParser
from pathlib import Path

import numpy as np
import pytest
from brdf_qt.program.suite import MEMBERS
from PIL import Image

import brdf_suite as bs
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.project import Project, save_project
from brdf_suite.processes import child_command
from brdf_suite.resources import resource

SCRIPT = Path(__file__).resolve().parents[2] / "packaging" / "frozen" / "desktop.py"


@pytest.fixture(scope="module")
def share(tmp_path_factory) -> Path:
    prefix = tmp_path_factory.mktemp("usr")
    subprocess.run([sys.executable, str(SCRIPT), str(prefix)], check=True, capture_output=True)
    return prefix / "share"


def entry_of(path: Path) -> RawConfigParser:
    parser = RawConfigParser(strict=True)
    parser.optionxform = str  # type: ignore[assignment, method-assign]
    parser.read(path, encoding="utf-8")
    return parser


def test_every_program_has_a_menu_entry_with_an_icon(share) -> None:
    found = {path.stem: entry_of(path)["Desktop Entry"] for path in (share / "applications").iterdir()}
    assert set(found) == {member.command for member in MEMBERS.values()}
    for member in MEMBERS.values():
        assert found[member.command]["Name"] == f"BRDF Suite {member.name}"
        assert found[member.command]["Icon"] == member.command
        for side in (16, 48, 256):
            icon = Image.open(share / f"icons/hicolor/{side}x{side}/apps/{member.command}.png")
            assert icon.size == (side, side)
            assert np.asarray(icon)[..., 3].max() == 255


def test_every_kind_of_document_has_a_program_an_icon_and_a_description(share) -> None:
    types = {
        kind for path in (share / "applications").iterdir()
        for kind in entry_of(path)["Desktop Entry"]["MimeType"].split(";") if kind
    }  # fmt: skip
    root = ET.fromstring((share / "mime/packages/brdf-suite.xml").read_text(encoding="utf-8"))
    described = {kind.get("type") for kind in root}
    kinds = ("brdfpaint", "brdfpalette", "brdfview", "brdfstudio", "brdfproject")
    assert types == described == {f"application/x-{kind}" for kind in kinds}
    for kind in kinds:
        assert (share / f"icons/hicolor/scalable/mimetypes/{kind}.svg").is_file()


@pytest.mark.skipif(shutil.which("update-mime-database") is None, reason="shared-mime-info is not installed")
@pytest.mark.skipif(shutil.which("gio") is None, reason="gio is not installed")
def test_documents_are_known_by_their_content(share, tmp_path) -> None:
    shutil.copytree(share / "mime", tmp_path / "data" / "mime")
    subprocess.run(["update-mime-database", str(tmp_path / "data" / "mime")], check=True, capture_output=True)
    shutil.copy(resource("paints", "blue.brdfpaint"), tmp_path / "a")
    bs.save(bs.View(), tmp_path / "b.brdfview")
    bs.save(Palette("p", (Entry(bs.load("blue", bs.Paint)),)), tmp_path / "c.brdfpalette")
    save_project(Project("d"), tmp_path / "d.brdfproject")
    for name in ("b.brdfview", "c.brdfpalette", "d.brdfproject"):
        (tmp_path / name).rename(tmp_path / name[0])
    environment = os.environ | {"XDG_DATA_HOME": str(tmp_path / "data")}
    for name, kind in zip("abcd", ("brdfpaint", "brdfview", "brdfpalette", "brdfproject"), strict=True):
        words = ["gio", "info", "-a", "standard::content-type", str(tmp_path / name)]
        found = subprocess.run(words, env=environment, capture_output=True, text=True, check=True)
        assert f"application/x-{kind}" in found.stdout


@pytest.mark.skipif(
    shutil.which("desktop-file-validate") is None, reason="desktop-file-utils is not installed"
)
def test_the_menu_entries_are_valid(share) -> None:
    files = [str(path) for path in (share / "applications").iterdir()]
    done = subprocess.run(["desktop-file-validate", *files], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (0, "")


@pytest.mark.skipif(shutil.which("appstreamcli") is None, reason="appstream is not installed")
def test_the_metadata_are_valid(share) -> None:
    (file,) = (share / "metainfo").iterdir()
    done = subprocess.run(
        ["appstreamcli", "validate", "--no-net", str(file)], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout


def test_an_appimage_starts_the_suite_and_describes_it(share, tmp_path) -> None:
    """The frozen suite is a script here, which prints what it is called with."""
    folder, appdir = tmp_path / "brdf-suite", tmp_path / "AppDir"
    folder.mkdir()
    (folder / "brdf-suite").write_text('#!/bin/sh\necho suite "$@"\n', encoding="utf-8")
    (folder / "brdf-suite").chmod(0o755)
    code = "import sys, build; from pathlib import Path; build.write_appdir(*map(Path, sys.argv[1:]))"
    words = [sys.executable, "-c", code, str(folder), str(appdir)]
    subprocess.run(words, cwd=SCRIPT.parent, check=True, capture_output=True)
    called = subprocess.run([appdir / "AppRun", "a b"], capture_output=True, text=True, check=True)
    assert called.stdout == "suite a b\n"
    (entry,) = appdir.glob("*.desktop")
    icon = appdir / f"{entry_of(entry)['Desktop Entry']['Icon']}.png"
    assert np.asarray(Image.open(icon)).shape == (256, 256, 4)
    assert (appdir / ".DirIcon").resolve() == (appdir / "brdf-suite.png").resolve()
    (described,) = (appdir / "usr/share/metainfo").iterdir()
    root = ET.fromstring(described.read_text(encoding="utf-8"))
    assert entry.stem == root.findtext("id")
    if shutil.which("desktop-file-validate"):
        subprocess.run(["desktop-file-validate", str(entry)], check=True)


def test_what_the_executable_is_called_says_what_it_opens() -> None:
    code = "import json, sys, entry; print(json.dumps(entry.command_words(sys.argv[1], sys.argv[2:])))"

    def words(*given: str) -> list[str]:
        command = [sys.executable, "-c", code, *given]
        done = subprocess.run(command, cwd=SCRIPT.parent, capture_output=True, text=True, check=True)
        return json.loads(done.stdout)

    assert words("/usr/bin/brdf-viewer", "--open", "a.brdfview") == ["viewer", "--open", "a.brdfview"]
    assert words("brdf-suite", "A.BRDFPAINT", "b.brdfpaint") == [
        "designer",
        "--open",
        "A.BRDFPAINT",
        "b.brdfpaint",
    ]
    assert words("/Applications/BRDF Suite.app/Contents/MacOS/brdf-suite") == ["designer"]
    assert words("brdf-suite", "render", "blue") == ["render", "blue"]
    assert words("brdf-designer", "--module", "brdf_viewer") == ["--module", "brdf_viewer"]
    opened = {kind: words("suite", f"a.{kind}")[0] for kind in ("brdfpalette", "brdfview", "brdfproject")}
    assert opened == {"brdfpalette": "swatch", "brdfview": "viewer", "brdfproject": "viewer"}


@pytest.mark.parametrize("module", ["brdf_suite", "brdf_viewer"])
def test_the_frozen_command_runs_modules_of_its_own_without_a_warning(module: str) -> None:
    """Windows take what a command prints on standard error for its fault."""
    command = [sys.executable, str(SCRIPT.with_name("entry.py")), "--module", module, "--help"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("usage: ")


def test_a_thumbnailer_draws_paints_and_palettes(share, tmp_path) -> None:
    bs.save(
        Palette("p", tuple(Entry(bs.load(name, bs.Paint), name) for name in ("blue", "red", "copper"))),
        tmp_path / "three.brdfpalette",
    )
    shutil.copy(resource("paints", "red.brdfpaint"), tmp_path / "red.brdfpaint")
    words = entry_of(share / "thumbnailers" / "brdf-suite.thumbnailer")["Thumbnailer Entry"]["Exec"].split()
    assert words[0] == "brdf-suite"
    for name, across in (("red.brdfpaint", 1), ("three.brdfpalette", 2)):
        places = {"%i": str(tmp_path / name), "%o": str(tmp_path / f"{name}.png"), "%s": "64"}
        arguments = [places.get(word, word) for word in words[1:]]
        done = subprocess.run(
            child_command("brdf_suite", *arguments), capture_output=True, text=True, check=False
        )
        assert (done.returncode, done.stdout) == (0, ""), done.stderr
        pixels = np.asarray(Image.open(tmp_path / f"{name}.png"))
        assert pixels.shape == (64, 64, 4)
        # Of three paints in two rows the last place is empty.
        assert (pixels[40:, 40:, 3] == 0).all() == (across == 2)
    red = np.asarray(Image.open(tmp_path / "red.brdfpaint.png"))[24:40, 24:40].mean(axis=(0, 1))
    assert red[0] > 1.5 * red[2]


def test_a_thumbnail_of_something_else_is_one_line(tmp_path) -> None:
    (tmp_path / "a.brdfpaint").write_text("{", encoding="utf-8")
    words = ("thumbnail", str(tmp_path / "a.brdfpaint"), "-o", str(tmp_path / "a.png"))
    done = subprocess.run(child_command("brdf_suite", *words), capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert len(done.stderr.splitlines()) == 1
    assert not (tmp_path / "a.png").exists()
