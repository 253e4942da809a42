"""The coordinates of ALTA: from a row's inputs to the directions of light L and view V.

N is the normal, H the half vector, R the light mirrored at the normal. The names are those of ALTA's ``params.cpp``,
whose definitions (the way from directions to coordinates) are followed; its way back errs for COS_TK, SCHLICK_VH,
STEREOGRAPHIC, RETRO… and the sign of NEUMANN_3D. The difference vector of RUSIN… is the view's.

| name | inputs |
|---|---|
| COS_TH, COS_TH_TD, RUSIN_TH_TD, RUSIN_TH_TD_PD, RUSIN_TH_PH_TD_PD | half-angle coordinates, or their cosines |
| RUSIN_VH | H, at θd = 0 |
| COS_TK, SCHLICK_VH | polar angle's cosine, or the vector, of a light seen from its mirror direction |
| SCHLICK_TL_TK_PROJ_DPHI | θL; the vector halfway between V and R, as (θ cos φ, θ sin φ) |
| COS_TLV, COS_TLR, ISOTROPIC_TV_PROJ_DPHI | V for light along the normal: cosine of θV, or (θV cos φ, θV sin φ) |
| ISOTROPIC_TL_TV_PROJ_DPHI, ISOTROPIC_TV_TL_DPHI, ISOTROPIC_TV_TL, SPHERICAL_TL_PL_TV_PV | polar angles, azimuths |
| RETRO_TL_TVL_PROJ_DPHI | θL; V about L, as (θ cos φ, θ sin φ) with φ = 0 towards N |
| STARK_2D, STARK_3D | length of (L + V)/2 across N, that of B = (L - V)/2, and the azimuth between |
| NEUMANN_2D, NEUMANN_3D | lengths of both across N, and the azimuth between |
| STEREOGRAPHIC | x/(1 + z), y/(1 + z) of V, then of L |
| CARTESIAN | V, L |
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.geometry.directions import from_half_angle_coordinates, spherical

Pair = tuple[Floats, Floats]
"""Light and view, (n, 3) each; not a number where there is no such pair."""


@dataclass(frozen=True)
class AltaSystem:
    """One of ALTA's coordinate systems.

    Parameters
    ----------
    inputs
        How many columns.
    pair
        Light and view (n, 3) of the columns (n, ``inputs``); some may lie below the horizon, or be of another length.
    anisotropic
        Whether azimuths about the normal count.
    gridded
        Whether a regular table in it has rows that lie below the horizon; such rows are left out, elsewhere refused.
    """

    inputs: int
    pair: Callable[[Floats], Pair]
    anisotropic: bool = False
    gridded: bool = False


def _half(theta_h: Floats, phi_h: Floats, theta_d: Floats, phi_d: Floats) -> Pair:
    view, light = from_half_angle_coordinates(theta_h, phi_h, theta_d, phi_d)
    return light, view


def _towards(x: Floats, y: Floats) -> Floats:
    """Return the direction at the angle |(x, y)| from the normal, towards (x, y)."""
    return spherical(np.hypot(x, y), np.arctan2(y, x))


def _light(theta: Floats) -> Floats:
    return spherical(theta, np.zeros_like(theta))


def _mirror(w: Floats) -> Floats:
    return w * (-1.0, -1.0, 1.0)


def _root(values: Floats) -> Floats:
    """Return the square root, not a number below 0."""
    return np.asarray(np.sqrt(np.where(values >= 0.0, values, np.nan)))


def _arccos(values: Floats) -> Floats:
    return np.asarray(np.arccos(np.where(np.abs(values) <= 1.0 + 1e-9, np.clip(values, -1.0, 1.0), np.nan)))


def _about_mirror(x: Floats) -> Pair:
    light = _light(x[:, 0])
    reflected, back = _mirror(light), _towards(x[:, 1], x[:, 2])
    along = np.einsum("ni,ni->n", reflected, back)[:, None]
    return light, 2.0 * along * back - reflected


def _about_light(x: Floats) -> Pair:
    light = _light(x[:, 0])
    angle, turn = np.hypot(x[:, 1], x[:, 2]), np.arctan2(x[:, 2], x[:, 1])
    zero = np.zeros(len(x))
    to_normal = np.stack((-np.cos(x[:, 0]), zero, np.sin(x[:, 0])), axis=-1)
    across = np.cos(turn)[:, None] * to_normal + np.sin(turn)[:, None] * (0.0, 1.0, 0.0)
    return light, np.cos(angle)[:, None] * light + np.sin(angle)[:, None] * across


def _stark(along: Floats, length: Floats, turn: Floats) -> Pair:
    up = _root(1.0 - along * along - length * length)
    half = np.stack((along, np.zeros_like(along), up), axis=-1)
    # B is square to H, and its azimuth is the turn.
    c, s = np.cos(turn), np.sin(turn)
    across = np.stack((up * c, up * s, -along * c), axis=-1)
    norm = np.sqrt(np.einsum("ni,ni->n", across, across))[:, None]
    # With H in the plane and B along it nothing is left of the norm: B is then along the normal.
    across = np.where(norm > 0.0, across / np.where(norm > 0.0, norm, 1.0), (0.0, 0.0, 1.0))
    back = length[:, None] * across
    return half + back, half - back


def _neumann(along: Floats, length: Floats, turn: Floats) -> Pair:
    x, y = length * np.cos(turn), length * np.sin(turn)

    def raised(x: Floats, y: Floats) -> Floats:
        return np.stack((x, y, _root(1.0 - x * x - y * y)), axis=-1)

    return raised(along + x, y), raised(along - x, -y)


def _stereographic(x: Floats, y: Floats) -> Floats:
    square = x * x + y * y
    return np.asarray(np.stack((2.0 * x, 2.0 * y, 1.0 - square), axis=-1) / (1.0 + square)[:, None])


def _normal(count: int) -> Floats:
    return np.broadcast_to(np.array([0.0, 0.0, 1.0]), (count, 3)).copy()


def _both(theta: Floats) -> Pair:
    light = _light(theta)
    return light, light.copy()


def _mirrored(light: Floats) -> Pair:
    return light, _mirror(light)


_QUARTER = 0.5 * math.pi

SYSTEMS: dict[str, AltaSystem] = {
    "COS_TH": AltaSystem(1, lambda x: _both(_arccos(x[:, 0]))),
    "COS_TK": AltaSystem(1, lambda x: _mirrored(_light(_arccos(x[:, 0])))),
    "COS_TLV": AltaSystem(1, lambda x: (_normal(len(x)), _light(_arccos(x[:, 0])))),
    "COS_TLR": AltaSystem(1, lambda x: (_normal(len(x)), _mirror(_light(_arccos(x[:, 0]))))),
    "COS_TH_TD": AltaSystem(
        2,
        lambda x: _half(_arccos(x[:, 0]), 0.0 * x[:, 0], _arccos(x[:, 1]), np.full(len(x), _QUARTER)),
        gridded=True,
    ),
    "RUSIN_TH_TD": AltaSystem(
        2, lambda x: _half(x[:, 0], 0.0 * x[:, 0], x[:, 1], np.full(len(x), _QUARTER)), gridded=True
    ),
    "ISOTROPIC_TV_PROJ_DPHI": AltaSystem(2, lambda x: (_normal(len(x)), _towards(x[:, 0], x[:, 1]))),
    "ISOTROPIC_TV_TL": AltaSystem(2, lambda x: (_light(x[:, 1]), _light(x[:, 0]))),
    "STARK_2D": AltaSystem(2, lambda x: _stark(x[:, 0], x[:, 1], np.full(len(x), _QUARTER)), gridded=True),
    "NEUMANN_2D": AltaSystem(
        2, lambda x: _neumann(x[:, 0], x[:, 1], np.full(len(x), _QUARTER)), gridded=True
    ),
    "RUSIN_TH_TD_PD": AltaSystem(3, lambda x: _half(x[:, 0], 0.0 * x[:, 0], x[:, 1], x[:, 2]), gridded=True),
    "ISOTROPIC_TV_TL_DPHI": AltaSystem(3, lambda x: (spherical(x[:, 1], x[:, 2]), _light(x[:, 0]))),
    "ISOTROPIC_TL_TV_PROJ_DPHI": AltaSystem(3, lambda x: (_light(x[:, 0]), _towards(x[:, 1], x[:, 2]))),
    "RUSIN_VH": AltaSystem(3, lambda x: (x, x.copy()), anisotropic=True),
    "SCHLICK_VH": AltaSystem(3, lambda x: _mirrored(x), anisotropic=True),
    "SCHLICK_TL_TK_PROJ_DPHI": AltaSystem(3, _about_mirror, gridded=True),
    "RETRO_TL_TVL_PROJ_DPHI": AltaSystem(3, _about_light, gridded=True),
    "STARK_3D": AltaSystem(3, lambda x: _stark(x[:, 0], x[:, 1], x[:, 2]), gridded=True),
    "NEUMANN_3D": AltaSystem(3, lambda x: _neumann(x[:, 0], x[:, 1], x[:, 2]), gridded=True),
    "RUSIN_TH_PH_TD_PD": AltaSystem(
        4, lambda x: _half(x[:, 0], x[:, 1], x[:, 2], x[:, 3]), anisotropic=True, gridded=True
    ),
    "SPHERICAL_TL_PL_TV_PV": AltaSystem(
        4, lambda x: (spherical(x[:, 0], x[:, 1]), spherical(x[:, 2], x[:, 3])), anisotropic=True
    ),
    "STEREOGRAPHIC": AltaSystem(
        4,
        lambda x: (_stereographic(x[:, 2], x[:, 3]), _stereographic(x[:, 0], x[:, 1])),
        anisotropic=True,
    ),
    "CARTESIAN": AltaSystem(6, lambda x: (x[:, 3:].copy(), x[:, :3].copy()), anisotropic=True),
}
"""By the names that files have; SCHLICK_VH is what ALTA writes for its SCHLICK_VK."""
SYSTEMS["SCHLICK_VK"] = SYSTEMS["SCHLICK_VH"]
