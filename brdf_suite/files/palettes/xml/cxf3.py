"""CxF3 (ISO 17972-1): samples as paints where they were read at several angles, else as flat colours.

A flat colour keeps every number of the sample: spectrum, Lab, LCh, XYZ, RGB, CMYK; the spectrum comes first where there
is one, since the colour follows from it exactly. Written are, for each entry, an Object with values that every program
reads, and what CxF3 has no place for (group, code, tags, the flat colour's own numbers) as tags of this suite.
"""

from __future__ import annotations

import json
from datetime import UTC, datetime

import numpy as np

from brdf_suite.appearance.colour.spectra import spectrum_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import flat_to_json
from brdf_suite.errors import SuiteError
from brdf_suite.files.cxf import is_cxf
from brdf_suite.files.exports.cxf3 import (
    any_specification,
    fits,
    tag_collection,
    write_document,
    write_object,
)
from brdf_suite.files.exports.format import ExportItem, Spectra
from brdf_suite.files.hardened_xml import attribute, text_content
from brdf_suite.files.palettes.conversions import as_readings, convert_to_flat
from brdf_suite.files.palettes.format import PaletteFormat
from brdf_suite.files.palettes.sample_entries import SPECTRA, kept_effects
from brdf_suite.files.palettes.xml.cxf3_reading import (
    CODE,
    COLOUR,
    COLUMNS,
    DATE,
    FLAT,
    GROUP,
    GROUPS,
    LABELS,
    NOTES,
    PALETTE,
    USAGE,
    read,
)

_SAME_DE = 0.5
"""How far a spectrum's own colour may lie from a reading for the two still to belong together, ΔE00."""
_ILLUMINANTS = {
    "A", "B", "C", "D50", "D55", "D60", "D65", "D75", "E", "F2", "F3", "F7", "F9", "F10", "F11", "F12",
}  # fmt: skip


def _spectra_of(entry: Entry, paint: Paint) -> Spectra | None:
    """Return the spectra of a paint, where they still match its colours."""
    text = dict(entry.foreign).get(SPECTRA, "")
    try:
        kept = json.loads(text)
        bands, rows = np.array(kept["bands"], float), np.array(kept["rows"], float)
        labs = spectrum_to_lab(rows, bands)
    except (ValueError, TypeError, KeyError, SuiteError):
        return None
    own = np.array([m.lab for m in paint.measurements])
    if len(rows) != len(own) or float(np.max(delta_e_2000(labs, own))) > _SAME_DE:
        return None
    return Spectra(tuple(bands.tolist()), tuple(tuple(row) for row in rows.tolist()))


def write(palette: Palette) -> bytes:
    """Return a CxF3 file with an Object for each entry."""
    now = datetime.now(UTC).isoformat(timespec="seconds").replace("+00:00", "Z")
    specifications: dict[str, str] = {}
    objects = []
    for index, entry in enumerate(palette):
        tags = _tags(entry)
        identity = f"entry{index + 1}"
        if isinstance(entry.content, FlatColour):
            objects.append(_flat_object(entry, entry.content, identity, now, specifications, tags))
        else:
            paint = as_readings(entry.content)
            if entry.notes:
                tags[NOTES] = entry.notes
            item = ExportItem(paint, spectra=_spectra_of(entry, paint))
            objects.append(write_object(item, identity, now, specifications, tags, kept_effects(entry)))
    about = {PALETTE: palette.name, NOTES: palette.notes, COLOUR: palette.colour}
    about[COLUMNS] = str(palette.columns) if palette.columns else ""
    if palette.groups:
        paths = [json.dumps(list(group.path), ensure_ascii=False) for group in palette.groups]
        about[GROUPS] = json.dumps(paths, ensure_ascii=False)
    rows = "".join(
        f"    <cc:Tag Name={attribute(name)} Value={attribute(value)}/>\n"
        for name, value in about.items()
        if value
    )
    return write_document(objects, specifications, now, palette.name, rows)


def _tags(entry: Entry) -> dict[str, str]:
    tags = {
        GROUP: json.dumps(list(entry.group), ensure_ascii=False) if entry.group else "",
        CODE: entry.code,
        LABELS: json.dumps(list(entry.tags), ensure_ascii=False) if entry.tags else "",
        USAGE: entry.usage if entry.usage != "process" else "",
        DATE: entry.date,
    }
    return {name: text for name, text in tags.items() if text}


