"""The part of the window that holds the slices: it asks for what the plots that are shown need, and draws it.

A change of any kind marks plots as stale; they are drawn together, once, when the program comes to rest: many changes
of one gesture cost one drawing. Plots that are hidden are brought up to date when they are shown. Lines are worked out
at once, images on a thread: while one is made, no other is begun, and when it is there the newest wish is next.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from brdf_qt.program.feature import Feature
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.message_bar import message_of
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QObject
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QFileDialog

from brdf_lobe_visualizer.cuts.curves_plot import CurvesPlot
from brdf_lobe_visualizer.cuts.image_view import SliceImageView
from brdf_lobe_visualizer.cuts.images import Axes, Grid
from brdf_lobe_visualizer.cuts.lines import SliceLines, csv_of
from brdf_lobe_visualizer.cuts.pictures import Request, make_grid
from brdf_lobe_visualizer.cuts.polar_plot import PolarPlot
from brdf_lobe_visualizer.cuts.section import SlicesSection, SliceState
from brdf_lobe_visualizer.cuts.slice_views import (
    HalfAngleView,
    UnrolledView,
    half_angle_axes,
    half_angle_pairs_of,
    half_angle_places,
    unrolled_pairs_of,
    unrolled_places,
)
from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.subjects.subjects import SamplePoints, Srgb
from brdf_lobe_visualizer.window import LobeWindow
from brdf_lobe_visualizer.words import AXIS_TITLES, quantity
from brdf_suite.arrays import Floats
from brdf_suite.documents.atomic import write_atomically
from brdf_suite.errors import SuiteError
from brdf_suite.inspection.slices.cuts import Slice, difference_slice, half_slice, plane_slice

POLAR, CURVES, UNROLLED, HALF_ANGLE = "polar", "curves", "unrolled", "half_angle"
_TITLES = {
    POLAR: mark("Polar"),
    CURVES: mark("Curves"),
    UNROLLED: mark("Unrolled"),
    HALF_ANGLE: mark("Half angle"),
}


class Slices(Feature, QObject):
    """Polar plot, curves, unrolled hemispheres, half-angle slice, and their section."""

    def __init__(self, session: LobeSession, window: LobeWindow) -> None:
        super().__init__(window)
        self._session = session
        self.window = window
        self.state = SliceState(self)
        self.values = SliceLines(session)
        self.polar, self.curves = PolarPlot(), CurvesPlot(self.state)
        self.unrolled, self.half_angle = UnrolledView(), HalfAngleView()
        self._lines = {POLAR: self.polar, CURVES: self.curves}
        self._images: dict[str, SliceImageView] = {UNROLLED: self.unrolled, HALF_ANGLE: self.half_angle}
        self._cuts: dict[tuple[object, ...], Slice] = {}
        self._stale: set[str] = set(_TITLES)
        self._made: dict[str, Request] = {}
        self._running: set[str] = set()
        self._built = False
        for key, plot in {**self._lines, **self._images}.items():
            window.plots.add(key, tr(_TITLES[key]), plot)
        self.section = SlicesSection(self.state)
        window.add_section("slices", tr("Slices"), self.section, is_open=False)
        window.add_command("edit", mark("Copy Curves"), "copy_curves", self.copy_curves)
        window.add_command("file", mark("Save Curves as CSV…"), None, self._save_curves)
        self._timer = make_timer(self, self.draw_now)
        for signal in session.changes:
            signal.connect(self._all_stale)
        self.state.changed.connect(self._options_changed)
        window.plots.shown_changed.connect(lambda _key, _shown: self._timer.start())
        window.first_painted.connect(self._build)

    @property
    def is_idle(self) -> bool:
        shown = set(self._shown())
        return self._built and not self._timer.isActive() and not (self._stale | self._running) & shown

    def run_script(self, key: str, value: str) -> bool:
        """Take ``slices.NAME=VALUE``, for pictures that are made by scripts; False: it is not of here."""
        return key.startswith("slices.") and self.state.set_from_text(key.removeprefix("slices."), value)

    def draw_now(self) -> None:
        """Draw what is stale and shown; images are asked for."""
        self._timer.stop()
        if not self._built:
            return
        wanted = [key for key in self._shown() if key in self._stale]
        self._draw_lines([key for key in wanted if key in self._lines])
        for key in wanted:
            if key in self._images and key not in self._running:
                self._ask(key)

    def copy_curves(self) -> None:
        QGuiApplication.clipboard().setText(self.curves_csv())

    def save_curves(self, path: Path) -> None:
        try:
            write_atomically(path, self.curves_csv().encode())
            self._session.messages.dismiss_message("curves")
        except SuiteError as error:
            self._session.messages.show_message(message_of(error, "curves"))

    def curves_csv(self) -> str:
        """Return the curves of the chosen axis, whether they are shown or not."""
        (lines,) = self.values.of([self._curves_cut()])
        return csv_of(
            lines, tr(AXIS_TITLES[lines.cut.axis]), quantity(self._session.options), self._session.incidence
        )

    def _save_curves(self) -> None:
        filters = tr("Comma-separated values (*.csv)")
        title = tr("Save Curves as CSV")
        name, _ = QFileDialog.getSaveFileName(self.window, title, "curves.csv", filters)
        if name:
            self.save_curves(Path(name))

    def _draw_lines(self, wanted: list[str]) -> None:
        """Draw lines; polar plot and curves of the plane share its values, which are evaluated once."""
        if not wanted:
            return
        plane = self.state.options.axis in ("gamma", "theta_o")
        cuts = {key: self._plane() if key == POLAR or plane else self._curves_cut() for key in wanted}
        distinct = list({id(cut): cut for cut in cuts.values()}.values())
        lines = dict(zip(map(id, distinct), self.values.of(distinct), strict=True))
        if not self.state.options.samples:
            lines = {at: replace(found, points={}) for at, found in lines.items()}
        incidence, options = self._session.incidence, self._session.options
        for key, cut in cuts.items():
            found = lines[id(cut)]
            if key == POLAR:
                self.polar.show_lines(found, incidence, options, self.state.options.polar)
            else:
                own = self._curves_cut()
                turned = found if own.axis == cut.axis else found.reversed_over(own, incidence[0])
                self.curves.show_lines(turned, incidence[0], options)
            self._stale.discard(key)

    def _ask(self, key: str) -> None:
        """Ask a thread for a plot's images, unless it shows them already."""
        self._stale.discard(key)
        request = self._request(key)
        if request is None:
            self._made.pop(key, None)
            self._images[key].show_grid(None)
            return
        made = self._made.get(key)
        if made is not None and made.gives_same(request):
            return
        self._running.add(key)
        self._images[key].set_stale(True)
        # Images are made for the azimuth of the incidence, also where it does not matter.
        options, phi, front = self.state.options, self._session.incidence[1], self._session.front
        lights = options.incidences_deg, phi, options.phi_d_deg, options.by_root
        colour = (0.5, 0.5, 0.5) if front is None else front.colour
        self._session.tasks.submit(
            f"slices/{key}",
            make_grid,
            request,
            lambda grid: self._arrived(key, request, grid, lights, colour),
            lambda error: self._failed(key, error),
        )

    def _arrived(self, key: str, request: Request, grid: Grid, lights: tuple[Any, ...], colour: Srgb) -> None:
        self._made[key] = request
        self.unrolled.set_lights(*lights[:2]) if key == UNROLLED else self.half_angle.set_slice(*lights[2:])
        self._images[key].show_grid(grid, colour)
        self._session.messages.dismiss_message(f"slices/{key}")
        self._ended(key)

    def _failed(self, key: str, error: Exception) -> None:
        self._session.messages.show_message(message_of(error, f"slices/{key}"))
        self._ended(key)

    def _ended(self, key: str) -> None:
        self._running.discard(key)
        self._images[key].set_stale(False)
        if key in self._stale:
            self._timer.start()

    def _request(self, key: str) -> Request | None:
        subject, session, options = self._session.front, self._session, self.state.options
        if subject is None:
            return None
        phi, shown = session.incidence[1], session.options.shown
        other = session.reference if shown == "difference" else None
        if key == UNROLLED:
            angles = options.incidences_deg
            pairs = tuple(unrolled_pairs_of(angle, phi) for angle in angles)
            columns, axes = tuple(f"{angle:g}°" for angle in angles), Axes()
        else:
            pairs = (half_angle_pairs_of(options.phi_d_deg, phi, options.by_root),)
            columns, axes = ("",), half_angle_axes(options.by_root)

        def places(samples: SamplePoints, column: int) -> Floats:
            if key == UNROLLED:
                return unrolled_places(options.incidences_deg, phi, samples, column)
            return half_angle_places(options.phi_d_deg, phi, options.by_root, samples)

        return Request(
            title=subject.title,
            reflectance=session.target_of(subject),
            weights=session.weights_of(subject),
            other=None
            if other is None or other.key == subject.key
            else (other.title, session.target_of(other)),
            difference=shown == "difference",
            measured=subject.measured,
            samples=subject.samples if options.samples else None,
            pairs=pairs,
            columns=columns,
            channel=session.options.channel,
            cosine=session.options.cosine,
            tone=options.tone,
            ev=options.ev,
            quantity=quantity(session.options).removeprefix("Δ "),
            axes=axes,
            places=places,
        )

    def _build(self) -> None:
        self._built = True
        self.polar.build()
        self.curves.build()
        self._all_stale()

    def _shown(self) -> list[str]:
        return [key for key in _TITLES if key in self.window.plots.shown()]

    def _all_stale(self, *_: object) -> None:
        self._stale = set(_TITLES)
        self._timer.start()

    def _options_changed(self) -> None:
        self.curves.show_options(self.state.options)
        self._all_stale()

    def _curves_cut(self) -> Slice:
        theta, phi = self._session.incidence
        options = self.state.options
        if options.axis == "gamma":
            return self._kept("gamma", theta, phi)
        if options.axis == "theta_o":
            return self._plane()
        if options.axis == "theta_h":
            theta_d = theta if options.follow else options.theta_d_deg
            return self._kept("theta_h", theta_d, options.phi_d_deg, phi)
        return self._kept("theta_d", options.theta_h_deg, options.phi_d_deg, phi)

    def _plane(self) -> Slice:
        return self._kept("plane", *self._session.incidence)

    def _kept(self, kind: str, *angles: float) -> Slice:
        """Return a cut, the same object as long as its angles are the same: values are kept with it."""
        key = (kind, *angles)
        if key not in self._cuts:
            for old in [at for at in self._cuts if at[0] == kind]:
                del self._cuts[old]
            makers: dict[str, Callable[..., Slice]] = {
                "gamma": lambda theta, _phi: self._plane().over("gamma", theta),
                "plane": plane_slice,
                "theta_h": half_slice,
                "theta_d": difference_slice,
            }
            self._cuts[key] = makers[kind](*angles)
        return self._cuts[key]
