"""Prepare this machine and run the tests: ``python3 packaging/test.py [pytest arguments]``.

Without arguments everything runs, one after the other: what needs no screen (Qt's ``offscreen`` platform,
OpenGL through EGL), and the windows with OpenGL, on X servers of their own (Xvfb); each in two workers. With
arguments they go to one pytest, as in ``python3 packaging/test.py tests/fitting -k limit``.
"""

from __future__ import annotations

import os
import subprocess
import sys

from prepare import ROOT, prepare

SCREEN = ("tests/viewer", "tests/qt_gl", "tests/lobes_gl", "tests/swatch_gl")


def main() -> int:
    """Prepare, run, and return pytest's exit status (the first that is not zero)."""
    if sys.argv[1:] == ["--prepare-only"]:
        prepare("acquisition", "dev", "reference", "video")
        return 0
    python = str(prepare("acquisition", "dev", "reference", "video"))
    environment = {**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1", "PYTHONFAULTHANDLER": "1"}
    # Hundreds of tests start programs; each would compile every module again where no bytecode may be kept.
    environment.pop("PYTHONDONTWRITEBYTECODE", None)
    environment["PYTHONPYCACHEPREFIX"] = str(ROOT / ".venv" / "bytecode")
    # A worker has a core: threads of linear algebra would wait for each other in a loop, a quarter of all time.
    environment.setdefault("OPENBLAS_NUM_THREADS", "1")
    pytest = [python, "-m", "pytest"]
    if sys.argv[1:]:
        runs = [[*pytest, *sys.argv[1:]]]
    else:
        screen = [folder for folder in SCREEN if (ROOT / folder).is_dir()]
        without = [f"--ignore={folder}" for folder in screen]
        workers = ["-n", "2", "--dist", "loadfile"]
        runs = [[*pytest, *workers, *without], [*pytest, *workers, *screen]]
    try:
        codes = [subprocess.run(run, cwd=ROOT, env=environment, check=False).returncode for run in runs]
    except KeyboardInterrupt:  # pytest has told what there was to tell
        return 130
    return next((code for code in codes if code), 0)


if __name__ == "__main__":
    sys.exit(main())
