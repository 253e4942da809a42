"""Frames while something moves: coarser where whole ones would come too slowly."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import moderngl

from brdf_suite.realtime.gl.objects import GpuObjects, Size, Target
from brdf_suite.realtime.gl.programs import assign
from brdf_suite.realtime.pictures.light_pass import DEFAULT_SAMPLES

BUDGET_MS = 90.0
"""A frame that takes longer does not follow the hand."""
_ROOM = 1.3
_MANY_TRIANGLES = 250_000
_QUICK_MS = 25.0


@dataclass(frozen=True)
class Coarseness:
    """The part of width and height that a frame is drawn in, and its samples a pixel; its time relative to a whole one.

    A software renderer takes several times as long for four samples as for one, though it shades once a pixel.
    """

    scale: float
    samples: int

    @property
    def cost(self) -> float:
        """About the time of such a frame, over that of a whole one."""
        return self.scale**2 * (0.25 if self.samples < DEFAULT_SAMPLES else 1.0)


WHOLE = Coarseness(1.0, DEFAULT_SAMPLES)
STEPS = (WHOLE, *(Coarseness(scale, 0) for scale in (1.0, 0.75, 0.5, 0.375, 0.25)))
"""Few, since a change of size makes all targets anew."""


class Pace:
    """Chooses the coarseness of frames by the time that they have taken; knows of no window and no clock."""

    def __init__(self) -> None:
        self._moves = False
        self._chosen = self._last = WHOLE
        self._begun: Coarseness | None = None
        self._known = {DEFAULT_SAMPLES}
        self._arrives = self._wanted_whole = False
        self._whole_ms: float | None = None

    @property
    def coarseness(self) -> Coarseness:
        """How to draw the next frame."""
        if self._arrives:
            return STEPS[-1]
        return self._chosen if self._moves else WHOLE

    def move(self) -> None:
        """Take the next frames for those of a movement."""
        self._moves = True

    def arrive(self, triangles: int) -> None:
        """Take the next frame for the first one of a surface: of very many triangles it is coarse, to come soon.

        The one after it is as usual. The first is whole too where it is wanted so (:meth:`want_whole`), or where whole
        frames were quick, as with a graphics card.
        """
        slow = self._whole_ms is None or self._whole_ms > _QUICK_MS
        self._arrives = triangles >= _MANY_TRIANGLES and slow and not self._wanted_whole

    def want_whole(self) -> None:
        """Draw the next frame whole also where a surface arrives with it, as for a picture that is kept."""
        self._wanted_whole = True

    def rest(self) -> bool:
        """Draw whole frames from now on; return whether the last one was coarser."""
        self._moves = False
        coarser, self._last = self._last is not WHOLE, WHOLE
        return coarser

    def begin_frame(self) -> Coarseness:
        """Return how to draw a frame that begins now."""
        self._begun = self._last = self.coarseness
        self._arrives = self._wanted_whole = False
        return self._begun

    def end_frame(self, milliseconds: float) -> None:
        """Note the time that the last frame took, and choose how to draw the next ones of a movement.

        A frame that was not begun here says nothing, nor does the first with fewer samples, which compiles.
        """
        drawn, self._begun = self._begun, None
        if drawn is None:
            return
        if drawn is WHOLE:
            self._whole_ms = milliseconds
        if drawn.samples not in self._known:
            self._known.add(drawn.samples)
            return
        whole = milliseconds / drawn.cost
        best = _finest(whole, BUDGET_MS)
        if best.cost < self._chosen.cost:
            self._chosen = best
        else:
            # Finer frames only where they fit with some room, or sizes would alternate.
            self._chosen = max(self._chosen, _finest(whole, BUDGET_MS / _ROOM), key=lambda step: step.cost)


def _finest(whole_ms: float, budget_ms: float) -> Coarseness:
    """Return the finest step that takes no longer, where a whole frame takes ``whole_ms``."""
    return next((step for step in STEPS if whole_ms * step.cost <= budget_ms), STEPS[-1])


class Enlarger:
    """Draws frames in a part of their size, and enlarges them."""

    def __init__(self, objects: GpuObjects) -> None:
        self._objects = objects
        self._target = Target(objects)

    def draw(
        self,
        scale: float,
        framebuffer: moderngl.Framebuffer | int,
        size: Size,
        draw: Callable[[moderngl.Framebuffer | int, Size], None],
    ) -> None:
        """Have ``draw`` draw into a framebuffer of ``scale`` of ``size``, and that into ``framebuffer``."""
        if scale >= 1.0:
            draw(framebuffer, size)
            return
        small = (max(1, round(scale * size[0])), max(1, round(scale * size[1])))
        target, texture = self._target.prepare(small)
        draw(target, small)
        self._objects.bind(framebuffer, size)
        program, screen = self._objects.screen("enlarged.frag.glsl")
        texture.filter = (moderngl.LINEAR, moderngl.LINEAR)
        texture.repeat_x = texture.repeat_y = False
        texture.use(0)
        assign(program, {"picture": 0, "size": (float(size[0]), float(size[1]))})
        screen.render(moderngl.TRIANGLES, vertices=3)
