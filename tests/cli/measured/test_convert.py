"""``convert`` to and from half-angle tables, as a user calls it."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.cli.main import main
from brdf_suite.files.measured.brdftable import read_brdftable, write_brdftable
from brdf_suite.files.measured.merl import read_merl, write_merl
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable


def grey(value: float, colour: tuple[float, float, float] = (1.0, 1.0, 1.0)) -> IsotropicTable:
    return IsotropicTable((value * np.ones((8, 8, 16, 1)) * colour).astype(np.float32))


def test_a_merl_table_becomes_ours_and_back(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    merl, ours, again = (tmp_path / name for name in ("a.binary", "a.brdftable", "b.binary"))
    write_merl(grey(0.1, (1.0, 0.9, 0.8)), merl)
    assert main(["convert", str(merl), str(ours), "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["format"] == "brdftable"
    assert answer["facts"]["scale_factors"] == "True"
    assert answer["notes"] == []
    assert main(["convert", str(ours), str(again)]) == 0
    before, after = (np.frombuffer(path.read_bytes(), "<f8", offset=12) for path in (merl, again))
    assert np.allclose(before, after, rtol=1e-6)


def test_scale_factors_can_be_said_and_what_is_found_is_printed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    merl, ours = tmp_path / "a.binary", tmp_path / "a.brdftable"
    write_merl(grey(0.1), merl, scale_factors=False)
    assert main(["convert", str(merl), str(ours)]) == 0
    assert "plain f_r, without MERL's scale factors" in capsys.readouterr().err
    plain = read_brdftable(ours)
    assert main(["convert", str(merl), str(ours), "--scale-factors", "yes"]) == 0
    assert read_brdftable(ours).values.max() < 0.01 * plain.values.max()


def test_what_a_format_cannot_hold_is_printed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    ours, merl = tmp_path / "a.brdftable", tmp_path / "a.binary"
    write_brdftable(grey(0.1, (0.0, 1.0, 0.0)), ours)
    assert main(["convert", str(ours), str(merl)]) == 0
    assert "too saturated for Rec. 709" in capsys.readouterr().err
    assert not np.asarray(read_merl(merl).holes).any()


def test_both_orders_of_a_pair_can_be_averaged(tmp_path: Path) -> None:
    merl, ours = tmp_path / "a.binary", tmp_path / "a.brdftable"
    stored = np.full((3, 8, 8, 32), 100.0)
    stored[..., 16:] = 300.0
    merl.write_bytes(np.array([8, 8, 32], "<i4").tobytes() + stored.astype("<f8").tobytes())
    assert main(["convert", str(merl), str(ours), "--average-reciprocal"]) == 0
    table = read_brdftable(ours)
    assert isinstance(table, IsotropicTable)
    assert table.reciprocal
    assert np.ptp(table.values, axis=(0, 1, 2)).max() == 0.0
