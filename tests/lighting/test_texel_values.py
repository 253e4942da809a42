"""What texels hold for the sake of look-ups: shared errors between them, the same bits from both ways."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.geometry.cube_map import texel_directions
from brdf_suite.lighting.filter.kernels import compilation as compiled
from brdf_suite.lighting.filter.texel_values import (
    BEND_SHARE,
    bends,
    edge_changes,
    pack_background,
    pack_lobe,
)

SIZE = 96


def lobe(towards: np.ndarray, exponent: float) -> np.ndarray:
    """A lobe about the middle of +Z."""
    return np.maximum(towards[..., 2] / np.linalg.norm(towards, axis=-1), 0.0) ** exponent


def test_texels_and_what_lies_between_share_the_error() -> None:
    """A bilinear look-up errs by E/F² of the peak at most; by half of that where texels hold less than their value."""
    exponent = (SIZE / 9.2) ** 2
    faces = np.repeat(lobe(texel_directions(SIZE), exponent)[..., None], 3, axis=-1)
    stored = (faces - BEND_SHARE * bends(faces))[4, ..., 0]
    line = (2.0 * np.arange(SIZE) + 1.0) / SIZE - 1.0
    between = 0.5 * (line[1:] + line[:-1])
    x, y = np.meshgrid(between, between)
    truth = lobe(np.stack([x, -y, np.ones_like(x)], axis=-1), exponent)

    def in_the_middle(texels: np.ndarray) -> np.ndarray:
        return (texels[1:, 1:] + texels[1:, :-1] + texels[:-1, 1:] + texels[:-1, :-1]) / 4.0

    unshared = exponent / SIZE**2
    assert np.abs(in_the_middle(faces[4, ..., 0]) - truth).max() == pytest.approx(unshared, rel=0.05)
    for error in (in_the_middle(stored) - truth, stored - faces[4, ..., 0]):
        assert np.abs(error).max() == pytest.approx(0.5 * unshared, rel=0.05)


def test_light_that_does_not_bend_stays_as_it_is() -> None:
    white = np.full((6, 16, 16, 3), 0.75, dtype=np.float32)
    assert np.array_equal(bends(white), np.zeros_like(white))
    assert (pack_lobe(white).radiance() == 0.75).all()


@pytest.mark.usefixtures("kernels_compiled")
@given(seed=st.integers(0, 2**32 - 1), decades=st.floats(0.0, 12.0), gain=st.floats(1e-30, 1e30))
def test_half_floats_are_numpys_own(seed: int, decades: float, gain: float) -> None:
    """Also those too small for a whole mantissa, and 0 for what is negative."""
    rng = np.random.default_rng(seed)
    faces = (10.0 ** rng.uniform(-decades, 0.0, (6, 10, 10, 3)) * gain).astype(np.float32)
    faces[0, 0, :3] = [[-gain], [0.0], [gain]]
    kernels = compiled.compile_now()
    assert kernels is not None
    packed = pack_background(faces)
    assert np.array_equal(packed.faces, np.maximum(faces / np.float32(packed.scale), 0.0).astype(np.float16))
    assert 25000.0 <= packed.faces.max() <= 50000.0 or packed.scale == 2.0**-100


@pytest.mark.usefixtures("kernels_compiled")
def test_kernels_pack_a_lobe_as_plain_numpy_does(monkeypatch: pytest.MonkeyPatch) -> None:
    compiled.compile_now()
    faces = np.random.default_rng(3).random((6, 14, 14, 3)).astype(np.float32)
    fast = pack_lobe(faces).radiance()
    monkeypatch.setattr(compiled._State, "kernels", None)
    plain = pack_lobe(faces).radiance()
    assert np.abs(fast - plain).max() <= 1e-3
    assert np.abs(plain - faces).max() > 0.05
    assert np.abs(edge_changes(faces)).max() > 0.01
