"""The pictures of a report: the real renderer's, on the speed form in the booth and on a sphere in the sun."""

from __future__ import annotations

import io
from dataclasses import dataclass, replace

from PIL import Image

from brdf_suite.appearance.colour.spaces import SRGB_SPACE
from brdf_suite.documents.view import Camera, View
from brdf_suite.output.still import loaded_scene
from brdf_suite.pipeline.exposure import metered
from brdf_suite.pipeline.lobe_fit import LobeFit, refit_under
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.realtime.pictures.display import Display

_HERO, _SMALL = (1040, 640), (520, 640)
_SAMPLES = 4
SECOND = View(camera=Camera(elevation_deg=14.0), environment="sunny", surface="sphere")
"""The scene of the second picture: flakes show in the sun."""


@dataclass(frozen=True, eq=False)
class ReportPicture:
    """A PNG and what it shows."""

    title: str
    png: bytes
    width: int
    height: int


def draw_pictures(
    fit: LobeFit, view: View | None, scale: float, progress: Progress | None = None
) -> tuple[ReportPicture, ...]:
    """Return the pictures of a fit; ``view`` is the scene of the first one, the default one where left out.

    Errors as :func:`brdf_suite.output.still.render_to_file`.
    """
    scenes = ((view or View(), _HERO), (SECOND, _SMALL))
    pictures = []
    for index, (scene, (width, height)) in enumerate(scenes):
        size = (max(16, round(width * scale)), max(16, round(height * scale)))
        step = subrange(progress, index / len(scenes), (index + 1) / len(scenes))
        pictures.append(_draw(fit, scene, size, step))
    return tuple(pictures)


def _draw(fit: LobeFit, view: View, size: tuple[int, int], progress: Progress | None) -> ReportPicture:
    view = replace(view, clipping_marks=False, gamut_marks=False)
    with loaded_scene(view, subrange(progress, 0.0, 0.8)) as loaded:
        loaded.scene.set_material(refit_under(fit, view.light_colour))
        report(progress, 0.8, "drawing")
        renderer = loaded.scene.renderer
        shown = metered(renderer, loaded.composed(view, size), size)
        pixels = renderer.render_image(shown, size, _SAMPLES, display=Display(SRGB_SPACE))
        title = f"{loaded.mesh.name.replace('_', ' ')}, {loaded.prepared.environment.name}"
    packed = io.BytesIO()
    Image.fromarray(pixels).save(packed, "PNG", optimize=False)
    return ReportPicture(title, packed.getvalue(), size[0], size[1])
