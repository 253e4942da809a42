"""Whether a window can be opened: real sockets, with and without anybody behind them."""

from __future__ import annotations

import socket
import sys
from pathlib import Path

import pytest

from brdf_suite import screen
from brdf_suite.screen import screen_missing

pytestmark = pytest.mark.skipif(
    not sys.platform.startswith("linux"), reason="other systems always have a screen"
)


@pytest.fixture(autouse=True)
def bare(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    monkeypatch.setattr(screen, "_X_SOCKETS", str(tmp_path))


def server(address: str) -> socket.socket:
    listening = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    listening.bind(address)
    listening.listen(4)
    return listening


def test_nothing_is_set() -> None:
    assert "neither DISPLAY nor WAYLAND_DISPLAY" in (screen_missing() or "")


@pytest.mark.parametrize("abstract", [False, True])
def test_an_x_server_that_answers_and_what_it_leaves(monkeypatch, tmp_path: Path, abstract: bool) -> None:
    monkeypatch.setenv("DISPLAY", ":71.0")
    assert "nothing answers at DISPLAY :71.0" in (screen_missing() or "")
    with server(f"{chr(0) if abstract else ''}{tmp_path}/X71"):
        assert screen_missing() is None
    assert (tmp_path / "X71").exists() is not abstract
    assert "nothing answers" in (screen_missing() or "")


def test_an_x_server_across_the_network(monkeypatch) -> None:
    with socket.create_server(("127.0.0.1", 0)) as listening:
        number = listening.getsockname()[1] - 6000
        if number < 0:
            pytest.skip("the port is below those of X")
        monkeypatch.setenv("DISPLAY", f"localhost:{number}.0")
        assert screen_missing() is None
    assert "nothing answers" in (screen_missing() or "")


@pytest.mark.parametrize("display", ["nonsense", ":", ":x", "localhost:99999999", f"{'x' * 99}:0"])
def test_a_display_that_is_none(monkeypatch, display: str) -> None:
    monkeypatch.setenv("DISPLAY", display)
    assert "nothing answers" in (screen_missing() or "")


def test_wayland_or_else_x(monkeypatch, tmp_path: Path) -> None:
    monkeypatch.setenv("WAYLAND_DISPLAY", "wayland-0")
    assert "WAYLAND_DISPLAY wayland-0" in (screen_missing() or "")
    with server(f"{tmp_path}/wayland-0"):
        assert screen_missing() is None
    monkeypatch.setenv("DISPLAY", ":71")
    assert "WAYLAND_DISPLAY wayland-0 or DISPLAY :71" in (screen_missing() or "")
    with server(f"{tmp_path}/X71"):
        assert screen_missing() is None


def test_a_platform_of_qt_that_needs_no_server(monkeypatch) -> None:
    monkeypatch.setenv("QT_QPA_PLATFORM", "offscreen")
    assert screen_missing() is None
    monkeypatch.setenv("QT_QPA_PLATFORM", "xcb")
    assert screen_missing() is not None
