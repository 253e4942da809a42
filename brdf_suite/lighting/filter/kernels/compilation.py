"""Availability of the compiled kernels, and their compilation in the background.

Numba comes with the optional part ``speed``; without it plain numpy does all of the work. It needs about half a
second to be imported and 10 s to compile the kernels, once for a machine. So it is imported by the first filtering,
and where nothing is compiled yet, that filtering is done in plain numpy while another process compiles. The kernels
are kept where numba keeps them: beside the source, or in the user's cache folder where that cannot be written, or in
``$NUMBA_CACHE_DIR``. ``python -m brdf_suite.lighting.filter.kernels.compilation`` compiles them now.
"""

from __future__ import annotations

import hashlib
import logging
import os
import subprocess
import sys
import threading
import time
from pathlib import Path
from types import ModuleType

import numpy as np

from brdf_suite.errors import ExtraError
from brdf_suite.extras import import_extra
from brdf_suite.processes import child_command
from brdf_suite.progress import Progress, report

_log = logging.getLogger(__name__)
_lock = threading.Lock()
_COMPILE_SECONDS = 12.0
_POLL_SECONDS = 0.1


class _State:
    """State of the compilation in this process."""

    kernels: ModuleType | None = None
    broken = False
    process: subprocess.Popen[bytes] | None = None


def kernels(progress: Progress | None = None, *, wait: bool = False) -> ModuleType | None:
    """Return :mod:`brdf_suite.lighting.filter.kernels.filter` where its kernels are compiled, else None.

    Where they are not, another process starts to compile them; ``wait`` waits for it, with progress. Returns
    None for good where numba cannot be imported, or finds no folder to keep its work in.
    """
    with _lock:
        if _State.kernels is not None or _State.broken:
            return _State.kernels
        module = _import()
        if module is None:
            _State.broken = True
            return None
        if not _stamp(module).exists():
            if _State.process is None:
                _State.process = _start()
            if wait:
                _wait(_State.process, progress)
        if _stamp(module).exists():
            _State.kernels = module
        elif _State.process is not None and _State.process.poll() is not None:
            _log.warning(
                "The filter's kernels could not be compiled; environments are filtered without them."
            )
            _State.broken = True
        return _State.kernels


def loaded_kernels() -> ModuleType | None:
    """Return what :func:`kernels` returned last; nothing is started."""
    return _State.kernels


def compile_now() -> ModuleType | None:
    """Compile the kernels in this process, where they are not yet, and return as :func:`kernels` does."""
    with _lock:
        module = _import()
        if module is None:
            return None
        stamp = _stamp(module)
        if not stamp.exists():
            coefficients = module.analyse(np.ones((8, 16, 3), dtype=np.float32), np.full(8, 0.25), 8)
            module.cube(coefficients, np.ones(9), 8)
            module.pack_faces(module.resample_to_cube(np.ones((8, 16, 3), dtype=np.float32), 8), 0.0, None)
            stamp.touch()
        _State.kernels = module
        return module


def _import() -> ModuleType | None:
    try:
        from brdf_suite.lighting.filter.kernels import filter as compiled_filter
    except ExtraError as error:
        _log.info("Environments are filtered by numpy alone: %s", error)
        return None
    if _folder(compiled_filter) is None:
        _log.warning("numba finds no folder for its cache; environments are filtered without it.")
        return None
    return compiled_filter


def _folder(module: ModuleType) -> str | None:
    """Return where numba keeps the compiled kernels; None where it finds no place."""
    folder: str | None = module.compiled_cube.side_band.stats.cache_path
    return folder


def _stamp(module: ModuleType) -> Path:
    """Return the file that stands beside the compiled kernels once all of them are there."""
    import llvmlite
    import llvmlite.binding

    numba = import_extra("numba", purpose="the compiled filter")

    digest = hashlib.sha256(
        repr(
            (
                sys.version_info,
                numba.__version__,
                llvmlite.__version__,
                llvmlite.binding.get_host_cpu_name(),
                llvmlite.binding.get_host_cpu_features().flatten(),
            )
        ).encode()
    )
    for source in sorted(Path(__file__).parent.glob("*.py")):
        digest.update(f"{source.name} {source.stat().st_mtime_ns}".encode())
    return Path(_folder(module) or "") / f"brdf_suite-{digest.hexdigest()[:16]}.compiled"


def _start() -> subprocess.Popen[bytes] | None:
    """Start another process that compiles; None where that is not possible."""
    try:
        return subprocess.Popen(  # noqa: S603 - a module of ours
            child_command("brdf_suite.lighting.filter.kernels.compilation"),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,  # an interrupt meant for this program leaves it alone
        )
    except OSError as error:
        _log.warning("No process can be started to compile the filter's kernels (%s).", error)
        return None


def _wait(process: subprocess.Popen[bytes] | None, progress: Progress | None) -> None:
    start = time.monotonic()
    while process is not None and process.poll() is None:
        elapsed = time.monotonic() - start
        report(progress, min(0.95, elapsed / _COMPILE_SECONDS), "compiling the filter, once for this machine")
        if elapsed > 10.0 * _COMPILE_SECONDS:
            break
        time.sleep(_POLL_SECONDS)


if __name__ == "__main__":
    if hasattr(os, "nice"):
        os.nice(10)
    sys.exit(0 if compile_now() is not None else 1)
