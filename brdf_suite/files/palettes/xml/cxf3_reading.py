"""Reading CxF3 as a palette: paints where a sample was read at several angles, else flat colours."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from datetime import datetime

from brdf_suite.appearance.colour.flat_colours import flat_labs
from brdf_suite.documents.flat_colour import FlatColour, Model
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.palette import USAGES, Palette
from brdf_suite.documents.palette_store import flat_from_json
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.cxf import (
    NAMESPACE,
    SPECTRAL,
    TAGS,
    VERSION,
    SampleReader,
    average_repeated,
    read_spectrum,
)
from brdf_suite.files.cxf_specification import Specification, child_number, number, read_specifications
from brdf_suite.files.hardened_xml import Element, parse_xml
from brdf_suite.files.palettes.collecting import Collector
from brdf_suite.files.palettes.conversions import is_icc, labs_d50
from brdf_suite.files.palettes.sample_entries import sample_content, sample_fields
from brdf_suite.files.samples import AngleSample

GROUP, CODE, LABELS, USAGE, DATE, NOTES, FLAT = (
    "palette.group", "palette.code", "palette.tags", "palette.usage", "palette.date", "palette.notes", "palette.flat",
)  # fmt: skip
"""Of an entry."""

PALETTE, COLUMNS, COLOUR, GROUPS = "palette.name", "palette.columns", "palette.colour", "palette.groups"
"""Of the file, with ``palette.notes``."""

_UNCHANGED = 1e-6
_MOST_NAMED = 50
_NOT_READ = ("Emissive", "Transmittance")


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a CxF3 file; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    collector = Collector(path)
    root = parse_xml(content, path)
    if root.name != "CxF" or root.namespace != NAMESPACE:
        raise collector.fail(f"is not CxF3: its root is {root.name[:60]!r}", f"line {root.line}")
    resources = root.first("Resources")
    objects = resources.first("ObjectCollection") if resources else None
    info = root.first("FileInformation")
    about = {
        tag.attributes.get("Name", ""): tag.attributes.get("Value", "")
        for tag in (info.all("Tag") if info else [])
    }
    if resources is None or objects is None:
        collector.note("The file holds no sample.")
    else:
        elements = objects.all("Object")
        collector.check_count(len(elements), f"line {objects.line}")
        reader = _Reader(read_specifications(resources, path), collector)
        for name in _list(about.get(GROUPS, "")):
            collector.declare(f"line {root.line}", _list(name)[:32])
        reader.add(elements)
        reader.settle()
    description = info.first("Description") if info else None
    columns = about.get(COLUMNS, "")
    return collector.finish(
        about.get(PALETTE, "")
        or (description.text if description is not None and PALETTE not in about else ""),
        notes=collector.lines(about.get(NOTES, "")),
        columns=int(columns) if columns.isascii() and columns.isdecimal() and len(columns) < 5 else 0,
        colour=about.get(COLOUR, ""),
    )


def _list(text: str) -> list[str]:
    """Return the texts of a JSON list; empty for anything else."""
    try:
        found = json.loads(text)
    except (ValueError, RecursionError):
        return []
    return [item for item in found if isinstance(item, str)] if isinstance(found, list) else []


class _Reader:
    def __init__(self, specifications: Mapping[str, Specification], collector: Collector) -> None:
        self._specifications, self._collector = specifications, collector
        self._kept: list[tuple[int, FlatColour, tuple[float, ...]]] = []

    def settle(self) -> None:
        """Put back the flat colours that this program kept, unless another has changed the values since.

        All at once, since a conversion of one colour takes as long as that of thousands.
        """
        if not self._kept:
            return
        entries = self._collector.entries
        worked_out = labs_d50(flat_labs([own for _, own, _ in self._kept])).tolist()
        for (index, own, lab_read), lab in zip(self._kept, worked_out, strict=True):
            shown = next((c.values for c in (own, *own.others) if c.model == "Lab" and is_icc(c)), lab)
            if all(abs(a - b) < _UNCHANGED for a, b in zip(shown, lab_read, strict=True)):
                entries[index] = replace(entries[index], content=own)

    def add(self, elements: Sequence[Element]) -> None:
        """Add samples as entries, repeated measurements of one as one entry.

        Raises :class:`FileError`: one is damaged, and there is no other.
        """
        found: list[tuple[Element, AngleSample | None, Paint | FlatColour]] = []
        failed: list[FileError] = []
        for element in elements:
            try:
                found += self._read(element)
            except FileError as error:
                failed.append(error)
                name = self._collector.name(element.attributes.get("Name", ""))[:80]
                self._collector.note(
                    f"The sample {name!r} is left out: {error.reason} ({error.place})."
                    if len(failed) <= _MOST_NAMED
                    else "{n} more sample[|s] [is|are] left out."
                )
        if failed and not found:
            raise failed[0]
        several = [
            (index, sample)
            for index, (_, sample, content) in enumerate(found)
            if sample is not None and isinstance(content, Paint)
        ]
        means = {
            several[places[0]][0]: (mean, [several[place][0] for place in places[1:]])
            for places, mean in average_repeated([sample for _, sample in several])
        }
        others = {place for _, places in means.values() for place in places}
        for index, (element, sample, content) in enumerate(found):
            if index in others:
                continue
            mean, rest = means.get(index, (sample, []))
            if mean is not None and rest:
                content = sample_content(self._collector, mean, f"line {element.line}")
            self._add(element, mean, content)

    def _read(self, element: Element) -> list[tuple[Element, AngleSample | None, Paint | FlatColour]]:
        """Return a sample and its content; nothing where it has no value that can be used."""
        collector, place = self._collector, f"line {element.line}"
        sample_reader = SampleReader(element, self._specifications, collector.path)
        sample = sample_reader.read()
        refused = sample_reader.refused[:3]
        content: Paint | FlatColour | None
        try:
            content = (
                sample_content(collector, sample, place)
                if sample is not None
                else self._flat(element, named=bool(refused))
            )
        except FileError:
            if not sample_reader.failed:
                raise
            raise sample_reader.failed[0] from None
        for reason in refused:
            collector.note(f"{sample_reader.name}: {reason}.")
        if content is None:
            collector.note("{n} sample[|s] without a value that can be used [is|are] left out.")
            return []
        return [(element, sample, content)]

    def _add(self, element: Element, sample: AngleSample | None, content: Paint | FlatColour) -> None:
        collector, place = self._collector, f"line {element.line}"
        tags = {
            tag.attributes.get("Name", ""): tag.attributes.get("Value", "")
            for collection in element.all("TagCollection")
            if collection.attributes.get("Name") == TAGS
            for tag in collection.all("Tag")
        }
        if sample is not None and sample.measurements > 1:
            collector.note(
                f"{sample.name}: the mean of up to {sample.measurements} readings at an angle, which differ from it by "
                f"at most ΔE00 {sample.spread:.2f}."
            )
        paint = content if isinstance(content, Paint) else None
        if sample is not None and paint is not None:
            if sample.gloss is None:
                collector.note("{n} sample[ says|s say] nothing of gloss, and as a paint gets 90 GU at 20°.")
            for way in {reading.converted for reading in sample.readings if reading.converted}:
                collector.note(f"{{n}} sample[|s]: L*a*b* is {way}.")
        foreign = sample_fields(sample) if sample is not None and paint is not None else ()
        if paint is None:
            self._keep(content, tags.get(FLAT, ""))
        comment = element.first("Comment")
        date = element.first("CreationDate")
        collector.add(
            place,
            content,
            group=collector.declare(place, _list(tags.get(GROUP, ""))[:32]),
            code=collector.name(tags.get(CODE, ""), 200),
            tags=tuple(_list(tags.get(LABELS, ""))),
            notes=collector.lines(
                tags.get(NOTES, "") if paint is not None else comment.raw if comment is not None else ""
            ),
            usage=tags[USAGE] if tags.get(USAGE) in USAGES else "process",
            date=tags.get(DATE, "") if DATE in tags else _moment(date.text if date is not None else "", tags),
            foreign=foreign,
        )

    def _keep(self, content: Paint | FlatColour, own: str) -> None:
        """Keep the own numbers of the flat colour that is added next, for :meth:`settle`."""
        if not isinstance(content, FlatColour):
            return
        kept = _own_flat(own, content.name, self._collector.path) if own else None
        lab_read = next((c.values for c in (content, *content.others) if c.model == "Lab"), None)
        if kept is not None and lab_read is not None:
            self._kept.append((len(self._collector.entries), kept, lab_read))

    def _flat(self, element: Element, *, named: bool) -> FlatColour | None:
        """Return a sample as a flat colour; ``named`` where the values that are left out have been named already.

        Raises :class:`FileError`: none of its values can be used, and one is damaged.
        """
        collector = self._collector
        name = collector.name(element.attributes.get("Name", ""))
        colours: list[FlatColour] = []
        failed: list[FileError] = []
        for kind in ("ColorValues", "DeviceColorValues"):
            values = element.first(kind)
            for value in values.children if values else []:
                try:
                    colour = self._value(value)
                except FileError as error:
                    failed.append(error)
                    continue
                if colour is not None and len(colours) < 16:
                    colours.append(colour)
        if failed and not colours:
            raise failed[0]
        for why in failed[: 0 if named else 3]:
            collector.note(f"A value of {name[:80]!r} is left out: {why.reason} ({why.place}).")
        if not colours:
            return None
        colours.sort(key=lambda colour: colour.model != "spectrum")
        first = colours[0]
        return collector.colour(
            f"line {element.line}", name, first.model, first.values, space=first.space, illuminant=first.illuminant,
            observer_deg=first.observer_deg, wavelengths_nm=first.wavelengths_nm, others=tuple(colours[1:]),
        )  # fmt: skip

    def _value(self, value: Element) -> FlatColour | None:
        """Return one value of a sample as an unnamed colour; None for an unsupported kind."""
        path, place = self._collector.path, f"line {value.line}"
        specification = self._specifications.get(value.attributes.get("ColorSpecification", ""))
        if specification is not None and any(kind in specification.kind for kind in _NOT_READ):
            self._collector.note("{n} value[|s] that [is|are] of no reflectance [is|are] left out.")
            return None
        illuminant, observer = (
            (specification.illuminant or "", specification.observer or "") if specification else ("", "")
        )
        white = {
            "illuminant": self._collector.name(illuminant, 50),
            "observer_deg": {"2_Degree": 2, "10_Degree": 10}.get(observer, 0),
        }
        known: dict[str, tuple[Model, tuple[str, ...]]] = {
            "ColorCIELab": ("Lab", ("L", "A", "B")),
            "ColorCIELCh": ("LCh", ("L", "C", "H")),
            "ColorCIEXYZ": ("XYZ", ("X", "Y", "Z")),
            "ColorCMYK": ("CMYK", ("Cyan", "Magenta", "Yellow", "Black")),
            "ColorHSL": ("HSL", ("Hue", "Saturation", "Lightness")),
            "ColorSRGB": ("RGB", ("R", "G", "B")),
            "ColorAdobeRGB": ("RGB", ("R", "G", "B")),
            "ColorRGB": ("RGB", ("R", "G", "B")),
        }
        if value.name in SPECTRAL:
            return self._spectrum(value, specification)
        if value.name not in known:
            return None
        model, names = known[value.name]
        values = [child_number(value, name, path) for name in names]
        if model == "RGB":
            most = value.first("MaxRange")
            scale = 255.0 if most is None else number(most, most.text, path, "MaxRange")
            if scale <= 0.0:
                raise self._collector.fail("MaxRange must be greater than 0", place)
            space = {"ColorSRGB": "sRGB", "ColorAdobeRGB": "Adobe RGB (1998)"}.get(value.name, "")
            return self._collector.colour(place, "", model, [item / scale for item in values], space=space)
        if model == "CMYK":
            return self._collector.colour(place, "", model, [item / 100.0 for item in values])
        if model == "HSL":
            return self._collector.colour(place, "", model, [values[0], values[1] / 100.0, values[2] / 100.0])
        return self._collector.colour(place, "", model, values, **white)

    def _spectrum(self, value: Element, specification: Specification | None) -> FlatColour | None:
        if specification is None:
            self._collector.note("{n} [spectrum|spectra] without wavelengths [is|are] left out.")
            return None
        bands, values = read_spectrum(value, specification, self._collector.path)
        return self._collector.colour(f"line {value.line}", "", "spectrum", values, wavelengths_nm=bands)


def _moment(text: str, tags: Mapping[str, str]) -> str:
    """When a sample was made, where it says so; what this program wrote says it as a tag."""
    if VERSION in tags or FLAT in tags:
        return ""
    try:
        return datetime.fromisoformat(text).isoformat()
    except ValueError:
        return ""


def _own_flat(text: str, name: str, path: PathLike) -> FlatColour | None:
    """The flat colour as this program kept it, where it is of this sample."""
    try:
        own = flat_from_json(json.loads(text), path, FLAT)
    except (ValueError, RecursionError, FileError):
        return None
    return own if own.name == name else None
