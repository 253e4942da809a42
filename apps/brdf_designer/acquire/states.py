"""What the pages show: plain values, so that a page knows nothing of where they come from."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_designer.acquire.plots.tone import Tones


@dataclass(frozen=True)
class Problem:
    """Something that a check found: ``severity`` is ``error``, ``warning`` or ``info``."""

    severity: str
    file: str
    reason: str


@dataclass(frozen=True, eq=False)
class Shot:
    """One photograph of a position's series.

    ``histogram`` (channels, bins) counts over ``edges`` (bins + 1) codes; ``clipped`` and ``dark`` are shares 0…1 of
    the pixels; ``clipped_area`` (rows, columns) is where a channel is clipped; ``exif_s`` is None where there is none.
    """

    exposure_s: float
    exif_s: float | None
    file: str
    tones: Tones
    clipped: float
    dark: float
    clipped_area: NDArray[np.bool_]
    histogram: NDArray[np.floating]
    edges: NDArray[np.floating]
    top: float


@dataclass(frozen=True, eq=False)
class Series:
    """All photographs of one position, shortest first."""

    position: int
    angle_deg: float
    shots: tuple[Shot, ...]
    problems: tuple[Problem, ...] = ()


@dataclass(frozen=True, eq=False)
class ResponseState:
    """A response curve: ``exposure`` (channels, codes), usable between ``lowest`` and ``highest`` (channels,)."""

    exposure: NDArray[np.floating]
    lowest: NDArray[np.integer]
    highest: NDArray[np.integer]
    facts: tuple[tuple[str, str, str], ...] = ()
    times: tuple[tuple[float, float], ...] = ()
    """(stated seconds, what the photographs say in percent of it)."""
    linear: bool = False


@dataclass(frozen=True, eq=False)
class GeometryState:
    """Where sphere and highlights were found; places are pixels with their centres at whole numbers.

    ``found`` and ``predicted`` (n, 2) are highlights at ``angles_deg`` (n,), ``residual_px`` and ``residual_deg`` (n,)
    their distance; ``outliers`` (n,) were left out. ``parameters`` are (name, refined, explanation).
    """

    picture: Tones
    edge: NDArray[np.floating]
    edge_used: NDArray[np.bool_]
    outline: NDArray[np.floating]
    found: NDArray[np.floating]
    predicted: NDArray[np.floating]
    angles_deg: NDArray[np.floating]
    residual_px: NDArray[np.floating]
    residual_deg: NDArray[np.floating]
    outliers: NDArray[np.bool_]
    facts: tuple[tuple[str, str, str], ...] = ()
    parameters: tuple[tuple[str, str, str], ...] = ()
    problems: tuple[Problem, ...] = ()


@dataclass(frozen=True, eq=False)
class Found:
    """A response, or a calibration with its geometry, and what is shown of it.

    ``found`` is None for the response of linear files; ``state`` too, and for a geometry from a work file. ``kept``:
    taken from a work file, with the figures of the run that found it.
    """

    found: Any
    state: Any
    kept: bool = False


@dataclass(frozen=True, eq=False)
class CoverageState:
    """How a table is covered, over (θd, θh) bins whose centres are given in degrees; NaN where nothing was measured.

    ``share`` of the φd bins measured 0…1, ``pixels`` in them, relative ``error`` of their mean.
    """

    share: NDArray[np.floating]
    pixels: NDArray[np.floating]
    error: NDArray[np.floating]
    theta_h_deg: NDArray[np.floating]
    theta_d_deg: NDArray[np.floating]
    facts: tuple[tuple[str, str, str], ...] = ()
