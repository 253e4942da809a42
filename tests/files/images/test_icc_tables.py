"""Monitor profiles that describe the screen by tables, through littleCMS, and what is refused before."""

from __future__ import annotations

import io
import struct
from collections.abc import Callable
from types import ModuleType

import numpy as np
import pytest
from PIL import Image, ImageCms

from brdf_suite.appearance.colour.colorimetry import WORKING_TO_XYZ, adaptation, srgb_decode
from brdf_suite.appearance.colour.spaces import (
    DISPLAY_P3_SPACE,
    WORKING_SPACE,
    DisplaySpace,
    interpolate_table,
)
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.errors import FileError, ValueRangeError
from brdf_suite.files.images.icc import profile_bytes, read_display_profile

KINDS = [("lut8", "Lab"), ("lut16", "Lab"), ("lut16", "XYZ"), ("mAB", "Lab"), ("mAB", "XYZ")]
kinds = pytest.mark.parametrize(("kind", "connection"), KINDS, ids=["-".join(kind) for kind in KINDS])


@pytest.fixture(scope="module")
def made(load_helper: Callable[[str], ModuleType]) -> ModuleType:
    return load_helper("table_profiles.py")


def colours_in_gamut(space: DisplaySpace) -> tuple[np.ndarray, np.ndarray]:
    """Codes of the working space, with the sRGB curve, that the screen can show, and their reflectance factors."""
    codes = np.random.default_rng(8).integers(0, 256, (20_000, 3)).astype(np.uint8)
    rho = srgb_decode(codes / 255.0)
    linear = space.of_working(rho)
    inside = ((linear >= 0.0) & (linear <= 1.0)).all(axis=-1)
    assert inside.mean() > 0.3
    return codes[inside], rho[inside]


@kinds
@pytest.mark.parametrize("black", [0.0, 0.003])
def test_codes_are_littlecms_codes(made: ModuleType, kind: str, connection: str, black: float) -> None:
    """littleCMS takes each colour through the profile by itself; ours come of a table of 33 points an axis."""
    screen = made.Screen(black)
    data = made.profile(kind, connection, screen)
    space = read_display_profile(data, "monitor")
    assert space.title == "Table screen"
    codes, rho = colours_in_gamut(space)
    source = ImageCms.ImageCmsProfile(io.BytesIO(profile_bytes(WORKING_SPACE)))
    tags = entries(data)  # littleCMS compensates for black only where the intent has tables of its own
    data = made.assemble(
        tags | {b"A2B1": tags[b"A2B0"], b"B2A1": tags[b"B2A0"]}, connection, 4 if kind == "mAB" else 2
    )
    flags = ImageCms.Flags.NOOPTIMIZE | ImageCms.Flags.BLACKPOINTCOMPENSATION
    transform = ImageCms.buildTransform(
        source, ImageCms.ImageCmsProfile(io.BytesIO(data)), "RGB", "RGB", renderingIntent=1, flags=flags
    )
    theirs = np.asarray(ImageCms.applyTransform(Image.fromarray(codes[None]), transform))[0] / 255.0
    ours = space.encode(space.of_working(rho))
    difference = delta_e_2000(*(made.xyz_to_lab(screen.xyz(shown)) for shown in (theirs, ours)))
    # Theirs are rounded to 8 bits, which alone is 0.13 in the mean.
    assert difference.mean() < 0.25
    assert np.quantile(difference, 0.99) < 0.8


@kinds
def test_the_screen_shows_the_colour(made: ModuleType, kind: str, connection: str) -> None:
    """By the screen's own formula; the profile's tables of 25 points an axis are most of the difference."""
    screen = made.Screen()
    space = read_display_profile(made.profile(kind, connection, screen), "monitor")
    _, rho = colours_in_gamut(space)
    wanted = made.xyz_to_lab(rho @ to_d50(made).T)
    linear = space.of_working(rho)
    difference = delta_e_2000(wanted, made.xyz_to_lab(screen.xyz(space.encode(linear))))
    assert difference.mean() < 0.5
    # A matrix that is right for each full channel is not enough: the channels take light from one another.
    by_matrix = made.xyz_to_lab(screen.xyz(linear ** (1.0 / made.EXPONENTS)))
    assert delta_e_2000(wanted, by_matrix).mean() > 1.5


