"""CxF3 (ISO 17972-1): the multi-angle samples of a file, as standards and as paints.

What is read of a sample, in this order: L*a*b*, LCh or XYZ of D65 and the 10° observer as they stand; else the
reflectance spectrum, from which L*a*b* follows exactly. Tristimulus values of another light or observer are refused:
without the spectrum the sample's colour under D65 is unknown, and an adaptation would only be a guess.

A value belongs to the one angle of its ColorSpecification; where that lists several, to the one whose notation is the
value's name. A value that is damaged or out of range is left out with its line, and so is a sample of which something
else is; a file that is no XML, or of which nothing is left, is refused. Samples of other programs that have one name
and kind are averaged where they agree, as those of tables are.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np

from brdf_suite.appearance.colour.colorimetry import xyz_to_lab
from brdf_suite.appearance.colour.spaces import lch_to_lab
from brdf_suite.appearance.colour.spectra import spectrum_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.appearance.texture import NO_TEXTURE, SCALE
from brdf_suite.documents.paint import PARAMETERS, Gloss, Lab
from brdf_suite.errors import FileError, PathLike, ValueRangeError
from brdf_suite.files.bounded_reading import MOST_BANDS
from brdf_suite.files.cxf_specification import (
    BrdfAngle,
    Specification,
    child_number,
    number,
    read_specifications,
)
from brdf_suite.files.hardened_xml import MOST_BYTES, Element, parse_xml
from brdf_suite.files.paint_fields import setting_from_text
from brdf_suite.files.samples import (
    SAME_SAMPLE_DE,
    AngleSample,
    SampleFile,
    SampleReading,
    effect_notes,
    plain_name,
)
from brdf_suite.files.tables.columns import EFFECTS, angle_text, interpret
from brdf_suite.files.tables.grid import parse_number
from brdf_suite.files.tables.readings import average
from brdf_suite.regular_files import read_bytes, within_memory

NAMESPACE = "http://colorexchangeformat.com/CxF3-core"
TAGS = "BRDF Suite"
"""The name of the TagCollection in which this suite keeps the fields of a paint that CxF3 has no place for."""
INSTRUMENT = "Instrument"
"""The name of the TagCollection with sparkle and graininess as another maker's instrument read them."""
SETTING = "setting."
"""Goes before the names of settings among the tags, as in ``setting.flakes.size_um``."""
TEXTURE = "texture."
"""Goes before the names of readings of the texture instrument, as in ``texture.sparkle_15.grade``."""
UNNAMED = "unnamed"
"""The name of a sample that has neither a name nor an identity."""
VERSION = "paint version"
SOURCE = "source"

_IN_PLANE_DEG = 1e-6
_COLOURS = ("ColorCIELab", "ColorCIELCh", "ColorCIEXYZ")
SPECTRAL = ("ReflectanceSpectrum", "CustomSpectrum")
_OTHER_KINDS = ("Emissive", "Transmittance")
_MOST_MEAN = 12.0
"""Of a spectrum: brighter than L* 250, as per cent in the place of factors are."""
_GLOSS = re.compile(r"\b(20|60)\b")

Spectrum = tuple[tuple[float, ...], tuple[float, ...]]
"""Wavelengths, nm, and reflectance factors."""


def is_cxf(head: bytes) -> bool:
    """Return whether the first bytes of a file are those of CxF3, whatever its prefix."""
    return NAMESPACE.encode("ascii") in head or NAMESPACE.encode("utf-16-le") in head


@within_memory
def read_cxf(path: PathLike) -> SampleFile:
    """Return the multi-angle samples of a CxF3 file.

    Raises
    ------
    FileError
        It cannot be read, is not valid, or has no sample at a multi-angle geometry that can be used; with the line.
    """
    root = parse_xml(read_bytes(path, MOST_BYTES), path)
    if root.name != "CxF" or root.namespace != NAMESPACE:
        raise FileError(path, f"is not CxF3: its root is {root.name[:60]!r}", f"line {root.line}")
    resources = root.first("Resources")
    objects = resources.first("ObjectCollection") if resources else None
    if resources is None or objects is None:
        raise FileError(path, "holds no sample", f"line {root.line}")
    specifications = read_specifications(resources, path)
    samples: list[AngleSample] = []
    refused: list[str] = []
    failed: list[FileError] = []
    others = 0
    for element in objects.all("Object"):
        reader = SampleReader(element, specifications, path)
        try:
            sample = reader.read()
        except FileError as error:
            failed.append(error)
            refused.append(f"{reader.name}: the sample is left out: {error.reason} ({error.place})")
            continue
        if sample is not None:
            samples.append(sample)
            refused += [f"{sample.name}: {reason}" for reason in reader.refused]
        elif reader.refused:
            refused += [f"{reader.name}: {reason}" for reason in reader.refused]
        else:
            others += 1
    if not samples:
        if failed:
            raise failed[0]
        why = f" ({refused[0]})" if refused else ""
        raise FileError(path, f"holds no sample read at several angles that can be used{why}")
    if others:
        refused.append(f"{others} samples that were not read by a multi-angle instrument are left out")
    samples = [sample for _, sample in average_repeated(samples)]
    return SampleFile(tuple(samples), _notes(samples), tuple(refused))


