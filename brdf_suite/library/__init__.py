"""What ``import brdf_suite`` offers: functions over the rooms below, which take names, files and values alike."""

from __future__ import annotations

from brdf_suite.notebook import draw_with


def _drawn(value: object) -> str:
    """Return the drawing of a value as HTML, for notebooks."""
    from brdf_suite.library.drawings import (
        drawing_of,  # with numpy, which most names of the library need anyway
    )

    return drawing_of(value).svg


draw_with(_drawn)
