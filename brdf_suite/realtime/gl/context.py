"""Creation of windowless OpenGL contexts, and translation of OpenGL errors.

Inside a widget the toolkit has made the context already; :func:`adopt_context` takes the current one.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import moderngl
from moderngl import Context

from brdf_suite.errors import GraphicsError

__all__ = [
    "Context",
    "adopt_context",
    "create_context",
    "draws_in_software",
    "graphics_errors",
    "release_context",
]

REQUIRED_VERSION = 330

_HINT = {
    "linux": "Install Mesa's EGL (on Debian: apt-get install libegl1 libgl1-mesa-dri) or a graphics driver",
    "win32": "Install the graphics driver of the machine",
    "darwin": "OpenGL 3.3 needs a graphical login session on macOS",
}

_SOFTWARE = ("llvmpipe", "softpipe", "swiftshader", "software rasterizer")


def create_context() -> moderngl.Context:
    """Return a windowless context of OpenGL 3.3 core or newer.

    On Linux through EGL, which needs no display, or else through the X display; elsewhere the system's way.

    Raises
    ------
    GraphicsError
        There is none to be had; the message says why and what to install.
    """
    ways: list[dict[str, Any]] = [{}]
    if sys.platform.startswith("linux"):
        # The second form finds the libraries on machines without their development links.
        ways = [{"backend": "egl"}, {"backend": "egl", "libgl": "libGL.so.1", "libegl": "libEGL.so.1"}]
        if os.environ.get("DISPLAY"):
            ways.append({})
    reasons: list[str] = []
    for way in ways:
        try:
            context = moderngl.create_context(standalone=True, **way)
        except Exception as error:  # noqa: BLE001  (the loaders raise bare Exception, OSError or their own)
            reason = str(error).strip().splitlines()[0] if str(error).strip() else type(error).__name__
            if reason not in reasons:
                reasons.append(reason)
            continue
        return _checked(context, release_context)
    raise GraphicsError(f"No OpenGL 3.3 context could be made ({'; '.join(reasons)}). {_hint()}.")


def release_context(context: moderngl.Context) -> None:
    """Release a context of :func:`create_context`; after it no context is current in this thread.

    Where a context is destroyed while it is current it stays so. Windows that this process opens later then get no
    context of their own: GLX makes none current in a thread in which EGL has one (libglvnd).
    """
    with context:
        pass  # leaving the block makes none current
    context.release()


def adopt_context(load: Callable[[str], int] | None = None) -> moderngl.Context:
    """Return the context that a toolkit has made current, as inside ``initializeGL``.

    Parameters
    ----------
    load
        Address of an OpenGL function by name, 0 where unknown, as the toolkit gives it; needed with EGL and
        Wayland, and for a second context in one process. Without it the platform's own way is tried.

    Raises
    ------
    GraphicsError
        None is current, or it is older than OpenGL 3.3.
    """
    try:
        # With a loader, moderngl makes a new object; without, it may return one that it remembers.
        given: dict[str, Any] = {"context": _Loader(load)} if load else {}
        context = moderngl.create_context(**given)
    except Exception as error:
        raise GraphicsError(f"The window has no usable OpenGL context ({error}). {_hint()}.") from error
    return _checked(context, moderngl.Context.release)


class _Loader:
    """Function loader for moderngl of a context owned by another toolkit; it is current during our calls."""

    def __init__(self, load: Callable[[str], int]) -> None:
        self._load = load

    def load(self, name: str) -> int:
        """Return the address of a function."""
        return self._load(name)

    def release(self) -> None:
        """Do nothing: the toolkit owns the context."""

    def __enter__(self) -> _Loader:
        return self

    def __exit__(self, *_: object) -> None:
        """Do nothing: no context was made current."""


def draws_in_software(context: moderngl.Context) -> bool:
    """Return whether processors draw what a graphics card would, by the renderer's name; the context is current."""
    name = str(context.info.get("GL_RENDERER", "")).lower()
    return any(known in name for known in _SOFTWARE)


def _checked(context: moderngl.Context, release: Callable[[moderngl.Context], None]) -> moderngl.Context:
    if context.version_code < REQUIRED_VERSION:
        name = context.info.get("GL_RENDERER", "unknown")
        version = context.info.get("GL_VERSION", str(context.version_code))
        release(context)
        raise GraphicsError(f"OpenGL 3.3 is needed, but {name} offers {version}. {_hint()}.")
    return context


def _hint() -> str:
    return _HINT.get(sys.platform, "Install a graphics driver with OpenGL 3.3")


@contextmanager
def graphics_errors(context: moderngl.Context, doing: str) -> Iterator[None]:
    """Turn OpenGL's errors inside the block into :class:`GraphicsError`, "… failed while ``doing``".

    Errors that others left in the context before are dropped first.
    """
    context.clear_errors()
    try:
        yield
    except moderngl.Error as error:
        raise GraphicsError(f"The graphics driver failed while {doing}: {error}.") from error
    name = context.error
    if name != "GL_NO_ERROR":
        raise GraphicsError(f"The graphics driver failed while {doing}: {name}.")