def average_repeated(samples: Sequence[AngleSample]) -> list[tuple[list[int], AngleSample]]:
    """Return samples, those averaged that were measured repeatedly, each with the places of those it is the mean of.

    These have one name and kind, and differ by no more than :data:`SAME_SAMPLE_DE`. Samples without a name, that this
    suite wrote, or that are means already stay as they are.
    """
    groups: dict[tuple[str, str] | int, list[int]] = {}
    for place, sample in enumerate(samples):
        repeated = sample.name != UNNAMED and sample.version is None and sample.measurements == 1
        groups.setdefault((sample.name, sample.kind) if repeated else place, []).append(place)
    found = []
    for places in groups.values():
        group = [samples[place] for place in places]
        mean = average(group) if len(group) > 1 else None
        found += [(places, mean)] if mean is not None else [([place], samples[place]) for place in places]
    return sorted(found, key=lambda pair: pair[0][0])


def _notes(samples: list[AngleSample]) -> tuple[str, ...]:
    notes = []
    ways = {reading.converted for sample in samples for reading in sample.readings if reading.converted}
    for way in sorted(ways):
        count = sum(any(r.converted == way for r in sample.readings) for sample in samples)
        notes.append(f"{count} of {len(samples)} samples: L*a*b* is {way}.")
    notes += [
        f"“{sample.name}” is the mean of up to {sample.measurements} readings at an angle; they differ from it by at "
        f"most ΔE00 {sample.spread:.2f}."
        for sample in samples
        if sample.measurements > 1
    ]
    if any(sample.effects for sample in samples):
        notes.append("Sparkle and graininess are on the instrument's own scale; they are kept as notes.")
    without = sum(sample.gloss is None for sample in samples)
    if without:
        notes.append(
            f"{without} of {len(samples)} samples say nothing of gloss; as paints they get 90 GU at 20°."
        )
    return tuple(notes)


