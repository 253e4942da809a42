"""The kernels of the rays are compiled by another process, the first time on a machine.

That takes about 7 s, during which a program would hang whenever the compiler holds the interpreter, and could not be
cancelled. Where no process can be started, or nothing can be kept, they are compiled here on the way.
``python -m brdf_suite.surface.occlusion.compiled`` compiles them now.
"""

from __future__ import annotations

import hashlib
import logging
import os
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np

from brdf_suite.processes import child_command
from brdf_suite.progress import Progress, report

_log = logging.getLogger(__name__)
_SECONDS = 10.0
_POLL_SECONDS = 0.05


def ready_kernels(progress: Progress | None = None) -> None:
    """Return when the kernels are compiled, or cannot be by another process.

    Raises
    ------
    Cancelled
        ``progress`` asked for it; the other process goes on, and its work is kept.
    ImportError, RuntimeError
        numba is not there, or finds no folder to keep its work in.
    """
    stamp = _stamp()
    if stamp.exists():
        return
    try:
        process = subprocess.Popen(
            child_command("brdf_suite.surface.occlusion.compiled"),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,  # an interrupt meant for this program leaves it alone
        )
    except OSError as error:
        _log.warning("No process can be started to compile what follows the rays (%s).", error)
        return
    start = time.monotonic()
    while process.poll() is None:
        elapsed = time.monotonic() - start
        report(progress, min(0.95, elapsed / _SECONDS), "compiling, once for this machine")
        if elapsed > 20.0 * _SECONDS:
            break
        time.sleep(_POLL_SECONDS)


def compile_now() -> None:
    """Compile the kernels in this process and leave the mark that they are."""
    from brdf_suite.surface.occlusion.tree import TriangleTree

    tree = TriangleTree.of(np.eye(3)[None] + np.arange(8.0)[:, None, None])
    points, up = np.zeros((1, 3), np.float32), np.array([[0.0, 1.0, 0.0]], np.float32)
    tree.gather(points, up, up, 1)
    tree.leaves(points, up.astype(np.float64), np.zeros(1))
    _stamp().touch()


def _stamp() -> Path:
    """Return the file that stands beside the compiled kernels once all of them are there."""
    import llvmlite.binding
    import numba

    from brdf_suite.surface.occlusion import compiled_rays

    machine = (
        sys.version_info,
        numba.__version__,
        llvmlite.binding.get_host_cpu_name(),
        llvmlite.binding.get_host_cpu_features().flatten(),
    )
    digest = hashlib.sha256(repr(machine).encode())
    for source in sorted(Path(__file__).parent.glob("compiled_*.py")):
        digest.update(f"{source.name} {source.stat().st_mtime_ns}".encode())
    kernel: Any = compiled_rays.is_hit  # numba adds to it what its type does not say
    return Path(kernel.stats.cache_path) / f"brdf_suite-occlusion-{digest.hexdigest()[:16]}.compiled"


if __name__ == "__main__":
    if hasattr(os, "nice"):
        os.nice(5)  # whoever waits for it does so with a picture on the screen
    compile_now()
