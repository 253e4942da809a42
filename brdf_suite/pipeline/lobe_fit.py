"""A material becomes a :class:`LobeFit`: the weights of the fixed cosine lobes, their errors and notices.

The weights are of one kind, whatever they were fitted to, and the renderer draws them all. What differs is how:

- A designed paint and a Cook-Torrance one are two layers, each fitted for itself (``reflectance.designed.layers``).
- A reflectance without separate layers is fitted in a single step (``fitting.lobes.measured``).

:class:`PaintFitter` is the edit path: no file access, no import, no allocation that grows; under a millisecond or
two. What only :func:`fit_material` needs is therefore imported in it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, replace
from functools import cached_property, lru_cache
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats, triple
from brdf_suite.documents.atomic import with_lists
from brdf_suite.documents.paint import Flakes, OrangePeel, Paint
from brdf_suite.documents.view_settings import LightColour
from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.fitter import LayersFit, LobeFitter
from brdf_suite.fitting.lobes.samples import BaseSamples, CoatSamples
from brdf_suite.fitting.lobes.settings import FitSettings
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.fitting.metrics import AngleError, HeldOut
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.notebook import Shown
from brdf_suite.pipeline.material import SCATTERED, material_of, under_illuminant
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.reflectance.designed.aspecular_base import SeveralLights
from brdf_suite.reflectance.designed.paint_reflectance import PaintReflectance
from brdf_suite.reflectance.material import Material
from brdf_suite.reflectance.protocol import Layered, Reflectance

if TYPE_CHECKING:
    from concurrent.futures import Future

    from brdf_suite.fitting.lobes.measured import UndividedFit

DEFAULT_TIME_LIMIT_S = 0.004
PATIENT_TIME_LIMIT_S = 1.0
"""For work without a screen: no frame waits for the fit, and a busy machine must not make the answer worse."""

EXPONENTS_ALONE = (
    "It has no separate coat, so of the settings of the fit the exponents alone apply: the diffuse term is fitted with "
    "the lobes, and the weights of the samples are those of measured data."
)

#: ``split_layers`` is what has a coat and a base but is neither of the two kinds of paint.
Kind = Literal["designed", "cook_torrance", "layered", "measured"]


@dataclass(frozen=True, eq=False)
class LobeFit(Shown):
    """A material and the lobes fitted to it.

    Parameters
    ----------
    l1_errors
        Per part of the fit and channel, Σ w·|M x - b| over Σ w·b.
    notices
        Sentences for the user: those of the material, and what the fit has to add.
    fit_seconds
        The time from target samples in memory to weights.
    seconds
        The time from the paint's document to its weights, of a paint that is edited; else 0.
    angles
        Errors at the usual geometries; empty where they were not evaluated, as on the edit path.
    held_out
        Errors where the fit did not look; None where they were not asked for, or there are too few samples.
    incidences_deg
        Those of the fit.
    samples
        How many samples an undivided fit had.
    exact
        Where the time limit came first, it gets the fit with the optimum, unless the fitter's next paint comes before
        it; :func:`with_exact` makes it a fit of this material.
    weights_by_light
        For readings under other lights than the fit's: the lobes fitted with each, by its angle in degrees.
    settings
        Those of the fit.

    >>> import brdf_suite as bs
    >>> fitted = bs.fit("blue")
    >>> fitted.kind, fitted.eval([0.0, 0.0, 1.0], [0.6, 0.0, 0.8]).shape
    ('designed', (3,))
    """

    material: Material
    kind: Kind
    weights: LobeWeights
    l1_errors: Mapping[str, tuple[float, float, float]]
    notices: tuple[str, ...]
    fit_seconds: float
    seconds: float = 0.0
    angles: tuple[AngleError, ...] = ()
    held_out: HeldOut | None = None
    split_determined: bool = True
    incidences_deg: tuple[float, ...] = ()
    samples: int = 0
    exact: Future[LayersFit] | None = None
    weights_by_light: Mapping[float, LobeWeights] = field(default_factory=dict)
    settings: FitSettings = field(default_factory=FitSettings)

    @property
    def name(self) -> str:
        """The material's name."""
        return self.material.name

    @property
    def paint(self) -> Paint:
        """The designed paint that the lobes were fitted to; only of a material that is one."""
        assert self.material.paint is not None
        return self.material.paint

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return what was fitted, f_r (..., 3) in 1/sr, linear Rec. 2020, without the cosine; 0 below the horizon.

        Parameters
        ----------
        wi, wo
            Unit directions (..., 3) to the light and to the viewer, z along the normal; they broadcast.

        >>> import brdf_suite as bs
        >>> bs.fit("blue").eval(bs.spherical([0.2, 0.4], 0.0), [0.0, 0.0, 1.0]).shape
        (2, 3)
        """
        return self.weights.eval(wi, wo)

    @property
    def reflectance(self) -> Reflectance:
        """What the lobes were fitted to."""
        return self.material.reflectance

    @property
    def flakes(self) -> Flakes | None:
        """The material's flakes, where it has any."""
        return self.material.flakes

    @property
    def orange_peel(self) -> OrangePeel | None:
        """The waviness of the material's coat, where it has any."""
        return self.material.orange_peel

    @property
    def time_limited(self) -> bool:
        """True where the time limit came before the optimum."""
        return self.weights.time_limited

    @property
    def exact_follows(self) -> bool:
        """True while the optimum is still to come by ``exact``; False where it was cancelled or not found."""
        if self.exact is None or self.exact.cancelled():
            return False
        return not self.exact.done() or self.exact.exception() is None

    @cached_property
    def readings(self) -> tuple[AngleError, ...]:
        """A designed paint's readings: the document's L*a*b* and what the lobes give. Worked out at the first use."""
        return _readings(self.material.paint, self.weights, self.weights_by_light)

    @property
    def compared(self) -> tuple[AngleError, ...]:
        """A designed paint's readings, of all else the usual geometries that the fit looked at."""
        return self.readings or tuple(row for row in self.angles if row.fitted)

    @property
    def worst_delta_e(self) -> float | None:
        """The largest ΔE00 of :attr:`compared`; None where there is no such angle."""
        return max((row.delta_e_2000 for row in self.compared), default=None)

    def to_json(self) -> dict[str, object]:
        """Return everything as plain values, as JSON holds them; angles in degrees, times in milliseconds.

        >>> import brdf_suite as bs
        >>> plain = bs.fit("blue").to_json()
        >>> len(plain["exponents"]), plain["delta_e_2000_worst"] < 2.0
        (11, True)
        """
        weights, reflectance = self.weights, self.reflectance
        plain: dict[str, object] = {
            "name": self.name,
            "kind": self.kind,
            "exponents": weights.exponents.tolist(),
            "weighting": self.settings.weighting,
            "diffuse": self.settings.diffuse,
            "kd": weights.kd.tolist(),
            "kdd": weights.kdd.tolist(),
            "kg": weights.kg.tolist(),
            "theta_fit_deg": float(np.degrees(weights.theta_fit_rad)),
            "ior": weights.ior,
            "base_under_coat": weights.base_under_coat,
            "ms": self.fit_seconds * 1e3,
            "time_limited": self.time_limited,
            "split_determined": self.split_determined,
            "incidences_deg": list(self.incidences_deg),
            "samples": self.samples,
            "l1_relative": {name: list(errors) for name, errors in self.l1_errors.items()},
            "angles": [asdict(row, dict_factory=with_lists) for row in self.angles],
            "delta_e_2000_worst": self.worst_delta_e,
            "held_out": None if self.held_out is None else asdict(self.held_out),
            "notices": list(self.notices),
        }
        if self.readings and isinstance(reflectance, PaintReflectance):
            plain["judged_angles"] = plain["angles"]
            plain["paint"] = self.name
            plain["coat_roughness"] = reflectance.roughness
            plain["paint_to_weights_ms"] = self.seconds * 1e3
            rows = [asdict(row, dict_factory=with_lists) for row in self.readings]
            plain["angles"] = [
                {"lab_asked" if name == "lab" else name: row[name] for name in row if name != "fitted"}
                for row in rows
            ]
        return plain


