"""Blending of a second paint over the first by its mask."""

from __future__ import annotations

from typing import Any

import moderngl


def blend_over(context: moderngl.Context, on: bool) -> None:
    """Blend what is drawn over what is there by its alpha, and leave the object's coverage as it is; or do not."""
    if not on:
        context.disable(moderngl.BLEND)
        return
    context.enable(moderngl.BLEND)
    # moderngl's types know two factors; four set those of alpha apart.
    factors: Any = (moderngl.SRC_ALPHA, moderngl.ONE_MINUS_SRC_ALPHA, moderngl.ZERO, moderngl.ONE)
    context.blend_func = factors
