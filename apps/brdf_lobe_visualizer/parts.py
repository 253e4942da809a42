"""The parts of the window beside its own: views, plots, sections and commands, in the order of the inspector."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from brdf_qt.program.feature import Feature

from brdf_lobe_visualizer.basis.part import Basis
from brdf_lobe_visualizer.cuts.panel import Slices
from brdf_lobe_visualizer.factors.part import Factors
from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.view3d.panel import Space
from brdf_lobe_visualizer.window import LobeWindow

MakePart = Callable[[LobeSession, LobeWindow], Feature]

PARTS: tuple[MakePart, ...] = (Space, Slices, Basis, Factors)
"""What makes each part: called with session and window, it adds itself to the window and listens to the session.

Parts are made before the window is shown: what is heavy to import or to make waits for ``window.first_painted``.
"""


def build_parts(session: LobeSession, window: LobeWindow, parts: Sequence[MakePart] = PARTS) -> list[Feature]:
    """Make every part and return them; their owner keeps them."""
    return [part(session, window) for part in parts]
