"""Maps for small pictures are what the next mip level of the whole ones would be."""

from __future__ import annotations

import numpy as np

from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.filter.face_array import FaceArray
from brdf_suite.lighting.filter.lobe_maps import LobeMaps
from brdf_suite.output.still import with_smaller_maps
from brdf_suite.pipeline.scene import PreparedEnvironment


def test_large_maps_are_halved_and_small_ones_stay() -> None:
    rng = np.random.default_rng(2)
    file = rng.random(6 * 1024 * 1024 * 3 + 6 * 64 * 64 * 3).astype(np.float16)
    large = FaceArray(file[: 6 * 1024 * 1024 * 3].reshape(6, 1024, 1024, 3), 4.0)
    small = FaceArray(file[6 * 1024 * 1024 * 3 :].reshape(6, 64, 64, 3), 0.5)
    light = Environment("x", np.ones((8, 16, 3), np.float32))
    maps = LobeMaps((5.0, 900.0, 5000.0), (small, large, large), small, small, large)
    found = with_smaller_maps(PreparedEnvironment("x", light, maps, True), 300).maps
    # 256 texels are the least that mip levels are made of, so one halving more than 300 asks for is not done.
    assert [lobe.size for lobe in found.lobes] == [64, 256, 256]
    assert found.lobes[1].scale == 4.0
    assert found.lobes[1].faces is found.lobes[2].faces is found.background.faces
    assert (found.diffuse.faces == small.faces).all()
    blocks = large.faces.astype(np.float64).reshape(6, 256, 4, 256, 4, 3).mean(axis=(2, 4))
    assert np.abs(found.background.faces - blocks).max() < 1e-3
    # Nothing of the file's bytes is held any longer.
    assert not any(np.shares_memory(lobe.faces, file) for lobe in (*found.lobes, found.diffuse))
