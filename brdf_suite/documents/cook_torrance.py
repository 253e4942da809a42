"""Paint document of Cook-Torrance lobes, as fitted to measured data (Günther et al. 2005, section 4.2).

Values only; the reflectance room evaluates them. A bad value raises :class:`ValueRangeError` whose ``place``
names the field (``lobes[1].ks[0]``).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal, get_args

from brdf_suite.documents.paint import SCATTERINGS, Flakes, Scattering
from brdf_suite.documents.parameter import (
    Parameter,
    check_choices,
    check_items,
    check_labels,
    check_parts,
    describe,
    set_numbers,
)
from brdf_suite.errors import ValueRangeError
from brdf_suite.notebook import Shown

DistributionNorm = Literal["full", "quarter"]
DISTRIBUTION_NORMS: tuple[str, ...] = get_args(DistributionNorm)
Rgb = tuple[float, float, float]

# The paper uses three; a fit with more than a dozen is a damaged file.
_MOST_LOBES = 16

PARAMETERS: Mapping[str, Parameter] = {
    "kd": Parameter("Diffuse", "", 0.0, 10.0, 0.1, "Diffuse reflectance, linear Rec. 2020"),
    "lobes[].ks": Parameter("Specular", "", 0.0, 100.0, 0.1, "Weight of the lobe, linear Rec. 2020"),
    "lobes[].m": Parameter("Slope", "", 1e-4, 10.0, 0.2, "Root-mean-square slope of the facets"),
    "lobes[].r": Parameter("Reflectance", "", 0.0, 1.0, 0.04, "Fresnel reflectance along the normal"),
    "clearcoat.ior": Parameter("Index", "", 1.0, 3.0, 1.5, "Index of refraction of the clearcoat"),
    "clearcoat.roughness": Parameter("Roughness", "", 0.001, 1.0, 0.002, "Beckmann α of the clearcoat"),
}


@dataclass(frozen=True)
class CookTorranceLobe:
    """One lobe: weight ``ks`` (linear Rec. 2020), facet slope ``m``, Fresnel reflectance ``r`` at the normal."""

    ks: Rgb
    m: float
    r: float

    def __post_init__(self) -> None:
        object.__setattr__(self, "ks", check_rgb(self.ks, "ks", PARAMETERS["lobes[].ks"]))
        set_numbers(self, PARAMETERS, "m", "r", group="lobes[].")


@dataclass(frozen=True)
class Clearcoat:
    """A clear dielectric layer over the paint: index of refraction, Beckmann roughness, how light scatters."""

    ior: float = 1.5
    roughness: float = 0.002
    scattering: Scattering = "multiple"

    def __post_init__(self) -> None:
        set_numbers(self, PARAMETERS, "ior", "roughness", group="clearcoat.")
        check_choices(self, scattering=SCATTERINGS)


@dataclass(frozen=True)
class CookTorrancePaint(Shown):
    """Diffuse part and lobes, with a clearcoat over them where ``clearcoat`` is given.

    ``d_norm`` says which normalisation of the facet distribution the weights belong to: ``full`` that of
    equation 1 of the paper, ``quarter`` that of its section 5.1.3, a fourth of it.

    >>> CookTorrancePaint("grey", (0.2, 0.2, 0.2)).kd
    (0.2, 0.2, 0.2)
    """

    name: str
    kd: Rgb
    lobes: tuple[CookTorranceLobe, ...] = ()
    d_norm: DistributionNorm = "full"
    clearcoat: Clearcoat | None = None
    flakes: Flakes | None = None
    notes: str = ""
    source: str = ""

    def __post_init__(self) -> None:
        check_labels(self)
        object.__setattr__(self, "kd", check_rgb(self.kd, "kd", PARAMETERS["kd"]))
        object.__setattr__(self, "lobes", check_items(self.lobes, "lobes", CookTorranceLobe, _MOST_LOBES))
        check_choices(self, d_norm=DISTRIBUTION_NORMS)
        check_parts(self, clearcoat=(Clearcoat, "a clearcoat"), flakes=(Flakes, "flakes"))


def check_rgb(value: object, place: str, parameter: Parameter) -> Rgb:
    """Return three numbers in the parameter's range; raise :class:`ValueRangeError` naming the channel."""
    if not isinstance(value, (tuple, list)) or len(value) != 3:
        raise ValueRangeError(place, f"expected three numbers red, green, blue, not {describe(value)}")
    red, green, blue = (parameter.check(value[i], f"{place}[{i}]") for i in range(3))
    return (red, green, blue)