def test_black_is_the_screens_black(made: ModuleType) -> None:
    """Greys darker than what a lit screen gives at the codes 0 are those of a dark screen: black is compensated."""
    space = read_display_profile(made.profile("lut16", "Lab", made.Screen(0.01), points=33), "monitor")
    rho = np.array([0.003, 0.006, 0.01, 0.03, 0.1])[:, None] * np.ones(3)
    codes = 255.0 * space.encode(space.of_working(rho))
    np.testing.assert_allclose(codes, 255.0 * made.Screen().codes(rho @ to_d50(made).T), atol=2.5)


def test_tables_of_the_colorimetric_intent_stand_before_the_default(made: ModuleType) -> None:
    default, lit = (entries(made.profile("lut16", "Lab", made.Screen(black))) for black in (0.0, 0.05))
    both = default | {b"A2B1": lit[b"A2B0"], b"B2A1": lit[b"B2A0"]}
    chosen, wanted = (read_display_profile(made.assemble(tags, "Lab", 2), "x") for tags in (both, lit))
    assert chosen.table is not None
    np.testing.assert_array_equal(chosen.table, wanted.table)
    plain = read_display_profile(made.assemble(default, "Lab", 2), "x")
    assert np.abs(chosen.table - plain.table).max() > 0.02


def to_d50(made: ModuleType) -> np.ndarray:
    """The matrix from the working space to the connection space."""
    return adaptation(WORKING_TO_XYZ.sum(axis=1), made.WHITE, "Bradford") @ WORKING_TO_XYZ


def test_full_channels_are_the_edge_of_the_gamut(made: ModuleType) -> None:
    space = read_display_profile(made.profile("mAB", "Lab"), "monitor")
    channels = made.Screen().xyz(np.eye(3)) @ np.linalg.inv(to_d50(made)).T
    linear = space.of_working(channels)
    linear /= linear.max(axis=-1, keepdims=True)
    np.testing.assert_allclose(linear, np.eye(3), atol=0.01)
    np.testing.assert_allclose(space.of_working([1.0, 1.0, 1.0]), 1.0, atol=1e-12)


def test_tables_stand_before_a_matrix(made: ModuleType) -> None:
    """The same profile with Display P3's matrix beside: the codes stay; without one table, the matrix is used."""
    tabled = made.profile("lut16", "XYZ")
    tags, matrix = entries(tabled), entries(profile_bytes(DISPLAY_P3_SPACE))
    both = made.assemble(matrix | tags, "XYZ", 2)
    colours = np.random.default_rng(1).random((50, 3))
    alone, with_matrix = (read_display_profile(data, "x") for data in (tabled, both))
    np.testing.assert_array_equal(alone.encode(colours), with_matrix.encode(colours))
    del tags[b"B2A0"]
    half = read_display_profile(made.assemble(matrix | tags, "XYZ", 2), "x")
    assert half.table is None
    np.testing.assert_allclose(half.from_working, DISPLAY_P3_SPACE.from_working, atol=2e-4)


def entries(data: bytes) -> dict[bytes, bytes]:
    (count,) = struct.unpack_from(">I", data, 128)
    found = {}
    for i in range(count):
        tag, at, size = struct.unpack_from(">4sII", data, 132 + 12 * i)
        found[tag] = data[at : at + size]
    return found


def change_table(made: ModuleType, kind: str, change: Callable[[bytearray], None]) -> bytes:
    tags = entries(made.profile(kind, "Lab", points=3))
    table = bytearray(tags[b"B2A0"])
    change(table)
    return made.assemble(tags | {b"B2A0": bytes(table)}, "Lab", 4)


