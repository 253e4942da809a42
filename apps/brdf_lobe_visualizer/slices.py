"""The part of the window that holds the slices: it asks for what the plots that are shown need, and draws it at once.

A change of any kind marks the plots as stale; they are drawn together, once, when the program comes to rest: many
changes of one gesture cost one drawing. Plots that are hidden are brought up to date when they are shown.
"""

from __future__ import annotations

from brdf_qt.translation import mark, tr
from PySide6.QtCore import QObject, QTimer

from brdf_lobe_visualizer.curves_plot import CurvesPlot
from brdf_lobe_visualizer.desk import Desk
from brdf_lobe_visualizer.polar_plot import PolarPlot
from brdf_lobe_visualizer.slice_lines import Lines, SliceLines
from brdf_lobe_visualizer.slice_options import SliceState
from brdf_lobe_visualizer.window import LobeWindow
from brdf_suite.pipeline.slices import Slice, difference_slice, half_slice, plane_slice

POLAR, CURVES = "polar", "curves"
_TITLES = {POLAR: mark("Polar"), CURVES: mark("Curves")}


class Slices(QObject):
    """Polar plot and curves."""

    def __init__(self, desk: Desk, window: LobeWindow) -> None:
        super().__init__(window)
        self._desk = desk
        self._window = window
        self.state = SliceState(self)
        self.values = SliceLines(desk)
        self.polar = PolarPlot()
        self.curves = CurvesPlot(self.state)
        self._plots = {POLAR: self.polar, CURVES: self.curves}
        self._cuts: dict[tuple[object, ...], Slice] = {}
        self._stale: set[str] = set(self._plots)
        self._built = False
        for key, plot in self._plots.items():
            window.add_plot(key, tr(_TITLES[key]), plot)
        self._timer = QTimer(self, singleShot=True, interval=0, timeout=self.draw_now)
        for signal in (
            desk.subjects_changed,
            desk.front_changed,
            desk.visibility_changed,
            desk.incidence_changed,
            desk.options_changed,
        ):
            signal.connect(self._all_stale)
        self.state.changed.connect(self._options_changed)
        window.plots.shown_changed.connect(self._plot_shown)
        window.first_painted.connect(self._build)

    @property
    def is_complete(self) -> bool:
        """Whether all that is shown is drawn."""
        return self._built and not self._timer.isActive() and not (self._stale & set(self._shown()))

    def draw_now(self) -> None:
        """Draw what is stale and shown."""
        self._timer.stop()
        if not self._built:
            return
        wanted = [key for key in self._shown() if key in self._stale]
        cuts = {key: self._cut(key) for key in wanted}
        if not cuts:
            return
        # Polar plot and curves of the plane share its values: they are evaluated once.
        own = {key: self._plane() if self._is_plane(key) else cut for key, cut in cuts.items()}
        distinct = list({id(cut): cut for cut in own.values()}.values())
        lines = dict(zip(map(id, distinct), self.values.of(distinct), strict=True))
        incidence, options = self._desk.incidence, self._desk.options
        for key, cut in own.items():
            found = lines[id(cut)]
            if key == POLAR:
                self.polar.show_lines(found, incidence, options)
            else:
                self.curves.show_lines(_over(found, cuts[key], incidence[0]), incidence[0], options)
            self._stale.discard(key)

    def _build(self) -> None:
        self._built = True
        for plot in self._plots.values():
            plot.build()
        self._all_stale()

    def _shown(self) -> list[str]:
        shown = self._window.plots.shown()
        return [key for key in self._plots if key in shown]

    def _all_stale(self, *_: object) -> None:
        self._stale = set(self._plots)
        self._timer.start()

    def _options_changed(self) -> None:
        self.curves.show_options(self.state.options)
        self._all_stale()

    def _plot_shown(self, _key: str, _shown: bool) -> None:
        self._timer.start()

    def _is_plane(self, key: str) -> bool:
        return key == POLAR or self.state.options.axis in ("gamma", "theta_o")

    def _cut(self, key: str) -> Slice:
        if self._is_plane(key):
            plane = self._plane()
            return plane if key == POLAR else plane.over(self.state.options.axis, self._desk.incidence[0])
        theta, phi = self._desk.incidence
        options = self.state.options
        if options.axis == "theta_h":
            theta_d = theta if options.follow else options.theta_d_deg
            return self._kept("theta_h", theta_d, options.phi_d_deg, phi)
        return self._kept("theta_d", options.theta_h_deg, options.phi_d_deg, phi)

    def _plane(self) -> Slice:
        return self._kept("plane", *self._desk.incidence)

    def _kept(self, kind: str, *angles: float) -> Slice:
        """Return a cut, the same object as long as its angles are the same: values are kept with it."""
        key = (kind, *angles)
        if key not in self._cuts:
            make = {"plane": plane_slice, "theta_h": half_slice, "theta_d": difference_slice}[kind]
            for old in [at for at in self._cuts if at[0] == kind]:
                del self._cuts[old]
            self._cuts[key] = make(*angles)
        return self._cuts[key]


def _over(lines: Lines, cut: Slice, theta_deg: float) -> Lines:
    """Return lines of the plane over θo as those over γ, which runs the other way; others as they are."""
    return lines if lines.cut.axis == cut.axis else lines.reversed_over(cut, theta_deg)
