"""The second paint: chosen, frozen or a picture; loaded in the background, and shown beside the first."""

from __future__ import annotations

import dataclasses
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from brdf_qt.choosing.sources import Source
from brdf_qt.documents.recent_files import RecentFiles
from brdf_qt.fields.choices import set_note
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.names import title_of
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.message_bar import Message
from brdf_qt.work.tasks import TaskRunner
from brdf_qt.work.timer import make_timer
from PySide6.QtWidgets import QWidget

from brdf_suite.documents.view import View
from brdf_suite.errors import SuiteError
from brdf_suite.output.compared import load_compared
from brdf_suite.pipeline.material import ENTRY_MARK, paint_names
from brdf_suite.realtime.pictures.comparison import ComparedPicture, divider_px
from brdf_suite.regular_files import is_file
from brdf_viewer.compare.divider_gesture import DividerGesture
from brdf_viewer.compare.frozen_paints import freeze, frozen_title, touch
from brdf_viewer.documents.file_kinds import AskFile
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.overlay.overlay import OverlayLabel, Scale
from brdf_viewer.scene.viewer_state import OWN_KEY, RealTimePicture, ViewerState
from brdf_viewer.tracing.section import RENDERER_TITLES
from brdf_viewer.window import ViewerWindow

if TYPE_CHECKING:
    from brdf_suite.pipeline.lobe_fit import LobeFit

KIND = "compare"
_OFFER = "no second paint"
_TODO = mark("Choose another paint as B, or freeze the current one.")
_OF = {"light": mark("of the light, before the tone curve"), "picture": mark("of the picture, as shown")}


