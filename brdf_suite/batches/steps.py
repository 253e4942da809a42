"""Steps of a batch: what is done with one item, in a process that may do the same with thousands.

A step is a frozen value that goes to the workers by pickle. ``open`` prepares, once for each process, what all its
items share: a windowless scene with its light, or nothing.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager, nullcontext
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, ClassVar, Protocol, TypeAlias

from brdf_suite.appearance.geometries import geometry_set
from brdf_suite.batches.items import BatchItem, content_hash, load_item
from brdf_suite.documents.atomic import make_folder
from brdf_suite.documents.view import View
from brdf_suite.errors import SuiteError
from brdf_suite.fitting.homomorphic.reflectance_fit import (
    FactoringOptions,
    factor_reflectance,
    save_factored,
)
from brdf_suite.fitting.lobes.settings import FitSettings
from brdf_suite.inspection.measuring import measured_row, read_material
from brdf_suite.output.exposures import focused
from brdf_suite.output.picture_file import PictureSettings, picture_metadata, write_picture
from brdf_suite.output.still import loaded_scene
from brdf_suite.pipeline.exposure import metered
from brdf_suite.pipeline.lobe_fit import LobeFit, fit_material
from brdf_suite.pipeline.material import under_illuminant
from brdf_suite.pipeline.scene import load_environment
from brdf_suite.progress import Progress
from brdf_suite.reflectance.instruments.aperture import aperture
from brdf_suite.regular_files import is_file
from brdf_suite.release import __version__
from brdf_suite.reports.handover import export, format_named, item_of, item_of_material

Value: TypeAlias = str | float | int | bool | list[float] | None
"""What a column of the results holds."""

_NO_WORD = re.compile(r"[^\w.+-]+")


@dataclass(frozen=True)
class Outcome:
    """What came of one item: its row, the files that were written (below the folder of the results), and notices."""

    row: Mapping[str, Value]
    files: tuple[str, ...] = ()
    notices: tuple[str, ...] = ()


Work: TypeAlias = Callable[[BatchItem, Path], Outcome]
"""Does one item; files go below the folder."""


class BatchStep(Protocol):
    """What a batch does, a dataclass; ``name`` is the word of the command."""

    name: ClassVar[str]
    __dataclass_fields__: ClassVar[dict[str, Any]]

    def prepare(self, _progress: Progress | None, /) -> None:
        """Do once, before any worker starts, what all of them would do otherwise."""

    def open(self) -> AbstractContextManager[Work]:
        """Return what works on items, with what they share."""


def fingerprint(step: BatchStep) -> str:
    """Return a hash of the release, a step, its options and the files that they name; all is done again with another.

    Raises :class:`FileError`: one of the files cannot be read.
    """
    digest = hashlib.sha256(f"{__version__} {step!r}".encode())
    for text in sorted(_texts(asdict(step))):
        if is_file(text):
            digest.update(content_hash(Path(text)).encode())
    return digest.hexdigest()


def _texts(value: object) -> set[str]:
    """Return all texts within a value that is made of dictionaries and sequences."""
    if isinstance(value, str):
        return {value}
    inside = value.values() if isinstance(value, dict) else value if isinstance(value, list | tuple) else ()
    return {text for one in inside for text in _texts(one)}


@dataclass(frozen=True)
class Measure:
    """Read each paint as :func:`brdf_suite.measure` does; the columns are those of ``brdf-suite measure --csv``."""

    geometry: str = "six"
    aperture: str = "point"
    texture: bool = True
    name: ClassVar[str] = "measure"

    def prepare(self, _progress: Progress | None) -> None:
        """Check the options."""
        geometry_set(self.geometry)
        aperture(self.aperture)

    def open(self) -> AbstractContextManager[Work]:
        """Return what reads an item."""
        return nullcontext(self._measure)

    def _measure(self, item: BatchItem, _folder: Path) -> Outcome:
        material = load_item(item)
        geometries, through = geometry_set(self.geometry), aperture(self.aperture)
        report = read_material(material, geometries, through, texture=self.texture)
        return Outcome(measured_row(material, report), notices=(*material.notices, *report.notices))


@dataclass(frozen=True)
class Fit:
    """Fit the cosine lobes of each paint; weights in 1/sr, linear Rec. 2020, channel by channel within each lobe."""

    settings: FitSettings = field(default_factory=FitSettings)
    name: ClassVar[str] = "fit"

    def prepare(self, _progress: Progress | None) -> None:
        """There is nothing to prepare."""

    def open(self) -> AbstractContextManager[Work]:
        """Return what fits an item."""
        return nullcontext(self._fit)

    def _fit(self, item: BatchItem, _folder: Path) -> Outcome:
        fitted = fit_material(load_item(item), self.settings)
        weights = fitted.weights
        row: dict[str, Value] = {
            "name": fitted.name,
            **_fit_facts(fitted),
            "kd": [float(value) for value in weights.kd],
            "kdd": [float(value) for value in weights.kdd.ravel()],
            "kg": [float(value) for value in weights.kg.ravel()],
        }
        return Outcome(row, notices=fitted.notices)


@dataclass(frozen=True)
class Render:
    """Render each paint in one view, on OpenGL, to a picture of its own."""

    view: View
    size: tuple[int, int] = (640, 360)
    ending: str = ".png"
    settings: PictureSettings = field(default_factory=PictureSettings)
    fitting: FitSettings = field(default_factory=FitSettings)
    name: ClassVar[str] = "render"

    def prepare(self, progress: Progress | None) -> None:
        """Filter the environment and bake the occlusion, which go to the cache."""
        self.settings.of_file(Path(f"x{self.ending}"))
        with loaded_scene(self.view, progress, fitting=self.fitting):
            pass

    @contextmanager
    def open(self) -> Iterator[Work]:
        """Load the scene, and return what draws an item in it."""
        with loaded_scene(self.view, fitting=self.fitting) as loaded:
            composed = loaded.composed(self.view, self.size)

            def draw(item: BatchItem, folder: Path) -> Outcome:
                fit = fit_material(under_illuminant(load_item(item), self.view.light_colour), self.fitting)
                loaded.scene.set_material(fit)
                renderer = loaded.scene.renderer
                shown = focused(metered(renderer, composed, self.size), loaded.mesh, self.size)
                file = file_of(item, fit.name, "pictures", self.ending)
                target = _made(folder / file)
                write_picture(renderer, shown, self.size, target, self.settings, picture_metadata(fit, shown))
                return Outcome({"name": fit.name, **_fit_facts(fit), "picture": file}, (file,), fit.notices)

            yield draw


@dataclass(frozen=True)
class Prefilter:
    """Filter each environment for the lobes, into the cache."""

    settings: FitSettings = field(default_factory=FitSettings)
    layout: str = "auto"
    name: ClassVar[str] = "prefilter"

    def prepare(self, _progress: Progress | None) -> None:
        """There is nothing to prepare."""

    def open(self) -> AbstractContextManager[Work]:
        """Return what filters an item."""
        return nullcontext(self._filter)

    def _filter(self, item: BatchItem, _folder: Path) -> Outcome:
        if item.fault:
            raise SuiteError(item.fault)
        made = load_environment(item.source, layout=self.layout, basis=self.settings.basis)
        rows, columns = made.environment.radiance.shape[:2]
        sizes = [float(lobe.faces.shape[1]) for lobe in made.maps.lobes]
        return Outcome(
            {"name": made.name, "columns": columns, "rows": rows, "face_sizes": sizes},
            notices=made.environment.notes,
        )


@dataclass(frozen=True)
class Factorize:
    """Factor each reflectance into a product of textures: a ``.brdfpaint`` with its ``.exr`` for each."""

    options: FactoringOptions = field(default_factory=FactoringOptions)
    name: ClassVar[str] = "factorize"

    def prepare(self, _progress: Progress | None) -> None:
        """There is nothing to prepare."""

    def open(self) -> AbstractContextManager[Work]:
        """Return what factors an item."""
        return nullcontext(self._factorize)

    def _factorize(self, item: BatchItem, folder: Path) -> Outcome:
        material = load_item(item)
        found = factor_reflectance(material.name, material.reflectance, self.options)
        file = file_of(item, material.name, "factors", ".brdfpaint")
        save_factored(found, _made(folder / file))
        near = found.accuracy
        row: dict[str, Value] = {
            "name": material.name,
            "factors": str(found.factors),
            "median_relative_error": float(near.median_relative),
            "snr_db": float(near.snr_db),
            "paint": file,
        }
        return Outcome(row, (file,), material.notices)


@dataclass(frozen=True)
class Export:
    """Write each paint in another program's format, a file for each; what is lost stands in the row."""

    format: str
    name: ClassVar[str] = "export"

    def prepare(self, _progress: Progress | None) -> None:
        """Check that there is such a format."""
        format_named(self.format)

    def open(self) -> AbstractContextManager[Work]:
        """Return what exports an item."""
        return nullcontext(self._export)

    def _export(self, item: BatchItem, folder: Path) -> Outcome:
        known = format_named(self.format)
        given = item_of_material(load_item(item)) if item.entry or item.fault else item_of(item.source)
        file = file_of(item, given.name, "exports", known.ending)
        done = export(known, [given], _made(folder / file))
        row: dict[str, Value] = {"name": given.name, "file": file, "lost": "; ".join(done.losses)}
        return Outcome(row, (file,), done.notes)


def file_of(item: BatchItem, name: str, folder: str, ending: str) -> str:
    """Return where the file of an item goes, below the folder of the results: the same in every run."""
    word = _NO_WORD.sub("_", name)[:60].strip("._") or "paint"
    return f"{folder}/{item.key[:2]}/{word}-{item.key[:12]}{ending}"


def _fit_facts(fitted: LobeFit) -> dict[str, Value]:
    worst = fitted.worst_delta_e
    return {
        "worst_delta_e_2000": None if worst is None else float(worst),
        "time_limited": fitted.time_limited,
    }


def _made(path: Path) -> Path:
    make_folder(path.parent)
    return path
