"""What can be looked at, by name or by file, and how it is read: found by content, on any thread, without Qt.

A name is of a shipped paint, of a paint of Table 1 or of a model with an example; what is a file is read as what its
content says it is: a paint, a palette, or measured data of any format.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import numpy as np

from brdf_lobe_visualizer.subjects import SamplePoints, Subject
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.progress import Progress, report
from brdf_suite.reflectance.protocol import Reflectance

if TYPE_CHECKING:
    from brdf_suite.documents.palette import Entry, Palette
    from brdf_suite.documents.store import AnyPaint

MOST_AT_ONCE = 8
"""So many entries of a palette are shown when it is opened; the others stand in the list of reflectances."""
ENTRY_MARK = "#"
"""Between a palette's file and the id of an entry: ``summer.brdfpalette#12``."""

Kind = Literal["paint", "palette", "measured"]

_HEAD = 1 << 12
_DOCUMENT = re.compile(rb'"format"\s*:\s*"(brdfpaint|brdfpalette)"')
_SPIKE = 0.1
"""Share of the directions with light below which a reflectance is one narrow lobe."""


@dataclass(frozen=True, eq=False)
class Opened:
    """What was read: subjects, without keys and lines, and of a palette the entries that are not among them."""

    subjects: tuple[Subject, ...]
    title: str
    entries: tuple[tuple[str, str], ...] = ()
    """Name and origin of every entry of a palette."""
    refused: tuple[str, ...] = ()
    """Why entries of a palette cannot be shown, one sentence each."""
    notes: tuple[str, ...] = ()
    """What was repaired, assumed or left out where a palette was read."""


def open_source(asked: str, progress: Progress | None = None) -> Opened:
    """Return what ``asked`` names: a shipped paint, one of Table 1, a model, a file, or an entry of a palette.

    Raises
    ------
    SuiteError
        There is no such thing, or it cannot be read or built; the message says what and where.
    Cancelled
        The progress callback asked for it.
    """
    from brdf_suite.pipeline.scene import find_any_paint
    from brdf_suite.reflectance.registry import MODELS

    report(progress, 0.0, "reading")
    if asked in MODELS and not _is_file(asked):
        entry = MODELS[asked]
        return _one(
            _described(Subject("", entry.title, entry.make(), notes=(f"{entry.source}.",), origin=asked))
        )
    path, _, entry_id = asked.rpartition(ENTRY_MARK)
    if path and not _is_file(asked) and _is_file(path):
        return _of_palette(path, entry_id, progress)
    if not _is_file(asked):
        return _one(_of_paint(find_any_paint(asked), asked))
    kind = kind_of(asked)
    if kind == "palette":
        return _of_palette(asked, None, progress)
    if kind == "paint":
        from brdf_suite.documents.store import load_any_paint

        return _one(_of_paint(load_any_paint(asked), asked))
    return _foreign(asked, progress)


def kind_of(path: str) -> Kind:
    """Return what a file is, by its content; raise :class:`FileError` where it cannot be read.

    What is no document of ours is taken for measured data, or for another program's palette where it is none.
    """
    try:
        with Path(path).open("rb") as stream:
            head = stream.read(_HEAD)
    except OSError as error:
        raise FileError(path, f"cannot be read: {error.strerror or error}") from error
    if not head:
        raise FileError(path, "is empty", "byte 0")
    found = _DOCUMENT.search(head) if head.lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"{") else None
    if found is None:
        # Fields in another order, or a document that is cut off: the ending says what it is meant to be.
        ending = Path(path).suffix.lower()
        return "paint" if ending == ".brdfpaint" else "palette" if ending == ".brdfpalette" else "measured"
    return "paint" if found[1] == b"brdfpaint" else "palette"


def subject_of_paint(paint: AnyPaint, origin: str) -> Subject:
    """Return a paint as a subject; raise :class:`~brdf_suite.errors.UnreachableError` where none can be so."""
    return _of_paint(paint, origin)


def _one(subject: Subject) -> Opened:
    return Opened((subject,), subject.title)


