"""Keeps a traced picture in step with the viewer state: begins it when hand and scene rest, drops it when they change.

The real-time picture is shown, and says so, until there is a traced one of the very scene. So a gesture is never
slower than it is without a tracer, and no picture is ever of something else than the window says.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from functools import partial
from pathlib import Path
from statistics import median
from typing import TypeVar

from brdf_qt.program.settings import settings
from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import Message
from brdf_qt.work.tasks import TaskRunner
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QObject, Signal

from brdf_suite.documents.store import view_to_json
from brdf_viewer.documents.file_kinds import AskTarget
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.tracing.hand_over import HandOver, forget_others, write_request
from brdf_viewer.tracing.process import TracedPicture, TraceProcess
from brdf_viewer.tracing.request import QUALITIES, RENDERERS, Quality, Renderer, TraceRequest
from brdf_viewer.tracing.section import DEFAULT_SAMPLES, RENDERER_TITLES, picture_words, rate_words
from brdf_viewer.tracing.trace_input import TraceInput, make_trace_input
from brdf_viewer.window import ViewerWindow

KIND = "traced"
REST_MS = 200
"""A reference begins when nothing has changed for so long: in the middle of a drag it would only be thrown away."""

LIVE_S = 0.125
"""A ray-traced frame that takes no longer is shown while the hand moves, though it is a frame late."""

_KEEP_MS = 120_000
"""The process outlives a look at the real-time picture: to start it again takes seconds."""

_MESSAGE_MS = 6000
_FRAMES = 7
T = TypeVar("T", bound=str)


class TracedControl(ViewerFeature):
    """The renderer that is chosen, its process, and its newest picture on the viewer state.

    A picture that was asked for is dropped as soon as the scene is another one, by its generation.

    ``make_process`` makes what traces.

    Signals: ``changed()`` where the picture, or what is said of it, has changed; ``settled()`` where a traced picture
    is as good as it was asked to become, or there will be none.
    """

    changed = Signal()
    settled = Signal()

    def __init__(
        self,
        state: ViewerState,
        window: ViewerWindow,
        runner: TaskRunner,
        ask: AskTarget,
        *,
        make_process: Callable[[QObject], TraceProcess] = TraceProcess,
    ) -> None:
        super().__init__(state, window)
        self._runner, self._ask = runner, ask
        self._make_process = make_process
        self._process: TraceProcess | None = None
        self._generation = 0
        self._asked: TraceInput | None = None  # what is traced, or was
        self._answered = True  # whether there is a picture of what was asked for last
        self._stopped = False
        self._step = ""
        self._notices: tuple[str, ...] = ()
        self._hand_over = HandOver()
        self._frames: deque[float] = deque(maxlen=_FRAMES)
        self.quality: Quality = _known(str(settings().value("traced/quality")), QUALITIES, "fast")
        self.samples = int(str(settings().value("traced/samples", DEFAULT_SAMPLES)))
        self.denoised = bool(settings().value("traced/denoised", False, type=bool))
        self._rest = make_timer(self, self._begin)
        self._leave = make_timer(self, self._end_process, _KEEP_MS)
        section, commands = window.renderer, window.commands
        for signal, slot in (
            (section.renderer.picked, self.set_renderer),
            (commands.renderer.picked, self.set_renderer),
            (section.quality.picked, self.set_quality),
            (commands.quality.picked, self.set_quality),
            (section.samples.edited, lambda value: self.set_samples(round(value))),
            (section.denoised.clicked, self._set_denoised),
            (section.stop.clicked, self._stop),
            (commands.stop_refining.triggered, self._stop),
            (section.resume.clicked, self._resume),
            (commands.resume_refining.triggered, self._resume),
            (commands.save_traced.triggered, self._save),
        ):
            signal.connect(slot)
        state.view_changed.connect(lambda *_: self._follow())
        state.contents_changed.connect(self._follow)
        window.picture.frame_drawn.connect(self._follow)  # of another size, perhaps
        self._show()

    @property
    def renderer(self) -> Renderer:
        return self._state.renderer

    @property
    def process_id(self) -> int:
        """The process that traces; 0 where there is none."""
        return 0 if self._process is None else int(self._process.process.processId())

    @property
    def is_settled(self) -> bool:
        """Whether no trace is pending."""
        return self.renderer == "realtime" or (self._state.traced is not None and self._state.traced.done)

    def set_renderer(self, key: str) -> None:
        """Take another renderer; the real-time one ends what is traced."""
        renderer = _known(key, RENDERERS, "realtime")
        if renderer == self.renderer:
            return
        self._window.messages.dismiss(KIND)
        self._state.set_renderer(renderer)
        self._drop()
        self._notices, self._stopped = (), False
        self._frames.clear()
        if renderer == "realtime":
            self._leave.start()
        else:
            self._leave.stop()
            self._follow()
        self._show()

    def set_quality(self, key: str) -> None:
        """Trace rays with another preset; remembered. With another renderer on show, the ray tracer is taken."""
        self.quality = _known(key, QUALITIES, "fast")
        settings().setValue("traced/quality", self.quality)
        self._frames.clear()
        self.set_renderer("raytraced")
        self._follow()
        self._show()

    def set_samples(self, count: int) -> None:
        """Stop the reference at so many samples a pixel, 0: never; remembered."""
        self.samples = max(0, count)
        settings().setValue("traced/samples", self.samples)
        picture = self._state.traced
        is_enough = picture is not None and 0 < self.samples <= picture.samples
        if self.renderer == "reference" and not is_enough:
            self._resume()
        self._show()

    def _set_denoised(self, on: bool) -> None:
        """Show the reference without its noise, where there is a denoiser; remembered."""
        self.denoised = on
        settings().setValue("traced/denoised", on)
        self._send({"do": "denoise", "on": on})
        self._show()

    def _stop(self) -> None:
        """Refine no more; the picture stays until something changes."""
        if self.renderer == "realtime" or self._process is None:
            return
        self._stopped = True
        self._send({"do": "pause"})
        self._show()

    def _resume(self) -> None:
        if self.renderer == "realtime":
            return
        self._stopped = False
        self._send({"do": "resume", "samples": self._limit})
        self._show()

    def _save(self) -> None:
        """Ask for a file, and have the newest picture written to it as EXR."""
        fit = self._state.fit
        if self._state.traced is None or fit is None or self._process is None:
            return  # the command is not offered
        name = f"{fit.name} {self.renderer}"
        chosen = self._ask(self._window, name, tr("EXR, radiance with variance"), ".exr")
        if not chosen:
            return
        path = Path(chosen)
        path = path.with_name(path.name + ".exr") if path.suffix.lower() != ".exr" else path
        view = view_to_json(self._state.exposed_view)
        self._send({"do": "save", "path": str(path.absolute()), "view": view})

    def close(self) -> None:
        self._rest.stop()
        self._end_process()

    @property
    def _limit(self) -> int:
        return self.samples if self.renderer == "reference" else 0

    def _trace_input(self) -> TraceInput | None:
        return make_trace_input(self._state, self.renderer, self.quality, self._window.picture.device_size)

    def _follow(self, *_: object) -> None:
        """The scene may be another one: what is shown of the old one goes, and a new one is begun."""
        if self.renderer == "realtime":
            return
        wanted = self._trace_input()
        if wanted is None:
            self._drop()
            return
        if self._asked is not None and self._asked.same(wanted):
            return
        live = self.renderer == "raytraced"
        if not (live and self._is_live):
            self._hide()
        if not live:
            if self._asked is not None:
                self._send({"do": "pause"})
                self._asked = None
            self._rest.start(REST_MS)
            self._show()
        elif self._answered and not self._rest.isActive():
            self._rest.start(0)

    @property
    def _is_live(self) -> bool:
        """Whether the tracer keeps up with a hand."""
        return 0.0 < self._frame_s <= LIVE_S

    @property
    def _frame_s(self) -> float:
        """Seconds of a frame, the median of the last few; 0 before the first."""
        return median(self._frames) if self._frames else 0.0

    def _begin(self) -> None:
        wanted = self._trace_input()
        if wanted is None or (self._asked is not None and self._asked.same(wanted)):
            return
        if self._process is None:
            self._start_process()
        assert self._process is not None
        self._generation += 1
        self._asked, self._answered, self._stopped, self._step = wanted, False, False, ""
        write = partial(
            write_request,
            folder=self._process.folder,
            numbers=self._hand_over.numbers(wanted),
            generation=self._generation,
            samples=self._limit,
            denoised=self.denoised,
        )
        self._runner.submit(KIND, write, wanted, self._handed_over, lambda error: self._fail(str(error)))
        self._show()

    def _handed_over(self, request: TraceRequest) -> None:
        if request.generation == self._generation:
            self._send(request.to_json())
            forget_others(request)

    def _start_process(self) -> None:
        self._process = process = self._make_process(self)
        process.opened.connect(self._opened)
        process.moved.connect(self._moved)
        process.pictured.connect(self._pictured)
        process.failed.connect(self._trace_failed)
        process.crashed.connect(self._crashed)
        process.saved.connect(self._saved)
        todo = tr("Choose another name or folder.")
        process.not_saved.connect(lambda path, text: self._refuse(KIND, text, todo, where=path))
        process.start()

    def _end_process(self) -> None:
        self._runner.cancel(KIND)
        process, self._process = self._process, None
        self._hand_over = HandOver()
        if process is not None:
            process.end()
            process.deleteLater()

    def _send(self, message: dict[str, object]) -> None:
        if self._process is not None:
            self._process.send(message)

    def _opened(self, generation: int, notices: list[str], no_denoiser: str) -> None:
        if generation == self._generation:
            self._notices, self._step = tuple(notices), ""
            self._window.renderer.set_denoiser(no_denoiser)
            self._show()

    def _moved(self, generation: int, _fraction: float, what: str) -> None:
        if generation == self._generation and self._step != what:
            self._step = what
            self._show()

    def _pictured(self, picture: TracedPicture) -> None:
        if picture.generation != self._generation or self.renderer == "realtime":
            return
        self._answered = True
        if picture.done:
            self._frames.append(picture.seconds)
        wanted = self._trace_input()
        current = wanted is not None and self._asked is not None and self._asked.same(wanted)
        fits = wanted is not None and picture.size == wanted.size
        if current or (self.renderer == "raytraced" and self._is_live and fits):
            self._state.set_traced(picture)
            self._window.picture.redraw()
        self._show()
        if not current:
            self._follow()  # the newest of what came meanwhile
        elif picture.done:
            self.settled.emit()

    def _crashed(self, text: str) -> None:
        self._end_process()
        if self.renderer != "realtime":
            self._fail(text)

    def _trace_failed(self, generation: int, text: str) -> None:
        if generation == self._generation:
            self._fail(text)

    def _fail(self, text: str) -> None:
        """Say why there is no traced picture, and go on with the real-time one."""
        wanted = self.renderer
        self.set_renderer("realtime")
        todo = tr("The real-time picture continues.")
        actions = ((tr("Try Again"), lambda: self.set_renderer(wanted)),)
        message = Message(KIND, text, todo=todo, severity="error", actions=actions)
        self._window.messages.show_message(message)
        self.settled.emit()

    def _saved(self, path: str) -> None:
        self._window.messages.dismiss(KIND)
        self._window.status.showMessage(tr("Saved {name}").format(name=Path(path).name), _MESSAGE_MS)

    def _drop(self) -> None:
        """What is traced is wanted no more."""
        self._rest.stop()
        self._runner.cancel(KIND)
        if self._asked is not None:
            self._send({"do": "pause"})
        self._generation += 1
        self._asked, self._answered, self._step = None, True, ""
        self._hide()

    def _hide(self) -> None:
        if self._state.traced is not None:
            self._state.set_traced(None)
            self._window.picture.redraw()

    def _show(self) -> None:
        """Bring section, menu, status bar and the words over the picture to what there is."""
        window, renderer, picture = self._window, self.renderer, self._state.traced
        section = window.renderer
        section.show_renderer(renderer, self.quality, self.samples, denoised=self.denoised)
        window.commands.renderer.show_choice(renderer)
        window.commands.quality.show_choice(self.quality if renderer == "raytraced" else "")
        running = renderer != "realtime" and not self._stopped and not (picture is not None and picture.done)
        section.show_work(running=running, stopped=self._stopped)
        window.commands.offer_traced(picture is not None)
        words = "" if renderer == "realtime" else self._words(picture)
        section.set_state(words, "\n".join(self._notices) if renderer != "realtime" else "")
        window.overlay.show_mark(words)
        self.changed.emit()

    def _words(self, picture: TracedPicture | None) -> str:
        title = tr(RENDERER_TITLES[self.renderer])
        if picture is None:
            if self._stopped:
                return tr("Real-time picture; {renderer}: stopped").format(renderer=title)
            waits = tr("waiting for changes to end") if self._asked is None else tr("starting…")
            step = self._step or waits
            return tr("Real-time picture; {renderer}: {step}").format(renderer=title, step=step)
        words = picture_words(self.renderer, self.quality, picture)
        if self.renderer == "raytraced":
            words = "   ".join(word for word in (words, rate_words(self._frame_s)) if word)
        return words + ("   " + tr("stopped") if self._stopped and not picture.done else "")


def _known(key: str, known: tuple[T, ...], default: T) -> T:
    return next((item for item in known if item == key), default)
