"""ICC profiles: ours read by littleCMS, those of others read by us."""

from __future__ import annotations

import io
import struct

import numpy as np
import pytest
from PIL import Image, ImageCms

from brdf_suite.appearance.colour.colorimetry import WORKING_TO_SRGB, srgb_encode
from brdf_suite.appearance.colour.spaces import (
    DISPLAY_P3_SPACE,
    SPACES,
    SRGB_SPACE,
    DisplaySpace,
    inverse_codes,
)
from brdf_suite.errors import FileError, ValueRangeError
from brdf_suite.files.images.icc import profile_bytes, read_display_profile


def codes() -> np.ndarray:
    return np.random.default_rng(3).integers(0, 256, (40, 50, 3)).astype(np.uint8)


@pytest.mark.parametrize("space", SPACES.values(), ids=SPACES)
def test_littlecms_takes_our_profile_for_what_it_says(space: DisplaySpace) -> None:
    profile = ImageCms.ImageCmsProfile(io.BytesIO(profile_bytes(space)))
    assert ImageCms.getProfileDescription(profile).strip() == space.title
    to_srgb = ImageCms.buildTransform(
        profile, ImageCms.createProfile("sRGB"), "RGB", "RGB", renderingIntent=1
    )
    got = np.asarray(ImageCms.applyTransform(Image.fromarray(codes()), to_srgb)).astype(int)
    linear = np.where(
        codes() <= 0.04045 * 255, codes() / 255 / 12.92, ((codes() / 255 + 0.055) / 1.055) ** 2.4
    )
    working = linear @ np.linalg.inv(space.from_working).T
    wanted = np.rint(255 * srgb_encode(np.clip(working @ WORKING_TO_SRGB.T, 0.0, 1.0)))
    assert np.abs(got - wanted).max() <= 1  # it rounds through PCS numbers


@pytest.mark.parametrize("space", SPACES.values(), ids=SPACES)
def test_our_own_come_back(space: DisplaySpace) -> None:
    back = read_display_profile(profile_bytes(space), "monitor")
    assert back.title == space.title
    np.testing.assert_allclose(back.from_working, space.from_working, atol=2e-4)
    linear = np.random.default_rng(0).random((200, 3))
    np.testing.assert_allclose(back.encode(linear), space.encode(linear), atol=2e-5)
    np.testing.assert_allclose(back.of_working([1.0, 1.0, 1.0]), 1.0, atol=1e-12)


def test_the_same_profile_is_the_same_bytes() -> None:
    assert profile_bytes(SRGB_SPACE) == profile_bytes(SRGB_SPACE)
    with pytest.raises(ValueError, match="not defined by primaries"):
        profile_bytes(read_display_profile(profile_bytes(SRGB_SPACE), "x"))


def with_curves(curve: bytes) -> bytes:
    """Our sRGB profile with another curve at its end, which all three channels point to."""
    data = bytearray(profile_bytes(SRGB_SPACE))
    place = len(data)
    data += curve
    (count,) = struct.unpack_from(">I", data, 128)
    for i in range(count):
        tag = bytes(data[132 + 12 * i : 136 + 12 * i])
        if tag.endswith(b"TRC"):
            struct.pack_into(">II", data, 136 + 12 * i, place, len(curve))
    struct.pack_into(">I", data, 0, len(data))
    return bytes(data)


def curv(values: np.ndarray) -> bytes:
    return b"curv\0\0\0\0" + struct.pack(">I", len(values)) + values.astype(">u2").tobytes()


def para(kind: int, *values: float) -> bytes:
    numbers = np.rint(np.array(values) * 65536).astype(">i4").tobytes()
    return b"para\0\0\0\0" + struct.pack(">HH", kind, 0) + numbers


