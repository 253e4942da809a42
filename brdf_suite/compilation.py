"""Compilation of kernels by numba, without the GIL and cached on disk.

Imported only by modules of kernels, which are imported where they are used: numba takes half a second to import.
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


def compiled_on_disk(function: _Function) -> _Function:
    """Compile a function on its first call, or load it from disk where that has been done before.

    Raises
    ------
    RuntimeError
        There is no folder in which compiled functions can be kept.
    """
    return _compiled(function, cache=True, fastmath=_FREEDOMS)


def compiled(function: _Function) -> _Function:
    """As :func:`compiled_on_disk`; where nothing can be kept, each process compiles the function again."""
    try:
        return compiled_on_disk(function)
    except RuntimeError:
        return _compiled(function, fastmath=_FREEDOMS)


def compiled_in_order(function: _Function) -> _Function:
    """As :func:`compiled`, with every sum in the order in which it is written: the same numbers on any machine."""
    try:
        return _compiled(function, cache=True)
    except RuntimeError:
        return _compiled(function)


def _compiled(function: _Function, **options: object) -> _Function:
    return cast(_Function, numba.njit(nogil=True, error_model="numpy", **options)(function))
