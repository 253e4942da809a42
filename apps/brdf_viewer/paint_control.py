"""The paint on show: from Designer, shipped, or a file; fitted at once and drawn in the next frame."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from brdf_qt.exact_fit import ExactFit
from brdf_qt.fit_error import fit_tips, is_large, marked
from brdf_qt.link import LiveLink
from brdf_qt.message_bar import Message, message_of
from PySide6.QtCore import QObject

from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.paint import Paint
from brdf_suite.errors import SuiteError
from brdf_suite.pipeline.paint import PaintFit, PaintFitter
from brdf_suite.pipeline.scene import default_paint_name, paint_names
from brdf_viewer.paint_patches import Patch
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
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._stage = stage
        self._window = window
        self._link = link
        self._fitter = fitter
        self._recent = RecentFiles(_KEY)
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
        self._list()
        self._show_following()

    def start_with(self, name_or_path: str, *, follow: bool = True) -> None:
        """Show this paint until Designer has another one; without ``follow`` it stays, and Designer is offered.

        A paint that cannot be read or fitted is told, and the default one shown.
        """
        self.source.set_following(follow)
        self._offers = not follow
        self._show_following()
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
        shipped = key in self._names
        key = key if shipped else str(Path(key).absolute())
        if self._try(self.source.choose, key) and not shipped:
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

    def _take(self, paint: Paint | CookTorrancePaint, key: str) -> None:
        """The edit path: fit and draw; no file, no texture, no import. Only designed paints are edited."""
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

    def _tell(self, error: SuiteError) -> None:
        fit = self._stage.fit
        shown = default_paint_name().capitalize() if fit is None else fit.name
        todo = f"The picture shows {shown}. Choose another paint, or correct this one."
        self._window.messages.show_message(message_of(error, _KEY, todo=todo))

    def _show_fit(self, fit: PaintFit | AnyFit, key: str) -> None:
        section = self._window.paint
        section.chooser.show_source(key, self._designer_title() if key == DESIGNER else title_of(key, {}))
        self._name_designer()
        section.patches.set_patches(_patches(fit))
        worst, follows = fit.worst_delta_e, _exact_follows(fit)
        section.set_fit_error(worst, fit.time_limited, follows)
        set_note(section.facts, "\n".join(fit.notices))
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
        self._window.paint.chooser.set_sources(self._shipped(), [Source(p, title_of(p, {})) for p in files])
        self._window.commands.set_recent(_KEY, files)


def _fitted(paint: CookTorrancePaint) -> AnyFit:
    # Not on the edit path nor at the start, so not imported with it.
    from brdf_suite.pipeline.any_fit import fit_reflectance
    from brdf_suite.reflectance.build import build_reflectance

    return fit_reflectance(paint.name, build_reflectance(paint))


def _exact_follows(fit: PaintFit | AnyFit) -> bool:
    """Only a designed paint's fit is finished after its limit."""
    return isinstance(fit, PaintFit) and fit.exact_follows


def _patches(fit: PaintFit | AnyFit) -> list[Patch]:
    """A designed paint's readings, or the usual angles that the fit looked at."""
    limited = fit.time_limited
    if isinstance(fit, PaintFit):
        follows = fit.exact_follows
        return [
            Patch(a.aspecular_deg, a.asked, a.fitted, a.delta_e_2000, limited, follows) for a in fit.angles
        ]
    return [
        Patch(a.aspecular_deg, a.lab, a.lab_fitted, a.delta_e_2000, limited) for a in fit.angles if a.fitted
    ]
