"""Our own container: what goes in comes out, what was tampered with does not."""

from __future__ import annotations

import hashlib
import json
import struct
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.errors import FileError
from brdf_suite.files.measured.brdftable import FORMAT, read_brdftable, write_brdftable
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.factored.map import MapFactor
from brdf_suite.reflectance.factored.model import Factored
from brdf_suite.reflectance.tabulated.anisotropic import AnisotropicTable
from brdf_suite.reflectance.tabulated.isotropic import Coverage, IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

RNG = np.random.default_rng(9)
FACTS = {"format": "MERL", "notes": ("one", "zwei ü"), "holes": 3, "scaled": True, "albedo": 0.25}


def isotropic(reciprocal: bool = True) -> IsotropicTable:
    values = RNG.random((4, 5, 6, 3)).astype(np.float32)
    return IsotropicTable(values, RNG.random((4, 5, 6)) < 0.3, reciprocal, "a sphere", FACTS)


def covered() -> IsotropicTable:
    table = isotropic()
    readings = np.where(table.holes, 0.0, RNG.integers(1, 50, (4, 5, 6))).astype(np.float32)
    coverage = Coverage(readings, np.where(readings > 0.0, RNG.random((4, 5, 6)), 0.0).astype(np.float32))
    return replace(table, coverage=coverage)


def anisotropic() -> AnisotropicTable:
    return AnisotropicTable(RNG.random((3, 4, 2, 4, 3)), [0.0, 0.5, 1.0], [0.2, 1.4], "brushed", FACTS)


def product() -> Factored:
    rng = np.random.default_rng(5)
    p, q, s, f = (rng.random((n, 3)).astype(np.float32) + 0.1 for n in (6, 8, 12, 4))
    whole = rng.random((5, 5, 3)).astype(np.float32)
    more = (MapFactor("h", whole, False, "g"),)
    peak = (MapFactor("sqrt|h|", s, True, "s"), MapFactor("w.h", f, True, "f"))
    return Factored(p, q, (0.5, 1.0, 2.0), "a product", FACTS, more=more, peak=peak, logarithmic=True)


def scattered(spectral: bool = True) -> ScatteredSamples:
    wi, wo = (
        spherical(RNG.uniform(0, 1.5, 20), RNG.uniform(0, 6, 20)),
        spherical(RNG.uniform(0, 1.5, 20), 0.0),
    )
    spectra = (RNG.random((20, 31)), np.linspace(400.0, 700.0, 31)) if spectral else (None, None)
    return ScatteredSamples(wi, wo, RNG.random((20, 3)), *spectra, isotropic=False, source="x", facts=FACTS)


def factored() -> Factored:
    p, q = RNG.random((4, 4, 3)).astype(np.float32), RNG.random((6, 6, 3)).astype(np.float32)
    return Factored(p, q, (0.5, 1.0, 2.0), "a product", FACTS)


@pytest.mark.parametrize(
    "make",
    [
        isotropic,
        lambda: isotropic(False),
        covered,
        anisotropic,
        factored,
        product,
        scattered,
        lambda: scattered(False),
    ],
    ids=[
        "isotropic",
        "whole turn",
        "with coverage",
        "anisotropic",
        "factored",
        "product",
        "spectral",
        "colours",
    ],
)
def test_every_kind_comes_back_to_the_last_bit(make: Callable[[], Any], tmp_path: Path) -> None:
    value, path = make(), tmp_path / "a.brdftable"
    write_brdftable(value, path)
    again = read_brdftable(path)
    assert type(again) is type(value)
    for name in value.__dataclass_fields__:
        before, after = getattr(value, name), getattr(again, name)
        if isinstance(before, np.ndarray):
            assert np.array_equal(before, after)
            assert before.dtype == after.dtype
        elif isinstance(before, Coverage):
            assert np.array_equal(before.samples, after.samples)
            assert np.array_equal(before.deviation, after.deviation)
        elif name in ("more", "peak"):
            for one, other in zip(before, after, strict=True):
                assert (one.projection, one.logarithmic, one.name) == (
                    other.projection,
                    other.logarithmic,
                    other.name,
                )
                assert np.array_equal(one.values, other.values)
        else:
            assert before == after
    data = path.read_bytes()
    assert FORMAT.sniff(data[:64], len(data))
    wi, wo = spherical([0.3, 0.9], 1.0), spherical([0.2, 0.1], 0.0)
    assert np.array_equal(value.eval(wi, wo), again.eval(wi, wo))


