"""Narrow lobes sampled about their half vector by a cosine lobe (Günther et al. 2005, section 5.1.3).

Beckmann's facets of slope m are taken for a cosine lobe of the same height,

    exp(-tan²θ / m²) / (4 m² cos⁴θ) ≈ (n + 1) / (2π) cosⁿθ,    n = 2π / (4 m²) - 1,

which is sampled by θ = arccos(r1^(1/(n+1))), φ = 2π r2 for the half vector h; the view mirrored at h has the density

    pdf(ω) = (n + 1) / (2π) cosⁿθh / (4 h·ωo).

The cosine lobe is a little wider than the facets: f_r cosθ over pdf stays below 4/π of its value in the middle. The
paper's equation 5 prints neither the 1/s nor the cosine: a picture is the mean of f_r (N·ω) L / pdf.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

from brdf_suite.reference.bsdfs import directions as d
from brdf_suite.reference.bsdfs.directions import Colour, Half, Real, Square, Vector
from brdf_suite.reference.bsdfs.terms import AboutMirror, FacetLobe, Facets
from brdf_suite.reference.mitsuba_modules import dr

_EVEN = 1e4
LARGEST_SLOPE = 0.12
"""Facets up to this slope are narrow: sampled. Wider ones are lit by the lights."""
LEAST_SUNLIT_SLOPE = 0.035
"""Narrow facets from this slope on are lit by suns as by lamps: most of their few rays would miss such a light."""
LARGEST_MIRROR_SLOPE = 0.05
"""The same where narrow lobes are mirrored: of a wider one the mirror image would be no likeness."""


def equivalent_exponent(slope: float) -> float:
    """Return n of the cosine lobe that represents facets of ``slope`` m.

    >>> round(equivalent_exponent(0.1), 2)
    156.08
    """
    return 2.0 * math.pi / (4.0 * slope * slope) - 1.0


def cosine_lobe_mirrored(view: Vector, u: Square, exponent: Real) -> Vector:
    """Return the view mirrored at half vectors of a cosine lobe about the normal; some lie below the horizon."""
    # cos θ = r^(1/(n+1)), so tan² θ = exp(-2 ln r / (n+1)) - 1: no difference of numbers near 1.
    tan2 = d.exp_minus_one(-2.0 * dr.log(dr.maximum(1.0 - u.x, 1e-30)) / (exponent + 1.0))
    return d.mirrored_at(view, tan2, u.y)


def cosine_lobe_pdf(half: Half, exponent: Real) -> Real:
    """Return the density of :func:`cosine_lobe_mirrored` per solid angle."""
    power = dr.exp(-0.5 * exponent * d.log_one_plus(half.tan2_h))
    return (exponent + 1.0) * (0.5 / math.pi) * power / (4.0 * half.cos_d)


@dataclass(frozen=True, eq=False)
class FacetGlint(Facets):
    """A narrow microfacet lobe: a ``term`` with its value, sampled as a cosine lobe.

    ``weight`` is how much the lobe sends of what all narrow ones do, as a luminance.
    """

    term: Any = None

    @property
    def is_sunlit(self) -> bool:
        """Whether suns light it, and its rays leave them out."""
        return self.slope >= LEAST_SUNLIT_SLOPE

    def sample(self, view: Vector, u: Square) -> Vector:
        """Return directions to the light."""
        return cosine_lobe_mirrored(view, u, d.number(equivalent_exponent(self.slope)))

    def pdf(self, light: Vector, view: Vector) -> Real:
        """Return the density of :meth:`sample` per solid angle."""
        return cosine_lobe_pdf(Half.of(light, view), d.number(equivalent_exponent(self.slope)))


@dataclass(frozen=True, eq=False)
class MirrorLobe(AboutMirror):
    """A narrow cosine lobe of fitted weights about the mirror direction, sampled by itself; ``term`` has its value."""

    term: Any = None

    @property
    def is_sunlit(self) -> bool:
        """Whether suns light it, and its rays leave them out."""
        return self.exponent <= 0.5 / LEAST_SUNLIT_SLOPE**2


@dataclass(frozen=True, eq=False)
class WideFacets:
    """A broad microfacet lobe, widened by the extent of a light.

    A light's directions of standard deviation σ along an axis spread the half vector by σ/2; Beckmann's facets of slope
    m spread it by m/√2. Together they are facets of m² + σ²/2. So the l lights make one highlight together, where
    points would make l of them; as l grows, nothing is left of it.
    """

    term: FacetLobe

    def eval(self, light: Vector, view: Vector) -> Colour:
        """Return f_r in 1/sr."""
        return self.term.eval(light, view)

    def lit(self, light: Vector, view: Vector, spread: Real) -> Colour:
        """Return the mean f_r for a light whose directions have ``spread``, radians along an axis."""
        half = Half.of(light, view)
        wide = d.number(self.term.slope**2) + 0.5 * dr.square(spread)
        # With facets of all slopes alike, all of the lobe is left but their distribution.
        even = replace(self.term, slope=_EVEN).eval(light, view)
        return even * (dr.exp(-half.tan2_h / wide) * _EVEN**2 / wide)
