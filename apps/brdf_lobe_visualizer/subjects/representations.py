"""A reflectance as cosine lobes, Cook-Torrance lobes and factors, to be looked at side by side; without Qt."""

from __future__ import annotations

from dataclasses import replace

from brdf_qt.program.translation import mark

from brdf_lobe_visualizer.subjects.sources import describe
from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial
from brdf_suite.inspection.representations import Kind, fit_representations, hold_out
from brdf_suite.progress import Progress
from brdf_suite.reflectance.material import Material

_TITLES: dict[Kind, str] = {
    "cosine lobes": mark("{name}: cosine lobes"),
    "Cook-Torrance lobes": mark("{name}: Cook-Torrance lobes"),
    "homomorphic factors": mark("{name}: homomorphic factors"),
}


def represent(material: Material, progress: Progress | None = None) -> tuple[PlottedMaterial, ...]:
    """Return the material as cosine lobes, Cook-Torrance lobes and factors, with untranslated titles.

    The fits are those that ``brdf-suite represent`` compares: they see the same part of measured data.

    Raises
    ------
    FittingError
        One of the fits is not possible; the message says which, and why.
    Cancelled
        The progress callback asked for it.
    """
    seen = replace(material, reflectance=hold_out(material.reflectance).seen)
    return tuple(
        describe(Material(_TITLES[one.kind], one.reflectance, notices=one.notices))
        for one in fit_representations(seen, progress=progress)
    )