def test_the_layout_is_as_documented(tmp_path: Path) -> None:
    path = tmp_path / "a.brdftable"
    table = isotropic()
    write_brdftable(table, path)
    data = path.read_bytes()
    magic, length, zero = struct.unpack_from("<8sII", data)
    assert (magic, zero) == (b"BRDFTABL", 0)
    assert data[16:48] == hashlib.sha256(data[48:]).digest()
    header = json.loads(data[48 : 48 + length])
    assert header["arrays"][0] == {"name": "values", "dtype": "<f4", "shape": [4, 5, 6, 3]}
    start = 48 + length
    assert start % 64 == 0
    assert np.array_equal(np.frombuffer(data, "<f4", 360, start), table.values.reshape(-1))


def test_a_model_is_tabulated_to_be_written(tmp_path: Path) -> None:
    class Lambert:
        def eval(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
            return np.full(np.broadcast_shapes(wi.shape, wo.shape), 0.25)

    path = tmp_path / "a.brdftable"
    write_brdftable(Lambert(), path)
    table = read_brdftable(path)
    assert isinstance(table, IsotropicTable)
    assert table.values.shape == (90, 90, 180, 3)
    assert "90 × 90 × 180" in table.facts["notes"][-1]
    assert table.eval(spherical(0.3, 0.0), spherical(0.4, 1.0)) == pytest.approx([0.25] * 3)


def signed(header: dict[str, Any] | bytes, payload: bytes) -> bytes:
    """A file with a checksum that fits, whatever it says."""
    text = header if isinstance(header, bytes) else json.dumps(header).encode()
    text += b" " * (-(48 + len(text)) % 64)
    body = text + payload
    return struct.pack("<8sII", b"BRDFTABL", len(text), 0) + hashlib.sha256(body).digest() + body


def sound_header() -> dict[str, Any]:
    return {
        "format": "brdftable",
        "version": 1,
        "kind": "isotropic",
        "source": "",
        "facts": {},
        "reciprocal": True,
        "arrays": [
            {"name": "values", "dtype": "<f4", "shape": [2, 2, 2, 3]},
            {"name": "holes", "dtype": "|u1", "shape": [2, 2, 2]},
        ],
    }


SOUND = np.ones(24, "<f4").tobytes() + bytes(32) + bytes(64)


def test_the_hand_made_file_is_sound(tmp_path: Path) -> None:
    path = tmp_path / "a.brdftable"
    path.write_bytes(signed(sound_header(), SOUND))
    assert np.array_equal(read_brdftable(path).values, np.ones((2, 2, 2, 3)))


def test_coverage_that_belongs_to_no_table_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.brdftable"
    header = sound_header()
    header["arrays"].append({"name": "samples", "dtype": "<f4", "shape": [2, 2, 2]})
    ones = np.ones(8, "<f4").tobytes() + bytes(32)
    path.write_bytes(signed(header, SOUND + ones))
    with pytest.raises(FileError, match=r"array samples.*belong together"):
        read_brdftable(path)
    header["arrays"].append({"name": "deviation", "dtype": "<f4", "shape": [2, 2, 2]})
    path.write_bytes(signed(header, SOUND + 2 * ones))
    assert np.array_equal(read_brdftable(path).coverage.samples, np.ones((2, 2, 2)))
    path.write_bytes(signed(header, SOUND[:128] + b"\1" * 8 + SOUND[136:] + 2 * ones))
    with pytest.raises(FileError, match=r"array samples.*not measured"):
        read_brdftable(path)
    path.write_bytes(signed(header, SOUND + ones + np.full(8, -1.0, "<f4").tobytes() + bytes(32)))
    with pytest.raises(FileError, match=r"array deviation.*negative"):
        read_brdftable(path)


def changed(**fields: Any) -> bytes:
    return signed({**sound_header(), **fields}, SOUND)


def shaped(shape: Any, dtype: Any = "<f4", payload: bytes = SOUND) -> bytes:
    header = sound_header()
    header["arrays"][0] |= {"shape": shape, "dtype": dtype}
    return signed(header, payload)


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (b"", "is no .brdftable"),
        (b"BRDFTABL", "cut off"),
        (b"BRDFTABL" + bytes(30), "cut off"),
        (struct.pack("<8sII32s", b"BRDFTABL", 2**32 - 1, 0, b""), "byte 8"),
        (signed(sound_header(), SOUND)[:-1], "checksum"),
        (signed(sound_header(), SOUND)[:-64] + b"x" * 64, "checksum"),
        (signed(sound_header(), SOUND[:-64]), "'holes' that does not fit"),
        (signed(sound_header(), SOUND + bytes(64)), "64 bytes that belong to no array"),
        (signed(b"[1, 2]", b""), "no JSON object"),
        (signed(b"{", b""), "not JSON"),
        (signed(b"\xff\xfe", b""), "not JSON"),
        (signed(b"[" * 100_000, b""), "not JSON"),
        (signed(b'{"a": NaN}', b""), "not JSON"),
        (changed(format="other"), "format"),
        (changed(version=2), "has version 2; this program reads 1"),
        (changed(kind="spherical"), "header, kind"),
        (changed(kind=["isotropic"]), "header, kind"),
        (changed(kind="scattered"), "lacks the array"),
        (changed(reciprocal=1), "header, reciprocal"),
        (changed(source=None), "header, source"),
        (changed(facts=[]), "header, facts"),
        (changed(colour="x"), "header, colour: is unknown"),
        (signed({**sound_header(), "arrays": []}, b""), "lacks the array 'holes'"),
        (changed(arrays=None), "lists no arrays"),
        (changed(arrays=[{}] * 65), "more than 64"),
        (changed(arrays=[{"name": "values"}]), r"arrays\[0\]"),
        (changed(arrays=sound_header()["arrays"][:1] * 2), "does not fit"),
        (shaped([2, 2, 2, 2**40]), "positive whole numbers"),
        (shaped([2**30] * 8), "does not fit"),
        (shaped([2, 2, -2, 3]), "positive whole numbers"),
        (shaped([2, 2, True, 3]), "positive whole numbers"),
        (shaped([2] * 9), "at most 8"),
        (shaped([2, 2, 2, 3], "|O"), "one of"),
        (shaped([2, 2, 2, 3], ["<f4"]), "one of"),
        (shaped([2, 2, 6]), "array values"),
        (
            shaped([2, 2, 2, 3], payload=np.full(24, np.nan, "<f4").tobytes() + SOUND[96:]),
            "array values.*not finite",
        ),
        (
            shaped([2, 2, 2, 3], payload=np.full(24, -1, "<f4").tobytes() + SOUND[96:]),
            "array values.*negative",
        ),
        (shaped([2, 2, 2, 3], payload=SOUND[:128] + b"\2" * 8 + bytes(56)), "array holes"),
    ],
)
def test_what_is_not_sound_is_refused_by_place(content: bytes, says: str, tmp_path: Path) -> None:
    path = tmp_path / "a.brdftable"
    path.write_bytes(content)
    with pytest.raises(FileError, match=says) as caught:
        read_brdftable(path)
    assert str(path) in str(caught.value)


