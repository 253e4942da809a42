"""Every test here has settings and a live link of its own, on Qt's offscreen platform unless told otherwise."""

from __future__ import annotations

import os
import uuid
from pathlib import Path

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")


@pytest.fixture(autouse=True)
def own_session(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """No test touches a user's settings, or speaks with a program that is open."""
    monkeypatch.setenv("BRDF_SUITE_SETTINGS", str(tmp_path / "settings"))
    monkeypatch.setenv("BRDF_SUITE_LINK", f"test-{uuid.uuid4().hex[:12]}")
    return tmp_path / "settings"
