"""Start values of the search: slopes of the lobes read off the logarithm, then pairs, triples … from a list.

For one lobe of Beckmann's facets the profile P = (f_r - kd/π) cosθi cosθo cos⁴θh / G falls as exp(-tan²θh/m²): against
tan²θh its logarithm is a line of slope -1/m². For several it is a curve, steep where the sharp lobe rules and
flatter outwards, so the local slopes give a range of m from the sharpest lobe to the widest. The first start takes its
slopes from there. The others take sets of slopes from a list, the best by least squares of relative errors
with weights ≥ 0 first, and draw the Fresnel reflectances, over which the energy has more than one valley.
"""

from __future__ import annotations

import itertools
import math

import numpy as np
import numpy.typing as npt
from scipy.optimize import nnls

from brdf_suite.arrays import Floats
from brdf_suite.fitting.cook_torrance.model import (
    LobeModel,
    Terms,
    Vector,
    fresnel,
    inverse_index,
    reflectance_from_inverse_index,
)
from brdf_suite.fitting.cook_torrance.samples import LobeSamples
from brdf_suite.fitting.cook_torrance.solve import products

SLOPES = np.geomspace(0.006, 0.9, 16)
"""The list of m."""
REFLECTANCES = (0.04, 0.15, 0.5, 0.9)
_MOST_SETS = 600
_BINS = 40
_COAT_R = 0.04
# Two sets of slopes that are alike in all but one step of the list lead to the same place.
_APART = 2


