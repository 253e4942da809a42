"""Compilation of kernels by numba, without the GIL and cached on disk.

Imported only by modules of kernels, which are imported where they are used: numba takes half a second to import.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
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

    Where numba finds no folder to keep it in, each process compiles it again; the function's ``stats.cache_path`` is
    None then. ``in_order`` keeps every sum in the order in which it is written: the same numbers on any machine.
    """
    fastmath = False if in_order else _FREEDOMS
    if function is None:
        return partial(_compiled, fastmath=fastmath)
    return _compiled(function, fastmath=fastmath)


def _compiled(function: _Function, *, fastmath: bool | set[str]) -> _Function:
    compiler = partial(numba.njit, nogil=True, error_model="numpy", fastmath=fastmath)
    try:
        return cast(_Function, compiler(cache=True)(function))
    except RuntimeError:  # "cannot cache function: no locator available"
        return cast(_Function, compiler()(function))