def with_exact(fitted: LobeFit, found: LayersFit) -> LobeFit:
    """Return the same material with the lobes that were found after the time limit."""
    return replace(
        fitted,
        weights=found.weights,
        l1_errors=_l1_errors(found),
        fit_seconds=found.seconds,
        seconds=fitted.seconds + found.seconds - fitted.fit_seconds,
        exact=found.exact,
    )


class PaintFitter:
    """Fits paint after paint, or other layered materials, on one kept linear program.

    Parameters
    ----------
    settings
        How it fits; default: the suite's own basis, a joint diffuse term and absolute weights.
    time_limit_s
        Hard limit of one fit, in seconds.

    :meth:`close`, or losing the last reference, ends the thread that finishes what the limit cut short. ``lobe_fitter``
    is what fits.
    """

    def __init__(
        self, settings: FitSettings | None = None, *, time_limit_s: float = DEFAULT_TIME_LIMIT_S
    ) -> None:
        chosen = settings or FitSettings()
        self.lobe_fitter = LobeFitter(
            chosen.basis, time_limit_s=time_limit_s, weighting=chosen.weighting, diffuse=chosen.diffuse
        )
        self._of_other_lights: dict[float, LobeFitter] = {}

    @property
    def settings(self) -> FitSettings:
        """How it fits."""
        return self.lobe_fitter.settings

    def close(self) -> None:
        """Drop what is still worked at; a fit whose optimum is to come will not get it."""
        for fitter in (self.lobe_fitter, *self._of_other_lights.values()):
            fitter.close()

    def fit(self, paint: Paint) -> LobeFit:
        """Return the lobe fit of a paint that is edited.

        Raises
        ------
        UnreachableError
            The gloss or a colour is one that no such paint can have; the message says which.
        """
        start = perf_counter()
        material = material_of(paint)
        assert isinstance(material.reflectance, PaintReflectance)
        return self.fit_layers(material, material.reflectance, "designed", start)

    def fit_layers(
        self, material: Material, layers: Layered, kind: Kind, start: float | None = None
    ) -> LobeFit:
        """Return the lobe fit of a material, whose layers are given; the usual geometries are not evaluated.

        ``start`` is the reading of :func:`time.perf_counter` from which ``seconds`` counts; None: 0.
        """
        fit = self.lobe_fitter.fit(layers)
        weights = fit.weights
        notices = material.notices
        if isinstance(material.reflectance, PaintReflectance) and isinstance(
            material.reflectance.base, SeveralLights
        ):
            # Lobes know the mirror angle only, not how far light and view are apart.
            notices += (
                f"The lobes are fitted with the light at {np.degrees(weights.theta_fit_rad):.0f}°; the readings under "
                "other lights enter the picture by weights fitted for every angle of the view. The error stated at "
                "such a reading is that of lobes fitted with its light.",
            )
        if kind == "cook_torrance" and weights.ior == 1.0:
            notices += ("It has no sharp lobe that would be a coat: everything is fitted as base.",)
        by_light = self._weights_by_light(material, layers)
        return LobeFit(
            material=material,
            kind=kind,
            weights=weights,
            l1_errors=_l1_errors(fit),
            notices=notices,
            fit_seconds=fit.seconds,
            seconds=0.0 if start is None else perf_counter() - start,
            weights_by_light=by_light,
            incidences_deg=(float(np.degrees(weights.theta_fit_rad)),),
            exact=fit.exact,
            settings=self.settings,
        )

    def _weights_by_light(self, material: Material, layers: Layered) -> dict[float, LobeWeights]:
        """Return the lobes fitted with each other light of the readings, by its angle in degrees."""
        reflectance, paint = material.reflectance, material.paint
        if paint is None or not isinstance(reflectance, PaintReflectance):
            return {}
        if not isinstance(reflectance.base, SeveralLights):
            return {}
        usual = float(np.degrees(self.lobe_fitter.base_samples.theta_rad))
        others = {m.illumination_deg for m in paint.measurements} - {usual}
        return {light: self._fitter_at(light).fit(layers).weights for light in sorted(others)}

    def _fitter_at(self, illumination_deg: float) -> LobeFitter:
        """Return the fitter with the light at another angle, made at its first use."""
        if illumination_deg not in self._of_other_lights:
            theta = float(np.radians(illumination_deg))
            self._of_other_lights[illumination_deg] = LobeFitter(
                self.settings.basis,
                time_limit_s=self.lobe_fitter.time_limit_s,
                base_samples=BaseSamples.at(theta),
                coat_samples=CoatSamples(theta),
                weighting=self.settings.weighting,
            )
        return self._of_other_lights[illumination_deg]


