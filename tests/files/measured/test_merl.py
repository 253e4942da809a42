"""MERL tables, against a file written here with index arithmetic and rotations of its own."""

from __future__ import annotations

import struct
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.errors import FileError
from brdf_suite.files.measured.format import ReadOptions
from brdf_suite.files.measured.merl import FORMAT, read_merl, write_merl
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

WriteFile = Callable[[bytes], Path]

# Rec. 709 to Rec. 2020, ITU-R BT.2087-0, four decimals.
BT2087 = np.array([[0.6274, 0.3293, 0.0433], [0.0691, 0.9195, 0.0114], [0.0164, 0.0880, 0.8956]])


def model(theta_h: np.ndarray, theta_d: np.ndarray, phi_d: np.ndarray) -> np.ndarray:
    """f_r in linear Rec. 709; no two axes and no two channels behave alike, and the sign of φd matters."""
    turn = 1.0 + 0.25 * np.cos(2.0 * phi_d) + 0.15 * np.sin(2.0 * phi_d)
    lobe = np.exp(-theta_h / 0.15)
    return np.stack(
        np.broadcast_arrays(
            0.08 + 2.0 * lobe * turn,
            0.06 + 0.02 * turn * theta_d + 0.5 * lobe,
            0.05 + 0.03 * np.cos(theta_d) + 0.01 * turn,
        )
    )


def bytes_of(phi_bins: int = 180, scaled: bool = True, low: float = -1.0) -> bytes:
    """A whole file: the place of a value is φd + bins·(θd + 90·θh), a plane per channel."""
    # Axes in the order of the places, the slowest first.
    bin_h, bin_d, bin_p = np.ogrid[:90, :90, :phi_bins]
    theta_h = np.radians((bin_h + 0.5) ** 2 / 90.0)
    theta_d = np.radians(bin_d + 0.5)
    phi_d = (bin_p + 0.5) * np.pi / 180.0
    planes = model(theta_h, theta_d, phi_d)
    if scaled:
        planes *= 1500.0 / np.array([1.0, 1.15, 1.66])[:, None, None, None]
    z = np.cos(theta_h) * np.cos(theta_d)
    deep = np.abs(np.sin(theta_h) * np.sin(theta_d) * np.cos(phi_d)) >= z
    planes[:, deep] = low
    return struct.pack("<3i", 90, 90, phi_bins) + planes.astype("<f8").tobytes()


def turn(vector: np.ndarray, axis: str, angle: float) -> np.ndarray:
    """Rodrigues about z or y."""
    c, s = np.cos(angle), np.sin(angle)
    x, y, z = vector
    return np.array([c * x - s * y, s * x + c * y, z] if axis == "z" else [c * x + s * z, y, c * z - s * x])


