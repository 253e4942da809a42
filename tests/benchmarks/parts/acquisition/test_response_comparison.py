"""The comparison of recovered responses runs; the statements of docs/method/acquisition.md hold on a small case."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent


def test_a_smooth_curve_is_nearer_than_free_values_by_turns() -> None:
    command = [sys.executable, "-W", "error", "compare_responses.py", "--cases", "1"]
    done = subprocess.run(command, cwd=HERE, capture_output=True, text=True, timeout=600, check=False)
    assert done.returncode == 0, done.stderr
    rows = [line.strip("| ").split(" | ") for line in done.stdout.splitlines() if line.startswith("| ")]
    assert len(rows) == 2
    ours, turns = float(rows[1][2]), float(rows[1][3])
    assert ours < 0.02
    assert ours < 0.5 * turns