def _flat_object(
    entry: Entry,
    colour: FlatColour,
    identity: str,
    now: str,
    specifications: dict[str, str],
    tags: dict[str, str],
) -> str:
    # A changed colour is distinguished from an unchanged one by its Lab, so every object has it.
    lab = convert_to_flat(entry, ("Lab",))
    shown = [lab, *(c for c in (colour, *colour.others) if c.model != "Lab")]
    values = device = ""
    for item in shown:
        element = _element(item, specifications)
        line = f"          {element}\n" if element else ""
        if item.model not in ("CMYK", "RGB") or item.space == "sRGB":
            values += line
        else:
            device += line
    tags = {FLAT: json.dumps(flat_to_json(colour), ensure_ascii=False), **tags}
    return (
        f'      <cc:Object ObjectType="Standard" Name={attribute(entry.name)} Id="{identity}">\n'
        f"        <cc:CreationDate>{now}</cc:CreationDate>\n"
        + (f"        <cc:Comment>{text_content(entry.notes)}</cc:Comment>\n" if entry.notes else "")
        + f"        <cc:ColorValues>\n{values}        </cc:ColorValues>\n"
        + (f"        <cc:DeviceColorValues>\n{device}        </cc:DeviceColorValues>\n" if device else "")
        + tag_collection(tags)
        + "      </cc:Object>\n"
    )


def _element(colour: FlatColour, specifications: dict[str, str]) -> str:
    """Return a value as a CxF3 element with its specification; empty where CxF3 cannot hold it."""
    v = colour.values
    light = colour.illuminant if colour.illuminant in _ILLUMINANTS else "D50"
    observer = colour.observer_deg or 2
    if colour.model == "spectrum":
        steps = np.diff(colour.wavelengths_nm)
        first = colour.wavelengths_nm[0]
        if not (360.0 <= first <= 400.0 and first == round(first) and np.all(steps == steps[0]) and fits(v)):
            return ""
        key = f"reflectance_{first:.0f}by{steps[0]:g}".replace(".", "_")
        specifications[key] = _specification(key, "D65", 10, (first, float(steps[0])))
        numbers = " ".join(repr(value) for value in v)
        start = f'<cc:ReflectanceSpectrum StartWL="{first:.0f}" ColorSpecification="{key}">'
        return f"{start}{numbers}</cc:ReflectanceSpectrum>"
    if colour.model in ("Lab", "LCh", "XYZ"):
        if colour.illuminant not in ("", *_ILLUMINANTS):
            return ""
        key = f"{light}_{observer}"
        specifications.setdefault(key, _specification(key, light, observer, None))
        name = {"Lab": "ColorCIELab", "LCh": "ColorCIELCh", "XYZ": "ColorCIEXYZ"}[colour.model]
        parts = "".join(f"<cc:{c}>{x!r}</cc:{c}>" for c, x in zip(colour.model.upper(), v, strict=True))
        return f'<cc:{name} ColorSpecification="{key}">{parts}</cc:{name}>'
    specifications.setdefault("device", _specification("device", "D50", 2, None))
    if colour.model == "CMYK":
        inks = zip(("Cyan", "Magenta", "Yellow", "Black"), v, strict=True)
        parts = "".join(f"<cc:{name}>{100.0 * ink!r}</cc:{name}>" for name, ink in inks)
        return f'<cc:ColorCMYK ColorSpecification="device">{parts}</cc:ColorCMYK>'
    if colour.model == "RGB" and all(0.0 <= x <= 1.0 for x in v):
        parts = "".join(f"<cc:{c}>{round(255.0 * x)}</cc:{c}>" for c, x in zip("RGB", v, strict=True))
        name = "ColorSRGB" if colour.space == "sRGB" else "ColorRGB"
        return f'<cc:{name} ColorSpecification="device">{parts}</cc:{name}>'
    return ""


def _specification(name: str, light: str, observer: int, bands: tuple[float, float] | None) -> str:
    unknown = "<cc:UnknownGeometry>true</cc:UnknownGeometry>"
    return any_specification(name, light, observer, "unknown", unknown, bands)


FORMAT = PaletteFormat(
    name="cxf",
    title="CxF3",
    endings=(".cxf",),
    models=("RGB", "CMYK", "CMY", "Gray", "HSB", "HSL", "Lab", "LCh", "XYZ", "spectrum"),
    groups="nested",
    paints=True,
    holds="Paints with L*a*b* at every angle, spectra, gloss and settings; flat colours in every model; groups, codes "
    "and tags as tags of this suite.",
    sniff=lambda head, _size: is_cxf(head),
    read=read,
    write=write,
)
