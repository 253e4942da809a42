"""Flakes of a paint of Cook-Torrance lobes: their tilts are those of a lobe's facets."""

from __future__ import annotations

from dataclasses import replace

from brdf_suite.appearance.flakes.visible import full_density
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.paint import PARAMETERS, Flakes

DEFAULT_SIZE_UM = 20.0
"""Mean diameter of a common aluminium flake; it is not in the lobes."""
SHARPEST_FLAKES = 0.05
"""Spread of slopes below which a lobe is a coat's gloss: flakes of a paint are tilted by more."""


def flakes_of_lobes(
    paint: CookTorrancePaint, size_um: float = DEFAULT_SIZE_UM, density_per_mm2: float | None = None
) -> Flakes | None:
    """Return the flakes of a metallic paint of which lobes are known, or None where no lobe can be theirs.

    Günther et al. 2005, section 5.2, draw flakes from the distribution of the paint's facets. Theirs is the highest
    lobe, by ks / m², of those at least as wide as :data:`SHARPEST_FLAKES`. Below a coat of index n a flake of the tilt
    δ mirrors as a facet in air of about n δ, so the spread is m / n. A rough surface has such lobes too, and size and
    density are not in them: ``size_um`` is in µm, ``density_per_mm2`` as many as lie side by side unless given.

    Raises
    ------
    ValueRangeError
        Size or density is out of a flake's range.

    >>> from brdf_suite.documents.cook_torrance import CookTorranceLobe
    >>> lobes = [CookTorranceLobe((ks, ks, ks), m, 0.9) for ks, m in ((0.08, 0.38), (0.12, 0.17), (0.01, 0.013))]
    >>> flakes_of_lobes(CookTorrancePaint("silver", (0.0, 0.0, 0.0), tuple(lobes))).roughness
    0.17
    """
    ior = 1.0 if paint.clearcoat is None else paint.clearcoat.ior
    most = PARAMETERS["flakes.roughness"].high * ior
    wide = [lobe for lobe in paint.lobes if SHARPEST_FLAKES <= lobe.m <= most and max(lobe.ks) > 0.0]
    if not wide:
        return None
    found = max(wide, key=lambda lobe: sum(lobe.ks) / lobe.m**2)
    flakes = Flakes(0.0, size_um, found.m / ior)
    if density_per_mm2 is None:  # an assumption, so rounded
        density_per_mm2 = min(
            float(f"{full_density(size_um):.3g}"), PARAMETERS["flakes.density_per_mm2"].high
        )
    return replace(flakes, density_per_mm2=density_per_mm2)