def off_grid_pairs(count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """wi, wo, and the model's colour there, at random angles; h is built first, then the light about it."""
    rng = np.random.default_rng(11)
    lights, views, colours = [], [], []
    while len(lights) < count:
        theta_h, theta_d = rng.uniform(0.0, 1.1), rng.uniform(0.05, 1.2)
        phi_d, phi_h = rng.uniform(0.0, 2.0 * np.pi, 2)
        d = np.array([np.sin(theta_d) * np.cos(phi_d), np.sin(theta_d) * np.sin(phi_d), np.cos(theta_d)])
        light = turn(turn(d, "y", theta_h), "z", phi_h)
        half = turn(turn(np.array([0.0, 0.0, 1.0]), "y", theta_h), "z", phi_h)
        view = 2.0 * (light @ half) * half - light
        if light[2] > 0.1 and view[2] > 0.1:
            lights.append(light)
            views.append(view)
            colours.append(BT2087 @ model(np.array(theta_h), np.array(theta_d), np.array(phi_d)))
    return np.array(lights), np.array(views), np.array(colours)


@pytest.fixture(scope="module")
def whole() -> bytes:
    return bytes_of()


@pytest.fixture
def file(tmp_path: Path) -> WriteFile:
    def write(content: bytes) -> Path:
        path = tmp_path / "paint.binary"
        path.write_bytes(content)
        return path

    return write


def test_the_usual_file_has_the_usual_size(whole: bytes) -> None:
    assert len(whole) == 34_992_012
    assert FORMAT.sniff(whole[:64], len(whole))


def test_an_analytic_model_comes_back_at_off_grid_directions(whole: bytes, file: WriteFile) -> None:
    table = read_merl(file(whole))
    wi, wo, colour = off_grid_pairs(3000)
    error = np.abs(table.eval(wi, wo) / colour - 1.0)
    assert error.max() < 4e-3
    assert np.median(error) < 3e-4
    assert np.array_equal(table.eval(wo, wi), table.eval(wi, wo))
    assert table.reciprocal
    assert table.facts["scale_factors"] is True
    assert table.facts["scale_factors_found_by"] == "energy"
    assert table.facts["holes_above_horizon"] == 0
    assert table.facts["notes"] == ()


def test_plain_values_are_noticed_and_said(file: WriteFile) -> None:
    path = file(bytes_of(scaled=False))
    table = read_merl(path)
    wi, wo, colour = off_grid_pairs(200)
    assert np.allclose(table.eval(wi, wo), colour, rtol=4e-3)
    assert table.facts["scale_factors"] is False
    assert "plain f_r" in table.facts["notes"][0]
    forced = FORMAT.read(path, ReadOptions(scale_factors=True))
    assert np.allclose(
        forced.values.max(axis=(0, 1, 2)) * 1500.0 / table.values.max(axis=(0, 1, 2)), 1.2, atol=0.3
    )
    assert forced.facts["scale_factors_found_by"] == "the user"


@pytest.mark.parametrize(("albedo", "scaled"), [(0.01, True), (0.9, True), (0.01, False), (0.95, False)])
def test_black_and_white_are_distinguished_from_their_scale(
    tmp_path: Path, albedo: float, scaled: bool
) -> None:
    path = tmp_path / "grey.binary"
    grey = IsotropicTable(np.full((90, 90, 180, 3), albedo / np.pi, np.float32))
    write_merl(grey, path, scale_factors=scaled)
    table = read_merl(path)
    assert table.facts["scale_factors"] is scaled
    assert not table.facts["notes"] or not scaled
    assert np.allclose(table.values, albedo / np.pi, rtol=1e-5)


def test_a_scale_that_energy_cannot_decide_is_called_uncertain(tmp_path: Path) -> None:
    path = tmp_path / "odd.binary"
    write_merl(IsotropicTable(np.full((8, 8, 16, 3), 4.0 / np.pi, np.float32)), path, scale_factors=False)
    assert any("uncertain" in note for note in read_merl(path).facts["notes"])


def test_phi_over_the_whole_turn(file: WriteFile) -> None:
    content = bytearray(bytes_of(360))
    planes = np.frombuffer(content, "<f8", offset=12).reshape(3, 90, 90, 360)
    planes[..., 180:] *= np.where(planes[..., 180:] > 0.0, 1.5, 1.0)
    table = read_merl(file(bytes(content)))
    assert not table.reciprocal
    assert table.facts["phi_d_range_deg"] == 360
    wi, wo, colour = off_grid_pairs(300)
    ratio = table.eval(wi, wo) / colour
    first = np.isclose(ratio, 1.0, rtol=5e-3).all(axis=1)
    second = np.isclose(ratio, 1.5, rtol=5e-3).all(axis=1)
    assert np.count_nonzero(first | second) > 290
    assert 100 < first.sum() < 200
    even = FORMAT.read(file(bytes(content)), ReadOptions(average_reciprocal=True))
    assert even.reciprocal
    assert np.allclose(even.eval(wi, wo), 1.25 * colour, rtol=5e-3)
    assert "a pair and its swap were averaged" in even.facts["notes"]


def test_a_header_of_360_above_180_bins(whole: bytes, file: WriteFile) -> None:
    path = file(struct.pack("<3i", 90, 90, 360) + whole[12:])
    table = read_merl(path)
    assert table.reciprocal
    assert "180, over 180°" in table.facts["notes"][0]
    wi, wo, colour = off_grid_pairs(100)
    assert np.allclose(table.eval(wi, wo), colour, rtol=4e-3)


def test_negative_values_are_holes_and_are_filled(whole: bytes, file: WriteFile) -> None:
    content = bytearray(whole)
    planes = np.frombuffer(content, "<f8", offset=12).reshape(3, 90, 90, 180)
    planes[1, 20:23, 30:33, 40:43] = -0.25  # one channel is enough
    table = read_merl(file(bytes(content)))
    holes = np.asarray(table.holes)
    assert holes[20:23, 30:33, 40:43].all()
    assert table.facts["holes_above_horizon"] == 27
    assert any("27 bins" in note for note in table.facts["notes"])
    true = read_merl(file(whole)).values[20:23, 30:33, 40:43]
    assert np.allclose(table.values[20:23, 30:33, 40:43], true, rtol=5e-3)


def test_written_and_read_again(whole: bytes, file: WriteFile, tmp_path: Path) -> None:
    table = read_merl(file(whole))
    again = tmp_path / "again.binary"
    assert write_merl(table, again) == ()
    assert again.stat().st_size == len(whole)
    before, after = (np.frombuffer(data, "<f8", offset=12) for data in (whole, again.read_bytes()))
    assert np.array_equal(before < 0.0, after < 0.0)
    assert np.allclose(after, before, rtol=1e-5)
    plain = tmp_path / "plain.binary"
    write_merl(table, plain, scale_factors=False)
    assert np.allclose(read_merl(plain).values, table.values, rtol=1e-6)


def test_a_colour_outside_rec_709_is_written_without_holes_and_reported(tmp_path: Path) -> None:
    path = tmp_path / "green.binary"
    notes = write_merl(IsotropicTable(np.full((8, 8, 16, 3), [0.0, 0.3, 0.0], np.float32)), path)
    assert "1,024 bins are too saturated" in notes[0]
    table = read_merl(path, scale_factors=True)
    assert not np.asarray(table.holes).any()


def test_a_model_is_tabulated_to_be_written(tmp_path: Path) -> None:
    class Lambert:
        def eval(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
            above = (wi[..., 2] > 0.0) & (wo[..., 2] > 0.0)
            return np.where(above[..., None], np.array([0.1, 0.2, 0.15]), 0.0)

    path = tmp_path / "lambert.binary"
    notes = write_merl(Lambert(), path)
    assert "tabulated" in notes[0]
    assert len(notes) == 1
    table = read_merl(path)
    assert table.values.shape == (90, 90, 180, 3)
    assert np.allclose(table.values[table.grid.reached()], [0.1, 0.2, 0.15], rtol=1e-5)
    assert np.array_equal(np.asarray(table.holes), ~HalfAngleGrid().above_horizon())


def test_spectra_that_the_layout_cannot_hold_are_reported(tmp_path: Path) -> None:
    up = np.array([[0.0, 0.0, 1.0]])
    samples = ScatteredSamples(up, up, np.full((1, 3), 0.1), np.full((1, 2), 0.1), np.array([400.0, 700.0]))
    notes = write_merl(samples, tmp_path / "a.binary")
    assert "spectra were left out" in notes[1]
    assert np.allclose(read_merl(tmp_path / "a.binary").eval(up, up), 0.1)


def test_a_failed_write_keeps_the_old_file(tmp_path: Path, full_disk: None) -> None:
    path = tmp_path / "old.binary"
    path.write_bytes(b"old")
    with pytest.raises(FileError, match="No space left"):
        write_merl(IsotropicTable(np.ones((4, 4, 8, 3), np.float32)), path)
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


def small(shape: tuple[int, int, int] = (6, 5, 10)) -> bytes:
    return struct.pack("<3i", *shape) + np.full(3 * int(np.prod(shape)), 100.0).astype("<f8").tobytes()


def test_odd_shapes_are_read_where_phi_fits(file: WriteFile) -> None:
    assert read_merl(file(small())).values.shape == (6, 5, 10, 3)
    assert not read_merl(file(small((6, 5, 20)))).reciprocal


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (b"", "cut off"),
        (small()[:7], "cut off"),
        (small()[:12], "is cut off: 6 × 5 × 10 bins take 7,212 bytes, the file has 12"),
        (small()[:-1], "cut off"),
        (small() + b"\0", "too long"),
        (small((6, 5, 11)), "11 bins of φd"),
        (struct.pack("<3i", -90, 90, 180) + small()[12:], "not a MERL table"),
        (struct.pack("<3i", 2**31 - 1, 2**31 - 1, 2**31 - 1), "not a MERL table"),
        (struct.pack("<3i", 4096, 2048, 4096), "cut off"),
        (b"#?RADIANCE\n" * 50, "not a MERL table"),
        (small()[:12] + struct.pack("<d", -1.0) * 900, "every bin is negative"),
        (
            small()[:20] + struct.pack("<d", float("nan")) + small()[28:],
            "at byte 20: holds a value that is no finite",
        ),
        (small()[:20] + struct.pack("<d", float("-inf")) + small()[28:], "at byte 20"),
        (small()[:20] + struct.pack("<d", 1e300) + small()[28:], "at byte 20"),
    ],
)
def test_damaged_files_are_refused_by_place(content: bytes, says: str, file: WriteFile) -> None:
    path = file(content)
    with pytest.raises(FileError, match=says) as caught:
        read_merl(path)
    assert str(path) in str(caught.value)


