"""Complete fit: many starts on few samples, the best on all, other Fresnel reflectances, fewer lobes where sufficient.

The energy has valleys. Those over the slopes are met by the starts. Those over the Fresnel reflectance are met by
jumps: F/r falls and then rises towards grazing, so r = .9 and r = .5 look alike up to 60° and a search from one side
ends at a wrong bottom. So from the best answer each lobe in turn is set to other reflectances and searched again.

At last each lobe is taken away, and the rest searched again. Where the answer is as good but for what chance gives
(Schwarz' criterion, for errors of Laplace's distribution, whose likelihood |log(fit/measured)| is), it stays away,
with a weight of 0: two lobes where one is enough have no determined parameters.
"""

from __future__ import annotations

import hashlib
import json
import math
from collections.abc import Iterator, Mapping
from functools import partial
from pathlib import Path

import numpy as np
import numpy.typing as npt

from brdf_suite.documents.atomic import encode, write_atomically
from brdf_suite.errors import FileError, FittingError
from brdf_suite.fitting.cook_torrance.model import LobeModel, Vector, inverse_index
from brdf_suite.fitting.cook_torrance.result import (
    CookTorranceFit,
    Profile,
    covariance_of,
    standard_errors,
)
from brdf_suite.fitting.cook_torrance.samples import LobeSamples, check_samples
from brdf_suite.fitting.cook_torrance.settings import Settings
from brdf_suite.fitting.cook_torrance.solve import COARSE, FINE, FitProblem, final_cost, search
from brdf_suite.fitting.cook_torrance.starts import starts
from brdf_suite.fitting.cook_torrance.uncertainty import (
    Noise,
    alternatives_of,
    blurred_once_more,
    profiles_of,
    widened,
)
from brdf_suite.progress import Progress, report
from brdf_suite.regular_files import exists, read_bytes

VERSION = 1
"""Of the search; kept starts of another one are of no use."""
COARSE_SAMPLES = 1500
_STEPS, _FINE_STEPS, _JUMP_STEPS = 60, 80, 30
_REFINED = 2
_JUMPS = (0.05, 0.25, 0.6, 0.93)
_ROUNDS = 3
# What a change must win to be worth keeping, and below which a difference is rounding of the data.
_GAIN, _ROUNDING = 1e-3, 2e-6
_WORTH_A_LOOK = 1.03
_LOOKED_AT = 4
STARTS_FORMAT = "brdf-suite starts of a lobe fit"
STARTS_VERSION = 1
_LARGEST = 1 << 20


def fit_lobes(
    wi: npt.ArrayLike,
    wo: npt.ArrayLike,
    values: npt.ArrayLike,
    weights: npt.ArrayLike | None = None,
    settings: Settings | None = None,
    *,
    kept: StartsFile | None = None,
    progress: Progress | None = None,
) -> CookTorranceFit:
    """Fit lobes to samples of a reflectance: equations 1 to 3 of Günther et al. 2005.

    Parameters
    ----------
    wi, wo
        (n, 3) unit directions, local frame, z along the normal.
    values
        (n, 3) f_r in 1/sr, working space, without the cosine. Those of 0 or less, and not finite ones, are left out.
    weights
        (n,) how much each counts, at least 0; all alike if left out.
    settings
        What is fitted and how; :class:`Settings` if left out.
    kept
        Where the ends of the starts are kept and looked for.

    Raises
    ------
    FittingError
        The arrays do not fit together, or hold fewer values than there are parameters; the message says which.
    Cancelled
        The progress callback asked for it.

    >>> from brdf_suite.reflectance.models.cook_torrance import CookTorrance
    >>> from brdf_suite.reflectance.models.table_1 import TABLE_1
    >>> rng = np.random.default_rng(0)
    >>> wi, wo = (rng.normal(size=(900, 3)) + [0, 0, 2] for _ in range(2))
    >>> wi, wo = (np.abs(w) / np.linalg.norm(w, axis=1)[:, None] for w in (wi, wo))
    >>> values = CookTorrance(TABLE_1["table1_polaris_silver"]).eval(wi, wo)
    >>> fit_lobes(wi, wo, values, settings=Settings(lobes=3)).kd.round(3).tolist()
    [0.055, 0.063, 0.071]
    """
    settings = settings or Settings()
    samples = check_samples(wi, wo, values, weights, settings.grazing_deg)
    return fit_checked_samples(samples, settings, kept=kept, progress=progress)


