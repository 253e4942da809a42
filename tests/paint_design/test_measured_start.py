"""A design that starts from something measured."""

from __future__ import annotations

import math
import os
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.appearance.geometries import geometry_set
from brdf_suite.errors import SuiteError
from brdf_suite.files.measured.astm import write_astm
from brdf_suite.paint_design.measured_start import USUAL_GLOSS, load_start, measured_start
from brdf_suite.pipeline.material import Material, load_material, load_shipped_paint
from brdf_suite.reflectance.designed.build import build_paint


@dataclass(frozen=True)
class Diffuser:
    rho: float

    def eval(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
        return np.full(np.broadcast_shapes(np.shape(wi), np.shape(wo)), self.rho / math.pi)


@pytest.mark.parametrize("angles", ["e2194", "five", "six"])
def test_a_design_measured_comes_back(angles: str) -> None:
    """The paint's own readings, gloss and look return: 0.01 of rounding, and nothing at angles not used."""
    paint = load_shipped_paint("blue")
    item = Material("blue", build_paint(paint), origin="blue")
    start = measured_start(item, geometry_set(angles))
    for angle in (15.0, 45.0, 110.0):
        assert start.paint.lab_at(angle) == pytest.approx(paint.lab_at(angle), abs=0.006)
    assert start.gloss_used
    assert start.paint.gloss.gu_20 == pytest.approx(paint.gloss.gu_20, abs=0.11)
    assert start.paint.flakes is None
    assert start.mean_delta_e < 0.5
    used = {(m.illumination_deg, m.aspecular_deg) for m in start.paint.measurements}
    assert used.isdisjoint((row.illumination_deg, row.aspecular_deg) for row in start.held_out)
    assert {row.illumination_deg for row in start.held_out} == {45.0, 20.0, 60.0}
    assert start.worst.delta_e_2000 == max(row.delta_e_2000 for row in start.held_out)
    assert any("flakes" in notice for notice in start.notices)


def test_a_cook_torrance_paint_is_read_with_its_gloss() -> None:
    start = load_start("table1_blue")
    assert start.paint.lab_at(45.0) == pytest.approx((17.31, 5.42, -34.83), abs=0.01)
    assert start.paint.gloss.gu_20 == pytest.approx(31.2, abs=0.1)
    assert start.paint.gloss.gu_60 == pytest.approx(57.3, abs=0.1)
    assert start.mean_delta_e == pytest.approx(0.67, abs=0.05)
    # A matt one whose 60° reading is below its 20° one: no clearcoat does that.
    start = load_start("table1_ford_f8")
    assert (start.paint.gloss.gu_20, start.paint.gloss.gu_60) == (25.3, None)
    assert any("only the 20° reading" in notice for notice in start.notices)


def test_the_rule_that_is_nearer_to_the_original_is_taken() -> None:
    """A silver of Cook-Torrance lobes has no bell of flakes, and the flake rule misses its five readings."""
    start = load_start("table1_polaris_silver", geometry_set("five"))
    assert start.paint.interpolation == "monotone"
    assert any("the monotone rule is used" in notice for notice in start.notices)
    assert start.mean_delta_e < 5.0
    assert not any("does not pass through" in notice for notice in start.notices)
    # One that is a bell keeps the usual rule.
    assert load_start("blue", geometry_set("five")).paint.interpolation == "flake"


def test_matter_without_a_mirror_lobe_gets_the_dullest_coat_and_a_notice() -> None:
    start = measured_start(Material("chalk.bin", Diffuser(0.5)))
    assert start.paint.name == "chalk"
    assert start.paint.gloss.gu_20 < 3.0
    assert start.paint.lab_at(45.0)[0] == pytest.approx(76.07, abs=0.01)


def test_scattered_samples_have_no_gloss(shared_data: Path) -> None:
    start = load_start(shared_data / "brdf" / "cayman.brdf")
    assert start.paint.gloss == USUAL_GLOSS
    assert not start.gloss_used
    assert any("not measured" in notice for notice in start.notices)
    assert start.paint.lab_at(45.0) == pytest.approx((21.02, -31.28, -13.84), abs=0.01)
    assert start.paint.source == "Read by the virtual spectrophotometer from cayman.brdf"


def test_a_tensor_file_and_its_steps(shared_data: Path) -> None:
    heard: list[float] = []
    start = load_start(
        shared_data / "brdf" / "vch_golden_yellow_rgb.bsdf", progress=lambda f, _what: heard.append(f)
    )
    assert start.paint.gloss.gu_20 == pytest.approx(17.9, abs=0.05)
    assert heard == sorted(heard)
    assert heard[-1] == 1.0


def test_paper_gets_the_nearest_gloss_that_can_be(shared_data: Path) -> None:
    start = load_start(shared_data / "brdf" / "paper_white_rgb.bsdf")
    assert not start.gloss_used
    assert start.paint.gloss.gu_20 == pytest.approx(1.1)
    assert any("nearest found" in notice for notice in start.notices)


def test_brighter_than_a_paint_can_hold_is_reported() -> None:
    start = measured_start(Material("lamp", Diffuser(40.0)))
    assert start.paint.lab_at(45.0)[0] == 250.0
    assert any("beyond what a paint holds" in notice for notice in start.notices)


def test_what_cannot_be_read_is_reported(tmp_path: Path) -> None:
    broken = tmp_path / "broken.bsdf"
    broken.write_bytes(b"tensor_file\0 and then nothing")
    with pytest.raises(SuiteError, match="broken"):
        load_start(broken)


@pytest.mark.skipif(sys.platform != "linux", reason="other systems take text alone as names of files")
def test_the_name_of_the_measured_file_may_be_no_text(tmp_path: Path) -> None:
    path = tmp_path / os.fsdecode(b"caf\xe9\n15.csv")
    write_astm(build_paint(load_shipped_paint("blue")), path)
    assert load_material(path).name == "caf  15.csv"
    paint = load_start(path).paint
    assert paint.name == "caf  15"
    assert paint.source.endswith("from caf  15.csv")
