"""Creation, release and counting of all OpenGL objects of the renderer.

The counts are the proof that a path makes none: an edit of a paint must write a buffer and nothing else.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, TypeVar

import moderngl

from brdf_suite.realtime.gl.context import graphics_errors
from brdf_suite.realtime.gl.shader_source import ShaderSource, compile_program

_Object = TypeVar("_Object")


@dataclass
class Counters:
    """Counts of objects created, and of bytes written into textures and uniform buffers."""

    created: dict[str, int] = field(default_factory=dict)
    released: int = 0
    texture_uploads: int = 0
    buffer_writes: int = 0

    @property
    def total_created(self) -> int:
        """All objects made since the start, of any kind."""
        return sum(self.created.values())

    @property
    def live(self) -> int:
        """Objects that exist now."""
        return self.total_created - self.released


class GpuObjects:
    """Factory of OpenGL objects in one context; :meth:`release_all` releases all of them."""

    def __init__(self, context: moderngl.Context) -> None:
        self.context = context
        self.counters = Counters()
        self._live: dict[int, Any] = {}

    def buffer(
        self, data: bytes | None = None, *, reserve: int = 0, dynamic: bool = False
    ) -> moderngl.Buffer:
        """Make a buffer from bytes, or an empty one of ``reserve`` bytes."""
        with graphics_errors(self.context, f"reserving {reserve or len(data or b'')} bytes"):
            return self._keep("buffer", self.context.buffer(data, reserve=reserve, dynamic=dynamic))

    def cube(self, size: int) -> moderngl.TextureCube:
        """Make an empty cube map of half floats, RGB, ``size`` texels along an edge."""
        with graphics_errors(self.context, f"making a cube map of {size} texels"):
            return self._keep("texture", self.context.texture_cube((size, size), 3, dtype="f2"))

    def cube_of(self, size: int, dtype: str) -> moderngl.TextureCube:
        """Make an empty RGBA cube map (``f1``, ``f2`` or ``f4``)."""
        with graphics_errors(self.context, f"making a cube map of {size} texels"):
            return self._keep("texture", self.context.texture_cube((size, size), 4, dtype=dtype))

    def texture_3d(self, size: tuple[int, int, int]) -> moderngl.Texture3D:
        """Make an empty 3-D texture of half floats, RGBA, filtered linearly and held at its edges."""
        with graphics_errors(self.context, f"making a stack of {size[2]} maps of {size[0]} texels"):
            made = self._keep("texture", self.context.texture3d(size, 4, dtype="f2"))
            made.repeat_x = made.repeat_y = made.repeat_z = False
            made.filter = (moderngl.LINEAR, moderngl.LINEAR)
            return made

    def ramp(self, size: tuple[int, int]) -> moderngl.Texture:
        """Make an empty RGBA texture of 32-bit floats, filtered linearly and held at its edges."""
        with graphics_errors(self.context, f"making a table of {size[0]}x{size[1]} numbers"):
            made = self._keep("texture", self.context.texture(size, 4, dtype="f4"))
            made.repeat_x = made.repeat_y = False
            made.filter = (moderngl.LINEAR, moderngl.LINEAR)
            return made

    def texture(self, size: tuple[int, int], dtype: str, samples: int = 0) -> moderngl.Texture:
        """Make an empty RGBA texture (``f1``, ``f2`` or ``f4``), multisampled where ``samples`` > 1."""
        with graphics_errors(self.context, f"making an image of {size[0]}x{size[1]} pixels"):
            return self._keep("texture", self.context.texture(size, 4, samples=samples, dtype=dtype))

    def depth(self, size: tuple[int, int], samples: int) -> moderngl.Renderbuffer:
        """Make a depth buffer that fits :meth:`texture`."""
        with graphics_errors(self.context, f"making a depth buffer of {size[0]}x{size[1]} pixels"):
            return self._keep("renderbuffer", self.context.depth_renderbuffer(size, samples=samples))

    def framebuffer(
        self, colour: moderngl.Texture, depth: moderngl.Renderbuffer | None = None
    ) -> moderngl.Framebuffer:
        """Make a framebuffer of one colour texture."""
        with graphics_errors(self.context, "making a framebuffer"):
            return self._keep("framebuffer", self.context.framebuffer([colour], depth))

    def framebuffer_of(
        self, colours: Sequence[moderngl.Texture], depth: moderngl.Renderbuffer
    ) -> moderngl.Framebuffer:
        """Make a framebuffer of several colour textures."""
        with graphics_errors(self.context, "making a framebuffer of several images"):
            return self._keep("framebuffer", self.context.framebuffer(list(colours), depth))

    def query(self) -> Any:
        """Make a query that counts samples; it goes with the context."""
        with graphics_errors(self.context, "making a query"):
            return self.context.query(samples=True)

    def program(self, vertex: ShaderSource, fragment: ShaderSource) -> moderngl.Program:
        """Compile and link a program."""
        return self._keep("program", compile_program(self.context, vertex, fragment))

    def vertex_array(self, program: moderngl.Program, *content: Any) -> moderngl.VertexArray:
        """Make a vertex array; ``content`` as moderngl wants it: (list of buffers, index buffer)."""
        with graphics_errors(self.context, "making a vertex array"):
            made = (
                self.context.vertex_array(program, *content)
                if content
                else self.context.vertex_array(program, [])
            )
            return self._keep("vertex array", made)

    @property
    def live(self) -> list[Any]:
        """What was made and not given back, in the order in which it was made."""
        return list(self._live.values())

    def release(self, made: Any) -> None:
        """Give one object back; nothing happens where it is gone already."""
        if self._live.pop(id(made), None) is not None:
            if isinstance(made, moderngl.Framebuffer):
                # moderngl goes back to the last used framebuffer by its number, even when it is gone.
                self.context.detect_framebuffer(0).use()
            made.release()
            self.counters.released += 1

    def release_all(self) -> None:
        """Give everything back."""
        for made in self.live:
            self.release(made)

    def _keep(self, kind: str, made: _Object) -> _Object:
        self._live[id(made)] = made
        self.counters.created[kind] = self.counters.created.get(kind, 0) + 1
        return made
