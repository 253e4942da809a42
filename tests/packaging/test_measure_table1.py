"""The pages of Table 1 are what the committed programs write."""

from __future__ import annotations

import runpy
import subprocess
import sys
from pathlib import Path

PAINTS = ("Ford F8", "Polaris Silver", "Opel Titan", "BMW 339", "2K Acrylack", "White", "Blue", "Blue Matte")


def test_the_page_is_up_to_date(checkout: Path, tmp_path: Path) -> None:
    command = [
        sys.executable,
        str(checkout / "packaging" / "documents" / "measure_table1.py"),
        str(tmp_path / "table1.md"),
    ]
    subprocess.run(command, check=True, timeout=240, capture_output=True)
    written = (tmp_path / "table1.md").read_text(encoding="utf-8")
    assert written == (checkout / "docs" / "method" / "table1.md").read_text(encoding="utf-8")
    for name in PAINTS:
        # The colours, and both facet distributions.
        assert written.count(f"| {name} |") == 3


def test_the_measurements_hold_the_table_of_the_eight_paints(checkout: Path) -> None:
    bench = runpy.run_path(str(checkout / "tests" / "benchmarks" / "bench_measure.py"))
    table = bench["appendix"]()
    assert table.strip() in (checkout / "docs" / "method" / "measurements.md").read_text(encoding="utf-8")
    for name in PAINTS:
        # One row of colours per angle, one of gloss, flop and travel.
        assert table.count(f"| {name} |") == 2
