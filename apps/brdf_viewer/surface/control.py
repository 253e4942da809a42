"""The surface's settings: what changes its shape loads it again; what is baked for it comes in the background."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import Literal

from brdf_qt.fields.choices import set_note
from brdf_qt.program.translation import tr
from brdf_qt.work.scene_loading import SURFACE
from brdf_qt.work.tasks import TaskRunner
from brdf_qt.work.timer import make_timer

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import SECOND_PAINT, Material, PartMaterial
from brdf_suite.files.meshes.occlusion_cache import baked_occlusion
from brdf_suite.pipeline.surface import wants_baking
from brdf_suite.surface.mesh import Mesh
from brdf_suite.surface.occlusion.rays import BakedMesh
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.scene.control import SceneControl
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow

OCCLUSION = "occlusion"
_SHAPE = ("unit", "up", "tessellation_mm", "scale", "recentre", "flip_normals", "normals")
_FIRST_SECONDS = ("fine_silver", "dark_grey")
"""Shipped paints that a part gets that is to wear the second paint where none was chosen."""
_CLOSING_MS = 60_000
"""Baking hears of its end within a fraction of a second, and on a crowded machine later."""
_RELOAD_MS = 250
"""A number that is dragged loads the surface when the hand rests."""


class SurfaceControl(ViewerFeature):
    """Wires the Surface section to the viewer state, bakes occlusion, and gives parts their materials."""

    def __init__(self, state: ViewerState, window: ViewerWindow, scene: SceneControl) -> None:
        super().__init__(state, window)
        self._section = window.surface
        self._runner = TaskRunner(self, threads=1)
        self._mesh: Mesh | None = None
        self._baking: Mesh | None = None
        self._declined: Mesh | None = None
        self._reload = make_timer(self, lambda: scene.open(SURFACE, state.view.surface), _RELOAD_MS)
        self._section.edited.connect(lambda field, value: state.change_part("surface_look", **{field: value}))
        self._section.parts.material_edited.connect(lambda names, material: self.give(names, material))
        self._section.again.clicked.connect(self.bake)
        state.view_changed.connect(self._view_changed)
        state.contents_changed.connect(self._contents_changed)
        window.busy_cancelled.connect(self._cancelled)
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

    def materials_of(self, names: list[str]) -> set[str]:
        """Return what these parts are made of in the view."""
        mesh, chosen = self._mesh, self._state.view.surface_look.chosen
        own = {} if mesh is None else {part.name: part.material for part in mesh.parts}
        return {chosen.get(name, own[name]) for name in names if name in own}

    def give(self, names: list[str], material: Material | Literal[""], second: str | None = None) -> None:
        """Make these parts of a material, or with "" of their own again; one step that can be undone.

        ``second`` becomes the view's second paint. Where it has none, the first part that is to wear it brings one.
        """
        view = self._state.view
        chosen = {item.part: item for item in view.surface_look.materials if item.part not in names}
        if material:
            chosen |= {name: PartMaterial(name, material) for name in names}
        look, two_tone = replace(view.surface_look, materials=tuple(chosen.values())), view.two_tone
        if material == SECOND_PAINT and second is None and two_tone.paint is None:
            second = next(name for name in _FIRST_SECONDS if name != self._state.paint_key)
        if second is not None:
            two_tone = replace(two_tone, paint=second)
        self._state.step_view(surface_look=look, two_tone=two_tone)

    def _view_changed(self, old: View, new: View) -> None:
        if old.surface_look == new.surface_look:
            return
        self._section.set_look(new.surface_look)
        # Of another surface, which is loaded as the view says, this is no change of shape.
        if old.surface == new.surface and any(
            getattr(old.surface_look, name) != getattr(new.surface_look, name) for name in _SHAPE
        ):
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
