"""Stock materials of a car beside its paint, as lobe weights for any set of exponents.

The numbers are plausible for the class of material, not measured. No material reflects more than it receives.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from brdf_suite.documents.view_settings import PANE_IOR, TRANSMITTANCE
from brdf_suite.geometry.fresnel import fresnel_dielectric, sheet_reflectance
from brdf_suite.realtime.environment.ladder import BROADEST_SHARP
from brdf_suite.realtime.values import MaterialWeights, check_exponents

_THETA_FIT = float(np.pi / 4)
_BROAD = (8.0, 12.0, 30.0, 40.0, 60.0)


def stock_materials(exponents: ArrayLike) -> dict[str, MaterialWeights]:
    """Return the materials of a car: ``glass``, ``rubber``, ``chrome`` …, ``neutral`` and a stand-in ``paint``.

    glass: a tinted pane, n = 1.52, seen through; lens: a clear one of plastic, n = 1.59; rubber: black, broad weak
    sheen; chrome: neutral metal mirror; lamp: a bright reflector under clear plastic, n = 1.59; tail_lamp: the same
    under red plastic; trim: satin black plastic; cavity: the inside of openings and wheel wells, which most of the
    sky's light does not reach, so that next to nothing comes back; gap: the same between panels; neutral: an 18 %
    grey, matt. ``paint`` is a plain grey under a coat, seen until the paint has been fitted.

    Their broad lobes have exponents of their own, as far as the environment's broad lobes reach.
    """
    given = check_exponents(exponents)
    reach = max((e for e in given if e <= BROADEST_SHARP), default=0.0)
    e = tuple(sorted({*given, *(own for own in _BROAD if own <= reach)}))
    return {
        "glass": _pane(e, ior=PANE_IOR["glass"], transmittance=TRANSMITTANCE["glass"]),
        "lens": _pane(e, ior=PANE_IOR["lens"], transmittance=TRANSMITTANCE["lens"]),
        "rubber": _coated(e, base=0.03, ior=1.5, coat_exponent=12.0, coat_share=0.35),
        "chrome": _metal(e, reflectance=(0.56, 0.57, 0.58)),
        "lamp": _coated(e, base=0.16, ior=1.59, coat_exponent=np.inf, metallic=0.42, metallic_exponent=60.0),
        "tail_lamp": _coated(
            e,
            base=(0.07, 0.004, 0.003),
            ior=1.59,
            coat_exponent=np.inf,
            metallic=(0.22, 0.012, 0.006),
            metallic_exponent=30.0,
        ),
        "trim": _coated(e, base=0.035, ior=1.49, coat_exponent=40.0, coat_share=0.8),
        "cavity": _matt(e, albedo=0.004),
        "gap": _matt(e, albedo=0.004),
        "neutral": _coated(e, base=0.18, ior=1.5, coat_exponent=8.0, coat_share=0.25),
        "paint": _coated(e, base=0.25, ior=1.5, coat_exponent=np.inf),
    }


def lobe_mix(exponents: tuple[float, ...], exponent: float, albedo: ArrayLike) -> NDArray[Any]:
    """Return weights (m, 3) of the two nearest lobes that make a lobe of ``exponent`` with this albedo.

    The share of each is linear in log E, and ``albedo`` (3,) = Σ weight·2π/(E+1) exactly. An exponent
    beyond the ends of the set takes the lobe at the end.
    """
    order = np.argsort(exponents)
    logs = np.log(np.asarray(exponents)[order])
    place = np.interp(np.log(min(exponent, 1e12)), logs, np.arange(len(order)))
    low = int(place)
    shares = np.zeros(len(exponents))
    shares[order[low]] = 1.0 - (place - low)
    if place > low:
        shares[order[low + 1]] = place - low
    solid_angles = 2.0 * np.pi / (np.asarray(exponents) + 1.0)
    return np.outer(shares / solid_angles, np.broadcast_to(np.asarray(albedo, np.float64), 3))


def _coated(
    exponents: tuple[float, ...],
    *,
    base: ArrayLike,
    ior: float,
    coat_exponent: float,
    coat_share: float = 1.0,
    metallic: ArrayLike = 0.0,
    metallic_exponent: float = 1.0,
) -> MaterialWeights:
    coat = coat_share * float(fresnel_dielectric(np.cos(_THETA_FIT), ior))
    return MaterialWeights(
        exponents=exponents,
        kd=np.broadcast_to(np.asarray(base, np.float64), 3) / np.pi,
        kdd=lobe_mix(exponents, metallic_exponent, metallic),
        kg=lobe_mix(exponents, coat_exponent, coat),
        theta_fit_rad=_THETA_FIT,
        ior=ior,
        coat="dielectric",
    )


def _pane(exponents: tuple[float, ...], *, ior: float, transmittance: float) -> MaterialWeights:
    nothing = np.zeros((len(exponents), 3))
    return MaterialWeights(
        exponents=exponents,
        kd=np.zeros(3),
        kdd=nothing,
        kg=lobe_mix(exponents, np.inf, float(sheet_reflectance(np.cos(_THETA_FIT), ior))),
        theta_fit_rad=_THETA_FIT,
        ior=ior,
        coat="sheet",
        transmittance=transmittance,
    )


def _matt(exponents: tuple[float, ...], *, albedo: float) -> MaterialWeights:
    nothing = np.zeros((len(exponents), 3))
    return MaterialWeights(exponents, np.full(3, albedo / np.pi), nothing, nothing, ior=1.0, coat="none")


def _metal(exponents: tuple[float, ...], *, reflectance: tuple[float, float, float]) -> MaterialWeights:
    nothing = np.zeros((len(exponents), 3))
    return MaterialWeights(
        exponents=exponents,
        kd=np.zeros(3),
        kdd=nothing,
        kg=lobe_mix(exponents, np.inf, reflectance),
        theta_fit_rad=0.0,
        ior=1.0,
        coat="metal",
    )
