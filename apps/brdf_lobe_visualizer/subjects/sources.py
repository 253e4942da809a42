"""What can be looked at, by name or by file, and how it is read: found by content, on any thread, without Qt.

:mod:`brdf_suite.pipeline.material` decides what a name or a file is; of a palette the first entries are shown.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import numpy.typing as npt
from brdf_qt.documents.stamp import FileStamp, stamp_of
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.names import title_of
from brdf_qt.program.translation import tr

from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial, SamplePoints
from brdf_suite.arrays import Floats
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.fitting.lobes.measured_samples import measured_pairs
from brdf_suite.geometry.directions import illumination, mirror, spherical
from brdf_suite.pipeline.material import (
    ENTRY_MARK,
    Material,
    file_kind,
    load_material,
    load_palette_file,
    material_of_entry,
    paint_names,
)
from brdf_suite.progress import Progress, report
from brdf_suite.reflectance.isotropy import is_isotropic
from brdf_suite.reflectance.live.model import LiveModel
from brdf_suite.reflectance.live.text import LARGEST
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.registry import ENTRIES
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples
from brdf_suite.regular_files import is_file

MOST_AT_ONCE = 8
"""So many entries of a palette are shown when it is opened; the others stand in the list of reflectances."""
_LARGEST_TEXT_BYTES = 4 * LARGEST
"""Of a model's text in UTF-8."""
_SPIKE = 0.1
"""Share of the directions with light below which a reflectance is one narrow lobe."""


@dataclass(frozen=True, eq=False)
class Opened:
    """What was read: subjects, without keys and lines, and of a palette the entries that are not among them."""

    subjects: tuple[PlottedMaterial, ...]
    title: str
    entries: tuple[tuple[str, str], ...] = ()
    """Name and origin of every entry of a palette."""
    refused: tuple[str, ...] = ()
    """Why entries of a palette cannot be shown, one sentence each."""
    notes: tuple[str, ...] = ()
    """What was repaired, assumed or left out where a palette was read."""


def open_source(asked: str, progress: Progress | None = None) -> Opened:
    """Return what ``asked`` names: all that :func:`load_material` takes, or a palette, whose first entries are shown.

    Raises
    ------
    SuiteError
        There is no such thing, or it cannot be read or built; the message says what and where.
    Cancelled
        The progress callback asked for it.
    """
    report(progress, 0.0, "reading")
    if is_file(asked) and asked not in paint_names() and file_kind(asked) == "palette":
        return _of_palette(asked, progress)
    # Before the content is read: a change in between is then asked about once too often, never lost.
    stamp = _text_stamp(Path(asked))
    material = load_material(asked)
    report(progress, 0.7, "checking the values")
    subject = describe(material)
    if isinstance(material.reflectance, LiveModel):
        subject = replace(subject, stamp=stamp)
    return Opened((subject,), material.name)


def _text_stamp(path: Path) -> FileStamp | None:
    """Return the stamp of a file that may be a model's text; larger ones are not read for it."""
    try:
        is_text = path.stat().st_size <= _LARGEST_TEXT_BYTES
    except (OSError, ValueError):
        return None  # a name, or reading reports what is wrong with it
    return stamp_of(path) if is_text else None


def _of_palette(path: str, progress: Progress | None) -> Opened:
    read = load_palette_file(path)
    palette = read.palette
    entries = tuple((entry.name or entry.id, f"{path}{ENTRY_MARK}{entry.id}") for entry in palette)
    if not entries:
        raise FileError(path, tr("is a palette without a paint"))
    subjects: list[PlottedMaterial] = []
    refused: list[str] = []
    for place, entry in enumerate(palette):
        if len(subjects) == MOST_AT_ONCE:
            break
        report(progress, 0.2 + 0.8 * place / min(len(palette), MOST_AT_ONCE), "building paints")
        try:
            subjects.append(describe(material_of_entry(entry, entries[place][1])))
        except SuiteError as error:
            refused.append(str(error))
    return Opened(tuple(subjects), palette.name, entries, tuple(refused), read.notes)


