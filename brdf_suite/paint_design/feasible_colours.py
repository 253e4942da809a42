"""The colours nearest to what is asked that a sum of lobes with non-negative weights can give at all.

At n geometries the lobes give, per channel of the working space, ρ = s + M x with the coat's share s, the columns
M = π (1, (R·V)^E_1, …) of KD and KDD, and x ≥ 0: a cone, the same for every channel, whose top is s. Wanted is the
point of that cone with the least Σ ΔE00², which the three channels share.

By Newton's steps: about the present point L*a*b* is taken as linear in x, and ΔE00² as its true gradient with the
curvature that it has about the asked colour; that makes a least-squares problem with x ≥ 0, solved exactly (Lawson and
Hanson 1974). A step is shortened until the true sum falls.

Far from the asked colours ΔE00 has jumps (opposite hues) and several minima, where these steps end early. So random
weights around their end are tried as well, in six sizes; where they find a lower sum, the steps start again from there.
The random numbers have a fixed seed: equal input gives equal colours.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import lab_to_working, working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats

_MOST_STEPS = 60
_LENGTHS = tuple(0.5**k for k in range(9))
_SETTLED = 1e-6
# The random search: relative sizes of its changes, weights tried at a time, and the gain that counts as one.
_SEARCH_SIZES = (0.3, 0.1, 0.03, 0.01, 0.003, 0.001)
_SEARCH_COUNT = 200
_SEARCH_GAIN = 1e-3
_MOST_SEARCHES = 30
# Reflectance factor: a weight that gives less than this changes as much as one that gives this.
_SEARCH_LEAST_RHO = 0.02
# L*a*b*: ΔE00 has a kink at 0 difference, and steps of this size see the quadratic about it.
_PROBE_LAB = 0.25
_NEAR_LAB = 1e-4
# Reflectance factor: the derivative of L*a*b* is taken over this share of the value.
_PROBE_RHO, _LEAST_RHO = 1e-3, 1e-5


def nearest_in_cone(columns: Floats, share: Floats, asked: npt.ArrayLike) -> Floats:
    """Return L*a*b* (n, 3), the point of the cone nearest to ``asked`` (n, 3).

    ``columns`` (n, m) are ρ of each lobe at weight 1, ``share`` (n,) ρ of the coat.
    """
    asked = np.asarray(asked, np.float64)
    metric = _metric(asked)
    wanted = lab_to_working(asked)
    start = 1.0 / np.maximum(wanted, 0.02)
    x = np.stack(
        [_nnls(columns * start[:, c, None], (wanted[:, c] - share) * start[:, c]) for c in range(3)], axis=1
    )
    x, value = _descend(columns, share, x, asked, metric)
    rng = np.random.default_rng(0)
    for _ in range(_MOST_SEARCHES):
        near, near_value = _search_around(columns, share, x, value, asked, rng)
        if near_value >= value:
            break
        x, value = _descend(columns, share, near, asked, metric)
    return np.asarray(working_to_lab(share[:, None] + columns @ x))


def _descend(
    columns: Floats, share: Floats, x: Floats, asked: Floats, metric: Floats
) -> tuple[Floats, float]:
    """Return the weights (m, 3) where Newton's steps from ``x`` end, and their Σ ΔE00²."""
    value = float(_value(columns, share, x, asked))
    for _ in range(_MOST_STEPS):
        candidate = _newton(columns, share, x, asked, metric)
        for length in _LENGTHS:
            trial = x + length * (candidate - x)
            found = float(_value(columns, share, trial, asked))
            if found < value:
                break
        else:
            break
        gained, x, value = value - found, trial, found
        if gained <= _SETTLED * max(value, _SETTLED):
            break
    return x, value


def _search_around(
    columns: Floats, share: Floats, x: Floats, value: float, asked: Floats, rng: np.random.Generator
) -> tuple[Floats, float]:
    """Return the best weights (m, 3) found by random steps from ``x``, whose Σ ΔE00² is ``value``, and theirs."""
    least = _SEARCH_LEAST_RHO / np.maximum(columns.max(axis=0), _LEAST_RHO)[:, None]
    for size in _SEARCH_SIZES:
        for _ in range(_MOST_STEPS):
            change = size * rng.standard_normal((_SEARCH_COUNT, *x.shape)) * np.maximum(x, least)
            near = np.maximum(x + change, 0.0)
            values = _value(columns, share, near, asked)
            best = int(values.argmin())
            if values[best] >= (1.0 - _SEARCH_GAIN) * value:
                break
            x, value = near[best], float(values[best])
    return x, value


