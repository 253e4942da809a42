"""Creation, release and counting of all OpenGL objects of the renderer.

The counts are the proof that a path makes none: an edit of a paint must write a buffer and nothing else.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, TypeVar

import moderngl

from brdf_suite.realtime.gl.context import graphics_errors
from brdf_suite.realtime.gl.shader_source import ShaderSource, compile_program, compose

ScreenProgram = tuple[moderngl.Program, moderngl.VertexArray]
"""A program that draws without a mesh, and the vertex array to draw it with."""
Size = tuple[int, int]
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
        self._screens: dict[tuple[str, str, frozenset[tuple[str, str]]], ScreenProgram] = {}

    def bind(
        self,
        framebuffer: moderngl.Framebuffer | int,
        size: Size,
        region: tuple[int, int, int, int] | None = None,
        *,
        depth: bool = False,
    ) -> None:
        """Draw into a framebuffer of ``size`` from now on, or only into a region: left, lower edge, width, height.

        A framebuffer of another library is given by its number.
        """
        if isinstance(framebuffer, int):
            framebuffer = self.context.detect_framebuffer(framebuffer)
        framebuffer.use()
        self.context.viewport = (0, 0, *size)
        self.context.scissor = region
        self.context.enable_only(moderngl.DEPTH_TEST if depth else moderngl.NOTHING)
        if depth:
            self.context.depth_func = "<="

    def buffer(
        self, data: bytes | None = None, *, reserve: int = 0, dynamic: bool = False
    ) -> moderngl.Buffer:
        """Make a buffer from bytes, or an empty one of ``reserve`` bytes."""
        with graphics_errors(self.context, f"reserving {reserve or len(data or b'')} bytes"):
            return self._keep("buffer", self.context.buffer(data, reserve=reserve, dynamic=dynamic))

    def cube(self, size: int, channels: int = 3, dtype: str = "f2") -> moderngl.TextureCube:
        """Make an empty cube map (``f1``, ``f2`` or ``f4``), ``size`` texels along an edge."""
        with graphics_errors(self.context, f"making a cube map of {size} texels"):
            return self._keep("texture", self.context.texture_cube((size, size), channels, dtype=dtype))

    def texture_3d(
        self, size: tuple[int, int, int], channels: int = 4, dtype: str = "f2"
    ) -> moderngl.Texture3D:
        """Make an empty 3-D texture (``f2`` or ``f4``), filtered linearly and held at its edges."""
        with graphics_errors(self.context, f"making a stack of {size[2]} maps of {size[0]} texels"):
            made = self._keep("texture", self.context.texture3d(size, channels, dtype=dtype))
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

    def depth_texture(self, size: tuple[int, int]) -> moderngl.Texture:
        """Make a depth buffer that can be read as numbers, 0 to 1, one sample a pixel."""
        with graphics_errors(self.context, f"making a depth map of {size[0]}x{size[1]} pixels"):
            made = self._keep("texture", self.context.depth_texture(size))
            made.compare_func = ""
            made.filter = (moderngl.NEAREST, moderngl.NEAREST)
            made.repeat_x = made.repeat_y = False
            return made

    def framebuffer(
        self, *colours: moderngl.Texture, depth: moderngl.Renderbuffer | moderngl.Texture | None = None
    ) -> moderngl.Framebuffer:
        """Make a framebuffer of colour textures, or of depth alone."""
        with graphics_errors(self.context, "making a framebuffer"):
            return self._keep("framebuffer", self.context.framebuffer(list(colours), depth))

    def query(self) -> Any:
        """Make a query that counts samples; it goes with the context."""
        with graphics_errors(self.context, "making a query"):
            return self.context.query(samples=True)

    def program(self, vertex: ShaderSource, fragment: ShaderSource) -> moderngl.Program:
        """Compile and link a program."""
        return self._keep("program", compile_program(self.context, vertex, fragment))

    def screen(
        self, fragment: str, words: Mapping[str, str] | None = None, vertex: str = "screen.vert.glsl"
    ) -> ScreenProgram:
        """Return the program of these shader files, ``words`` defined in the fragment's; made at the first call."""
        key = (vertex, fragment, frozenset((words or {}).items()))
        if key not in self._screens:
            program = self.program(compose(vertex), compose(fragment, dict(words or {})))
            self._screens[key] = (program, self.vertex_array(program))
        return self._screens[key]

    def vertex_array(self, program: moderngl.Program, *content: Any) -> moderngl.VertexArray:
        """Make a vertex array; ``content`` as moderngl wants it: (list of buffers, index buffer)."""
        with graphics_errors(self.context, "making a vertex array"):
            return self._keep("vertex array", self.context.vertex_array(program, *(content or ([],))))

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


class Target:
    """A texture to draw into, with depth or without; made again when its size, numbers or sample count change."""

    def __init__(self, objects: GpuObjects, *, has_depth: bool = False) -> None:
        self._objects, self._has_depth = objects, has_depth
        self._key: tuple[Size, str, int] | None = None
        self._made: list[Any] = []

    def prepare(
        self, size: Size, dtype: str = "f1", samples: int = 0
    ) -> tuple[moderngl.Framebuffer, moderngl.Texture]:
        """Return a framebuffer of exactly this size and its colour texture, as :meth:`GpuObjects.texture` makes it."""
        if self._key != (size, dtype, samples):
            self.release()
            self._made.append(self._objects.texture(size, dtype, samples))
            self._made.append(self._objects.depth(size, samples) if self._has_depth else None)
            self._made.append(self._objects.framebuffer(self._made[0], depth=self._made[1]))
            self._key = (size, dtype, samples)
        texture, _, framebuffer = self._made
        return framebuffer, texture

    def release(self) -> None:
        """Give everything back."""
        for made in reversed(self._made):
            self._objects.release(made)
        self._made, self._key = [], None
