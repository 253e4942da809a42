"""Designed paint: a colour per aspecular angle, gloss, orange peel and flakes.

All values are frozen; an edit makes a new one. A bad value raises :class:`ValueRangeError` whose ``place``
names the field (``measurements[1].lab[0]``).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal, get_args

from brdf_suite.documents.parameter import (
    Parameter,
    check_choices,
    check_labels,
    check_parts,
    describe,
    set_numbers,
)
from brdf_suite.errors import ValueRangeError
from brdf_suite.notebook import Shown

Interpolation = Literal["flake", "monotone", "polynomial"]
INTERPOLATIONS: tuple[str, ...] = get_args(Interpolation)
OutOfPlane = Literal["aspecular", "half_vector"]
OUT_OF_PLANE: tuple[str, ...] = get_args(OutOfPlane)
Scattering = Literal["multiple", "single"]
"""How often light may meet facets of a rough surface: as often as it does, or once, as papers have it."""
SCATTERINGS: tuple[str, ...] = get_args(Scattering)
Lab = tuple[float, float, float]

# An instrument of a hundred angles is far beyond any made; more is a damaged file.
_MOST_MEASUREMENTS = 100
_SAME_ANGLE_DEG = 1e-9

STEEPEST_PEEL_DEG = 5.0
"""The steepest orange peel, root mean square; a bad coat has half a degree."""

PARAMETERS: Mapping[str, Parameter] = {
    "illumination_deg": Parameter(
        "Illumination", "°", 0.0, 85.0, 45.0, "Polar angle of the instrument's light"
    ),
    "aspecular_deg": Parameter(
        "Aspecular angle", "°", -45.0, 170.0, 45.0, "From the mirror direction to the view, past the normal"
    ),
    # Metallic paints reach L* 130 at 15°; nothing known passes 250.
    "lab[0]": Parameter("L*", "", 0.0, 250.0, 50.0, "Lightness"),
    "lab[1]": Parameter("a*", "", -250.0, 250.0, 0.0, "Green to red"),
    "lab[2]": Parameter("b*", "", -250.0, 250.0, 0.0, "Blue to yellow"),
    "gloss.gu_20": Parameter("Gloss 20°", "GU", 0.0, 200.0, 90.0, "Reading at 20°, coat and base together"),
    "gloss.gu_60": Parameter("Gloss 60°", "GU", 0.0, 200.0, 95.0, "Reading at 60°, coat and base together"),
    "orange_peel.amplitude_um": Parameter(
        "Orange peel", "µm", 0.0, 20.0, 0.5, "Root mean square height of the coat's waviness"
    ),
    "orange_peel.wavelength_mm": Parameter(
        "Peel wavelength", "mm", 0.5, 50.0, 4.0, "Typical distance from crest to crest of the orange peel"
    ),
    "flakes.density_per_mm2": Parameter(
        "Flake density", "1/mm²", 0.0, 100_000.0, 3200.0, "Flakes that can be seen per area"
    ),
    "flakes.size_um": Parameter("Flake size", "µm", 0.1, 2000.0, 20.0, "Mean diameter of a flake"),
    "flakes.roughness": Parameter("Flake roughness", "", 0.001, 1.0, 0.17, "Spread of the flake tilts"),
    "flakes.colour_spread": Parameter(
        "Flake colour spread", "", 0.0, 1.0, 0.0, "0: all flakes of one colour; 1: every hue"
    ),
    "texture.grade_15": Parameter("Sparkle 15°", "", 1e-4, 50.0, 1.0, "Grade in light from 15° to aim at"),
    "texture.grade_45": Parameter("Sparkle 45°", "", 1e-4, 50.0, 1.0, "Grade in light from 45° to aim at"),
    "texture.grade_75": Parameter("Sparkle 75°", "", 1e-4, 50.0, 1.0, "Grade in light from 75° to aim at"),
    "texture.graininess": Parameter("Graininess", "", 1e-4, 1.0, 0.03, "In diffuse light, to aim at"),
    "near_specular": Parameter(
        "Near-specular", "", 0.0, 10.0, 1.0, "Scales the base in the mirror direction; not measured"
    ),
}


@dataclass(frozen=True, slots=True)
class Measurement:
    """One reading: CIE L*a*b* at an illumination and an aspecular angle, both in degrees.

    The view's polar angle is ``illumination_deg - aspecular_deg`` and must be above the horizon. Raises
    :class:`ValueRangeError` where it is not, and where L* is not 0 to 250, or a* or b* not -250 to 250.

    >>> import brdf_suite as bs
    >>> bs.Measurement(45.0, 15.0, (62.0, -4.0, -45.0)).lab
    (62.0, -4.0, -45.0)
    """

    illumination_deg: float
    aspecular_deg: float
    lab: Lab

    def __post_init__(self) -> None:
        set_numbers(self, PARAMETERS, "illumination_deg", "aspecular_deg")
        view_deg = self.illumination_deg - self.aspecular_deg
        if abs(view_deg) >= 90.0:
            raise ValueRangeError(
                "aspecular_deg",
                f"with the light at {self.illumination_deg:g}°, {self.aspecular_deg:g}° would look from "
                f"below the surface (polar angle {view_deg:g}°)",
            )
        if not isinstance(self.lab, (tuple, list)) or len(self.lab) != 3:
            raise ValueRangeError("lab", f"expected three numbers L*, a*, b*, not {describe(self.lab)}")
        lab = tuple(PARAMETERS[f"lab[{i}]"].check(self.lab[i], f"lab[{i}]") for i in range(3))
        object.__setattr__(self, "lab", lab)


@dataclass(frozen=True, slots=True)
class Gloss:
    """Glossmeter readings in gloss units, 0 to 200, coat and base together.

    ``gu_20`` is that at 20°, ``gu_60`` at 60°, None where it is not known.

    Raises :class:`ValueRangeError` where one is out of its range.

    >>> import brdf_suite as bs
    >>> bs.Gloss(90.0).gu_20
    90.0
    """

    gu_20: float
    gu_60: float | None = None

    def __post_init__(self) -> None:
        names = ("gu_20",) if self.gu_60 is None else ("gu_20", "gu_60")
        set_numbers(self, PARAMETERS, *names, group="gloss.")


@dataclass(frozen=True, slots=True)
class OrangePeel:
    """The waviness of the coat: its root mean square height, µm, and its typical wavelength, mm.

    Waves steeper than :data:`STEEPEST_PEEL_DEG` are refused: that is a relief, and no coat that has run out.
    """

    amplitude_um: float = 0.5
    wavelength_mm: float = 4.0

    def __post_init__(self) -> None:
        set_numbers(self, PARAMETERS, "amplitude_um", "wavelength_mm", group="orange_peel.")
        if self.slope_deg > STEEPEST_PEEL_DEG:
            most = math.tan(math.radians(STEEPEST_PEEL_DEG)) * self.wavelength_mm * 1e3 / (2.0 * math.pi)
            raise ValueRangeError(
                "amplitude_um",
                f"waves of {self.amplitude_um:g} µm and {self.wavelength_mm:g} mm would be steeper than "
                f"{STEEPEST_PEEL_DEG:g}°; at this wavelength at most {math.floor(100.0 * most) / 100.0:g} µm",
            )

    @property
    def slope_deg(self) -> float:
        """Return the root mean square slope, degrees, of waves of one length: tan = 2π height / wavelength.

        >>> round(OrangePeel(1.11, 4.0).slope_deg, 2)
        0.1
        """
        return math.degrees(math.atan(2.0 * math.pi * self.amplitude_um * 1e-3 / self.wavelength_mm))


@dataclass(frozen=True, slots=True)
class Flakes:
    """Flakes that sparkle.

    Attributes
    ----------
    density_per_mm2
        Flakes that can be seen per area, 0 to 100,000.
    size_um
        Mean diameter, 0.1 to 2,000 µm.
    roughness
        Spread of the flakes' tilts, 0.001 to 1.
    colour_spread
        0: all of one colour; 1: every hue.

    Raises
    ------
    ValueRangeError
        A number is out of its range.

    >>> import brdf_suite as bs
    >>> bs.Flakes(size_um=30.0).size_um
    30.0
    """

    density_per_mm2: float = 3200.0
    size_um: float = 20.0
    roughness: float = 0.17
    colour_spread: float = 0.0

    def __post_init__(self) -> None:
        set_numbers(
            self, PARAMETERS, "density_per_mm2", "size_um", "roughness", "colour_spread", group="flakes."
        )


@dataclass(frozen=True, slots=True)
class TextureTargets:
    """Readings of the texture instrument that a paint shall have, as shares of 1; None leaves one open.

    The grades of sparkle are in light from 15, 45 and 75°. The scale is :data:`brdf_suite.appearance.texture.SCALE`;
    another one would be another version of the format.
    """

    grade_15: float | None = None
    grade_45: float | None = None
    grade_75: float | None = None
    graininess: float | None = None

    def __post_init__(self) -> None:
        given = [name for name in self.__dataclass_fields__ if getattr(self, name) is not None]
        set_numbers(self, PARAMETERS, *given, group="texture.")

    @property
    def wanted(self) -> tuple[float | None, ...]:
        """Return (4,): the three grades and graininess, as of ``TextureReadings.scales``."""
        return self.grade_15, self.grade_45, self.grade_75, self.graininess

    @classmethod
    def of(cls, wanted: Sequence[float | None]) -> TextureTargets | None:
        """Return the targets of :attr:`wanted` (4,), 0 being none; None where all are left open."""
        return cls(*(value or None for value in wanted)) if any(wanted) else None


@dataclass(frozen=True, slots=True)
class Paint(Shown):
    """A designed paint: at least three measurements, in any order, no two at the same angles.

    ``name``, ``notes`` and ``source`` are texts, of at most 200, 100,000 and 10,000 characters; ``gloss`` is what a
    glossmeter reads, ``flakes`` and ``orange_peel`` what is seen of the base and of the coat, None without.
    L*a*b* is CIE 1976 with the white of ``illuminant`` and ``observer_deg``; only D65 and 10° are known so
    far. ``near_specular`` scales what the interpolation gives in the mirror direction, where no instrument
    of three angles looks. ``out_of_plane`` says what a direction outside the readings' plane is compared by: its
    aspecular angle, or the tilt of the flake that would mirror the light there (the flake rule only). ``scattering``
    says whether light that meets several facets of the coat counts (multiple), or is lost as papers have it (single).
    ``texture`` is what its flakes are to be seen as, and changes nothing of what is seen.

    >>> import brdf_suite as bs
    >>> flop = {15: (62.0, -4.0, -45.0), 45: (25.0, 4.0, -38.0), 110: (9.0, 8.0, -28.0)}
    >>> sea = bs.Paint("sea", tuple(bs.Measurement(45, at, lab) for at, lab in flop.items()), bs.Gloss(90))
    >>> sea.with_lab(45.0, (24.0, 4.0, -38.0)).lab_at(45.0)
    (24.0, 4.0, -38.0)
    """

    name: str
    measurements: tuple[Measurement, ...]
    gloss: Gloss
    flakes: Flakes | None = None
    interpolation: Interpolation = "flake"
    near_specular: float = 1.0
    illuminant: str = "D65"
    observer_deg: int = 10
    notes: str = ""
    source: str = ""
    out_of_plane: OutOfPlane = "aspecular"
    orange_peel: OrangePeel | None = None
    scattering: Scattering = "multiple"
    texture: TextureTargets | None = None

    def __post_init__(self) -> None:
        check_labels(self)
        object.__setattr__(self, "measurements", _checked_measurements(self.measurements))
        if not isinstance(self.gloss, Gloss):
            raise ValueRangeError("gloss", f"expected gloss readings, not {describe(self.gloss)}")
        check_parts(
            self,
            flakes=(Flakes, "flakes"),
            orange_peel=(OrangePeel, "orange peel"),
            texture=(TextureTargets, "targets of texture"),
        )
        check_choices(self, interpolation=INTERPOLATIONS, out_of_plane=OUT_OF_PLANE, scattering=SCATTERINGS)
        check_choices(self, illuminant=("D65",))
        set_numbers(self, PARAMETERS, "near_specular")
        if self.observer_deg != 10 or isinstance(self.observer_deg, bool):
            raise ValueRangeError(
                "observer_deg", f"only the 10° observer is known, not {self.observer_deg!r}"
            )
        object.__setattr__(self, "observer_deg", 10)

    @property
    def main_light_deg(self) -> float:
        """Return the polar angle, degrees, of the light that most readings have; of several, the least."""
        lights = [measurement.illumination_deg for measurement in self.measurements]
        return min(lights, key=lambda light: (-lights.count(light), light))

    def lab_at(self, aspecular_deg: float, illumination_deg: float | None = None) -> Lab:
        """Return the L*a*b* read at ``aspecular_deg``, under the light at ``illumination_deg``, as :meth:`index_of`.

        >>> import brdf_suite as bs
        >>> len(bs.load("blue", bs.Paint).lab_at(45.0))
        3
        """
        return self.measurements[self.index_of(aspecular_deg, illumination_deg)].lab

    def with_lab(self, aspecular_deg: float, lab: Lab, illumination_deg: float | None = None) -> Paint:
        """Return this paint with ``lab`` as its L*a*b* at one of its measured geometries.

        ``aspecular_deg`` and ``illumination_deg`` say which, with errors, as of :meth:`index_of`.

        >>> import brdf_suite as bs
        >>> bs.load("blue", bs.Paint).with_lab(45.0, (30.0, 2.0, -40.0)).lab_at(45.0)
        (30.0, 2.0, -40.0)
        """
        index = self.index_of(aspecular_deg, illumination_deg)
        changed = list(self.measurements)
        changed[index] = replace(changed[index], lab=lab)
        return replace(self, measurements=tuple(changed))

    def index_of(self, aspecular_deg: float, illumination_deg: float | None = None) -> int:
        """Return which measurement was read at ``aspecular_deg``, under the light at ``illumination_deg``.

        Without a light (None) it is the first at the angle. Raises :class:`ValueRangeError` where there is none.

        >>> import brdf_suite as bs
        >>> blue = bs.load("blue", bs.Paint)
        >>> blue.measurements[blue.index_of(45.0)].aspecular_deg
        45.0
        """
        used = [
            (index, m)
            for index, m in enumerate(self.measurements)
            if illumination_deg is None or abs(m.illumination_deg - illumination_deg) <= _SAME_ANGLE_DEG
        ]
        if not used:
            known = ", ".join(
                f"{light:g}" for light in sorted({m.illumination_deg for m in self.measurements})
            )
            reason = f"nothing is measured with the light at {illumination_deg:g}°; there are {known}°"
            raise ValueRangeError("illumination_deg", reason)
        for index, measurement in used:
            if abs(measurement.aspecular_deg - aspecular_deg) <= _SAME_ANGLE_DEG:
                return index
        known = ", ".join(f"{m.aspecular_deg:g}" for _, m in used)
        under = "" if illumination_deg is None else f" with the light at {illumination_deg:g}°"
        reason = f"{aspecular_deg:g}° is not measured{under}; there are {known}°"
        raise ValueRangeError("aspecular_deg", reason)


def solid_paint(name: str, lab: Lab, gloss: Gloss | None = None) -> Paint:
    """Return a paint without flop: the same L*a*b* at 15, 45 and 110° with the light at 45°."""
    measurements = tuple(Measurement(45.0, angle, lab) for angle in (15.0, 45.0, 110.0))
    return Paint(name=name, measurements=measurements, gloss=gloss or Gloss(90.0))


def _checked_measurements(measurements: object) -> tuple[Measurement, ...]:
    if not isinstance(measurements, (tuple, list)):
        raise ValueRangeError("measurements", f"expected a list, not {describe(measurements)}")
    if not 3 <= len(measurements) <= _MOST_MEASUREMENTS:
        reason = f"expected 3 to {_MOST_MEASUREMENTS} measurements, found {len(measurements)}"
        raise ValueRangeError("measurements", reason)
    for index, item in enumerate(measurements):
        if not isinstance(item, Measurement):
            raise ValueRangeError(f"measurements[{index}]", f"expected a measurement, not {describe(item)}")
        for earlier, other in enumerate(measurements[:index]):
            if (
                abs(other.illumination_deg - item.illumination_deg) <= _SAME_ANGLE_DEG
                and abs(other.aspecular_deg - item.aspecular_deg) <= _SAME_ANGLE_DEG
            ):
                reason = f"has the same angles as measurements[{earlier}]"
                raise ValueRangeError(f"measurements[{index}]", reason)
    return tuple(measurements)