def fit_material(
    material: Material,
    settings: FitSettings | None = None,
    *,
    errors: bool = False,
    progress: Progress | None = None,
) -> LobeFit:
    """Fit lobes to a material where no frame waits for them: as layers where it has them, else undivided.

    Parameters
    ----------
    settings
        How it is fitted, as for :class:`PaintFitter`; without layers the exponents alone apply, and a notice says so.
    errors
        Whether ``held_out`` is worked out, which takes longer than the fit.

    Raises
    ------
    FittingError
        A value is negative or not finite, or nothing lies above the horizon; the message names the material's origin.
    Cancelled
        The progress callback asked for it.
    """
    # No paint that is edited needs these; they would add 30 ms to the start of each program.
    from brdf_suite.pipeline.factored_maps import TOO_MANY, too_many_maps
    from brdf_suite.pipeline.fit_errors import angle_errors, fit_and_compare, held_out_errors
    from brdf_suite.reflectance.designed.layers import has_cook_torrance_base, split_layers

    report(progress, 0.0, "fitting")
    chosen = settings or FitSettings()
    layers = split_layers(material.reflectance)
    try:
        if layers is None:
            fitting = subrange(progress, 0.0, 0.3 if errors else 1.0)
            fitted = fit_and_compare(material.reflectance, chosen.basis, fitting)
            found = _undivided_fit(material, chosen, *fitted)
        else:
            kind: Kind = "layered"
            if isinstance(material.reflectance, PaintReflectance):
                kind = "designed"
            elif has_cook_torrance_base(material.reflectance):
                kind = "cook_torrance"
            fitter = PaintFitter(chosen, time_limit_s=PATIENT_TIME_LIMIT_S)
            try:
                found = fitter.fit_layers(material, layers, kind)
            finally:
                fitter.close()
            found = replace(found, angles=angle_errors(material.reflectance, found.weights))
    except FittingError as error:
        if not material.origin:
            raise
        raise type(error)(f"{Path(material.origin).name}: {error}") from error
    if too_many_maps(material.reflectance):
        found = replace(found, notices=(*found.notices, TOO_MANY))
    if errors:
        judging = subrange(progress, 0.3, 1.0)
        judged = held_out_errors(material.reflectance, found.weights, chosen.basis, judging)
        found = replace(found, held_out=judged)
    report(progress, 1.0, "done")
    return found


