"""Design, measure, fit and render automotive paint: ``import brdf_suite as bs``.

What is named here, and what its functions return, is the library, and stays as it is from one minor version to the
next; everything else below may change.
Each name is imported at its first use. Docstrings state shapes, units, ranges and errors, with an example.

>>> import brdf_suite as bs
>>> blue = bs.load("blue", bs.Material)
>>> blue.eval(bs.spherical(0.3, 0.0), bs.spherical(0.5, 3.0)).shape
(3,)
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

from brdf_suite.release import __version__

if TYPE_CHECKING:
    from brdf_suite.documents.paint import Flakes as Flakes
    from brdf_suite.documents.paint import Gloss as Gloss
    from brdf_suite.documents.paint import Measurement as Measurement
    from brdf_suite.documents.paint import Paint as Paint
    from brdf_suite.documents.palette import Entry as Entry
    from brdf_suite.documents.palette import Palette as Palette
    from brdf_suite.documents.view import View as View
    from brdf_suite.errors import SuiteError as SuiteError
    from brdf_suite.library.batching import batch as batch
    from brdf_suite.library.drawings import Drawing as Drawing
    from brdf_suite.library.drawings import plot as plot
    from brdf_suite.library.fits import factorize as factorize
    from brdf_suite.library.fits import fit as fit
    from brdf_suite.library.fits import fit_cook_torrance as fit_cook_torrance
    from brdf_suite.library.fits import samples as samples
    from brdf_suite.library.photographs import acquire as acquire
    from brdf_suite.library.photographs import simulate as simulate
    from brdf_suite.library.pictures import Rendering as Rendering
    from brdf_suite.library.pictures import prefilter as prefilter
    from brdf_suite.library.pictures import render as render
    from brdf_suite.library.readings import check as check
    from brdf_suite.library.readings import compare as compare
    from brdf_suite.library.readings import delta_e as delta_e
    from brdf_suite.library.readings import find_nearest as find_nearest
    from brdf_suite.library.readings import measure as measure
    from brdf_suite.library.readings import spherical as spherical
    from brdf_suite.library.storing import convert as convert
    from brdf_suite.library.storing import export as export
    from brdf_suite.library.storing import load as load
    from brdf_suite.library.storing import names as names
    from brdf_suite.library.storing import save as save
    from brdf_suite.lighting.environment import Environment as Environment
    from brdf_suite.pipeline.lobe_fit import LobeFit as LobeFit
    from brdf_suite.reflectance.material import Material as Material

version: str = __version__
"""The version, as in ``0.2.0``."""

_ROOM_OF = {
    "acquire": "library.photographs",
    "batch": "library.batching",
    "check": "library.readings",
    "compare": "library.readings",
    "convert": "library.storing",
    "delta_e": "library.readings",
    "Drawing": "library.drawings",
    "Entry": "documents.palette",
    "Environment": "lighting.environment",
    "export": "library.storing",
    "factorize": "library.fits",
    "find_nearest": "library.readings",
    "fit": "library.fits",
    "fit_cook_torrance": "library.fits",
    "Flakes": "documents.paint",
    "Gloss": "documents.paint",
    "load": "library.storing",
    "LobeFit": "pipeline.lobe_fit",
    "Material": "reflectance.material",
    "measure": "library.readings",
    "Measurement": "documents.paint",
    "names": "library.storing",
    "Paint": "documents.paint",
    "Palette": "documents.palette",
    "plot": "library.drawings",
    "prefilter": "library.pictures",
    "render": "library.pictures",
    "Rendering": "library.pictures",
    "samples": "library.fits",
    "save": "library.storing",
    "simulate": "library.photographs",
    "spherical": "library.readings",
    "SuiteError": "errors",
    "View": "documents.view",
}
"""The module of each name of the library."""

__all__ = [
    "Drawing",
    "Entry",
    "Environment",
    "Flakes",
    "Gloss",
    "LobeFit",
    "Material",
    "Measurement",
    "Paint",
    "Palette",
    "Rendering",
    "SuiteError",
    "View",
    "__version__",
    "acquire",
    "batch",
    "check",
    "compare",
    "convert",
    "delta_e",
    "export",
    "factorize",
    "find_nearest",
    "fit",
    "fit_cook_torrance",
    "load",
    "measure",
    "names",
    "plot",
    "prefilter",
    "render",
    "samples",
    "save",
    "simulate",
    "spherical",
    "version",
]


def __dir__() -> list[str]:
    return [*__all__, "__doc__", "__name__", "__path__"]


if not TYPE_CHECKING:  # type checkers shall report a name that is not there

    def __getattr__(name: str) -> object:
        if name in _ROOM_OF:
            import_module("brdf_suite.library")  # by which values are drawn in notebooks
            found = vars(import_module(f"brdf_suite.{_ROOM_OF[name]}"))[name]
        elif name.startswith("_"):
            raise AttributeError(f"module 'brdf_suite' has no attribute {name!r}")
        else:
            raise AttributeError(import_module("brdf_suite.library.hints").missing_name(name, __all__))
        globals()[name] = found
        return found
