"""What Viewer of an earlier release has kept is taken over."""

from __future__ import annotations

import shutil
from pathlib import Path

import old_documents as old
from brdf_viewer.documents.remembered import recall, remember
from PySide6.QtCore import QSettings

KEPT = Path(__file__).resolve().parents[2] / "documents" / "old" / "0.1.0" / "settings"


def stored(path: Path) -> QSettings:
    return QSettings(str(path), QSettings.Format.IniFormat)


def test_viewer_starts_with_the_view_that_an_earlier_version_left(tmp_path) -> None:
    shutil.copy(KEPT / "Viewer.ini", tmp_path)
    remember(stored(tmp_path / "now.ini"), old.view())
    found = recall(stored(tmp_path / "Viewer.ini"))
    assert found == recall(stored(tmp_path / "now.ini"))
    assert (found.environment, found.surface, found.tone_curve, found.glare) == (
        "booth",
        "car",
        "aces",
        "eye",
    )
    assert (found.sparkle, found.turntable_deg_s) == (old.view().sparkle, -12.0)
