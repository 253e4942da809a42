"""``brdf-suite`` with no argument: both programs, linked, as processes of their own."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(not Path("/proc/self/task").is_dir(), reason="children are read from /proc")


def children(process: subprocess.Popen[str]) -> dict[str, int]:
    """The programs that the command has started, by the name of their package."""
    listed = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
    commands = {}
    for pid in listed:
        with suppress(OSError):  # it ended meanwhile
            commands[int(pid)] = Path(f"/proc/{pid}/cmdline").read_bytes().split(b"\0")
    return {
        words[words.index(b"-m") + 1].decode(): pid
        for pid, words in commands.items()
        if b"-P" in words and b"-m" in words
    }


def wait_for(condition, seconds: float = 200.0):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        found = condition()
        if found:
            return found
        time.sleep(0.1)
    raise AssertionError("it did not come")


def wait_for_both(process: subprocess.Popen[str]) -> dict[str, int]:
    """Wait until both are what they shall be: a child is a copy of the command until its own program is loaded."""

    def both() -> dict[str, int] | None:
        started = children(process)
        return started if set(started) == {"brdf_designer", "brdf_viewer"} else None

    return wait_for(both)


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
def test_both_programs_open_and_end_with_the_command(number) -> None:
    command = [sys.executable, "-m", "brdf_suite"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        try:
            started = wait_for_both(process)
            process.send_signal(number)
            assert process.wait(200) == 130
            assert process.stderr.read().strip() == "brdf-suite: cancelled"
            assert not any(Path(f"/proc/{pid}").exists() for pid in started.values())
        finally:
            process.kill()


def test_the_viewer_follows_designer_also_on_a_paint_that_was_named() -> None:
    command = [sys.executable, "-m", "brdf_suite", "open", "copper"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        try:
            started = wait_for_both(process)
            words = {
                name: Path(f"/proc/{pid}/cmdline").read_text().split("\0") for name, pid in started.items()
            }
            assert "copper" in words["brdf_designer"]
            assert {"copper", "--follow"} <= set(words["brdf_viewer"])
            process.terminate()
            process.wait(200)
        finally:
            process.kill()


def test_when_one_program_is_killed_the_other_lives_on() -> None:
    command = [sys.executable, "-m", "brdf_suite"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        try:
            started = wait_for_both(process)
            os.kill(started["brdf_designer"], signal.SIGKILL)
            wait_for(lambda: set(children(process)) == {"brdf_viewer"})
            time.sleep(0.5)
            assert process.poll() is None
            process.terminate()
            process.wait(200)
            assert "designer ended with status -9" in process.stderr.read()
        finally:
            process.kill()


@pytest.mark.parametrize("package", ["brdf_designer", "brdf_viewer"])
def test_a_program_without_a_screen_says_so(package: str) -> None:
    bare = {k: v for k, v in os.environ.items() if k not in {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}}
    done = subprocess.run(
        [sys.executable, "-m", package], env=bare, capture_output=True, text=True, timeout=240, check=False
    )
    assert done.returncode == 1
    assert "there is no screen" in done.stderr
    assert len(done.stderr.strip().splitlines()) == 1
