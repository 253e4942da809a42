"""Cook-Torrance parameters as JSON: the ``.brdfpaint`` document of that kind, read as a reflectance."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.store import load_any_paint, save_paint
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.measured.format import MeasuredFormat, ReadOptions
from brdf_suite.reflectance.protocol import SampledReflectance


@dataclass(frozen=True)
class CookTorranceFile:
    """The parameters of a file, with their reflectance."""

    paint: CookTorrancePaint
    reflectance: SampledReflectance

    @property
    def facts(self) -> dict[str, object]:
        """Facts for tables and dialogs."""
        return {
            "format": "Cook-Torrance parameters",
            "name": self.paint.name,
            "lobes": len(self.paint.lobes),
            "clearcoat": "yes" if self.paint.clearcoat else "no",
            "colour": "linear Rec. 2020",
        }

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3), working space, 1/sr, without the cosine."""
        return self.reflectance.eval(wi, wo)

    def sample(self, wo: npt.ArrayLike, u: npt.ArrayLike) -> Floats:
        """Return directions (..., 3) to the light for views ``wo`` and ``u`` (..., 3)."""
        return self.reflectance.sample(wo, u)

    def pdf(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return the density (...) of :meth:`sample` per solid angle; 0 where either direction is below the horizon."""
        return self.reflectance.pdf(wi, wo)


def read_cook_torrance(path: PathLike, _options: ReadOptions | None = None) -> CookTorranceFile:
    """Return the paint of a file; raise :class:`FileError` with the field where it is not one.

    No option matters: parameters are in the working space already.
    """
    from brdf_suite.reflectance.designed.build import build_reflectance  # pulls in every model

    try:
        paint = load_any_paint(path)
    except FileError as error:
        if error.place is not None:
            raise
        raise FileError(path, error.reason, "the JSON text") from error
    if not isinstance(paint, CookTorrancePaint):
        raise FileError(
            path, "is a paint designed by its colours, not measured lobes; open it as a paint", "kind"
        )
    return CookTorranceFile(paint, build_reflectance(paint))


# Any: a writer takes its own value classes and says what it cannot write.
def write_cook_torrance(value: Any, path: PathLike) -> None:
    """Write Cook-Torrance parameters.

    Raises
    ------
    FileError
        The value has no such parameters (they are fitted elsewhere), or the file cannot be written.
    """
    paint = value if isinstance(value, CookTorrancePaint) else getattr(value, "paint", None)
    if not isinstance(paint, CookTorrancePaint):
        raise FileError(
            path, "this format holds Cook-Torrance lobes, and the reflectance is not made of them"
        )
    save_paint(paint, path)


FORMAT = MeasuredFormat(
    name="cook_torrance",
    title="Cook-Torrance parameters (JSON)",
    endings=(".brdfpaint",),
    sniff=lambda head, _size: head.lstrip().startswith(b"{") and b'"brdfpaint"' in head,
    read=read_cook_torrance,
    write=write_cook_torrance,
)
