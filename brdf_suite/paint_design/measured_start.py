"""From a measured reflectance to a designed paint: what the virtual instruments read of it, as a start.

The spectrophotometer reads L*a*b* at a chosen set of angles, the glossmeter 20° and 60°. Flakes cannot be derived from
a reflectance. How well the design matches the original is reported where it was *not* read: ΔE00 at angles between and
beyond, and under other lights.
"""

from __future__ import annotations

import math
import os
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from brdf_suite.appearance.colour.flat_colours import within_paint
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.appearance.geometries import GEOMETRY_SETS, Geometry, GeometrySet
from brdf_suite.arrays import triple
from brdf_suite.documents.paint import PARAMETERS, Gloss, Interpolation, Lab, Measurement, Paint
from brdf_suite.documents.store import AnyPaint
from brdf_suite.errors import SuiteError, UnreachableError
from brdf_suite.foreign_text import file_title
from brdf_suite.pipeline.material import Material, load_document, load_material
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.reflectance.designed.build import build_paint, interpolation_notices
from brdf_suite.reflectance.instruments.glossmeter import gloss_reading
from brdf_suite.reflectance.instruments.spectrophotometer import SUPPORT_DEG, Reading, measure
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

USUAL_GLOSS = Gloss(90.0)
"""What stands in where no gloss can be had of the data: a usual clearcoat."""
START_SET = "e2194"

HELD_OUT_LIGHTS_DEG = (45.0, 20.0, 60.0)
HELD_OUT_STEP_DEG = 10.0
_HELD_OUT_FROM_DEG, _HELD_OUT_TO_DEG = 15.0, 110.0
_MOST_VIEW_DEG = 75.0
_SAME_DEG = 1e-6
_DECIMALS = 2
_GLOSS_ANGLES = (20, 60)
# The usual rule first: another one takes its place only where that is seen.
_RULES: tuple[Interpolation, ...] = ("flake", "monotone", "polynomial")
_WORTH_DELTA_E = 0.1
# Where the readings themselves cannot be had, one of these is: six steps in a doubling of the gloss.
_REACH_GU = tuple(round(2.0 ** (k / 6.0), 1) for k in range(-6, 46))


@dataclass(frozen=True)
class GlossEstimate:
    """What a glossmeter reads of a reflectance: ``gloss`` is ``None`` where nothing can be said, and ``why``."""

    gloss: Gloss | None
    readings: dict[int, float]
    why: str = ""


@dataclass(frozen=True)
class HeldOutGeometry:
    """A geometry that the design was not made from: what the original and the design look like there.

    ``sample_deg`` is the angle from it to the original's nearest sample, degrees, as of a reading.
    """

    illumination_deg: float
    aspecular_deg: float
    original: Lab
    design: Lab
    delta_e_2000: float
    sample_deg: float = 0.0

    @property
    def supported(self) -> bool:
        """Whether the original has a sample near enough."""
        return self.sample_deg <= SUPPORT_DEG


@dataclass(frozen=True)
class MeasuredStart:
    """A designed paint that was read from something measured.

    ``readings`` are the original's. ``gloss`` says what the glossmeter read, ``gloss_used`` whether the paint has it.
    ``held_out`` is empty where the design cannot be built; ``notices`` are whole sentences.
    """

    paint: Paint
    source: str
    geometry_set: GeometrySet
    readings: tuple[Reading, ...]
    gloss: GlossEstimate
    gloss_used: bool
    held_out: tuple[HeldOutGeometry, ...]
    notices: tuple[str, ...]

    @property
    def mean_delta_e(self) -> float | None:
        """The mean ΔE00 at the geometries that were not used."""
        return float(np.mean([row.delta_e_2000 for row in self.held_out])) if self.held_out else None

    @property
    def worst(self) -> HeldOutGeometry | None:
        """Where the design is farthest from the original."""
        return max(self.held_out, key=lambda row: row.delta_e_2000, default=None)

    def under(self, illumination_deg: float) -> tuple[HeldOutGeometry, ...]:
        """Return the rows of one light."""
        return tuple(row for row in self.held_out if row.illumination_deg == illumination_deg)