def _of_paint(paint: AnyPaint, origin: str) -> Subject:
    from brdf_suite.reflectance.build import build_reflectance

    reflectance = build_reflectance(paint)
    notes = tuple(getattr(reflectance, "notices", ()))
    return _described(Subject("", paint.name, reflectance, paint=paint, notes=notes, origin=origin))


def _foreign(path: str, progress: Progress | None) -> Opened:
    """Read a file that is no document of ours: measured data, else a palette of another program."""
    from brdf_suite.files.measured.registry import sniff

    try:
        sniff(path)
    except FileError as no_measurement:
        return _foreign_palette(path, no_measurement, progress)
    return _one(_measured(path, progress))


def _foreign_palette(path: str, no_measurement: FileError, progress: Progress | None) -> Opened:
    from brdf_suite.files.palettes import read_palette
    from brdf_suite.files.palettes.registry import sniff

    try:
        sniff(Path(path).read_bytes(), path)
    except OSError as error:
        raise FileError(path, f"cannot be read: {error.strerror or error}") from error
    except FileError:
        reason = (
            "is neither a paint nor a palette nor measured data of a format that is known here (the pages "
            "measured_files and formats of the documents list them)"
        )
        raise FileError(path, reason, no_measurement.place) from no_measurement
    read = read_palette(path)
    return _shown_of_palette(read.palette, path, None, progress, read.notes)


def _of_palette(path: str, entry_id: str | None, progress: Progress | None) -> Opened:
    if kind_of(path) != "palette":
        from brdf_suite.files.palettes import read_palette

        read = read_palette(path)
        # Of a single entry nothing is told of the others: it comes from a list that has told it already.
        return _shown_of_palette(read.palette, path, entry_id, progress, read.notes)
    from brdf_suite.documents.palette_store import load_palette

    return _shown_of_palette(load_palette(path), path, entry_id, progress)


def _shown_of_palette(
    palette: Palette,
    path: str,
    entry_id: str | None,
    progress: Progress | None,
    notes: tuple[str, ...] = (),
) -> Opened:
    """Return the entry of an id, or the first of a palette."""
    entries = tuple((entry.name or entry.id, f"{path}{ENTRY_MARK}{entry.id}") for entry in palette)
    if entry_id is not None:
        if entry_id not in palette.by_id:
            raise FileError(path, f"has no entry {entry_id!r}")
        return _one(_of_entry(palette.entry(entry_id), f"{path}{ENTRY_MARK}{entry_id}"))
    if not len(palette):
        raise FileError(path, "is a palette without a paint")
    subjects, refused = [], []
    for place, entry in enumerate(palette):
        if len(subjects) == MOST_AT_ONCE:
            break
        report(progress, 0.2 + 0.8 * place / min(len(palette), MOST_AT_ONCE), "building paints")
        try:
            subjects.append(_of_entry(entry, entries[place][1]))
        except SuiteError as error:
            refused.append(str(error))
    return Opened(tuple(subjects), palette.name, entries, tuple(refused), notes)


def _of_entry(entry: Entry, origin: str) -> Subject:
    if not entry.is_flat:
        return _of_paint(entry.content, origin)
    from brdf_suite.appearance.flat_colours import to_paint

    subject = _of_paint(to_paint(entry.content), origin)
    flat = "A flat colour has no gloss and no angles; it is shown as a solid paint of that colour."
    return replace(subject, title=entry.name or entry.id, notes=(flat, *subject.notes))


def _measured(path: str, progress: Progress | None) -> Subject:
    from brdf_suite.pipeline.measuring import load_measurable

    item = load_measurable(path)
    report(progress, 0.7, "looking at the values")
    value = item.reflectance
    subject = Subject("", Path(path).name, value, notes=item.notices, origin=path)
    paint = getattr(value, "paint", None)
    if paint is not None:
        subject = replace(subject, title=paint.name, paint=paint)
    return _described(subject)


