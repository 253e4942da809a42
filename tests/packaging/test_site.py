"""The site of the documents is built without a warning and without a network, and its generated pages are current."""

from __future__ import annotations

import dataclasses
import json
import re
import subprocess
import sys
from collections.abc import Callable
from html.parser import HTMLParser
from pathlib import Path

import pytest

import brdf_suite as bs
from brdf_suite.acquisition.session.session import (
    Board,
    FlatField,
    Light,
    Position,
    Session,
    SessionCamera,
    Sphere,
)
from brdf_suite.acquisition.session.store import session_from_json
from brdf_suite.cli.tools.bench import load_module
from brdf_suite.documents.cook_torrance import Clearcoat, CookTorranceLobe, CookTorrancePaint
from brdf_suite.documents.factored import FactoredPaint, TextureFile
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import OrangePeel, TextureTargets
from brdf_suite.documents.palette import Group
from brdf_suite.documents.palette_store import palette_from_json
from brdf_suite.documents.project import Project, ProjectPicture, project_from_json
from brdf_suite.documents.store import any_paint_from_json, view_from_json
from brdf_suite.documents.studio import Backdrop, BoothRoom, Sky, Studio, StudioLamp, light_from_json
from brdf_suite.documents.view import Camera
from brdf_suite.documents.view_settings import (
    Compare,
    Lamp,
    Lens,
    LightColour,
    Relief,
    Sparkle,
    SurfaceLook,
    TwoTone,
)
from brdf_suite.library.reference import list_pages

LOADED = {"script": "src", "link": "href", "img": "src", "iframe": "src", "source": "src"}
"""Elements by which a page loads what it needs, and their attributes."""


class Loads(HTMLParser):
    """Collects the addresses that a page loads from, and its links."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.loaded: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        address = dict(attrs).get(LOADED.get(tag, ""))
        if address:
            self.loaded.append(address)


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The site, built with warnings as errors."""
    folder = tmp_path_factory.mktemp("site")
    checkout = Path(__file__).resolve().parents[2]
    done = subprocess.run(
        [
            sys.executable,
            "-m",
            "mkdocs",
            "build",
            "--strict",
            "-q",
            "-f",
            "packaging/mkdocs.yml",
            "-d",
            str(folder),
        ],
        cwd=checkout,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return folder


def test_every_page_of_the_list_is_in_the_site_and_in_its_order(site: Path, checkout: Path) -> None:
    docs = checkout / "docs"
    pages = [
        page.relative_to(docs).with_suffix(".html").as_posix()
        for c in list_pages(docs).values()
        for _, _, page in c
    ]
    assert {page.relative_to(site).as_posix() for page in site.rglob("*.html")} == {
        *pages,
        "index.html",
        "404.html",
    }
    menu = (site / "index.html").read_text(encoding="utf-8")
    assert [
        link for link in re.findall(r'<a href="([^"]+)" class="md-nav__link"', menu) if link in pages
    ] == pages


def test_no_page_loads_anything_from_elsewhere(site: Path) -> None:
    for page in site.rglob("*.html"):
        loaded = Loads(page.read_text(encoding="utf-8")).loaded
        assert loaded
        assert [address for address in loaded if re.match(r"\w+:|//", address)] == [], page
    for style in site.rglob("*.css"):
        assert re.findall(r"url\(['\"]?(?:https?:)?//", style.read_text(encoding="utf-8")) == [], style


def test_the_library_and_the_tables_are_rendered(site: Path) -> None:
    text = (site / "library" / "reference.html").read_text(encoding="utf-8")
    assert len(re.findall(r'<h3 id="brdf_suite\.\w+"', text)) == len(set(bs.__all__) - {"__version__"})
    assert "L*a*b*" in text
    assert ":class:" not in text
    assert "<code>sqrt&#124;h&#124;</code>" in (site / "method" / "factorization.html").read_text("utf-8")


def test_the_page_of_the_commands_is_what_their_parsers_say(checkout: Path) -> None:
    page = load_module(checkout / "packaging" / "documents" / "command_page.py").command_page()
    assert (checkout / "docs" / "command" / "reference.md").read_text(encoding="utf-8") == page, (
        "run .venv/bin/python packaging/documents/command_page.py"
    )


READERS: dict[str, Callable[[object], object]] = {
    "brdfpaint": any_paint_from_json,
    "brdfpalette": palette_from_json,
    "brdfview": view_from_json,
    "brdfstudio": light_from_json,
    "brdfproject": lambda value: project_from_json(value, "the page", Path(), set()),
    "brdf-suite acquisition session": lambda value: session_from_json(value, Path("session.json")),
}
FIELDS: dict[str, tuple[type, ...]] = {
    "brdfpaint": (
        bs.Paint, bs.Measurement, bs.Gloss, bs.Flakes, OrangePeel, TextureTargets,
        CookTorrancePaint, CookTorranceLobe, Clearcoat, FactoredPaint, TextureFile,
    ),
    "brdfpalette": (bs.Palette, Group, FlatColour),
    "brdfview": (bs.View, Camera, Compare, Lamp, Lens, LightColour, Relief, Sparkle, SurfaceLook, TwoTone),
    "brdfstudio": (Studio, Sky, StudioLamp, BoothRoom, Backdrop),
    "brdfproject": (Project, ProjectPicture),
    "session": (Session, SessionCamera, Sphere, Light, Board, FlatField, Position),
}  # fmt: skip


def test_every_example_of_an_own_format_can_be_read(checkout: Path) -> None:
    found = set()
    for page in (checkout / "docs" / "formats").glob("*.md"):
        for block in re.findall(
            r"^```json\n(.*?)^```", page.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE
        ):
            value = json.loads(block)
            READERS[value["format"]](value)
            found.add(value["format"])
    assert found == set(READERS)


@pytest.mark.parametrize("page", sorted(FIELDS))
def test_a_page_names_every_field_of_its_format(page: str, checkout: Path) -> None:
    text = (checkout / "docs" / "formats" / f"{page}.md").read_text(encoding="utf-8")
    named = set(re.findall(r"\w+", " ".join(re.findall(r"`[^`\n]+`|\"\w+\":", text))))
    for kind in FIELDS[page]:
        assert {field.name for field in dataclasses.fields(kind)} - named == set(), kind
