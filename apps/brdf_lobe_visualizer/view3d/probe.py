"""Reading a lobe under the cursor: direction of view, aspecular angle and value."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from brdf_qt.program.translation import tr
from PySide6.QtCore import QEvent, QObject, QPointF, Qt, QTimer
from PySide6.QtGui import QMouseEvent

from brdf_lobe_visualizer.cuts.crosshair import number
from brdf_lobe_visualizer.cuts.words import UNIT
from brdf_lobe_visualizer.view3d.scene import Probe
from brdf_suite.geometry.directions import angle_between
from brdf_suite.inspection.lobe_surface.occlusion import value_along

if TYPE_CHECKING:
    from brdf_lobe_visualizer.view3d.view import LobeView

_REST_MS = 30
"""The cursor is asked about once it moves no more for so long: a ray costs as much as a surface."""


class SpaceProbe(QObject):
    """Marks the point of the first solid lobe under the cursor and writes what it is."""

    def __init__(self, view: LobeView) -> None:
        super().__init__(view)
        self._view = view
        self._at: QPointF | None = None
        self._rest = QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.setInterval(_REST_MS)
        self._rest.timeout.connect(self.look)
        view.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kind = event.type()
        if (
            isinstance(event, QMouseEvent)
            and kind == QEvent.Type.MouseMove
            and event.buttons() == Qt.MouseButton.NoButton
        ):
            self._at = event.position()
            self._rest.start()
        elif kind in (QEvent.Type.Leave, QEvent.Type.MouseButtonPress, QEvent.Type.Wheel):
            self._at = None
            self._rest.stop()
            self._view.set_probe(None)
        return super().eventFilter(watched, event)

    def look(self) -> None:
        """Read what is under the cursor now."""
        if self._at is None:
            return
        probe = self._view.probe_at(self._at)
        self._view.set_probe(probe, "" if probe is None else words_of(probe))


def words_of(probe: Probe) -> str:
    """Return direction, aspecular angle and value of a point of a lobe."""
    view = probe.place / np.linalg.norm(probe.place)
    theta = np.degrees(np.arctan2(np.hypot(view[0], view[1]), view[2]))
    # As the labels of the frame count azimuth: 0 where the light of azimuth 0 stands.
    phi = (np.degrees(np.arctan2(view[1], view[0])) + 180.0) % 360.0
    gamma = np.degrees(angle_between(probe.grid.mirror, view))
    value = value_along(probe.surface, probe.grid, view)
    text = tr("θo {theta}°  φo {phi}°  γ {gamma}°  {value} {unit}")
    return text.format(
        theta=f"{theta:.1f}", phi=f"{phi:.1f}", gamma=f"{gamma:.1f}", value=number(value), unit=UNIT
    )
