"""Check for an available display before Qt starts: without one Qt aborts the process."""

from __future__ import annotations

import os
import socket
import sys
from pathlib import Path

_ANSWER_S = 2.0
_X_SOCKETS = "/tmp/.X11-unix"  # noqa: S108 - where X servers listen
_X_FIRST_PORT = 6000


def screen_missing() -> str | None:
    """Return the reason why no window can be opened here; ``None`` where one can."""
    platform = os.environ.get("QT_QPA_PLATFORM", "").partition(":")[0]
    if not sys.platform.startswith("linux") or platform not in {"", "xcb", "wayland", "wayland-egl"}:
        return None
    wayland, display = os.environ.get("WAYLAND_DISPLAY", ""), os.environ.get("DISPLAY", "")
    if not wayland and not display:
        return "there is no screen (neither DISPLAY nor WAYLAND_DISPLAY is set)"
    # Asked, not looked up: a killed server leaves its socket behind, and Qt ends the process where none answers.
    if (wayland and _wayland_answers(wayland)) or (display and _x_answers(display)):
        return None
    asked = [f"WAYLAND_DISPLAY {wayland}"] * bool(wayland) + [f"DISPLAY {display}"] * bool(display)
    return f"there is no screen (nothing answers at {' or '.join(asked)})"


def _wayland_answers(name: str) -> bool:
    return _answers(socket.AF_UNIX, str(Path(os.environ.get("XDG_RUNTIME_DIR", "")) / name))


def _x_answers(display: str) -> bool:
    host, _, rest = display.rpartition(":")
    number = rest.partition(".")[0]
    if not number.isdecimal():
        return False
    if host not in {"", "unix"}:
        return _answers(socket.AF_INET, (host, _X_FIRST_PORT + int(number)))
    path = f"{_X_SOCKETS}/X{number}"
    return _answers(socket.AF_UNIX, path) or _answers(socket.AF_UNIX, f"\0{path}")  # the second has no file


def _answers(family: socket.AddressFamily, address: str | tuple[str, int]) -> bool:
    with socket.socket(family, socket.SOCK_STREAM) as attempt:
        attempt.settimeout(_ANSWER_S)
        try:
            attempt.connect(address)
        except (OSError, OverflowError, UnicodeError):  # a port beyond the last, a host that is no name
            return False
    return True
