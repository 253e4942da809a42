"""One reflectance in the suite's three compact forms: cosine lobes, Cook-Torrance lobes and homomorphic factors.

All three are fitted to one part of the data and compared where none of them looked, in a picture, in size and in time.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from time import perf_counter, process_time
from typing import Literal, get_args

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError
from brdf_suite.fitting.cook_torrance import Settings, fit_checked_samples
from brdf_suite.fitting.cook_torrance.samples import (
    ASKED,
    FitErrors,
    Floor,
    errors_at,
    even_pairs,
    half_and_difference,
    samples_of,
    spread,
)
from brdf_suite.fitting.homomorphic.reflectance_fit import FactoringOptions, factor_reflectance
from brdf_suite.fitting.lobes.weights import RaisedWeights
from brdf_suite.inspection.sphere_picture import picture_differences, sphere_light
from brdf_suite.lighting.environment import Environment
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import Material
from brdf_suite.progress import Progress, report, stage, subrange
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.half_angle_grid import fill_holes
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

Kind = Literal["cosine lobes", "Cook-Torrance lobes", "homomorphic factors"]
KINDS: tuple[Kind, ...] = get_args(Kind)
HELD_OUT = 0.2
"""Share of the measured samples."""
HELD_OUT_PAIRS = ASKED // 3
_FEWEST_SAMPLES = 50
_SEED, _PAIRS_SEED = 7, 11
_ROWS, _HELD_ROW = 5, 2
_NUMBER_BYTES = 4
_TIMED_PAIRS, _TIMED_RUNS = 20_000, 3


@dataclass(frozen=True, eq=False)
class HeldOutSplit:
    """A reflectance in two parts: ``seen`` may be fitted, the rest is what the fits are compared with.

    The rest: f_r ``values`` (n, 3) in 1/sr at unit directions ``wi``, ``wo`` (n, 3). ``where`` says which ones.
    """

    seen: Reflectance
    wi: Floats
    wo: Floats
    values: Floats
    where: str

    def within(self, grazing_deg: float) -> HeldOutSplit:
        """Return the split with only those pairs whose light and view lie within this angle from the normal."""
        inside = np.minimum(self.wi[:, 2], self.wo[:, 2]) >= np.cos(np.radians(grazing_deg))
        where = f"{self.where}, within {grazing_deg:g}° of the normal"
        return replace(self, wi=self.wi[inside], wo=self.wo[inside], values=self.values[inside], where=where)

    def keep_edge(self, edge_deg: float) -> HeldOutSplit:
        """Return the split with those samples seen whose light or view is within this angle of the steepest one.

        Beyond the steepest nothing is measured: without the edge, fits would be compared where they extrapolate. What
        is not scattered samples has no such edge, and is returned as it is.
        """
        seen = self.seen
        if not isinstance(seen, ScatteredSamples):
            return self
        steep = np.minimum(self.wi[:, 2], self.wo[:, 2])  # cosines: the steeper, the smaller
        steepest = min(float(steep.min(initial=1.0)), float(seen.wi[:, 2].min()), float(seen.wo[:, 2].min()))
        edge = steep <= math.cos(max(math.acos(steepest) - math.radians(edge_deg), 0.0))
        wi, wo, values = (
            np.concatenate((one, own[edge]))
            for one, own in ((seen.wi, self.wi), (seen.wo, self.wo), (seen.values, self.values))
        )
        return HeldOutSplit(
            replace(seen, wi=wi, wo=wo, values=values),
            self.wi[~edge],
            self.wo[~edge],
            self.values[~edge],
            f"{self.where}, none within {edge_deg:g}° of the steepest",
        )


def hold_out(reflectance: Reflectance) -> HeldOutSplit:
    """Return a reflectance split into what is fitted and what is compared.

    A fifth of scattered samples is held out, drawn at random; of a table every fifth row of θd, which is a hole in the
    part that is seen. What can be evaluated anywhere is seen whole, and compared at 20,000 pairs that no fit draws.

    Raises
    ------
    FittingError
        There are fewer than 50 samples, or no measured row of the table would be held out.
    """
    if isinstance(reflectance, ScatteredSamples):
        if len(reflectance.wi) < _FEWEST_SAMPLES:
            reason = (
                f"{len(reflectance.wi)} samples cannot be divided into a part to fit and a part to compare"
            )
            raise FittingError(f"{reason}; {_FEWEST_SAMPLES} or more are needed.")
        order = np.random.default_rng(_SEED).permutation(len(reflectance.wi))
        held, kept = np.split(order, [round(HELD_OUT * len(order))])
        fields = ("wi", "wo", "values")
        wi, wo, values = (getattr(reflectance, field)[held] for field in fields)
        part = {field: getattr(reflectance, field)[kept] for field in fields}
        seen = replace(reflectance, **part, spectra=None, wavelengths_nm=None)
        return HeldOutSplit(seen, wi, wo, values, "a fifth of the samples, drawn at random")
    if isinstance(reflectance, IsotropicTable):
        return _rows_held_out(reflectance)
    wi, wo = even_pairs(HELD_OUT_PAIRS, _PAIRS_SEED, Settings().grazing_deg)
    where = "pairs even over √θh, θd and φd that no fit draws"
    return HeldOutSplit(reflectance, wi, wo, np.asarray(reflectance.eval(wi, wo)), where)


def _rows_held_out(table: IsotropicTable) -> HeldOutSplit:
    held = np.zeros(table.grid.shape, np.bool_)
    held[:, _HELD_ROW::_ROWS] = True
    measured = table.measured_mask()
    if not (measured & held).any() or not (measured & ~held).any():
        raise FittingError("The table has too few measured rows of θd to hold every fifth of them out.")
    values, holes = table.values.copy(), np.asarray(table.holes) | held
    fill_holes(values, holes, table.grid)
    coverage = table.coverage
    if coverage is not None:
        parts = {name: np.where(held, np.float32(0.0), value) for name, value in vars(coverage).items()}
        coverage = replace(coverage, **parts)
    seen = replace(table, values=values, holes=holes, coverage=coverage)
    places, pairs = np.argwhere(measured & held), []
    for h in np.unique(places[:, 0]):
        inside = (measured & held)[h]
        pairs.append([w[inside] for w in table.grid.pairs(h)])
    wi, wo = (np.concatenate(directions) for directions in zip(*pairs, strict=True))
    chosen = spread(*half_and_difference(wi, wo), HELD_OUT_PAIRS, _PAIRS_SEED)
    measured_values = table.values[tuple(places[chosen].T)].astype(np.float64)
    return HeldOutSplit(seen, wi[chosen], wo[chosen], measured_values, "bins of every fifth row of θd")


@dataclass(frozen=True, eq=False)
class Representation:
    """One compact form of a reflectance, fitted.

    ``numbers``: how many numbers of the paint it consists of; what all paints share, as the lobes' exponents, does not
    count. ``seconds``: of the fit.
    """

    kind: Kind
    reflectance: Reflectance
    numbers: int
    seconds: float
    notices: tuple[str, ...] = ()

    @property
    def size_bytes(self) -> int:
        """Its size in single precision."""
        return _NUMBER_BYTES * self.numbers


def fit_representations(
    material: Material,
    settings: Settings | None = None,
    factoring: FactoringOptions | None = None,
    progress: Progress | None = None,
) -> tuple[Representation, ...]:
    """Return the material in each of :data:`KINDS`, in their order; ``settings`` are of the Cook-Torrance lobes.

    Raises
    ------
    FittingError
        One of the fits is not possible; the message says which, and why.
    Cancelled
        The progress callback asked for it.
    """
    found: list[Representation] = []
    for number, fit in enumerate((_cosine_lobes, _cook_torrance_lobes, _factors)):
        step = stage(progress, number / len(KINDS), (number + 1) / len(KINDS), KINDS[number])
        start = perf_counter()
        try:
            made = fit(material, settings or Settings(), factoring or FactoringOptions(), step)
        except FittingError as error:
            raise FittingError(f"{material.name}, {KINDS[number]}: {error}") from error
        found.append(replace(made, seconds=perf_counter() - start))
    return tuple(found)


def _cosine_lobes(
    material: Material, _settings: Settings, _factoring: FactoringOptions, progress: Progress | None
) -> Representation:
    # Without its origin, which the message of an error would name a second time.
    fit = fit_material(replace(material, origin=""), progress=progress)
    weights = fit.weights
    numbers = (
        weights.kd.size + weights.kdd.size + weights.kg.size + 2
    )  # the angle of the fit and the coat's index
    return Representation(KINDS[0], RaisedWeights(weights), numbers, 0.0, fit.notices)


def _cook_torrance_lobes(
    material: Material, settings: Settings, _factoring: FactoringOptions, progress: Progress | None
) -> Representation:
    fit = fit_checked_samples(samples_of(material.reflectance, settings), settings, progress=progress)
    numbers = 3 + 5 * (fit.model.lobes - len(fit.dropped))
    return Representation(KINDS[1], fit, numbers, 0.0, fit.notices)


def _factors(
    material: Material, _settings: Settings, factoring: FactoringOptions, progress: Progress | None
) -> Representation:
    fit = factor_reflectance(material.name, material.reflectance, factoring, progress=progress)
    return Representation(KINDS[2], fit.value, 3 + sum(values.size for values in fit.maps.values()), 0.0)


@dataclass(frozen=True)
class Judged:
    """How one representation does.

    ``errors``: over the pairs that were held out; ``delta_e_mean``, ``delta_e_p99``: ΔE00 over the pixels of a sphere;
    ``nanoseconds``: processor time of an evaluation of one pair of directions.
    """

    kind: Kind
    errors: FitErrors
    delta_e_mean: float
    delta_e_p99: float
    size_bytes: int
    nanoseconds: float
    fit_seconds: float
    notices: tuple[str, ...]


@dataclass(frozen=True)
class Comparison:
    """The representations of one reflectance side by side: ``pairs`` were held out ``where`` it says."""

    name: str
    pairs: int
    where: str
    environment: str
    rows: tuple[Judged, ...]

    def to_json(self) -> dict[str, object]:
        """Return the figures as plain values."""
        rows = []
        for row in self.rows:
            errors = {f"held_out_{name}": value for name, value in asdict(row.errors).items()}
            rest = {name: value for name, value in vars(row).items() if name not in ("errors", "notices")}
            rows.append({**rest, **errors, "notices": list(row.notices)})
        held_out = {"pairs": self.pairs, "where": self.where}
        return {
            "name": self.name,
            "held_out": held_out,
            "environment": self.environment,
            "representations": rows,
        }


def compare_representations(
    material: Material,
    environment: Environment,
    settings: Settings | None = None,
    factoring: FactoringOptions | None = None,
    progress: Progress | None = None,
) -> tuple[Comparison, tuple[Representation, ...]]:
    """Fit the three representations to the part of a material that is seen, and judge them; errors as the fits'."""
    settings = settings or Settings()
    try:
        split = hold_out(material.reflectance).within(settings.grazing_deg)
    except FittingError as error:
        raise FittingError(f"{material.name}: {error}") from error
    seen = replace(material, reflectance=split.seen)
    found = fit_representations(seen, settings, factoring, subrange(progress, 0.0, 0.7))
    report(progress, 0.7, "pictures")
    light = sphere_light(environment)
    reference = light.radiance(material.reflectance)
    floor, rows = Floor.of(split.values), []
    for number, one in enumerate(found):
        report(progress, 0.8 + 0.2 * number / len(found), "errors")
        rows.append(
            _judged(one, split, floor, picture_differences(light.radiance(one.reflectance), reference))
        )
    report(progress, 1.0, "done")
    return Comparison(material.name, len(split.wi), split.where, environment.name, tuple(rows)), found


def _judged(one: Representation, split: HeldOutSplit, floor: Floor, differences: Floats) -> Judged:
    errors = errors_at(split.values, np.asarray(one.reflectance.eval(split.wi, split.wo)), floor)
    return Judged(
        one.kind,
        errors,
        float(differences.mean()),
        float(np.quantile(differences, 0.99)),
        one.size_bytes,
        _nanoseconds(one.reflectance, (split.wi, split.wo)),
        one.seconds,
        one.notices,
    )


def _nanoseconds(reflectance: Reflectance, pairs: Sequence[Floats]) -> float:
    """Return the processor time of an evaluation of one pair: the least of a few runs, which the first one warms up."""
    wi, wo = (np.resize(directions, (_TIMED_PAIRS, 3)) for directions in pairs)
    times = []
    for _ in range(_TIMED_RUNS):
        start = process_time()
        reflectance.eval(wi, wo)
        times.append(process_time() - start)
    return 1e9 * min(times) / _TIMED_PAIRS
