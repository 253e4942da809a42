"""How the kernels of the rays are compiled: by numba, without the interpreter's lock, kept on disk.

Imported only by the kernels' modules: numba takes half a second to import.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeAlias, TypeVar, cast

import numba

Array: TypeAlias = Any
"""A numpy array in a kernel: numba indexes it to scalars, which numpy's own types do not say."""

_Function = TypeVar("_Function", bound=Callable[..., Any])


def compiled(function: _Function) -> _Function:
    """Compile a function on its first call, or load it from the disk where that has been done before."""
    # Division by zero gives infinity, as the box test wants it; no freedom that would drop infinities.
    wrap = numba.njit(cache=True, nogil=True, error_model="numpy", fastmath={"contract", "nsz"})
    return cast(_Function, wrap(function))