def refit_under(fit: LobeFit, colour: LightColour, progress: Progress | None = None) -> LobeFit:
    """Return the fit of the same material as it looks in a light to an adapted eye; the very fit where nothing differs.

    Its settings are those of ``fit``. Raises as :func:`fit_material`.
    """
    material = under_illuminant(fit.material, colour)
    if material is fit.material:
        return fit
    return replace(fit_material(material, fit.settings, progress=progress), notices=fit.notices)


def _undivided_fit(
    material: Material, settings: FitSettings, fit: UndividedFit, angles: tuple[AngleError, ...]
) -> LobeFit:
    # That samples are interpolated is true of reading them, not of fitting them.
    known = tuple(notice for notice in material.notices if notice != SCATTERED)
    if not settings.is_joint_and_absolute:
        known += (EXPONENTS_ALONE,)
    return LobeFit(
        material=material,
        kind="measured",
        weights=fit.weights,
        l1_errors={"whole": triple(fit.relative_error)},
        notices=(*known, *fit.notices),
        fit_seconds=fit.seconds,
        angles=angles,
        split_determined=fit.split_determined,
        incidences_deg=tuple(float(np.degrees(angle)) for angle in fit.incidences_rad),
        samples=fit.samples,
        settings=settings,
    )


def _l1_errors(fit: LayersFit) -> dict[str, tuple[float, float, float]]:
    return {"base": triple(fit.base_error.relative), "coat": triple(fit.coat_error.relative)}


def _readings(
    paint: Paint | None, weights: LobeWeights, by_light: Mapping[float, LobeWeights]
) -> tuple[AngleError, ...]:
    """Return the errors at a paint's readings, each of the lobes that were fitted with its light."""
    if paint is None:
        return ()
    lab = np.array([m.lab for m in paint.measurements])
    lights = np.array([m.illumination_deg for m in paint.measurements])
    light, view = _directions(tuple((m.illumination_deg, m.aspecular_deg) for m in paint.measurements))
    fitted = working_to_lab(np.pi * weights.eval(light, view))
    for angle, own in by_light.items():
        fitted[lights == angle] = working_to_lab(np.pi * own.eval(light, view))[lights == angle]
    difference = delta_e_2000(lab, fitted)
    return tuple(
        AngleError(m.illumination_deg, m.aspecular_deg, m.lab, triple(fitted[i]), float(difference[i]))
        for i, m in enumerate(paint.measurements)
    )


@lru_cache(maxsize=16)
def _directions(geometries: tuple[tuple[float, float], ...]) -> tuple[Floats, Floats]:
    """wi (n, 3) and wo (n, 3) of readings at illumination and aspecular angles, degrees: the same from edit to edit."""
    incidence, aspecular = np.array(geometries).T
    return illumination(incidence), aspecular_view(incidence, aspecular)