def describe(material: Material) -> PlottedMaterial:
    """Add the properties of the reflectance: whether it is isotropic, where its samples and holes are, and notes."""
    subject = PlottedMaterial("", material.name, material, notes=material.notices)
    value = material.reflectance
    if isinstance(value, ScatteredSamples):
        samples = SamplePoints(value.wi, value.wo, value.values, value.isotropic)
        return replace(subject, samples=samples, isotropic=value.isotropic)
    if isinstance(value, IsotropicTable):
        measured = MeasuredBins(value) if value.holes_above_horizon() else None
        return _add_notes(replace(subject, measured=measured, isotropic=True))
    known = getattr(value, "isotropic", None)
    if not isinstance(known, bool):
        known = material.document is not None or is_isotropic(value)
    return _add_notes(replace(subject, isotropic=known))


def _add_notes(subject: PlottedMaterial) -> PlottedMaterial:
    """Say what makes a picture look empty or strange: nothing, one spike, no numbers."""
    values = _look(subject.reflectance)
    numbers = np.isfinite(values).all(axis=-1)
    notes = list(subject.notes)
    if not numbers.all():
        text = tr("{share:.0f} % of the directions have no value (drawn as holes).")
        notes.append(text.format(share=100.0 * np.mean(~numbers)))
    known = values[numbers]
    if known.size and not known.any():
        notes.append(tr("The reflectance is zero in every sampled direction."))
    elif known.size and float(np.mean(known.max(axis=-1) > 0.0)) < _SPIKE:
        notes.append(tr("All light is reflected into one narrow lobe; other views are dark."))
    return replace(subject, notes=tuple(notes))


def _look(reflectance: Reflectance) -> Floats:
    """Values (n, 3) at mirror directions and around, and over the hemisphere, for three lights."""
    theta, phi = np.meshgrid(np.radians(np.arange(2.0, 90.0, 8.0)), np.radians(np.arange(0.0, 360.0, 30.0)))
    views = spherical(theta.ravel(), phi.ravel())
    lights = illumination([0.0, 45.0, 75.0])
    wo = [np.concatenate((views, mirror(light)[None])) for light in lights]
    return np.concatenate([np.asarray(reflectance.eval(*pair)) for pair in zip(lights, wo, strict=True)])


@dataclass(frozen=True, eq=False)
class MeasuredBins:
    """Which pairs of directions fall into bins of a table that were measured: ``(wi, wo) -> (...)`` bool."""

    table: IsotropicTable

    def __call__(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> npt.NDArray[np.bool_]:
        table = self.table
        light, view = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
        shape = light.shape[:-1]
        flat_light, flat_view = (np.ascontiguousarray(w.reshape(-1, 3).T) for w in (light, view))
        above = (flat_light[2] > 0.0) & (flat_view[2] > 0.0)
        if table.coverage is not None:
            # Holes between the readings of photographs are everywhere, and filled; drawn, they would hide all else.
            return np.asarray((above & measured_pairs(table, flat_light.T, flat_view.T)).reshape(shape))
        places = table.grid.index_of(flat_light, flat_view)
        h, d, p = (
            np.minimum(place.astype(np.intp), size - 1)
            for place, size in zip(places, table.grid.shape, strict=True)
        )
        return np.asarray((above & ~np.asarray(table.holes)[h, d, p]).reshape(shape))


def names() -> dict[str, Sequence[tuple[str, str]]]:
    """Return what comes with the program: title and name of every shipped paint, paint of Table 1, and model."""
    return {
        "paints": [(title_of(name), name) for name in paint_names()],
        "table_1": [(paint.name, name) for name, paint in TABLE_1.items()],
        "models": [(tr_core(entry.title), entry.name) for entry in ENTRIES.built_in],
    }


def plugin_models() -> Sequence[tuple[str, str]]:
    """Return title and name of every model of a plug-in; loads them."""
    return [(entry.title, entry.name) for entry in ENTRIES.added]
