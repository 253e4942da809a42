"""Every test here has a screen, settings and a live link of its own."""

from __future__ import annotations

import importlib.util
import uuid
from pathlib import Path

import pytest

_spec = importlib.util.spec_from_file_location("xvfb", Path(__file__).with_name("xvfb.py"))
xvfb = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(xvfb)


@pytest.fixture(scope="session", autouse=True)
def screen() -> None:
    """The display on which this session's widgets are shown."""
    xvfb.use_screen()


@pytest.fixture(autouse=True)
def own_session(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """No test touches a user's settings, or speaks with a program that is open."""
    monkeypatch.setenv("BRDF_SUITE_SETTINGS", str(tmp_path / "settings"))
    monkeypatch.setenv("BRDF_SUITE_LINK", f"test-{uuid.uuid4().hex[:12]}")
