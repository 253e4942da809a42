"""What the functions of the library accept: a name, a file, or anything in memory that reflects."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TypeAlias

from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.factored import FactoredPaint
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.errors import SuiteError
from brdf_suite.fitting.cook_torrance.reflectance_fit import FileFit
from brdf_suite.fitting.homomorphic.reflectance_fit import FactoredFit
from brdf_suite.pipeline.lobe_fit import LobeFit
from brdf_suite.pipeline.material import Material, load_material, material_of, material_of_entry
from brdf_suite.reflectance.protocol import Reflectance

Subject: TypeAlias = (
    str
    | os.PathLike[str]
    | Material
    | Paint
    | CookTorrancePaint
    | FactoredPaint
    | Entry
    | LobeFit
    | FileFit
    | FactoredFit
    | Reflectance
)
"""The name of a shipped paint, a paint of Table 1 or a model; a file of any kind; a material, a paint of any kind or a
palette's entry; a fit; or anything with ``eval(wi, wo)`` that returns f_r (..., 3) in 1/sr, linear Rec. 2020."""


def material_for(subject: Subject, *, observer_deg: int = 10) -> Material:
    """Return a subject as a material; a fit stands for what was fitted.

    Raises
    ------
    SuiteError
        There is nothing of that name, the file is not valid, no such paint can be, or it is nothing that reflects.
    """
    if isinstance(subject, (str, os.PathLike)):
        return load_material(subject, observer_deg=observer_deg)
    if isinstance(subject, Material):
        return subject
    if isinstance(subject, (Paint, CookTorrancePaint, FactoredPaint)):
        return material_of(subject)
    if isinstance(subject, Entry):
        return material_of_entry(subject)
    if isinstance(subject, LobeFit):
        fitted = subject.material
        return Material(subject.name, subject.weights, flakes=fitted.flakes, orange_peel=fitted.orange_peel)
    if isinstance(subject, FileFit):
        return Material(subject.name, subject.fit) if subject.paint is None else material_of(subject.paint)
    if isinstance(subject, FactoredFit):
        return Material(subject.name, subject.value)
    if isinstance(subject, Palette):
        raise SuiteError(
            f"{subject.name}: a palette holds paints; give one of its entries, as palette.entries[0]."
        )
    if isinstance(subject, Reflectance):
        return Material(type(subject).__name__, subject)
    raise SuiteError(
        f"Nothing that reflects: {type(subject).__name__}. Give a name, a file, a paint, a material, a fit, or "
        "anything with eval(wi, wo)."
    )


def title_of(subject: Subject) -> str:
    """Return what a fit of a subject is called: a file by its name without the ending."""
    name = material_for(subject).name
    return Path(name).stem or name
