"""Photographs of a painted sphere become a table, Cook-Torrance lobes, and a paint (needs the extra acquisition)."""

import brdf_suite as bs

bs.simulate(
    "table1_white", "session", size=(96, 96), positions=12, exposures=4
)  # or photographs of one's own
acquired = bs.acquire("session", "sphere.brdftable")
fitted = bs.fit_cook_torrance("sphere.brdftable", lobes=1, starts=2, samples=1000)
print(f"{acquired.readings:,} readings; mean |ln(fit/measured)| {fitted.errors.l1_mean:.3f}")
bs.save(fitted, "sphere.brdfpaint")
