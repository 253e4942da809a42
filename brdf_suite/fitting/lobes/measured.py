"""Lobe weights of a reflectance without separate layers, such as measured data.

KD, KDD and KG of a channel are fitted together to ``f_r·(N·L)``::

    min Σ_j w_j·|KD·c_j + Σ_i (KDD_i·c_j + KG_i)·(R_j·V_j)^E_i - b_j|,    weights ≥ 0

KDD and KG differ by c = N·L alone, so samples from at least three incidences are needed; with fewer, KG is
left out and the split is undetermined. The weights hold at every angle as they are: no Fresnel factor comes on top,
because the data hold it already (``ior`` 1).

An error counts less where the target is large, by a power of it, because the eye judges ratios while the peak of
a mirror lobe is 10⁵ times the flank; the weight of a row is w·(b/b_median + :data:`FLOOR`)^-:data:`POWER`.

Where samples leave several answers, the one that reflects least light is taken: a lobe that only one sample sees
claims no more than that sample. A lobe that no sample sees (none within its half-width) gets no weight.
"""

from __future__ import annotations

import contextlib
import time
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.basis import LobeBasis, default_basis
from brdf_suite.fitting.lobes.checks import check_limit, check_targets
from brdf_suite.fitting.lobes.measured_samples import (
    UndividedRows,
    reflectance_rows,
    scattered_rows,
    used_samples,
)
from brdf_suite.fitting.lobes.program import build_program
from brdf_suite.fitting.lobes.time_limit import LimitedSolver
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.geometry.directions import aspecular_angle, mirror
from brdf_suite.progress import Progress, report
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

#: Incidences from which on gloss and directional-diffuse lobes can be separated.
FEWEST_INCIDENCES = 3
#: Samples below which only the diffuse part is fitted.
FEWEST_SAMPLES = 3
POWER, FLOOR = 0.67, 0.1
#: A lobe is seen where some sample has at least this value of it.
SEEN = 0.3
#: What a unit of reflected light costs, against a unit of error: it decides between equal fits only.
LEAST_LIGHT = 1e-4
#: No frame waits for such a fit.
TIME_LIMIT_S = 30.0
#: Residual, as a fraction of the target, from which a notice is given.
_POOR = 0.3


@dataclass(frozen=True, eq=False)
class UndividedFit:
    """Weights of undivided data, with errors and notices.

    ``relative_error`` ``(3,)``: Σ w·|M x - b| over Σ w·b per channel, of the rows that were fitted (0 where that is
    0). ``split_determined``: gloss and directional-diffuse parts were separated. ``incidences_rad``: the different
    polar angles of the light. ``samples``: direction pairs. ``seconds``: samples in hand to weights.
    """

    weights: LobeWeights
    relative_error: Floats
    split_determined: bool
    incidences_rad: tuple[float, ...]
    samples: int
    rows: int
    seconds: float
    notices: tuple[str, ...]

    @property
    def time_limited(self) -> bool:
        """True where the time limit came before the optimum."""
        return self.weights.time_limited


def fit_undivided(
    reflectance: Reflectance,
    basis: LobeBasis | None = None,
    *,
    rows: UndividedRows | None = None,
    time_limit_s: float = TIME_LIMIT_S,
    progress: Progress | None = None,
) -> UndividedFit:
    """Fit lobes to any reflectance; scattered samples where they were measured, all else where it is sampled best.

    ``rows`` takes other samples than the default ones. ``progress`` receives the share of the limit that is used up.

    Raises
    ------
    FittingError
        A value is negative, not finite or beyond any reflectance, or there is no sample above the horizon; the
        message says where.
    Cancelled
        The progress callback asked for it; what is in work ends within a tenth of a second or so.
    """
    if isinstance(reflectance, ScatteredSamples) and rows is None:
        rows, values = scattered_rows(reflectance), scattered_values(reflectance)
    else:
        rows = rows or reflectance_rows(reflectance)
        values = reflectance.eval(rows.wi, rows.wo)
    return fit_rows(rows, values, basis, time_limit_s=time_limit_s, progress=progress)


def scattered_values(samples: ScatteredSamples) -> Floats:
    """Return f_r (n, 3) of the samples that :func:`scattered_rows` takes, in its order."""
    return samples.values[used_samples(samples)]


