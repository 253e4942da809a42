"""The widgets that choose a paint: the first, the second that it is compared with, and that of two-tone paint.

All have the signals and setters of :class:`SourceChooser`; nothing else of the window knows what they are.
"""

from __future__ import annotations

from brdf_qt.choosing.picker import SourceChooser
from brdf_qt.program.translation import tr


def paint_picker() -> SourceChooser:
    """Return what chooses the paint on show."""
    return SourceChooser(tr("Open a paint (.brdfpaint) or a measured file"))


def second_picker() -> SourceChooser:
    """Return what chooses B, a paint or a picture."""
    return SourceChooser(tr("Open a paint, a measured file or a picture (.exr, .png) as B"))


def two_tone_picker() -> SourceChooser:
    """Return what chooses the second paint of a two-tone surface."""
    return SourceChooser(tr("Open a second paint"))
