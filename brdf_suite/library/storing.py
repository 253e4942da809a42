"""Reading and writing: names and files of any kind to values, and values to files."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Literal, TypeVar, get_args, overload

from brdf_suite.appearance.geometries import GEOMETRY_SETS
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.factored import FactoredPaint
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.store import PAINT_ENDING, load_view, save_paint, save_view
from brdf_suite.documents.view import View
from brdf_suite.errors import FileError, PathLike, SuiteError, ValueRangeError
from brdf_suite.files.exports.format import ExportItem
from brdf_suite.files.images.environments import write_exr
from brdf_suite.files.measured import FORMATS as MEASURED_FORMATS
from brdf_suite.files.measured import write_measured
from brdf_suite.files.palettes import FORMATS as PALETTE_FORMATS
from brdf_suite.files.palettes import read_palette, write_palette
from brdf_suite.fitting.cook_torrance.reflectance_fit import FileFit
from brdf_suite.fitting.homomorphic.reflectance_fit import FactoredFit, save_factored
from brdf_suite.inspection.measuring import Conversion
from brdf_suite.inspection.measuring import convert as convert_measured
from brdf_suite.library.subjects import Subject, material_for
from brdf_suite.lighting.environment import Environment
from brdf_suite.pipeline.environments import read_environment
from brdf_suite.pipeline.lobe_fit import LobeFit
from brdf_suite.pipeline.material import (
    Material,
    document_kind,
    file_kind,
    load_document,
    load_material,
    load_palette_file,
    paint_names,
)
from brdf_suite.pipeline.scene import environment_names, find_environment, surface_names
from brdf_suite.progress import Progress
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.registry import MODELS
from brdf_suite.regular_files import is_file
from brdf_suite.reports.handover import (
    Exported,
    format_named,
    format_of,
    formats,
    item_of,
    item_of_material,
)
from brdf_suite.reports.handover import export as export_items
from brdf_suite.resources import schema_names

_Kind = TypeVar("_Kind", bound=Material | Palette | Environment | View | Paint)

NameKind = Literal[
    "paints", "table 1", "models", "environments", "surfaces", "geometries", "formats", "schemas"
]


@overload
def load(name_or_file: PathLike) -> Material | Palette: ...


@overload
def load(name_or_file: PathLike, kind: type[_Kind]) -> _Kind: ...


def load(name_or_file: PathLike, kind: type[_Kind] | None = None) -> Material | Palette | _Kind:
    """Return what a name or a file stands for: a palette's file as a :class:`Palette`, all else as a :class:`Material`.

    Parameters
    ----------
    name_or_file
        The name of a shipped paint, a paint of Table 1 or a model (:func:`names` lists them); a paint's document; a
        palette of any format; a measured file of any format. ``PALETTE#ID`` is one entry of a palette. Files are known
        by their content.
    kind
        What is wanted, which type checkers then know: :class:`Material`; :class:`Palette`; :class:`Paint`, the
        document; :class:`Environment`, of which there are shipped names, too; or :class:`View`.

    Raises
    ------
    SuiteError
        There is nothing of that name, the file cannot be read or is damaged (with the place), or it is of another kind.

    >>> import brdf_suite as bs
    >>> bs.load("blue").name
    'Blue'
    >>> bs.load("blue", bs.Paint).gloss.gu_20
    90.0
    >>> bs.load("overcast", bs.Environment).radiance.shape
    (512, 1024, 3)
    """
    if kind is None:
        text = str(name_or_file)
        if text in environment_names() and not is_file(text):
            raise SuiteError(
                f'{text}: is an environment; load it with load("{text}", brdf_suite.Environment).'
            )
        is_palette = is_file(text) and file_kind(name_or_file) == "palette"
        return load_palette_file(name_or_file).palette if is_palette else load_material(name_or_file)
    if kind not in _READERS:
        raise SuiteError(f"kind: expected Material, Palette, Paint, Environment or View, not {kind!r}.")
    found = _READERS[kind](name_or_file)
    if not isinstance(found, kind):
        raise FileError(name_or_file, "is no paint that is designed by its readings; load it as a Material")
    return found


_READERS: dict[type, Callable[[PathLike], object]] = {
    Material: load_material,
    Palette: lambda path: load_palette_file(path).palette,
    Paint: load_document,
    Environment: lambda name_or_file: read_environment(find_environment(name_or_file)[1]),
    View: load_view,
}
"""How each kind is read."""


def names(kind: NameKind = "paints") -> list[str]:
    """Return the names of what is shipped, and of what can be read and written.

    Parameters
    ----------
    kind
        ``paints``, ``table 1`` (paints of Günther et al. 2005) and ``models``, for :func:`load` and whatever takes a
        subject; ``environments`` and ``surfaces``, for :func:`render`; ``geometries``, for :func:`measure`;
        ``formats``, for :func:`export`; ``schemas``, of the suite's own JSON formats (`brdf-suite list schemas` says
        where they are).

    Raises
    ------
    ValueRangeError
        It is none of these.

    >>> import brdf_suite as bs
    >>> bs.names("surfaces")
    ['car', 'panel', 'speed_form', 'sphere']
    >>> "blue" in bs.names()
    True
    """
    known: dict[str, Callable[[], list[str]]] = {
        "paints": paint_names,
        "table 1": lambda: list(TABLE_1),
        "models": lambda: list(MODELS),
        "environments": environment_names,
        "surfaces": surface_names,
        "geometries": lambda: list(GEOMETRY_SETS),
        "formats": lambda: [one.name for one in formats()],
        "schemas": schema_names,
    }
    if kind not in known:
        raise ValueRangeError("kind", f"expected one of {', '.join(get_args(NameKind))}, not {kind!r}")
    return known[kind]()


def save(value: Subject | Palette | Environment | View, path: PathLike) -> tuple[str, ...]:
    """Write a value to a file of the format that the ending of ``path`` names; return what the format could not hold.

    A paint, also one that Cook-Torrance lobes or factors make, goes into a ``.brdfpaint``; a palette into any palette
    format (``.brdfpalette``, ``.ase``, ``.gpl``, ``.csv`` …); a material, a reflectance or a lobe fit into any measured
    format that holds it (``.brdftable``, ``.binary``, ``.bsdf`` …); an environment into an ``.exr``; a view into a
    ``.brdfview``. The file is written whole or not at all.

    Raises
    ------
    SuiteError
        The ending names no format for such a value, the format cannot hold it, or the disk refuses.

    >>> import brdf_suite as bs, tempfile, pathlib
    >>> folder = pathlib.Path(tempfile.mkdtemp())
    >>> bs.save(bs.load("blue", bs.Paint), folder / "mine.brdfpaint")
    ()
    >>> bs.load(folder / "mine.brdfpaint").name
    'Blue'
    """
    target = Path(path)
    if isinstance(value, Palette):
        return write_palette(value, target).losses
    if isinstance(value, Environment):
        if target.suffix.lower() != ".exr":
            raise FileError(target, "an environment goes into an .exr; give it that ending")
        write_exr(target, value.radiance)
        return ()
    if isinstance(value, View):
        save_view(value, target)
        return ()
    if isinstance(value, FactoredFit):
        save_factored(value, target)
        return ()
    if target.suffix.lower() == PAINT_ENDING:
        document = _document_of(value)
        if document is None:
            raise FileError(
                target,
                "what is given is no paint; make one with fit_cook_torrance or factorize, or choose a measured format",
            )
        save_paint(document, target)
        return ()
    return write_measured(material_for(value).reflectance, target).notes


def _document_of(value: Subject) -> Paint | CookTorrancePaint | FactoredPaint | None:
    if isinstance(value, FileFit):
        return value.paint
    return None if isinstance(value, LobeFit) else material_for(value).document


def export(
    subjects: Subject | Palette | Sequence[Subject],
    path: PathLike,
    *,
    format: str | None = None,
    progress: Progress | None = None,
) -> Exported:
    """Write paints for other programs, or a report of one, and return what was written and what was lost.

    Parameters
    ----------
    subjects
        One subject, several, or a palette; of what is no paint the virtual instrument reads one.
    path
        The file. Its ending names the format: ``.cxf`` (CxF3), ``.csv``, ``.json``, ``.mtlx`` (MaterialX OpenPBR),
        ``.glb`` (glTF clearcoat), ``.scn`` (LuxCore), ``.bsdf`` (RGL), ``.html`` and ``.pdf`` (reports).
    format
        One of ``names("formats")``, whatever the ending.
    progress
        Called with a share, 0 to 1, and a sentence; it may raise ``brdf_suite.errors.Cancelled``.

    Raises
    ------
    SuiteError
        There is no such format, it takes one paint only, a paint cannot be, or the disk refuses.

    >>> import brdf_suite as bs, tempfile, pathlib
    >>> done = bs.export(["blue", "fine_silver"], pathlib.Path(tempfile.mkdtemp()) / "two.cxf")
    >>> done.format, done.paints
    ('cxf', 2)
    """
    given: list[Subject]
    if isinstance(subjects, Palette):
        given = list(subjects.entries)
    elif isinstance(subjects, Sequence) and not isinstance(subjects, str):
        given = list(subjects)
    else:
        given = [subjects]
    known = format_of(path) if format is None else format_named(format)
    return export_items(known, [_item_of(one) for one in given], path, progress=progress)


def _item_of(subject: Subject) -> ExportItem:
    return item_of(subject) if isinstance(subject, str | Path) else item_of_material(material_for(subject))


def convert(source: PathLike, target: PathLike) -> Conversion:
    """Read a file of any kind, or take a paint by its name, and write it in another format.

    Parameters
    ----------
    source
        A file of any kind, or a name as of :func:`load`.
    target
        The file; its ending names the format.

    Palettes become palettes, and a paint a palette of one entry; measured files and paints become measured files. What
    the target could not hold is in ``notes``.

    Raises
    ------
    SuiteError
        One of the files cannot be read or written, or the target's format cannot hold the data.

    >>> import brdf_suite as bs, tempfile, pathlib
    >>> bs.convert("blue", pathlib.Path(tempfile.mkdtemp()) / "blue.gpl").format
    'gpl'
    """
    ending = Path(target).suffix.lower()
    measured = {end for known in MEASURED_FORMATS if known.write is not None for end in known.endings}
    palettes = {end for known in PALETTE_FORMATS if known.write is not None for end in known.endings}
    if ending in measured or ending not in palettes:
        return convert_measured(source, target)
    if is_file(source) and document_kind(source) != "paint" and file_kind(source) == "palette":
        found = read_palette(source)
        palette, notes = found.palette, found.notes
    else:
        document = load_document(source)
        if document is None:
            raise FileError(source, "is no palette and no paint, which a palette's format could hold")
        palette, notes = Palette(document.name, (Entry(document),)), ()
    written = write_palette(palette, target)
    return Conversion(
        Path(source), Path(target), written.format.name, {"entries": len(palette)}, (*notes, *written.losses)
    )
