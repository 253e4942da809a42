"""Every command takes every kind of material: shipped names, paint files, measured files, models, palette entries."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from brdf_suite.cli.main import main
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.pipeline.material import load_document
from brdf_suite.realtime.environment import textures

KINDS = (
    "shipped",
    "table 1",
    "model",
    "paint file",
    "paint file of another ending",
    "Cook-Torrance file",
    "factored file",
    "RGL file",
    "scattered file",
    "table over angles",
    "surface shader",
    "palette entry",
    "palette of one",
)

COMMANDS: dict[str, Callable[[str, Path], list[str]]] = {
    "fit": lambda what, _out: ["fit", what],
    "measure": lambda what, _out: ["measure", what],
    "compare": lambda what, _out: ["compare", what, "blue"],
    "judge": lambda what, _out: ["judge", what, "blue"],
    "export": lambda what, out: ["export", what, "-o", str(out / "out.csv")],
    "design start": lambda what, out: ["design", "start", what, "-o", str(out / "out.brdfpaint")],
    "design between": lambda what, out: ["design", "between", what, "blue", "-o", str(out / "out.brdfpaint")],
    "palette find": lambda what, out: ["palette", "find", what, "--in", str(out / "shipped.brdfpalette")],
    "sheet": lambda what, out: [
        "sheet",
        what,
        "-o",
        str(out / "out.png"),
        "--form",
        "chips",
        "--size",
        "48x32",
    ],
    "render": lambda what, out: ["render", what, "-o", str(out / "out.png"), "--size", "32x18"],
}


@pytest.mark.usefixtures("shared_cache")
@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.parametrize("kind", KINDS)
def test_every_command_takes_every_kind(
    kind: str,
    command: str,
    materials: dict[str, str],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(
        textures, "MIPMAPPED_FROM", 4096
    )  # made in software they take longer than the pictures
    save_palette(
        Palette("Shipped", (Entry(load_document("blue"), id="1"),)), tmp_path / "shipped.brdfpalette"
    )
    assert main([*COMMANDS[command](materials[kind], tmp_path), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)
