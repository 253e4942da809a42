"""Measuring and comparing materials, and converting measured files."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import TypeAlias

import numpy as np

from brdf_suite.appearance.colour.spaces import in_display_gamut
from brdf_suite.appearance.difference.tolerance import (
    DIFFERENCES,
    Tolerances,
    Verdict,
    find_difference,
    judge,
)
from brdf_suite.appearance.difference.words import NamedDifference, name_differences, name_flop, sentence
from brdf_suite.appearance.geometries import DEFAULT_SET, GEOMETRY_SETS, GeometrySet
from brdf_suite.appearance.texture import NO_TEXTURE
from brdf_suite.errors import SuiteError
from brdf_suite.files.measured import read_measured, write_measured
from brdf_suite.files.measured.format import ReadOptions
from brdf_suite.fitting.metrics import ErrorFigures, value_errors
from brdf_suite.geometry.directions import angle_between, mirror
from brdf_suite.inspection.texture.readings import texture_of
from brdf_suite.pipeline.fit_errors import ANGLE_SET, NEAR_MIRROR_DEG, hemisphere_pairs
from brdf_suite.pipeline.material import file_kind, load_material
from brdf_suite.reflectance.instruments.aperture import POINT, Aperture
from brdf_suite.reflectance.instruments.spectrophotometer import InstrumentReport, Reading, measure
from brdf_suite.reflectance.instruments.under_light import metamerism, readings_under
from brdf_suite.reflectance.material import Material
from brdf_suite.reflectance.protocol import has_spectra
from brdf_suite.regular_files import exists, is_file

Cell: TypeAlias = str | float | None
"""What a column of a table of readings holds."""


def read_material(
    item: Material,
    geometries: GeometrySet = GEOMETRY_SETS[DEFAULT_SET],
    through: Aperture = POINT,
    *,
    texture: bool = True,
) -> InstrumentReport:
    """Return what spectrophotometer, glossmeter and texture instrument read; texture is zeros without flakes.

    Texture takes most of the time of a paint with flakes; with ``texture`` False it is not read, and is None.

    Raises :class:`FittingError`: its values are not finite, or no lobes can be fitted to it.
    """
    report = measure(item.reflectance, geometries, through)
    return replace(report, texture=texture_of(item)) if texture else report


def measurement_json(item: Material, report: InstrumentReport, illuminant: str = "D65") -> dict[str, object]:
    """Return a report as plain values: degrees, gloss units, L*a*b* of D65 and 10° unless said otherwise."""
    flop, path = report.flop, report.travel
    answer: dict[str, object] = {
        "name": item.name,
        "source": item.origin,
        "facts": {key: _plain(value) for key, value in item.facts.items() if key != "notes"},
        "illuminant": "D65",
        "observer_deg": 10,
        "spectra_observer_deg": item.observer_deg if has_spectra(item.reflectance) else None,
        "geometry": report.geometry_set.name,
        "geometry_title": report.geometry_set.title,
        "aperture": {
            "name": report.aperture.name,
            "light_half_angle_deg": report.aperture.light_deg,
            "receptor_half_angle_deg": report.aperture.receptor_deg,
        },
        "readings": [_reading_json(reading) for reading in report.readings],
        "gloss": {f"gu_{angle}": value for angle, value in report.gloss.items()},
        "gloss_nearest_sample_deg": {f"gu_{angle}": deg for angle, deg in report.gloss_sample_deg.items()},
        "gloss_supported": {f"gu_{angle}": report.gloss_supported(angle) for angle in report.gloss},
        "haze": report.haze,
        "flop_index": None if flop is None or not math.isfinite(flop.value) else flop.value,
        "travel": None if path is None else {k: v for k, v in asdict(path).items() if k != "notice"},
        "texture": None if report.texture is None else report.texture.to_json(),
        "notices": [*item.notices, *report.notices],
    }
    if illuminant != "D65":
        colours = readings_under(item.reflectance, report, illuminant, item.observer_deg)
        answer["under"] = {
            "illuminant": illuminant,
            "label": colours[0].label,
            "recomputed": colours[0].road == "recomputed",
            "readings": [
                {"geometry": reading.geometry.name, "xyz": colour.xyz.tolist(), "lab": colour.lab.tolist()}
                for reading, colour in zip(report.readings, colours, strict=True)
            ],
        }
    return answer


def measured_row(item: Material, report: InstrumentReport, illuminant: str = "D65") -> dict[str, Cell]:
    """Return a report as one row of a table, rounded: by columns, the same ones for every material.

    Columns of the usual light are named by the aspecular angle alone; what is not known is None.
    """
    names = [reading.geometry.name.removeprefix("45as") for reading in report.readings]
    path = report.travel
    row: dict[str, Cell] = {"name": item.name, "source": item.origin}
    for name, reading in zip(names, report.readings, strict=True):
        row |= {f"{axis}_{name}": round(value, 4) for axis, value in zip("Lab", reading.lab, strict=True)}
    if illuminant != "D65":
        colours = readings_under(item.reflectance, report, illuminant, item.observer_deg)
        for name, colour in zip(names, colours, strict=True):
            lab = zip("Lab", colour.lab.tolist(), strict=True)
            row |= {f"{axis}_{name}_{illuminant}": round(value, 4) for axis, value in lab}
    row |= {f"factor_{name}": round(one.factor, 6) for name, one in zip(names, report.readings, strict=True)}
    row |= {f"G{angle}": round(value, 3) for angle, value in report.gloss.items()}
    row["haze"] = round(report.haze, 3)
    row["flop_index"] = None if report.flop is None else round(report.flop.value, 4)
    travel = (None,) * 3 if path is None else (path.length, path.hue_deg, path.chroma)
    for column, value in zip(("travel_ab", "hue_travel_deg", "chroma_travel"), travel, strict=True):
        row[column] = None if value is None else round(value, 4)
    texture = report.texture or NO_TEXTURE
    seen = {
        f"sparkle_{part}_{one.light_deg:g}": value
        for one in texture.sparkle
        for part, value in asdict(one).items()
        if part != "light_deg"
    }
    for column, value in (seen | {"graininess": texture.graininess}).items():
        row[column] = None if report.texture is None else float(f"{value:.5g}")
    support = {name: one.sample_deg for name, one in zip(names, report.readings, strict=True)}
    support |= {f"G{angle}": value for angle, value in report.gloss_sample_deg.items()}
    return row | {f"nearest_sample_deg_{name}": round(value, 2) for name, value in support.items()}


def _plain(value: object) -> object:
    """A fact as JSON holds it; anything else than a number, a text or nothing by its words."""
    known = value is None or isinstance(value, (bool, int, str))
    return value if known or (isinstance(value, float) and math.isfinite(value)) else str(value)


def _reading_json(reading: Reading) -> dict[str, object]:
    geometry = reading.geometry
    return {
        "geometry": geometry.name,
        "illumination_deg": geometry.illumination_deg,
        "aspecular_deg": geometry.aspecular_deg,
        "view_deg": geometry.view_deg,
        "xyz": list(reading.xyz),
        "lab": list(reading.lab),
        "lch": list(reading.lch),
        "rho": list(reading.rho),
        "reflectance_factor": reading.factor,
        "nearest_sample_deg": reading.sample_deg,
        "supported": reading.supported,
        "in_srgb": bool(in_display_gamut(reading.lab)),
        "in_display_p3": bool(in_display_gamut(reading.lab, "Display P3")),
    }


@dataclass(frozen=True)
class Comparison:
    """Two reflectances side by side: ΔE per geometry by every formula, and errors over all directions.

    ``away`` leaves out views within 5° of the light's mirror direction, where a clearcoat's lobe outweighs
    everything else. ``metamerism`` is ΔE*ab per geometry and test light, where both know their spectra.
    """

    first: InstrumentReport
    second: InstrumentReport
    differences: Mapping[str, tuple[float, ...]]
    figures: ErrorFigures
    away: ErrorFigures
    verdict: Verdict | None
    metamerism: Mapping[str, tuple[float, ...]] | None

    @property
    def words(self) -> tuple[tuple[NamedDifference, ...], ...]:
        """The trade's words for the second against the first, per geometry."""
        pairs = zip(self.first.readings, self.second.readings, strict=True)
        return tuple(name_differences(one.lab, two.lab) for one, two in pairs)

    @property
    def sentence(self) -> str:
        """All geometries in words: ``darker at 110°; more flop``."""
        flops = self.first.flop, self.second.flop
        word = None if flops[0] is None or flops[1] is None else name_flop(flops[0].value, flops[1].value)
        return sentence([reading.geometry.label for reading in self.first.readings], self.words, word)

    def to_json(self) -> dict[str, object]:
        """Return the comparison as plain values, as JSON holds them; angles in degrees.

        >>> import brdf_suite as bs
        >>> bs.compare("blue", "blue").to_json()["geometry"]
        'six'
        """
        rows: list[dict[str, object]] = []
        words = self.words
        for k, (one, two) in enumerate(zip(self.first.readings, self.second.readings, strict=True)):
            rows.append(
                {
                    "geometry": one.geometry.name,
                    "illumination_deg": one.geometry.illumination_deg,
                    "aspecular_deg": one.geometry.aspecular_deg,
                    "lab_a": list(one.lab),
                    "lab_b": list(two.lab),
                    "supported_a": one.supported,
                    "supported_b": two.supported,
                    **{f"delta_e_{name}": values[k] for name, values in self.differences.items()},
                    "words": [named.text() for named in words[k]],
                }
            )
        answer: dict[str, object] = {
            "geometry": self.first.geometry_set.name,
            "angles": rows,
            "words": self.sentence,
            "gloss_difference": {
                f"gu_{angle}": self.second.gloss[angle] - value for angle, value in self.first.gloss.items()
            },
            "angle_set": ANGLE_SET,
            **asdict(self.figures),
            "away_from_mirror": {"left_out_deg": NEAR_MIRROR_DEG, **asdict(self.away)},
        }
        if self.metamerism is not None:
            answer["metamerism_index"] = {light: list(values) for light, values in self.metamerism.items()}
        if self.verdict is not None:
            answer["verdict"] = {
                "difference": self.verdict.difference,
                "passes": self.verdict.passes,
                "angles": [asdict(row) for row in self.verdict.angles],
            }
        return answer


