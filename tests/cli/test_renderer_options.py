"""Options of one renderer with the other are refused, not left out in silence."""

from __future__ import annotations

from pathlib import Path

import pytest

from brdf_suite.cli.main import main


@pytest.mark.parametrize(
    ("renderer", "option"),
    [
        ("realtime", ["--spp", "4"]),
        ("realtime", ["--fresh"]),
        ("reference", ["--samples", "8"]),
        ("reference", ["--quality", "fast"]),
        ("raytraced", ["--transparent"]),
    ],
)
def test_an_option_of_the_other_renderer_is_refused(
    renderer: str, option: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target = tmp_path / "a.png"
    assert main(["render", "blue", "-o", str(target), "--renderer", renderer, *option]) != 0
    assert f"With --renderer {renderer} there is no {option[0]}" in capsys.readouterr().err
    assert not target.exists()
