"""Names from files steer no terminal: what people see shows their characters, what programs read has them."""

from __future__ import annotations

import json
import os
import pty
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest

from brdf_suite.cli.main import main
from brdf_suite.documents.store import save_paint
from brdf_suite.foreign_text import escape_html, make_visible
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.processes import child_command

HOSTILE = "Blue\u202egnp.exe\u200b"


@pytest.fixture
def paint(tmp_path: Path) -> Path:
    path = tmp_path / "a.brdfpaint"
    save_paint(replace(load_shipped_paint("blue"), name=HOSTILE), path)
    return path


def on_a_terminal(*arguments: str) -> str:
    """What the command writes to a terminal that is its standard output and its standard error."""
    ours, its = pty.openpty()
    process = subprocess.Popen(
        child_command("brdf_suite", *arguments), stdin=subprocess.DEVNULL, stdout=its, stderr=its
    )
    os.close(its)
    said = b""
    try:
        while block := os.read(ours, 65536):
            said += block
    except OSError:  # how Linux reports that the other end is closed
        pass
    os.close(ours)
    process.wait()
    return said.decode("utf-8")


def test_a_terminal_is_shown_the_characters_of_a_name(paint: Path) -> None:
    said = on_a_terminal("measure", str(paint))
    assert "Blue[U+202E]gnp.exe[U+200B]" in said
    assert HOSTILE not in said


def test_another_program_is_given_the_name_as_it_is(paint: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["measure", str(paint), "--json"]) == 0
    assert json.dumps(HOSTILE, ensure_ascii=False) in capsys.readouterr().out


def test_an_escape_in_the_name_of_a_file_reaches_no_terminal(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    name = f"{tmp_path}/\x1b]0;owned\x07\x1b[31mred\u2028.brdfpaint"
    assert main(["measure", name]) == 1
    said = capsys.readouterr().err
    assert "\x1b" not in said
    assert "\x07" not in said
    assert "[U+001B]]0;owned[U+0007][U+001B][31mred" in said
    said = on_a_terminal("measure", name)
    assert "\x1b" not in said


def test_texts_of_people_stay_as_they_are() -> None:
    for text in ("Größe 15°, ΔE00", "青い", "مرحبا", "a\tb\nc", "🚗\ufe0f", ""):
        assert make_visible(text) == text
    for code in (
        *range(9),
        11,
        12,
        13,
        *range(14, 32),
        *range(127, 160),
        0x202E,
        0x2067,
        0x200B,
        0xFEFF,
        0xE0041,
    ):
        assert make_visible(f"a{chr(code)}b") == f"a[U+{code:04X}]b"
    assert escape_html("<b a='\u202e'>&") == "&lt;b a=&#x27;[U+202E]&#x27;&gt;&amp;"
