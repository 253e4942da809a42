"""LuxCore: the paint as a material of type ``carpaint``, a text of properties for a scene (``.scn``).

A scene takes the lines over with ``Scene.Parse``; an object is painted by ``scene.objects.NAME.material``. Colours are
linear Rec. 709. How the parameters are found stands in :mod:`brdf_suite.files.exports.carpaint_fit`.
"""

from __future__ import annotations

from collections.abc import Sequence
from importlib.metadata import version

from brdf_suite.documents.atomic import write_atomically
from brdf_suite.errors import PathLike
from brdf_suite.files.exports.carpaint_fit import CarPaint, fit_carpaint
from brdf_suite.files.exports.format import ExportFormat, ExportItem
from brdf_suite.files.exports.material_names import material_names
from brdf_suite.files.exports.model_fit import fitted_losses
from brdf_suite.progress import Progress


def losses(item: ExportItem) -> tuple[str, ...]:
    """Return what the car paint of LuxCore cannot hold of a paint; it is fitted for this."""
    found = fit_carpaint(item.modelled)
    return fitted_losses(
        item, "LuxCore's car paint (two lobes under a coat)", found.differences, found.clipped
    )


def write(items: Sequence[ExportItem], path: PathLike, _progress: Progress | None = None) -> tuple[str, ...]:
    """Write the materials of paints; raise :class:`FileError`, or :class:`UnreachableError` of a paint."""
    names = material_names([item.name for item in items])
    blocks = [
        _block(item, name, fit_carpaint(item.modelled)) for item, name in zip(items, names, strict=True)
    ]
    write_atomically(path, "\n".join(blocks).encode("utf-8"))
    return ()


def _block(item: ExportItem, name: str, paint: CarPaint) -> str:
    differences = ", ".join(f"{value:.2f}" for value in paint.differences)
    lines = [
        f"# {' '.join(item.name.split())}, by BRDF Suite {version('brdf-suite')}",
        f"# dE00 to the paint at its readings: {differences}",
        f'scene.materials.{name}.type = "carpaint"',
        f"scene.materials.{name}.kd = {_numbers(paint.kd)}",
    ]
    for index, (ks, r, m) in enumerate(zip(paint.ks, paint.r, paint.m, strict=True), start=1):
        lines += [
            f"scene.materials.{name}.ks{index} = {_numbers(ks)}",
            f"scene.materials.{name}.r{index} = {_numbers((r,))}",
            f"scene.materials.{name}.m{index} = {_numbers((m,))}",
        ]
    lines += [f"scene.materials.{name}.ka = 0 0 0", f"scene.materials.{name}.d = 0", ""]
    return "\n".join(lines)


def _numbers(values: Sequence[float]) -> str:
    return " ".join(f"{value:.9g}" for value in values)


FORMAT = ExportFormat(
    name="luxcore",
    title="LuxCore car paint",
    ending=".scn",
    holds="A diffuse layer, two coloured lobes and a clearcoat, fitted to the readings.",
    losses=losses,
    write=write,
    many=True,
)