def _value(columns: Floats, share: Floats, x: Floats, asked: Floats) -> Floats:
    """Return Σ ΔE00² (...) over the readings for weights ``x`` (..., m, 3)."""
    reached = working_to_lab(share[:, None] + columns @ x)
    return np.asarray((delta_e_2000(asked, reached) ** 2).sum(axis=-1))


def _newton(columns: Floats, share: Floats, x: Floats, asked: Floats, metric: Floats) -> Floats:
    """The x ≥ 0 (m, 3) of least squares with L*a*b* taken as linear about the present one."""
    rho = share[:, None] + columns @ x
    lab = working_to_lab(rho)
    slope = _slope(rho)
    gap = lab - asked
    length = np.linalg.norm(np.einsum("nij,nj->ni", metric, gap), axis=-1)
    true = delta_e_2000(asked, lab)
    # A far colour is not as far as the form about the asked one says: the form is scaled to what is true.
    scale = np.where(length > 1e-9, true / np.maximum(length, 1e-9), 1.0)
    form = np.clip(scale, 0.05, 20.0)[:, None, None] * metric
    # Half the true gradient of ΔE00², so that where no step is left there is a minimum; the form is its curvature.
    push = np.linalg.solve(form, (true[:, None] * _gradient(asked, lab))[..., None])[..., 0]
    count, lobes = columns.shape
    # The residual of colour i at reading n, by the weight of lobe k in channel c.
    system = np.einsum("nic,nk->nikc", form @ slope, columns).reshape(3 * count, 3 * lobes)
    return _nnls(system, system @ x.ravel() - push.ravel()).reshape(lobes, 3)


def _gradient(asked: Floats, lab: Floats) -> Floats:
    """dΔE00/dL*a*b* (n, 3) at colours other than the asked ones; 0 at those."""
    steps = _NEAR_LAB * np.eye(3)
    slopes = [delta_e_2000(asked, lab + step) - delta_e_2000(asked, lab - step) for step in steps]
    return np.asarray(np.stack(slopes, axis=-1) / (2.0 * _NEAR_LAB))


def _slope(rho: Floats) -> Floats:
    """dL*a*b*/dρ (n, 3, 3) by differences."""
    step = _PROBE_RHO * np.maximum(rho, _LEAST_RHO)
    slope = np.empty((len(rho), 3, 3))
    for channel in range(3):
        moved = np.zeros_like(rho)
        moved[:, channel] = step[:, channel]
        slope[:, :, channel] = (working_to_lab(rho + moved) - working_to_lab(rho - moved)) / (
            2.0 * step[:, channel, None]
        )
    return slope


def _metric(asked: Floats) -> Floats:
    """The symmetric root (n, 3, 3) of the form that ΔE00² is near each colour."""
    half = np.empty((len(asked), 3, 3))
    steps = _PROBE_LAB * np.eye(3)
    for i in range(3):
        for j in range(i + 1):
            # The polar form of a quadratic one: 4 q(a, b) = q(a + b) - q(a - b).
            both = delta_e_2000(asked, asked + steps[i] + steps[j]) ** 2
            apart = delta_e_2000(asked, asked + steps[i] - steps[j]) ** 2 if i != j else 0.0
            half[:, i, j] = half[:, j, i] = (both - apart) / (4.0 * _PROBE_LAB**2)
    values, vectors = np.linalg.eigh(half)
    root = np.sqrt(np.maximum(values, 1e-4))
    return np.asarray(np.einsum("nij,nj,nkj->nik", vectors, root, vectors))


def _nnls(system: Floats, target: Floats) -> Floats:
    from scipy.optimize import nnls  # 0.2 s to import, and nothing on the edit path asks for it

    # Lobes are of very different sizes and much alike; columns of one length are solved better.
    length = np.linalg.norm(system, axis=0)
    length = np.where(length > 0.0, length, 1.0)
    return np.asarray(nnls(system / length, target)[0] / length)
