"""Joins the neighbours to the paint session: computed when the edits pause, fitted on a thread, drawn by a process."""

from __future__ import annotations

from typing import NamedTuple

from brdf_qt.choosing.thumbnails import USUAL_LOOK, thumbnail
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.feature import Feature
from brdf_qt.program.names import ENVIRONMENTS
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import decimal, mark, tr
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject, QTimer

from brdf_designer.session.paint_session import PaintSession
from brdf_designer.standard_comparison.state import say
from brdf_designer.variations.section import DAILY, FORMS, NeighbourState, VariationsSection
from brdf_designer.window.window import DesignerWindow
from brdf_suite.documents.paint import Paint
from brdf_suite.paint_design.variations import (
    DIRECTIONS,
    LEAST_STEP,
    MOST_STEP,
    USUAL_STEP,
    Variation,
    examined,
    variations,
)
from brdf_suite.palettes.swatches.look import SwatchLook
from brdf_suite.pipeline.lobe_fit import PATIENT_TIME_LIMIT_S, PaintFitter
from brdf_suite.progress import Progress, report

KEY = "variations"
_STEP, _LIGHT, _FORM = "variations/step", "variations/environment", "variations/surface"
STEP_NAMES = {
    "lighter": mark("Lighter"),
    "darker": mark("Darker"),
    "cleaner": mark("Cleaner"),
    "dirtier": mark("Dirtier"),
    "more flop": mark("More Flop"),
    "less flop": mark("Less Flop"),
    "redder": mark("Redder"),
    "yellower": mark("Yellower"),
    "greener": mark("Greener"),
    "bluer": mark("Bluer"),
    "deeper": mark("Deeper"),
    "warmer": mark("Warmer"),
    "finer flakes": mark("Finer Flakes"),
    "coarser flakes": mark("Coarser Flakes"),
}
"""What Undo calls the step; a test holds that every word has one."""
WORDS_OF_OWN = (mark("deeper"), mark("warmer"), mark("finer flakes"), mark("coarser flakes"))
"""Words that no comparison with a standard uses."""
_START_MS = 2500
"""After the start the first picture of the window comes before the small ones."""


class _Request(NamedTuple):
    paint: Paint
    step: float


