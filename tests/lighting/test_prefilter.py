"""The prefilter against the brute-force double sum, and the properties that the shading relies on."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.errors import Cancelled, ValueRangeError
from brdf_suite.files.images.environments import read_environment_image
from brdf_suite.geometry.cube_map import texel_directions
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.filter.face_array import pack_faces
from brdf_suite.lighting.filter.harmonics import BROAD_BANDLIMIT, lobe_bandlimit
from brdf_suite.lighting.filter.kernels import compilation as compiled
from brdf_suite.lighting.filter.lobe_filter import LobeFilter
from brdf_suite.lighting.filter.lobe_maps import background_size, face_size, prefilter
from brdf_suite.lighting.filter.texel_values import pack_lobe
from brdf_suite.lighting.latlong import column_angles, direction, fejer_weights, ring_angles

EXPONENTS = (1.0, 2.0, 3.7, 20.0, 320.0, 3500.0)


pytestmark = pytest.mark.usefixtures("kernels_compiled")


@pytest.mark.parametrize("plain", [False, True])
@pytest.mark.parametrize("exponent", EXPONENTS)
def test_error_against_the_double_sum(
    rough_map: np.ndarray, exponent: float, double_sum: Callable[..., np.ndarray], plain: bool
) -> None:
    size = 64 if exponent < 1000.0 else 256
    lobe_filter = LobeFilter(rough_map, plain=plain)
    assert lobe_filter.compiled is not plain
    got = lobe_filter.lobe(exponent, size)
    rng = np.random.default_rng(5)
    places = rng.integers(0, [6, size, size], size=(60, 3))
    brightest = np.unravel_index(got.max(axis=3).argmax(), got.shape[:3])
    at = tuple(np.vstack([places, brightest]).T)
    truth = double_sum(rough_map, texel_directions(size)[at], exponent)
    bound = 2e-4 if exponent < 2.0 else 1e-6
    assert np.abs(got[at] - truth).max() <= bound * got.max()


@pytest.mark.parametrize("plain", [False, True])
def test_light_through_a_coat_against_the_double_sum(rough_map: np.ndarray, plain: bool) -> None:
    """Σ L cos T(cos) over the half sphere, by the share of it that constant light has."""
    got = LobeFilter(rough_map, plain=plain).through_coat(64)
    places = np.random.default_rng(6).integers(0, [6, 64, 64], size=(40, 3))
    brightest = np.unravel_index(got.max(axis=3).argmax(), got.shape[:3])
    at = tuple(np.vstack([places, brightest]).T)
    rings, columns = rough_map.shape[:2]
    towards = direction(ring_angles(rings)[:, None], column_angles(columns)[None]).reshape(-1, 3)
    weights = np.repeat(fejer_weights(rings) * (2.0 * np.pi / columns), columns)
    flux = rough_map.reshape(-1, 3).astype(np.float64) * weights[:, None]
    x, share = np.polynomial.legendre.leggauss(400)
    cosine = 0.5 * (x + 1.0)
    whole = np.pi * float((share * cosine * (1.0 - fresnel_dielectric(cosine, 1.5))).sum())
    for wanted, value in zip(texel_directions(64)[at], got[at], strict=True):
        cosine = np.maximum(towards @ wanted, 0.0)
        truth = (cosine * (1.0 - fresnel_dielectric(cosine, 1.5)) / whole) @ flux
        assert np.abs(value - truth).max() <= 2e-4 * got.max()


@pytest.mark.parametrize("rings", [8, 257])
def test_constant_light_stays_constant(rings: int) -> None:
    white = np.ones((rings, 2 * rings, 3), dtype=np.float32) * np.float32(2.0)
    lobe_filter = LobeFilter(white)
    for exponent in (1.0, 2.5, 40.0, 900.0, lobe_filter.largest_exponent):
        assert np.abs(lobe_filter.lobe(exponent, 64) - 2.0).max() <= 1e-4 * 2.0
    packed = prefilter(Environment("white", white), [1.0, 40.0, 60000.0])
    for item in (*packed.lobes, packed.diffuse, packed.through_coat, packed.background):
        assert np.abs(item.radiance() - 2.0).max() <= 2.0 * 2.0**-11


def test_a_sun_of_one_texel_leaves_the_sky_right_and_nothing_negative(
    double_sum: Callable[..., np.ndarray],
) -> None:
    sky = np.full((256, 512, 3), 1.0, dtype=np.float32)
    with_sun = sky.copy()
    with_sun[70, 200] = 1e5
    places = texel_directions(64)
    for exponent in (1.0, 2.0, 20.0, 300.0, 2000.0):
        got = LobeFilter(with_sun).lobe(exponent, 64)
        assert got.min() > 0.0
        at = tuple(np.random.default_rng(1).integers(0, [6, 64, 64], size=(40, 3)).T)
        truth = double_sum(with_sun, places[at], exponent)
        assert (np.abs(got[at] - truth) / truth).max() < 1e-3, exponent


def test_turning_the_light_turns_the_maps(rough_map: np.ndarray) -> None:
    turned = np.roll(rough_map, 128, axis=1)  # a quarter turn, towards growing u
    before = LobeFilter(rough_map).lobe(200.0, 64)
    after = LobeFilter(turned).lobe(200.0, 64)
    # +z goes to -x goes to -z goes to +x; these faces all have their rows downwards.
    for old, new in ((4, 1), (1, 5), (5, 0), (0, 4)):
        assert np.abs(after[new] - before[old]).max() < 1e-6 * before.max()


def test_light_is_found_where_it_is() -> None:
    for axis, (row, column) in {2: (64, 128), 0: (64, 64), 1: (0, 0)}.items():
        pixels = np.zeros((128, 256, 3), dtype=np.float32)
        pixels[row, column] = 1.0
        faces = LobeFilter(pixels).lobe(300.0, 64)
        where = np.unravel_index(faces[..., 1].argmax(), faces.shape[:3])
        assert texel_directions(64)[where][axis] > 0.99


def test_exponents_beyond_the_maps_sharpness_share_the_background(rough_map: np.ndarray) -> None:
    maps = prefilter(Environment("rough", rough_map), [50000.0, 10.0])
    assert maps.exponents == (50000.0, 10.0)
    assert maps.lobes[0] is maps.background
    assert maps.background.size == background_size(Environment("rough", rough_map)) == 256
    assert maps.lobes[1].size == 64
    assert maps.lobes[1].faces.flags.c_contiguous


def test_faces_meet_without_a_seam(rough_map: np.ndarray) -> None:
    """Beside an edge, neighbours on two faces differ no more than neighbours on one."""
    faces = LobeFilter(rough_map).lobe(50.0, 64)
    across = np.abs(faces[4][:, 0] - faces[1][:, -1]).max()
    top = np.abs(faces[4][0] - faces[2][-1]).max()
    within = np.abs(np.diff(faces[4], axis=1)).max()
    assert max(across, top) < 2.0 * within
    assert within > 0.0


def test_sizes_follow_the_exponent() -> None:
    sizes = [face_size(exponent) for exponent in (1.0, 30.0, 100.0, 1000.0, 1e6)]
    assert sizes == sorted(sizes)
    assert (sizes[0], sizes[-1]) == (64, 2048)
    assert all(face_size(e) >= 9.2 * e**0.5 for e in (50.0, 500.0, 5000.0))


def test_broad_maps_come_first_and_progress_rises_to_one(rough_map: np.ndarray) -> None:
    seen: list[float | None] = []
    fractions: list[float] = []
    prefilter(
        Environment("rough", rough_map),
        [900.0, 5.0],
        lambda fraction, what: fractions.append(fraction),
        lambda exponent, faces: seen.append(exponent),
    )
    assert seen == [1.0, 5.0, 900.0, None]
    assert fractions == sorted(fractions)
    assert fractions[-1] == 1.0
    assert len(fractions) > 10


@pytest.mark.usefixtures("kernels_compiled")
def test_a_ladder_of_exponents_costs_one_analysis(
    rough_map: np.ndarray, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Exponents need not be those of a basis: any number, in any order, whole or not, one of them twice."""
    kernels = compiled.compile_now()
    assert kernels is not None
    limits: list[int] = []
    real = kernels.analyse

    def counted(pixels: np.ndarray, weights: np.ndarray, bandlimit: int, *rest: object) -> np.ndarray:
        limits.append(bandlimit)
        return real(pixels, weights, bandlimit, *rest)

    monkeypatch.setattr(kernels, "analyse", counted)
    ladder = [1.5**k for k in range(1, 20)]
    wanted = [*ladder[::2], 1e6, *ladder[1::2], ladder[4]]
    seen: list[float | None] = []
    maps = prefilter(
        Environment("rough", rough_map), wanted, None, lambda exponent, faces: seen.append(exponent)
    )
    broad = [exponent for exponent in ladder if lobe_bandlimit(exponent) <= BROAD_BANDLIMIT]
    assert seen == [1.0, *broad, None, *ladder[len(broad) :]]  # the sharpest after there is a picture to show
    assert 15 < len(broad) < len(ladder)
    assert limits == [lobe_bandlimit(ladder[-1])]
    assert maps.exponents == tuple(wanted)
    lobe_filter = LobeFilter(rough_map)
    lobe_filter.analyse(limits[0])
    for exponent, lobe in zip(wanted, maps.lobes, strict=True):
        if exponent == 1e6:
            assert lobe is maps.background
        else:
            expected = pack_lobe(lobe_filter.lobe(exponent, face_size(exponent)))
            assert np.array_equal(lobe.faces, expected.faces), exponent


