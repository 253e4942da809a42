"""Compilation of kernels by numba, without the GIL and cached on disk.

Imported only by modules of kernels, which are imported where they are used: numba takes half a second to import.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any, TypeAlias, TypeVar, cast, overload

from brdf_suite.extras import import_extra

numba = import_extra("numba", purpose="the evaluation of photographs")

Array: TypeAlias = Any
"""A numpy array in a kernel: numba indexes it to scalars, which numpy's own types do not say."""

_Function = TypeVar("_Function", bound=Callable[..., Any])

# Sums may be reordered, as vector registers need it; not-a-number, infinity and division keep their meaning.
_FREEDOMS = {"reassoc", "contract", "nsz"}


@overload
def compiled(function: _Function) -> _Function: ...
@overload
def compiled(*, in_order: bool) -> Callable[[_Function], _Function]: ...
def compiled(
    function: _Function | None = None, *, in_order: bool = False
) -> _Function | Callable[[_Function], _Function]:
    """Compile a function on its first call, or load it from disk where that has been done before.

    Where numba finds no folder to keep it in, or only one that other users may write to, each process compiles it
    again; the function's ``stats.cache_path`` is None then. ``in_order`` keeps every sum in the order in which it is
    written: the same numbers on any machine.
    """
    fastmath = False if in_order else _FREEDOMS
    if function is None:
        return partial(_compiled, fastmath=fastmath)
    return _compiled(function, fastmath=fastmath)


def _compiled(function: _Function, *, fastmath: bool | set[str]) -> _Function:
    compiler = partial(numba.njit, nogil=True, error_model="numpy", fastmath=fastmath)
    try:
        kept = compiler(cache=True)(function)
    except RuntimeError:  # "cannot cache function: no locator available"
        return cast(_Function, compiler()(function))
    if _others_may_write(Path(kept.stats.cache_path)):
        return cast(_Function, compiler()(function))
    return cast(_Function, kept)


def _others_may_write(folder: Path) -> bool:
    """Return whether a folder from which code is loaded is another user's, or open to every user."""
    if not hasattr(os, "getuid"):
        return False
    try:
        found = folder.stat()
    except OSError:
        return False
    return found.st_uid not in (0, os.getuid()) or bool(found.st_mode & stat.S_IWOTH)
