"""A material's weights over the angle, fitted before the frame, and only in the modes that take them.

In the mode ``multi_angle`` a paint is fitted at 16 incidences (2 ms in the median, hard limit 16 ms) and the weights
are brought to the cosines of the renderer's ramp. Materials for which Fresnel's gains do not serve get weights for
every angle of the view (``seen_weights``). In the other modes nothing is fitted, and an edit costs nothing more. The
renderer receives the tables as arrays.

The solver's models take a quarter of a second to be set up. In a window that happens on a thread, and the picture
shows the raised weights until it is done.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from functools import lru_cache
from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.documents.view import View
from brdf_suite.fitting.lobes.basis import LobeBasis
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.pipeline.seen_queue import SeenQueue, SeenWeights
from brdf_suite.realtime.environment.look_up_table import RAMP_COSINES, TURNS, constant_light
from brdf_suite.realtime.values import MaterialWeights, WeightsOverAngle
from brdf_suite.reflectance.designed.aspecular_base import SeveralLights
from brdf_suite.reflectance.designed.paint_reflectance import PaintReflectance

if TYPE_CHECKING:
    from concurrent.futures import Future

    from brdf_suite.fitting.lobes.angles import AngleFit, AngleFitter, AngleGrid, AngleWeights
    from brdf_suite.pipeline.lobe_fit import LobeFit
    from brdf_suite.reflectance.protocol import Layered

_Key = tuple[tuple[float, ...], bool]

ROUGHEST_RAISED = 0.05
"""The largest α of a coat at which Fresnel's gains serve: at α = .08 constant light is 10 % too dark at 85°."""


class PaintAngles:
    """Keeps the fitters, one for each basis and kind of base; ``failed`` are those that could not be set up.

    Parameters
    ----------
    time_limit_s
        Limit of a fit; None: that of an edit.
    changed
        Where given, fitters are set up on a thread, and this is called (on any thread) whenever asking again gives
        something else: a fitter is ready, or an optimum has come after the limit. Otherwise the caller waits.
    """

    def __init__(
        self, *, time_limit_s: float | None = None, changed: Callable[[], None] | None = None
    ) -> None:
        self._time_limit_s = time_limit_s
        self._changed = changed
        self._fitters: dict[_Key, AngleFitter] = {}
        self._begun: set[_Key] = set()
        self.failed: set[_Key] = set()
        self._lock = threading.Lock()
        self._over: WeakKeyDictionary[LobeFit, FitOverAngle] = WeakKeyDictionary()
        self._seen: WeakKeyDictionary[LobeFit, SeenWeights] = WeakKeyDictionary()
        self._weights: WeakKeyDictionary[LobeFit, MaterialWeights] = WeakKeyDictionary()
        self._queue = None if changed is None else SeenQueue(self.notify)

    @property
    def waits(self) -> bool:
        """Whether :meth:`prepare` returns only when everything is fitted."""
        return self._changed is None

    def prepare(self, fit: LobeFit, view: View) -> None:
        """Fit what the modes of ``view`` take of ``fit``, or have it fitted on threads; before a frame, not in it."""
        if view.fresnel == "off":
            return
        by_view = self.by_view(fit) if view.look_up == "shifted" else None
        found = None if by_view is None else by_view.weights()
        if found is None and view.fresnel == "multi_angle" and (over_angle := self.of(fit)) is not None:
            over_angle.weights()

    def is_pending(self, fit: LobeFit, view: View) -> bool:
        """Whether weights of ``fit`` that the modes of ``view`` take were asked for and are not found yet."""
        by_view, over_angle = self._seen.get(fit), self._over.get(fit)
        if by_view is not None and by_view.is_pending:
            return True
        if view.fresnel != "multi_angle" or over_angle is None:
            return False
        return over_angle.is_pending and (
            view.look_up != "shifted" or by_view is None or by_view.found is None
        )

    def weights(self, fit: LobeFit) -> MaterialWeights:
        """Return the weights of ``fit`` with what is fitted over the angle by now, the same object while that stays."""
        over_angle, by_view = self._over.get(fit), self._seen.get(fit)
        known = (None if over_angle is None else over_angle.found, None if by_view is None else by_view.found)
        kept = self._weights.get(fit)
        if kept is None or (kept.over_angle, kept.by_view) != known:
            kept = self._weights[fit] = material_weights(fit.weights, *known)
        return kept

    def of(self, fit: LobeFit) -> FitOverAngle | None:
        """Return the fit of ``fit`` over the incidence; None where nothing divides it into layers."""
        from brdf_suite.reflectance.designed.layers import (  # 8 ms at the start of the Viewer
            depends_on_halfway,
            split_layers,
        )

        if fit not in self._over:
            layers = split_layers(fit.reflectance)
            if layers is None:
                return None
            exponents = tuple(fit.weights.exponents.tolist())
            self._over[fit] = FitOverAngle(self, layers, exponents, depends_on_halfway(layers))
        return self._over[fit]

    def by_view(self, fit: LobeFit) -> SeenWeights | None:
        """Return the search for weights at every angle of the view; None where Fresnel's gains serve.

        They serve designed paints read under one light whose coat is smooth enough. With several lights the colour
        depends on the light's angle too, of which the fit of one incidence knows nothing; and a rough coat does not
        reflect F, nor does it let 1 - F through.
        """
        reflectance = fit.reflectance
        if (
            isinstance(reflectance, PaintReflectance)
            and not isinstance(reflectance.base, SeveralLights)
            and reflectance.roughness <= ROUGHEST_RAISED
        ):
            return None
        # One fit is shown again and again: as another material, after another paint, in another light. And after a fit
        # that met its time limit comes the one with the optimum, of the same reflectance.
        if fit not in self._seen:
            exponents = tuple(fit.weights.exponents.tolist())
            known = (
                s for s in self._seen.values() if s.reflectance is reflectance and s.exponents == exponents
            )
            later = None if self._queue is None else self._queue.add
            self._seen[fit] = next(known, None) or SeenWeights(reflectance, exponents, later)
        return self._seen[fit]

    def close(self) -> None:
        """End the solvers; ``changed`` is called no more."""
        if self._queue is not None:
            self._queue.close()
        with self._lock:
            self._changed = None
            for fitter in self._fitters.values():
                fitter.close()
            self._fitters = {}

    def fitter(self, exponents: tuple[float, ...], halfway: bool) -> AngleFitter | None:
        """Return the fitter for a basis; None while it is set up on its thread, and where that has failed."""
        key = (exponents, halfway)
        with self._lock:
            if key in self._fitters or key in self._begun:
                return self._fitters.get(key)
            if self._changed is not None:
                self._begun.add(key)
                threading.Thread(target=self._set_up, args=(key,), name="angle fitter", daemon=True).start()
                return None
        self._set_up(key)
        return self._fitters[key]

    def notify(self) -> None:
        """Call ``changed``, where one was given."""
        with self._lock:
            changed = self._changed
        if changed is not None:
            changed()

    def _set_up(self, key: _Key) -> None:
        # 12 ms at the start of the Viewer.
        from brdf_suite.fitting.lobes.angles.fitter import TIME_LIMIT_S, AngleFitter

        limit = TIME_LIMIT_S if self._time_limit_s is None else self._time_limit_s
        try:
            fitter = AngleFitter(LobeBasis(key[0]), halfway=key[1], time_limit_s=limit)
        except BaseException:
            self.failed.add(key)
            raise
        with self._lock:
            self._fitters[key] = fitter
        self.notify()


