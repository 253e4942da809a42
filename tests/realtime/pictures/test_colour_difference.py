"""ΔE00 and L*a*b* on the GPU against their twins in numpy."""

from __future__ import annotations

import numpy as np

from brdf_suite.appearance.colour.colorimetry import RELATIVE_TO_WORKING, working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000

# Sharma, Wu and Dalal 2005, Table 1: pairs where implementations go wrong (hues on both sides of 0° and 180°, greys).
PAIRS = np.array(
    [
        [[50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485]],
        [[50.0, -1.0, 2.0], [50.0, 0.0, 0.0]],
        [[50.0, 2.49, -0.001], [50.0, -2.49, 0.0009]],
        [[50.0, 2.49, -0.001], [50.0, -2.49, 0.0011]],
        [[50.0, -0.001, 2.49], [50.0, 0.0009, -2.49]],
        [[50.0, 2.5, 0.0], [73.0, 25.0, -18.0]],
        [[63.0109, -31.0961, -5.8663], [62.8187, -29.7946, -4.0864]],
        [[22.7233, 20.0904, -46.694], [23.0331, 14.973, -42.5619]],
        [[2.0776, 0.0795, -1.135], [0.9033, -0.0636, -0.5514]],
        [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0]],
        [[250.0, 0.0, 0.0], [180.0, 90.0, -60.0]],
    ]
)


def test_delta_e_2000(evaluate):
    random = np.random.default_rng(5)
    spread = random.uniform([0.0, -90.0, -90.0], [140.0, 90.0, 90.0], (600, 2, 3))
    close = spread.copy()
    close[:, 1] = close[:, 0] + random.normal(0.0, 1.0, (600, 3))
    pairs = np.concatenate([PAIRS, spread, close]).astype(np.float32)
    # Two texels hold a pair: the second colour in the next one.
    flat = np.concatenate([pairs.reshape(-1, 3), np.ones((2 * len(pairs), 1))], 1)
    lit = evaluate(
        "colour_difference.glsl",
        "vec4(delta_e_2000(x.xyz, texelFetch(points, ivec2(gl_FragCoord.xy) ^ ivec2(1, 0), 0).xyz))",
        flat,
    )[:, 0]
    wanted = delta_e_2000(pairs[:, 0], pairs[:, 1])
    # Where the hues are half a turn apart, which way round is a matter of the last bit.
    np.testing.assert_allclose(lit[::2], wanted, rtol=2e-3, atol=2e-3)
    np.testing.assert_allclose(lit[1::2], wanted, rtol=2e-3, atol=2e-3)


def test_lab_of_the_working_space(evaluate):
    levels = np.array([0.0, 1e-4, 0.004, 0.03, 0.18, 0.7, 1.0, 2.5, 30.0])
    grid = np.stack(np.meshgrid(levels, levels, levels), -1).reshape(-1, 3)
    relative = grid @ np.linalg.inv(RELATIVE_TO_WORKING)
    got = evaluate(
        "colour_difference.glsl",
        "vec4(lab_of_relative(x.xyz), 1.0)",
        np.concatenate([relative, np.ones((len(grid), 1))], 1),
    )[:, :3]
    np.testing.assert_allclose(got, working_to_lab(grid), rtol=2e-4, atol=2e-3)