def starts(model: LobeModel, samples: LobeSamples, terms: Terms, count: int, seed: int) -> list[Vector]:
    """Return ``count`` vectors (p,) from which to search; the same for the same arguments."""
    rng = np.random.default_rng(seed)
    found = [_weighted(model, samples, terms, estimate_slopes(samples, terms, model.lobes), _middle(model))]
    if count == 1:
        return found
    sets = _best_sets(model, samples, terms, (count + 1) // 2, rng)
    for number in range(count - 1):
        chosen = SLOPES[list(sets[number % len(sets)])][::-1]
        jitter = np.exp(rng.normal(0.0, 0.1, model.lobes)) if number >= len(sets) else np.ones(model.lobes)
        reflected = rng.choice(REFLECTANCES, model.lobes) if number else _middle(model)
        if model.coat:
            reflected[-1] = _COAT_R
        found.append(_weighted(model, samples, terms, np.minimum(chosen * jitter, 1.0), reflected))
    return found


def estimate_slopes(samples: LobeSamples, terms: Terms, lobes: int) -> Floats:
    """Return m (lobes,), falling, from the slopes of the profile's logarithm against tan²θh."""
    grey = np.maximum(np.exp(_grey(samples)) - samples.added, 1e-30) * math.pi
    order = np.argsort(terms.tan2_h)
    bins = np.array_split(order, min(_BINS, max(2, len(order) // 4)))
    matt = float(np.percentile(grey, 5.0))
    profile = np.maximum(grey - matt, 1e-3 * grey) * np.exp(-terms.log_grooves)
    x = np.array([np.median(terms.tan2_h[at]) for at in bins])
    y = np.log([np.median(profile[at]) for at in bins])
    wide = max(1, len(bins) // 10)
    step = x[wide:] - x[:-wide]
    fall = -(y[wide:] - y[:-wide]) / np.maximum(step, 1e-12)
    local = 1.0 / np.sqrt(fall[(fall > 1.0) & (step > 0.0)])
    if local.size < 2:
        return np.geomspace(0.4, 0.02, lobes) if lobes > 1 else np.array([0.2])
    low, high = np.percentile(local, [5.0, 95.0]).tolist()
    low = max(low, 2e-3)
    return np.geomspace(max(high, 2.0 * low), low, lobes) if lobes > 1 else np.array([low])


def _grey(samples: LobeSamples) -> Floats:
    """Return the mean logarithm (n,) over the known channels."""
    counts = np.maximum(samples.known.sum(axis=0), 1)
    return np.asarray(samples.logs.sum(axis=0) / counts)


def _middle(model: LobeModel) -> Floats:
    reflected = np.full(model.lobes, 0.4)
    if model.coat:
        reflected[-1] = _COAT_R
    return reflected


def _columns(model: LobeModel, terms: Terms, slopes: Floats, reflected: Floats) -> Floats:
    """Return (n, 1 + k): f_r of the diffuse part of kd = 1 and of lobes of a = 1."""
    rows = [np.full(len(terms.cos_d), 1.0 / math.pi)]
    for m, r in zip(slopes.tolist(), reflected.tolist(), strict=True):
        share = fresnel(terms.cos_d, inverse_index(r))[0] / r
        rows.append(share * np.exp(model.shape(terms, math.log(m))[0]) / math.pi)
    return np.stack(rows, axis=-1)


def _best_sets(
    model: LobeModel, samples: LobeSamples, terms: Terms, count: int, rng: np.random.Generator
) -> list[tuple[int, ...]]:
    """Return places in the list of slopes, rising, of the ``count`` sets that come nearest and differ."""
    columns = _columns(model, terms, SLOPES, np.full(len(SLOPES), 0.4))
    scale = np.exp(-_grey(samples)) * np.sqrt(samples.weights)
    relative = columns * scale[:, None]
    whole = np.vstack((relative.T, np.sqrt(samples.weights) - samples.added * scale))
    # A square root of the products has the same lengths as the n rows, for all the sets.
    squares, vectors = np.linalg.eigh(products(whole, np.ones(whole.shape[1]), whole[0])[0])
    root: Floats = np.sqrt(np.maximum(squares, 0.0))[:, None] * vectors.T
    wanted = root[:, -1]
    sets = list(itertools.combinations(range(len(SLOPES)), model.lobes))
    if len(sets) > _MOST_SETS:
        sets = [sets[k] for k in np.sort(rng.choice(len(sets), _MOST_SETS, replace=False))]
    errors = [nnls(root[:, [0, *(k + 1 for k in one)]], wanted)[1] for one in sets]
    chosen: list[tuple[int, ...]] = []
    for place in np.argsort(errors, kind="stable").tolist():
        if all(sum(abs(a - b) for a, b in zip(sets[place], one, strict=True)) >= _APART for one in chosen):
            chosen.append(sets[place])
        if len(chosen) == count:
            break
    return chosen


def _weighted(
    model: LobeModel, samples: LobeSamples, terms: Terms, slopes: npt.ArrayLike, reflected: Floats
) -> Vector:
    """Return the vector of the slopes, with the weights of each channel by least squares of relative errors."""
    m = np.asarray(slopes, np.float64)
    columns = _columns(model, terms, m, reflected)
    if model.coat:
        columns[:, -1] *= 0.25 * reflected[-1]
    kd, ks = np.zeros(3), np.zeros((model.lobes, 3))
    for channel in range(3):
        known = samples.known[channel]
        if not known.any():
            continue
        root = np.sqrt(samples.weights[known])
        scale = np.exp(-samples.logs[channel, known]) * root
        # The floor is no part of what the lobes make.
        relative, wanted = columns[known] * scale[:, None], root - samples.added[known] * scale
        if model.coat:
            # The coat's own light is what it is; the rest takes what it leaves.
            relative, wanted = relative[:, :-1], np.maximum(wanted - relative[:, -1], 0.0)
        weights = nnls(relative, wanted)[0]
        # A lobe of no weight could not come back: its derivative is 0.
        weights = np.maximum(weights, 1e-4 * max(float(weights.max()), 1e-6))
        kd[channel] = weights[0]
        count = len(weights) - 1
        ks[:count, channel] = weights[1:] / reflected[:count]
    e = [reflectance_from_inverse_index(inverse_index(r)) for r in reflected.tolist()]
    return model.vector(kd, ks, m, e)
