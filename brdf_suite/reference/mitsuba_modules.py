"""Imports of Mitsuba and Dr.Jit for all modules of this room, with one clear error where they are missing."""

from __future__ import annotations

from typing import TYPE_CHECKING

from brdf_suite.extras import import_extra

if TYPE_CHECKING:
    import drjit as dr
    import mitsuba as mi
else:
    mi = import_extra("mitsuba", purpose="path tracing")
    dr = import_extra("drjit", purpose="path tracing")

__all__ = ["dr", "mi"]