class SampleReader:
    """Reader of one Object with multi-angle values; ``refused`` collects the unusable parts, ``failed`` the damaged."""

    def __init__(self, element: Element, specifications: Mapping[str, Specification], path: PathLike) -> None:
        self._element, self._specifications, self._path = element, specifications, path
        identity = element.attributes.get("Id", "")
        self.name = plain_name(element.attributes.get("Name", ""), identity[:200] or UNNAMED)
        self.refused: list[str] = []
        self.failed: list[FileError] = []
        self.measurements, self.spread = 1, 0.0

    def read(self) -> AngleSample | None:
        """Return the sample, or None where it has no reading at a multi-angle geometry."""
        colours: dict[tuple[float, float], tuple[Lab, str]] = {}
        repeated: dict[tuple[float, float], list[Lab]] = {}
        spectra: dict[tuple[float, float], list[Spectrum]] = {}
        unusable: dict[tuple[float, float], str] = {}
        values = self._element.first("ColorValues")
        for value in values.children if values else []:
            if value.name not in _COLOURS + SPECTRAL:
                continue
            identity = value.attributes.get("ColorSpecification", "")
            if identity not in self._specifications:
                error = self._fail(value, f"the ColorSpecification {identity[:80]!r} is not in the file")
                self.failed.append(error)
                self.refused.append(f"a reading is left out: {error.reason} ({error.place})")
                continue
            specification = self._specifications[identity]
            if not specification.angles or any(kind in specification.kind for kind in _OTHER_KINDS):
                continue
            angle = self._angle_of(value, specification)
            if angle is None:
                continue
            key = (angle.illumination_deg, angle.aspecular_deg)
            if value.name in SPECTRAL:
                try:
                    found = read_spectrum(value, specification, self._path)
                    self._check(value, _lab_of(found[1], found[0]))
                except FileError as error:
                    self.failed.append(error)
                    self.refused.append(f"a spectrum is left out: {error.reason} ({error.place})")
                else:
                    spectra.setdefault(key, []).append(found)
            elif not specification.is_d65_10:
                unusable[key] = specification.light
            else:
                try:
                    self._take(colours, repeated, key, value)
                except FileError as error:
                    self.failed.append(error)
                    self.refused.append(f"a colour is left out: {error.reason} ({error.place})")
        averaged = {key: _mean_spectrum(found) for key, found in spectra.items()}
        for key, (bands, reflectance) in averaged.items():
            if key not in colours:
                colours[key] = (_lab_of(reflectance, bands), "recomputed from the spectrum")
                repeated[key] = [_lab_of(row, own) for own, row in spectra[key]]
        self._average(colours, repeated)
        for (light, aspecular), why in unusable.items():
            if (light, aspecular) not in colours:
                self.refused.append(
                    f"the colour at {light:g}as{aspecular:g} is of {why}, and without a spectrum it cannot become "
                    "that of D65 and 10°"
                )
        if not colours:
            return None
        readings = tuple(
            SampleReading(*key, lab, how, *averaged.get(key, (None, None)))
            for key, (lab, how) in colours.items()
        )
        return self._sample(readings)

    def _fail(self, element: Element, reason: str) -> FileError:
        return FileError(self._path, reason, f"line {element.line}")

    def _angle_of(self, value: Element, specification: Specification) -> BrdfAngle | None:
        angle = specification.angle_of(value.attributes.get("Name", "").strip())
        if angle is None:
            reason = (
                f"{specification.name[:80]} lists {len(specification.angles)} angles, and no name says which of them "
                f"the value of line {value.line} was read at"
            )
        elif abs(angle.azimuth_deg) > _IN_PLANE_DEG:
            reason = (
                f"{angle.notation or 'a reading'} is out of the plane of incidence ({angle.azimuth_deg:g}°)"
            )
            angle = None
        else:
            return angle
        if reason not in self.refused:
            self.refused.append(reason)
        return None

    def _take(
        self,
        colours: dict[tuple[float, float], tuple[Lab, str]],
        repeated: dict[tuple[float, float], list[Lab]],
        key: tuple[float, float],
        value: Element,
    ) -> None:
        names = {"ColorCIELab": "LAB", "ColorCIELCh": "LCH", "ColorCIEXYZ": "XYZ"}[value.name]
        how = {"LAB": "", "LCH": "from LCh", "XYZ": "from XYZ"}[names]
        found = [child_number(value, name, self._path) for name in names]
        if how:
            found = (lch_to_lab(found) if names == "LCH" else xyz_to_lab(found)).tolist()
        lab: Lab = (found[0], found[1], found[2])
        self._check(value, lab)
        before = colours.get(key)
        if before is not None and before[1] == how:
            repeated[key].append(lab)
        # L*a*b* itself is nearest to what was measured; what was made of it counts less.
        elif before is None or (before[1] and not how):
            colours[key] = (lab, how)
            repeated[key] = [lab]

    def _check(self, value: Element, lab: Lab) -> None:
        """Raise :class:`FileError` where a colour is beyond a paint's range."""
        for place, number_ in zip(("lab[0]", "lab[1]", "lab[2]"), lab, strict=True):
            try:
                PARAMETERS[place].check(number_, PARAMETERS[place].label)
            except ValueRangeError as error:
                raise self._fail(value, str(error).rstrip(".")) from error

    def _average(
        self,
        colours: dict[tuple[float, float], tuple[Lab, str]],
        repeated: Mapping[tuple[float, float], Sequence[Lab]],
    ) -> None:
        """Put the means of repeated readings in their place; raise :class:`FileError` where they disagree."""
        for key, labs in repeated.items():
            if len(labs) < 2:
                continue
            lightness, a, b = np.mean(labs, axis=0).tolist()
            spread = float(np.max(delta_e_2000(np.array(labs), np.array([lightness, a, b]))))
            if spread > SAME_SAMPLE_DE:
                reason = f"a second, different colour at {key[0]:g}as{key[1]:g} (ΔE00 {spread:.1f} from their mean)"
                raise self._fail(self._element, reason)
            colours[key] = ((lightness, a, b), colours[key][1])
            self.measurements = max(self.measurements, len(labs))
            self.spread = max(self.spread, spread)

    def _sample(self, readings: tuple[SampleReading, ...]) -> AngleSample:
        element = self._element
        comment = element.first("Comment")
        tags = {
            tag.attributes.get("Name", ""): (tag, tag.attributes.get("Value", ""))
            for collection in element.all("TagCollection")
            if collection.attributes.get("Name") == TAGS
            for tag in collection.all("Tag")
        }
        effects = self._effects()
        lines = [comment.raw] if comment is not None and comment.raw else []
        if (said := effect_notes(effects)) and not any(said in line for line in lines):
            lines.append(said)
        return AngleSample(
            name=self.name,
            kind=element.attributes.get("ObjectType", ""),
            readings=readings,
            gloss=self._gloss(),
            notes="\n".join(lines),
            source=tags[SOURCE][1] if SOURCE in tags else "",
            settings={
                name.removeprefix(SETTING): setting_from_text(text)
                for name, (_, text) in tags.items()
                if name.startswith(SETTING)
            },
            version=round(number(*tags[VERSION], self._path, VERSION)) if VERSION in tags else None,
            texture=self._texture(tags),
            effects=effects,
            measurements=self.measurements,
            spread=self.spread,
        )

    def _effects(self) -> dict[str, float]:
        """Return sparkle and graininess that another maker's instrument wrote as tags, by their names there."""
        found: dict[str, float] = {}
        for collection in self._element.all("TagCollection"):
            for tag in collection.all("Tag") if collection.attributes.get("Name") != TAGS else []:
                column = interpret([tag.attributes.get("Name", "")])[0]
                value = parse_number(tag.attributes.get("Value", ""))
                if column.what in EFFECTS.values() and value is not None:
                    found.setdefault(column.what + angle_text(column.geometry), value)
        return found

    def _texture(self, tags: Mapping[str, tuple[Element, str]]) -> dict[str, float]:
        """Return readings of the same scale as the instrument's; others could not be compared with its."""
        names = [name for name in NO_TEXTURE.by_name() if TEXTURE + name in tags]
        _, scale = tags.get(TEXTURE + "scale", (None, ""))
        if scale != SCALE:
            if scale or names:
                named = f"on the scale {scale[:80]!r}" if scale else "on a scale that is not named"
                self.refused.append(f"the texture is {named}, not {SCALE!r}")
            return {}
        found: dict[str, float] = {}
        for name in names:
            element, text = tags[TEXTURE + name]
            found[name] = number(element, text, self._path, TEXTURE + name)
            if found[name] < 0.0:
                raise self._fail(element, f"{TEXTURE}{name} must not be negative, is {found[name]:g}")
        return found

    def _gloss(self) -> Gloss | None:
        found: dict[str, float] = {}
        attributes = self._element.first("PhysicalAttributes")
        for gloss in attributes.all("Gloss") if attributes else []:
            angle = _GLOSS.search(gloss.attributes.get("Method", ""))
            if angle is not None:
                found[angle[1]] = number(gloss, gloss.text, self._path, "Gloss")
        if "20" not in found:
            return None
        try:
            return Gloss(found["20"], found.get("60"))
        except ValueRangeError as error:
            raise self._fail(self._element, str(error).rstrip(".")) from error


