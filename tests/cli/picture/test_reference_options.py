"""Options of one renderer with the other are refused, not left out in silence; how many threads numpy gets."""

from __future__ import annotations

import os
import subprocess
import sys
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


@pytest.mark.parametrize(("wanted", "found"), [(None, "1"), ("3", "3")])
def test_matrix_products_leave_the_cores_to_the_filter(
    wanted: str | None, found: str, tmp_path: Path
) -> None:
    program = (
        "import os, sys\n"
        "from brdf_suite.cli.main import main\n"
        "assert 'numpy' not in sys.modules\n"
        "main(['render', 'blue', '-o', 'a.png', '--spp', '4'])\n"
        "print(os.environ['OPENBLAS_NUM_THREADS'])\n"
    )
    environment = {key: value for key, value in os.environ.items() if key != "OPENBLAS_NUM_THREADS"}
    if wanted is not None:
        environment["OPENBLAS_NUM_THREADS"] = wanted
    done = subprocess.run(
        [sys.executable, "-c", program],
        cwd=tmp_path,
        env=environment,
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout.strip() == found
