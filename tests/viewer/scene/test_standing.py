"""The question how a mesh stands: asked once over the picture, shown in it, kept in the view."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest


def write_box(path: Path, size: tuple[float, float, float]) -> None:
    """A box that stands on z = 0, with y to both sides."""
    x, y, z = size
    corners = [(a * x / 2, b * y / 2, c * z) for a in (-1, 1) for b in (-1, 1) for c in (0, 1)]
    faces = ("1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6")
    lines = ["v {} {} {}".format(*corner) for corner in corners] + [f"f {face}" for face in faces]
    path.write_text("\n".join(lines))


def press(viewer, field: str, key: str) -> None:
    group = viewer.controller.standing.panel.choices[field]
    QTest.mouseClick(next(b for b in group.buttons() if b.objectName() == key), Qt.MouseButton.LeftButton)


def extent(viewer) -> np.ndarray:
    low, high = viewer.state.surface.value.bounds()
    return high - low


def open_mesh(viewer, path: Path) -> None:
    viewer.controller.open_file(str(path))
    viewer.qtbot.waitUntil(lambda: viewer.state.surface.key == str(path))


def test_a_mesh_of_millimetres_with_z_up_is_proposed_upright(viewer, qtbot, tmp_path) -> None:
    path = tmp_path / "tall.obj"
    write_box(path, (1000.0, 500.0, 2000.0))
    open_mesh(viewer, path)
    panel = viewer.controller.standing.panel
    qtbot.waitUntil(panel.isVisible)
    look = viewer.view.surface_look
    assert (look.up, look.unit) == ("z", "mm")
    qtbot.waitUntil(lambda: extent(viewer) == pytest.approx([1.0, 2.0, 0.5]))
    qtbot.waitUntil(lambda: panel.extent.text() == "Now 1 × 0.5 m, 2 m high")
    press(viewer, "unit", "in")
    qtbot.waitUntil(lambda: extent(viewer) == pytest.approx([25.4, 50.8, 12.7]))
    press(viewer, "unit", "mm")
    press(viewer, "up", "y")
    qtbot.waitUntil(lambda: extent(viewer) == pytest.approx([1.0, 0.5, 2.0]))
    QTest.mouseClick(panel.done, Qt.MouseButton.LeftButton)
    assert not panel.isVisible()
    viewer.controller.scene.open("surface", str(path))  # read again: it has been answered
    viewer.wait_idle()
    assert not panel.isVisible()
    assert viewer.view.surface_look.up == "y"
    viewer.controller.scene.open("surface", "sphere")  # another surface is taken as its file says
    qtbot.waitUntil(lambda: viewer.state.surface.key == "sphere")
    assert (viewer.view.surface_look.up, viewer.view.surface_look.unit) == ("file", "file")


def test_what_stands_is_not_asked(viewer, tmp_path) -> None:
    path = tmp_path / "car.obj"
    write_box(path, (2.0, 1.0, 1.0))
    text = path.read_text().splitlines()
    upright = [f"v {x} {z} {y}" for x, y, z in (line.split()[1:] for line in text if line[0] == "v")]
    path.write_text("\n".join([*upright, *(line for line in text if line[0] == "f")]))
    open_mesh(viewer, path)
    viewer.wait_idle()
    assert not viewer.controller.standing.panel.isVisible()
    assert viewer.view.surface_look.up == "file"


def test_of_a_cad_file_the_fineness_is_asked(viewer, qtbot, tmp_path, load_helper) -> None:
    pytest.importorskip("cascadio")
    path = load_helper("mesh_writers.py").VARIANTS["step"](1, tmp_path).path
    open_mesh(viewer, path)
    panel = viewer.controller.standing.panel
    qtbot.waitUntil(panel.isVisible)
    assert panel.question.text() == "Is it upright, the right size, and fine enough?"
    assert panel.fineness.isVisible()
    before = viewer.state.surface.value
    panel.fineness.setValue(1.5)
    assert viewer.view.surface_look.tessellation_mm == 1.5
    qtbot.waitUntil(lambda: viewer.state.surface.value is not before)
    assert panel.fineness.value() == 1.5
    QTest.mouseClick(panel.done, Qt.MouseButton.LeftButton)
    assert not panel.isVisible()
    box = tmp_path / "tall.obj"
    write_box(box, (1000.0, 500.0, 2000.0))
    open_mesh(viewer, box)
    qtbot.waitUntil(panel.isVisible)
    assert not panel.fineness.isVisible()
    assert panel.question.text() == "Is it upright, and the right size?"
