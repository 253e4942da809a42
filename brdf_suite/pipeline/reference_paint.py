"""What is path-traced as the paint: anything that reflects, with its flakes and its orange peel where it says so."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from brdf_suite.appearance.light_matrix import ILLUMINANT_OF
from brdf_suite.documents.paint import Flakes, OrangePeel, Paint
from brdf_suite.documents.store import AnyPaint
from brdf_suite.documents.view import View
from brdf_suite.realtime.values import MaterialWeights
from brdf_suite.reflectance.protocol import Reflectance


@dataclass(frozen=True, eq=False)
class TracedPaint:
    """A reflectance, or lobes fitted to one, with its name, its flakes and orange peel, and sentences for the user."""

    name: str
    reflectance: Reflectance | MaterialWeights
    flakes: Flakes | None = None
    orange_peel: OrangePeel | None = None
    notices: tuple[str, ...] = ()


def load_traced(paint: str | os.PathLike[str] | AnyPaint, view: View) -> TracedPaint:
    """Return a paint by name, file or document, or a measured file, as it looks in the view's lamp.

    Raises
    ------
    SuiteError
        There is nothing of that name, the file is not valid, or no such paint can be; the message says why.
    """
    from brdf_suite.pipeline.measuring import is_measured_file, load_measurable
    from brdf_suite.pipeline.scene import find_any_paint

    if isinstance(paint, (str, os.PathLike)):
        if is_measured_file(Path(paint)):
            item = load_measurable(paint)
            return TracedPaint(item.name, in_the_lamp(item.reflectance, view), notices=item.notices)
        paint = find_any_paint(paint)
    reflectance, notices = _built(paint)
    peel = paint.orange_peel if isinstance(paint, Paint) else None
    return TracedPaint(paint.name, in_the_lamp(reflectance, view), paint.flakes, peel, notices)


def load_reflectance(name_or_path: str | os.PathLike[str]) -> tuple[str, Reflectance, tuple[str, ...]]:
    """Return name, reflectance and notices of a paint by name or file, or of a measured file; errors as the readers."""
    from brdf_suite.pipeline.measuring import load_measurable

    item = load_measurable(name_or_path)
    return item.name, item.reflectance, item.notices


def in_the_lamp(reflectance: Reflectance, view: View) -> Reflectance:
    """Return what has spectra as it looks in the view's lamp, as the real-time picture shows it."""
    from brdf_suite.reflectance.relit import relit
    from brdf_suite.reflectance.under_light import has_spectra

    illuminant = ILLUMINANT_OF.get(view.light_colour.illuminant, "D65")
    return relit(reflectance, illuminant) if illuminant != "D65" and has_spectra(reflectance) else reflectance


def _built(paint: AnyPaint) -> tuple[Reflectance, tuple[str, ...]]:
    from brdf_suite.reflectance.aperture import POINT
    from brdf_suite.reflectance.build import build_reflectance
    from brdf_suite.reflectance.through_aperture import build_through

    if isinstance(paint, Paint):
        solved = build_through(paint, POINT)
        return solved.reflectance, solved.notices
    return build_reflectance(paint), ()