def load_start(
    name_or_path: str | os.PathLike[str],
    geometry_set: GeometrySet = GEOMETRY_SETS[START_SET],
    progress: Progress | None = None,
) -> MeasuredStart:
    """Read a measured file, or a paint of any kind, and start a design from it.

    Raises
    ------
    SuiteError
        It cannot be read, or nothing can be measured of it; the message says why.
    Cancelled
        The progress callback asked for it.
    """
    report(progress, 0.0, f"reading {Path(name_or_path).name}")
    item = load_material(name_or_path)
    return measured_start(item, geometry_set, subrange(progress, 0.5, 1.0))


def load_paint_or_start(
    name_or_path: str | os.PathLike[str],
    progress: Progress | None = None,
    *,
    cmyk_profile: str | os.PathLike[str] | None = None,
) -> AnyPaint:
    """Return the document of a paint of any kind; of measured data and models the design that is started from them.

    ``cmyk_profile`` as in :func:`~brdf_suite.pipeline.material.load_material`; errors as :func:`load_start`, but for
    paints that cannot be built.
    """
    document = load_document(name_or_path, cmyk_profile=cmyk_profile)
    return load_start(name_or_path, progress=progress).paint if document is None else document


def measured_start(
    item: Material,
    geometry_set: GeometrySet = GEOMETRY_SETS[START_SET],
    progress: Progress | None = None,
) -> MeasuredStart:
    """Start a design from something measured; errors as :func:`load_start`."""
    report(progress, 0.0, "reading the colours")
    notices = list(item.notices)
    found = measure(item.reflectance, geometry_set)
    measurements = tuple(_measurement(reading.geometry, reading.lab, notices) for reading in found.readings)
    report(progress, 0.3, "reading the gloss")
    estimate = estimated_gloss(item.reflectance)
    # Without the ending of a file, short enough and in one line.
    name = file_title(Path(item.name).stem).strip()[:200]
    paint = Paint(
        name=name or "Measured",
        measurements=measurements,
        gloss=USUAL_GLOSS,
        source=f"Read by the virtual spectrophotometer from {file_title(Path(item.origin or item.name).name)}",
    )
    notices.append("Of flakes a reflectance says nothing: the design has none that can be seen singly.")
    report(progress, 0.5, "comparing at angles that were not used")
    paint, used, rows, further = _nearest_rule(item.reflectance, paint, estimate)
    notices += further
    report(progress, 1.0, "done")
    return MeasuredStart(
        paint, item.origin, geometry_set, found.readings, estimate, used, rows, tuple(notices)
    )


def estimated_gloss(reflectance: Reflectance) -> GlossEstimate:
    """Return the glossmeter's readings at 20 and 60° as a paint holds them, where they can be had.

    Scattered samples have none: a mirror lobe is narrower than they lie apart. A table reads what its
    interpolation makes of the lobe.
    """
    if isinstance(reflectance, ScatteredSamples):
        return GlossEstimate(None, {}, "scattered samples lie too far apart for a mirror lobe")
    readings = {angle: gloss_reading(reflectance, angle) for angle in _GLOSS_ANGLES}
    if not all(map(math.isfinite, readings.values())):
        return GlossEstimate(None, {}, "the data are not finite numbers around the mirror direction")
    kept = {
        angle: min(PARAMETERS[f"gloss.gu_{angle}"].high, max(0.0, round(value, 1)))
        for angle, value in readings.items()
    }
    return GlossEstimate(Gloss(kept[20], kept[60]), readings)


def _with_gloss(paint: Paint, estimate: GlossEstimate) -> tuple[Paint, bool, list[str]]:
    """The paint with the most of the gloss readings that a clearcoat over its colours can have."""
    if estimate.gloss is None:
        reason = f"No gloss could be had of the data ({estimate.why}); {USUAL_GLOSS.gu_20:g} GU at 20° is set instead,"
        return paint, False, [f"{reason} not measured."]
    read = ", ".join(f"{value:.1f} GU at {angle}°" for angle, value in estimate.readings.items())
    at_20 = estimate.gloss.gu_20
    # Both readings; else the 20° one alone; else the nearest that can be, dull or glossy.
    nearest = sorted(_REACH_GU, key=lambda value: abs(math.log(value / max(at_20, _REACH_GU[0]))))
    reason = ""
    for gloss in (estimate.gloss, Gloss(at_20), *map(Gloss, nearest)):
        candidate = replace(paint, gloss=gloss)
        try:
            build_paint(candidate)
        except UnreachableError as error:
            reason = reason or str(error).rstrip(".")
            continue
        if gloss is estimate.gloss:
            return candidate, True, []
        if gloss.gu_20 == at_20:
            notice = f"The glossmeter reads {read}, which no clearcoat gives; only the 20° reading is taken."
            return candidate, True, [notice]
        notice = f"The glossmeter reads {read}, which no clearcoat over these colours gives ({reason});"
        return candidate, False, [f"{notice} {gloss.gu_20:g} GU at 20°, the nearest found, is set instead."]
    return (
        paint,
        False,
        [f"The glossmeter reads {read}, and no clearcoat over these colours was found: {reason}."],
    )