def test_missing_files_and_folders_are_reported(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="cannot be read"):
        read_merl(tmp_path / "none.binary")
    with pytest.raises(FileError):
        read_merl(tmp_path)


@given(st.integers(0, 1000), st.binary(min_size=1, max_size=16), st.integers(0, 1400))
def test_random_damage_is_refused_or_read(
    tmp_path_factory: pytest.TempPathFactory, place: int, other: bytes, cut: int
) -> None:
    content = bytearray(small((5, 2, 4)))  # 972 bytes
    content[place : place + len(other)] = other
    path = tmp_path_factory.mktemp("damage") / "a.binary"
    path.write_bytes(bytes(content[:cut]))
    try:
        table = read_merl(path)
    except FileError:
        return
    assert np.isfinite(table.values).all()
    assert table.values.min() >= 0.0


def table_bytes(
    theta_h: int, theta_d: int, phi: int, kind: str, *, scaled: bool, header: int = 0, holes: bool = True
) -> bytes:
    """A table of any bins and type; the place of a value is φd + bins·(θd + n·θh), a plane per channel."""
    bin_h, bin_d, bin_p = np.ogrid[:theta_h, :theta_d, :phi]
    high, wide = (
        np.radians((bin_h + 0.5) ** 2 * 90.0 / theta_h**2),
        np.radians((bin_d + 0.5) * 90.0 / theta_d),
    )
    around = (bin_p + 0.5) * np.pi / (2 * theta_d)
    planes = model(high, wide, around)
    if scaled:
        planes *= 1500.0 / np.array([1.0, 1.15, 1.66])[:, None, None, None]
    if holes:
        deep = np.abs(np.sin(high) * np.sin(wide) * np.cos(around)) >= np.cos(high) * np.cos(wide)
        planes[:, deep] = -1.0
    return struct.pack("<3i", theta_h, theta_d, header or phi) + planes.astype(kind).tobytes()