def test_cancel_stops_the_work(rough_map: np.ndarray) -> None:
    calls = 0

    def cancel_soon(fraction: float, what: str) -> None:
        nonlocal calls
        calls += 1
        if calls == 5:
            raise Cancelled

    with pytest.raises(Cancelled):
        prefilter(Environment("rough", rough_map), [900.0], cancel_soon)
    assert calls == 5


@pytest.mark.parametrize("bad", [0.0, -1.0, float("nan"), float("inf")])
def test_bad_exponents_are_named(rough_map: np.ndarray, bad: float) -> None:
    with pytest.raises(ValueRangeError, match=r"exponents\[1\]"):
        prefilter(Environment("rough", rough_map), [5.0, bad])


@pytest.mark.parametrize("value", [np.nan, np.inf, -1.0])
def test_an_environment_refuses_what_is_not_radiance(value: float) -> None:
    pixels = np.ones((8, 16, 3), dtype=np.float32)
    pixels[2, 3, 1] = value
    with pytest.raises(ValueRangeError, match="finite"):
        Environment("bad", pixels)


def test_packing_keeps_a_range_of_a_hundred_million() -> None:
    radiance = np.full((6, 8, 8, 3), 1e-3)
    radiance[0, 0, 0] = 1e5
    radiance[1, 1, 1] = -3.0
    packed = pack_faces(radiance)
    back = packed.radiance()
    assert np.isfinite(back).all()
    assert back[1, 1, 1].tolist() == [0.0, 0.0, 0.0]
    assert abs(back[0, 0, 0, 0] / 1e5 - 1.0) < 1e-3
    assert abs(back[2, 0, 0, 0] / 1e-3 - 1.0) < 0.1
    assert pack_faces(np.zeros((6, 2, 2, 3))).radiance().max() == 0.0


def texel_solid_angles(size: int) -> np.ndarray:
    """Return the solid angles (size, size) in steradians of a face's texels; six faces sum to 4π."""
    edges = 2.0 * np.arange(size + 1) / size - 1.0
    x, y = edges[None, :], edges[:, None]
    corner = np.arctan2(x * y, np.sqrt(x * x + y * y + 1.0))
    return np.diff(np.diff(corner, axis=0), axis=1)


def test_every_real_environment_is_filtered_sensibly(shared_data: Path) -> None:
    files = sorted((shared_data / "environments").iterdir())
    assert len(files) >= 6
    for file in files:
        environment = Environment(file.stem, read_environment_image(file).pixels)
        maps = prefilter(environment, [8.0, 100.0])
        mean = environment.average()
        for item in (maps.diffuse, maps.through_coat, *maps.lobes):
            values = item.radiance()
            assert np.isfinite(values).all()
            assert values.max() <= environment.radiance.max() * 1.001
            average = (values * texel_solid_angles(item.size)[None, :, :, None]).sum(axis=(0, 1, 2)) / (
                4 * np.pi
            )
            assert np.allclose(average, mean, rtol=0.01), file.name
