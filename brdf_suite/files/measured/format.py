"""Registry entry of a format of measured reflectance, and the losses of a half-angle table."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol, runtime_checkable

import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.errors import PathLike
from brdf_suite.reflectance.protocol import Reflectance


@runtime_checkable
class MeasuredReflectance(Protocol):
    """A reflectance read from a file, with its origin."""

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3), working space, 1/sr, without the cosine."""
        ...

    @property
    def facts(self) -> dict[str, object]:
        """Return what is known of the measurement, by name."""
        ...


@dataclass(frozen=True)
class ReadOptions:
    """Options for facts that a file does not state.

    Parameters
    ----------
    observer_deg
        2 or 10: the observer through which spectra become colour (under D65).
    scale_factors
        MERL: whether values carry its scale factors; None detects it, and the facts say what was found.
    average_reciprocal
        MERL with φd over 360°: take the mean of a pair and its swap.
    srgb_encoded
        UTIA: whether values were passed through the sRGB curve.
    """

    observer_deg: int = 10
    scale_factors: bool | None = None
    average_reciprocal: bool = False
    srgb_encoded: bool = False


@dataclass(frozen=True)
class MeasuredFormat:
    """A format of measured reflectance.

    Parameters
    ----------
    name
        Short, as a command-line word.
    title
        For dialogs.
    endings
        Lower case, with the dot; the first is the usual one.
    sniff
        ``(head, size) -> bool``: whether the first bytes (up to 64 KiB) of a file of ``size`` bytes are of
        this format. It may not raise.
    read
        ``(path, options) -> value``; raises :class:`~brdf_suite.errors.FileError`, imports nothing partly.
    write
        ``(value, path)``, or None for formats that are only read; whole file or none. What the format could
        not hold is returned as notes, each a clause for the user.
    """

    name: str
    title: str
    endings: tuple[str, ...]
    sniff: Callable[[bytes, int], bool]
    # A reader's own value class; the registry hands it through.
    read: Callable[[PathLike, ReadOptions], Any]
    write: Callable[[Any, PathLike], tuple[str, ...] | None] | None = None


@dataclass(frozen=True)
class WrittenMeasurement:
    """Result of writing a reflectance: the format, and its losses."""

    format: MeasuredFormat
    notes: tuple[str, ...] = ()


def tabulation_notes(value: Reflectance) -> tuple[str, ...]:
    """Return the notices for the user, each a clause."""
    notes = ["tabulated in 90 × 90 × 180 half-angle bins, as an isotropic and reciprocal reflectance"]
    if getattr(value, "wavelengths_nm", None) is not None:
        notes.append("its spectra were left out; the colours are those of the chosen observer under D65")
    return tuple(notes)
