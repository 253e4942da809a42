"""How the user left the views: incidence, options, sizes; kept between runs, and put back by one command."""

from __future__ import annotations

import json
from typing import Any

from brdf_qt.program.settings import settings
from PySide6.QtWidgets import QSplitter

from brdf_lobe_visualizer.options import CHANNELS, COSINES, INCIDENCE_DEG, RADII, SHOWN
from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.window import LobeWindow

_VIEW_KEY = "lobes/view"
_SPLIT_KEY = "lobes/split"
_CHOICES: dict[str, tuple[str, ...]] = {
    "channel": CHANNELS,
    "radius": RADII,
    "cosine": COSINES,
    "shown": SHOWN,
}


def recall(session: LobeSession, window: LobeWindow) -> None:
    """Take up incidence, options and sizes of the last time; what is no value any more is left out."""
    try:
        stored: Any = json.loads(str(settings().value(_VIEW_KEY, "{}")))
    except (ValueError, RecursionError):
        stored = {}
    if not isinstance(stored, dict):
        return
    options = {name: stored[name] for name, choices in _CHOICES.items() if stored.get(name) in choices}
    session.set_options(**options)
    angles: Any = stored.get("incidence")
    sound = isinstance(angles, list) and all(isinstance(a, (int, float)) and abs(a) <= 360.0 for a in angles)
    if sound and len(angles) == len(INCIDENCE_DEG):
        session.set_incidence(*angles)
    for split in window.findChildren(QSplitter):
        state = settings().value(f"{_SPLIT_KEY}/{split.objectName()}")
        if split.objectName() and state is not None:
            split.restoreState(state)


def remember(session: LobeSession, window: LobeWindow) -> None:
    """Keep incidence, options and sizes for the next start; lobes that are switched off are not kept."""
    kept = {name: vars(session.options)[name] for name in _CHOICES}
    settings().setValue(_VIEW_KEY, json.dumps({**kept, "incidence": list(session.incidence)}))
    for split in window.findChildren(QSplitter):
        if split.objectName():
            settings().setValue(f"{_SPLIT_KEY}/{split.objectName()}", split.saveState())
