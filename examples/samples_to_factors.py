"""Values at scattered pairs of directions become a product of small textures."""

import numpy as np

import brdf_suite as bs

rng = np.random.default_rng(1)
wi, wo = bs.spherical(np.arccos(rng.uniform(0.1, 1.0, (2, 5000))), rng.uniform(0.0, 2.0 * np.pi, (2, 5000)))
product = bs.factorize(
    wi, wo, bs.load("fine_silver", bs.Material).eval(wi, wo)
)  # or measured values, (n, 3), 1/sr
print(product.factors, product.accuracy.median_relative, bs.save(product, "factors.brdfpaint"))
