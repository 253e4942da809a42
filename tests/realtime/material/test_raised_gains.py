"""Fresnel's gains in Python are those of the shader, where both have one angle."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import moderngl
import numpy as np
import pytest

from brdf_suite.arrays import Floats
from brdf_suite.fitting import LobeWeights
from brdf_suite.fitting.lobes.weights import RaisedWeights
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.realtime.environment.ladder import Ladder
from brdf_suite.realtime.environment.look_up_table import RAMP_COSINES
from brdf_suite.realtime.material.material_set import pack
from brdf_suite.realtime.material.ramp import MAX_BROAD, make_ramp
from brdf_suite.realtime.values import Coat, MaterialWeights

COSINES = np.linspace(0.0, 1.0, 101)


def gains_of_the_shader(
    context: moderngl.Context,
    evaluate: Callable[..., Floats],
    folder: Path,
    weights: LobeWeights,
    coat: Coat,
) -> tuple[Floats, Floats]:
    (folder / "gains.glsl").write_text(
        f'#define MAX_BROAD {MAX_BROAD}\n#define FRESNEL_RAISED 1\n#include "material.glsl"\n'
        "vec4 gains(float c) { vec3 base, gloss; fresnel_gains(c, base, gloss); return vec4(base.r, gloss.rgb); }\n"
    )
    material = MaterialWeights(
        tuple(weights.exponents),
        weights.kd,
        weights.kdd,
        weights.kg,
        weights.theta_fit_rad,
        weights.ior,
        coat,
    )
    ramp = make_ramp(material, "raised", "paper", Ladder((1.0, 8.0)))
    block = context.buffer(pack(material, ramp))
    block.bind_to_uniform_block(0)
    got = evaluate("gains.glsl", "gains(x.x)", np.tile(COSINES[:, None], 4))
    block.release()
    # The ramp, which lobes are looked up with, has the same gains.
    base, gloss = RaisedWeights(weights, "view").gains(RAMP_COSINES)
    np.testing.assert_allclose(ramp.rows[0, :, 0], np.pi * weights.kd[0] * base, rtol=2e-5, atol=1e-6)
    if ramp.sharp:
        energy = weights.kg[1, 0] * 2.0 * np.pi / 2001.0
        np.testing.assert_allclose(ramp.rows[1, :, 0], energy * gloss, rtol=2e-4, atol=1e-6)
    return got[:, 0], got[:, 1]


@pytest.mark.parametrize("ior", [1.0, 1.3, 1.5, 1.8])
@pytest.mark.parametrize("theta_fit_deg", [20.0, 45.0, 70.0])
@pytest.mark.parametrize(("under", "coat"), [(True, "dielectric"), (False, "facets")])
@pytest.mark.parametrize("share", [1.0, 3.0])
def test_gains(
    context: moderngl.Context,
    evaluate: Callable[..., Floats],
    tmp_path: Path,
    ior: float,
    theta_fit_deg: float,
    under: bool,
    coat: Coat,
    share: float,
) -> None:
    theta = np.radians(theta_fit_deg)
    energy = share * float(fresnel_dielectric(np.cos(theta), ior))
    weights = LobeWeights(
        exponents=np.array([5.0, 2000.0]),
        kd=np.full(3, 0.1),
        kdd=np.array([np.full(3, 0.2), np.zeros(3)]),
        kg=np.array([np.zeros(3), np.full(3, energy * 2001.0 / (2.0 * np.pi))]),
        theta_fit_rad=float(theta),
        ior=ior,
        base_under_coat=under,
    )
    base, gloss = gains_of_the_shader(context, evaluate, tmp_path, weights, coat)
    raised = RaisedWeights(weights, "view")
    wanted_base, wanted_gloss = raised.gains(COSINES)
    np.testing.assert_allclose(base, wanted_base, rtol=2e-5, atol=2e-6)
    np.testing.assert_allclose(gloss, wanted_gloss, rtol=2e-4, atol=2e-6)
