"""What is exported, and what the registry knows of one format that it is exported in."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from brdf_suite.appearance.geometries import Geometry
from brdf_suite.appearance.texture import TextureReadings
from brdf_suite.documents.paint import PARAMETERS, Flakes, Gloss, Measurement, Paint
from brdf_suite.documents.store import AnyPaint
from brdf_suite.errors import PathLike, UnreachableError, ValueRangeError
from brdf_suite.progress import Progress
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.reflectance.instruments.spectrophotometer import InstrumentReport, nearest_sample_deg
from brdf_suite.reflectance.material import Material
from brdf_suite.reflectance.protocol import Reflectance


@dataclass(frozen=True)
class Spectra:
    """The reflectance factor of each reading: ``values[i][k]`` at ``wavelengths_nm[k]``; 1 is a perfect diffuser."""

    wavelengths_nm: tuple[float, ...]
    values: tuple[tuple[float, ...], ...]

    def __post_init__(self) -> None:
        for row in (self.wavelengths_nm, *self.values):
            if len(row) != len(self.wavelengths_nm) or not all(math.isfinite(value) for value in row):
                raise ValueRangeError("spectra", "expected as many finite numbers as wavelengths")


@dataclass(frozen=True, eq=False)
class ExportItem:
    """A paint as it is exported.

    Parameters
    ----------
    paint
        Its readings, gloss, flakes and texts. Of anything that is not designed by readings, what the virtual
        instruments read of it.
    material
        What the virtual instruments read; None for a paint that is designed by readings, which need not be one that
        can be built.
    spectra
        One per reading of ``paint``, where they are known.
    texture
        What the texture instrument reads of its flakes; None where it has not been read.
    """

    paint: Paint
    material: Material | None = None
    spectra: Spectra | None = None
    texture: TextureReadings | None = None

    @property
    def name(self) -> str:
        """The paint's name."""
        return self.paint.name

    @property
    def document(self) -> AnyPaint | None:
        """The paint's own document where it has one."""
        return self.paint if self.material is None else self.material.document

    @property
    def computed(self) -> bool:
        """Whether the readings are the virtual instruments' and not the document's own."""
        return self.material is not None

    def nearest_sample_deg(self, geometry: Geometry) -> float:
        """Return the angle from a computed reading to the nearest sample, degrees; 0 where there are no samples."""
        return 0.0 if self.material is None else nearest_sample_deg(self.material.reflectance, geometry)

    @cached_property
    def modelled(self) -> Paint:
        """The paint with the coat of renderers' models: the readings under the nearest possible coat.

        What virtual instruments read need not be a coat over a base: then the gloss at 20° alone counts.
        """
        if self.computed:
            try:
                build_paint(self.paint)
            except UnreachableError:
                return replace(self.paint, gloss=Gloss(self.paint.gloss.gu_20))
        return self.paint

    @property
    def reflectance(self) -> Reflectance:
        """All that is known of how it reflects; :class:`UnreachableError` where no paint has these readings."""
        return build_paint(self.paint) if self.material is None else self.material.reflectance


@dataclass(frozen=True)
class ImportedPaints:
    """Imported paints, with notices of assumptions, conversions and omissions."""

    paints: tuple[AnyPaint, ...]
    notes: tuple[str, ...] = ()


Losses = Callable[[ExportItem], tuple[str, ...]]
Write = Callable[[Sequence[ExportItem], PathLike, Progress | None], tuple[str, ...]]


@dataclass(frozen=True)
class ExportFormat:
    """An export format.

    Parameters
    ----------
    name
        Short, as a command-line word.
    title
        For lists and dialogs.
    ending
        Lower case, with the dot.
    holds
        What it carries, a sentence for the user.
    losses
        ``(item) -> sentences``: what of this paint the format cannot hold. Asked before anything is written.
    write
        ``(items, path, progress) -> notes``: writes the file whole or not at all, and returns sentences about it.
    read
        ``(path) -> Imported``, or None where a paint cannot be read back from the format.
    sniff
        Whether the first bytes of a file are of this format.
    many
        Whether one file takes several paints.
    texture
        Whether it carries the texture instrument's readings.
    """

    name: str
    title: str
    ending: str
    holds: str
    losses: Losses
    write: Write
    read: Callable[[PathLike], ImportedPaints] | None = None
    sniff: Callable[[bytes], bool] | None = None
    many: bool = False
    texture: bool = False


def paint_of_report(
    found: InstrumentReport, name: str, source: str, flakes: Flakes | None, notes: str
) -> Paint:
    """Return what virtual instruments read, as a paint; its gloss is held to what a paint's can be.

    Raises :class:`ValueRangeError`: a colour is beyond a paint's range.
    """
    low, high = PARAMETERS["gloss.gu_20"].low, PARAMETERS["gloss.gu_20"].high
    gloss = Gloss(*(min(high, max(low, found.gloss[angle])) for angle in (20, 60)))
    places = ((r.geometry.illumination_deg, r.geometry.aspecular_deg, r.lab) for r in found.readings)
    source = f"{source} Read by virtual instruments.".strip()
    return Paint(
        name, tuple(Measurement(*place) for place in places), gloss, flakes, notes=notes, source=source
    )


def flake_loss(item: ExportItem) -> tuple[str, ...]:
    """Return the sentences about flakes and orange peel for formats that have neither."""
    losses = []
    if item.paint.flakes is not None:
        losses.append("The flakes do not sparkle there: density, size and tilt are left out.")
    if item.paint.orange_peel is not None:
        losses.append("The orange peel is left out: the surface is smooth there.")
    return tuple(losses)


def readings_loss(item: ExportItem) -> tuple[str, ...]:
    """Return the sentence for formats of readings about a paint that is more than its readings."""
    if not item.computed:
        return ()
    count = len(item.paint.measurements)
    return (
        f"Only what the virtual instruments read of it goes in: L*a*b* at {count} angles and gloss. How it reflects "
        "between and beyond them is left out.",
    )


def model_loss(item: ExportItem) -> tuple[str, ...]:
    """Return the sentence for formats with a model of their own about a paint that is not designed by readings."""
    if not item.computed:
        return ()
    return ("The clearcoat is that of a designed paint with the same gloss.",)
