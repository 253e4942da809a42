"""How the lighting's kernels are compiled: by numba, without the interpreter's lock, kept on disk.

Imported only by the kernels' modules: numba takes half a second to import.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeAlias, TypeVar, cast

from brdf_suite.extras import import_extra

numba = import_extra("numba", purpose="the compiled filter")

Array: TypeAlias = Any
"""A numpy array in a kernel: numba indexes it to scalars, which numpy's own types do not say."""

_Function = TypeVar("_Function", bound=Callable[..., Any])

# Sums may be reordered, as vector registers need it; not-a-number, infinity and division keep their meaning.
_FREEDOMS = {"reassoc", "contract", "nsz"}


def compiled(function: _Function) -> _Function:
    """Compile a function on its first call, or load it from the disk where that has been done before."""
    wrap = numba.njit(cache=True, nogil=True, fastmath=_FREEDOMS, error_model="numpy")
    return cast(_Function, wrap(function))
