"""The colours of the monitor that a window is on, as far as the platform provides them.

X11: the ICC profile in the property ``_ICC_PROFILE`` of the root window (ICC Profiles in X, 0.4), ``_ICC_PROFILE_1``
for the second monitor and so on. Windows: the profile that the system has for the monitor. macOS and Wayland convert
by themselves what a window declares to be sRGB, which :func:`brdf_qt.program.application.surface_format` does; whether
they took it stands in the window's format afterwards. Where there is no profile, or it cannot be used, sRGB is assumed,
and that is said.
"""

from __future__ import annotations

import ctypes
import logging
import sys
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

from PySide6.QtGui import QGuiApplication, QScreen
from PySide6.QtWidgets import QWidget

from brdf_qt.program.application import declared_colour_space
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import tr
from brdf_suite.appearance.colour.spaces import SRGB_SPACE, DisplaySpace
from brdf_suite.errors import FileError
from brdf_suite.files.images.icc import LARGEST_PROFILE, read_display_profile

log = logging.getLogger(__name__)


@dataclass(frozen=True, eq=False)
class Monitor:
    """What is known of a monitor: its colours, and in words where they come from.

    ``is_measured`` says whether they are the monitor's own; otherwise they are sRGB.
    """

    space: DisplaySpace
    description: str
    is_measured: bool


def monitor_of(widget: QWidget | None, platform: str | None = None) -> Monitor:
    """Return what the platform (Qt's name of it) provides for the screen and the window of a widget."""
    platform = platform or QGuiApplication.platformName()
    screen = None if widget is None else widget.screen()
    data: bytes | None = None
    text = tr("No monitor profile found; assuming sRGB")
    if declared_colour_space(platform).isValid():
        if not _is_declared(widget):
            text = tr("sRGB; the window system does not manage colour")
        elif platform == "cocoa":
            text = tr("sRGB, which macOS converts to the monitor's profile")
        else:
            text = tr("sRGB, which the Wayland compositor converts to the monitor's profile")
    elif platform == "xcb":
        data = _x11_profile(screen)
    elif platform == "windows":
        data = _windows_profile(screen)
    if data is None:
        return Monitor(SRGB_SPACE, text, False)
    try:
        space = _read_space(data)
    except FileError as error:
        log.warning("monitor: %s", error)
        text = tr("The monitor's profile {reason}; assuming sRGB").format(reason=tr_core(error.reason))
        return Monitor(SRGB_SPACE, text, False)
    text = tr("Monitor profile: {title}")
    if space.table is not None:
        text = tr("Monitor profile: {title} (look-up tables)")
    return Monitor(space, text.format(title=space.title), True)


@lru_cache(maxsize=2)
def _read_space(data: bytes) -> DisplaySpace:
    """Read a profile; the same one is the same space, so that nothing is drawn anew for it."""
    return read_display_profile(data, "the monitor's profile")


def _is_declared(widget: QWidget | None) -> bool:
    """Return whether the window system took the colour space that the widget's window declares.

    Qt takes it out of the window's format where a compositor has no protocol for it.
    """
    handle = None if widget is None else widget.window().windowHandle()
    return handle is not None and handle.format().colorSpace().isValid()


def _x11_profile(screen: QScreen | None) -> bytes | None:
    """Read the property by a connection of our own: Qt's own one is not to be waited on behind its back."""
    try:
        # By its own name, as Qt's plug-in has loaded it: looking for it would start the compiler of the search path.
        x11 = ctypes.CDLL("libX11.so.6")
    except OSError:
        return None
    x11.XOpenDisplay.restype = ctypes.c_void_p
    display = ctypes.c_void_p(x11.XOpenDisplay(None))
    if not display:
        return None
    try:
        number = QGuiApplication.screens().index(screen) if screen in QGuiApplication.screens() else 0
        return _property(x11, display, "_ICC_PROFILE" if number == 0 else f"_ICC_PROFILE_{number}")
    finally:
        x11.XCloseDisplay(display)


def _property(x11: Any, display: ctypes.c_void_p, name: str) -> bytes | None:
    x11.XInternAtom.restype = ctypes.c_ulong
    x11.XDefaultRootWindow.restype = ctypes.c_ulong
    atom = x11.XInternAtom(display, name.encode(), 1)  # only where it is known to the server
    if not atom:
        return None
    root = ctypes.c_ulong(x11.XDefaultRootWindow(display))
    kind, form = ctypes.c_ulong(), ctypes.c_int()
    count, left = ctypes.c_ulong(), ctypes.c_ulong()
    data = ctypes.POINTER(ctypes.c_ubyte)()
    whole = (ctypes.c_long(0), ctypes.c_long(LARGEST_PROFILE // 4))
    wanted = (ctypes.c_ulong(atom), *whole, 0, ctypes.c_ulong(0))
    results = (ctypes.byref(out) for out in (kind, form, count, left, data))
    failed = x11.XGetWindowProperty(display, root, *wanted, *results)
    if failed or not data:
        return None
    try:
        return bytes(data[: count.value]) if form.value == 8 and count.value else None
    finally:
        x11.XFree(data)


def _windows_profile(screen: QScreen | None) -> bytes | None:
    if sys.platform != "win32" or screen is None:
        return None
    gdi = ctypes.WinDLL("gdi32")
    gdi.CreateDCW.restype = ctypes.c_void_p
    context = ctypes.c_void_p(gdi.CreateDCW(screen.name(), None, None, None))
    if not context:
        return None
    try:
        length = ctypes.c_ulong(1024)
        path = ctypes.create_unicode_buffer(length.value)
        if not gdi.GetICMProfileW(context, ctypes.byref(length), path):
            return None
        return Path(path.value).read_bytes()
    except OSError as error:
        log.warning("monitor: its profile cannot be read: %s", error)
        return None
    finally:
        gdi.DeleteDC(context)
