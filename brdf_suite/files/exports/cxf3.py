"""CxF3 (ISO 17972-1), written: an Object per paint, and one ColorSpecification per angle.

A value in CxF3 cannot name its angle, so each angle has a specification of its own with one BRDFAngle, noted as the
trade does (``45as15``: light at 45°, 15° from the mirror direction). Tristimulus values are L*a*b* of D65 and the 10°
observer. Where the spectra are known they stand beside them. Gloss goes into the physical attributes. What CxF3 has no
place for (flakes, their texture as the suite's own instrument reads it, the rule between angles) is kept as tags,
which only this suite reads.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from types import MappingProxyType

import numpy as np

from brdf_suite.appearance.colour.spectra import DEFAULT_WAVELENGTHS_NM
from brdf_suite.appearance.geometries import Geometry
from brdf_suite.appearance.texture import SCALE, TextureReadings
from brdf_suite.documents.atomic import write_atomically
from brdf_suite.documents.reading import VERSIONS
from brdf_suite.errors import FileError, PathLike, ValueRangeError
from brdf_suite.files.cxf import (
    INSTRUMENT,
    NAMESPACE,
    SETTING,
    SOURCE,
    TAGS,
    TEXTURE,
    VERSION,
    is_cxf,
    read_cxf,
)
from brdf_suite.files.exports.format import ExportFormat, ExportItem, ImportedPaints, Spectra, readings_loss
from brdf_suite.files.hardened_xml import attribute, clean_text, text_content
from brdf_suite.files.paint_fields import flatten_paint, setting_text
from brdf_suite.progress import Progress
from brdf_suite.release import __version__

_FIRST_NM, _LAST_FIRST_NM = 360.0, 400.0
_LEAST, _MOST = -0.1, 3.0
"""Between these, both left out, lies a reflectance of the schema (ReflectanceDataType)."""


def losses(item: ExportItem) -> tuple[str, ...]:
    """Return what CxF3 cannot hold of a paint."""
    found = list(readings_loss(item))
    kept = [name for name in flatten_paint(item.paint) if "." in name]
    parts = " and ".join(dict.fromkeys(name.partition(".")[0].replace("_", " ") for name in kept))
    what = f"The {parts}, the rule between angles" if parts else "The rule between angles"
    found.append(
        f"{what} and the near-specular factor go in as tags of this suite; other programs pass over them."
    )
    if any(clean_text(text) != text for text in (item.name, item.paint.notes, item.paint.source)):
        found.append("Characters that XML does not know are written as �.")
    if item.spectra is not None:
        if not _is_even(item.spectra):
            found.append(
                "The spectra are read off at 400 to 700 nm, every 10 nm: CxF3 wants even steps from 360 to 400 nm."
            )
        rows = item.spectra.values
        if high := sum(not fits(row) for row in rows):
            found.append(
                f"{high} of {len(rows)} spectra are left out: a reflectance there is 3 or more, or -0.1 or less."
            )
    return tuple(found)


def write(items: Sequence[ExportItem], path: PathLike, _progress: Progress | None = None) -> tuple[str, ...]:
    """Write paints as one CxF3 file; raise :class:`FileError` where the disk refuses."""
    now = datetime.now(UTC).isoformat(timespec="seconds").replace("+00:00", "Z")
    specifications: dict[str, str] = {}
    objects = [write_object(item, f"paint{i + 1}", now, specifications) for i, item in enumerate(items)]
    about = "Multi-angle colours of paints, D65 and 10° observer"
    write_atomically(path, write_document(objects, specifications, now, about))
    return ()


def write_document(
    objects: Sequence[str], specifications: Mapping[str, str], now: str, about: str, tags: str = ""
) -> bytes:
    """Return the file: Objects and their specifications, with a description and further elements about the file."""
    resources = (
        f"    <cc:ObjectCollection>\n{''.join(objects)}    </cc:ObjectCollection>\n"
        f"    <cc:ColorSpecificationCollection>\n{''.join(specifications.values())}"
        "    </cc:ColorSpecificationCollection>\n"
    )
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        f'<cc:CxF xmlns:cc="{NAMESPACE}">\n'
        "  <cc:FileInformation>\n"
        f"    <cc:Creator>BRDF Suite {__version__}</cc:Creator>\n"
        f"    <cc:CreationDate>{now}</cc:CreationDate>\n"
        f"    <cc:Description>{text_content(about)}</cc:Description>\n{tags}"
        "  </cc:FileInformation>\n"
        + (f"  <cc:Resources>\n{resources}  </cc:Resources>\n" if objects else "  <cc:Resources/>\n")
        + "</cc:CxF>\n"
    ).encode()


def write_object(
    item: ExportItem,
    identity: str,
    now: str,
    specifications: dict[str, str],
    further_tags: Mapping[str, str] = MappingProxyType({}),
    effects: Mapping[str, float] = MappingProxyType({}),
) -> str:
    """Return the Object of a paint; what its values are measured by is added to ``specifications`` by its Id.

    ``effects`` are sparkle and graininess as another maker's instrument read them.
    """
    paint, values = item.paint, []
    tags = {VERSION: str(VERSIONS["brdfpaint"]), **({SOURCE: paint.source} if paint.source else {})}
    tags |= texture_tags(item.texture)
    tags |= {SETTING + name: setting_text(value) for name, value in flatten_paint(paint).items()}
    spectra = None if item.spectra is None else _even(item.spectra)
    for index, reading in enumerate(paint.measurements):
        geometry = Geometry(reading.illumination_deg, reading.aspecular_deg)
        row = None if spectra is None else spectra.values[index]
        bands = None if spectra is None or row is None or not fits(row) else spectra.wavelengths_nm
        name = f"D65_10_{geometry.name}" + (
            "" if bands is None else f"_{bands[0]:.0f}by{bands[1] - bands[0]:.0f}"
        )
        if name not in specifications:
            specifications[name] = write_specification(name, geometry, bands)
        lightness, a, b = (repr(value) for value in reading.lab)
        values.append(
            f'          <cc:ColorCIELab Name="{geometry.name}" ColorSpecification="{name}">'
            f"<cc:L>{lightness}</cc:L><cc:A>{a}</cc:A><cc:B>{b}</cc:B></cc:ColorCIELab>\n"
        )
        if bands is not None and row is not None:
            values.append(
                f'          <cc:ReflectanceSpectrum Name="{geometry.name}" StartWL="{bands[0]:.0f}" '
                f'ColorSpecification="{name}">{" ".join(f"{value:.7g}" for value in row)}</cc:ReflectanceSpectrum>\n'
            )
    return (
        f'      <cc:Object ObjectType="Standard" Name={attribute(paint.name)} Id="{identity}">\n'
        f"        <cc:CreationDate>{now}</cc:CreationDate>\n"
        + (f"        <cc:Comment>{text_content(paint.notes)}</cc:Comment>\n" if paint.notes else "")
        + f"        <cc:ColorValues>\n{''.join(values)}        </cc:ColorValues>\n"
        + tag_collection({**tags, **further_tags})
        + tag_collection({what: repr(value) for what, value in effects.items()}, INSTRUMENT)
        + "        <cc:PhysicalAttributes>\n"
        + f'          <cc:Gloss Method="20° GU">{paint.gloss.gu_20!r}</cc:Gloss>\n'
        + (
            ""
            if paint.gloss.gu_60 is None
            else f'          <cc:Gloss Method="60° GU">{paint.gloss.gu_60!r}</cc:Gloss>\n'
        )
        + "        </cc:PhysicalAttributes>\n      </cc:Object>\n"
    )


def texture_tags(texture: TextureReadings | None) -> dict[str, str]:
    """Return the texture instrument's readings as tags, which :func:`brdf_suite.files.cxf.read_cxf` reads."""
    if texture is None:
        return {}
    numbers = {TEXTURE + name: repr(value) for name, value in texture.by_name().items()}
    return {TEXTURE + "scale": SCALE, **numbers}