class VariationsControl(Feature, QObject):
    """The neighbours of the paint in front; nothing is done while the section is not seen, or in a drag."""

    def __init__(self, session: PaintSession, window: DesignerWindow) -> None:
        super().__init__(window)
        self._session = session
        self._pictures = window.pictures
        self._tasks = TaskRunner(self, threads=1)
        self._fitter: PaintFitter | None = None
        self.neighbours: tuple[Variation, ...] = ()
        """Those that are shown."""
        self._of: _Request | None = None
        self._step, self._look = _kept_step(), _kept_look()
        self.section = VariationsSection()
        self.section.show_choices(self._step, self._look.environment, self._look.form)
        self.host = window.add_section(KEY, tr("Variations"), self.section, "colour", tab="paint")
        self._waits = True
        """Whether pictures wait for those of the start."""
        self.section.taken.connect(self.take)
        self.section.previewed.connect(self.preview)
        self.section.step_edited.connect(self.set_step)
        self.section.scene_chosen.connect(self.set_scene)
        self.host.seen.connect(self._later)
        self.section.more.seen.connect(self._unfold)
        session.paint_changed.connect(self._later)
        session.gesture_ended.connect(self._later)
        self._pictures.arrived.connect(lambda _keys: self._show_pictures())
        self._pictures.unavailable.connect(lambda _look, _why: self._show_pictures())

    @property
    def is_idle(self) -> bool:
        """Whether every picture that is wanted is there, or never will be."""
        if not self.host.is_seen or self._waits or not self._pictures.program:
            return True
        if self._pictures.problem(self._look):
            return True
        wanted = [one.paint for one in self._pictured() if one.paint is not None]
        present = self._of is not None and self._of.paint is self._session.paint
        return present and all(self._pictures.is_settled(paint, self._look) for paint in wanted)

    def start(self) -> None:
        """Let the small pictures come once the window has its own."""
        QTimer.singleShot(_START_MS, self, self._begin)

    def take(self, direction: str) -> None:
        """Make a neighbour the paint, as one step."""
        chosen = self._neighbour(direction)
        if chosen.paint is not None:
            self._session.set_paint(chosen.paint, tr(STEP_NAMES[chosen.word]))

    def preview(self, direction: str) -> None:
        """Let a neighbour be seen in the picture and the patches; an empty text: the paint itself again."""
        paint = self._neighbour(direction).paint if direction else None
        if paint is None or self._session.in_gesture:
            self._session.end_preview()
        else:
            self._session.preview(paint)

    def _neighbour(self, direction: str) -> Variation:
        paint = self._session.paint
        known = self.neighbours
        if self._of is None or self._of.paint is not paint:
            # An edit came just before the click: the neighbour of what is there now is meant.
            known = variations(paint, self._step)
        return next(one for one in known if one.direction == direction)

    def _begin(self) -> None:
        self._waits = False
        self._request_pictures()

    def set_step(self, step: float) -> None:
        """Look at neighbours nearer or farther away."""
        self._step = step
        settings().setValue(_STEP, step)
        self.refresh()

    def set_scene(self, environment: str, surface: str) -> None:
        """Have the pictures drawn in another light, on another form."""
        self._look = _look(environment, surface)
        settings().setValue(_LIGHT, environment)
        settings().setValue(_FORM, surface)
        self._request_pictures()
        self._show_pictures()

    def refresh(self) -> None:
        """Work out the neighbours of the paint as it is now."""
        request = _Request(self._session.paint, self._step)
        if not self.host.is_seen or (request == self._of and self._of.paint is request.paint):
            return
        self._of = request
        self.neighbours = variations(request.paint, request.step)
        self._show_words()
        self._show_pictures()
        self._request_pictures()
        self._tasks.submit(KEY, self._examine, request, self._examined, self._failed)

    def close(self) -> None:
        """End the thread."""
        self._tasks.stop()
        if self._fitter is not None:
            self._fitter.close()

    def _later(self, *_: object) -> None:
        # The states of a drag have no neighbours; the one that it ends with has.
        if self.host.is_seen and not self._session.in_gesture:
            self._session.at_idle(KEY, self.refresh)

    # On the thread.

    def _examine(self, request: _Request, progress: Progress) -> tuple[_Request, tuple[Variation, ...]]:
        if self._fitter is None:
            self._fitter = PaintFitter(self._session.fitting, time_limit_s=PATIENT_TIME_LIMIT_S)
        found = []
        for number, one in enumerate(variations(request.paint, request.step)):
            report(progress, number / len(DIRECTIONS), one.word)
            found.append(examined(one, self._fitter))
        return request, tuple(found)

    def _examined(self, answer: tuple[_Request, tuple[Variation, ...]]) -> None:
        request, found = answer
        if self._of is not None and request.paint is self._of.paint and request.step == self._of.step:
            self.neighbours = found
            self._show_words()

    def _unfold(self) -> None:
        self._request_pictures()
        self._show_pictures()

    def _failed(self, error: Exception) -> None:
        raise error  # no file and no user's value is met there: a fault of ours, which the program reports

    # Showing.

    def _show_words(self) -> None:
        self.section.show_neighbours([_state(one) for one in self.neighbours])

    def _request_pictures(self) -> None:
        if not self.host.is_seen or self._of is None or self._waits:
            return
        paints = [one.paint for one in self._pictured() if one.paint is not None]
        self._pictures.request(KEY, paints, self._look)

    def _pictured(self) -> list[Variation]:
        """The neighbours whose pictures are seen."""
        unfolded = self.section.more.is_open
        return [one for one in self.neighbours if unfolded or one.direction in DAILY]

    def _show_pictures(self) -> None:
        if not self.host.is_seen or self._of is None:
            return
        for one in self._pictured():
            picture = thumbnail(self._pictures, one.paint or self._of.paint, self._look)
            self.section.buttons[one.direction].show_picture(picture)
        why = self._pictures.problem(self._look)
        self.section.show_note(
            why and tr("{reason} Discs show the readings instead.").format(reason=tr_core(why))
        )


def _state(one: Variation) -> NeighbourState:
    word = say(one.word)
    if one.paint is None:
        return NeighbourState(one.direction, tr("{word}: none").format(word=word), tr_core(one.reason), False)
    if one.direction in ("finer_flakes", "coarser_flakes"):
        flakes = one.paint.flakes
        assert flakes is not None
        tip = tr("Click to use it. Flakes of {size:.1f} µm, {density:.0f} per mm².")
        tip = tip.format(size=flakes.size_um, density=flakes.density_per_mm2)
        return NeighbourState(one.direction, word, decimal(tip), True)
    colours = "\n".join(
        decimal(f"{m.aspecular_deg:g}°: ")
        + ", ".join(decimal(f"{value:.1f}") for value in m.lab).replace("-", "−")
        for m in one.paint.measurements
    )
    if one.is_missed:
        assert one.missed is not None
        tip = tr(
            "No paint of this kind matches these colours exactly: ΔE00 up to {missed:.1f}. L*a*b*:"
        ).format(missed=one.missed)
        return NeighbourState(one.direction, f"{word} ≈", f"{tip}\n{colours}", True)
    return NeighbourState(one.direction, word, tr("Click to use it. L*a*b*:") + "\n" + colours, True)


def _kept_step() -> float:
    try:
        step = float(str(settings().value(_STEP, USUAL_STEP)))
    except (TypeError, ValueError):  # edited by hand
        return USUAL_STEP
    return step if LEAST_STEP <= step <= MOST_STEP else USUAL_STEP


def _kept_look() -> SwatchLook:
    light, form = (settings().value(key, "", type=str) for key in (_LIGHT, _FORM))
    return _look(
        light if light in ENVIRONMENTS else USUAL_LOOK.environment,
        form if form in FORMS else USUAL_LOOK.form,
    )


def _look(environment: str, form: str) -> SwatchLook:
    return SwatchLook.from_json({"form": form, "environment": environment, "size": USUAL_LOOK.size})
