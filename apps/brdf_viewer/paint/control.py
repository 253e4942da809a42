"""The paint on show: from Designer, shipped, or a file; fitted at once and drawn in the next frame."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from brdf_qt.link.link import LiveLink
from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import Message, message_of
from brdf_qt.work.exact_fit import ExactFit
from brdf_qt.work.fit_error import fit_tips, is_large, marked
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import QObject

from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.factored import FactoredPaint
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.store import AnyPaint
from brdf_suite.errors import SuiteError
from brdf_suite.pipeline.factored_maps import is_factored
from brdf_suite.pipeline.lobe_fit import LobeFit, PaintFitter, fit_material
from brdf_suite.pipeline.material import (
    default_paint_name,
    document_kind,
    file_kind,
    is_file,
    load_document,
    load_material,
    load_palette_file,
    load_shipped_paint,
    material_of,
    paint_names,
)
from brdf_suite.progress import Progress, report, subrange
from brdf_viewer.documents.recent_files import RecentFiles
from brdf_viewer.fields.note import set_note
from brdf_viewer.fields.source_chooser import Source, title_of
from brdf_viewer.paint.patches import Patch
from brdf_viewer.paint.sequence import OpenPalette, is_swatch, stepped
from brdf_viewer.paint.source import DESIGNER, PaintSource
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow

if TYPE_CHECKING:
    from brdf_suite.pipeline.lobe_fit import LobeFit

_KEY = "paint"
_OFFER = "follow"
_DESIGNER = "designer"
"""What Designer calls itself on the link."""


class PaintControl(QObject):
    """Fits what :class:`PaintSource` gives and puts it on the viewer state."""

    def __init__(
        self,
        state: ViewerState,
        window: ViewerWindow,
        link: LiveLink,
        fitter: PaintFitter,
        runner: TaskRunner,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._runner = runner
        self._loading: str | None = None
        self._palette: OpenPalette | None = None
        self._paints: dict[str, AnyPaint] = {}
        self._stepped_to = ""
        self._state = state
        self._window = window
        self._link = link
        self.fitter = fitter
        self._recent = RecentFiles(_KEY)
        self._recent_palettes = RecentFiles("palette")
        self._names = paint_names()
        self._shown_key = ""
        self._exact = ExactFit(self)
        self._exact.arrived.connect(self._show_exact)
        # The same fit again: it no longer says that an exact one follows.
        self._exact.failed.connect(lambda fit, _error: self.show_fit(fit, self._shown_key))
        self._offers = False
        self.source = PaintSource(self)
        self.source.changed.connect(self._take)
        self.source.following_changed.connect(self._show_following)
        link.received.connect(self._received)
        link.peers_changed.connect(self._show_following)
        window.paint.follow_edited.connect(self.source.set_following)
        window.paint.chooser.chosen.connect(self.open)
        window.commands.follow_requested.connect(self.source.set_following)
        window.commands.paint_requested.connect(self.open)
        window.commands.set_paints(self._shipped())
        window.commands.step_requested.connect(self.step)
        window.commands.palette_close_requested.connect(self.close_palette)
        window.busy_cancelled.connect(self._cancel)
        self._list()
        self._show_following()

    @property
    def loading(self) -> str | None:
        """What is loaded in the background, by name or file; None where none is."""
        return self._loading

    def start_with(self, name_or_path: str, *, follow: bool = True) -> None:
        """Show this paint until Designer has another one; without ``follow`` it stays, and Designer is offered.

        A paint that cannot be read or fitted is reported, and the default one shown.
        """
        self.source.set_following(follow)
        self._offers = not follow
        self._show_following()
        file = is_file(name_or_path) and name_or_path not in self._names
        if file and document_kind(name_or_path) != "paint":
            self._show_default()  # until the file is read
            self.open(name_or_path)
            return
        self._show_document(name_or_path, self.source.start_with)
        if self._state.fit is None:
            message = self._window.messages.shown().get(_KEY)
            self._show_default()
            if message is not None:
                self._window.messages.show_message(message)

    def open(self, key: str) -> None:
        """Show a shipped paint or a file, and follow Designer no more."""
        if key == DESIGNER:
            self.source.set_following(True)
            return
        self._stepped_to = key
        if key in self._paints:
            self.source.show(self._paints[key], key)
            return
        file = key not in self._names and is_file(key)
        key = str(Path(key).absolute()) if file else key
        kind = document_kind(key) if file else "paint"
        if kind == "palette":
            self.open_palette(key)
        elif kind is None:
            self._load(key)
        elif self._show_document(key, self.source.show) and file:
            self._remember(key)

    def open_palette(self, path: str) -> None:
        """Go through the paints of a palette from now on, and show its first."""
        path = str(Path(path).absolute())
        try:
            palette = load_palette_file(path).palette
        except SuiteError as error:
            self._report(error)
            return
        self._palette = OpenPalette(path, palette)
        self._paints = self._palette.paints
        self._recent_palettes.add(path)
        self._window.messages.dismiss(_KEY)
        self._list()
        self.step(1)

    def close_palette(self) -> None:
        """Go through the shipped paints again; the paint on show stays."""
        self._palette, self._paints = None, {}
        self._list()
        self._show_place(self._shown_key)

    def step(self, step: int) -> None:
        """Show the next paint of the palette, or of the shipped ones; -1 the one before."""
        keys = tuple(self._paints) if self._palette is not None else tuple(self._names)
        # From where the last step led, also where that paint could not be fitted.
        key = stepped(keys, self._stepped_to or self._shown_key, step)
        if key is not None:
            self.open(key)

    def _show_default(self) -> None:
        name = default_paint_name()
        self.source.start_with(load_shipped_paint(name), name)

    def _show_document(self, key: str, show: Callable[[AnyPaint, str], None]) -> bool:
        """Show the paint of a name or file by ``show``; what has no document is loaded in the background."""
        try:
            document = load_document(key)
        except SuiteError as error:
            self._report(error)
            return False
        if document is None:
            self._load(key)
            return False
        show(document, key)
        return True

    def _load(self, key: str) -> None:
        """Load and fit what is no paint document in the background; the paint on show stays until it is there."""
        self._loading = key
        title = title_of(key, {})
        self._window.messages.dismiss(_KEY)
        self._window.set_busy(_KEY, 0.0, title)
        self._runner.submit(
            _KEY,
            _load_and_fit,
            key,
            done=lambda fit: self._loaded(key, fit),
            failed=self._not_loaded,
            progress=lambda fraction, what: self._window.set_busy(_KEY, fraction, f"{title}: {what}"),
        )

    def _loaded(self, key: str, fit: LobeFit | None) -> None:
        self._cancel(_KEY)
        if fit is None:
            self.open_palette(key)
            return
        self.source.set_following(False)
        self._exact.forget()
        self._state.set_fit(fit, key)
        self._shown_key = key
        self.show_fit(fit, key)
        if is_file(key):
            self._remember(key)

    def _not_loaded(self, error: Exception) -> None:
        self._cancel(_KEY)
        self._report(error)
        self._show_choice()

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

    def _received(self, topic: str, value: dict[str, Any]) -> None:
        if topic == _KEY:
            self.source.received(value)

    def close(self) -> None:
        """Drop a fit that is still worked at."""
        self.fitter.close()

    def _take(self, paint: Paint | CookTorrancePaint | FactoredPaint, key: str) -> None:
        """The edit path: fit and draw; no file, no texture, no import. Only designed paints are edited."""
        self._cancel(_KEY)
        try:
            fit = self.fitter.fit(paint) if isinstance(paint, Paint) else fit_material(material_of(paint))
        except SuiteError as error:
            self._report(error)
            return
        self._window.messages.dismiss(_KEY)
        self._exact.watch(fit)
        self._state.set_fit(fit, key)
        self._shown_key = key
        self.show_fit(fit, key)

    def _show_exact(self, fit: LobeFit) -> None:
        """The optimum of the paint on show, where the time limit came first."""
        self._state.set_fit(fit, self._shown_key)
        self.show_fit(fit, self._shown_key)

    def _report(self, error: Exception) -> None:
        fit = self._state.fit
        shown = default_paint_name().capitalize() if fit is None else fit.name
        todo = tr("The picture shows {shown}. Choose another paint, or correct this one.").format(shown=shown)
        self._window.messages.show_message(message_of(error, _KEY, todo=todo))

    def show_fit(self, fit: LobeFit, key: str) -> None:
        """Show name, notices, error and time of a fit in the window."""
        section = self._window.paint
        self._show_choice()
        self._name_designer()
        self._show_place(key)
        section.patches.set_patches(_patches(fit))
        worst, follows = fit.worst_delta_e, fit.exact_follows
        section.set_fit_error(worst, fit.time_limited, follows)
        set_note(section.facts, "\n".join((*fit.notices, *_ways_of_light(fit))))
        limited = ", " + tr("time-limited") if fit.time_limited else ""
        self._window.status.cell("lobes").set(
            tr("{count} lobes").format(count=len(fit.weights.exponents)), tr("Cosine lobes of the fit")
        )
        large = worst is not None and is_large(worst)
        message = "" if worst is None else f" · {marked(f'ΔE {worst:.2f}', worst)}"
        tips = [tr("Duration of the lobe fit, and its maximum ΔE00 at the measured angles")]
        if worst is None:
            tips = [tr("Duration of the lobe fit; no measured angles to compare with")]
        if more := fit_tips(worst, fit.time_limited, follows):
            tips.append(more)
        self._window.status.cell("fit").set(
            tr("fit {ms} ms").format(ms=f"{fit.fit_seconds * 1e3:.2f}") + f"{message}{limited}",
            "\n".join(tips),
            "warning" if large or fit.time_limited else "fresh",
        )

    def _show_choice(self) -> None:
        key = self._shown_key
        title = self._designer_title() if key == DESIGNER else title_of(key, {})
        self._window.paint.chooser.show_source(key, "" if is_swatch(key) else title)

    def _show_place(self, key: str) -> None:
        words = "" if self._palette is None else self._palette.words(key)
        tip = tr("Open palette; the arrow keys select its paints")
        self._window.status.cell("palette").set(words, tip)

    def _designer_title(self) -> str:
        """Return what Designer's paint is called; a program that has gone is not named as if it were there."""
        paint = self.source.of_designer
        name = tr("Paint") if paint is None else paint.name
        is_open = _DESIGNER in self._link.peers
        return f"{name} (Designer)" if is_open else tr("{name} (closed)").format(name=name)

    def _name_designer(self) -> None:
        self._window.paint.chooser.rename(DESIGNER, self._designer_title())

    def _show_following(self, *_: object) -> None:
        linked = _DESIGNER in self._link.peers
        following = self.source.following
        self._name_designer()
        self._offer(linked, following)
        self._window.paint.set_following(following, linked)
        self._window.commands.follow.setChecked(following)
        text = tr("Designer not open")
        if linked:
            text = tr("Designer connected") if following else tr("Designer connected (not following)")
        others = ", ".join(self._link.peers) or tr("none")
        self._window.status.cell("link", right=True).set(
            text, tr("Other programs on the link: {programs}").format(programs=others)
        )

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
                actions=((tr("Follow Designer"), lambda: self.source.set_following(True)),),
            )
            self._window.messages.show_message(message)

    def _shipped(self) -> list[Source]:
        return [Source(name, title_of(name, {}).capitalize()) for name in self._names]

    def _list(self) -> None:
        files = self._recent.paths()
        swatches = [Source(key, paint.name) for key, paint in self._paints.items()]
        chooser = self._window.paint.chooser
        chooser.set_sources([*swatches, *self._shipped()], [Source(p, title_of(p, {})) for p in files])
        commands = self._window.commands
        commands.set_recent(_KEY, files)
        commands.set_recent("palette", self._recent_palettes.paths())
        commands.palette_close.setEnabled(self._palette is not None)


def _ways_of_light(fit: LobeFit) -> tuple[str, ...]:
    """Say of a factored paint what is drawn by its factors."""
    if fit.material.paint is not None or not is_factored(fit.reflectance):
        return ()
    return (tr("Factored paint: lamps use its maps, the environment uses fitted lobes."),)


def _load_and_fit(key: str, progress: Progress) -> LobeFit | None:
    """Return the fit of a name or file; None of a palette with several paints."""
    report(progress, 0.0, "reading")
    if is_file(key) and file_kind(key) == "palette":
        return None
    return fit_material(load_material(key), progress=subrange(progress, 0.1, 1.0))


def _patches(fit: LobeFit) -> list[Patch]:
    """A designed paint's readings, or the usual angles that the fit looked at."""
    return [
        Patch(
            row.aspecular_deg,
            row.lab,
            row.lab_fitted,
            row.delta_e_2000,
            fit.time_limited,
            fit.exact_follows,
            row.illumination_deg,
        )
        for row in fit.compared
    ]
