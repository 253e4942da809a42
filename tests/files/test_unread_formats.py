"""Formats that are known and not read: every command says which it is, and another way to what is in them."""

from __future__ import annotations

from pathlib import Path

import pytest

from brdf_suite.cli.main import main
from brdf_suite.errors import FileError, UnreadFormatError
from brdf_suite.files.measured import read_measured
from brdf_suite.files.palettes import read_content, read_palette
from brdf_suite.files.palettes.text import json_tokens
from brdf_suite.pipeline.material import file_kind

AXF = {"a.axf": b"anything", "b.dat": b"\x89HDF\r\n\x1a\n" + bytes(90)}
THEMES = {
    "Breeze.colors": "[ColorEffects:Disabled]\nColor=56,56,56\n\n[Colors:Window]\nBackgroundNormal=239,240,241\n",
    "comments.colors": "# SPDX-License-Identifier: LGPL\n\n[General]\nName=Night\n\n[WM]\nactiveBackground=1,2,3\n",
    "mark.colors": "\ufeff[Colors:Button]\r\nForegroundLink=41,128,185\r\n",
    "index.theme": "[Desktop Entry]\nType=X-GNOME-Metatheme\nName=Adwaita\n",
    "old.theme": "; Copyright\r\n[Theme]\r\nDisplayName=Classic\r\n[Control Panel\\Colors]\r\nWindow=255 255 255\r\n",
    "qt.conf": "  [ColorScheme]\nactive_colors=#ff000000, #ffefefef\n",
}
COMMANDS = (
    "convert FILE -o out.gpl",
    "check FILE",
    "measure FILE",
    "fit FILE",
    "export FILE -o out.gltf",
    "render FILE -o out.png",
    "design start FILE -o out.brdfpaint",
    "palette info FILE",
    "thumbnail FILE -o out.png",
    "judge blue FILE",
)


@pytest.fixture(params=AXF)
def axf(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    """A file that is taken for AxF, by its ending or by its start."""
    path = tmp_path / str(request.param)
    path.write_bytes(AXF[request.param])
    return path


def run(words: str, path: Path, capsys: pytest.CaptureFixture[str]) -> str:
    """Return what a command that fails says."""
    assert main([str(path) if word == "FILE" else word for word in words.split()]) == 1
    return capsys.readouterr().err


def test_axf_is_refused_with_the_way_through_cxf3(axf: Path) -> None:
    for refuse in (read_measured, read_palette, file_kind):
        with pytest.raises(UnreadFormatError, match="export its measurements as CxF3"):
            refuse(axf)


@pytest.mark.parametrize("words", COMMANDS)
def test_commands_say_that_it_is_axf(
    axf: Path, words: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.chdir(tmp_path)
    said = run(words, axf, capsys)
    assert "is an AxF material or another HDF5 container, which is not read" in said
    assert "the page “AxF” of the manual" in said
    assert not list(tmp_path.glob("out.*"))


@pytest.mark.parametrize("name", THEMES)
def test_desktop_themes_are_refused_by_name(
    name: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.chdir(tmp_path)
    path = tmp_path / name
    path.write_text(THEMES[name], "utf-8", newline="")
    for words in (*COMMANDS[:2], "palette info FILE"):
        said = run(words, path, capsys)
        assert "is a desktop theme or a colour scheme of windows" in said
        assert "JSON" not in said


def test_lists_in_json_are_no_theme() -> None:
    for text in ('["#d40000"]', '[\n  {"name": "a", "hex": "#d40000"}]', '{"a": [["#d40000"]]}'):
        assert read_content(text.encode(), "a.theme").format is json_tokens.FORMAT
    for text in ("[", "[]", "[[212, 0, 0]]", "[1, 2"):
        with pytest.raises(FileError) as caught:
            read_content(text.encode(), "a.json")
        assert not isinstance(caught.value, UnreadFormatError)
