"""A factored paint in the Viewer: its maps in the light of lamps that move."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from brdf_suite.files.measured.brdftable import write_brdftable
from brdf_suite.reflectance.factored.model import Factored


@pytest.fixture
def factored(tmp_path: Path) -> Path:
    """A glossy red whose highlight is a map over the half vector."""
    ring = (np.arange(48) + 0.5) / 48
    path = tmp_path / "red.brdftable"
    grey = np.ones((8, 3), np.float32)
    gloss = (0.05 + np.exp(-((ring / 0.12) ** 2)))[:, None] * np.array([1.0, 0.1, 0.1])
    write_brdftable(Factored(grey, gloss.astype(np.float32), 0.6), path)
    return path


def test_lamps_move_over_a_factored_paint(viewer, factored, qtbot) -> None:
    QTest.mouseClick(viewer.window.lighting.preset_buttons["three"], Qt.MouseButton.LeftButton)
    viewer.wait_idle()
    assert len(viewer.view.lamps) == 3
    assert viewer.view.light_colour.brightness == 0.0
    viewer.controller.open_file(str(factored))
    qtbot.waitUntil(lambda: viewer.state.paint_key.endswith("red.brdftable"))
    viewer.wait_idle()
    assert "Factored" in viewer.window.paint.facts.text()
    before = viewer.pixels().astype(int)
    lit = before.max(axis=-1) > 20
    assert 0.02 < lit.mean() < 0.9
    assert (before[lit][:, 0] >= before[lit][:, 2]).mean() > 0.95
    # Drawn by its factors, not by its lobes.
    lobes = viewer.controller.drawer.scene_renderer
    fields = viewer.window.lighting.lamps
    fields.azimuth.setValue(150.0)
    moved = viewer.pixels().astype(int)
    assert np.abs(moved - before).max() > 60
    assert lobes.renderer.factors.features("paint")
    fields.shading.setCurrentIndex(fields.shading.findData("ball"))
    fields.shading.picked.emit("ball")
    assert viewer.view.lamp_shading == "ball"
    ball = viewer.pixels().astype(int)
    assert 0.0 < np.abs(ball - moved).mean() < 0.1 * moved.mean() + 2.0
    viewer.window.lighting.brightness.setValue(1.0)
    assert viewer.view.light_colour.brightness == 1.0
    assert viewer.pixels().mean() > ball.mean() + 5
