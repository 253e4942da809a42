"""Pages for users are short: all of them together, each sentence, and the README."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import brdf_suite as bs

FOLDERS = ("start", "guides", "formats", "library", "command")
GENERATED = {Path("command/reference.md"), Path("library/reference.md")}
MOST_WORDS = 15_000
LONGEST_SENTENCE = 25
LONGEST_README = 90

CODE = re.compile(r"^```.*?^```|^    .*?$|<!--.*?-->", re.DOTALL | re.MULTILINE)
LINK = re.compile(r"!?\[([^]]*)\]\([^)]*\)")
BLOCK = re.compile(r"\n\s*\n|\n(?=\s*(?:[-*] |\d+\. |\||#))|^\|[-|]+\|$", re.MULTILINE)
SENTENCE = re.compile(r"(?<=[.!?])[*)”]*\s+")
WORD = re.compile(r"\w")


def user_pages(checkout: Path) -> list[Path]:
    """Return the pages for users that people write, without those made from the code."""
    docs = checkout / "docs"
    pages = [page for folder in FOLDERS for page in sorted((docs / folder).rglob("*.md"))]
    return [page for page in pages if page.relative_to(docs) not in GENERATED]


def sentences(text: str) -> list[str]:
    """Return the sentences of a page: of paragraphs, headings, items of lists, and cells of tables."""
    text = LINK.sub(r"\1", CODE.sub("\n\n", text))
    found = []
    for block in BLOCK.split(text):
        cells = re.split(r"(?<!\\)\|", block) if block.startswith("|") else [block]
        for cell in cells:
            found += [sentence.strip() for sentence in SENTENCE.split(" ".join(cell.split()))]
    return [sentence for sentence in found if sentence]


def length(sentence: str) -> int:
    return sum(WORD.search(word) is not None for word in sentence.split())


def too_long(text: str) -> list[str]:
    return [sentence for sentence in sentences(text) if length(sentence) > LONGEST_SENTENCE]


def test_the_pages_for_users_are_at_most_15000_words(checkout: Path) -> None:
    pages = user_pages(checkout)
    assert {page.parent.name for page in pages} == set(FOLDERS)
    assert sum(len(page.read_text(encoding="utf-8").split()) for page in pages) <= MOST_WORDS


def test_no_sentence_for_users_is_longer_than_25_words(checkout: Path) -> None:
    pages = [*user_pages(checkout), checkout / "README.md", checkout / "docs" / "README.md"]
    found = {page.name: too_long(page.read_text(encoding="utf-8")) for page in pages}
    assert {name: long for name, long in found.items() if long} == {}


@pytest.mark.parametrize(
    "text",
    [
        "A " + "word " * 25 + "here.",
        "- Short.\n- An item " + "word " * 24 + "here.",
        "| a | b |\n|---|---|\n| short | " + "word " * 26 + "|",
        "Two lines\n" + "word " * 20 + "\n" + "word " * 5 + ".",
    ],
)
def test_a_long_sentence_is_found(text: str) -> None:
    assert len(too_long(text)) == 1


def test_short_ones_are_not() -> None:
    words = "word " * 20
    assert (
        too_long(f"# {words}\n\n{words}. {words}!\n\n- {words}\n- {words}\n\n| {words} | {words} |\n") == []
    )
    assert (
        too_long(f"```\n{words}{words}\n```\n\n    {words}{words}\n\n[{words}](" + "a/" * 40 + ".md)") == []
    )


def test_the_readme_fits_two_screens_and_has_one_picture(checkout: Path) -> None:
    text = (checkout / "README.md").read_text(encoding="utf-8")
    assert len(text.splitlines()) <= LONGEST_README
    assert text.count("![") == 1
    for command in ("python3 packaging/run.py", "python3 packaging/test.py"):
        assert command in text


def test_the_citation_is_of_the_present_version_and_names_three_papers(checkout: Path) -> None:
    text = (checkout / "CITATION.cff").read_text(encoding="utf-8")
    assert re.findall(r"^version: (.+)$", text, re.MULTILINE) == [bs.version]
    assert re.findall(r"^title: (.+)$", text, re.MULTILINE) == ["BRDF Suite"]
    assert len(re.findall(r"^ +title: ", text, re.MULTILINE)) == 3
    assert all(name in text for name in ("Shimizu", "Günther", "McCool"))


def test_no_page_installs_from_an_index_or_names_an_address_of_the_project(checkout: Path) -> None:
    for page in (checkout / "README.md", checkout / "docs" / "README.md", *user_pages(checkout)):
        text = page.read_text(encoding="utf-8")
        assert re.findall(r"(?:pipx?|uv|uvx|conda) (?:tool )?install (?!\.)\S+", text) == [], page.name
        assert re.findall(r"https?://\S+", text) == [], page.name
