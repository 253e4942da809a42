"""The paint on show: from Designer, shipped, or a file; fitted at once and drawn in the next frame."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from brdf_qt.choosing.sources import Source
from brdf_qt.documents.recent_files import RecentFiles
from brdf_qt.fields.choices import set_note
from brdf_qt.link.link import LiveLink
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.names import title_of
from brdf_qt.program.suite import connected_words
from brdf_qt.program.translation import decimal, tr
from brdf_qt.window.message_bar import Message
from brdf_qt.work.exact_fit import ExactFit
from brdf_qt.work.fit_error import fit_mark, fit_tips
from brdf_qt.work.tasks import TaskRunner
from brdf_qt.work.timer import make_timer

from brdf_suite.documents.paint import Paint
from brdf_suite.documents.palette import Palette
from brdf_suite.documents.store import AnyPaint, paint_from_json
from brdf_suite.errors import SuiteError
from brdf_suite.fitting.lobes.settings import FitSettings
from brdf_suite.pipeline.factored_maps import is_factored
from brdf_suite.pipeline.lobe_fit import LobeFit, PaintFitter, fit_material
from brdf_suite.pipeline.material import (
    default_paint_name,
    document_kind,
    file_kind,
    load_document,
    load_material,
    load_palette_file,
    load_shipped_paint,
    material_of,
    paint_names,
)
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.regular_files import is_file
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.paint.sequence import OpenPalette, is_swatch, stepped
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow

DESIGNER = "designer:"
"""The key of the paint that Designer holds; no file and no shipped paint has a name with a colon at its end."""
_KEY = "paint"
_OFFER = "follow"
_READERS = 4
_DEFAULT_MS = 250
"""A first paint that is read for longer is waited for behind the default one."""
_DESIGNER = "designer"
"""What Designer calls itself on the link."""


class PaintControl(ViewerFeature):
    """Fits Designer's paint while it is followed, else a shipped one or a file, and puts it on the viewer state.

    The paint ``first`` is shown until Designer has another one; without ``follow`` it stays, and Designer is offered.
    One that cannot be read or fitted is reported, and the default one shown; also until a file that takes a while is
    read.
    """

    def __init__(
        self,
        state: ViewerState,
        window: ViewerWindow,
        link: LiveLink,
        first: str,
        *,
        follow: bool,
    ) -> None:
        super().__init__(state, window)
        # Its own: a light that is being loaded keeps no paint waiting, nor does a disk that hangs the next file.
        self._runner = TaskRunner(self, threads=_READERS)
        self._first = first
        self._loading: str | None = None  # by name or file, in the background
        self._default_soon = make_timer(self, self._show_default_first, _DEFAULT_MS)
        self._palette: OpenPalette | None = None
        self._paints: dict[str, AnyPaint] = {}
        self._stepped_to = ""
        self._link = link
        self.fitter = PaintFitter(state.fitting)
        self._recent = RecentFiles(f"recent/{_KEY}")
        self._recent_palettes = RecentFiles("recent/palette")
        self._names = paint_names()
        self._exact = ExactFit(self)
        self._exact.arrived.connect(lambda fit: self._set_fit(fit, state.paint_key))
        # The same fit again: it no longer says that an exact one follows.
        self._exact.failed.connect(lambda fit, _error: self.show_fit(fit, self._state.paint_key))
        self.following = follow
        """Whether Designer's paint is shown as soon as there is one."""
        self._offers = not follow
        self.of_designer: AnyPaint | None = None
        """The newest paint that Designer has published; it stays when Designer closes."""
        link.received.connect(self._received)
        link.peers_changed.connect(self._show_following)
        window.paint.follow.clicked.connect(self.set_following)
        for taken in (window.paint.chooser.chosen, window.strip.taken):
            taken.connect(self.open)
        window.commands.follow.triggered.connect(self.set_following)
        window.commands.paint_requested.connect(self.open)
        window.commands.set_paints(self._shipped())
        window.commands.step_requested.connect(self.step)
        window.commands.palette_close.triggered.connect(self._close_palette)
        window.busy_cancelled.connect(self._give_up)
        self._list()
        self._show_following()

    def set_following(self, following: bool) -> None:
        """Follow Designer or not; its newest paint is shown at once."""
        if following == self.following:
            return
        self.following = following
        self._show_following()
        if following and self.of_designer is not None:
            self._show(self.of_designer, DESIGNER)

    def _received(self, topic: str, value: dict[str, Any]) -> None:
        """Take what Designer has published; ``value`` has passed the link's check."""
        if topic == _KEY:
            self.of_designer = paint_from_json(value, "Designer")
            if self.following:
                self._show(self.of_designer, DESIGNER)

    @property
    def is_idle(self) -> bool:
        return self._loading is None

    def start(self) -> None:
        if self._first in self._names:
            self._show_document(self._first)
            self._show_default_first()
            return
        self._load(str(Path(self._first).absolute()) if is_file(self._first) else self._first, is_first=True)
        # Nothing is drawn without a paint; the light takes longer than this in any case.
        self._default_soon.start()

    def _show_default_first(self) -> None:
        """Show the default paint where none is shown yet; a message about the one that was asked for stays."""
        self._default_soon.stop()
        if self._state.fit is not None:
            return
        message = self._window.messages.shown().get(_KEY)
        name = default_paint_name()
        self._fit(load_shipped_paint(name), name)
        if message is not None:
            self._window.messages.show_message(message)

    def open(self, key: str) -> None:
        """Show a shipped paint or a file, and follow Designer no more."""
        if key == DESIGNER:
            self.set_following(True)
            return
        self._stepped_to = key
        if key in self._paints:
            self.set_following(False)
            self._show(self._paints[key], key)
            return
        if key in self._names:
            self.set_following(False)
            self._show_document(key)
        else:
            self._load(str(Path(key).absolute()) if is_file(key) else key)

    def name_of(self, key: str) -> str:
        """Return the name by which a listed paint is loaded: of a swatch, its entry in the palette's file."""
        return key if self._palette is None else self._palette.name_of(key)

    def open_palette(self, path: str) -> None:
        """Go through the paints of a palette from now on, and show its first."""
        self._load(str(Path(path).absolute()), is_palette=True)

    def go_through(self, path: str, palette: Palette) -> None:
        """Go through the paints of a palette that was read from ``path``, and show its first."""
        self._palette = OpenPalette(path, palette)
        self._paints = self._palette.paints
        self._stepped_to = ""
        self._window.messages.dismiss(_KEY)
        self._list()
        for key in self._palette.keys[:1]:
            self.open(key)

    def _close_palette(self) -> None:
        """Go through the shipped paints again; the paint on show stays."""
        self._palette, self._paints = None, {}
        self._list()
        self._show_place(self._state.paint_key)

    def step(self, step: int) -> None:
        """Show the next paint of the palette, or of the shipped ones; -1 the one before."""
        keys = tuple(self._paints) if self._palette is not None else tuple(self._names)
        # From where the last step led, also where that paint could not be fitted.
        key = stepped(keys, self._stepped_to or self._state.paint_key, step)
        if key is not None:
            self.open(key)

    def _show_document(self, key: str) -> None:
        """Show the paint of a name or file; what has no document is loaded in the background."""
        try:
            document = load_document(key)
        except SuiteError as error:
            self._complain(error)
            return
        if document is None:
            self._load(key)
        else:
            self._show(document, key)

    def _load(self, key: str, *, is_palette: bool = False, is_first: bool = False) -> None:
        """Load what a file has in the background; the paint on show stays until it is there.

        The first one of a run ends no following of Designer.
        """
        self._loading = key
        title = title_of(key)
        self._window.set_busy(_KEY, 0.0, title)
        loaded = partial(self._loaded, key, keeps_following=is_first and self.following)
        request = _Request(key, is_palette, self._state.fitting)
        self._run(self._runner, _KEY, _read, request, loaded, self._not_loaded, f"{title}: ")

    def _loaded(self, key: str, found: _Found, *, keeps_following: bool) -> None:
        self._cancel(_KEY)
        if found.palette is not None:
            self._recent_palettes.add(key)
            self.go_through(key, found.palette)
            return
        if not keeps_following:
            self.set_following(False)
        if found.document is not None:
            self._show(found.document, key)
        elif found.fit is not None:
            self._exact.forget()
            self._set_fit(found.fit, key)
        if found.is_file:
            self._remember(key)

    def _not_loaded(self, error: Exception) -> None:
        self._cancel(_KEY)
        self._complain(error)
        self._show_default_first()

    def _give_up(self, kind: str) -> None:
        """Do what the button Cancel says; a picture has a paint also where the first one is given up."""
        if kind == _KEY and self._loading is not None:
            self._cancel(kind)
            self._show_default_first()

    def _cancel(self, kind: str) -> None:
        """Give up what is loaded in the background."""
        if kind == _KEY and self._loading is not None:
            self._loading = None
            self._runner.cancel(_KEY)
            self._window.set_idle(_KEY)
            self._show_choice()

    def _remember(self, key: str) -> None:
        self._recent.add(key)
        self._list()

    def close(self) -> None:
        self._default_soon.stop()
        self._runner.stop()
        self.fitter.close()

    def _show(self, paint: AnyPaint, key: str) -> None:
        """The edit path: fit and draw; no file, no texture, no import. Only designed paints are edited."""
        self._cancel(_KEY)
        self._fit(paint, key)
        # A first paint that cannot be fitted is reported, and the default one shown.
        self._show_default_first()

    def _fit(self, paint: AnyPaint, key: str) -> None:
        try:
            if isinstance(paint, Paint):
                fit = self.fitter.fit(paint)
            else:
                fit = fit_material(material_of(paint), self._state.fitting)
        except SuiteError as error:
            self._complain(error)
            return
        self._window.messages.dismiss(_KEY)
        self._exact.watch(fit)
        self._set_fit(fit, key)

    def _set_fit(self, fit: LobeFit, key: str) -> None:
        self._state.set_fit(fit, key)
        if key == DESIGNER:
            self._window.paint_thumbnails.set_content(key, fit.material.document)
        self.show_fit(fit, key)

    def _complain(self, error: Exception) -> None:
        fit = self._state.fit
        shown = default_paint_name().capitalize() if fit is None else fit.name
        todo = tr("The picture shows {shown}. Choose another paint, or correct this one.").format(shown=shown)
        self._report(error, _KEY, todo)

    def show_fit(self, fit: LobeFit, key: str) -> None:
        """Show name, notices, error and time of a fit in the window."""
        section = self._window.paint
        self._show_choice()
        self._window.paint.chooser.rename(DESIGNER, self._designer_title())
        self._show_place(key)
        # A designed paint's readings, or the usual angles that the fit looked at.
        section.patches.set_patches(fit.compared, fit.time_limited, fit.exact_follows)
        worst, follows = fit.worst_delta_e, fit.exact_follows
        section.set_fit_error(worst, fit.time_limited, follows)
        facts = [tr_core(notice) for notice in fit.notices]
        if fit.material.paint is None and is_factored(fit.reflectance):
            facts.append(tr("Factored paint: lamps use its maps, the environment uses fitted lobes."))
        set_note(section.facts, "\n".join(facts))
        limited = ", " + tr("time-limited") if fit.time_limited else ""
        text, sign = tr("Fit"), fit_mark(worst, fit.time_limited)
        tip = tr("No measured angles to compare with")
        if worst is not None:
            text = tr("Fit ΔE00 {worst}").format(worst=decimal(f"{worst:.2f}"))
            tip = tr("Maximum ΔE00 of the fit at the measured angles")
        how = tr("{count} cosine lobes, fitted in {ms} ms")
        milliseconds = decimal(f"{fit.fit_seconds * 1e3:.2f}")
        how = how.format(count=len(fit.weights.exponents), ms=milliseconds)
        tips = (tip, how, fit_tips(worst, fit.time_limited, follows))
        self._window.status.cell("fit").set(
            f"{text}{limited}",
            "\n".join(line for line in tips if line),
            "warning" if sign else "fresh",
            sign,
        )

    def _show_choice(self) -> None:
        key = self._state.paint_key
        title = self._designer_title() if key == DESIGNER else title_of(key)
        self._window.paint.chooser.show_source(key, "" if is_swatch(key) else title)

    def _show_place(self, key: str) -> None:
        words = "" if self._palette is None else self._palette.words(key)
        tip = tr("Open palette; the arrow keys select its paints")
        self._window.status.cell("palette").set(words, tip)

    def _designer_title(self) -> str:
        """Return what Designer's paint is called; a program that has gone is not named as if it were there."""
        name = tr("Paint") if self.of_designer is None else self.of_designer.name
        is_open = _DESIGNER in self._link.peers
        return f"{name} (Designer)" if is_open else tr("{name} (closed)").format(name=name)

    def _show_following(self, *_: object) -> None:
        linked = _DESIGNER in self._link.peers
        following = self.following
        self._window.paint.chooser.rename(DESIGNER, self._designer_title())
        self._offer(linked, following)
        self._window.paint.set_following(following, linked)
        self._window.commands.follow.setChecked(following)
        text = connected_words(self._link.peers)
        if linked and not following:
            text = tr("{link} (not following)").format(link=text)
        self._window.status.cell("link", right=True).set(text)

    def _offer(self, linked: bool, following: bool) -> None:
        """Say once that a Designer is open, where Viewer was asked to show another paint at its start."""
        if following or not linked:
            self._window.messages.dismiss(_OFFER)
        elif self._offers:
            self._offers = False
            message = Message(
                _OFFER,
                tr("Designer is open. Follow it to see its paint at every change."),
                todo=tr("Until then Viewer shows the paint that it was started with."),
                actions=((tr("Follow Designer"), lambda: self.set_following(True)),),
            )
            self._window.messages.show_message(message)

    def _shipped(self) -> list[Source]:
        return [Source(name, title_of(name)) for name in self._names]

    def _list(self) -> None:
        files = self._recent.paths()
        swatches = [Source(key, paint.name, "palette", paint) for key, paint in self._paints.items()]
        chooser = self._window.paint.chooser
        chooser.set_sources([*swatches, *self._shipped()], [Source(p, title_of(p)) for p in files])
        commands = self._window.commands
        commands.set_recent(_KEY, files)
        commands.set_recent("palette", self._recent_palettes.paths())
        commands.palette_close.setEnabled(self._palette is not None)


@dataclass(frozen=True)
class _Request:
    """What is read: a name or file; ``is_palette``: its paints are gone through, also where it has only one."""

    key: str
    is_palette: bool
    fitting: FitSettings


@dataclass(frozen=True)
class _Found:
    """What a name or file stands for, one of the three: of a material without a document there is the fit."""

    palette: Palette | None = None
    document: AnyPaint | None = None
    fit: LobeFit | None = None
    is_file: bool = False


def _read(request: _Request, progress: Progress) -> _Found:
    report(progress, 0.0, "reading")
    key = request.key
    if request.is_palette or (is_file(key) and file_kind(key) == "palette"):
        return _Found(palette=load_palette_file(key).palette)
    if not is_file(key) or document_kind(key) == "paint":
        document = load_document(key)
        if document is not None:
            return _Found(document=document, is_file=is_file(key))
    material = load_material(key)
    fit = fit_material(material, request.fitting, progress=subrange(progress, 0.1, 1.0))
    return _Found(fit=fit, is_file=is_file(key))