def tag_collection(tags: Mapping[str, str], name: str = TAGS) -> str:
    """Return a collection of tags, this suite's own unless it has another name; empty for no tags at all."""
    if not tags and name != TAGS:
        return ""
    rows = "".join(
        f"          <cc:Tag Name={attribute(name)} Value={attribute(value)}/>\n"
        for name, value in tags.items()
    )
    return f"        <cc:TagCollection Name={attribute(name)}>\n{rows}        </cc:TagCollection>\n"


def write_specification(name: str, geometry: Geometry, bands: tuple[float, ...] | None) -> str:
    """Return the ColorSpecification of one angle, D65 and 10°, with the wavelengths of its spectra where it has any."""
    angle = (
        f'<cc:MultiAngle><cc:BRDFAngle Notation="{geometry.name}">'
        f"<cc:IlluminationAngle>{geometry.illumination_deg!r}</cc:IlluminationAngle>"
        f"<cc:Aspecular>{geometry.aspecular_deg!r}</cc:Aspecular></cc:BRDFAngle></cc:MultiAngle>"
    )
    range_nm = None if bands is None else (bands[0], bands[1] - bands[0])
    method = "unknown" if bands is None else "E308_1nm"
    return any_specification(name, "D65", 10, method, angle, range_nm)


def any_specification(
    name: str, light: str, observer: int, method: str, geometry: str, bands: tuple[float, float] | None
) -> str:
    """Return a ColorSpecification; ``geometry`` is its element, ``bands`` first wavelength and step of spectra, nm."""
    kind = "Colorimetric_Reflectance" if bands is None else "Spectrum_Reflectance"
    spectral = (
        "" if bands is None else f'<cc:WavelengthRange StartWL="{bands[0]:.0f}" Increment="{bands[1]:g}"/>'
    )
    return (
        f'      <cc:ColorSpecification Id="{name}">\n'
        f"        <cc:TristimulusSpec><cc:Illuminant>{light}</cc:Illuminant>"
        f"<cc:Observer>{observer}_Degree</cc:Observer><cc:Method>{method}</cc:Method></cc:TristimulusSpec>\n"
        "        <cc:MeasurementSpec>\n"
        f"          <cc:MeasurementType>{kind}</cc:MeasurementType>\n"
        f"          <cc:GeometryChoice>{geometry}</cc:GeometryChoice>\n"
        + (f"          {spectral}\n" if spectral else "")
        + "        </cc:MeasurementSpec>\n      </cc:ColorSpecification>\n"
    )