@pytest.mark.parametrize(
    ("kind", "at", "value", "reported"),
    [
        ("lut8", 0, b"mft9", "kind that is not known"),
        ("lut8", 8, b"\4", "4 channels to 3"),
        ("lut8", 10, b"\1", "without points"),
        ("lut8", 10, b"\xff", "cut off in a table"),
        ("lut16", 48, b"\0\0", "without points"),
        ("lut16", 50, b"\x10\1", "without points"),
        ("lut16", 50, b"\x10\0", "cut off in a table"),
        ("mAB", 9, b"\5", "3 channels to 5"),
        ("mAB", 24, b"\x7f\xff\xff\xff", "cut off in a table"),
        ("mAB", 28, b"\x7f\xff\xff\xff", "cut off in a table"),
        ("mAB", 12, b"\0\0\0\0", "cannot be used"),
    ],
)
def test_damaged_tables_are_refused(
    made: ModuleType, kind: str, at: int, value: bytes, reported: str
) -> None:
    def change(table: bytearray) -> None:
        table[at : at + len(value)] = value

    read_display_profile(change_table(made, kind, lambda table: None), "x")
    with pytest.raises(FileError, match=reported):
        read_display_profile(change_table(made, kind, change), "x")


def test_a_table_without_points_on_an_axis_is_refused(made: ModuleType) -> None:
    def change(table: bytearray) -> None:
        (at,) = struct.unpack_from(">I", table, 24)
        table[at + 1] = 0

    with pytest.raises(FileError, match="without points"):
        read_display_profile(change_table(made, "mAB", change), "x")


def test_other_devices_and_flat_screens_are_refused(made: ModuleType) -> None:
    tags = entries(made.profile("lut8", "Lab", points=3))
    with pytest.raises(FileError, match="not of a monitor"):
        read_display_profile(made.assemble(tags, "Lab", 2, b"prtr"), "x")
    grey = bytearray(tags[b"A2B0"])
    grey[48 + 768 : 48 + 768 + 81] = bytes([128] * 81)
    with pytest.raises(FileError, match="colours are the same"):
        read_display_profile(made.assemble(tags | {b"A2B0": bytes(grey)}, "Lab", 2), "x")


def test_random_damage_is_a_file_error_or_a_profile(made: ModuleType) -> None:
    rng = np.random.default_rng(6)
    for kind, connection in KINDS:
        good = np.frombuffer(made.profile(kind, connection, points=4), np.uint8)
        head = min(len(good), 700)
        for _ in range(12):
            bad = good.copy()
            bad[rng.integers(0, head, 4)] = rng.integers(0, 256, 4)
            bad[rng.integers(0, len(good), 4)] = rng.integers(0, 256, 4)
            try:
                space = read_display_profile(bad.tobytes(), "x")
            except FileError:
                continue
            codes = space.encode(space.of_working([0.2, 0.5, 0.1]))
            assert ((codes >= 0.0) & (codes <= 1.0)).all()


def test_interpolation_is_exact_where_the_table_is_linear_and_on_its_points() -> None:
    rng = np.random.default_rng(2)
    n = 5
    axis = np.linspace(0.0, 1.0, n)
    points = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), axis=-1)
    matrix = rng.random((3, 3))
    places = rng.random((40, 3))
    np.testing.assert_allclose(interpolate_table(points @ matrix, places), places @ matrix, atol=1e-14)
    table = rng.random((n, n, n, 3))
    np.testing.assert_allclose(interpolate_table(table, points), table, atol=1e-14)
    # Between two greys nothing but these greys counts.
    low, high = table[1, 1, 1], table[2, 2, 2]
    np.testing.assert_allclose(interpolate_table(table, [0.3125] * 3), 0.75 * low + 0.25 * high)


def test_a_space_checks_its_table() -> None:
    with pytest.raises(ValueRangeError, match="n by n by n"):
        DisplaySpace("x", np.eye(3), table=np.zeros((3, 3, 2, 3), np.float32))
    with pytest.raises(ValueRangeError, match="not both"):
        DisplaySpace(
            "x", np.eye(3), None, np.zeros((4, 3), np.float32), table=np.zeros((2, 2, 2, 3), np.float32)
        )
