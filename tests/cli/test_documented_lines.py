"""Command lines in the blocks of code of the documents: all are parsed, and those that take no time are run."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

import brdf_suite as bs
from brdf_suite.cli.main import COMMANDS, main, parser

CHECKOUT = Path(__file__).resolve().parents[2]
PAGES = (CHECKOUT / "README.md", *sorted((CHECKOUT / "docs").rglob("*.md")))
MADE = {"docs/command/reference.md"}
"""Its lines are the examples of the parsers, which their own tests run."""
RUN = ("README.md", "docs/start/", "docs/guides/", "docs/command/")

BLOCK = re.compile(r"^```(?:\w*)\n(.*?)^```", re.DOTALL | re.MULTILINE)
INDENTED = re.compile(r"(?<=\n\n)((?: {4}.*\n)+)")
LINE = re.compile(r"^ *(?:cat \S+ \| )?(?:python3 packaging/run\.py(?: --with \S+)?|(brdf-\w+))( .*)?$")
PATTERN = re.compile(r"[A-Z]{3}(?!-)|[\[…]|\w\|\w")
"""What stands in a line that shows the form of a command, and is none."""
AFTER = re.compile(r"(\s{3,}\S| +#|\s+>|\s+\||\s+\().*$")

SLOW = re.compile(
    r"^(?:batch|render|turntable|sheet|acquire|basis|agreement|represent|prefilter|factorize|fit-cook-torrance"
    r"|completion (?:bash|zsh|fish)|environment (?:sky|info)|cache|export .*\.pdf|open|designer|viewer|lobes|swatch)\b"
)
"""Commands that draw, filter, search, open windows, or write outside of the working folder."""


def blocks(page: Path) -> Iterator[str]:
    """Yield the lines of the blocks of code, with those that go on joined."""
    text = re.sub(r"\\\n\s*", " ", page.read_text(encoding="utf-8"))
    for block in (*BLOCK.findall(text), *INDENTED.findall(BLOCK.sub("", text))):
        yield from block.splitlines()


def documented(page: Path) -> Iterator[tuple[str, list[str]]]:
    """Yield program and words of each command line."""
    for line in blocks(page):
        found = LINE.match(line)
        if found and not PATTERN.search(words := AFTER.sub("", found[2] or "")):
            yield found[1] or "brdf-suite", shlex.split(words)


def parse(program: str, words: list[str]) -> None:
    if program == "brdf-lobes":
        from brdf_lobe_visualizer.command_line import parser as lobes

        lobes().parse_args(words)
    elif program == "brdf-suite" and words[:1] == ["lobes"]:
        parse("brdf-lobes", words[1:])
    elif program == "brdf-suite" and words[:1] == ["help"]:
        parser(COMMANDS).parse_args([*words[1:], "--help"])
    elif program == "brdf-suite" and (not words or words[0] not in {"designer", "viewer", "lobes", "swatch"}):
        parser(COMMANDS).parse_args(words)
    else:
        assert not [word for word in words if word != "--help"], "add the parser of this program to the test"


def test_every_documented_command_line_can_be_parsed(capsys: pytest.CaptureFixture[str]) -> None:
    wrong, count = [], 0
    for page in PAGES:
        for program, words in documented(page):
            count += 1
            try:
                parse(program, words)
            except SystemExit as end:
                if end.code:
                    wrong.append(f"{page.name}: {program} {shlex.join(words)}: {capsys.readouterr().err}")
    assert wrong == []
    assert count > 100


def test_a_line_of_every_form_is_found(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text(
        "# A\n\n    brdf-suite list paints   all of them\n\n```\ncat a | brdf-suite measure - > b\n"
        "python3 packaging/run.py --with video turntable blue \\\n    -o a.mp4\nbrdf-lobes blue\n"
        "brdf-suite render PAINT\n```\n`brdf-suite list`\n"
    )
    assert sorted(documented(page)) == [
        ("brdf-lobes", ["blue"]),
        ("brdf-suite", ["list", "paints"]),
        ("brdf-suite", ["measure", "-"]),
        ("brdf-suite", ["turntable", "blue", "-o", "a.mp4"]),
    ]


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The files that the guides take for given."""
    folder = tmp_path_factory.mktemp("documented")
    blue = bs.load("blue", bs.Paint)
    bs.export(blue, folder / "standard.cxf")
    bs.export(blue.with_lab(110.0, (9.5, 8.0, -28.0)), folder / "batch.cxf")
    directions = bs.spherical([0.1 + 0.02 * i for i in range(60)], 0.0)
    views = bs.spherical([0.2 + 0.015 * i for i in range(60)], 3.0)
    values = bs.load("fine_silver", bs.Material).eval(directions, views)
    bs.save(bs.samples(directions, views, values), folder / "sample.astm")
    (folder / "sample.astm").rename(folder / "sample.brdf")  # what it is, its content says
    model = "def brdf(L, V, N, X, Y, a=number(0, 1, 0.5)):\n    return a / pi\n"
    (folder / "model.brdf").write_text(model, encoding="utf-8")
    entries = (bs.Entry(bs.load(name, bs.Paint)) for name in ("blue", "copper", "fine_silver"))
    bs.save(bs.Palette("Summer", tuple(entries)), folder / "summer.brdfpalette")
    return folder


def quick(page: Path) -> list[str]:
    """Return the lines of a page that can be run, as they stand."""
    return [
        line.strip()
        for line in blocks(page)
        if (found := LINE.match(line))
        and found[1] == "brdf-suite"
        and not PATTERN.search(found[2] or "")
        and not SLOW.search((found[2] or "").strip())
        and "~" not in line
    ]


RUNNABLE = [
    page
    for page in PAGES
    if (name := page.relative_to(CHECKOUT).as_posix()).startswith(RUN) and name not in MADE
]


@pytest.mark.parametrize("page", [page for page in RUNNABLE if quick(page)], ids=lambda page: page.stem)
def test_quick_command_lines_run_in_the_order_of_the_page(
    page: Path, files: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for file in files.iterdir():
        (tmp_path / file.name).write_bytes(file.read_bytes())
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("BRDF_SUITE_CACHE", str(tmp_path / "cache"))
    for line in quick(page):
        assert run(line) in ({0, 1} if re.search("judge|compare", line) else {0}), line


def run(line: str) -> int:
    """Run a line, in this process where the shell has nothing to do; return its status."""
    words = shlex.split(line, comments=True)
    if not {"|", ">"} & set(words):
        try:
            return main(words[1:])
        except SystemExit as end:
            return int(str(end.code or 0))
    command = f"{shlex.quote(sys.executable)} -m brdf_suite "
    shell = re.sub(r"(^|\| )brdf-suite ", lambda match: match[1] + command, line)
    return subprocess.run(
        ["bash", "-o", "pipefail", "-c", shell], check=False, timeout=240, env=os.environ
    ).returncode
