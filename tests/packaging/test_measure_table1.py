"""The page of Table 1 is what the committed command writes."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path


def test_the_page_is_up_to_date(checkout: Path, tmp_path: Path) -> None:
    command = [sys.executable, str(checkout / "packaging" / "measure_table1.py"), str(tmp_path / "table1.md")]
    subprocess.run(command, check=True, timeout=120, capture_output=True)
    written = (tmp_path / "table1.md").read_text(encoding="utf-8")
    assert written == (checkout / "docs" / "table1.md").read_text(encoding="utf-8")
    for name in (
        "Ford F8",
        "Polaris Silver",
        "Opel Titan",
        "BMW 339",
        "2K Acrylack",
        "White",
        "Blue",
        "Blue Matte",
    ):
        # Two tables of colours, one of gloss, and both facet distributions.
        assert written.count(f"| {name} |") == 5
