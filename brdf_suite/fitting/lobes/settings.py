"""What can be chosen about a lobe fit: the exponents, the weights of the samples and the diffuse term."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal, get_args

from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.basis import LobeBasis, default_basis
from brdf_suite.fitting.lobes.program import Weighting, check_weighting

Diffuse = Literal["joint", "measured"]
"""Where KD comes from.

joint
    From the same program as the lobes.
measured
    From the base's value off the mirror direction with the light at the angle of incidence, as in section 4 of Westlund
    and Meyer; the lobes are fitted to the rest.
"""


@dataclass(frozen=True)
class FitSettings:
    """The exponents of a fit, and for paints with layers the weights of the samples and the diffuse term.

    A reflectance without layers is fitted by weights of its own, its diffuse term with the lobes
    (:mod:`brdf_suite.fitting.lobes.measured`): of these settings it takes the exponents alone.

    Raises
    ------
    FittingError
        An unknown weighting or way for the diffuse term.
    """

    basis: LobeBasis = field(default_factory=default_basis)
    weighting: Weighting = "absolute"
    diffuse: Diffuse = "joint"

    def __post_init__(self) -> None:
        check_weighting(self.weighting)
        if self.diffuse not in get_args(Diffuse):
            known = "choose 'joint' or 'measured'"
            raise FittingError(f"There is no way {self.diffuse!r} for the diffuse term; {known}.")

    @property
    def is_joint_and_absolute(self) -> bool:
        """Whether weighting and diffuse term are the default ones."""
        return (self.weighting, self.diffuse) == ("absolute", "joint")
