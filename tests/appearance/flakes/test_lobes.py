"""Flakes of paints of which lobes are known: tilted as their lobe says, none where no lobe can be theirs."""

from __future__ import annotations

from dataclasses import replace

import pytest

from brdf_suite.appearance.flakes.lobes import flakes_of_lobes
from brdf_suite.appearance.flakes.visible import flake_coverage
from brdf_suite.documents.cook_torrance import Clearcoat, CookTorranceLobe, CookTorrancePaint
from brdf_suite.errors import ValueRangeError
from brdf_suite.reflectance.models.table_1 import TABLE_1

METALLIC = {
    "table1_ford_f8": 0.11,
    "table1_polaris_silver": 0.17,
    "table1_opel_titan": 0.17,
    "table1_bmw_339": 0.17,
}


@pytest.mark.parametrize("name", sorted(TABLE_1))
def test_the_metallic_paints_of_table_1_have_flakes(name: str) -> None:
    flakes = TABLE_1[name].flakes
    if name not in METALLIC:
        assert flakes is None
        return
    assert flakes is not None
    assert flakes.roughness == METALLIC[name]
    assert flake_coverage(flakes) == pytest.approx(1.0, abs=0.01)


def test_below_a_coat_flakes_are_tilted_less() -> None:
    paint = TABLE_1["table1_polaris_silver"]
    coated = flakes_of_lobes(replace(paint, clearcoat=Clearcoat(ior=1.5)), 30.0, 100.0)
    assert coated is not None
    assert (coated.roughness, coated.size_um, coated.density_per_mm2) == (
        pytest.approx(0.17 / 1.5),
        30.0,
        100.0,
    )


def test_a_coat_alone_has_none() -> None:
    gloss = CookTorranceLobe((0.04, 0.04, 0.04), 0.01, 0.9)
    empty = CookTorranceLobe((0.0, 0.0, 0.0), 0.2, 0.9)
    assert flakes_of_lobes(CookTorrancePaint("solid", (0.1, 0.1, 0.1), (gloss, empty))) is None
    with pytest.raises(ValueRangeError, match="size_um"):
        flakes_of_lobes(TABLE_1["table1_ford_f8"], -1.0)
