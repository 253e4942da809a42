"""RGL ``.bsdf``: the paint as a table for renderers that read measured materials (Mitsuba's ``measured``)."""

from __future__ import annotations

from collections.abc import Sequence

from brdf_suite.errors import PathLike
from brdf_suite.files.exports.format import ExportFormat, ExportItem, flake_loss
from brdf_suite.files.measured import write_measured
from brdf_suite.progress import Progress, report
from brdf_suite.reflectance.tensor.tensor_reflectance import TensorReflectance


def losses(item: ExportItem) -> tuple[str, ...]:
    """Return what the table cannot hold of a paint."""
    texts = "Name, gloss readings, notes and source are left out; nothing that is edited can be read back."
    if item.material is not None and isinstance(item.material.reflectance, TensorReflectance):
        return (texts,)
    return (
        "The paint is tabulated: in the middle of the hemisphere within 2 in 10,000, near the horizon within percents.",
        *flake_loss(item),
        texts,
    )


def write(items: Sequence[ExportItem], path: PathLike, progress: Progress | None = None) -> tuple[str, ...]:
    """Write the table of one paint and return what the writer found out; errors as :func:`write_measured`."""
    (item,) = items
    report(progress, 0.0, "tabulating")
    return write_measured(item.reflectance, path).notes


FORMAT = ExportFormat(
    name="rgl",
    title="RGL measured material",
    ending=".bsdf",
    holds="How the paint reflects, for every pair of directions; spectra where they are known.",
    losses=losses,
    write=write,
)
