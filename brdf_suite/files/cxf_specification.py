"""ColorSpecifications of a CxF3 file: illuminant, observer and angles of a value."""

from __future__ import annotations

import math
from dataclasses import dataclass

from brdf_suite.appearance.geometries import Geometry
from brdf_suite.errors import FileError, PathLike, ValueRangeError
from brdf_suite.files.hardened_xml import Element

_MOST_ANGLES = 100


@dataclass(frozen=True)
class BrdfAngle:
    """One BRDFAngle, degrees; ``azimuth_deg`` is 0 in the plane of incidence."""

    notation: str
    illumination_deg: float
    aspecular_deg: float
    azimuth_deg: float


@dataclass(frozen=True)
class Specification:
    """One ColorSpecification; ``angles`` is empty where it is not multi-angle."""

    name: str
    illuminant: str | None
    observer: str | None
    kind: str
    angles: tuple[BrdfAngle, ...]
    start_nm: float | None
    step_nm: float | None

    @property
    def is_d65_10(self) -> bool:
        """Whether its tristimulus values are those of D65 and the 10° observer."""
        return self.illuminant == "D65" and self.observer == "10_Degree"

    @property
    def light(self) -> str:
        """Illuminant and observer as text."""
        if self.illuminant is None:
            return "no stated illuminant"
        return f"{self.illuminant} and the {(self.observer or 'unknown').replace('_Degree', '°')} observer"

    def angle_of(self, value_name: str) -> BrdfAngle | None:
        """Return the angle of a value called ``value_name``, or None where the file does not say which it is.

        Where a specification lists several angles, a value belongs to the one whose notation is its name.
        """
        if len(self.angles) == 1:
            return self.angles[0]
        named = [angle for angle in self.angles if angle.notation and angle.notation == value_name]
        return named[0] if len(named) == 1 else None


def number(element: Element, text: str, path: PathLike, what: str) -> float:
    """Return the finite number ``text`` of ``element``; raise :class:`FileError` naming ``what`` and the line."""
    try:
        # Python also takes 1_000 and digits of other scripts, which XML Schema's double does not.
        value = float(text) if text.isascii() and "_" not in text else math.nan
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        shown = text if len(text) <= 40 else text[:37] + "..."
        raise FileError(path, f"expected a finite number for {what}, not {shown!r}", f"line {element.line}")
    return value


def child_number(element: Element, name: str, path: PathLike) -> float:
    """Return the number in the child ``name``, which must be there."""
    child = element.first(name)
    if child is None:
        raise FileError(path, f"{element.name} has no {name}", f"line {element.line}")
    return number(child, child.text, path, name)


def read_specifications(resources: Element, path: PathLike) -> dict[str, Specification]:
    """Return every ColorSpecification by its Id; raise :class:`FileError` with the line where one is damaged."""
    found: dict[str, Specification] = {}
    collection = resources.first("ColorSpecificationCollection")
    for element in collection.all("ColorSpecification") if collection else []:
        name = element.attributes.get("Id", "")
        if not name:
            raise FileError(path, "a ColorSpecification has no Id", f"line {element.line}")
        if name in found:
            raise FileError(path, f"two ColorSpecifications are called {name[:80]!r}", f"line {element.line}")
        found[name] = _specification(element, name, path)
    return found


def _specification(element: Element, name: str, path: PathLike) -> Specification:
    measurement = element.first("MeasurementSpec")
    kind = measurement.first("MeasurementType") if measurement else None
    bands = measurement.first("WavelengthRange") if measurement else None
    return Specification(
        name=name,
        illuminant=_text(element.first("TristimulusSpec", "Illuminant")),
        observer=_text(element.first("TristimulusSpec", "Observer")),
        kind=_text(kind) or "",
        angles=_angles(measurement.first("GeometryChoice", "MultiAngle"), path) if measurement else (),
        start_nm=_attribute(bands, "StartWL", path),
        step_nm=_attribute(bands, "Increment", path),
    )


def _text(element: Element | None) -> str | None:
    return element.text if element is not None else None


def _attribute(element: Element | None, name: str, path: PathLike) -> float | None:
    if element is None or name not in element.attributes:
        return None
    return number(element, element.attributes[name].strip(), path, name)


def _angles(multi: Element | None, path: PathLike) -> tuple[BrdfAngle, ...]:
    if multi is None:
        return ()
    elements = multi.all("BRDFAngle")
    if not 1 <= len(elements) <= _MOST_ANGLES:
        raise FileError(
            path,
            f"a MultiAngle has {len(elements)} angles; expected 1 to {_MOST_ANGLES}",
            f"line {multi.line}",
        )
    return tuple(_angle(element, path) for element in elements)


def _angle(element: Element, path: PathLike) -> BrdfAngle:
    azimuth = element.first("Azimuth")
    found = BrdfAngle(
        notation=element.attributes.get("Notation", "").strip(),
        illumination_deg=child_number(element, "IlluminationAngle", path),
        aspecular_deg=child_number(element, "Aspecular", path),
        azimuth_deg=0.0 if azimuth is None else number(azimuth, azimuth.text, path, "Azimuth"),
    )
    try:
        Geometry(found.illumination_deg, found.aspecular_deg)
    except ValueRangeError as error:
        raise FileError(path, error.reason, f"line {element.line}, {error.place}") from error
    return found
