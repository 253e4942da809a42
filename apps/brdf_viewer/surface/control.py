"""The surface's settings: what changes its shape loads it again; what is baked for it comes in the background."""

from __future__ import annotations

from functools import partial
from typing import Literal

import numpy as np
from brdf_qt.fields.choices import set_note
from brdf_qt.program.translation import tr
from brdf_qt.work.scene_loading import SURFACE
from brdf_qt.work.tasks import TaskRunner
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QEvent, QObject, QPointF, Qt
from PySide6.QtGui import QMouseEvent

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Material, PartMaterial
from brdf_suite.files.meshes.occlusion_cache import baked_occlusion
from brdf_suite.pipeline.surface import wants_baking
from brdf_suite.realtime.camera import matrices
from brdf_suite.surface.mesh import Mesh
from brdf_suite.surface.occlusion.rays import BakedMesh
from brdf_suite.surface.picking import pick
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.scene.control import SceneControl
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow

OCCLUSION = "occlusion"
_SHAPE = ("unit", "scale", "recentre", "flip_normals", "normals")
_CLICK_PIXELS = 4.0
_CLOSING_MS = 60_000
"""Baking hears of its end within a fraction of a second, and on a crowded machine later."""
_RELOAD_MS = 250
"""A number that is dragged loads the surface when the hand rests."""


class SurfaceControl(ViewerFeature):
    """Wires the Surface section to the viewer state, bakes occlusion, and picks parts in the picture."""

    def __init__(self, state: ViewerState, window: ViewerWindow, scene: SceneControl) -> None:
        super().__init__(state, window)
        self._section = window.surface
        self._runner = TaskRunner(self, threads=1)
        self._mesh: Mesh | None = None
        self._baking: Mesh | None = None
        self._declined: Mesh | None = None
        self._pressed: QPointF | None = None
        self._reload = make_timer(self, lambda: scene.open(SURFACE, state.view.surface), _RELOAD_MS)
        self._section.edited.connect(lambda field, value: state.change_part("surface_look", **{field: value}))
        self._section.parts.material_edited.connect(self._material_edited)
        self._section.again.clicked.connect(self.bake)
        state.view_changed.connect(self._view_changed)
        state.contents_changed.connect(self._contents_changed)
        window.busy_cancelled.connect(self._cancelled)
        window.picture.canvas_changed.connect(self._watch)
        self._watch(window.picture.canvas)
        self._section.set_look(state.view.surface_look)

    @property
    def is_idle(self) -> bool:
        return self._baking is None

    def bake(self) -> None:
        """Bake for the present surface; what is drawn stays until it is there."""
        surface = self._state.surface
        if surface is None:
            return
        self._baking, self._declined = surface.value, None
        baked = partial(self._baked, surface.value)
        self._run(self._runner, OCCLUSION, baked_occlusion, surface.value, baked, self._failed)
        self._show_state()

    def close(self) -> None:
        self._reload.stop()
        self._runner.stop(_CLOSING_MS)

    def _pick_at(self, place: QPointF, *, add: bool) -> None:
        """Pick the part that is seen at ``place`` of the picture (widget pixels, from the upper left)."""
        surface, canvas = self._state.surface, self._window.picture.canvas
        if surface is None:
            return
        size = self._window.picture.device_size
        camera = matrices(self._state.view.camera, self._state.bounds, size)
        right = (2.0 * place.x() / max(1, canvas.width()) - 1.0) * camera.half_tangents[0]
        up = (1.0 - 2.0 * place.y() / max(1, canvas.height())) * camera.half_tangents[1]
        hit = pick(surface.value, camera.eye, camera.view_to_world @ np.array([right, up, -1.0]))
        if hit is not None:
            self._section.parts.pick(surface.value.parts[hit.part].name, add=add)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Notice clicks, and leave every event to the camera's gestures."""
        if isinstance(event, QMouseEvent) and event.button() == Qt.MouseButton.LeftButton:
            if event.type() == QEvent.Type.MouseButtonPress:
                plain = not event.modifiers() & ~Qt.KeyboardModifier.ControlModifier
                self._pressed = event.position() if plain else None
            elif event.type() == QEvent.Type.MouseButtonRelease and self._pressed is not None:
                moved = event.position() - self._pressed
                self._pressed = None
                if abs(moved.x()) + abs(moved.y()) < _CLICK_PIXELS:
                    held = event.modifiers() & Qt.KeyboardModifier.ControlModifier
                    self._pick_at(event.position(), add=bool(held))
        return super().eventFilter(watched, event)

    def _watch(self, canvas: QObject) -> None:
        canvas.installEventFilter(self)

    def _material_edited(self, names: list[str], material: Material | Literal[""]) -> None:
        present = self._state.view.surface_look.materials
        chosen = {item.part: item for item in present if item.part not in names}
        if material:
            chosen |= {name: PartMaterial(name, material) for name in names}
        self._state.change_part("surface_look", materials=tuple(chosen.values()))

    def _view_changed(self, old: View, new: View) -> None:
        if old.surface_look == new.surface_look:
            return
        self._section.set_look(new.surface_look)
        if any(getattr(old.surface_look, name) != getattr(new.surface_look, name) for name in _SHAPE):
            self._reload.start()
        elif self._baking is not None and not wants_baking(new.surface_look):
            self._stop()
        else:
            self._bake_where_wanted()

    def _contents_changed(self) -> None:
        surface = self._state.surface
        mesh = None if surface is None else surface.value
        if mesh is not self._mesh:
            self._mesh = mesh
            self._stop()
            parts = [] if mesh is None else [(part.name, part.material) for part in mesh.parts]
            self._section.parts.set_parts(parts)
            self._bake_where_wanted()

    def _bake_where_wanted(self) -> None:
        surface = self._state.surface
        wanted = surface is not None and surface.baked is None and wants_baking(self._state.view.surface_look)
        if surface is not None and wanted and surface.value not in (self._baking, self._declined):
            self.bake()
        else:
            self._show_state()

    def _baked(self, mesh: Mesh, baked: BakedMesh) -> None:
        self._baking = None
        if self._state.surface is not None and self._state.surface.value is mesh:
            self._state.set_baked(baked)
        self._show_state()

    def _failed(self, error: Exception) -> None:
        self._declined, self._baking = self._baking, None
        self._report(error, OCCLUSION, tr("The surface is shown without ambient occlusion."))
        self._show_state()

    def _cancelled(self, kind: str) -> None:
        if kind == OCCLUSION and self._baking is not None:
            self._declined = self._baking
            self._stop()

    def _stop(self) -> None:
        if self._baking is not None:
            self._runner.cancel(OCCLUSION)
            self._baking = None
            self._window.set_idle(OCCLUSION)
        self._show_state()

    def _show_state(self) -> None:
        surface, wanted = self._state.surface, wants_baking(self._state.view.surface_look)
        declined = wanted and surface is not None and self._declined is surface.value
        text = tr("Computing ambient occlusion…") if self._baking is not None else ""
        if declined:
            text = tr("Shown without ambient occlusion; it has not been computed.")
        set_note(self._section.baking, text)
        self._section.again.setVisible(declined)
