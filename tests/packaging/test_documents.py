"""Links and named files of the documents exist, the index lists every page, and the pages on the code equal it."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

from brdf_suite.library.reference import heading_anchor, list_pages

CODE_BLOCK = re.compile(r"^```.*?^```", re.DOTALL | re.MULTILINE)
LINK = re.compile(r"\]\((?![a-z]+:)([^)\s]+)\)")
HEADING = re.compile(r"^#+ (.*)$", re.MULTILINE)
NAMED_FILE = re.compile(r"`((?:apps|brdf_suite|docs|packaging|resources|tests)/[\w./*-]+\.\w+)`")
ROW = re.compile(r"^\| (\d+) \| ([^|]+) \|", re.MULTILINE)
ANSWER = re.compile(r"^\| (Where .+\?) \| `([^`]+)` \|$", re.MULTILINE)


def pages(checkout: Path) -> list[Path]:
    top = [checkout / name for name in ("README.md", "CONTRIBUTING.md", "SECURITY.md", "CHANGELOG.md")]
    return [*top, *sorted((checkout / "docs").rglob("*.md"))]


def anchors(page: Path) -> set[str]:
    """Return the anchors of a page's headings."""
    text = CODE_BLOCK.sub("", page.read_text(encoding="utf-8"))
    headings = (re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading) for heading in HEADING.findall(text))
    return {heading_anchor(heading) for heading in headings}


def broken_links(page: Path) -> list[str]:
    found = []
    for link in LINK.findall(CODE_BLOCK.sub("", page.read_text(encoding="utf-8"))):
        path, _, anchor = link.partition("#")
        target = page.parent / path if path else page
        if not target.exists() or (anchor and anchor not in anchors(target)):
            found.append(f"{page.name}: {link}")
    return found


def test_links_lead_to_pages_pictures_and_headings(checkout: Path) -> None:
    assert [link for page in pages(checkout) for link in broken_links(page)] == []


def test_a_broken_link_is_found(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text("# The page\n[a](page.md#the-page) [b](page.md#other) [c](none.md) [d](https://e.org)\n")
    assert broken_links(page) == ["page.md: page.md#other", "page.md: none.md"]


def test_the_list_has_every_page_once(checkout: Path) -> None:
    docs = checkout / "docs"
    listed = [page for chapter in list_pages(docs).values() for _, _, page in chapter]
    assert sorted(listed) == sorted(set(docs.rglob("*.md")) - {docs / "README.md"})
    rows = re.findall(r"^\| \[", (docs / "README.md").read_text(encoding="utf-8"), re.MULTILINE)
    assert len(rows) == len(listed)


def test_where_md_answers_questions_with_files(checkout: Path) -> None:
    answers = ANSWER.findall((checkout / "docs" / "development" / "where.md").read_text(encoding="utf-8"))
    assert len({question for question, _ in answers}) == len(answers) >= 30
    assert [path for _, path in answers if not (checkout / path).is_file()] == []


def test_files_that_a_page_names_exist(checkout: Path) -> None:
    missing = [
        f"{page.name}: {path}"
        for page in pages(checkout)
        for path in NAMED_FILE.findall(page.read_text(encoding="utf-8"))
        if not any(checkout.glob(path))
    ]
    assert missing == []


def drawn_rooms(checkout: Path) -> list[set[str]]:
    """Return the rooms of each row of the drawing, as modules."""
    text = (checkout / "docs" / "development" / "rooms.md").read_text(encoding="utf-8")
    rows = ROW.findall(text)
    assert [int(number) for number, _ in rows] == list(range(1, len(rows) + 1))
    return [
        {room.removeprefix("apps/").replace("/", ".") for room in re.findall(r"`([^`]+)`", rooms)}
        for _, rooms in rows
    ]


def test_the_drawing_of_the_rooms_is_the_import_contract(checkout: Path) -> None:
    settings = tomllib.loads((checkout / "pyproject.toml").read_text(encoding="utf-8"))
    (rows,) = (each for each in settings["tool"]["importlinter"]["contracts"] if each["id"] == "rows")
    assert drawn_rooms(checkout) == [set(re.findall(r"[\w.]+", layer)) for layer in rows["layers"]]


def test_every_room_of_the_code_is_in_the_drawing(checkout: Path) -> None:
    core, apps = checkout / "brdf_suite", checkout / "apps"
    there = {f"brdf_suite.{path.stem}" for path in core.glob("*.py")}
    there |= {f"brdf_suite.{path.parent.name}" for path in core.glob("*/__init__.py")}
    there |= {path.parent.name for path in apps.glob("*/__init__.py")}
    drawn = set().union(*drawn_rooms(checkout))
    assert there - {"brdf_suite.__init__", "brdf_suite.__main__", "brdf_suite.cli"} == drawn


def test_the_hand_offs_from_slider_to_pixel_are_numbered_and_counted(checkout: Path) -> None:
    text = (checkout / "docs" / "development" / "road.md").read_text(encoding="utf-8")
    numbers = [int(number) for number, _ in ROW.findall(text)]
    assert numbers == list(range(1, len(numbers) + 1))
    assert f"Hand-offs: {len(numbers)}." in text
