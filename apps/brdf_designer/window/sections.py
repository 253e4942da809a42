"""The parts of the desk that come as a section, a dock or a command of their own, in the order of the inspector."""

from __future__ import annotations

from collections.abc import Callable

from brdf_qt.program.feature import Feature

from brdf_designer.acquire.control import AcquireControl
from brdf_designer.coat_flakes.control import CoatControl
from brdf_designer.colour.commands import ColourCommands
from brdf_designer.colour.offer import NearestOffer
from brdf_designer.export.control import HandoverControl
from brdf_designer.history.control import HistoryControl
from brdf_designer.measured.control import MeasuredControl
from brdf_designer.preview.preview import PreviewControl
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.standard.control import StandardControl
from brdf_designer.variations.control import VariationsControl
from brdf_designer.variations.interpolation_control import InterpolationControl
from brdf_designer.window.window import DesignerWindow

PARTS: tuple[Callable[[PaintSession, DesignerWindow], Feature], ...] = (
    ColourCommands,
    CoatControl,
    NearestOffer,
    PreviewControl,
    HistoryControl,
    StandardControl,
    VariationsControl,
    HandoverControl,
    InterpolationControl,
    MeasuredControl,
    AcquireControl,
)
"""What makes each part: called with desk and window, it adds itself to the window and listens to the desk.

Parts are made before the window is shown. What costs time at a start belongs into :meth:`PaintSession.at_idle`.
"""


def build_sections(desk: PaintSession, window: DesignerWindow) -> list[Feature]:
    """Make every part and return them; their owner keeps them."""
    return [part(desk, window) for part in PARTS]
