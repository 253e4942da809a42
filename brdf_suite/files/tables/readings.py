"""Samples out of a table of multi-angle readings: a row per sample, or a row per angle.

Repeated measurements of one sample are averaged where they agree, and their spread is reported. A reading that cannot
be used is left out with its line; a file without any is refused.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np

from brdf_suite.appearance.colour.colorimetry import xyz_to_lab
from brdf_suite.appearance.colour.spaces import lch_to_lab
from brdf_suite.appearance.colour.spectra import spectrum_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.appearance.geometries import Geometry as Place
from brdf_suite.documents.paint import PARAMETERS, Gloss, Lab
from brdf_suite.errors import FileError, PathLike, ValueRangeError
from brdf_suite.files.samples import (
    SAME_SAMPLE_DE,
    AngleSample,
    SampleFile,
    SampleReading,
    effect_notes,
    plain_name,
)
from brdf_suite.files.tables.columns import (
    EFFECTS,
    USUAL_LIGHT_DEG,
    Geometry,
    angle_text,
    is_statistic,
    parse_geometry,
)
from brdf_suite.files.tables.finding import Table
from brdf_suite.files.tables.grid import TableRow, parse_number

_OTHER_LIGHT = "it is of {light}, and without a spectrum it cannot become that of D65 and 10°"
_MOST_FACTOR, _LEAST_PERCENT = 1.5, 12.0
_MOST_REFUSED = 50


@dataclass
class Measured:
    """One measurement of a sample: its readings by light and aspecular angle, degrees."""

    name: str
    kind: str
    line: int
    readings: dict[tuple[float, float], SampleReading] = field(default_factory=dict)
    effects: dict[str, float] = field(default_factory=dict)
    gloss: dict[str, float] = field(default_factory=dict)
    notes: str = ""


def read_samples(table: Table, path: PathLike) -> SampleFile:
    """Return the samples of a table; ``path`` is what messages call the file.

    Raises :class:`FileError`: it holds no reading that can be used, or its numbers may be per cent or fractions.
    """
    reader = _Reader(table, path)
    by_angle = any(
        (column.geometry and "." in column.what) or (column.geometry and column.nm)
        for column in table.columns
    )
    measured = reader.rows_of_samples() if by_angle else reader.rows_of_angles()
    return collect(measured, path, reader.notes(), reader.refused)


def collect(
    measured: Iterable[Measured], path: PathLike, notes: Sequence[str], refused: Sequence[str]
) -> SampleFile:
    """Return measurements as samples, those of one name averaged where they agree.

    Raises :class:`FileError`: there is none with a reading.
    """
    groups: dict[tuple[str, str], list[Measured]] = {}
    counts: Counter[tuple[tuple[str, str], tuple[float, float]]] = Counter()
    for number, one in enumerate(measured):
        if not one.readings:
            continue
        name = (one.name, one.kind) if one.name else ("", str(number))
        group = groups.setdefault(name, [])
        # Rows may be ordered by angle: a further reading at an angle begins a further measurement.
        place = max(counts[name, angle] for angle in one.readings)
        for angle in one.readings:
            counts[name, angle] = place + 1
        if place < len(group):
            _join(group[place], one)
        else:
            group.append(one)
    if not groups:
        why = f" ({refused[0]})" if refused else ""
        raise FileError(path, f"holds no sample read at several angles that can be used{why}", "the table")
    samples, said = [], list(notes)
    twice = 0
    for group in groups.values():
        made = _averaged(group)
        twice += len(made) > 1
        for found in made:
            samples.append(found)
            if found.measurements > 1:
                said.append(
                    f"“{found.name}” is the mean of {found.measurements} measurements; {_spread(found)}."
                )
    if twice:
        said.append(
            f"{twice} names are those of several samples that differ by more than ΔE00 {SAME_SAMPLE_DE:g}; "
            "they stay apart."
        )
    without = sum(sample.gloss is None for sample in samples)
    if without:
        said.append(
            f"{without} of {len(samples)} samples say nothing of gloss; as paints they get 90 GU at 20°."
        )
    if any(sample.effects for sample in samples):
        said.append("Sparkle and graininess are on the instrument's own scale; they are kept as notes.")
    left_out = [] if len(refused) <= _MOST_REFUSED else [f"{len(refused) - _MOST_REFUSED} more are left out"]
    return SampleFile(tuple(samples), tuple(said), (*refused[:_MOST_REFUSED], *left_out))


def _join(first: Measured, one: Measured) -> None:
    """Add readings at other angles to a measurement."""
    first.readings |= one.readings
    first.effects = one.effects | first.effects
    first.gloss = one.gloss | first.gloss


def _spread(sample: AngleSample) -> str:
    return f"they differ from it by at most ΔE00 {sample.spread:.2f}"


def _means(group: Sequence[Measured]) -> tuple[dict[tuple[float, float], Lab], float]:
    """Return the mean at each angle, and how far the farthest reading is from its mean, ΔE00."""
    means: dict[tuple[float, float], Lab] = {}
    farthest = 0.0
    for key in dict.fromkeys(key for one in group for key in one.readings):
        labs = np.array([one.readings[key].lab for one in group if key in one.readings])
        lightness, a, b = labs.mean(axis=0).tolist()
        means[key] = (lightness, a, b)
        farthest = max(farthest, float(np.max(delta_e_2000(labs, labs.mean(axis=0)))))
    return means, farthest


def _averaged(group: Sequence[Measured]) -> list[AngleSample]:
    """Return one sample for measurements that agree, else one for each."""
    if len(group) == 1:
        return [_sample(group, list(group[0].readings.values()), 0.0)]
    means, spread = _means(group)
    if spread > SAME_SAMPLE_DE:
        return [_sample([one], list(one.readings.values()), 0.0) for one in group]
    return [_sample(group, [_mean_reading(group, key, lab) for key, lab in means.items()], spread)]


def average(samples: Sequence[AngleSample]) -> AngleSample | None:
    """Return the mean of samples that were measured once each; None where they differ by more than is usual."""
    group = []
    for sample in samples:
        readings = {(one.illumination_deg, one.aspecular_deg): one for one in sample.readings}
        gloss = {} if sample.gloss is None else {"20": sample.gloss.gu_20, "60": sample.gloss.gu_60}
        notes = "\n".join(line for line in sample.notes.splitlines() if line != effect_notes(sample.effects))
        known = {angle: value for angle, value in gloss.items() if value is not None}
        group.append(Measured(sample.name, sample.kind, 0, readings, dict(sample.effects), known, notes))
    found = _averaged(group)
    return found[0] if len(found) == 1 else None


def _mean_reading(group: Sequence[Measured], key: tuple[float, float], lab: Lab) -> SampleReading:
    own = [one.readings[key] for one in group if key in one.readings]
    rows = [one.reflectance for one in own if one.reflectance is not None]
    if len(rows) == len(own) and len({one.wavelengths_nm for one in own}) == 1:
        return replace(own[0], lab=lab, reflectance=tuple(np.mean(rows, axis=0).tolist()))
    return replace(own[0], lab=lab, wavelengths_nm=None, reflectance=None)


def _sample(group: Sequence[Measured], readings: list[SampleReading], spread: float) -> AngleSample:
    readings.sort(
        key=lambda reading: (
            reading.illumination_deg != USUAL_LIGHT_DEG,
            reading.illumination_deg,
            reading.aspecular_deg,
        )
    )
    effects = {
        what: float(np.mean([one.effects[what] for one in group if what in one.effects]))
        for what in dict.fromkeys(what for one in group for what in one.effects)
    }
    first = group[0]
    gloss = None
    if "20" in first.gloss:
        means_of = {a: float(np.mean([one.gloss[a] for one in group if a in one.gloss])) for a in first.gloss}
        gloss = Gloss(means_of["20"], means_of.get("60"))
    found = AngleSample(
        plain_name(first.name, "unnamed"), first.kind, tuple(readings), gloss, effects=effects,
        measurements=len(group), spread=spread,
    )  # fmt: skip
    lines = [first.notes, effect_notes(effects)]
    if len(group) > 1:
        lines.append(f"Mean of {len(group)} measurements; {_spread(found)}.")
    return replace(found, notes="\n".join(line for line in lines if line))


class _Reader:
    def __init__(self, table: Table, path: PathLike) -> None:
        self._table, self._path = table, path
        self.refused: list[str] = []
        self._assumed = False
        self._guessed_percent = False
        self._spectra = 0
        self._others = [column.heading for column in table.columns if not column.what and column.heading]
        by_place: dict[Geometry | None, dict[str, dict[str, int]]] = {}
        for index, column in enumerate(table.columns):
            model, dot, channel = column.what.partition(".")
            if dot or column.nm:
                white = "/".join(map(str, column.white))
                key = f"{model} {white}" if dot else "spectrum"
                parts = by_place.setdefault(column.geometry, {}).setdefault(key, {})
                part = channel if dot else f"{column.nm:g}"
                if part in parts:
                    raise FileError(
                        path,
                        f"the column {column.heading[:80]!r} is there twice, and no heading says at which angle",
                        "the header",
                    )
                parts[part] = index
        self._by_place = by_place
        self._factor = self._find_factor()

    def notes(self) -> list[str]:
        """Return what was assumed."""
        found = ["The layout of the table is not published; its columns were recognised by their headings."]
        if self._assumed:
            found.append("L*a*b* without a named light are taken for those of D65 and 10°.")
        if self._spectra:
            found.append(f"{self._spectra} readings: L*a*b* is recomputed from the spectrum.")
        if self._guessed_percent:
            found.append("The spectra are taken for per cent: their largest values could be no factors.")
        shown = ", ".join(repr(heading[:40]) for heading in self._others[:8])
        if self._others:
            more = f" and {len(self._others) - 8} more" if len(self._others) > 8 else ""
            found.append(f"Columns that are not known here were skipped: {shown}{more}.")
        return found

    def _find_factor(self) -> float:
        """Return what a reflectance factor of 1 is in the table's spectra: 1, or 100 where they are per cent."""
        bands = [i for i, column in enumerate(self._table.columns) if column.nm]
        if not bands:
            return 1.0
        if any(self._table.columns[i].percent for i in bands) or "%" in "".join(self._table.about.values()):
            return 100.0
        values = [parse_number(row.cell(i)) for row in self._table.rows for i in bands]
        most = max((value for value in values if value is not None), default=0.0)
        if most <= _MOST_FACTOR:
            return 1.0
        compared = self._compare_with_colours()
        if compared:
            return compared
        if most > _LEAST_PERCENT:
            self._guessed_percent = True
            return 100.0
        raise FileError(
            self._path,
            f"its spectra, of at most {most:g}, may be per cent or fractions, and nothing says which; write % into a "
            "heading, or give L* a* b* beside them",
            "the header",
        )

    def _compare_with_colours(self) -> float:
        """Return the factor with which the spectra give the table's own L*a*b*; 0 where that cannot be said."""
        found: dict[float, float] = {}
        for row in self._table.rows[:20]:
            for models in self._by_place.values():
                lab_columns = next((parts for key, parts in models.items() if key.startswith("Lab")), None)
                if lab_columns is None or "spectrum" not in models:
                    continue
                lab = [parse_number(row.cell(lab_columns[part])) for part in "lab" if part in lab_columns]
                bands = {float(nm): parse_number(row.cell(i)) for nm, i in models["spectrum"].items()}
                if len(lab) < 3 or None in lab or None in bands.values() or len(bands) < 2:
                    continue
                for factor in (1.0, 100.0):
                    values = np.array([bands[nm] for nm in sorted(bands)], float) / factor
                    distance = abs(
                        float(spectrum_to_lab(values, np.array(sorted(bands)))[0]) - float(lab[0] or 0.0)
                    )
                    found[factor] = found.get(factor, 0.0) + distance
        return min(found, key=lambda factor: found[factor]) if found else 0.0

    def rows_of_samples(self) -> Iterable[Measured]:
        """Yield a measurement for each row."""
        for row in self._table.rows:
            one = self._begin(row)
            if one is None:
                continue
            for geometry, models in self._by_place.items():
                if geometry is not None:
                    self._take(one, row, geometry, models)
            yield one

    def rows_of_angles(self) -> Iterable[Measured]:
        """Yield a measurement for each run of rows of one sample, until an angle comes again."""
        open_: Measured | None = None
        models = self._by_place.get(None, {})
        before = ""
        passed = False
        for row in self._table.rows:
            label = self._table.text(row, "name") or self._table.text(row, "code")
            passed = is_statistic(label) if label else passed
            if passed and not label:
                continue  # a further angle of what has its name in the first row only
            text = self._table.text(row, "geometry")
            light = parse_number(self._table.text(row, "light"))
            geometry = parse_geometry(text, USUAL_LIGHT_DEG if light is None else light)
            new = self._begin(row)
            if new is None or geometry is None:
                if new is not None and new.effects and (open_ is None or new.name not in ("", open_.name)):
                    if open_ is not None:
                        yield open_
                    open_ = new
                elif new is not None and new.effects and open_ is not None:
                    open_.effects |= new.effects
                elif text and geometry is None:
                    self._refuse(row, f"{text[:40]!r} is no angle in the plane of incidence")
                continue
            turned = parse_number(self._table.text(row, "azimuth"))
            if turned:
                geometry = (geometry[0], geometry[1], turned)
            index = self._table.text(row, "index")
            key = geometry[:2]
            coloured = any(row.cell(index) for parts in models.values() for index in parts.values())
            again = coloured and open_ is not None and key in open_.readings
            named = new.name or self._table.text(row, "name")
            if (
                open_ is None
                or (named and named != open_.name)
                or new.kind != open_.kind
                or index != before
                or again
            ):
                if open_ is not None:
                    yield open_
                if not named and open_ is not None and not again:
                    new.name = open_.name
                open_ = new
            else:
                open_.effects |= new.effects
                open_.gloss |= new.gloss
            before = index
            self._effects(open_, row, geometry)
            self._take(open_, row, geometry, models)
        if open_ is not None:
            yield open_

    def _begin(self, row: TableRow) -> Measured | None:
        table = self._table
        name = table.text(row, "name") or table.text(row, "code") or table.about.get("name", "")
        kind = table.text(row, "type")
        # A measurement may be of the type mean.
        said = name if is_statistic(name) else kind if is_statistic(kind, means=False) else ""
        if said:
            self._refuse(row, f"{said[:40]!r} is a difference, tolerance or statistic, no measurement")
            return None
        texts = [table.text(row, what) for what in ("notes", "date", "instrument")]
        one = Measured(name, kind, row.line, notes=", ".join(text for text in texts if text))
        for angle in ("20", "60"):
            value = parse_number(table.text(row, f"gloss {angle}"))
            if value is not None and PARAMETERS["gloss.gu_20"].low <= value <= PARAMETERS["gloss.gu_20"].high:
                one.gloss[angle] = value
        if not table.text(row, "geometry"):
            self._effects(one, row, None)
        return one

    def _effects(self, one: Measured, row: TableRow, at: Geometry | None) -> None:
        for index, column in enumerate(self._table.columns):
            value = parse_number(row.cell(index)) if column.what in EFFECTS.values() else None
            if value is not None:
                one.effects.setdefault(column.what + angle_text(column.geometry or at), value)

    def _refuse(self, row: TableRow, reason: str) -> None:
        self.refused.append(f"line {row.line}: {reason}")

    def _take(
        self, one: Measured, row: TableRow, geometry: Geometry, models: Mapping[str, Mapping[str, int]]
    ) -> None:
        light, aspecular, azimuth = geometry
        try:
            Place(light, aspecular)
        except ValueRangeError as error:
            self._refuse(row, str(error).rstrip("."))
            return
        bands, values = self._spectrum(row, models.get("spectrum", {}))
        lab, why = self._lab(row, models)
        if lab is None and values is None:
            if why:
                self._refuse(row, f"the colour at {light:g}as{aspecular:g} is left out: {why}")
            return
        if azimuth:
            self._refuse(row, f"{light:g}as{aspecular:g} is out of the plane of incidence ({azimuth:g}°)")
            return
        how = ""
        if lab is None and values is not None:
            lightness, a, b = spectrum_to_lab(np.array(values), np.array(bands)).tolist()
            lab, how = (lightness, a, b), "recomputed from the spectrum"
            self._spectra += 1
        assert lab is not None
        if not all(PARAMETERS[f"lab[{i}]"].low <= lab[i] <= PARAMETERS[f"lab[{i}]"].high for i in range(3)):
            self._refuse(row, f"L*a*b* of {light:g}as{aspecular:g} are beyond what a paint can have")
            return
        one.readings[light, aspecular] = SampleReading(light, aspecular, lab, how, bands, values)

    def _spectrum(
        self, row: TableRow, parts: Mapping[str, int]
    ) -> tuple[tuple[float, ...] | None, tuple[float, ...] | None]:
        found = sorted((float(nm), row.cell(index)) for nm, index in parts.items())
        texts = [text for _, text in found]
        if not any(texts):
            return None, None
        values = [parse_number(text) for text in texts]
        numbers = [value / self._factor for value in values if value is not None]
        bands = [nm for nm, _ in found]
        if len(numbers) < len(values) or len(numbers) < 2:
            wrong = next((text for text, value in zip(texts, values, strict=True) if value is None), "")
            self._refuse(row, f"a spectrum with {wrong[:40]!r} in the place of a number is left out")
            return None, None
        if (
            bands[0] < 100.0
            or any(b <= a for a, b in pairwise(bands))
            or not all(-1.0 <= n <= 100.0 for n in numbers)
        ):
            self._refuse(row, "a spectrum with values beyond any reflectance is left out")
            return None, None
        return tuple(bands), tuple(numbers)

    def _lab(self, row: TableRow, models: Mapping[str, Mapping[str, int]]) -> tuple[Lab | None, str]:
        """Return the colour of D65 and 10° of a row, or why it has none; no reason where it is empty."""
        why = ""
        for key, parts in models.items():
            model, _, white = key.partition(" ")
            if model not in ("Lab", "LCh", "XYZ") or len(parts) < 3:
                continue
            texts = [row.cell(parts[channel]) for channel in model.lower()]
            if not any(texts):
                continue
            values = [parse_number(text) for text in texts]
            if None in values:
                why = f"{texts[values.index(None)][:40]!r} stands in the place of a number"
                continue
            light = self._light(row, white)
            if light:
                why = _OTHER_LIGHT.format(light=light)
                continue
            numbers = [value for value in values if value is not None]
            if model != "Lab":
                numbers = (lch_to_lab(numbers) if model == "LCh" else xyz_to_lab(numbers)).tolist()
            if all(map(math.isfinite, numbers)):
                return (numbers[0], numbers[1], numbers[2]), ""
        return None, why

    def _light(self, row: TableRow, white: str) -> str:
        """Return the light and observer of a colour where they are not D65 and 10°; empty where they are."""
        illuminant, _, observer = white.partition("/")
        said = self._table.text(row, "illuminant") or self._table.about.get("illuminant", "")
        watched = self._table.text(row, "observer") or self._table.about.get("observer", "")
        if not illuminant and said:
            illuminant = said.replace(" ", "").upper().partition("/")[0].partition("-")[0]
            watched = watched or said.replace(" ", "").upper().replace("-", "/").partition("/")[2]
        observer = observer if observer not in ("", "0") else watched.strip(" °") or "10"
        if not illuminant:
            self._assumed = True
        of_d65 = illuminant in ("", "D65") and observer.rstrip("°").split(".")[0] == "10"
        return "" if of_d65 else f"{illuminant or 'an unnamed light'} and the {observer[:10]}° observer"
