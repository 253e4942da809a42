"""Joins the Texture section to the paint session: readings come on a thread once the edits pause."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.feature import Feature
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import tr
from brdf_qt.work.tasks import TaskRunner
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QObject

from brdf_designer.session.edits import DEFAULT_FLAKES, SetField
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.texture.section import USUAL_TOLERANCE, Judged, TextureSection
from brdf_designer.window.window import DesignerWindow
from brdf_suite.appearance.texture import LIGHTS_DEG, NO_TEXTURE, PaintLight, TextureReadings
from brdf_suite.documents.paint import Paint, TextureTargets
from brdf_suite.errors import SuiteError
from brdf_suite.inspection.texture.camera import measure_texture
from brdf_suite.inspection.texture.inverse import LEAST, REACHED, FoundFlakes, find_flakes
from brdf_suite.inspection.texture.readings import paint_light
from brdf_suite.pipeline.lobe_fit import LobeFit
from brdf_suite.progress import Progress

KEY = "texture"
_FIND = "find flakes"
_TOLERANCE = "texture/tolerance"
_PAUSE_MS = 300
"""After the last edit: pictures of flakes take a few tenths of a second of a core."""

Wanted = tuple[float | None, ...]
_OPEN: Wanted = (None,) * 4


class _Request(NamedTuple):
    fit: LobeFit
    light: PaintLight
    wanted: Wanted = _OPEN


class TextureControl(Feature, QObject):
    """Readings of the paint in front, and its targets."""

    def __init__(self, session: PaintSession, window: DesignerWindow) -> None:
        super().__init__(window)
        self._session = session
        self._tasks = TaskRunner(self, threads=1)
        self._of: _Request | None = None
        self.readings: TextureReadings | None = None
        """Those that are shown."""
        self.section = TextureSection()
        self.section.tolerance.set_value(_kept_tolerance())
        self.host = window.add_section(
            KEY, tr("Texture"), self.section, "flakes", tab="paint", more=True, is_open=False
        )
        self._pause = make_timer(self, self._measure, _PAUSE_MS)
        self.section.targets_edited.connect(self._take_targets)
        self.section.tolerance_edited.connect(self._take_tolerance)
        self.section.take_requested.connect(self._use_readings)
        self.section.find_requested.connect(self.find)
        self.host.seen.connect(self._later)
        session.fit_changed.connect(lambda _fit: self._later())
        session.refused.connect(lambda _error: self._forget())
        session.document_switched.connect(self._switched)
        session.paint_changed.connect(lambda _paint: self._show_targets())
        self._show_targets()

    @property
    def is_idle(self) -> bool:
        """Whether the readings of the paint are shown, and no flakes are looked for."""
        return not self._tasks.busy and not self._pause.isActive()

    def find(self) -> None:
        """Look for flakes that have the targets, on the thread."""
        fit = self._session.fit
        wanted = self.section.wanted()
        if fit is None or all(value is None for value in wanted):
            return
        self.section.show_searching(True)
        self.section.show_answer(tr("Looking for flakes…"))
        request = _Request(fit, paint_light(fit.weights), wanted)
        self._tasks.submit(_FIND, _search, request, self._found, self._not_found)

    def close(self) -> None:
        """End the thread."""
        self._tasks.stop()

    # Readings.

    def _later(self) -> None:
        if not self.host.is_seen:
            self._pause.stop()
            return
        fit = self._session.fit
        if fit is None or (self._of is not None and self._of.fit is fit):
            return
        if self._of is not None and _looks_the_same(self._of.fit.paint, fit.paint):
            self._of = self._of._replace(fit=fit)
            return
        if fit.flakes is None:
            self._tasks.cancel(KEY)
            self._of = None
            self._show(NO_TEXTURE)
            return
        self.section.show_old()
        self._pause.start()

    def _measure(self) -> None:
        if self._session.in_gesture:
            self._pause.start()
            return
        fit = self._session.fit
        if fit is None:
            return
        self._of = _Request(fit, paint_light(fit.weights))
        self._tasks.submit(KEY, _read, self._of, self._measured, _raise)

    def _measured(self, readings: TextureReadings) -> None:
        if self._of is not None and self._of.fit is self._session.fit:
            self._show(readings)

    def _forget(self) -> None:
        self._pause.stop()
        self._tasks.cancel(KEY)
        self._of = None
        self._show(None)

    def _show(self, readings: TextureReadings | None) -> None:
        self.readings = readings
        self.section.show_readings(readings)
        self._judge()

    # Targets.

    def _switched(self) -> None:
        self._end_search()
        self._show_targets()
        self._forget()

    def _show_targets(self) -> None:
        targets = self._session.paint.texture
        wanted = _OPEN if targets is None else targets.wanted
        if wanted != self.section.wanted():
            self._end_search()
            self.section.show_wanted(wanted)
            self._judge()

    def _take_targets(self) -> None:
        self._end_search()
        self._session.edit(SetField("texture", TextureTargets.of(self.section.wanted())))
        self._judge()

    def _take_tolerance(self) -> None:
        settings().setValue(_TOLERANCE, self.section.tolerance.value())
        self._judge()

    def _end_search(self) -> None:
        self._tasks.cancel(_FIND)
        self.section.show_searching(False)
        self.section.show_answer("")

    def _use_readings(self) -> None:
        if self.readings is not None:
            self.section.show_wanted(tuple(self.readings.scales().tolist()))
            self._take_targets()

    def _judge(self) -> None:
        readings = self.readings
        scales = [None] * 4 if readings is None else readings.scales().tolist()
        limit = self.section.tolerance.value() / 100.0
        judged: list[Judged | None] = []
        for value, wanted, least in zip(scales, self.section.wanted(), LEAST, strict=True):
            away = None if value is None or wanted is None else (value - wanted) / max(wanted, least)
            judged.append(None if away is None else Judged(away, abs(away) <= limit))
        self.section.show_judged(judged)

    # Flakes for them.

    def _found(self, answer: tuple[_Request, FoundFlakes]) -> None:
        request, found = answer
        self.section.show_searching(False)
        self.section.show_judged([None] * 4)
        if self._session.paint is not request.fit.paint:
            # It was edited meanwhile: what was found is of another paint.
            self.section.show_answer(tr("The paint has changed; look again."))
            self._judge()
            return
        self._session.set_paint(replace(request.fit.paint, flakes=found.flakes), tr("Find Flakes"))
        self.section.show_answer(_sentence(found))
        self._judge()

    def _not_found(self, error: Exception) -> None:
        self.section.show_searching(False)
        self.section.show_answer(tr_core(str(error)) if isinstance(error, SuiteError) else "")
        self._judge()
        if not isinstance(error, SuiteError):
            _raise(error)


def _looks_the_same(one: Paint, other: Paint) -> bool:
    """Whether two paints differ in their targets at most."""
    return replace(one, texture=None) == replace(other, texture=None)


def _read(request: _Request, progress: Progress) -> TextureReadings:
    return measure_texture(request.light, request.fit.flakes, progress=progress)


def _search(request: _Request, progress: Progress) -> tuple[_Request, FoundFlakes]:
    return request, find_flakes(request.light, request.wanted, request.fit.flakes or DEFAULT_FLAKES, progress)


def _sentence(found: FoundFlakes) -> str:
    if found.reached:
        return tr("Flakes found. Undo brings the others back.")
    names = [*(f"{light:g}°" for light in LIGHTS_DEG), tr("graininess")]
    missed = "\n".join(
        tr("{name}: nearest {value:.3g} %, {away:+.0f} %").format(
            name=name, value=100.0 * value, away=100.0 * error
        )
        for name, value, error in zip(names, found.scales, found.errors, strict=True)
        if abs(error) > REACHED
    )
    said = tr("Not reachable with flakes in a paint of this colour. The nearest are set.")
    return f"{said}\n{missed.replace('-', '−')}"


def _raise(error: Exception) -> None:
    raise error  # no file and no user's value is met there: a fault of ours, which the program reports


def _kept_tolerance() -> float:
    try:
        kept = float(str(settings().value(_TOLERANCE, USUAL_TOLERANCE)))
    except (TypeError, ValueError):  # edited by hand
        return USUAL_TOLERANCE
    return kept if 0.5 <= kept <= 100.0 else USUAL_TOLERANCE
