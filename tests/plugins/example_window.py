"""Opens the example's model in Lobe Visualizer on an X server of its own, drags a slider, and prints what it sees."""

from __future__ import annotations

import importlib.util
import json
import os
import tempfile
import time
import uuid
from collections.abc import Callable
from pathlib import Path

from brdf_lobe_visualizer.assembly import LobeVisualizer
from brdf_lobe_visualizer.model_text.section import NumberSlider
from brdf_qt.program.application import create_application
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from brdf_suite.geometry.directions import spherical

_FILE = Path(__file__).parent.parent / "qt_gl" / "xvfb.py"
_spec = importlib.util.spec_from_file_location("xvfb", _FILE)
xvfb = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(xvfb)


def wait(condition: Callable[[], object]) -> None:
    """Let the window work until a condition holds."""
    ends = time.monotonic() + 300.0
    while not condition():
        QApplication.processEvents()
        time.sleep(0.01)
        if time.monotonic() > ends:
            raise TimeoutError


def drag(row: NumberSlider) -> None:
    """Drag the handle of a slider to the right end by the mouse."""
    slider = row.slider
    middle = slider.height() // 2
    share = slider.value() / slider.maximum()
    handle = QPoint(round(8 + share * (slider.width() - 16)), middle)
    button = Qt.MouseButton.LeftButton
    QTest.mousePress(slider, button, Qt.KeyboardModifier.NoModifier, handle)
    for x in range(handle.x(), slider.width() + 40, 12):
        QTest.mouseMove(slider, QPoint(x, middle))
        QApplication.processEvents()
    QTest.mouseRelease(slider, button, Qt.KeyboardModifier.NoModifier, QPoint(slider.width() + 40, middle))


def main() -> None:
    """Print one line of JSON."""
    xvfb.use_screen()
    os.environ["BRDF_SUITE_SETTINGS"] = tempfile.mkdtemp()
    os.environ["BRDF_SUITE_LINK"] = f"test-{uuid.uuid4().hex[:12]}"
    app = create_application("Lobe Visualizer")
    program = LobeVisualizer((), asked=["velvet"])
    program.window.resize(1300, 800)
    program.start_when_painted()
    program.window.show()
    wait(lambda: program.session.subjects and program.is_idle)
    tree = program.panel.tree

    def models_of_plugins() -> list[str]:
        groups = [tree.topLevelItem(place) for place in range(tree.topLevelItemCount())]
        return [
            group.child(place).text(0)
            for group in groups
            if group.text(0) == "Models of plug-ins"
            for place in range(group.childCount())
        ]

    wait(models_of_plugins)
    section = program.models.section

    def rows() -> dict[str, float]:
        return {key: row.number.value() for key, row in section.rows.items() if isinstance(row, NumberSlider)}

    def red_green() -> tuple[float, float]:
        front = program.session.front
        assert front is not None
        values = front.reflectance.eval(spherical(0.2, 0.0), spherical(0.9, 2.0))
        return float(values[0]), float(values[1])

    wait(lambda: section.rows)
    seen = {"listed": models_of_plugins(), "rows": rows()}
    seen["red_before"], seen["green_before"] = red_green()
    drag(section.rows["sheen"])
    wait(lambda: rows()["sheen"] == 1.0 and program.is_idle)
    seen["after"] = rows()
    seen["red_after"], seen["green_after"] = red_green()
    program.close()
    print(json.dumps(seen))
    app.quit()


if __name__ == "__main__":
    main()
