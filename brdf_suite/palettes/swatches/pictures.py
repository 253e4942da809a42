"""Pictures of the paints of a palette, many at a time, by the renderer that the Viewer's picture comes from.

A form is drawn once for a light and a size, and every paint shades what was drawn
(:mod:`brdf_suite.realtime.pictures.captured`); while the graphics driver shades one paint the next is fitted. The
pictures are the very ones that the renderer gives for each paint alone.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from brdf_suite.appearance.colour.flat_colours import to_paint
from brdf_suite.arrays import Bytes
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.store import AnyPaint
from brdf_suite.errors import GraphicsError, SuiteError
from brdf_suite.lighting.environment import SMALL_COLUMNS
from brdf_suite.palettes.swatches.look import Content, SwatchLook, flat_picture, swatch_key
from brdf_suite.pipeline.lobe_fit import PATIENT_TIME_LIMIT_S, LobeFit, PaintFitter, fit_material
from brdf_suite.pipeline.material import material_of

if TYPE_CHECKING:
    from brdf_suite.output.still import LoadedScene
    from brdf_suite.realtime.pictures.captured import CapturedForm, CapturedPaint

_Found: TypeAlias = Bytes | SuiteError

_SAMPLES = 4
_FACE_SIZES = (384, 768, 1536, 4096)
_MOST_CAPTURED = 3
"""Sizes of one form in one light that are kept; each is a few megabytes."""


@dataclass(frozen=True, eq=False)
class SwatchPicture:
    """A picture (size, size, 3) of sRGB codes, top row first, or why there is none."""

    key: str
    pixels: Bytes | None
    problem: str = ""


class SwatchPainter:
    """Draws pictures; use it with ``with``, from one thread.

    The graphics context, a light and a form are loaded when a picture first needs them; the last light and form are
    kept. Where there is no OpenGL, the flat forms are drawn all the same.
    """

    def __init__(self) -> None:
        self._stack = ExitStack()
        self._loaded: LoadedScene | None = None
        self._scene: tuple[object, ...] = ()
        self._largest_face = 0
        self._captured: dict[int, CapturedForm] = {}
        self._fitter: PaintFitter | None = None

    def __enter__(self) -> SwatchPainter:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Give back all that is held."""
        self._forget_scene()
        if self._fitter is not None:
            self._fitter.close()
        self._fitter = None

    def draw(self, contents: Sequence[Content], look: SwatchLook) -> list[SwatchPicture]:
        """Return a picture of each paint or flat colour, in their order.

        Raises
        ------
        GraphicsError
            There is no OpenGL 3.3, or the driver failed: nothing of this form can be drawn.
        FileError
            The light's file cannot be read.
        """
        keys = [swatch_key(content, look) for content in contents]
        paints = [to_paint(content) for content in contents]
        draw = self._rendered if look.is_rendered else self._flat
        return [
            SwatchPicture(key, found)
            if isinstance(found, np.ndarray)
            else SwatchPicture(key, None, str(found))
            for key, found in zip(keys, draw(paints, look), strict=True)
        ]

    def _flat(self, paints: Sequence[AnyPaint], look: SwatchLook) -> list[_Found]:
        found: list[_Found] = []
        for paint in paints:
            try:
                found.append(flat_picture(paint, look))
            except SuiteError as error:
                found.append(error)
        return found

    def _rendered(self, paints: Sequence[AnyPaint], look: SwatchLook) -> list[_Found]:
        form = self._form(look)
        found: dict[int, _Found] = {}
        fits: dict[int, LobeFit] = {}
        waiting = self._fitted(paints, found, fits)
        try:
            pictures: Iterable[Bytes] = form.draw(waiting)
        except GraphicsError:
            # One paint may be what the driver or the renderer does not take: the others are drawn.
            deque(waiting, maxlen=0)
            pictures = self._one_by_one(form, fits, found)
        captured = [place for place, fit in fits.items() if place not in found and not _waves(fit)]
        found.update(zip(captured, pictures, strict=True))
        for place, fit in fits.items():
            if place not in found:
                found[place] = self._alone(fit, look)
        return [found[place] for place in range(len(paints))]

    def _fitted(
        self, paints: Sequence[AnyPaint], found: dict[int, _Found], fits: dict[int, LobeFit]
    ) -> Iterator[CapturedPaint]:
        """Yield what the captured form takes as it is fitted; note the fits, and in ``found`` why there is none."""
        for place, paint in enumerate(paints):
            try:
                fits[place] = self._fit(paint)
            except SuiteError as error:
                found[place] = error
                continue
            if not _waves(fits[place]):
                yield self._swatch(fits[place])

    def _swatch(self, fit: LobeFit) -> CapturedPaint:
        if self._loaded is None:
            raise AssertionError("a form is captured from a scene that is loaded")
        return self._loaded.scene.swatch(fit)

    def _one_by_one(
        self, form: CapturedForm, fits: dict[int, LobeFit], found: dict[int, _Found]
    ) -> list[Bytes]:
        """Draw paints alone after a batch has failed; raise where none can be drawn."""
        pictures: list[Bytes] = []
        failed: dict[int, _Found] = {}
        for place, fit in fits.items():
            if _waves(fit):
                continue
            try:
                pictures.append(form.draw([self._swatch(fit)])[0])
            except GraphicsError as error:
                failed[place] = error
                last = error
        if failed and not pictures:
            raise last
        found.update(failed)
        return pictures

    def _alone(self, fit: LobeFit, look: SwatchLook) -> Bytes:
        """A paint whose coat stands otherwise than its base, which a captured form has not."""
        loaded, size = self._scene_of(look), (look.size, look.size)
        loaded.scene.set_material(fit)
        return loaded.scene.image(loaded.composed(look.view(), size), size)

    def _fit(self, paint: AnyPaint) -> LobeFit:
        if not isinstance(paint, Paint):
            return fit_material(material_of(paint, paint.name))
        if self._fitter is None:
            self._fitter = PaintFitter(time_limit_s=PATIENT_TIME_LIMIT_S)
        return self._fitter.fit(paint)

    def _form(self, look: SwatchLook) -> CapturedForm:
        loaded = self._scene_of(look)
        if look.size not in self._captured:
            while len(self._captured) >= _MOST_CAPTURED:
                self._captured.pop(next(iter(self._captured))).release()
            size = (look.size, look.size)
            view = loaded.composed(look.view(), size)
            self._captured[look.size] = loaded.scene.renderer.capture(view, size, _SAMPLES)
        return self._captured[look.size]

    def _scene_of(self, look: SwatchLook) -> LoadedScene:
        wanted = (look.environment, look.form, look.light_colour)
        # Four texels to a pixel across a face: finer than the level that any pixel of these forms asks for.
        enough = next(size for size in _FACE_SIZES if size >= min(4 * look.size, _FACE_SIZES[-1]))
        if self._loaded is None or self._scene != wanted or enough > self._largest_face:
            # 0.2 s at the start of the process, which needs it only where pictures are not in the store.
            from brdf_suite.output.still import loaded_scene

            self._forget_scene()
            self._loaded = self._stack.enter_context(
                loaded_scene(look.view(), columns=SMALL_COLUMNS, largest_face=enough)
            )
            self._scene, self._largest_face = wanted, enough
        return self._loaded

    def _forget_scene(self) -> None:
        for form in self._captured.values():
            form.release()
        self._captured = {}
        self._loaded = None
        self._stack.close()


def _waves(fit: LobeFit) -> bool:
    peel = fit.orange_peel
    return peel is not None and peel.slope_deg > 0.0
