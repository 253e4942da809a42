"""Look-up table of ``brdf-suite shading-table``, resampled at the nodes of a ramp.

``lighting/filter/shading_table.py`` and docs/method/shading.md describe the table and its computation. Exponents above
the table's last are so sharp that a shift no longer matters: they are looked up at R with a closed amplitude.
"""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from brdf_suite.arrays import Floats
from brdf_suite.errors import FileError
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.resources import resource

Target = Literal["plain", "coated", "gloss"]
"""A lobe times N·L, the same through a coat, a lobe alone."""

Turn = Literal["unturned", "back", "inwards", "outwards"]
TURNS: tuple[Turn, ...] = ("back", "inwards", "outwards")
"""Where a lobe may be looked up instead: mirrored about N, which is about the view; nearer to N; and away from it."""

_TILT = 1.5

RAMP_NODES = 64
RAMP_COSINES: Floats = (np.arange(RAMP_NODES) / (RAMP_NODES - 1)) ** 2
"""The cosines N·V at which a material's ramp has its texels: even in the root, dense at grazing."""


@dataclass(frozen=True, eq=False)
class LookUp:
    """Look-up parameters of a lobe at the ramp's 64 cosines c.

    Direction R + b N with ``b = toward_normal · (1, c, c²)``, the map of ``exponent`` (64,), times ``amplitude`` (64,),
    which is the integral of the target over light of 1.
    """

    toward_normal: Floats
    exponent: Floats
    amplitude: Floats


def direction(look_up: LookUp, exponent: float, turn: Turn = "unturned") -> Floats:
    """Return where a lobe is looked up, (4,): b's coefficients, and the sign of R in ± R + b N.

    Two lobes beside one in the plane of incidence are together as wide there as the lobe of a facet model is, which is
    narrower across the plane by the cosine. They lie a lobe's width times the sine of the angle apart from it.
    """
    c0, c1, c2 = look_up.toward_normal
    if turn == "back":  # R + b N mirrored about N: 2 c N - R + b N
        return np.array([c0, c1 + 2.0, c2, -1.0])
    tilt = {"unturned": 0.0, "inwards": _TILT, "outwards": -_TILT}[turn] / math.sqrt(exponent + 1.0)
    return np.array([c0 + tilt, c1, c2, 1.0])


class LookUpTable:
    """The look-up table with a cache by target and exponent."""

    def __init__(self, plain_values: dict[str, Any]) -> None:
        self._logs = np.log(np.asarray(plain_values["exponents"], np.float64))
        roots = np.sqrt(np.asarray(plain_values["cosines"], np.float64))
        self._ior = float(plain_values["coat_ior"])
        self._rows: dict[str, tuple[Floats, Floats, Floats]] = {}
        at = np.sqrt(RAMP_COSINES)
        exponents = np.exp(self._logs)
        for target, rows in plain_values["targets"].items():
            # Logarithms of ratios, because they hardly change from one exponent to the next.
            ratio, amplitude = [], []
            for row, log, e in zip(rows, self._logs, exponents, strict=True):
                ratio.append(np.interp(at, roots, np.log(row["exponent"]) - log))
                amplitude.append(np.interp(at, roots, np.log(np.asarray(row["amplitude"]) * (e + 1.0))))
            toward = np.array([row["toward_normal"] for row in rows], np.float64)
            self._rows[target] = (toward, np.stack(ratio), np.stack(amplitude))
        self.diffuse_exponent = float(plain_values["diffuse"]["exponent"])
        """Of the look-up at N for a diffuse base under a coat."""
        self.diffuse_amplitude = float(plain_values["diffuse"]["amplitude"])
        """Its integral over light of 1: π without the coat."""
        self._kept: dict[tuple[Target, float], LookUp] = {}

    def find(self, target: Target, exponent: float) -> LookUp:
        """Return how a lobe of ``exponent`` ≥ 1 is looked up."""
        key = (target, exponent)
        if key not in self._kept:
            if len(self._kept) > 512:  # a search over bases must not fill the memory
                self._kept.clear()
            self._kept[key] = self._find(target, exponent)
        return self._kept[key]

    def _find(self, target: Target, exponent: float) -> LookUp:
        if exponent > math.exp(self._logs[-1]) * (1.0 + 1e-9):
            return LookUp(
                np.zeros(3),
                np.full(RAMP_NODES, exponent),
                sharp_amplitude(target, exponent, RAMP_COSINES, self._ior),
            )
        toward, ratio, amplitude = self._rows[target]
        place = float(np.interp(math.log(max(exponent, 1.0)), self._logs, np.arange(len(self._logs))))
        low = min(int(place), len(self._logs) - 2)
        share = place - low

        def mixed(rows: Floats) -> Floats:
            return np.asarray((1.0 - share) * rows[low] + share * rows[low + 1])

        return LookUp(
            mixed(toward), exponent * np.exp(mixed(ratio)), np.exp(mixed(amplitude)) / (exponent + 1.0)
        )


@lru_cache(maxsize=1)
def look_up_table() -> LookUpTable:
    """Return the packaged table; :class:`FileError` where it is missing or damaged."""
    path = resource("shading", "look_ups.json")
    try:
        return LookUpTable(json.loads(path.read_text(encoding="utf-8")))
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise FileError(path, "the table of look-ups cannot be read; install brdf-suite again") from error


def constant_light(exponent: ArrayLike, cosine: ArrayLike) -> tuple[Floats, Floats]:
    """Return C and H (...): what a lobe of exponent E at the cosine N·R gives in constant light, over 2π/(E+1).

    C for a lobe times N·L, H for a lobe alone, both cut off at the horizon. With the normal distribution's cdf Φ and
    density φ: ``μ = (E+1)/(E+2)·cosθ, s = sinθ/√(E+3), C = μΦ(μ/s) + sφ(μ/s), H = Φ(μ/s)``; right to .018 (E = 1),
    .0015 (E = 16), .0002 (E ≥ 64) for C.
    """
    e, c = np.broadcast_arrays(np.asarray(exponent, np.float64), np.asarray(cosine, np.float64))
    mean = (e + 1.0) / (e + 2.0) * c
    spread = np.sqrt(np.maximum(1.0 - c * c, 1e-12) / (e + 3.0))
    x = mean / spread
    below = np.asarray(0.5 * (1.0 + np.vectorize(math.erf, otypes=[float])(x / math.sqrt(2.0))))
    density = np.exp(-0.5 * x * x) / math.sqrt(2.0 * math.pi)
    return np.asarray(mean * below + spread * density), below


def sharp_amplitude(target: Target, exponent: float, cosine: Floats, ior: float) -> Floats:
    """Return a sharp lobe's amplitude (...) at cosines (...), closed: with the coat where the mean light crosses it."""
    with_cosine, alone = constant_light(exponent, cosine)
    share = alone if target == "gloss" else with_cosine
    if target == "coated":
        at_fit = 1.0 - float(fresnel_dielectric(math.cos(math.pi / 4.0), ior))
        share = share * (1.0 - fresnel_dielectric(with_cosine / alone, ior)) / at_fit
    return np.asarray(2.0 * math.pi / (exponent + 1.0) * share)
