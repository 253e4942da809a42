"""A wheel over a field that has not the focus scrolls what lies below it, and changes nothing."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest
from brdf_qt.fields.colour_slider import ColourSlider
from brdf_qt.fields.number import NumberField
from brdf_qt.fields.quiet import QuietComboBox, QuietSlider, QuietSpinBox, quieten
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QColorDialog, QDialog, QFileDialog, QLineEdit, QScrollArea, QVBoxLayout, QWidget

APPS = Path(__file__).resolve().parent.parent.parent / "apps"
LOUD = {
    "QComboBox",
    "QSpinBox",
    "QDoubleSpinBox",
    "QSlider",
    "QDial",
    "QFontComboBox",
    "QDateEdit",
    "QTimeEdit",
}
BASES = {"brdf_qt/fields/quiet.py", "brdf_qt/fields/number.py", "brdf_qt/fields/colour_slider.py"}


def made_list() -> QuietComboBox:
    box = QuietComboBox()
    box.addItems(["one", "two", "three"])
    box.setCurrentIndex(1)
    return box


def made_number() -> QuietSpinBox:
    return QuietSpinBox(minimum=0, maximum=9, value=5)


def made_slider() -> QuietSlider:
    slider = QuietSlider(Qt.Orientation.Horizontal)
    slider.setRange(0, 100)
    slider.setValue(50)
    return slider


MADE = {
    "list": made_list,
    "whole number": made_number,
    "slider": made_slider,
    "number": lambda: NumberField("Gloss", "GU", 0.0, 200.0, 1.0, 1, 90.0),
    "colour": lambda: ColourSlider("Lightness"),
}


@pytest.mark.parametrize("kind", MADE)
def test_the_wheel_goes_on_to_the_scroll_area(kind: str, walks, qtbot) -> None:
    area, inside, field, other = QScrollArea(), QWidget(), MADE[kind](), QLineEdit()
    qtbot.addWidget(area)
    column = QVBoxLayout(inside)
    column.addWidget(other)
    column.addSpacing(60)
    column.addWidget(field)
    column.addSpacing(2000)
    area.setWidget(inside)
    area.setWidgetResizable(True)
    area.resize(300, 300)
    area.show()
    qtbot.waitExposed(area)
    area.activateWindow()
    bar = area.verticalScrollBar()
    before = walks.read_value(field)

    def turned(notches: int) -> int:
        """How far the area has scrolled by the wheel over the field."""
        bar.setValue(20)
        walks.turn_wheel(field, notches)
        return bar.value() - 20

    other.setFocus()
    qtbot.waitUntil(other.hasFocus)
    assert turned(-1) > 0
    assert walks.read_value(field) == before
    assert other.hasFocus()
    assert field.focusPolicy() != Qt.FocusPolicy.WheelFocus
    # With the focus, numbers and sliders take it, and lists do not.
    field.setFocus()
    qtbot.waitUntil(field.hasFocus)
    scrolled = turned(1)
    assert (walks.read_value(field) == before) == (kind == "list")
    assert (scrolled < 0) == (kind == "list")


def test_all_fields_are_of_these_classes() -> None:
    for path in sorted(APPS.rglob("*.py")):
        if path.relative_to(APPS).as_posix() in BASES:
            continue
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            used = set()
            if isinstance(node, ast.Call):
                used = {ast.unparse(node.func).split(".")[-1]}
            elif isinstance(node, ast.ClassDef):
                used = {ast.unparse(base).split(".")[-1] for base in node.bases}
            assert not used & LOUD, f"{path.name}: {used & LOUD}"


@pytest.mark.parametrize("make", [QColorDialog, QFileDialog])
def test_dialogs_of_qt_leave_the_wheel_too(make: type[QDialog], walks, qtbot) -> None:
    dialog = make()
    if isinstance(dialog, QColorDialog):
        dialog.setOption(QColorDialog.ColorDialogOption.DontUseNativeDialog)
    else:
        dialog.setOption(QFileDialog.Option.DontUseNativeDialog)
        dialog.setNameFilters(["Paints (*.brdfpaint)", "Tables (*.csv)", "All (*)"])
    qtbot.addWidget(dialog)
    quieten(dialog)
    dialog.show()
    qtbot.waitExposed(dialog)
    changed, count = walks.changed_by_wheel(dialog)
    assert count >= 2
    assert changed == []
