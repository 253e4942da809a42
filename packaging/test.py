"""Prepare this machine and run the tests: ``python3 packaging/test.py [options] [pytest arguments]``.

Without arguments everything runs in as many workers as there are cores, one part after the other since Qt has one
platform a process: the windows with OpenGL, each worker on an X server of its own (Xvfb), and what needs no screen
(Qt's ``offscreen`` platform, OpenGL through EGL). Other arguments go to one pytest, as in
``python3 packaging/test.py tests/fitting -k limit``.

``--changed [COMMIT]``   run what the changes since COMMIT (where the branch left main) can reach, uncommitted too
``--fresh-seeds``        draw other examples of the properties than last time, and more of them
``--prepare-only``       make the environment and run nothing
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Sequence

from changed import changed_files, select
from prepare import ROOT, prepare

SCREEN = ("tests/viewer", "tests/qt_gl", "tests/lobes_gl", "tests/swatch_gl", "tests/extras")
EXTRAS = ("acquisition", "batches", "dev", "meshes", "reference", "speed", "video")
FRESH_SEEDS = "--hypothesis-profile=nightly"


def cores() -> int:
    """Return how many processors this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def parts(tests: Sequence[str] | None) -> list[list[str]]:
    """Return what each run is given: files of tests, of which ``None`` are all, with and without a screen."""
    screen = [folder for folder in SCREEN if (ROOT / folder).is_dir()]
    if tests is None:
        runs = [screen, [f"--ignore={folder}" for folder in screen]]
    else:
        on_screen = [test for test in tests if test.startswith(tuple(f"{folder}/" for folder in screen))]
        runs = [on_screen, [test for test in tests if test not in on_screen]]
    return [["-n", str(cores()), "--dist", "worksteal", *run] for run in runs if run]


def runs_of(arguments: Sequence[str]) -> list[list[str]]:
    """Return the arguments of each pytest; raise :class:`ValueError` for a commit that git does not know."""
    options = [FRESH_SEEDS for argument in arguments if argument == "--fresh-seeds"]
    others = [argument for argument in arguments if argument != "--fresh-seeds"]
    if others[:1] == ["--changed"]:
        if len(others) > 2:
            raise ValueError("--changed takes one commit and nothing else")
        tests = selected(others[1] if len(others) == 2 else None)
    elif others:
        return [[*others, *options]]
    else:
        tests = None
    return [[*run, *options] for run in parts(tests)]


def selected(reference: str | None) -> tuple[str, ...] | None:
    """Say which files of tests the changes since a commit can reach, and return them; ``None``: all."""
    changed = changed_files(ROOT, reference)
    if not changed:
        print("--changed: nothing has changed, so nothing runs", flush=True)
        return ()
    selection = select(ROOT, changed)
    shown = "all tests" if selection.tests is None else " ".join(selection.tests) or "no test"
    print(f"--changed: {selection.reason} ({' '.join(changed)}); running {shown}", flush=True)
    return selection.tests


def main() -> int:
    """Prepare, run, and return pytest's exit status (the first that is not zero)."""
    if sys.argv[1:] == ["--prepare-only"]:
        prepare(*EXTRAS)
        return 0
    try:
        runs = runs_of(sys.argv[1:])
    except ValueError as error:
        print(f"test.py: {error}", file=sys.stderr)
        return 2
    if not runs:
        return 0
    python = str(prepare(*EXTRAS))
    environment = {**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1", "PYTHONFAULTHANDLER": "1"}
    # Hundreds of tests start programs; each would compile every module again where no bytecode may be kept.
    environment.pop("PYTHONDONTWRITEBYTECODE", None)
    environment["PYTHONPYCACHEPREFIX"] = str(ROOT / ".venv" / "bytecode")
    # A home folder without Mesa's cache would make every program translate its shaders again.
    environment.setdefault("MESA_SHADER_CACHE_DIR", str(ROOT / ".venv" / "shaders"))
    # A worker has a core: threads of linear algebra would wait for each other in a loop, a quarter of all time.
    environment.setdefault("OPENBLAS_NUM_THREADS", "1")
    try:
        with tempfile.TemporaryDirectory(prefix="brdf-suite-tests-") as cache:
            # Lights that are filtered and surfaces that are baked once serve all workers of all runs.
            environment["BRDF_SUITE_TESTS_CACHE"] = cache
            codes = [
                subprocess.run(
                    [python, "-m", "pytest", *run], cwd=ROOT, env=environment, check=False
                ).returncode
                for run in runs
            ]
    except KeyboardInterrupt:  # pytest has printed what there was to print
        return 130
    return next((code for code in codes if code), 0)


if __name__ == "__main__":
    sys.exit(main())