def fit_rows(
    rows: UndividedRows,
    values: Floats,
    basis: LobeBasis | None = None,
    *,
    time_limit_s: float = TIME_LIMIT_S,
    progress: Progress | None = None,
) -> UndividedFit:
    """Fit lobes to f_r ``values`` (p, 3), 1/sr, at the pairs of ``rows``; errors as :func:`fit_undivided`."""
    check_limit(time_limit_s)
    if rows.weights.size == 0:
        raise FittingError("There is nothing to fit: no sample has light and view above the horizon.")

    def where(place: tuple[int, ...]) -> str:
        gamma = np.degrees(aspecular_angle(rows.wi[place], rows.wo[place]))
        light = np.degrees(np.arccos(min(rows.wi[place][2], 1.0)))
        from_mirror = f"the view {float(gamma):.4g}° from its mirror direction"
        return f"with the light at {light:.4g}° from the normal and {from_mirror}"

    values = check_targets("The reflectance", values, rows.wi.shape, where)
    exponents = (basis or default_basis()).array()
    start = time.perf_counter()

    def watch() -> None:
        report(progress, (time.perf_counter() - start) / time_limit_s, "fitting")

    watch()
    count = exponents.size
    split = len(rows.incidences_rad) >= FEWEST_INCIDENCES
    target = rows.gather(values * rows.wi[:, 2:3])
    columns, unseen = _columns(rows, exponents, split)
    weights = rows.weights * _importance(target)
    # Each column's approximate response to uniform light is its solid angle, π for the diffuse one. Rows that cost a
    # little for light: below everything that is measured, above the solver's tolerance.
    solid = 2.0 * np.pi / (exponents + 1.0)
    light = np.concatenate([[np.pi], solid, solid] if split else [[np.pi], solid])
    matrix = np.concatenate((columns, np.diag(light)))
    typical = float(weights.sum() / (2.0 * np.pi))
    row_weights = np.concatenate((weights, np.full(light.size, LEAST_LIGHT * typical)))
    program = build_program(matrix, row_weights)
    goal = np.concatenate((target, np.zeros((light.size, 3))))
    goal *= program.row_weights[:, None]
    with contextlib.closing(LimitedSolver([program], inline=True)) as solver:
        answer = solver.solve([goal], start + time_limit_s, finish=False, watch=watch)
    found = answer.solutions[0] * program.column_scale[:, None]
    kg = found[1 + count :] if split else np.zeros((count, 3))
    lobes = LobeWeights(
        exponents=exponents,
        kd=found[0],
        kdd=found[1 : 1 + count],
        kg=kg,
        theta_fit_rad=float(np.median(rows.incidences_rad)),
        ior=1.0,
        time_limited=not answer.optimal,
    )
    error = weights[:, None] * np.abs(columns @ found - target)
    whole = (weights[:, None] * target).sum(axis=0)
    relative = np.divide(error.sum(axis=0), whole, out=np.zeros(3), where=whole > 0.0)
    notices = _notices(rows, exponents, unseen, error, relative, black=not target.any(), split=split)
    return UndividedFit(
        weights=lobes,
        relative_error=relative,
        split_determined=split,
        incidences_rad=rows.incidences_rad,
        samples=len(rows.wi),
        rows=rows.weights.size,
        seconds=time.perf_counter() - start,
        notices=(*rows.notices, *notices),
    )


def _columns(rows: UndividedRows, exponents: Floats, split: bool) -> tuple[Floats, NDArray[np.bool_]]:
    """Return the system (n, 1 + m or 1 + 2m), and the lobes (m,) without samples."""
    light, view = rows.wi, rows.wo
    cosine = light[:, 2:3]
    # R·V = 1 - |R - V|²/2, exact for sharp lobes, where 1 - R·V is near the rounding of R·V itself.
    apart = mirror(light) - view
    off = 0.5 * np.einsum("pi,pi->p", apart, apart)
    with_lobe = off < 1.0
    logarithm = np.log1p(-np.where(with_lobe, off, 0.0))
    lobes = np.where(with_lobe[:, None], np.exp(logarithm[:, None] * exponents), 0.0)
    unseen = lobes.max(axis=0) < SEEN
    if len(rows.weights) < FEWEST_SAMPLES:
        unseen[:] = True
    lobes[:, unseen] = 0.0
    parts = [cosine, cosine * lobes]
    if split:
        parts.append(lobes)
    return rows.gather(np.concatenate(parts, axis=1)), unseen


def _importance(target: Floats) -> Floats:
    """Return the weight (n,) of a unit of error from the magnitude of the row's target."""
    size = target.mean(axis=1)
    positive = size[size > 0.0]
    if positive.size == 0:
        return np.ones(len(size))
    return np.asarray((size / np.median(positive) + FLOOR) ** -POWER)


def _notices(
    rows: UndividedRows,
    exponents: Floats,
    unseen: NDArray[np.bool_],
    error: Floats,
    relative: Floats,
    *,
    black: bool,
    split: bool,
) -> tuple[str, ...]:
    """Return notices about the fit; ``error`` (n, 3) is each row's contribution to the objective."""
    if black:
        return ("It is black wherever it was sampled; all weights are zero.",)
    notices = []
    angles = ", ".join(f"{np.degrees(angle):.0f}" for angle in rows.incidences_rad)
    if len(rows.weights) < FEWEST_SAMPLES:
        notices.append(f"There are fewer than {FEWEST_SAMPLES} samples: the diffuse part alone is fitted.")
    elif unseen.all():
        notices.append("No sample lies near the mirror direction: the diffuse part alone is fitted.")
    elif unseen.any():
        notices.append(
            f"No sample lies near enough to the mirror direction for lobes sharper than exponent "
            f"{exponents[~unseen].max():g}: what gloss there is beyond is not in the fit."
        )
    if not split:
        notices.append(
            f"The light stood at {angles}° only. Gloss and directional-diffuse parts cannot be separated with fewer "
            f"than {FEWEST_INCIDENCES} incidences: all lobes are taken as directional-diffuse, and the split is "
            "undetermined."
        )
    if relative.max() > _POOR:
        worst = int(np.argmax(rows.share * error.sum(axis=1)[rows.row]))
        light = np.degrees(np.arccos(min(rows.wi[worst, 2], 1.0)))
        gamma = np.degrees(aspecular_angle(rows.wi[worst], rows.wo[worst]))
        notices.append(
            f"Cosine lobes about the mirror direction miss {100.0 * relative.max():.0f} % of it, most of all with the "
            f"light at {light:.0f}° and the view {float(gamma):.0f}° from its mirror direction."
        )
    return tuple(notices)
