"""Imports of Mitsuba and Dr.Jit for all modules of this room, with one clear error where they are missing."""

from __future__ import annotations

from typing import TYPE_CHECKING

from brdf_suite.extras import import_extra
from brdf_suite.reference.variant import prepare_library

if TYPE_CHECKING:
    import drjit as dr
    import mitsuba as mi
else:
    prepare_library()
    mi = import_extra("mitsuba", purpose="path tracing")
    dr = import_extra("drjit", purpose="path tracing")

__all__ = ["dr", "mi"]
