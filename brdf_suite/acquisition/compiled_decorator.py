"""How the kernels of the acquisition are compiled: by numba, without the interpreter's lock, kept on disk.

Imported only by the kernels' modules: numba takes half a second to import.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeAlias, TypeVar, cast

from brdf_suite.extras import import_extra

numba = import_extra("numba", purpose="the evaluation of photographs")

Array: TypeAlias = Any
"""A numpy array in a kernel: numba indexes it to scalars, which numpy's own types do not say."""

_Function = TypeVar("_Function", bound=Callable[..., Any])

# Sums may be reordered, as vector registers need it; not-a-number, infinity and division keep their meaning.
_FREEDOMS = {"reassoc", "contract", "nsz"}


def compiled(function: _Function) -> _Function:
    """Compile a function on its first call, or load it from the disk where that has been done before."""
    return _compiled(function, fastmath=_FREEDOMS)


def compiled_in_order(function: _Function) -> _Function:
    """As :func:`compiled`, with every sum in the order in which it is written: the same numbers on any machine."""
    return _compiled(function, fastmath=False)


def _compiled(function: _Function, **more: object) -> _Function:
    options = {"nogil": True, "error_model": "numpy", **more}
    try:
        return cast(_Function, numba.njit(cache=True, **options)(function))
    except RuntimeError:
        # No folder to keep the work in, as where nothing can be written: it is done again each time.
        return cast(_Function, numba.njit(**options)(function))