def compare(
    first: Material,
    second: Material,
    geometry_set: GeometrySet = GEOMETRY_SETS[DEFAULT_SET],
    aperture: Aperture = POINT,
    tolerances: Tolerances | None = None,
) -> Comparison:
    """Return how ``second`` differs from ``first``, the reference."""
    one, two = (measure(item.reflectance, geometry_set, aperture) for item in (first, second))
    differences = {name: tuple(formula(one.lab, two.lab).tolist()) for name, formula in DIFFERENCES.items()}
    if tolerances is not None and tolerances.difference not in DIFFERENCES:
        own = find_difference(tolerances.difference)
        differences[tolerances.difference] = tuple(own(one.lab, two.lab).tolist())
    wi, wo, weight = hemisphere_pairs()
    wanted, given = (np.asarray(item.reflectance.eval(wi, wo)) for item in (first, second))
    near = angle_between(mirror(wi), wo) < math.radians(NEAR_MIRROR_DEG)
    angles = [geometry.aspecular_deg for geometry in geometry_set.geometries]
    lights = None
    if has_spectra(first.reflectance) and has_spectra(second.reflectance):
        known = (first.reflectance, second.reflectance)
        lights = {
            light: tuple(
                metamerism(*known, geometry, aperture, light) for geometry in geometry_set.geometries
            )
            for light in ("A", "F11")
        }
    return Comparison(
        one,
        two,
        differences,
        value_errors(wanted, given, wi, weight),
        value_errors(wanted, given, wi, np.where(near, 0.0, weight)),
        None if tolerances is None else judge(angles, one.lab, two.lab, tolerances),
        lights,
    )


