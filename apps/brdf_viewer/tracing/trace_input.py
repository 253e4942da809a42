"""What there is to be traced: all that its light depends on, so that nothing else begins it anew."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass

from brdf_suite.documents.store import AnyPaint
from brdf_suite.documents.view import View
from brdf_suite.lighting.environment import Environment
from brdf_suite.realtime.camera import resolve
from brdf_suite.realtime.pictures.comparison import sides
from brdf_suite.surface.mesh import Mesh
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.tracing.request import Quality, Renderer

_SHOWN = (
    "environment",
    "surface",
    "environment_layout",
    "exposure_ev",
    "exposure_mode",
    "tone_curve",
    "background",
    "background_colour",
    "look_up",
    "clipping_marks",
    "gamut_marks",
    "mark_style",
    "compare",
    "turntable_deg_s",
    "lamp_shading",
    "glare",
    "lens",
)
"""Fields of a view that change how traced light is shown, or name what is handed over as it is."""
_PLAIN = View()


@dataclass(frozen=True, eq=False)
class TraceInput:
    """A scene; ``paint`` is None where only a file is known, ``paint_key``, a measured one."""

    renderer: Renderer
    quality: Quality
    view: View
    size: tuple[int, int]
    environment: Environment
    surface: Mesh
    paint: AnyPaint | None
    paint_key: str

    def same(self, other: TraceInput) -> bool:
        return (
            self.renderer == other.renderer
            and (self.quality == other.quality or self.renderer == "reference")
            and self.size == other.size
            and self.environment.content_hash == other.environment.content_hash
            and self.surface is other.surface
            and self.paint == other.paint
            and (self.paint is not None or self.paint_key == other.paint_key)
            and lit_part(self.view) == lit_part(other.view)
        )


def lit_part(view: View) -> View:
    """Return the view without what its light does not depend on.

    >>> from dataclasses import replace
    >>> lit_part(replace(_PLAIN, exposure_ev=2.0)) == lit_part(_PLAIN)
    True
    """
    return dataclasses.replace(view, **{name: getattr(_PLAIN, name) for name in _SHOWN})


def make_trace_input(
    state: ViewerState, renderer: Renderer, quality: Quality, device_size: tuple[int, int]
) -> TraceInput | None:
    """Return what is to be traced; None while something is missing, or the light is only sketched."""
    environment, surface = state.environment, state.surface
    if renderer == "realtime" or state.fit is None or environment is None or surface is None:
        return None
    if environment.value.draft:
        return None
    size = first_size(state.view, device_size)
    # Where it stands: without a place of its own a still picture's camera is placed otherwise than a window's.
    camera = resolve(state.view.camera, state.bounds, size)
    return TraceInput(
        renderer,
        quality,
        dataclasses.replace(state.view, camera=camera),
        size,
        environment.value.environment,
        surface.value,
        state.paint,
        state.paint_key,
    )


def first_size(view: View, device_size: tuple[int, int]) -> tuple[int, int]:
    """Return the size of the first picture: the window's, or half of it where two are side by side."""
    if view.compare.mode != "side":
        return device_size
    _, _, width, height = sides(device_size)[0]
    return (width, height)
