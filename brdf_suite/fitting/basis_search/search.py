"""Basis search: lobes added one at a time, each count from several starts (Westlund and Meyer, section 3.2)."""

from __future__ import annotations

import itertools
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from brdf_suite.errors import FittingError
from brdf_suite.fitting.basis_search.database import Database
from brdf_suite.fitting.basis_search.error import BasisError, equation_4
from brdf_suite.fitting.basis_search.optimize import LARGEST_EXPONENT, LOG_ENDS, Optimum
from brdf_suite.fitting.basis_search.workers import Exponents, Workers
from brdf_suite.progress import Progress, report

#: More lobes than this no renderer of the suite takes.
MOST_LOBES = 12
#: Answers of the last count from which a lobe is added, and the places in a gap where it is tried.
PARENTS = 2
PLACES = (0.25, 0.5, 0.75)
#: First exponents of the log-spaced starts; they end at the largest.
LOG_SPACED_FROM = (1.0, 3.0)
#: Starts of one lobe, before the best are chosen.
SINGLE_STARTS = 24


@dataclass(frozen=True)
class CountResult:
    """The best basis of one count: errors per paint ``(paints,)``, of base and of coat, and what it took.

    ``others`` are the optima of the other starts, best first: the next count may grow from them too.
    """

    exponents: Exponents
    errors: tuple[float, ...]
    base_errors: tuple[float, ...]
    coat_errors: tuple[float, ...]
    evaluations: int
    seconds: float
    others: tuple[tuple[Exponents, float], ...]

    @property
    def count(self) -> int:
        """Number of lobes."""
        return len(self.exponents)

    @property
    def value(self) -> float:
        """Equation 4: maximum plus mean error."""
        return equation_4(np.array(self.errors))


def search(
    database: Database,
    largest: int,
    *,
    starts: int,
    workers: int,
    done: Sequence[CountResult] = (),
    progress: Progress | None = None,
    found: Callable[[CountResult], None] | None = None,
) -> list[CountResult]:
    """Return the best basis of each count from 1 to ``largest``; the same whatever ``workers`` is.

    Parameters
    ----------
    database
        The paints; at least as many as lobes.
    starts
        Starts for each count, at least 2.
    workers
        Processes to work in.
    done
        Results of an earlier run for the first counts, from which it goes on.
    found
        Called with each new result, so that it can be kept.

    Raises
    ------
    FittingError
        Counts or starts out of range, too few paints, or a worker that ended early.
    Cancelled
        The progress callback asked for it.
    """
    if not 1 <= largest <= MOST_LOBES:
        raise FittingError(f"The search takes from 1 to {MOST_LOBES} lobes, not {largest}.")
    if starts < 2 or workers < 1:
        raise FittingError(f"The search needs at least 2 starts and 1 worker, not {starts} and {workers}.")
    if len(database.paints) < largest:
        raise FittingError(
            f"The database holds {len(database.paints)} paints; for {largest} lobes it needs as many or more."
        )
    results = list(done[:largest])
    if len(results) == largest:
        return results
    errors = BasisError(database)
    whole = sum(count**2 for count in range(1, largest + 1))
    team = Workers(database, workers)
    try:
        for count in range(len(results) + 1, largest + 1):
            begun = time.perf_counter()
            before = sum(k**2 for k in range(1, count))
            what = f"{count} lobe{'s' if count > 1 else ''}"
            report(progress, before / whole, what)
            chosen = _starts(errors, results[-1] if results else None, count, starts)

            def report_finished(
                finished: int, before: int = before, count: int = count, what: str = what
            ) -> None:
                report(progress, (before + count**2 * finished / starts) / whole, what)

            optima = team.run(chosen, report_finished)
            result = _result(errors, optima, time.perf_counter() - begun)
            results.append(result)
            if found is not None:
                found(result)
    finally:
        team.close()
    report(progress, 1.0, "done")
    return results


def _starts(errors: BasisError, last: CountResult | None, count: int, starts: int) -> list[Exponents]:
    """Return the starts of a count: a lobe more in the last answers where it helps most, and log-spaced sets."""
    if last is None:
        candidates: list[Exponents] = [(float(e),) for e in np.exp(np.linspace(*LOG_ENDS, SINGLE_STARTS))]
        spaced: list[Exponents] = []
    else:
        parents = [last.exponents, *(exponents for exponents, _ in last.others[: PARENTS - 1])]
        candidates = [grown for parent in parents for grown in _grown(parent)]
        spaced = [tuple(np.geomspace(low, LARGEST_EXPONENT, count).tolist()) for low in LOG_SPACED_FROM]
        spaced = spaced[: starts - 1]
    values = [equation_4(errors(candidate)) for candidate in candidates]
    best = sorted(range(len(candidates)), key=lambda k: (values[k], k))[: starts - len(spaced)]
    return [candidates[k] for k in best] + spaced


def _grown(parent: Exponents) -> list[Exponents]:
    """Return ``parent`` with one lobe more, in each gap between its lobes and their ends."""
    logs = [LOG_ENDS[0], *np.log(parent).tolist(), LOG_ENDS[1]]
    added = [
        float(np.exp(low + place * (high - low)))
        for low, high in itertools.pairwise(logs)
        if high - low > 0.05
        for place in PLACES
    ]
    return [tuple(sorted((*parent, value))) for value in added]


def _result(errors: BasisError, optima: Sequence[Optimum], seconds: float) -> CountResult:
    order = sorted(range(len(optima)), key=lambda k: (optima[k].value, k))
    best = optima[order[0]]
    base, coat = errors.layers(best.exponents)
    return CountResult(
        best.exponents,
        tuple(errors(best.exponents).tolist()),
        tuple(base.tolist()),
        tuple(coat.tolist()),
        sum(optimum.evaluations for optimum in optima),
        seconds,
        tuple((optima[k].exponents, optima[k].value) for k in order[1:]),
    )