class CompareControl(ViewerFeature):
    """Keeps the viewer state's second paint and the window in step with ``view.compare``."""

    def __init__(self, state: ViewerState, window: ViewerWindow, runner: TaskRunner, ask: AskFile) -> None:
        super().__init__(state, window)
        self._runner, self._ask = runner, ask
        self._names = paint_names()
        self._recent = RecentFiles(f"recent/{KIND}")
        self._loading: str | None = None
        self._before_blink = "off"
        self._blink = make_timer(self, self.flip, single_shot=False)
        self._blinking = False
        section, commands = window.compare, window.commands
        for box in (section.mode, commands.compare):
            box.picked.connect(self.set_mode)
        for signal in (section.freeze.clicked, commands.freeze.triggered):
            signal.connect(self.freeze)
        section.chooser.chosen.connect(self.choose)
        section.chooser.browse_requested.connect(self._browse)
        section.basis.picked.connect(lambda key: self._change(basis=key))
        section.divider.edited.connect(lambda percent: self._change(divider=percent / 100.0))
        section.rate.edited.connect(lambda rate: self._change(rate_hz=rate))
        section.scale.edited.connect(lambda end: self._change(scale_delta_e=end))
        commands.blink.triggered.connect(self.toggle_blink)
        commands.flip.triggered.connect(self._flip_by_hand)
        window.busy_cancelled.connect(self._cancel)
        for slot in (self._listen, self._show):
            window.picture.canvas_changed.connect(slot)
        state.view_changed.connect(self._view_changed)
        state.contents_changed.connect(self._show)
        state.traced_changed.connect(self._traced_changed)
        self._list()
        self._listen(window.picture.canvas)
        self._view_changed(None, state.view)

    def set_mode(self, mode: str) -> None:
        """Show A and B in this way; without a B, say how to get one."""
        self._change(mode=mode)
        if mode != "off" and self._state.view.compare.paint is None and self._state.compared is None:
            self._offer()

    def choose(self, key: str) -> None:
        """Take a shipped paint or a file as B; where nothing is compared yet, side by side."""
        if key not in self._names and is_file(key):
            key = str(Path(key).absolute())
        mode = self._state.view.compare.mode
        self._change(paint=key or None, mode="side" if mode == "off" else mode)

    def toggle(self, key: str) -> None:
        """Take a paint as B; the one that is compared already ends the comparison."""
        second, mode = self._state.second, self._state.view.compare.mode
        if second is not None and second.key == key and mode != "off":
            self.set_mode("off")
        else:
            self.choose(key)

    def freeze(self) -> None:
        """Keep the paint on show, as it is now, as B."""
        state = self._state
        if state.fit is None:
            return
        second = None if state.second is None else state.second.key
        used = (state.view.compare.paint, second, state.paint_key)
        try:
            key = freeze(state.paint, state.paint_key, used)
        except SuiteError as error:
            self._report(error, KIND, tr(_TODO))
            return
        self.choose(key)

    def toggle_blink(self) -> None:
        """Blink, or go back to what was shown before."""
        mode = self._state.view.compare.mode
        if mode != "blink":
            self._before_blink = mode
        self.set_mode("blink" if mode != "blink" else self._before_blink)

    def flip(self) -> None:
        """Show the other one of a blink, and with the same frame its label."""
        self._state.shows_second = not self._state.shows_second
        self._window.picture.redraw(at_once=True)
        self._show()

    @property
    def is_idle(self) -> bool:
        return self._loading is None

    def close(self) -> None:
        self._blink.stop()

    def _flip_by_hand(self) -> None:
        if self._state.view.compare.mode != "blink":
            self.toggle_blink()
        elif self._state.compared is not None:
            self.flip()
        self._blink.stop()

    def _change(self, **fields: Any) -> None:
        self._state.change_part("compare", **fields)

    def _view_changed(self, old: View | None, new: View) -> None:
        if old is not None and old.compare == new.compare:
            return
        if new.compare.paint is None:
            self._end()
            self._state.set_second(None)
        elif self._state.second is None or self._state.second.key != new.compare.paint:
            self._load(new.compare.paint)
        elif self._loading is not None:
            self._cancel(KIND)
        self._show()

    def _load(self, key: str) -> None:
        if key == self._loading:
            return
        self._loading = key
        self._window.set_busy(KIND, 0.0, f"B: {_title(key)}")
        loaded = partial(self._loaded, key)
        work = partial(load_compared, settings=self._state.fitting)
        self._run(self._runner, KIND, work, key, loaded, self._failed, "B: ")

    def _loaded(self, key: str, value: LobeFit | ComparedPicture) -> None:
        self._loading = None
        if key not in self._names:
            self._recent.add(key)
            self._list()
        touch(key)
        self._state.set_second(key, value)

    def _failed(self, error: Exception) -> None:
        self._loading = None
        self._report(error, KIND, tr(_TODO))
        self._keep_present()

    def _cancel(self, kind: str) -> None:
        if kind == KIND and self._loading is not None:
            self._end()
            self._keep_present()

    def _end(self) -> None:
        self._loading = None
        self._runner.cancel(KIND)
        self._window.set_idle(KIND)

    def refused(self, error: Exception) -> None:
        """The graphics card did not take B."""
        self._state.set_second(None)
        self._report(error, KIND, tr(_TODO))
        self._keep_present()

    def _keep_present(self) -> None:
        """Another B cannot be had: the view names again the one that there is."""
        present = self._state.second
        compare = self._state.view.compare
        compare = dataclasses.replace(compare, paint=None if present is None else present.key)
        self._state.follow_view(compare=compare)
        self._show()

    def _offer(self) -> None:
        message = Message(
            _OFFER,
            tr("No second paint is selected."),
            todo=tr("Choose one in the tab Compare, or freeze the current paint as B."),
            actions=((tr("Freeze A as B"), self.freeze),),
        )
        self._window.messages.show_message(message)

    def _browse(self) -> None:
        path = self._ask(self._window, KIND)
        if path:
            self.choose(path)

    def _listen(self, canvas: QWidget) -> None:
        self._gesture = gesture = DividerGesture(canvas)
        gesture.moved.connect(lambda share: self._change(divider=share))
        gesture.started.connect(self._state.history.begin)
        gesture.finished.connect(self._state.history.end)

    def _traced_changed(self) -> None:
        if self._listed != (self._state.renderer != "realtime"):
            self._list()
        self._show()

    def _list(self) -> None:
        self._listed = self._state.renderer != "realtime"
        own = [Source(OWN_KEY, tr("This paint in real time"))] if self._listed else []
        shipped = [*own, *(Source(name, _title(name)) for name in self._names)]
        files = [Source(path, _title(path)) for path in self._recent.paths()]
        self._window.compare.chooser.set_sources(shipped, files)

    def _show(self) -> None:
        """Bring section, menu, overlay and clock to what is compared."""
        state, window = self._state, self._window
        compare, second = state.view.compare, state.compared
        key = self._loading or compare.paint
        window.compare.show_compare(compare)
        title = "" if key is None else _title(key)
        if key is not None and ENTRY_MARK in key and second is not None and second.key == key:
            title = name_of(second.key, second.value)
        window.compare.chooser.show_source(key or "", title)
        facts = [] if second is None or compare.mode == "off" else second_facts(second.value)
        set_note(window.compare.facts, "\n".join(facts))
        window.commands.compare.show_choice(compare.mode)
        if second is not None or compare.mode == "off":
            window.messages.dismiss(_OFFER)
        shown = compare.mode if second is not None else "off"
        window.strip.view.show_second(second.key if second is not None and shown != "off" else "")
        self._set_blinking(shown == "blink", compare.rate_hz)
        divider = compare.divider if shown == "swipe" else None
        self._gesture.set_divider(divider)
        if second is None or state.fit is None:
            window.overlay.show_labels((), None, None)
            return
        picture = isinstance(second.value, ComparedPicture) and not second.value.is_light
        basis = "picture" if picture else compare.basis
        scale = Scale(compare.scale_delta_e, tr(_OF[basis])) if shown == "difference" else None
        first = state.fit.name
        if state.renderer != "realtime":
            made_by = state.renderer if state.traced is not None else "realtime"
            first = f"{first}, {tr(RENDERER_TITLES[made_by]).lower()}"
        names = (f"A  {first}", f"B  {name_of(second.key, second.value, state.fit.name)}")
        width = window.picture.device_size[0]
        labels = labels_of(shown, names, state.shows_second, divider_px(compare.divider, width) / width)
        window.overlay.show_labels(labels, divider, scale)

    def _set_blinking(self, on: bool, rate_hz: float) -> None:
        interval = round(1000.0 / rate_hz)
        if on and not self._blinking:
            self._state.shows_second = True  # at once: the user asked to see the other one
            self._blink.start(interval)
        elif on and self._blink.interval() != interval:
            self._blink.setInterval(interval)
        elif not on:
            self._blink.stop()
            self._state.shows_second = False
        self._blinking = on


