"""Child processes: modules of the suite, started so that no Python file of the working folder is imported.

``python -m`` and ``python -c`` put the working folder first on ``sys.path``: a folder with a ``random.py`` in it would
have that file run by every program opened there. All children are started by what stands here.
"""

from __future__ import annotations

import os
import runpy
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

OWN_PACKAGES = frozenset(
    {"brdf_suite", "brdf_qt", "brdf_designer", "brdf_viewer", "brdf_lobe_visualizer", "brdf_color_swatch"}
)
MODULE_OPTION = "--module"
"""Hidden option of the command ``brdf-suite``: a frozen build has no interpreter, and runs its modules by it."""

_SAFE_PATH = "PYTHONSAFEPATH"


def is_own_module(module: str) -> bool:
    """Return whether a dotted module name lies in one of the suite's packages.

    >>> is_own_module("brdf_viewer.tracing.worker"), is_own_module("http.server")
    (True, False)
    """
    return module.partition(".")[0] in OWN_PACKAGES


def child_command(module: str, *arguments: str) -> list[str]:
    """Return the command line that runs a module of the suite as a process: program first, then its arguments.

    Raises
    ------
    ValueError
        The module is not one of the suite's.
    """
    _check_module(module)
    if getattr(sys, "frozen", False):  # set by the tools that freeze programs, and by nothing else
        return [sys.executable, MODULE_OPTION, module, *arguments]
    return [sys.executable, "-P", "-m", module, *arguments]


def run_module(module: str, arguments: Sequence[str]) -> None:
    """Run a module of the suite in this process, as ``python -m`` would.

    Raises
    ------
    ValueError
        The module is not one of the suite's.
    SystemExit
        The module ends with an exit status.
    """
    _check_module(module)
    sys.argv = [module, *arguments]
    runpy.run_module(module, run_name="__main__", alter_sys=True)


@contextmanager
def safe_path_inherited() -> Iterator[None]:
    """Exclude the working folder from ``sys.path`` in processes started by ``multiprocessing`` inside the block.

    It builds its command lines itself; the environment is what they can be reached by.
    """
    before = os.environ.get(_SAFE_PATH)
    os.environ[_SAFE_PATH] = "1"
    try:
        yield
    finally:
        if before is None:
            os.environ.pop(_SAFE_PATH, None)
        else:
            os.environ[_SAFE_PATH] = before


def _check_module(module: str) -> None:
    if not is_own_module(module):
        raise ValueError(f"{module} is no module of the suite.")
