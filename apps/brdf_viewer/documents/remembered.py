"""What the Viewer shows when it starts again: the last environment, surface, background, Fresnel, tone curve and glare,
the speed of the turntable, how flakes are drawn, occlusion and ground, and how a comparison is shown.

Camera, exposure and the turn of the light start afresh: a picture that opens too dark or from behind would look
like a fault.
"""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, TypeVar

from PySide6.QtCore import QSettings

from brdf_suite.documents.view import View
from brdf_suite.errors import ValueRangeError
from brdf_suite.pipeline.scene import default_view, environment_names, in_environment, surface_names
from brdf_suite.regular_files import is_file

if TYPE_CHECKING:
    from _typeshed import DataclassInstance

T = TypeVar("T", bound="DataclassInstance")
_FIELDS = (
    "tone_curve",
    "background",
    "environment_layout",
    "fresnel",
    "look_up",
    "lamp_shading",
    "glare",
    "turntable_deg_s",
)
_PARTS = {
    "compare": ("rate_hz", "scale_delta_e", "basis"),
    "sparkle": ("mode", "light_count", "strength"),
    "surface_look": ("occlusion", "ground"),
}


def remember(store: QSettings, view: View) -> None:
    """Keep what is worth it."""
    for name in ("environment", "surface", *_FIELDS):
        store.setValue(f"view/{name}", getattr(view, name))
    store.setValue("view/background_colour", " ".join(f"{value:.6g}" for value in view.background_colour))
    for group, names in _PARTS.items():
        for name in names:
            store.setValue(f"{group}/{name}", getattr(getattr(view, group), name))


def recall(store: QSettings) -> View:
    """Return the default view with what was remembered; what is gone or damaged is left at its default."""
    default = view = default_view()
    shipped = environment_names()
    for field, names in (("environment", shipped), ("surface", surface_names())):
        found = str(store.value(f"view/{field}", ""))
        if found in names or is_file(found):
            view = _with(view, store, "view", (field,))
    view = in_environment(dataclasses.replace(view, environment=default.environment), view.environment)
    view = _with(view, store, "view", (*_FIELDS, "background_colour"))
    for group, parts in _PARTS.items():
        view = dataclasses.replace(view, **{group: _with(getattr(view, group), store, group, parts)})
    if view.environment in shipped:  # the layout is that of a file, which is gone
        view = dataclasses.replace(view, environment_layout=default.environment_layout)
    return view


def _with(value: T, store: QSettings, group: str, names: tuple[str, ...]) -> T:
    """Return ``value`` with those of its fields that were remembered and are valid."""
    for name in names:
        found = store.value(f"{group}/{name}")
        try:
            if found is not None:
                value = dataclasses.replace(value, **{name: _read(str(found), getattr(value, name))})
        except (ValueError, ValueRangeError):
            continue  # an edited settings file, or one of another version
    return value


def _read(text: str, like: object) -> object:
    """Return what a settings file holds as a value of the kind of ``like``: it gives all back as text.

    >>> _read("false", True), _read("8", 4), _read("0.5 0.5 1", (0.0, 0.0, 0.0)), _read("glints", "off")
    (False, 8, (0.5, 0.5, 1.0), 'glints')
    """
    if isinstance(like, bool):
        if text.lower() not in ("true", "false"):
            raise ValueError(text)
        return text.lower() == "true"
    if isinstance(like, int | float):
        return type(like)(text)
    if isinstance(like, tuple):
        return tuple(float(part) for part in text.split())
    return text