def labels_of(
    mode: str, names: tuple[str, str], shows_second: bool, divider: float
) -> tuple[OverlayLabel, ...]:
    """Return the captions of a comparison, each where its paint is."""
    first, second = names
    labels: dict[str, tuple[OverlayLabel, ...]] = {
        "swipe": (OverlayLabel(first, 0.0, divider), OverlayLabel(second, divider, 1.0 - divider)),
        "side": (OverlayLabel(first, 0.0, 0.5), OverlayLabel(second, 0.5, 0.5)),
        "blink": (OverlayLabel(second if shows_second else first),),
        "difference": (OverlayLabel(f"{first}  –  {second}"),),
    }
    return labels.get(mode, ())


def name_of(key: str, value: LobeFit | ComparedPicture | RealTimePicture, first: str = "") -> str:
    """Return what B is called; ``first`` is what A is."""
    if isinstance(value, RealTimePicture):
        return f"{first}, {tr(RENDERER_TITLES['realtime']).lower()}"
    return title_of(key) if isinstance(value, ComparedPicture) else value.name


def second_facts(value: LobeFit | ComparedPicture | RealTimePicture) -> list[str]:
    """Return what there is to say of B."""
    if isinstance(value, RealTimePicture):
        return [tr("B is the same paint in real time: all differences come from the renderer")]
    if isinstance(value, ComparedPicture):
        rows, columns = value.pixels.shape[:2]
        what = tr("light (linear)") if value.is_light else tr("display colours, with its own tone curve")
        text = tr("B is a picture of {columns} × {rows} pixels, {what}; it fits by its width")
        return [text.format(columns=columns, rows=rows, what=what)]
    worst = value.worst_delta_e
    text = tr("B: fit: maximum ΔE00 {worst:.2f} at the measured angles")
    fit = [] if worst is None else [text.format(worst=worst)]
    return [*fit, *map(tr_core, value.notices)]


def _title(key: str) -> str:
    return frozen_title(key) or title_of(key)
