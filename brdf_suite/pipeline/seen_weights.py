"""Weights for every angle of the view, fitted to all the light that a picture gathers there.

A designed paint is fitted in the plane of incidence at 45°, and Fresnel's equations take it to other angles. That is
not enough for what is wide and does not look the same from everywhere: a facet lobe of Cook and Torrance is narrower
across the plane than in it, by the cosine, so that a round lobe fitted in the plane sends 1.4 times too much to a view
along the normal and a third at grazing (docs/method/shading.md); measured data follow no equation at all; and
a paint read under several lights has another colour at each of them.

So here the target at a view is T(ω) = f_r·(N·ω) over the whole half sphere, the columns are the look-ups themselves, as
the renderer's table has them, and the measure is the error in typical light
(``lighting/filter/mirror_harmonics.py``). What is not a designed paint also gets lobes about the view, for light that
is sent back, and lobes beside the mirror direction in the plane of incidence, for what is wider there than across it.

A reflection as in a mirror is so much brighter than all else that errors of the rest would not count, but there is
not always a light to be reflected. So coat and base of a designed paint are fitted by themselves, and of what is not
divided the light from away from the mirror direction counts as much as all light.

In the end all weights of an angle are scaled such that constant light comes back as it should. Of the lobes at most
eight broad and four sharp ones are kept, what the renderer has written-out programs for.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from typing import NamedTuple, get_args

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats
from brdf_suite.fitting.lobes.checks import check_targets
from brdf_suite.fitting.lobes.measured_samples import differs_with_azimuth
from brdf_suite.fitting.lobes.smooth_over_angles import ColumnGroup, chained_weights
from brdf_suite.lighting.filter.mirror_harmonics import COAT_ORDERS, MirrorHarmonics, mirror_harmonics
from brdf_suite.realtime.environment.ladder import BROADEST_SHARP
from brdf_suite.realtime.environment.look_up_table import (
    RAMP_COSINES,
    RAMP_NODES,
    TURNS,
    Target,
    Turn,
    direction,
    look_up_table,
)
from brdf_suite.realtime.values import WeightsOverAngle
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.designed.paint_reflectance import PaintReflectance
from brdf_suite.reflectance.protocol import Reflectance

PLACES: tuple[int, ...] = tuple(range(0, RAMP_NODES, 3))
"""The nodes of the ramp at which weights are fitted; between them they are mixed."""

MOST_BROAD, MOST_SHARP = 8, 4
#: N·V there, and at grazing a little above 0.
_COSINES: tuple[float, ...] = tuple(max(float(RAMP_COSINES[place]), 1e-3) for place in PLACES)
#: Angles of the view that are analysed at once.
_AT_ONCE = 6
#: Share of the brightest angle below which an angle counts less, and of the first measure at the same angle.
_DARKEST, _LEAST_AWAY = 1e-4, 1e-3
#: Turns of the surface over which what differs with its azimuth is averaged.
_TURNS = 8


class _Column(NamedTuple):
    """A look-up: of KD at N (``target`` None), of a lobe times N·L, where the table says or turned, or alone."""

    target: Target | None
    lobe: int
    turn: Turn = "unturned"


_DIFFUSE = _Column(None, 0)


class _Layer(NamedTuple):
    """What of a reflectance is fitted by itself: its values f_r (..., c), in which measures, and with which columns."""

    eval: Callable[[Floats, Floats], Floats]
    measures: tuple[MirrorHarmonics, ...]
    columns: tuple[_Column, ...]


def seen_weights(reflectance: Reflectance, exponents: tuple[float, ...]) -> WeightsOverAngle:
    """Return weights on lobes of ``exponents`` (m,) for the renderer's shifted look-ups, at its 64 cosines N·V.

    Raises :class:`FittingError`: a value is negative or not finite; the message says where.
    """
    broad = [lobe for lobe, exponent in enumerate(exponents) if exponent <= BROADEST_SHARP]
    under_coat = isinstance(reflectance, PaintReflectance) and reflectance.ior > 1.0
    if isinstance(reflectance, PaintReflectance):
        # By itself, because it outshines the base.
        coat = _coat_weights(reflectance.coat, exponents)
        target: Target = "coated" if under_coat else "plain"
        columns = (_DIFFUSE, *(_Column(target, lobe) for lobe in broad))
        layer = _Layer(reflectance.base.eval, (mirror_harmonics(sharp=False),), columns)
    else:
        coat = np.zeros((RAMP_NODES, len(exponents), 3))
        lobes = (_Column("plain", lobe, turn) for turn in get_args(Turn) for lobe in broad)
        measures = (mirror_harmonics(), mirror_harmonics(sharp=False, away=True))
        layer = _Layer(reflectance.eval, measures, (_DIFFUSE, *lobes, *_gloss(exponents)))
    room = MOST_BROAD - int(np.count_nonzero(coat[:, broad].any(axis=(0, 2))))
    turns = _TURNS if differs_with_azimuth(reflectance) else 1
    found = _fitted(layer, exponents, under_coat, turns, room)
    kdd, kg, elsewhere = np.zeros(coat.shape), coat.copy(), np.zeros((len(TURNS), *coat.shape))
    for k, column in enumerate(layer.columns[1:], 1):
        part = kg if column.target == "gloss" else kdd
        if column.turn != "unturned":
            part = elsewhere[TURNS.index(column.turn)]
        part[:, column.lobe] = found[:, k]
    return WeightsOverAngle(found[:, 0], kdd, kg, elsewhere, under_coat)


@lru_cache(maxsize=16)
def _coat_weights(coat: CoatLobe, exponents: tuple[float, ...]) -> Floats:
    """Return the weights (64, m, 3) of a clearcoat; an edit of the colour does not change them."""
    sphere = mirror_harmonics(orders=COAT_ORDERS)
    layer = _Layer(lambda wi, wo: coat.eval_grey(wi, wo)[..., None], (sphere,), _gloss(exponents))
    return np.repeat(_fitted(layer, exponents, True, 1, MOST_BROAD), 3, axis=2)


def _gloss(exponents: tuple[float, ...]) -> tuple[_Column, ...]:
    # Sharp lobes are looked up at R, with or without the cosine alike.
    return tuple(_Column("gloss", lobe) for lobe in range(len(exponents)))


def _fitted(layer: _Layer, exponents: tuple[float, ...], under_coat: bool, turns: int, room: int) -> Floats:
    """Return the weights (64, columns, c) of a layer, of whose broad columns at most ``room`` are kept."""
    squares, products, targets, means, least = 0.0, 0.0, 0.0, [], np.zeros((1, 1))
    for sphere in layer.measures:
        systems, own_squares = _systems(exponents, layer.columns, under_coat, sphere.lobes)
        wanted = _analysed(layer, sphere, turns)
        size = (wanted**2).sum(axis=1)
        # What is dark at its angle counts as much as what is bright at another, but for next to nothing.
        brightness = size.mean(axis=1, keepdims=True)
        scale = 1.0 / np.maximum(
            brightness, np.maximum(_DARKEST * brightness.max(), np.maximum(least, 1e-300))
        )
        squares = squares + own_squares * scale[..., None]
        products = products + systems.transpose(0, 2, 1) @ wanted * scale[..., None]
        targets = targets + size * scale
        means.append((systems[:, :1], wanted[:, :1]))
        # In a further measure a polished surface has nothing but what is left of its peak.
        least = _LEAST_AWAY * brightness
    broad = [k for k, c in enumerate(layer.columns) if c.target and exponents[c.lobe] <= BROADEST_SHARP]
    sharp = [k for k, c in enumerate(layer.columns) if c.target and exponents[c.lobe] > BROADEST_SHARP]
    groups = (ColumnGroup(broad, room), ColumnGroup(sharp, MOST_SHARP))
    found = chained_weights(np.asarray(squares), np.asarray(products), np.asarray(targets), groups)
    # The first coefficient of the first measure is that of the mean.
    of_columns, mean = means[0]
    return _on_the_ramp(found * (mean / np.maximum(of_columns @ found, 1e-300)))


def _analysed(layer: _Layer, sphere: MirrorHarmonics, turns: int) -> Floats:
    """Return the coefficients (places, k, c) of a layer; in pieces, so that a process of thumbnails stays small."""
    found = []
    for first in range(0, len(PLACES), _AT_ONCE):
        views = _COSINES[first : first + _AT_ONCE]
        found.append(sphere.analyse(np.stack([_gathered(layer, sphere.lights(c), c, turns) for c in views])))
    return np.concatenate(found)


@lru_cache(maxsize=4)
def _systems(
    exponents: tuple[float, ...],
    columns: tuple[_Column, ...],
    under_coat: bool,
    lobes: Callable[[Floats, Floats], Floats],
) -> tuple[NDArray[np.float32], Floats]:
    """Return the coefficients A (places, k, columns) of all look-ups, which no reflectance changes, and AᵀA."""
    found = []
    for place, cosine in zip(PLACES, _COSINES, strict=True):
        away, sharpness, amplitude = _look_ups(columns, exponents, place, cosine, under_coat)
        found.append(lobes(away, sharpness) * amplitude)
    systems = np.stack(found)
    # Kept for all reflectances, and exact enough by half.
    return systems.astype(np.float32), systems.transpose(0, 2, 1) @ systems


def _look_ups(
    columns: tuple[_Column, ...], exponents: tuple[float, ...], place: int, cosine: float, under_coat: bool
) -> tuple[Floats, Floats, Floats]:
    """Return how far each look-up is turned from R to N (k,), its exponent (k,) and amplitude (k,)."""
    table = look_up_table()
    theta = float(np.arccos(cosine))
    diffuse = (table.diffuse_exponent, table.diffuse_amplitude) if under_coat else (1.0, np.pi)
    rows = []
    for column in columns:
        if column.target is None:
            rows.append((theta, *diffuse))
            continue
        exponent = exponents[column.lobe]
        found = table.find(column.target, exponent)
        away = 0.0
        if exponent <= BROADEST_SHARP:
            *towards, sign = direction(found, exponent, column.turn)
            height = sign * cosine + float(np.dot(towards, (1.0, cosine, cosine * cosine)))
            away = theta - math.atan2(sign * math.sin(theta), height)
        rows.append((away, float(found.exponent[place]), float(found.amplitude[place])))
    away, sharpness, amplitude = np.array(rows).T
    return away, sharpness, amplitude


def _gathered(layer: _Layer, lights: Floats, cosine: float, turns: int) -> Floats:
    """Return f_r·(N·ω) (rings, azimuths, c) of a layer for the view at -x."""
    view = np.array([-np.sqrt(1.0 - cosine * cosine), 0.0, cosine])
    above = lights[..., 2] > 0.0
    wi = lights[above]
    found = []
    for turn in range(turns):
        angle = 2.0 * np.pi * turn / turns
        about = np.array(
            [[np.cos(angle), np.sin(angle), 0.0], [-np.sin(angle), np.cos(angle), 0.0], [0.0, 0.0, 1.0]]
        )
        # Every other turn from the other side of the plane: the mean is even about it.
        mirrored = wi * ([1.0, -1.0, 1.0] if turn % 2 else [1.0, 1.0, 1.0])
        values = layer.eval(mirrored @ about, view @ about)
        found.append(
            check_targets(
                "The reflectance",
                values,
                (len(wi), np.shape(values)[-1]),
                lambda _: f"with the view at {np.degrees(np.arccos(cosine)):.4g}° from the normal",
            )
        )
    total = np.mean(found, axis=0)
    values = np.zeros((*lights.shape[:2], total.shape[-1]))
    # A coat's values far from its peak are denormal, with which products take ten times as long.
    values[above] = np.where(total > 1e-100, total * wi[:, 2:], 0.0)
    return values


def _on_the_ramp(found: Floats) -> Floats:
    """Return the weights (64, columns, c) at the nodes of the ramp, of those at the places."""
    at = np.sqrt(RAMP_COSINES)
    nodes = at[list(PLACES)]
    lower = np.clip(np.searchsorted(nodes, at, side="right") - 1, 0, len(nodes) - 2)
    share = ((at - nodes[lower]) / (nodes[lower + 1] - nodes[lower]))[:, None, None]
    return np.asarray((1.0 - share) * found[lower] + share * found[lower + 1])