def fits(row: Sequence[float]) -> bool:
    """Return whether reflectances are within the schema's bounds."""
    return all(_LEAST < value < _MOST for value in row)


def _is_even(spectra: Spectra) -> bool:
    bands = np.array(spectra.wavelengths_nm)
    steps = np.diff(bands)
    return bool(
        len(bands) > 1
        and _FIRST_NM <= bands[0] <= _LAST_FIRST_NM
        and np.all(np.abs(steps - steps[0]) < 1e-6)
        and np.all(np.abs(bands - np.round(bands)) < 1e-6)
    )


def _even(spectra: Spectra) -> Spectra:
    """Return the spectra at bands that CxF3 can name."""
    if _is_even(spectra):
        return spectra
    bands = np.array(spectra.wavelengths_nm)
    rows = tuple(tuple(np.interp(DEFAULT_WAVELENGTHS_NM, bands, row).tolist()) for row in spectra.values)
    return Spectra(tuple(DEFAULT_WAVELENGTHS_NM.tolist()), rows)


def read(path: PathLike) -> ImportedPaints:
    """Return the paints of a CxF3 file; samples that make no paint are reported in the notes."""
    found = read_cxf(path)
    paints, notes = [], [*found.notes, *found.refused]
    for sample in found.samples:
        try:
            paints.append(sample.paint())
        except (ValueRangeError, FileError) as error:
            notes.append(str(error).rstrip("."))
    if not paints:
        raise FileError(path, f"holds no sample that makes a paint ({notes[-1]})")
    return ImportedPaints(tuple(paints), tuple(notes))


FORMAT = ExportFormat(
    name="cxf",
    title="CxF3, one specification per angle",
    ending=".cxf",
    holds="L*a*b* at every angle (D65, 10°), spectra where they are known, gloss, name, notes.",
    losses=losses,
    write=write,
    read=read,
    sniff=is_cxf,
    many=True,
    texture=True,
)
