"""Child processes: modules of the suite, started so that no Python file of the working folder is imported.

``python -m`` and ``python -c`` put the working folder first on ``sys.path``: a folder with a ``random.py`` in it would
have that file run by every program opened there. All children are started by what stands here. They ignore the
variables ``PYTHON*`` of the environment, too, which can name more folders, another standard library or a file to run.
"""

from __future__ import annotations

import io
import os
import runpy
import shlex
import signal
import sys
import threading
from collections.abc import Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path

OWN_PACKAGES = frozenset(
    {"brdf_suite", "brdf_qt", "brdf_designer", "brdf_viewer", "brdf_lobe_visualizer", "brdf_color_swatch"}
)
MODULE_OPTION = "--module"
"""Hidden first argument of the command and the programs: a frozen build has no interpreter and runs modules by it."""

_PATH = "PYTHONPATH"
_SAFE_PATH = "PYTHONSAFEPATH"


_STREAMS = ("stdin", "stdout", "stderr")


def prepare_streams() -> None:
    """Let the standard streams take every letter, and give those that are closed the null device; for entry points.

    Files and other programs get and give UTF-8, whatever the locale; a terminal shows what it has no sign for by its
    number. A file that is opened gets the number of a closed stream, and what a library prints would be written to it.
    """
    for number, name in enumerate(_STREAMS):
        try:
            os.fstat(number)
        except OSError:
            os.set_inheritable(os.open(os.devnull, os.O_RDWR), True)  # the lowest number that is free
        stream = getattr(sys, name)
        if isinstance(stream, io.TextIOWrapper):
            if stream.isatty():
                stream.reconfigure(errors="backslashreplace")
            else:
                stream.reconfigure(encoding="utf-8", errors="surrogateescape")


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
    return [sys.executable, *_interpreter_options(), "-m", module, *arguments]


def shell_interpreter(executable: str | None = None) -> str:
    """Return the beginning of a shell's command line that runs Python with the options of :func:`child_command`.

    Job systems add ``-m`` and a module of their own. ``executable`` is a command that starts Python elsewhere, as it
    stands in a configuration file; default: this interpreter.
    """
    return " ".join([executable or shlex.quote(sys.executable), *map(shlex.quote, _interpreter_options())])


def run_named_module(words: Sequence[str]) -> int | None:
    """Run the module that a command line names with ``--module``; None where it does not begin with that option.

    A frozen build starts its child processes so. Entry points call it before they look at anything else.

    Raises
    ------
    SystemExit
        The module ends with an exit status.
    """
    if words[:1] != [MODULE_OPTION]:
        return None
    if len(words) < 2 or not is_own_module(words[1]):
        print(f"{MODULE_OPTION} takes the name of a module of the suite.", file=sys.stderr)
        return 2
    run_module(words[1], words[2:])
    return 0


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
def variables_inherited(variables: Mapping[str, str]) -> Iterator[None]:
    """Set variables of the environment, which processes started inside the block inherit; restore them after it."""
    before = {name: os.environ.get(name) for name in variables}
    os.environ.update(variables)
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                os.environ.pop(name, None)
            else:
                os.environ[name] = value


def safe_path_inherited() -> AbstractContextManager[None]:
    """Exclude the working folder from ``sys.path`` in processes started by ``multiprocessing`` inside the block.

    It builds its command lines itself; the environment is what they can be reached by.
    """
    return variables_inherited({_SAFE_PATH: "1"})


@contextmanager
def interrupts_held_back() -> Iterator[None]:
    """Start threads and processes inside the block that Ctrl-C does not reach: this process alone ends them.

    An interrupt that comes meanwhile takes effect at the end of the block. On Windows nothing is held back.
    """
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    from multiprocessing import resource_tracker

    resource_tracker.ensure_running()  # begun later, it would let interrupts through again
    # The system gives a signal that this thread does not take to another one, as those of linear algebra, and Python
    # interrupts the main thread all the same.
    handler = signal.getsignal(signal.SIGINT)
    is_held = handler is not None and threading.current_thread() is threading.main_thread()
    held: list[int] = []
    if is_held:
        signal.signal(signal.SIGINT, lambda number, _frame: held.append(number))
    try:
        before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        try:
            yield
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)
    finally:
        if is_held:
            signal.signal(signal.SIGINT, handler)
        if held:
            signal.raise_signal(signal.SIGINT)


def _interpreter_options() -> list[str]:
    """Return the options of the interpreter: no working folder and no variables, but this process's bytecode folder."""
    options = ["-P"]
    if not _found_by_variable():
        options.insert(0, "-E")
        if sys.pycache_prefix is not None:
            options += ["-X", f"pycache_prefix={sys.pycache_prefix}"]
    return options


def _found_by_variable() -> bool:
    """Whether the suite is not installed, and ``PYTHONPATH`` names its source: children need the variable, too."""
    source = Path(__file__).resolve().parent.parent
    entries = filter(None, os.environ.get(_PATH, "").split(os.pathsep))
    return any(Path(entry).resolve() == source for entry in entries)


def _check_module(module: str) -> None:
    if not is_own_module(module):
        raise ValueError(f"{module} is no module of the suite.")