def _described(subject: Subject) -> Subject:
    """Add what the reflectance itself tells: whether it is isotropic, where its samples and holes are, and notes."""
    from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
    from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

    value = subject.reflectance
    if isinstance(value, ScatteredSamples):
        samples = SamplePoints(value.wi, value.wo, value.values, value.isotropic)
        return replace(subject, samples=samples, isotropic=value.isotropic)
    if isinstance(value, IsotropicTable):
        holes = value.holes_above_horizon()
        measured = MeasuredBins(value) if holes else None
        return _noted(replace(subject, measured=measured, isotropic=True))
    known = getattr(value, "isotropic", None)
    if not isinstance(known, bool):
        from brdf_suite.pipeline.reflectance_figures import is_isotropic

        known = subject.paint is not None or is_isotropic(value)
    return _noted(replace(subject, isotropic=known))


def _noted(subject: Subject) -> Subject:
    """Say what makes a picture look empty or strange: nothing, one spike, no numbers."""
    values = _look(subject.reflectance)
    numbers = np.isfinite(values).all(axis=-1)
    notes = list(subject.notes)
    if not numbers.all():
        notes.append(
            f"{100.0 * np.mean(~numbers):.0f} % of the directions have no number; they are drawn as holes."
        )
    known = values[numbers]
    if known.size and not known.any():
        notes.append("It reflects nothing in any direction that was looked at.")
    elif known.size and float(np.mean(known.max(axis=-1) > 0.0)) < _SPIKE:
        notes.append(
            "It reflects into one narrow lobe and nowhere else; a view that misses the lobe is dark."
        )
    return replace(subject, notes=tuple(notes))


def _look(reflectance: Reflectance) -> np.ndarray:
    """Values (n, 3) at mirror directions and around, and over the hemisphere, for three lights."""
    from brdf_suite.geometry.directions import illumination, mirror, spherical

    theta, phi = np.meshgrid(np.radians(np.arange(2.0, 90.0, 8.0)), np.radians(np.arange(0.0, 360.0, 30.0)))
    views = spherical(theta.ravel(), phi.ravel())
    found = []
    for light in illumination([0.0, 45.0, 75.0]):
        found.append(np.asarray(reflectance.eval(light, np.concatenate((views, mirror(light)[None])))))
    return np.concatenate(found)


@dataclass(frozen=True, eq=False)
class MeasuredBins:
    """Which pairs of directions fall into bins of a table that were measured: ``(wi, wo) -> (...)`` bool."""

    table: object

    def __call__(self, wi: object, wo: object) -> np.ndarray:
        table = self.table
        light, view = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
        shape = light.shape[:-1]
        flat_light, flat_view = (np.ascontiguousarray(w.reshape(-1, 3).T) for w in (light, view))
        above = (flat_light[2] > 0.0) & (flat_view[2] > 0.0)
        if table.coverage is not None:
            # Holes between the readings of photographs are everywhere, and filled; drawn, they would hide all else.
            from brdf_suite.fitting.lobes.undivided_samples import measured_pairs

            return (above & measured_pairs(table, flat_light.T, flat_view.T)).reshape(shape)
        places = table.grid.index_of(flat_light, flat_view)
        h, d, p = (
            np.minimum(place.astype(np.intp), size - 1)
            for place, size in zip(places, table.grid.shape, strict=True)
        )
        return (above & ~np.asarray(table.holes)[h, d, p]).reshape(shape)


def names() -> dict[str, Sequence[tuple[str, str]]]:
    """Return what comes with the program: title and name of every shipped paint, paint of Table 1, and model."""
    from brdf_suite.pipeline.scene import paint_names
    from brdf_suite.reflectance.models.table_1 import TABLE_1
    from brdf_suite.reflectance.registry import MODELS

    return {
        "paints": [(name.replace("_", " ").capitalize(), name) for name in paint_names()],
        "table_1": [(paint.name, name) for name, paint in TABLE_1.items()],
        "models": [(entry.title, name) for name, entry in MODELS.items()],
    }


def _is_file(asked: str) -> bool:
    try:
        return Path(asked).is_file()
    except (OSError, ValueError):  # a name that the file system does not take
        return False
