"""Settings of a fit of Cook-Torrance lobes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from brdf_suite.errors import ValueRangeError

ModelName = Literal["cook-torrance", "ggx", "ggx-clearcoat"]
MODELS: tuple[str, ...] = get_args(ModelName)
Loss = Literal["l1", "l2", "robust"]
LOSSES: tuple[str, ...] = get_args(Loss)

MOST_LOBES = 6
"""More than twice the paper's number; further lobes cannot be resolved by any measurement."""


@dataclass(frozen=True)
class Settings:
    """Settings of a fit.

    Attributes
    ----------
    lobes
        1 to 6; that of the smallest slope stands last. A clearcoat is one of them.
    model
        ``cook-torrance``: equation 1 of Günther et al. 2005. ``ggx``: the same with facets of GGX and their shadowing.
        ``ggx-clearcoat``: lobes of GGX below a colourless coat, which is the last lobe and takes light from the rest.
    loss
        ``l1``: |log(fit/measured)|, the paper's. ``l2``: its square. ``robust``: Cauchy's, whose outliers count for
        almost nothing.
    starts
        1 to 64: from how many places the search sets out.
    seed
        Of the drawn starts and of the choice of samples.
    samples
        100 to 200,000: the most that the solver looks at.
    grazing_deg
        10 to 90: samples with light or view beyond this polar angle are left out.

    Raises
    ------
    ValueRangeError
        A setting is out of its range.
    """

    lobes: int = 3
    model: ModelName = "cook-torrance"
    loss: Loss = "l1"
    starts: int = 8
    seed: int = 0
    samples: int = 6000
    grazing_deg: float = 80.0

    def __post_init__(self) -> None:
        _whole("lobes", self.lobes, 1, MOST_LOBES)
        _whole("starts", self.starts, 1, 64)
        _whole("seed", self.seed, 0, 2**32 - 1)
        _whole("samples", self.samples, 100, 200_000)
        if self.model not in MODELS:
            raise ValueRangeError("model", f"expected one of {', '.join(MODELS)}, not {self.model!r}")
        if self.loss not in LOSSES:
            raise ValueRangeError("loss", f"expected one of {', '.join(LOSSES)}, not {self.loss!r}")
        # A NaN fails the comparison, as it should.
        if not 10.0 <= self.grazing_deg <= 90.0:
            raise ValueRangeError("grazing_deg", f"{self.grazing_deg:g}° is outside the range 10° to 90°")


def _whole(place: str, value: object, low: int, high: int) -> None:
    if isinstance(value, bool) or not isinstance(value, int) or not low <= value <= high:
        raise ValueRangeError(place, f"expected a whole number from {low} to {high:,}, not {value!r}")
