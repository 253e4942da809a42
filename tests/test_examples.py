"""Property tests try the same examples in every run, and others on request."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

PROPERTY = """
from hypothesis import given, settings
from hypothesis import strategies as st

@given(st.floats())
def test_any(value):
    print("tried", value)
"""


def tried(checkout: Path, folder: Path, *options: str) -> list[str]:
    """Return the examples that a run of one property tries with the settings of this suite."""
    (folder / "test_any.py").write_text(PROPERTY)
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-s",
        "-p",
        "_hypothesis_pytestplugin",  # and no other: that of Qt takes longer than the property
        "-p",
        "conftest",
        "-p",
        "no:cacheprovider",
        *options,
        "test_any.py",
    ]
    done = subprocess.run(
        command,
        cwd=folder,
        env={
            **os.environ,
            "PYTHONPATH": str(checkout / "tests"),
            "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",
        },
        capture_output=True,
        text=True,
        timeout=240,
        check=True,
    )
    return re.findall(r"tried (\S+)", done.stdout)


def test_a_run_repeats_its_examples_unless_fresh_ones_are_asked_for(checkout: Path, tmp_path: Path) -> None:
    first = tried(checkout, tmp_path)
    assert len(first) >= 50
    assert tried(checkout, tmp_path) == first
    fresh = tried(checkout, tmp_path, "--hypothesis-profile=nightly")
    assert len(fresh) >= 5 * len(first)
    assert fresh[: len(first)] != first
    assert tried(checkout, tmp_path, "--hypothesis-profile=nightly") != fresh


def test_no_test_has_a_number_of_examples_or_a_limit_of_time_of_its_own(checkout: Path) -> None:
    own = re.compile(r"\bsettings\([^)]*(max_examples=\d+\s*[,)]|deadline=|derandomize=|database=)")
    files = [path for path in (checkout / "tests").rglob("test_*.py") if path != Path(__file__)]
    assert [path.name for path in files if own.search(path.read_text())] == []
