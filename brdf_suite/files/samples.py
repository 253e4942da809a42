"""Samples read at several angles by an instrument, as every file of such readings gives them: CxF3, tables, XML."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field

from brdf_suite.appearance.geometries import Geometry
from brdf_suite.documents.paint import Gloss, Lab, Paint
from brdf_suite.errors import ValueRangeError
from brdf_suite.files.paint_fields import Setting, build_paint

UNKNOWN_GLOSS = Gloss(90.0)
"""What stands in where a file says nothing of gloss: a usual clearcoat."""

SAME_SAMPLE_DE = 3.0
"""Measurements of one sample that lie farther than this from their mean, ΔE00, are of different samples."""

_NAME, _NOTES = 200, 100_000
_CONTROL = re.compile(r"[\x00-\x1f\x7f-\x9f\ud800-\udfff]+")
_CONTROL_IN_LINES = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\ud800-\udfff]+")


@dataclass(frozen=True)
class SampleReading:
    """One colour at one geometry.

    ``lab`` is of D65 and the 10° observer; ``converted`` says how it was found where the file has it in another
    form, else it is empty. ``wavelengths_nm`` and ``reflectance`` (1 is a perfect diffuser) are there where the file
    has the spectrum.
    """

    illumination_deg: float
    aspecular_deg: float
    lab: Lab
    converted: str = ""
    wavelengths_nm: tuple[float, ...] | None = None
    reflectance: tuple[float, ...] | None = None

    @property
    def geometry(self) -> str:
        """The trade's short name of the geometry, as in ``45as15``."""
        return Geometry(self.illumination_deg, self.aspecular_deg).name


@dataclass(frozen=True)
class AngleSample:
    """A sample with at least one reading at a multi-angle geometry.

    ``kind`` is the file's own word (Standard, Sample, Target …); ``gloss`` is None where the file does not state it.
    ``texture`` is what this suite's texture instrument read, by the names of ``TextureReadings.by_name``: those that
    the file has as tags.
    ``settings`` are further fields of a paint, flakes among them, that this suite wrote as tags.
    ``effects`` are sparkle and graininess as another maker's instrument read them, on its own scale.
    ``measurements`` is of how many the readings are the mean, and ``spread`` the largest ΔE00 of one from it.
    """

    name: str
    kind: str
    readings: tuple[SampleReading, ...]
    gloss: Gloss | None = None
    notes: str = ""
    source: str = ""
    settings: Mapping[str, Setting] = field(default_factory=dict)
    version: int | None = None
    texture: Mapping[str, float] = field(default_factory=dict)
    effects: Mapping[str, float] = field(default_factory=dict)
    measurements: int = 1
    spread: float = 0.0

    def paint(self, gloss: Gloss = UNKNOWN_GLOSS) -> Paint:
        """Return the sample as a paint that can be designed further; ``gloss`` where the file has none.

        Raises
        ------
        ValueRangeError
            There are fewer than three readings.
        DocumentError
            One is out of a paint's range, or a setting is; ``place`` names the field.
        """
        if len(self.readings) < 3:
            raise ValueRangeError(
                self.name, f"a paint needs readings at 3 angles at least, there are {len(self.readings)}"
            )
        return build_paint(
            plain_name(self.name, "unnamed"),
            [(r.illumination_deg, r.aspecular_deg, r.lab) for r in self.readings],
            self.gloss or gloss,
            self.settings,
            _CONTROL_IN_LINES.sub(" ", self.notes)[:_NOTES],
            self.source,
            path=self.name,
            version=self.version,
        )


@dataclass(frozen=True)
class SampleFile:
    """The multi-angle samples of a file, in its order.

    ``notes`` say what was converted or assumed; ``refused`` which samples are left out, and why.
    """

    samples: tuple[AngleSample, ...]
    notes: tuple[str, ...] = ()
    refused: tuple[str, ...] = ()


def plain_name(name: str, otherwise: str) -> str:
    """Return ``name`` as a paint can have it: on one line, at most 200 characters, not empty."""
    short = " ".join(_CONTROL.sub(" ", name).split())[:_NAME].strip()
    return short or otherwise


def effect_notes(effects: Mapping[str, float]) -> str:
    """Return sparkle and graininess as a line of notes; empty where there is none."""
    if not effects:
        return ""
    return "Instrument's readings: " + ", ".join(f"{what} {value:g}" for what, value in effects.items()) + "."
