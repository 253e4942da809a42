"""What the window shows of a paint, worked out at once as one frozen value; widgets only draw it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from brdf_designer.colour.display import lab_to_codes, working_to_codes
from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.appearance.flop.travel import FlopIndex, flop_index
from brdf_suite.arrays import Bools, Bytes, Floats
from brdf_suite.documents.paint import Lab, Paint
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.pipeline.lobe_fit import LobeFit
from brdf_suite.reflectance.designed.paint_reflectance import PaintReflectance

FLOP_ANGLES_DEG = (15.0, 45.0, 110.0)
_CURVE_STEP_DEG = 1.0


@dataclass(frozen=True)
class AngleColour:
    """One measurement as it is shown: ``index`` in the document, L*a*b*, sRGB code, whether sRGB holds it."""

    index: int
    text: str
    aspecular_deg: float
    lab: Lab
    rgb: tuple[int, int, int]
    in_gamut: bool


@dataclass(frozen=True)
class GivenColour:
    """What the lobes give at a measurement: L*a*b*, sRGB code, whether sRGB holds it."""

    lab: Lab
    rgb: tuple[int, int, int]
    in_gamut: bool


@dataclass(frozen=True)
class Colours:
    """What the document alone says: always fresh, also where no coat gives the gloss."""

    paint: Paint
    angles: tuple[AngleColour, ...]
    flop: FlopIndex | None


@dataclass(frozen=True, eq=False)
class Curves:
    """What the model and its lobes give over the aspecular angle.

    ``gamma_deg`` (k,) with ``model`` and ``fitted`` L*a*b* (k, 3); ``ceiling`` the largest L* of the base alone;
    ``between_delta_e`` the largest ΔE00 between the two over the measured range, also between the readings;
    ``measured_deg`` the nearest and farthest reading; ``strip_rgb`` (s, 3) and ``strip_in_gamut`` (s,) of the model
    evenly between them, ``strip_given_rgb`` (s, 3) of the lobes.
    """

    gamma_deg: Floats
    model: Floats
    fitted: Floats
    ceiling: float
    between_delta_e: float
    measured_deg: tuple[float, float]
    marks_deg: tuple[float, ...]
    strip_rgb: Bytes
    strip_in_gamut: Bools
    strip_given_rgb: Bytes


@dataclass(frozen=True, eq=False)
class FitState:
    """The reflectance and its fit as the session publishes them; ``delta_e`` ΔE00 by index of the measurement.

    ``given`` is what the lobes give at each measurement, by its index: L*a*b*, sRGB code, whether sRGB holds it.

    ``time_limited``: the limit came before the optimum; ``exact_follows``: which is still looked for.
    """

    given: tuple[GivenColour, ...]
    delta_e: tuple[float, ...]
    worst_delta_e: float
    milliseconds: float
    time_limited: bool
    exact_follows: bool
    ior: float
    roughness: float
    notices: tuple[str, ...]


@dataclass(frozen=True)
class TabState:
    """What a tab says of its document: title, file, and whether all of it is saved; ``key`` is that of the document."""

    key: int
    title: str
    path: Path | None
    clean: bool


def angle_text(paint: Paint, index: int) -> str:
    """Return the angle of a measurement, as in ``15°``; with its light where that is not at 45°."""
    measurement = paint.measurements[index]
    text = f"{measurement.aspecular_deg:g}°".replace("-", "−")
    light = measurement.illumination_deg
    return text if light == 45.0 else f"{text}, light {light:g}°"


def by_angle(paint: Paint) -> tuple[int, ...]:
    """Return the indices of the measurements in the order in which they are shown: by light, then angle."""
    items = paint.measurements
    return tuple(sorted(range(len(items)), key=lambda i: (items[i].illumination_deg, items[i].aspecular_deg)))


def colours_of(paint: Paint) -> Colours:
    """Return what the document alone says."""
    codes, inside = lab_to_codes([m.lab for m in paint.measurements])
    angles = tuple(
        AngleColour(
            i,
            angle_text(paint, i),
            paint.measurements[i].aspecular_deg,
            paint.measurements[i].lab,
            (int(codes[i, 0]), int(codes[i, 1]), int(codes[i, 2])),
            bool(inside[i]),
        )
        for i in by_angle(paint)
    )
    return Colours(paint, angles, _flop(paint))


def layers_of(fit: LobeFit) -> PaintReflectance:
    """Return the base and the coat of the designed paint that was fitted."""
    assert isinstance(fit.reflectance, PaintReflectance)
    return fit.reflectance


def fit_state_of(fit: LobeFit) -> FitState:
    """Return what the reflectance and its lobes give."""
    assert fit.worst_delta_e is not None, "a designed paint has readings"
    layers = layers_of(fit)
    return FitState(
        given=_given(fit),
        delta_e=tuple(row.delta_e_2000 for row in fit.readings),
        worst_delta_e=fit.worst_delta_e,
        milliseconds=1e3 * fit.seconds,
        time_limited=fit.time_limited,
        exact_follows=fit.exact_follows,
        ior=layers.ior,
        roughness=layers.roughness,
        notices=fit.notices,
    )


def _given(fit: LobeFit) -> tuple[GivenColour, ...]:
    codes, inside = lab_to_codes([row.lab_fitted for row in fit.readings])
    return tuple(
        GivenColour(row.lab_fitted, (red, green, blue), shown)
        for row, (red, green, blue), shown in zip(fit.readings, codes.tolist(), inside.tolist(), strict=True)
    )


def _flop(paint: Paint) -> FlopIndex | None:
    found = {m.aspecular_deg: m.lab[0] for m in reversed(paint.measurements)}
    if any(angle not in found for angle in FLOP_ANGLES_DEG):
        return None
    return flop_index(*(found[angle] for angle in FLOP_ANGLES_DEG))


@lru_cache(maxsize=8)
def _directions(
    light_deg: float, nearest_deg: float, first_deg: float, last_deg: float
) -> tuple[int, Floats, Floats, Floats]:
    """Return where the strip begins in γ, γ (k,), wi (3,), wo (k, 3): the same from edit to edit."""
    before = np.arange(nearest_deg, first_deg, _CURVE_STEP_DEG)
    steps = max(1, math.ceil((last_deg - first_deg) / _CURVE_STEP_DEG))
    gamma = np.concatenate((before, np.linspace(first_deg, last_deg, steps + 1)))
    return len(before), gamma, illumination(light_deg), aspecular_view(light_deg, gamma)


def curves_of(fit: LobeFit) -> Curves:
    """Return what the model and its lobes give over the aspecular angle: half a millisecond, so not of a state."""
    readings = fit.paint.measurements
    # The light that most readings have is the one whose curve the rule was found for.
    light = fit.paint.main_light_deg
    angles = [m.aspecular_deg for m in readings if m.illumination_deg == light]
    # The strip lies on the normal's side of the mirror direction, where near and far are.
    this_side = [angle for angle in angles if angle >= 0.0] or angles
    first, last = min(this_side), max(this_side)
    begin, gamma, wi, wo = _directions(light, min(0.0, *angles), first, last)
    layers = layers_of(fit)
    base = np.pi * layers.base.eval(wi, wo)
    rho = base + np.pi * layers.coat.eval(wi, wo)
    fitted = np.pi * fit.weights.eval(wi, wo)
    model, lobes, under = working_to_lab(np.stack((rho, fitted, base)))
    between = delta_e_2000(model[begin:], lobes[begin:])
    codes, inside = working_to_codes(np.stack((rho[begin:], fitted[begin:])))
    return Curves(
        gamma_deg=gamma,
        model=model,
        fitted=lobes,
        ceiling=float(under[:, 0].max()),
        between_delta_e=float(between.max()),
        measured_deg=(first, last),
        marks_deg=tuple(sorted(this_side)),
        strip_rgb=codes[0],
        strip_in_gamut=inside[0],
        strip_given_rgb=codes[1],
    )
