"""Every command in the menus of the four programs without optional packages, in real windows."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

WALK = Path(__file__).with_name("walk_menus.py")
NEEDED = {
    "designer": ("needs numba",),
    "viewer": ("needs Mitsuba", "needs ffmpeg"),
    "lobes": (),
    "swatch": (),
}
"""What each program lacks when its parts are used."""


@pytest.mark.usefixtures("screen")
@pytest.mark.parametrize("program", NEEDED)
def test_no_command_of_a_menu_ends_in_a_fault(
    program: str, folder: Path, without_extras: dict[str, str]
) -> None:
    answer = folder / "answer.json"
    done = subprocess.run(
        [sys.executable, str(WALK), program, str(folder), str(answer)],
        env=without_extras,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert "Traceback" not in done.stderr
    found = json.loads(answer.read_text(encoding="utf-8"))
    assert {"action_Find a Command", "action_About BRDF Suite", "action_Quit"} <= set(found["done"])
    assert not [words for words in found["messages"] if "nternal error" in words]
    for package in NEEDED[program]:
        said = {words for words in found["messages"] if package in words}
        assert said
        for words in said:
            assert "which is not installed; `" in words
            assert "` installs it" in words
    logs = [file.read_text() for file in (folder / "settings").rglob("*.log")]
    assert not [line for log in logs for line in log.splitlines() if " ERROR " in line or "Traceback" in line]
