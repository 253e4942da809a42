"""What is looked at: a reflectance with its name, its line, and what is known of it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.geometry.directions import Floats
from brdf_suite.reflectance.protocol import Reflectance

if TYPE_CHECKING:
    from brdf_suite.documents.store import AnyPaint
    from brdf_suite.fitting.lobes.weights import LobeWeights

Dash = Literal["solid", "dash", "dot", "dash dot", "long dash"]
DASHES: tuple[Dash, ...] = ("solid", "dash", "dot", "dash dot", "long dash")
Srgb = tuple[float, float, float]

LINE_COLOURS: tuple[Srgb, ...] = tuple(
    (int(code[0:2], 16) / 255.0, int(code[2:4], 16) / 255.0, int(code[4:6], 16) / 255.0)
    for code in ("56b4e9", "e69f00", "009e73", "cc79a7", "d55e00", "0072b2", "f0e442")
)
"""The lines' colours, in the order in which they are taken: Okabe and Ito's, told apart by all eyes."""

Measured = Callable[[npt.ArrayLike, npt.ArrayLike], npt.NDArray[np.bool_]]
"""``(wi, wo) -> (...)``: whether a pair was measured, and not filled in from its neighbours; they broadcast."""


@dataclass(frozen=True, eq=False)
class SamplePoints:
    """Samples as they were measured: ``wi``, ``wo`` (n, 3) unit directions, ``values`` (n, 3) f_r in 1/sr."""

    wi: Floats
    wo: Floats
    values: Floats
    isotropic: bool = True


@dataclass(frozen=True, eq=False)
class SubjectFit:
    """The lobes fitted to a subject.

    ``weights`` has ``exponents`` (m,), ``kd`` (3,), ``kdd`` and ``kg`` (m, 3), ``eval(wi, wo)`` and
    ``reflected(wi, wo)``. ``worst_delta_e`` is over the measured angles, None where there are none. ``source`` is the
    :class:`~brdf_suite.pipeline.paint.PaintFit` or :class:`~brdf_suite.pipeline.any_fit.AnyFit` that it is from.
    """

    weights: LobeWeights
    seconds: float
    time_limited: bool = False
    exact_follows: bool = False
    worst_delta_e: float | None = None
    notices: tuple[str, ...] = ()
    source: Any = None


@dataclass(frozen=True, eq=False)
class Subject:
    """One reflectance on the desk. Compare ``reflectance`` and ``fit`` by identity to see what has changed.

    Attributes
    ----------
    key
        Its own, as long as the program runs; also when its reflectance changes.
    colour, dash
        Its line in plots and legend: sRGB, 0 to 1, and a dash.
    reflectance
        ``eval(wi, wo) -> (..., 3)`` in 1/sr, linear Rec. 2020, without the cosine.
    fit
        None until the fit is there, and where none can be had.
    samples
        Where the data are scattered samples.
    measured
        Where a table has holes: tells them from what was measured; None where there are none.
    isotropic
        Whether the azimuth of the incidence matters not.
    notes
        What a user should know of it, each a sentence.
    origin
        The file, or the name, that it was opened by.
    """

    key: str
    title: str
    reflectance: Reflectance
    colour: Srgb = LINE_COLOURS[0]
    dash: Dash = "solid"
    paint: AnyPaint | None = None
    fit: SubjectFit | None = None
    samples: SamplePoints | None = None
    measured: Measured | None = None
    isotropic: bool = True
    notes: tuple[str, ...] = ()
    origin: str = ""
