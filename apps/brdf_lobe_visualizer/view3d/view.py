"""The lobes in three dimensions: shows a :class:`Scene` in one or several panels from one camera, and reads points.

Who owns the view sets scene and camera; words are painted over the picture, sharp at any size.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from brdf_qt.fields.form import described
from brdf_qt.gl.items import BEFORE, BEHIND, DiscItem, SegmentItem
from brdf_qt.gl.segments import Rgba
from brdf_qt.gl.space import Region, SpaceView, project
from brdf_qt.program.translation import decimal, tr
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QEvent, QObject, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QImage, QMatrix4x4, QMouseEvent, QPainter, QPalette, QVector3D
from PySide6.QtOpenGL import QOpenGLFramebufferObject, QOpenGLFramebufferObjectFormat
from PySide6.QtWidgets import QWidget

from brdf_lobe_visualizer.view3d.camera import Camera
from brdf_lobe_visualizer.view3d.frame import LIGHT_REACH, Frame, Panel, Probe, Scene, frame_of
from brdf_lobe_visualizer.view3d.lobe_item import (
    ARROWS_DEPTH,
    FRAME_DEPTH,
    HANDLE_DEPTH,
    POINTS_DEPTH,
    LobeItem,
)
from brdf_lobe_visualizer.view3d.overlay import Overlay
from brdf_lobe_visualizer.view3d.save_svg import Look, svg_of
from brdf_lobe_visualizer.words import UNIT, number
from brdf_suite.arrays import Floats
from brdf_suite.documents.atomic import write_atomically
from brdf_suite.errors import GraphicsError
from brdf_suite.files.images.png import write_png
from brdf_suite.geometry.directions import angle_between
from brdf_suite.inspection.lobe_surface.export import write_surface
from brdf_suite.inspection.lobe_surface.occlusion import hidden, met, value_along

_TILE = 1024
"""Device pixels of a part of an exported picture; larger buffers may not be had."""
_SUPERSAMPLED = 2
_HANDLE_REACH_PX = 15.0
_HANDLE_PX, _HOT_PX = 11.0, 13.0
_HANDLE, _HOT = (0.95, 0.78, 0.25, 1.0), (1.0, 0.90, 0.55, 1.0)
_HANDLE_RIM = (0.15, 0.15, 0.15, 1.0)
_POINT_PX = 7.0
_SHINE = 0.3
"""How much of a sample is seen through a lobe that lies before it."""
_CONTENT = (2.6, 1.9)
"""Width and height of hemisphere and labels beside each other."""


class LobeView(SpaceView):
    """The view."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setMinimumSize(200, 160)
        described(self, name="space_view", spoken=tr("3-D lobe plot"))
        self.scene = Scene()
        self.camera = Camera()
        self.hot = False
        self._frame: Frame | None = None
        self._probe: Probe | None = None
        self._probe_text = ""
        self.make_items()

    def make_items(self) -> None:
        self._lobes: list[LobeItem] = []
        self._samples: list[DiscItem] = []
        self._grid, self._arrows = SegmentItem(), SegmentItem()
        self._handle = DiscItem(BEFORE, rim=_HANDLE_RIM)
        self._grid.setDepthValue(FRAME_DEPTH)
        self._arrows.setDepthValue(ARROWS_DEPTH)
        self._handle.setDepthValue(HANDLE_DEPTH)
        for item in (self._grid, self._arrows, self._handle):
            self.addItem(item)
        self._shown_frame: Frame | None = None
        self._fill()

    def set_scene(self, scene: Scene) -> None:
        """Show ``scene`` from the next frame on; its surfaces go to the card at once where it is there."""
        before = self.scene
        self.scene = scene
        alike = (before.scale, before.frame) == (scene.scale, scene.frame)
        if not alike or before.light is not scene.light:
            self._frame = None
        self._probe = None
        self._fill()
        if self.isValid():
            self.makeCurrent()
            try:
                for item in self._lobes:
                    item.upload()
            finally:
                self.doneCurrent()

    def _fill(self) -> None:
        """Give the items what they show; those of the scene before are used again."""
        ground, ink = self._colour(QPalette.ColorRole.Base), self._colour(QPalette.ColorRole.Text)
        self.opts["bgcolor"] = ground
        panels = self.scene.panels
        layers = [(layer, order) for panel in panels for order, layer in enumerate(panel.layers)]
        self._resize(self._lobes, len(layers), LobeItem)
        for lobe, (layer, order) in zip(self._lobes, layers, strict=True):
            lobe.set_layer(layer, order, ink)
        self._resize(self._samples, len(panels), partial(DiscItem, BEHIND, ground, _SHINE))
        for discs, panel in zip(self._samples, panels, strict=True):
            discs.setDepthValue(POINTS_DEPTH)
            discs.setVisible(panel.points is not None)
            if panel.points is not None:
                discs.setData(pos=panel.points.places, color=panel.points.colours, size=_POINT_PX)
            discs.rim = ground

    def _fill_frame(self) -> None:
        """Give the items about the lobes what they show, once for all changes between two frames."""
        frame = self.frame()
        if frame is not self._shown_frame:
            self._grid.set_segments(frame.behind)
            self._arrows.set_segments(frame.before)
            self._shown_frame = frame
            self._show_handle()

    def _resize(self, items: list[Any], count: int, make: Callable[[], Any]) -> None:
        while len(items) > count:
            self.removeItem(items.pop())
        while len(items) < count:
            items.append(make())
            self.addItem(items[-1])

    def _show_handle(self) -> None:
        at = self.frame().handle
        self._handle.setVisible(at is not None and self.scene.frame.arrows)
        if at is not None:
            size, colour = (_HOT_PX, _HOT) if self.hot else (_HANDLE_PX, _HANDLE)
            self._handle.setData(pos=at[None], color=colour, size=size)

    def _colour(self, role: QPalette.ColorRole) -> Rgba:
        colour = self.palette().color(role)
        return (colour.redF(), colour.greenF(), colour.blueF(), 1.0)

    def set_camera(self, camera: Camera) -> None:
        self.camera = camera
        self.update()

    def set_hot(self, hot: bool) -> None:
        if hot != self.hot:
            self.hot = hot
            self._show_handle()

    def set_probe(self, probe: Probe | None, text: str = "") -> None:
        """Mark a point of a lobe with words, or none."""
        if probe is not None or self._probe is not None:
            self._probe, self._probe_text = probe, text
            self.update()

    def rooms(self, size: QSize | None = None) -> list[QRectF]:
        """Return the panels' rectangles, logical pixels, for a picture of the view's size or another."""
        size = size or self.size()
        count = max(1, len(self.scene.panels))
        width, height = float(size.width()), float(size.height())

        def share(columns: int) -> float:
            # How large hemisphere and labels are then.
            rows = math.ceil(count / columns)
            return min(width / columns / _CONTENT[0], height / rows / _CONTENT[1])

        best = max(range(1, count + 1), key=lambda columns: (round(share(columns), 3), columns))
        wide, high = width / best, height / math.ceil(count / best)
        return [QRectF((i % best) * wide, (i // best) * high, wide, high) for i in range(count)]

    def project(self, place: tuple[float, float, float], room: QRectF) -> QPointF | None:
        """Return where a place of the local frame is on the widget; None behind the eye."""
        return _projected(self.camera.to_clip(room), place, room)

    def ray(self, at: QPointF) -> tuple[Floats, Floats, QRectF]:
        """Return start and direction of the ray through a point of the widget, and the panel that it is in."""
        rooms = self.rooms()
        room = next((r for r in rooms if r.contains(at)), rooms[0])
        inverse, _ = self.camera.to_clip(room).inverted()
        x = 2.0 * (at.x() - room.left()) / room.width() - 1.0
        y = 1.0 - 2.0 * (at.y() - room.top()) / room.height()
        near, far = (inverse.map(QVector3D(x, y, z)) for z in (-1.0, 1.0))
        start = np.array([near.x(), near.y(), near.z()])
        along = np.array([far.x(), far.y(), far.z()]) - start
        return start, along / np.linalg.norm(along), room

    def handle_at(self, at: QPointF) -> bool:
        """Whether the light's handle is under a point of the widget."""
        if self.scene.light is None or not self.scene.frame.arrows:
            return False
        x, y, z = (float(value) for value in LIGHT_REACH * self.scene.light)
        spots = [self.project((x, y, z), room) for room in self.rooms()]
        return any(
            s is not None and math.hypot(s.x() - at.x(), s.y() - at.y()) <= _HANDLE_REACH_PX for s in spots
        )

    def probe_at(self, at: QPointF) -> Probe | None:
        """Return the first solid lobe that the ray through a point of the widget meets; None where there is none."""
        start, along, room = self.ray(at)
        for panel, other in zip(self.scene.panels, self.rooms(), strict=False):
            for layer in panel.layers if other == room else ():
                if layer.style != "solid" or layer.grid is None or layer.surface.dark:
                    continue
                place = met(layer.surface, layer.grid, start, along)
                if place is not None:
                    return Probe(place, layer.surface, layer.grid, (room.left(), room.top()))
        return None

    def viewMatrix(self) -> QMatrix4x4:
        return self.camera.to_eye()

    def projectionMatrix(self, region: Region, viewport: Region) -> QMatrix4x4:
        """Return the projection onto ``region`` of a panel that lies in ``viewport``, device pixels."""
        (x, y, wide, high), (left, bottom, width, height) = region, viewport
        part = QMatrix4x4()
        part.translate((2 * (left - x) + width) / wide - 1.0, (2 * (bottom - y) + height) / high - 1.0, 0.0)
        part.scale(width / wide, height / high, 1.0)
        return part * self.camera.to_screen(width, height)

    def draw_picture(self, region: Region, viewport: Region) -> None:
        self._fill_frame()
        logical = QSize(round(viewport[2] / self.ratio), round(viewport[3] / self.ratio))
        across, down = viewport[2] / logical.width(), viewport[3] / logical.height()
        shared = [self._grid, self._arrows, self._handle]
        lobes = iter(self._lobes)
        for panel, room, samples in zip(self.scene.panels, self.rooms(logical), self._samples, strict=False):
            own = [next(lobes) for _ in panel.layers]
            # Of whole pixels, so that parts of a picture meet without a seam.
            left = round(room.left() * across) - region[0]
            bottom = viewport[3] - round(room.bottom() * down) - region[1]
            wide, high = max(1, round(room.width() * across)), max(1, round(room.height() * down))
            # What lies outside is cut off by the matrix: drivers allow no viewport as large as a large picture.
            x0, y0 = max(left, 0), max(bottom, 0)
            x1, y1 = min(left + wide, region[2]), min(bottom + high, region[3])
            if x0 < x1 and y0 < y1:
                self.draw_items(
                    [*own, samples, *shared], (x0, y0, x1 - x0, y1 - y0), (left, bottom, wide, high)
                )

    def picture(self, width: int, height: int) -> QImage:
        """Return the scene as a picture of any size in pixels, sixteen samples each, with its words.

        It is drawn in parts, so that neither the card's nor the screen's size limits it.
        """
        # Words and lines keep their share of the picture: as if the view were as high as it is now.
        scale = max(1.0, min(width, height) / max(1, min(self.width(), self.height())))
        logical = QSize(max(1, round(width / scale)), max(1, round(height / scale)))
        image = QImage(width, height, QImage.Format.Format_RGB32)
        self.makeCurrent()
        try:
            painter = QPainter(image)
            try:
                self.ratio = _SUPERSAMPLED * height / logical.height()
                self._paint_parts(painter, width, height)
                painter.scale(width / logical.width(), height / logical.height())
                self.paint_words(painter, logical)
            finally:
                painter.end()
        finally:
            self.doneCurrent()
            self.update()
        return image

    def _paint_parts(self, painter: QPainter, width: int, height: int) -> None:
        form = QOpenGLFramebufferObjectFormat()
        form.setAttachment(QOpenGLFramebufferObject.Attachment.CombinedDepthStencil)
        form.setSamples(4)
        whole = (0, 0, width * _SUPERSAMPLED, height * _SUPERSAMPLED)
        tile = _TILE // _SUPERSAMPLED
        for top in range(0, height, tile):
            for left in range(0, width, tile):
                wide, high = min(tile, width - left), min(tile, height - top)
                bottom = height - top - high
                size = QSize(wide * _SUPERSAMPLED, high * _SUPERSAMPLED)
                buffer = QOpenGLFramebufferObject(size, form)
                buffer.bind()
                corner = (left * _SUPERSAMPLED, bottom * _SUPERSAMPLED)
                self.paint(region=(*corner, size.width(), size.height()), viewport=whole)
                buffer.release()
                drawn = buffer.toImage().convertToFormat(QImage.Format.Format_RGB32)
                shape, mode = Qt.AspectRatioMode.IgnoreAspectRatio, Qt.TransformationMode.SmoothTransformation
                painter.drawImage(left, top, drawn.scaled(wide, high, shape, mode))

    def write_picture(self, path: Path, width: int, height: int, about: str) -> None:
        """Write the scene as PNG or SVG, by the ending of ``path``; raises :class:`FileError`."""
        if path.suffix.lower() == ".svg":
            size, palette = QSize(width, height), self.palette()
            look = Look(palette.text().color().name(), palette.base().color().name(), height / 60.0)
            picture = svg_of(self.scene, self.frame(), self.camera, self.rooms(size), size, look)
            write_atomically(path, picture.encode("utf-8"))
            return
        image = self.picture(width, height)
        rows = np.frombuffer(image.constBits(), np.uint8).reshape(height, -1)[:, : 4 * width]
        write_png(
            path, np.ascontiguousarray(rows.reshape(height, width, 4)[..., 2::-1]), {"Description": about}
        )

    def write_surface(self, path: Path, about: tuple[str, ...], radius_mm: float) -> None:
        """Write the first surface as OBJ or PLY; raises :class:`GraphicsError` where there is none."""
        layers = [layer for panel in self.scene.panels for layer in panel.layers]
        if not layers:
            raise GraphicsError(tr("No surface to save. Add a reflectance, or show one in the legend."))
        write_surface(path, layers[0].surface, about, radius_mm)

    def frame(self) -> Frame:
        """Return the lines and labels about the lobes, in the theme's colours."""
        if self._frame is None:
            ink = self._colour(QPalette.ColorRole.Text)
            self._frame = frame_of(self.scene.light, self.scene.scale, self.scene.frame, ink)
        return self._frame

    def paint_words(self, painter: QPainter, size: QSize) -> None:
        palette = self.palette()
        ink, paper = palette.color(QPalette.ColorRole.Text), palette.color(QPalette.ColorRole.Base)
        overlay = Overlay(painter, self.font(), QColor(ink), QColor(paper))
        rooms = self.rooms(size)
        labels = self.frame().labels
        everything = QRectF(0.0, 0.0, size.width(), size.height())
        taken = [] if self.scene.bar is None else [overlay.bar_room(self.scene.bar, everything)]
        for panel, room in zip(self.scene.panels, rooms, strict=False):
            matrix = self.camera.to_clip(room)
            behind = self._behind(panel, [label.place for label in labels])
            words = overlay.words_of(panel, room, taken)
            full = [*taken, *(one.box.adjusted(-3.0, -1.0, 3.0, 1.0) for one in words)]
            overlay.labels(labels, partial(_projected, matrix, room=room), room, behind, full)
            overlay.panel(panel, room, words, bordered=len(rooms) > 1)
        if self.scene.bar is not None:
            overlay.bar(self.scene.bar, everything)
        for room in rooms:
            probe = self._probe
            if probe is not None and probe.room == (room.left(), room.top()):
                x, y, z = (float(value) for value in probe.place)
                spot = self.project((x, y, z), room)
                if spot is not None:
                    overlay.probe(spot, self._probe_text, room)
        if not self.scene.panels:
            overlay.words(tr("No reflectance shown. Add one, or show one in the legend."), everything)

    def _behind(self, panel: Panel, places: list[tuple[float, float, float]]) -> list[bool]:
        """Which places a solid lobe of the panel hides."""
        result = np.zeros(len(places), bool)
        for layer in panel.layers:
            if layer.style == "solid" and layer.grid is not None and places:
                result |= hidden(layer.surface, layer.grid, self.camera.eye(), places)
        return [bool(value) for value in result]

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self._frame = None  # its lines have the theme's colour
            self._fill()
        self.update()


def _projected(matrix: QMatrix4x4, place: tuple[float, float, float], room: QRectF) -> QPointF | None:
    at, depth = project(matrix, place, room)
    return QPointF(*at) if depth > 1e-4 else None


_REST_MS = 30
"""The cursor is asked about once it moves no more for so long: a ray costs as much as a surface."""


class SpaceProbe(QObject):
    """Marks the point of the first solid lobe under the cursor and writes what it is."""

    def __init__(self, view: LobeView) -> None:
        super().__init__(view)
        self._view = view
        self._at: QPointF | None = None
        self._rest = make_timer(self, self.look, _REST_MS)
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
        theta=decimal(f"{theta:.1f}"),
        phi=decimal(f"{phi:.1f}"),
        gamma=decimal(f"{gamma:.1f}"),
        value=number(value),
        unit=UNIT,
    )
