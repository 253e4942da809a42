"""Exponents of the fixed set of cosine lobes.

The set is fixed because one environment map is prefiltered per exponent; an edit changes weights only
(Westlund and Meyer, sections 3.2 and 4). It was found by a search over a database of paints
(``basis_search``), whose stored answer is read here.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.documents.parameter import as_whole, describe
from brdf_suite.documents.reading import FieldReader, read_json
from brdf_suite.errors import DocumentError, FittingError
from brdf_suite.resources import resource

#: What the stored answer of a search calls itself.
STORED_FORMAT, STORED_VERSION = "lobe_basis", 1
STORED_NAME = "search.json"
#: More lobes than this no renderer of the suite takes.
MOST_LOBES = 12


@dataclass(frozen=True)
class LobeBasis:
    """Exponents of the cosine lobes ``(R·V)^E``, ascending, each ≥ 1 and all different (no unit).

    >>> LobeBasis((4.0, 16.0)).count
    2

    Raises
    ------
    FittingError
        No exponent, one that is not finite or below 1, or two that are equal or out of order.
    """

    exponents: tuple[float, ...]

    def __post_init__(self) -> None:
        values = tuple(float(e) for e in self.exponents)
        object.__setattr__(self, "exponents", values)
        if not values:
            raise FittingError("The lobe basis is empty; give at least one exponent.")
        for value in values:
            if not (math.isfinite(value) and value >= 1.0):
                raise FittingError(f"The lobe exponent {value:g} is not a finite number of at least 1.")
        for lower, upper in itertools.pairwise(values):
            if upper <= lower:
                found = f"{upper:g} follows {lower:g}"
                raise FittingError(f"The lobe exponents must ascend without repeats, but {found}.")

    @property
    def count(self) -> int:
        """Number of lobes."""
        return len(self.exponents)

    def array(self) -> Floats:
        """The exponents as a new array ``(m,)``."""
        return np.array(self.exponents, dtype=np.float64)


def log_spaced(count: int, low: float, high: float) -> LobeBasis:
    """Return ``count`` exponents from ``low`` to ``high`` in equal ratios.

    The paper's search found exponents "distributed somewhat regularly when graphed in log space" (its
    Figure 2). With ``count`` 1 the basis is ``low`` alone.

    >>> log_spaced(3, 2.0, 200.0).exponents
    (2.0, 20.0, 200.0)
    """
    if count < 1:
        raise FittingError(f"A lobe basis needs at least one lobe, not {count}.")
    if count > 1 and not 1.0 <= low < high:
        raise FittingError(f"Exponents from {low:g} to {high:g} do not ascend from at least 1.")
    steps = [low * (high / low) ** (k / max(count - 1, 1)) for k in range(count)]
    return LobeBasis(tuple(float(f"{e:.12g}") for e in steps))


def stored_bases(path: Path) -> tuple[dict[int, LobeBasis], int]:
    """Return the found basis of each count and the default count from the stored answer of a search.

    Raises
    ------
    DocumentError
        It is damaged; the message names the place.
    FileError
        It cannot be read.
    """
    reader = FieldReader(read_json(path), path)
    kind, version = reader.take("format"), reader.take("version")
    if (kind, version) != (STORED_FORMAT, STORED_VERSION) or isinstance(version, bool):
        reader.fail(f"this is no {STORED_FORMAT} of version {STORED_VERSION}", "format")
    bases: dict[int, LobeBasis] = {}
    for item in reader.take_objects("results"):
        values = item.take("exponents")
        if not isinstance(values, list) or not all(type(value) in (int, float) for value in values):
            item.fail("expected a list of numbers", "exponents")
        try:
            basis = LobeBasis(tuple(values))
        except FittingError as error:
            raise DocumentError(path, str(error).rstrip("."), item.where("exponents")) from error
        bases[basis.count] = basis
    count = as_whole(reader.take("default_count"))
    if not isinstance(count, int) or isinstance(count, bool) or count not in bases:
        reader.fail(f"there is no basis of {describe(count)} lobes", "default_count")
    return bases, count


def read_basis(path: Path, count: int | None = None) -> LobeBasis:
    """Return the basis of ``count`` lobes from a file of ``brdf-suite basis``; its default one where left out.

    Only ``format``, ``version``, ``default_count`` and the ``exponents`` of ``results`` are read.

    Raises
    ------
    DocumentError
        It is damaged, or has no basis of so many lobes, or one of more than :data:`MOST_LOBES`.
    FileError
        It cannot be read.
    """
    bases, default = stored_bases(path)
    wanted = default if count is None else count
    if wanted not in bases:
        known = ", ".join(str(one) for one in sorted(bases))
        raise DocumentError(path, f"there is no basis of {wanted} lobes; it has those of {known}", "results")
    if wanted > MOST_LOBES:
        raise DocumentError(path, f"at most {MOST_LOBES} lobes are drawn, not {wanted}", "results")
    return bases[wanted]


def shipped_basis(count: int | None = None) -> LobeBasis:
    """Return the suite's own basis of ``count`` lobes, the default one where left out; errors as :func:`read_basis`."""
    return default_basis() if count is None else read_basis(resource("basis", STORED_NAME), count)


@cache
def default_basis() -> LobeBasis:
    """Return the suite's default exponents; docs/method/basis.md describes how they were found and chosen.

    Raises
    ------
    FileError
        The packaged answer is missing or damaged; the install is.
    """
    return read_basis(resource("basis", STORED_NAME))
