"""Three compact forms of one reflectance: one split of the data, one light, errors where no fit looked."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.errors import FittingError
from brdf_suite.fitting.cook_torrance import Settings
from brdf_suite.fitting.cook_torrance.samples import even_pairs
from brdf_suite.fitting.homomorphic.reflectance_fit import FactoringOptions
from brdf_suite.inspection.representations import (
    KINDS,
    compare_representations,
    fit_representations,
    hold_out,
)
from brdf_suite.inspection.sphere_picture import picture_differences, sphere_light
from brdf_suite.lighting.environment import Environment
from brdf_suite.pipeline.material import load_material
from brdf_suite.reflectance.albedo import directional_albedo
from brdf_suite.reflectance.material import Material
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

GREY = Environment("grey", np.ones((16, 32, 3), np.float32))
QUICK = (Settings(lobes=2, starts=2, samples=800), FactoringOptions(pairs=3000, resolution=12))
SATIN = CookTorrance(TABLE_1["table1_blue_matte"])


def samples(count: int = 900) -> ScatteredSamples:
    wi, wo = even_pairs(count, 3, 75.0)
    return ScatteredSamples(wi, wo, SATIN.eval(wi, wo))


@pytest.mark.parametrize("reflectance", [Lambertian((0.5, 0.3, 0.2)), SATIN], ids=["matt", "satin"])
def test_a_sphere_in_even_light_sends_back_its_albedo(reflectance) -> None:
    light = sphere_light(GREY, 16)
    found = light.radiance(reflectance)
    wanted = directional_albedo(reflectance, light.wo[:, 0], 64)
    ratio = found / wanted
    assert abs(ratio.mean() - 1.0) < 0.01
    # Each pixel has noise of its own.
    assert np.abs(ratio - 1.0).mean() < 0.05


def test_light_from_one_side_falls_on_that_side_of_the_sphere() -> None:
    radiance = np.full((32, 64, 3), 1e-3, np.float32)
    radiance[:4] = 1.0  # the rows around the zenith
    light = sphere_light(Environment("above", radiance), 16)
    found = light.radiance(Lambertian((0.5, 0.5, 0.5)))[:, 1]
    # Pixels come row by row from the top.
    assert found[: len(found) // 4].min() > 3.0 * found[-len(found) // 4 :].max()


def test_a_picture_differs_from_itself_by_nothing_and_from_a_lighter_one_by_something() -> None:
    found = sphere_light(GREY, 16).radiance(SATIN)
    assert not picture_differences(found, found).any()
    assert picture_differences(1.3 * found, found).mean() > 2.0


def test_samples_are_either_seen_or_held_out() -> None:
    whole = samples()
    split = hold_out(whole)
    assert len(split.wi) == 180
    rows = np.concatenate((split.seen.wi, split.wi))
    assert np.array_equal(np.unique(rows, axis=0), np.unique(whole.wi, axis=0))


def test_the_steepest_samples_are_kept_where_the_edge_is() -> None:
    whole = samples()
    split = hold_out(whole)
    kept = split.keep_edge(5.0)
    steepest = np.degrees(np.arccos(np.minimum(whole.wi[:, 2], whole.wo[:, 2]))).max()
    steepness = np.degrees(np.arccos(np.minimum(kept.wi[:, 2], kept.wo[:, 2])))
    assert steepness.max() < steepest - 5.0
    assert 0 < len(kept.wi) < len(split.wi)
    assert isinstance(kept.seen, ScatteredSamples)
    rows = np.concatenate((kept.seen.wi, kept.wi))
    assert np.array_equal(np.unique(rows, axis=0), np.unique(whole.wi, axis=0))
    assert hold_out(SATIN).keep_edge(5.0).where == hold_out(SATIN).where


def test_a_table_hides_the_rows_that_are_held_out() -> None:
    plain = IsotropicTable.from_reflectance(Lambertian((0.5, 0.5, 0.5)), HalfAngleGrid(20, 20, 24))
    values = plain.values.copy()
    values[:, 7] = 1000.0  # a row of θd that is held out
    split = hold_out(IsotropicTable(values, plain.holes))
    assert split.values.max() == 1000.0
    assert split.seen.values.max() < 1.0
    assert not split.seen.measured_mask()[:, 7].any()
    assert split.seen.measured_mask()[:, 6].any()


def test_each_form_of_a_matt_paint_is_that_paint() -> None:
    material = Material("matt", Lambertian((0.5, 0.3, 0.2)))
    found, fits = compare_representations(material, GREY, *QUICK)
    assert [row.kind for row in found.rows] == [one.kind for one in fits] == list(KINDS)
    for row in found.rows:
        assert row.errors.relative_rms < 0.02
        assert row.delta_e_mean < 0.5
        assert row.nanoseconds > 0.0
    # No lobe is needed: three numbers of four bytes.
    assert found.rows[1].size_bytes == 12
    assert json.loads(json.dumps(found.to_json()))["representations"][2]["kind"] == "homomorphic factors"


def test_no_fit_looks_at_what_is_held_out() -> None:
    whole = samples()
    order = np.random.default_rng(7).permutation(len(whole.wi))
    spoiled = whole.values.copy()
    spoiled[order[:180]] *= 10.0
    split = hold_out(replace(whole, values=spoiled))
    assert np.allclose(split.values, 10.0 * SATIN.eval(split.wi, split.wo))
    assert np.allclose(split.seen.values, SATIN.eval(split.seen.wi, split.seen.wo))
    fits = fit_representations(Material("satin", split.seen), *QUICK)
    ratios = [np.median(one.reflectance.eval(split.wi, split.wo) / split.values) for one in fits]
    # A tenth but for the fit's own error; 1 where it had seen them.
    assert max(ratios) < 0.3
    assert ratios[:2] == pytest.approx([0.1, 0.1], rel=0.05)


def test_a_designed_paint_is_compared_too() -> None:
    found, _ = compare_representations(load_material("blue"), GREY, *QUICK)
    assert found.pairs == 20_000
    assert all(row.delta_e_mean < 6.0 for row in found.rows)


def test_too_few_samples_are_named() -> None:
    few = samples(40)
    with pytest.raises(FittingError, match="few: 40 samples"):
        compare_representations(Material("few", few), GREY, *QUICK)