@pytest.mark.parametrize(
    "curve",
    [
        curv(np.array([round(2.2 * 256)])),
        curv(np.rint(65535 * np.linspace(0, 1, 1024) ** 2.2)),
        curv(np.array([])),
        para(0, 2.2),
        para(1, 2.2, 0.95, 0.05),
        para(2, 2.2, 0.9, 0.05, 0.01),
        para(3, 2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045),
        para(4, 2.4, 0.94, 0.055, 1 / 12.92, 0.04045, 0.0, 0.0),
    ],
    ids=["gamma", "table", "identity", "para0", "para1", "para2", "para3", "para4"],
)
def test_codes_for_a_monitor_are_littlecms_codes(curve: bytes) -> None:
    """Working space to the monitor by us, and sRGB to the monitor by littleCMS."""
    data = with_curves(curve)
    space = read_display_profile(data, "monitor")
    monitor = ImageCms.ImageCmsProfile(io.BytesIO(data))
    srgb = ImageCms.ImageCmsProfile(io.BytesIO(profile_bytes(SRGB_SPACE)))
    transform = ImageCms.buildTransform(srgb, monitor, "RGB", "RGB", renderingIntent=1)
    pixels = codes()
    theirs = np.asarray(ImageCms.applyTransform(Image.fromarray(pixels), transform)).astype(float)
    linear = np.where(pixels <= 0.04045 * 255, pixels / 255 / 12.92, ((pixels / 255 + 0.055) / 1.055) ** 2.4)
    ours = 255 * space.encode(space.of_working(linear @ np.linalg.inv(WORKING_TO_SRGB).T))
    difference = np.abs(ours - theirs)
    # Where a curve starts above black, nothing can be darker, and either may choose the code.
    dark = pixels < 40
    assert difference[~dark].max() <= 1.01
    assert np.quantile(difference, 0.99) <= 1.5


@pytest.mark.parametrize(
    ("change", "reported"),
    [
        (lambda d: b"", "not an ICC profile"),
        (lambda d: d[:100], "not an ICC profile"),
        (lambda d: d[:-40], "cut off"),
        (lambda d: d[:16] + b"CMYK" + d[20:], "not RGB"),
        (lambda d: d[:20] + b"Lab " + d[24:], "connects by Lab"),
        (lambda d: d.replace(b"rXYZ", b"A2B0"), "has no rXYZ"),
        (lambda d: d[:128] + b"\xff\xff\xff\xff" + d[132:], "too short"),
        (lambda d: d.replace(b"para\0\0\0\0\0\3", b"para\0\0\0\0\0\x63"), "not known"),
        (lambda d: with_curves(curv(np.full(16, 500))), "does not rise"),
        (lambda d: with_curves(b"curv\0\0\0\0\0\0\xff\xff\0\0"), "cut off in a curve"),
    ],
)
def test_damaged_profiles_are_refused(change, reported: str) -> None:
    with pytest.raises(FileError, match=reported):
        read_display_profile(change(profile_bytes(SRGB_SPACE)), "monitor.icc")


def test_random_damage_is_a_file_error_or_a_profile() -> None:
    rng = np.random.default_rng(5)
    good = np.frombuffer(profile_bytes(DISPLAY_P3_SPACE), np.uint8)
    for _ in range(300):
        bad = good.copy()
        bad[rng.integers(0, len(bad), 6)] = rng.integers(0, 256, 6)
        try:
            space = read_display_profile(bad[: rng.integers(100, len(bad) + 1)].tobytes(), "x")
        except FileError:
            continue
        assert np.isfinite(space.encode(space.of_working([0.2, 0.5, 0.1]))).all()


def test_inverse_codes_of_a_curve_that_rests() -> None:
    curve = np.clip(np.linspace(-0.2, 1.0, 601), 0.0, 1.0)[:, None] * np.ones(3)
    table = inverse_codes(curve, 256)
    assert table[0].tolist() == [0.0, 0.0, 0.0]
    assert table[-1].tolist() == [1.0, 1.0, 1.0]
    assert (np.diff(table, axis=0) >= 0.0).all()


def test_a_space_checks_itself() -> None:
    with pytest.raises(ValueRangeError, match="from_working"):
        DisplaySpace("x", np.full((3, 3), np.nan))
    with pytest.raises(ValueRangeError, match="codes"):
        DisplaySpace("x", np.eye(3), None, np.zeros((4, 2), np.float32))


@pytest.mark.parametrize("exponent", [0.0, -2.0, 100.0])
def test_a_curve_with_an_impossible_exponent_is_refused(exponent: float) -> None:
    data = bytearray(profile_bytes(SRGB_SPACE))
    at = bytes(data).index(b"para") + 12
    data[at : at + 4] = struct.pack(">i", round(65536 * exponent))
    with pytest.raises(FileError, match="expected above 0 and up to 60"):
        read_display_profile(bytes(data), "screen")