def fit_checked_samples(
    samples: LobeSamples,
    settings: Settings,
    *,
    kept: StartsFile | None = None,
    progress: Progress | None = None,
) -> CookTorranceFit:
    """Fit lobes to samples that are checked already; otherwise as :func:`fit_lobes`."""
    model = LobeModel(settings.model, settings.lobes)
    if model.coat and settings.lobes < 2:
        reason = "with fewer than two there is nothing below it"
        raise FittingError(f"A clearcoat counts as one of the lobes; {reason}.")
    used = samples.fewer(settings.samples, settings.seed)
    count = int(used.known.sum())
    if count < model.size:
        lobes = "one lobe" if settings.lobes == 1 else f"{settings.lobes} lobes"
        raise FittingError(
            f"{count} values cannot determine the {model.size} parameters of {lobes}; measure more directions"
            + (", or fit fewer lobes." if settings.lobes > 1 else ".")
        )
    whole = FitProblem.of(model, used)
    few = FitProblem.of(model, used.fewer(COARSE_SAMPLES, settings.seed + 1))
    ends = _search_from_starts(few, settings, kept, progress)
    ends.sort(key=few.energy)
    steps = _Steps(progress, 0.6)
    answers = [search(whole, x, settings.loss, FINE, _FINE_STEPS, steps.tick) for x in _apart(ends, few)]
    best = min(answers, key=lambda x: _objective(whole, x, settings))
    best = _other_reflectances(whole, few, best, settings, steps, answers)
    best, dropped = _fewer_lobes(whole, few, best, settings, steps)
    return _with_uncertainty(whole, best, dropped, settings, answers, steps)


def _with_uncertainty(
    whole: FitProblem,
    best: Vector,
    dropped: tuple[int, ...],
    settings: Settings,
    minima: list[Vector],
    steps: _Steps,
) -> CookTorranceFit:
    """Return the fit with its profiles, those ``minima`` that the noise leaves possible, and errors over both."""
    model = whole.model
    profiles: tuple[Profile, ...] = ()
    for left in reversed(range(_ROUNDS)):
        best = model.sorted(best)
        cost = final_cost(whole, best, settings.loss)
        covariance = covariance_of(whole, best, cost)
        noise = Noise(whole, best, cost)
        if whole.energy(best) <= _ROUNDING:
            break
        profiles, better = profiles_of(noise, covariance, settings.loss, steps.tick)
        if better is None or not left:
            break
        minima, best = [*minima, best], better
    alternatives = alternatives_of(noise, minima) if profiles else ()
    errors = standard_errors(model, best, covariance)
    blurred = blurred_once_more(whole, best, settings.loss, steps.tick)
    errors = widened(errors, model, best, profiles, alternatives, blurred)
    return CookTorranceFit(model, best, settings, errors, whole, dropped, profiles, alternatives)


def fit_key(samples: LobeSamples, settings: Settings) -> str:
    """Return a name of the fit of these samples with these settings, for what is kept of it."""
    digest = hashlib.sha256(repr((VERSION, settings)).encode())
    for array in (samples.wi, samples.wo, samples.logs, samples.known, samples.weights):
        digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()


def _search_from_starts(
    few: FitProblem, settings: Settings, kept: StartsFile | None, progress: Progress | None
) -> list[Vector]:
    report(progress, 0.0, "starts")
    key = fit_key(few.samples, settings) if kept is not None else ""
    ends: dict[int, list[float]] = {}
    if kept is not None:
        found = kept.load(key)
        low, high = few.model.bounds()
        for number, values in found.items():
            x = np.array(values)
            if 0 <= number < settings.starts and x.shape == low.shape and np.all((x >= low) & (x <= high)):
                ends[number] = values
    if len(ends) < settings.starts:
        places = starts(few.model, few.samples, few.terms, settings.starts, settings.seed)
        for number, x in enumerate(places):
            if number in ends:
                continue
            text = f"start {number + 1} of {settings.starts}"
            tick = partial(report, progress, 0.6 * number / settings.starts, text)
            tick()
            ends[number] = search(few, x, settings.loss, COARSE, _STEPS, tick).tolist()
            if kept is not None:
                kept.save(key, ends)
    return [np.array(ends[number]) for number in sorted(ends)]


class _Steps:
    """Progress of work of unknown length: each step takes a fixed fraction of the remainder."""

    def __init__(self, progress: Progress | None, start: float) -> None:
        self._progress, self._left = progress, 0.97 - start

    def tick(self) -> None:
        self._left *= 0.995
        report(self._progress, 0.97 - self._left, "refining")


def _apart(ends: list[Vector], few: FitProblem) -> Iterator[Vector]:
    """Return the best end points without duplicates."""
    chosen: list[float] = []
    for x in ends:
        energy = few.energy(x)
        if all(abs(energy - other) > _GAIN * other for other in chosen):
            chosen.append(energy)
            yield x
        if len(chosen) == _REFINED:
            return


def _objective(problem: FitProblem, x: Vector, settings: Settings) -> float:
    """Return the objective for comparison: the energy of equation 2, or the mean square."""
    if settings.loss == "l2":
        return float(np.sqrt(2.0 * problem.objective(x, final_cost(problem, x, "l2"))))
    return problem.energy(x)


