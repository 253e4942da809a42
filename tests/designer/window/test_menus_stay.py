"""What is taken away from the desk takes nothing else with it."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import QCoreApplication, QEvent
from shiboken6 import isValid

from brdf_suite.documents.paint import Measurement


def test_menus_outlive_the_fields_of_angles_that_are_gone(designer) -> None:
    """Python must not take the menus for deleted with the fields of two angles."""
    paint = designer.desk.paint
    more = tuple(Measurement(45.0, angle, (30.0, 0.0, -20.0)) for angle in (25.0, 75.0))
    designer.desk.set_paint(replace(paint, measurements=(*paint.measurements, *more)), "Five Angles")
    assert len(designer.window.editors.editors) == 5
    designer.window.undo_action.trigger()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    window = designer.window
    assert all(isValid(menu) for menu in (window.file_menu, window.recent_menu, window.help_menu))
    window.show_recent([])
