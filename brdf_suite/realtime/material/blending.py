"""Blending of a second paint over the first by its mask."""

from __future__ import annotations

from typing import Any

import moderngl


def blend_over(context: moderngl.Context, on: bool) -> None:
    """Enable or disable blending of the drawn paint by its alpha; the object's coverage stays unchanged."""
    if not on:
        context.disable(moderngl.BLEND)
        return
    context.enable(moderngl.BLEND)
    # moderngl's types know two factors; four set those of alpha apart.
    factors: Any = (moderngl.SRC_ALPHA, moderngl.ONE_MINUS_SRC_ALPHA, moderngl.ZERO, moderngl.ONE)
    context.blend_func = factors
