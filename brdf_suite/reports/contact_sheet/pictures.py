"""The pictures of a contact sheet and the lines below them, one paint after the other."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.flop.travel import flop_index
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.store import AnyPaint
from brdf_suite.documents.view import View
from brdf_suite.errors import SuiteError, ValueRangeError
from brdf_suite.output.picture_file import PictureSettings
from brdf_suite.output.still import LoadedScene, loaded_scene
from brdf_suite.palettes.swatches.look import LARGEST, SMALLEST, Form, SwatchLook, flat_picture
from brdf_suite.pipeline.exposure import metered
from brdf_suite.pipeline.lobe_fit import LobeFit, fit_material
from brdf_suite.pipeline.material import material_of
from brdf_suite.progress import Progress
from brdf_suite.realtime.pictures.display import Display
from brdf_suite.reports.contact_sheet.page_layout import CellText

if TYPE_CHECKING:
    from brdf_suite.realtime.pictures.captured import CapturedForm

Size = tuple[int, int]
ANGLES_DEG = (15.0, 45.0, 110.0)
_SAME_ANGLE_DEG = 0.5


@dataclass(frozen=True)
class SheetItem:
    """A paint of a sheet, or why there is none; ``group`` is the heading that it stands under."""

    name: str
    group: str
    paint: AnyPaint | None
    problem: str = ""
    code: str = ""


class ItemPictures:
    """Draws the items; see :func:`item_pictures`. ``notices`` concern the light and the surface.

    Without a loaded scene it draws the bands of colours of ``form``.
    """

    def __init__(
        self,
        view: View,
        cell: Size,
        settings: PictureSettings,
        display: Display,
        loaded: LoadedScene | None,
        form: Form = "chips",
    ) -> None:
        self._view, self._cell, self._settings, self._display = view, cell, settings, display
        self._loaded, self._form = loaded, form
        self._captured: CapturedForm | None = None
        self._tried = False
        self.notices: tuple[str, ...] = ()
        if loaded is not None:
            self.notices = (*loaded.prepared.environment.notes, *loaded.mesh.notes)
            self._view = replace(
                loaded.composed(view, cell), glare="off", clipping_marks=False, gamut_marks=False
            )

    def draw(self, item: SheetItem) -> tuple[NDArray[np.uint8], CellText]:
        """Return the picture (h, w, 3) of an item and what stands below it.

        Raises :class:`SuiteError`: there is no such picture; the message names the paint.
        """
        if item.paint is None:
            raise SuiteError(f"{item.name}: {item.problem}")
        fit = fit_material(material_of(item.paint, item.paint.name))
        if self._loaded is None:
            return self._bands(item.paint), cell_text(item, fit)
        return self._rendered(fit, self._loaded), cell_text(item, fit)

    def close(self) -> None:
        """Give the captured surface back."""
        if self._captured is not None:
            self._captured.release()
        self._captured = None

    def _rendered(self, fit: LobeFit, loaded: LoadedScene) -> NDArray[np.uint8]:
        scene = loaded.scene
        renderer = scene.renderer
        waves = fit.orange_peel is not None and fit.orange_peel.slope_deg > 0.0
        if self._tried and self._captured is not None and not waves:
            (picture,) = self._captured.draw([scene.swatch(fit)], self._display)
            return np.asarray(picture)
        scene.set_material(fit)
        # Automatic exposure is that of the first paint, so that all stand in the same light.
        self._view = metered(renderer, self._view, self._cell)
        if not self._tried:
            self._tried = True
            try:
                self._captured = renderer.capture(self._view, self._cell, self._settings.samples)
            except ValueRangeError:  # large, or lit and painted in a way that is drawn paint by paint
                self._captured = None
        pixels: NDArray[np.uint8] = renderer.render_image(
            self._view, self._cell, self._settings.samples, display=self._display
        )
        return pixels

    def _bands(self, paint: AnyPaint) -> NDArray[np.uint8]:
        width, height = self._cell
        size = min(LARGEST, max(SMALLEST, width))
        look = SwatchLook(self._form, size=size, light_colour=self._view.light_colour)
        row = flat_picture(paint, look)[0][np.arange(width) * size // width]
        return np.ascontiguousarray(np.broadcast_to(row, (height, width, 3)))


@contextmanager
def item_pictures(
    view: View,
    cell: Size,
    settings: PictureSettings,
    display: Display,
    form: Form | None,
    progress: Progress | None = None,
) -> Iterator[ItemPictures]:
    """Load what a sheet's pictures need, while the block runs; ``form``: bands of colours instead of the surface."""
    if form in ("chips", "flop_strip"):
        yield ItemPictures(view, cell, settings, display, None, form)
        return
    with loaded_scene(view, progress) as loaded:
        pictures = ItemPictures(view, cell, settings, display, loaded)
        try:
            yield pictures
        finally:
            pictures.close()


def cell_text(item: SheetItem, fit: LobeFit) -> CellText:
    """Return name, code, flop index, gloss of a designed paint, and L*a*b* at 15, 45 and 110° with light at 45°."""
    measured = [(row.illumination_deg, row.aspecular_deg, row.lab) for row in fit.readings or fit.angles]
    found = {}
    for wanted in ANGLES_DEG:
        for light, aspecular, lab in measured:
            if abs(light - 45.0) < _SAME_ANGLE_DEG and abs(aspecular - wanted) < _SAME_ANGLE_DEG:
                found[wanted] = lab
                break
    figures = []
    if len(found) == len(ANGLES_DEG):
        index = flop_index(*(found[angle][0] for angle in ANGLES_DEG))
        figures.append("flop -" if math.isnan(index.value) else f"flop {index.value:.1f}")
    if isinstance(item.paint, Paint):
        figures.append(f"{item.paint.gloss.gu_20:g} GU at 20°")
    return CellText(item.name, item.code, ", ".join(figures), tuple(found.items()))