@dataclass(frozen=True)
class Conversion:
    """What a conversion did."""

    source: Path
    target: Path
    format: str
    facts: Mapping[str, object]
    #: what the target's format could not hold, each a clause for the user
    notes: tuple[str, ...] = ()


def convert(
    source: str | os.PathLike[str],
    target: str | os.PathLike[str],
    *,
    observer_deg: int = 10,
    scale_factors: bool | None = None,
    average_reciprocal: bool = False,
    format_name: str | None = None,
) -> Conversion:
    """Read a measured file, or take a paint, and write it in the format named, or that the target's ending names.

    A paint (a ``.brdfpaint``, or a shipped or Table 1 name) is tabulated by formats that hold tables.
    ``scale_factors`` and ``average_reciprocal`` say how MERL tables are read, as
    :class:`~brdf_suite.files.measured.ReadOptions` has them.

    Raises :class:`SuiteError`: one of the files cannot be read or written, or the target's format cannot hold the data.
    """
    read_from, write_to = Path(source), Path(target)
    if exists(write_to) and exists(read_from) and write_to.samefile(read_from):
        raise SuiteError(f"{write_to}: the target is the source itself; name another file.")
    options = ReadOptions(
        observer_deg=observer_deg, scale_factors=scale_factors, average_reciprocal=average_reciprocal
    )
    if is_file(source) and file_kind(source) == "measured":
        value = read_measured(read_from, options=options)
        written = write_measured(value, write_to, format_name or "")
        return Conversion(read_from, write_to, written.format.name, dict(value.facts), written.notes)
    item = load_material(source)
    written = write_measured(item.reflectance, write_to, format_name or "")
    notices = (*item.notices, *written.notes)
    return Conversion(read_from, write_to, written.format.name, {"name": item.name}, notices)