LAYOUTS = {
    f"{n} × {d} × {phi} {kind} {'scaled' if scaled else 'plain'}{' of 360' if header else ''}": (
        n, d, phi, kind, scaled, header,
    )
    for n, d in ((90, 45), (30, 30), (45, 20))
    for phi, header in ((2 * d, 0), (4 * d, 0), (2 * d, 4 * d))
    for kind in ("<f8", "<f4", "<f2")
    for scaled in (True, False)
}  # fmt: skip


@pytest.mark.parametrize("name", LAYOUTS)
def test_every_layout_and_precision_is_recognised_and_holds_its_values(name: str, file: WriteFile) -> None:
    n, d, phi, kind, scaled, header = LAYOUTS[name]
    path = file(table_bytes(n, d, phi, kind, scaled=scaled, header=header))
    content = path.read_bytes()
    assert FORMAT.sniff(content[:64], len(content))
    table = read_merl(path)
    assert table.grid.shape == (n, d, phi)
    assert table.reciprocal == (phi == 2 * d)
    said = {"<f8": "", "<f4": "single precision", "<f2": "half precision"}[kind]
    assert [note for note in table.facts["notes"] if "precision" in note] == (
        [f"it stores {said}"] if said else []
    )
    assert table.facts["scale_factors"] is scaled
    bin_h, bin_d, bin_p = np.meshgrid(range(n), range(d), range(phi), indexing="ij")
    angles = (
        np.radians((bin_h + 0.5) ** 2 * 90.0 / n**2), np.radians((bin_d + 0.5) * 90.0 / d),
        (bin_p + 0.5) * np.pi / (2 * d),
    )  # fmt: skip
    expected = np.moveaxis(model(*angles), 0, -1) @ BT2087.T
    known = ~np.asarray(table.holes)
    assert np.count_nonzero(known) > known.size // 3
    tolerance = 2e-3 if kind == "<f2" else 5e-4  # BT.2087 has four decimals
    assert np.allclose(table.values[known], expected[known], rtol=tolerance)


def test_an_even_table_in_single_precision_is_not_taken_for_one_of_half_the_azimuths(file: WriteFile) -> None:
    planes = np.full((3, 20, 20, 80), 0.25, "<f4")
    table = read_merl(file(struct.pack("<3i", 20, 20, 80) + planes.tobytes()))
    assert table.grid.shape == (20, 20, 80)
    assert table.values[..., 1] == pytest.approx(0.25, rel=1e-5)
