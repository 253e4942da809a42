"""Imports of Mitsuba and Dr.Jit for all modules of this room, with one clear error where they are missing."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, wraps
from typing import TYPE_CHECKING, Any

from brdf_suite.extras import import_extra
from brdf_suite.reference.variant import prepare_library

if TYPE_CHECKING:
    import drjit as dr
    import mitsuba as mi
else:
    prepare_library()
    mi = import_extra("mitsuba", purpose="path tracing")
    dr = import_extra("drjit", purpose="path tracing")

__all__ = ["dr", "mi", "per_variant"]


def per_variant(make: Callable[[], Any]) -> Callable[[], Any]:
    """Let a plug-in's class be made once for each variant: its base is another class in each."""
    made = cache(lambda _variant: make())

    @wraps(make)
    def of_this_variant() -> Any:
        return made(mi.variant())

    return of_this_variant
