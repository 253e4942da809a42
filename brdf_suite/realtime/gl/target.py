"""Framebuffers of a frame before and after finishing."""

from __future__ import annotations

import moderngl

from brdf_suite.realtime.gl.objects import GpuObjects


class LightTarget:
    """Exposed radiance of a frame, multisampled, with depth.

    Kept between frames and made again when the size, the sample count or the kind of its numbers changes: half
    floats, or whole ones where nothing may be cut off.
    """

    def __init__(self, objects: GpuObjects) -> None:
        self._objects = objects
        self._made: list[moderngl.Texture | moderngl.Renderbuffer | moderngl.Framebuffer] = []
        self._key: tuple[tuple[int, int], int, str] | None = None
        self._colour: moderngl.Texture | None = None
        self._framebuffer: moderngl.Framebuffer | None = None

    def prepare(
        self, size: tuple[int, int], samples: int, dtype: str = "f2"
    ) -> tuple[moderngl.Framebuffer, moderngl.Texture]:
        """Return the framebuffer to draw into and its colour texture."""
        if self._key != (size, samples, dtype) or self._colour is None or self._framebuffer is None:
            self.release()
            self._colour = self._objects.texture(size, dtype, samples)
            self._made.append(self._colour)
            depth = self._objects.depth(size, samples)
            self._made.append(depth)
            self._framebuffer = self._objects.framebuffer(self._colour, depth)
            self._made.append(self._framebuffer)
            self._key = (size, samples, dtype)
        return self._framebuffer, self._colour

    def release(self) -> None:
        """Give everything back."""
        for made in reversed(self._made):
            self._objects.release(made)
        self._made = []
        self._key = self._colour = self._framebuffer = None


class PictureTarget:
    """The finished picture of off-screen rendering: bytes, or floats."""

    def __init__(self, objects: GpuObjects) -> None:
        self._objects = objects
        self._key: tuple[tuple[int, int], str] | None = None
        self._texture: moderngl.Texture | None = None
        self._framebuffer: moderngl.Framebuffer | None = None

    def prepare(self, size: tuple[int, int], dtype: str = "f1") -> moderngl.Framebuffer:
        """Return a framebuffer of exactly this size."""
        if self._framebuffer is None or self._key != (size, dtype):
            self.release()
            self._texture = self._objects.texture(size, dtype)
            self._framebuffer = self._objects.framebuffer(self._texture)
            self._key = (size, dtype)
        return self._framebuffer

    def release(self) -> None:
        """Give everything back."""
        for made in (self._framebuffer, self._texture):
            if made is not None:
                self._objects.release(made)
        self._texture = self._framebuffer = self._key = None