class FitOverAngle:
    """The weights of one paint over the incidence, fitted when first asked for; ``found`` by now, or None."""

    def __init__(
        self, angles: PaintAngles, layers: Layered, exponents: tuple[float, ...], halfway: bool
    ) -> None:
        self._angles = angles
        self._layers = layers
        self._key = (exponents, halfway)
        self._asked = False
        self.found: WeightsOverAngle | None = None
        self._late: AngleFit | None = None

    @property
    def is_pending(self) -> bool:
        """Whether the weights were asked for, and their fitter is still being set up."""
        return self._asked and self.found is None and self._key not in self._angles.failed

    def weights(self) -> WeightsOverAngle | None:
        """Return the weights at the ramp's cosines, the same object until there are better ones; None: not yet."""
        self._asked = True
        if self._late is not None:
            self._take(self._late)
            self._late = None
        if self.found is None:
            fitter = self._angles.fitter(*self._key)
            if fitter is None:
                return None
            self._take(fitter.fit(self._layers))
        return self.found

    def _take(self, fit: AngleFit) -> None:
        self.found = at_ramp(fit.weights)
        if fit.exact is not None:
            fit.exact.add_done_callback(self._arrived)

    def _arrived(self, future: Future[AngleFit]) -> None:
        """On the fitter's thread: the optimum of a fit that met its limit, unless a newer one has overtaken it."""
        if not future.cancelled() and future.exception() is None:
            self._late = future.result()
            self._angles.notify()


def at_ramp(weights: AngleWeights) -> WeightsOverAngle:
    """Return the table of weights at the cosines of the renderer's ramp, mixed as the table says."""
    lower, share = weights.grid.shares(RAMP_COSINES)

    def mixed(table: Floats) -> Floats:
        part = share.reshape(share.shape + (1,) * (table.ndim - 1))
        return np.asarray((1.0 - part) * table[lower] + part * table[lower + 1])

    kdd, turned = mixed(weights.kdd), np.zeros((len(TURNS), RAMP_COSINES.size, *weights.kdd.shape[1:]))
    kg = mixed(weights.kg * _round_lobes(weights.grid, tuple(weights.exponents.tolist()))[..., None])
    return WeightsOverAngle(mixed(weights.kd), kdd, kg, turned)


@lru_cache(maxsize=8)
def _round_lobes(grid: AngleGrid, exponents: tuple[float, ...]) -> Floats:
    """Return (K, m) by how much the energy of a gloss lobe is above that of the round one that a picture draws.

    Above the horizon they differ towards grazing, where a round lobe has lost half, and for broad lobes.
    """
    from brdf_suite.fitting.lobes.angles.program import AngleCoatSamples

    array = np.array(exponents)
    _, above = constant_light(array, grid.cosines[:, None])
    whole = 2.0 * np.pi / (array + 1.0)
    return AngleCoatSamples(grid).lobe_energy(array) / (whole * above)


def material_weights(
    weights: LobeWeights,
    over_angle: WeightsOverAngle | None = None,
    by_view: WeightsOverAngle | None = None,
) -> MaterialWeights:
    """Return fitted weights as the renderer takes them, with those over the angle where they are fitted."""
    return MaterialWeights(
        exponents=tuple(weights.exponents.tolist()),
        kd=weights.kd,
        kdd=weights.kdd,
        kg=weights.kg,
        theta_fit_rad=weights.theta_fit_rad,
        ior=weights.ior,
        coat="dielectric" if weights.base_under_coat else "facets",
        over_angle=over_angle,
        by_view=by_view,
    )