def _measurement(geometry: Geometry, lab: Lab, notices: list[str]) -> Measurement:
    """A reading rounded to what an instrument shows, inside what a paint may hold."""
    kept = within_paint([round(value, _DECIMALS) + 0.0 for value in lab])
    if any(abs(one - value) > 0.5 * 10.0**-_DECIMALS + 1e-9 for one, value in zip(kept, lab, strict=True)):
        shown = ", ".join(f"{value:.1f}" for value in lab)
        notices.append(
            f"At {geometry.name} L*a*b* {shown} is beyond what a paint holds; the nearest is taken."
        )
    return Measurement(geometry.illumination_deg, geometry.aspecular_deg, kept)


def _nearest_rule(
    reflectance: Reflectance, paint: Paint, estimate: GlossEstimate
) -> tuple[Paint, bool, tuple[HeldOutGeometry, ...], list[str]]:
    """The paint with the rule between the angles that is nearest to the original where it was not read.

    Which gloss a clearcoat can have depends on the base below it, and so on the rule.
    """
    geometries = GeometrySet("held out", "angles that were not used", tuple(_unused(paint)))
    readings = measure(reflectance, geometries).readings
    original = np.array([reading.lab for reading in readings])
    found: dict[str, tuple[Paint, bool, tuple[HeldOutGeometry, ...], list[str]]] = {}
    refused: tuple[Paint, bool, list[str]] | None = None
    for rule in _RULES:
        candidate, used, notices = _with_gloss(replace(paint, interpolation=rule), estimate)
        try:
            design = build_paint(candidate)
        except SuiteError as error:
            refused = refused or (candidate, used, [*notices, f"The design cannot be drawn yet: {error}"])
            continue
        given = measure(design, geometries).lab
        rows = tuple(
            HeldOutGeometry(
                one.geometry.illumination_deg,
                one.geometry.aspecular_deg,
                one.lab,
                triple(two),
                float(delta),
                one.sample_deg,
            )
            for one, two, delta in zip(readings, given, delta_e_2000(original, given), strict=True)
        )
        found[rule] = (
            candidate,
            used,
            rows,
            [*notices, *design.notices, *interpolation_notices(candidate, design)],
        )
    if not found:
        assert refused is not None
        return refused[0], refused[1], (), refused[2]
    means = {rule: float(np.mean([row.delta_e_2000 for row in one[2]])) for rule, one in found.items()}
    first = next(iter(found))
    best = min(means, key=lambda rule: means[rule])
    if means[first] - means[best] < _WORTH_DELTA_E:
        best = first
    chosen, used, rows, notices = found[best]
    if best != first:
        notices = [
            *notices,
            f"Between the angles the {best} rule is used: it is nearer to the original (ΔE00 {means[best]:.1f} in "
            f"the mean) than the {first} rule ({means[first]:.1f}).",
        ]
    return chosen, used, rows, notices


def _unused(paint: Paint) -> list[Geometry]:
    """Angles from 15 to 110° under each light, but for those that were read."""
    used = {(m.illumination_deg, m.aspecular_deg) for m in paint.measurements}
    found = []
    for light in HELD_OUT_LIGHTS_DEG:
        for angle in np.arange(_HELD_OUT_FROM_DEG, _HELD_OUT_TO_DEG + _SAME_DEG, HELD_OUT_STEP_DEG).tolist():
            steep = abs(light - angle) > _MOST_VIEW_DEG
            if steep or any(
                abs(light - one) <= _SAME_DEG and abs(angle - two) <= _SAME_DEG for one, two in used
            ):
                continue
            found.append(Geometry(light, angle))
    return found
