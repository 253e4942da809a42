"""What lies behind the lines of a plot: hatched bands where nothing was measured, and the rings of a polar plot."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPainterPath, QPalette
from PySide6.QtWidgets import QStyleOptionGraphicsItem, QWidget

from brdf_lobe_visualizer.cuts.pens import grey_pen, hatching_brush
from brdf_suite.arrays import Bools, Floats

SPOKE_STEP_DEG = 15


def bands_of(angle_deg: Floats, holes: Bools | None) -> list[tuple[float, float]]:
    """Return the spans (from, to) of the angles at which ``holes`` is set, half way to their neighbours."""
    if holes is None or not holes.any():
        return []
    edges = np.concatenate((angle_deg[:1], 0.5 * (angle_deg[1:] + angle_deg[:-1]), angle_deg[-1:]))
    steps = np.diff(np.concatenate(([0], holes.astype(np.int8), [0])))
    return [
        (float(edges[a]), float(edges[b]))
        for a, b in zip(np.flatnonzero(steps == 1), np.flatnonzero(steps == -1), strict=True)
    ]


class HoleBands(pg.GraphicsObject):  # type: ignore[misc]  # pyqtgraph has no types
    """Hatched from top to bottom over spans of x."""

    def __init__(self) -> None:
        super().__init__()
        self._bands: list[tuple[float, float]] = []
        self._brush = hatching_brush(QPalette())
        self.setZValue(-20)

    def show_bands(self, bands: Sequence[tuple[float, float]], palette: QPalette) -> None:
        """Hatch these spans."""
        self._brush = hatching_brush(palette)
        if list(bands) != self._bands:
            self._bands = list(bands)
            self.prepareGeometryChange()
        self.setVisible(bool(self._bands))
        self.update()

    def boundingRect(self) -> QRectF:
        view = self.viewRect()
        return QRectF() if view is None else view

    def paint(
        self, painter: QPainter, _option: QStyleOptionGraphicsItem, _widget: QWidget | None = None
    ) -> None:
        view = self.viewRect()
        if view is None:
            return
        # Hatched in pixels: in the plot's numbers the lines would be stretched with it.
        to_device = painter.transform()
        painter.save()
        painter.resetTransform()
        for low, high in self._bands:
            corner = to_device.map(QPointF(low, view.top()))
            other = to_device.map(QPointF(high, view.bottom()))
            painter.fillRect(QRectF(corner, other).normalized(), self._brush)
        painter.restore()


class PolarRings(pg.GraphicsObject):  # type: ignore[misc]  # pyqtgraph has no types
    """Rings of radii up to 1 and spokes of a half disc, the normal upwards; drawn once and kept."""

    def __init__(self) -> None:
        super().__init__()
        self._radii: tuple[float, ...] = ()
        self._palette = QPalette()
        self.setZValue(-20)
        # Drawn anew it takes 2 ms a frame; as a kept picture nothing.
        self.setCacheMode(self.CacheMode.DeviceCoordinateCache)

    def show_rings(self, radii: Sequence[float], palette: QPalette) -> None:
        """Draw these rings in the greys of ``palette``."""
        self._radii, self._palette = tuple(radii), QPalette(palette)
        self.update()

    def boundingRect(self) -> QRectF:
        return QRectF(-1.02, -0.02, 2.04, 1.06)

    def paint(
        self, painter: QPainter, _option: QStyleOptionGraphicsItem, _widget: QWidget | None = None
    ) -> None:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        rings, edge = QPainterPath(), QPainterPath()
        for radius in self._radii:
            path = edge if radius > 0.999 else rings
            path.arcMoveTo(QRectF(-radius, -radius, 2 * radius, 2 * radius), 0.0)
            # The plot's y grows upwards, Qt's downwards: the upper half is below for it.
            path.arcTo(QRectF(-radius, -radius, 2 * radius, 2 * radius), 0.0, -180.0)
        for spoke in range(-90, 91, SPOKE_STEP_DEG):
            path = edge if abs(spoke) == 90 or spoke == 0 else rings
            path.moveTo(0.0, 0.0)
            path.lineTo(float(np.sin(np.radians(spoke))), float(np.cos(np.radians(spoke))))
        painter.setPen(grey_pen(self._palette, 0.16))
        painter.drawPath(rings)
        painter.setPen(grey_pen(self._palette, 0.4))
        painter.drawPath(edge)
