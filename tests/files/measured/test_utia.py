"""UTIA's tables, against a file written here with index arithmetic of its own."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from brdf_suite.errors import FileError
from brdf_suite.files.measured.format import ReadOptions
from brdf_suite.files.measured.utia import FORMAT, read_utia

BT2087 = np.array([[0.6274, 0.3293, 0.0433], [0.0691, 0.9195, 0.0114], [0.0164, 0.0880, 0.8956]])


def value(channel: int, ti: float, pi: float, tv: float, pv: float) -> float:
    """Smooth over the azimuths, another along each axis."""
    angle_i, angle_v = np.radians(7.5 * pi), np.radians(7.5 * pv)
    return float(
        (0.05 + 0.01 * channel) * (1.0 + 0.1 * ti + 0.03 * tv + 0.2 * np.cos(angle_i) + 0.1 * np.sin(angle_v))
    )


@pytest.fixture(scope="module")
def planes() -> np.ndarray:
    c, ti, pi, tv, pv = np.meshgrid(*(np.arange(n) for n in (3, 6, 48, 6, 48)), indexing="ij")
    flat = np.empty(3 * 288 * 288)
    place = 288 * 288 * c + 288 * (48 * ti + pi) + 48 * tv + pv
    flat[place] = np.vectorize(value)(c, ti, pi, tv, pv)
    return flat


@pytest.fixture
def path(planes: np.ndarray, tmp_path: Path) -> Path:
    file = tmp_path / "fabric.bin"
    file.write_bytes(planes.astype("<f8").tobytes())
    return file


def direction(theta_deg: float, phi_deg: float) -> np.ndarray:
    theta, phi = np.radians([theta_deg, phi_deg])
    return np.array([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)])


def test_nodes_lie_where_the_layout_says(path: Path) -> None:
    table = read_utia(path)
    for ti, pi, tv, pv in ((1, 3, 4, 40), (5, 47, 2, 0), (3, 24, 3, 25)):
        want = BT2087 @ [value(c, ti, pi, tv, pv) for c in range(3)]
        got = table.eval(direction(15 * ti, 7.5 * pi), direction(15 * tv, 7.5 * pv))
        assert got == pytest.approx(want, rel=2e-4)


def test_between_nodes_it_is_interpolated(path: Path) -> None:
    got = read_utia(path).eval(direction(22.5, 33.0), direction(40.0, 200.0))
    want = BT2087 @ [value(c, 1.5, 33.0 / 7.5, 40.0 / 15.0, 200.0 / 7.5) for c in range(3)]
    assert got == pytest.approx(want, rel=5e-3)


def test_what_is_assumed_is_said(path: Path, planes: np.ndarray) -> None:
    table = read_utia(path)
    assert "taken as linear" in str(table.facts["colour"])
    assert table.facts["notes"] == ()
    assert FORMAT.sniff(b"", path.stat().st_size)
    path.write_bytes((planes * 20.0).astype("<f8").tobytes())
    assert "not f_r as they stand" in read_utia(path).facts["notes"][0]
    path.write_bytes(np.where(np.arange(planes.size) < 7, -0.1, planes).astype("<f8").tobytes())
    table = read_utia(path)
    assert "7 negative values" in table.facts["notes"][0]
    assert table.values.min() >= 0.0


def test_an_encoded_file_is_decoded_on_request(path: Path, planes: np.ndarray) -> None:
    linear = planes * 0.5 + 0.1
    path.write_bytes((1.055 * linear ** (1 / 2.4) - 0.055).astype("<f8").tobytes())
    table = FORMAT.read(path, ReadOptions(srgb_encoded=True))
    want = BT2087 @ [0.5 * value(c, 2, 5, 3, 7) + 0.1 for c in range(3)]
    assert table.eval(direction(30, 37.5), direction(45, 52.5)) == pytest.approx(want, rel=2e-4)


@pytest.mark.parametrize("size", [0, 8, 1_990_655])
def test_a_cut_off_file_is_refused(path: Path, size: int) -> None:
    path.write_bytes(path.read_bytes()[:size])
    with pytest.raises(FileError, match="cut off"):
        read_utia(path)


def test_a_longer_file_is_refused(path: Path) -> None:
    path.write_bytes(path.read_bytes() + b"\0")
    with pytest.raises(FileError, match="too long: expected 1,990,656 bytes, found 1,990,657"):
        read_utia(path)


@pytest.mark.parametrize("odd", [np.nan, np.inf, 1e9])
def test_values_that_are_none_are_refused_by_place(path: Path, planes: np.ndarray, odd: float) -> None:
    broken = planes.copy()
    broken[100] = odd
    path.write_bytes(broken.astype("<f8").tobytes())
    with pytest.raises(FileError, match="byte 800"):
        read_utia(path)


def test_a_file_of_nothing_but_negative_values_is_refused(tmp_path: Path, planes: np.ndarray) -> None:
    file = tmp_path / "below.bin"
    np.full(planes.shape, -1.0).astype("<f8").tofile(file)
    with pytest.raises(FileError, match="every value is negative"):
        read_utia(file)
