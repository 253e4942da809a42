"""Every test here has settings of its own; widgets are shown on Qt's offscreen platform by default."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")


@pytest.fixture(autouse=True)
def own_settings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of this test's settings."""
    folder = tmp_path / "settings"
    monkeypatch.setenv("BRDF_SUITE_SETTINGS", str(folder))
    return folder