def read_spectrum(value: Element, specification: Specification, path: PathLike) -> Spectrum:
    """Return the wavelengths, nm, and reflectance factors of a spectrum; raise :class:`FileError` with the line."""

    def fail(reason: str) -> FileError:
        return FileError(path, reason, f"line {value.line}")

    if value.name == "CustomSpectrum":
        points = value.all("SpectralPoint")
        bands = [number(p, p.attributes.get("WL", ""), path, "WL") for p in points]
        reflectance = [number(p, p.text, path, "a SpectralPoint") for p in points]
    else:
        start = value.attributes.get("StartWL")
        first = specification.start_nm if start is None else number(value, start.strip(), path, "StartWL")
        words = value.text.split()
        if first is None or not specification.step_nm or specification.step_nm <= 0.0:
            raise fail(f"neither it nor {specification.name[:80]} says at which wavelengths it was read")
        step = specification.step_nm
        reflectance = [number(value, word, path, "a reflectance") for word in words[: MOST_BANDS + 1]]
        bands = [first + step * index for index in range(len(reflectance))]
    if not 2 <= len(bands) <= MOST_BANDS:
        raise fail(f"expected a spectrum of 2 to {MOST_BANDS} bands, not {len(bands)}")
    if bands[0] < 100.0 or bands[-1] > 10_000.0 or any(b <= a for a, b in pairwise(bands)):
        raise fail("the wavelengths of a spectrum must rise, from 100 to 10,000 nm")
    if not all(-1.0 <= value <= 100.0 for value in reflectance) or sum(reflectance) > _MOST_MEAN * len(
        reflectance
    ):
        raise fail(
            "the values of a spectrum are beyond any reflectance factor; 1 is that of a perfect diffuser"
        )
    return tuple(bands), tuple(reflectance)


def _mean_spectrum(found: Sequence[Spectrum]) -> Spectrum:
    """Return the mean of spectra at the same wavelengths; of others the first."""
    bands, first = found[0]
    rows = [row for own, row in found if own == bands]
    return bands, tuple(np.mean(rows, axis=0).tolist()) if len(rows) > 1 else first


def _lab_of(reflectance: Sequence[float], bands: Sequence[float]) -> Lab:
    lightness, a, b = spectrum_to_lab(np.array(reflectance), np.array(bands)).tolist()
    return lightness, a, b
