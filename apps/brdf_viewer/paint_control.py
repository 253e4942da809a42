"""The paint on show: from Designer, shipped, or a file; fitted at once and drawn in the next frame."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from brdf_qt.exact_fit import ExactFit
from brdf_qt.fit_error import fit_tips, is_large, marked
from brdf_qt.link import LiveLink
from brdf_qt.message_bar import Message, message_of
from brdf_qt.tasks import TaskRunner
from brdf_qt.translation import tr
from PySide6.QtCore import QObject

from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.factored import FactoredPaint
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.palette_store import PALETTE_ENDING, load_palette
from brdf_suite.documents.store import PAINT_ENDING, AnyPaint
from brdf_suite.errors import SuiteError
from brdf_suite.pipeline.factored_maps import is_factored
from brdf_suite.pipeline.paint import PaintFit, PaintFitter
from brdf_suite.pipeline.scene import default_paint_name, paint_names
from brdf_suite.progress import Progress
from brdf_viewer.paint_patches import Patch
from brdf_viewer.paint_sequence import OpenPalette, is_swatch, stepped
from brdf_viewer.paint_source import DESIGNER, PaintSource
from brdf_viewer.recent_files import RecentFiles
from brdf_viewer.sections.note import set_note
from brdf_viewer.source_chooser import Source, title_of
from brdf_viewer.stage import Stage
from brdf_viewer.window import ViewerWindow

if TYPE_CHECKING:
    from brdf_suite.pipeline.any_fit import AnyFit

_KEY = "paint"
_OFFER = "follow"
_DESIGNER = "designer"
"""What Designer calls itself on the link."""


class PaintControl(QObject):
    """Fits what :class:`PaintSource` gives and puts it on the stage."""

    def __init__(
        self,
        stage: Stage,
        window: ViewerWindow,
        link: LiveLink,
        fitter: PaintFitter,
        runner: TaskRunner,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._runner = runner
        self._measuring: str | None = None
        self._palette: OpenPalette | None = None
        self._paints: dict[str, AnyPaint] = {}
        self._stepped_to = ""
        self._stage = stage
        self._window = window
        self._link = link
        self._fitter = fitter
        self._recent = RecentFiles(_KEY)
        self._recent_palettes = RecentFiles("palette")
        self._names = paint_names()
        self._exact = ExactFit(self)
        self._exact.arrived.connect(self._show_exact)
        # The same fit again: it no longer says that an exact one follows.
        self._exact.failed.connect(lambda fit, _error: self._show_fit(fit, self._shown_key))
        self._shown_key = ""
        self._offers = False
        self.source = PaintSource(self)
        self.source.changed.connect(self._take)
        self.source.following_changed.connect(self._show_following)
        link.received.connect(self._received)
        link.peers_changed.connect(self._show_following)
        window.paint.follow_edited.connect(self.source.set_following)
        window.paint.chooser.chosen.connect(self.open)
        window.commands.follow_wanted.connect(self.source.set_following)
        window.commands.paint_wanted.connect(self.open)
        window.commands.set_paints(self._shipped())
        window.commands.step_wanted.connect(self.step)
        window.commands.palette_close_wanted.connect(self.close_palette)
        window.busy_cancelled.connect(self._cancel)
        self._list()
        self._show_following()

    @property
    def measuring(self) -> str | None:
        """The measured file that is on its way; None where none is."""
        return self._measuring

    def start_with(self, name_or_path: str, *, follow: bool = True) -> None:
        """Show this paint until Designer has another one; without ``follow`` it stays, and Designer is offered.

        A paint that cannot be read or fitted is told, and the default one shown.
        """
        self.source.set_following(follow)
        self._offers = not follow
        self._show_following()
        ending = Path(name_or_path).suffix.lower()
        if ending and ending != PAINT_ENDING and Path(name_or_path).is_file():
            self.source.start_with(default_paint_name())  # until the file is read
            (self.open_palette if ending == PALETTE_ENDING else self.open)(name_or_path)
            return
        self._try(self.source.start_with, name_or_path)
        if self._stage.fit is None:
            told = self._window.messages.shown().get(_KEY)
            self.source.start_with(default_paint_name())
            if told is not None:
                self._window.messages.show_message(told)

    def open(self, key: str) -> None:
        """Show a shipped paint or a file, and follow Designer no more."""
        if key == DESIGNER:
            self.source.set_following(True)
            return
        self._stepped_to = key
        if key in self._paints:
            self.source.show(self._paints[key], key)
            return
        shipped = key in self._names
        key = key if shipped else str(Path(key).absolute())
        if not shipped and Path(key).suffix.lower() != PAINT_ENDING:
            self._measure(key)
        elif self._try(self.source.choose, key) and not shipped:
            self._remember(key)

    def open_palette(self, path: str) -> None:
        """Go through the paints of a palette from now on, and show its first."""
        path = str(Path(path).absolute())
        try:
            palette = load_palette(path)
        except SuiteError as error:
            self._tell(error)
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

    def _measure(self, key: str) -> None:
        """Fit a measured file in the background; the paint on show stays until it is there."""
        self._measuring = key
        title = title_of(key, {})
        self._window.messages.dismiss(_KEY)
        self._window.set_busy(_KEY, 0.0, title)
        self._runner.submit(
            _KEY,
            _fit_measured,
            key,
            done=lambda fit: self._measured(key, fit),
            failed=self._not_measured,
            progress=lambda fraction, what: self._window.set_busy(_KEY, fraction, f"{title}: {what}"),
        )

    def _measured(self, key: str, fit: AnyFit) -> None:
        self._cancel(_KEY)
        self.source.set_following(False)
        self._exact.forget()
        self._stage.set_fit(fit, None, key)
        self._shown_key = key
        self._show_fit(fit, key)
        self._remember(key)

    def _not_measured(self, error: Exception) -> None:
        self._cancel(_KEY)
        self._tell(error)
        self._show_choice()

    def _cancel(self, kind: str) -> None:
        """Give a measured file up, where one is on its way."""
        if kind == _KEY and self._measuring is not None:
            self._measuring = None
            self._runner.cancel(_KEY)
            self._window.set_idle(_KEY)
            self._show_choice()

    def _remember(self, key: str) -> None:
        self._recent.add(key)
        self._list()

    def _try(self, action: Any, key: str) -> bool:
        try:
            action(key)
        except SuiteError as error:
            self._tell(error)
            return False
        return True

    def _received(self, topic: str, value: dict[str, Any]) -> None:
        if topic == _KEY:
            self.source.received(value)

    def close(self) -> None:
        """Drop a fit that is still worked at."""
        self._fitter.close()

    def _take(self, paint: Paint | CookTorrancePaint | FactoredPaint, key: str) -> None:
        """The edit path: fit and draw; no file, no texture, no import. Only designed paints are edited."""
        self._cancel(_KEY)
        fit: PaintFit | AnyFit
        try:
            fit = self._fitter.fit(paint) if isinstance(paint, Paint) else _fitted(paint)
        except SuiteError as error:
            self._tell(error)
            return
        self._window.messages.dismiss(_KEY)
        if isinstance(fit, PaintFit):
            self._exact.watch(fit)
        else:
            self._exact.forget()
        self._stage.set_fit(fit, paint, key)
        self._shown_key = key
        self._show_fit(fit, key)

    def _show_exact(self, fit: PaintFit) -> None:
        """The optimum of the paint on show, where the time limit came first."""
        self._stage.set_fit(fit, fit.paint, self._shown_key)
        self._show_fit(fit, self._shown_key)

    def _tell(self, error: Exception) -> None:
        fit = self._stage.fit
        shown = default_paint_name().capitalize() if fit is None else fit.name
        todo = f"The picture shows {shown}. Choose another paint, or correct this one."
        self._window.messages.show_message(message_of(error, _KEY, todo=todo))

    def _show_fit(self, fit: PaintFit | AnyFit, key: str) -> None:
        section = self._window.paint
        self._show_choice()
        self._name_designer()
        self._show_place(key)
        section.patches.set_patches(_patches(fit))
        worst, follows = fit.worst_delta_e, _exact_follows(fit)
        section.set_fit_error(worst, fit.time_limited, follows)
        set_note(section.facts, "\n".join((*fit.notices, *_ways_of_light(fit))))
        limited = ", time-limited" if fit.time_limited else ""
        self._window.status.cell("lobes").set(
            f"{len(fit.weights.exponents)} lobes", "Cosine lobes of the fit"
        )
        large = worst is not None and is_large(worst)
        told = "" if worst is None else f" · {marked(f'ΔE {worst:.2f}', worst)}"
        tips = ["Time of the lobe fit, and its largest ΔE00 at the measured angles"]
        if worst is None:
            tips = ["Time of the lobe fit; there is no angle to compare colours at"]
        if more := fit_tips(worst, fit.time_limited, follows):
            tips.append(more)
        self._window.status.cell("fit").set(
            f"fit {fit.fit_seconds * 1e3:.2f} ms{told}{limited}",
            "\n".join(tips),
            "warning" if large or fit.time_limited else "fresh",
        )

    def _show_choice(self) -> None:
        key = self._shown_key
        title = self._designer_title() if key == DESIGNER else title_of(key, {})
        self._window.paint.chooser.show_source(key, "" if is_swatch(key) else title)

    def _show_place(self, key: str) -> None:
        words = "" if self._palette is None else self._palette.words(key)
        tip = "The open palette; the arrow keys go through it"
        self._window.status.cell("palette").set(words, tip)

    def _designer_title(self) -> str:
        """Return what Designer's paint is called; a program that has gone is not named as if it were there."""
        paint = self.source.of_designer
        name = "Paint" if paint is None else paint.name
        return f"{name} (Designer)" if _DESIGNER in self._link.peers else f"{name} (closed)"

    def _name_designer(self) -> None:
        self._window.paint.chooser.rename(DESIGNER, self._designer_title())

    def _show_following(self, *_: object) -> None:
        linked = _DESIGNER in self._link.peers
        following = self.source.following
        self._name_designer()
        self._offer(linked, following)
        self._window.paint.set_following(following, linked)
        self._window.commands.follow.setChecked(following)
        text = "linked: Designer" if linked else "Designer not open"
        others = ", ".join(self._link.peers) or "none"
        self._window.status.cell("link", right=True).set(
            text if following else f"{text}, not followed", f"Other programs on the link: {others}"
        )

    def _offer(self, linked: bool, following: bool) -> None:
        """Say once that a Designer is open, where the Viewer was told to show another paint at its start."""
        if following or not linked:
            self._window.messages.dismiss(_OFFER)
        elif self._offers:
            self._offers = False
            message = Message(
                _OFFER,
                "Designer is open; follow it to see its paint at every change.",
                todo="Until then the Viewer shows the paint that it was started with.",
                actions=(("Follow Designer", lambda: self.source.set_following(True)),),
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


def _fitted(paint: CookTorrancePaint | FactoredPaint) -> AnyFit:
    # Not on the edit path nor at the start, so not imported with it.
    from brdf_suite.pipeline.any_fit import fit_reflectance
    from brdf_suite.reflectance.build import build_reflectance

    return fit_reflectance(paint.name, build_reflectance(paint))


def _ways_of_light(fit: PaintFit | AnyFit) -> tuple[str, ...]:
    """Say of a factored paint what is drawn by its factors."""
    if isinstance(fit, PaintFit) or not is_factored(fit.reflectance):
        return ()
    return (tr("Factored: lamps are shaded by its maps, the environment by lobes that are fitted to it."),)


def _fit_measured(key: str, progress: Progress) -> AnyFit:
    # Not at the start: what reads measured files is much to import.
    from brdf_suite.pipeline.any_fit import fit_any

    return fit_any(key, errors=False, progress=progress)


def _exact_follows(fit: PaintFit | AnyFit) -> bool:
    """Only a designed paint's fit is finished after its limit."""
    return isinstance(fit, PaintFit) and fit.exact_follows


def _patches(fit: PaintFit | AnyFit) -> list[Patch]:
    """A designed paint's readings, or the usual angles that the fit looked at."""
    limited = fit.time_limited
    if isinstance(fit, PaintFit):
        follows = fit.exact_follows
        return [
            Patch(a.aspecular_deg, a.asked, a.fitted, a.delta_e_2000, limited, follows, a.illumination_deg)
            for a in fit.angles
        ]
    return [
        Patch(
            a.aspecular_deg,
            a.lab,
            a.lab_fitted,
            a.delta_e_2000,
            limited,
            illumination_deg=a.illumination_deg,
        )
        for a in fit.angles
        if a.fitted
    ]