@settings(max_examples=2 * settings.default.max_examples)
@given(st.integers(0, 2000), st.binary(min_size=1, max_size=8))
def test_no_changed_byte_is_read(tmp_path_factory: pytest.TempPathFactory, place: int, other: bytes) -> None:
    sound = signed(sound_header(), SOUND)
    place %= len(sound) - len(other)
    content = sound[:place] + other + sound[place + len(other) :]
    if content == sound:
        return
    path = tmp_path_factory.mktemp("damage") / "a.brdftable"
    path.write_bytes(content)
    with pytest.raises(FileError):
        read_brdftable(path)


@settings(max_examples=3 * settings.default.max_examples)
@given(st.integers(0, 2000), st.binary(min_size=1, max_size=8), st.integers(0, 3))
def test_damage_with_a_checksum_that_fits_is_refused_or_sound(
    tmp_path_factory: pytest.TempPathFactory, place: int, other: bytes, longer: int
) -> None:
    body = bytearray(signed(sound_header(), SOUND)[48:])
    place %= len(body)
    body[place : place + max(0, len(other) - longer)] = other
    length = len(body) - len(SOUND)
    path = tmp_path_factory.mktemp("damage") / "a.brdftable"
    start = struct.pack("<8sII", b"BRDFTABL", length, 0)
    path.write_bytes(start + hashlib.sha256(body).digest() + bytes(body))
    try:
        table = read_brdftable(path)
    except FileError:
        return
    assert np.isfinite(table.values).all()
    assert table.values.min() >= 0.0


def test_facts_that_are_no_plain_values_are_refused_and_the_old_file_stays(tmp_path: Path) -> None:
    path = tmp_path / "a.brdftable"
    path.write_bytes(b"old")
    for odd in (object(), float("nan"), {1, 2}):
        table = IsotropicTable(np.ones((2, 2, 2, 3), np.float32), facts={"odd": odd})
        with pytest.raises(FileError, match="facts"):
            write_brdftable(table, path)
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]
