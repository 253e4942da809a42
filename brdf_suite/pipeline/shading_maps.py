"""Which maps an environment is filtered to, so that the shading can look lobes up at any exponent."""

from __future__ import annotations

from brdf_suite.fitting.lobes.basis import LobeBasis, default_basis
from brdf_suite.realtime.environment.ladder import BROADEST_SHARP

STACK_RATIO = 1.5
"""Between neighbouring slices of the stack: halfway, a mixture of the two errs by 1 % of the lobe's peak."""

STACK_EXPONENTS: tuple[float, ...] = tuple(float(STACK_RATIO**i) for i in range(12))
"""1 (the diffuse map) to 86.5: the broad lobes of the default basis, and what they are looked up as."""


def map_exponents(basis: LobeBasis | None = None) -> tuple[float, ...]:
    """Return the exponents, rising: the stack's, and those of ``basis`` that are too sharp for it.

    >>> from brdf_suite.fitting.lobes.basis import LobeBasis
    >>> map_exponents(LobeBasis((3.0, 500.0)))[-2:]
    (86.49755859375, 500.0)
    """
    sharp = tuple(sorted(e for e in (basis or default_basis()).exponents if e > BROADEST_SHARP))
    return STACK_EXPONENTS + sharp
