"""Paint document of a product of textures, from a homomorphic factorization (McCool, Ang and Ahmad 2001).

The document names the maps and how each is read; the maps themselves are parts of one EXR file beside it, known by its
content's hash (``documents.factor_textures``). Values only; the reflectance room evaluates them. A bad value raises
:class:`ValueRangeError` whose ``place`` names the field.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from brdf_suite.documents.cook_torrance import Clearcoat, Rgb, check_rgb
from brdf_suite.documents.paint import Flakes
from brdf_suite.documents.parameter import (
    Parameter,
    check_flags,
    check_labels,
    check_parts,
    check_text,
    describe,
    set_number,
)
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.factor_words import Factor, parse_factors
from brdf_suite.notebook import Shown

_HASH = re.compile(r"[0-9a-f]{64}")

PARAMETERS: Mapping[str, Parameter] = {
    "alpha": Parameter("Scale", "1/sr", 0.0, 1e6, 1.0, "What the product of the maps is multiplied by")
}


@dataclass(frozen=True)
class TextureFile:
    """The EXR file of the maps: its ``path``, absolute after reading, and the SHA-256 of its bytes, in hex."""

    path: str
    sha256: str

    def __post_init__(self) -> None:
        check_text(self.path, "path", longest=4096, lines=False, empty=False)
        if not isinstance(self.sha256, str) or _HASH.fullmatch(self.sha256) is None:
            raise ValueRangeError("sha256", f"expected 64 hexadecimal digits, not {describe(self.sha256)}")


@dataclass(frozen=True)
class FactoredPaint(Shown):
    """f_r = ``alpha`` Π ``factors`` + Π ``peak``, in 1/sr, with a clearcoat over it where ``clearcoat`` is given.

    ``factors`` and ``peak`` are words ``map:projection``, ``p:wo q:h p:wi``; each map is the part of that name in
    ``textures``. ``peak`` may be empty: nothing is added. With ``logarithmic`` the maps are interpolated as logarithms.
    ``largest``: the largest sample that was factored, 1/sr; 0 where it is not known.
    """

    name: str
    textures: TextureFile
    factors: str
    alpha: Rgb
    peak: str = ""
    logarithmic: bool = True
    largest: float = 0.0
    clearcoat: Clearcoat | None = None
    flakes: Flakes | None = None
    notes: str = ""
    source: str = ""

    def __post_init__(self) -> None:
        check_labels(self)
        if not isinstance(self.textures, TextureFile):
            raise ValueRangeError("textures", f"expected a texture file, not {describe(self.textures)}")
        for place in ("factors", "peak") if self.peak != "" else ("factors",):
            text = getattr(self, place)
            check_text(text, place, longest=1000, lines=False, empty=False)
            try:
                parse_factors(text)
            except ValueRangeError as error:
                raise ValueRangeError(place, error.reason) from error
        object.__setattr__(self, "alpha", check_rgb(self.alpha, "alpha", PARAMETERS["alpha"]))
        check_flags(self, "logarithmic")
        set_number(self, Parameter("Largest", "1/sr", 0.0, 1e12, 0.0, ""), "largest")
        check_parts(self, clearcoat=(Clearcoat, "a clearcoat"), flakes=(Flakes, "flakes"))

    @property
    def terms(self) -> tuple[tuple[Factor, ...], tuple[Factor, ...]]:
        """The factors of the product, and those of the peak."""
        return parse_factors(self.factors), parse_factors(self.peak) if self.peak else ()