def _other_reflectances(
    whole: FitProblem,
    few: FitProblem,
    best: Vector,
    settings: Settings,
    steps: _Steps,
    minima: list[Vector],
) -> Vector:
    """Set each lobe to other reflectances in turn, with its height kept, while that leads to something better.

    What else was searched to its end is added to ``minima``.
    """
    model = whole.model
    reflected = [model.m_at(lobe) + 1 for lobe in range(model.lobes)]
    value = _objective(whole, best, settings)
    for _ in range(_ROUNDS):
        trials: list[tuple[float, Vector]] = []
        for lobe in range(model.lobes - (1 if model.coat else 0)):
            if model.dead(best, lobe):
                continue
            place = model.m_at(lobe) + 1
            for r in _JUMPS:
                if abs(inverse_index(r) - best[place]) < 0.05:
                    continue
                x = best.copy()
                x[place] = inverse_index(r)
                x = search(few, x, settings.loss, (0.1,), _JUMP_STEPS, steps.tick)
                # Most fall back to where they came from, or to where another fell.
                others = (best, *(y for _, y in trials))
                if all(np.abs(x[reflected] - y[reflected]).max() > 0.03 for y in others):
                    trials.append((_objective(few, x, settings), x))
        if not trials or value <= _ROUNDING:
            break
        # The valleys differ by less than few samples can resolve: those that may be lower are searched with all.
        trials.sort(key=lambda trial: trial[0])
        limit = max(_WORTH_A_LOOK * min(trials[0][0], _objective(few, best, settings)), _ROUNDING)
        near = [x for reached, x in trials[:_LOOKED_AT] if reached <= limit]
        answers = [search(whole, x, settings.loss, FINE, _FINE_STEPS, steps.tick) for x in near]
        minima += answers
        if not answers:
            break
        found = min(answers, key=lambda x: _objective(whole, x, settings))
        reached = _objective(whole, found, settings)
        if not reached < value * (1.0 - 1e-5):
            break
        best, value = found, reached
    return best


def _fewer_lobes(
    whole: FitProblem, few: FitProblem, best: Vector, settings: Settings, steps: _Steps
) -> tuple[Vector, tuple[int, ...]]:
    """Take away lobes that the samples do not ask for; return which (numbers after sorting are the first ones)."""
    model = whole.model
    value = _objective(whole, best, settings)
    # Schwarz: 2n log(E'/E) against the number of parameters times log n.
    chance = 5.0 * math.log(max(whole.counted, 2.0)) / (2.0 * whole.counted)
    for _ in range(model.lobes):
        trials = []
        for lobe in range(model.lobes - (1 if model.coat else 0)):
            if model.dead(best, lobe):
                continue
            x = search(few, model.without(best, lobe), settings.loss, (0.1,), _JUMP_STEPS, steps.tick)
            # Most lobes are missed at the first sight.
            if _objective(few, x, settings) > max(_WORTH_A_LOOK * _objective(few, best, settings), 1e-4):
                continue
            x = search(whole, x, settings.loss, FINE, _FINE_STEPS, steps.tick)
            trials.append((_objective(whole, x, settings), x))
        if not trials:
            break
        reached, x = min(trials, key=lambda trial: trial[0])
        if reached > max(value * math.exp(chance), _ROUNDING):
            break
        best, value = x, reached
    best = model.sorted(best)
    return best, tuple(lobe for lobe in range(model.lobes) if model.dead(best, lobe))


class StartsFile:
    """Keeps starts in ``path``; the file is made with the first start and may be deleted at any time."""

    def __init__(self, path: Path) -> None:
        self._path = path

    def load(self, key: str) -> Mapping[int, list[float]]:
        """Return the ends that the file keeps for this key; none where there is no file, or it is another fit's.

        Raises
        ------
        FileError
            A file of this name holds something other than starts; it is left unchanged.
        """
        try:
            if not exists(self._path) and not self._path.is_symlink():
                return {}
            value = json.loads(read_bytes(self._path, _LARGEST))
        except (ValueError, RecursionError) as error:  # of the size, the encoding or the form
            raise FileError(self._path, "is no file of kept starts; name another one") from error
        if not isinstance(value, dict) or value.get("format") != STARTS_FORMAT:
            raise FileError(self._path, "is no file of kept starts; name another one", "format")
        if value.get("version") != STARTS_VERSION or value.get("key") != key:
            return {}
        return _ends(value.get("ends"))

    def save(self, key: str, ends: Mapping[int, list[float]]) -> None:
        """Write the ends of the fit of this key; raise :class:`FileError` where that fails."""
        value = {
            "format": STARTS_FORMAT,
            "version": STARTS_VERSION,
            "key": key,
            "ends": {str(number): list(x) for number, x in ends.items()},
        }
        write_atomically(self._path, encode(value))

    def remove(self) -> None:
        """Delete the file, which is of no use once the fit is done."""
        try:
            self._path.unlink(missing_ok=True)
        except OSError as error:
            raise FileError(self._path, f"cannot be removed: {error.strerror or error}") from error


def _ends(value: object) -> dict[int, list[float]]:
    """Those of the entries that are what was written; a start that is not is searched again."""
    found: dict[int, list[float]] = {}
    if not isinstance(value, dict):
        return found
    for name, numbers in value.items():
        is_start = str(name).isdecimal() and isinstance(numbers, list)
        if is_start and all(type(x) in (int, float) and abs(x) < 1e300 for x in numbers):
            found[int(name)] = [float(x) for x in numbers]
    return found
