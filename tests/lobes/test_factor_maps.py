"""The panel Factors: the maps of what is a product, their scale and channel, and words where there are none."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from brdf_lobe_visualizer.factor_maps.part import Factors, grid_of, title_of
from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial

from brdf_suite.inspection.factor_pictures import angles_at, factor_pictures, factored_in
from brdf_suite.pipeline.material import Material
from brdf_suite.reflectance.factored.map import MapFactor
from brdf_suite.reflectance.factored.model import Factored
from brdf_suite.reflectance.models.coated import Coated
from brdf_suite.reflectance.registry import MODELS


def product() -> Factored:
    ramp = np.linspace(0.1, 1.0, 8, dtype=np.float32)[:, None] * np.ones(3, np.float32)
    whole = np.broadcast_to(ramp[None, :, :], (8, 8, 3)).copy()
    return Factored(
        whole,
        ramp[::-1].copy(),
        0.2,
        more=(MapFactor("w.h", ramp, True, "d"),),
        peak=(MapFactor("sqrt|h|", ramp[::-1].copy(), True, "s"),),
    )


def test_each_map_is_drawn_once_over_what_it_depends_on() -> None:
    p, q, d, s = factor_pictures(product())
    assert [(one.name, one.reads, one.part, one.form) for one in (p, q, d, s)] == [
        ("p", ("wi", "wo"), "product", "disc"),
        ("q", ("|h|",), "product", "disc"),
        ("d", ("w.h",), "product", "band"),
        ("s", ("sqrt|h|",), "peak", "disc"),
    ]
    for one in (p, q, d, s):
        assert one.values.max() == pytest.approx(1.0)
        np.testing.assert_allclose(one.largest, 1.0, rtol=0.05)
    # p grows with s, from left to right; the radial ones fall from the middle; the band grows to the right.
    assert p.values[64, 100, 0] > p.values[64, 30, 0]
    np.testing.assert_allclose(q.values[64, 64], 1.0, rtol=0.05)
    assert q.values[64, 64, 0] > q.values[64, 110, 0] > 0.0
    assert d.values[5, 120, 1] > d.values[5, 10, 1]
    assert p.outside[0, 0]
    assert not d.outside.any()
    assert title_of(p) == "p(ωi) p(ωo)"


def test_a_place_in_a_round_map_is_a_direction() -> None:
    assert angles_at(0.5, 0.5) == pytest.approx((0.0, 0.0), abs=1e-9)
    theta, phi = angles_at(1.0, 0.5)
    assert (theta, phi) == pytest.approx((90.0, 0.0), abs=1e-9)
    assert angles_at(0.5, 0.0)[1] == pytest.approx(90.0)
    assert angles_at(0.0, 0.0) is None


def test_what_is_a_product_is_found_under_a_coat_too() -> None:
    value = product()
    assert factored_in(value) is value
    assert factored_in(Coated(value, 1.5, 0.01)) is value
    assert factored_in(MODELS["phong"].default) is None


@pytest.mark.parametrize("tone", ["gamma", "log"])
@pytest.mark.parametrize("channel", ["colour", "green"])
def test_the_scale_is_that_of_the_pictures(channel: str, tone: str) -> None:
    grid = grid_of(factor_pictures(product()), channel, tone)
    assert grid.columns[0] == "p(ωi) p(ωo)"
    assert grid.bar is not None
    assert grid.bar.ticks[0][0] == pytest.approx(1.0)
    codes = grid.pictures[0, 2].codes
    assert codes[0, -1].min() >= 250
    assert codes[0, 0].max() < codes[0, -1].max()
    assert grid.pictures[0, 3].notes
    assert not grid.pictures[0, 0].notes


@pytest.mark.parametrize(("channel", "index"), [("red", 0), ("green", 1), ("blue", 2)])
def test_a_channel_shows_its_own_values(channel: str, index: int) -> None:
    first = factor_pictures(product())[0]
    coloured = replace(first, values=first.values * (1.0, 0.5, 0.2))
    value = grid_of((coloured,), channel, "gamma").pictures[0, 0].value
    np.testing.assert_array_equal(value, coloured.values[..., index])


def test_the_panel_shows_the_front_one_and_says_where_there_is_nothing(window_with_factors, qtbot) -> None:
    program = window_with_factors
    part = program.feature(Factors)
    part.dock.show()
    program.sources.add(PlottedMaterial("", "Satin", Material("Satin", product())))
    program.sources.add(PlottedMaterial("", "Matt", Material("Matt", MODELS["lambertian"].default)))
    satin, matt = program.session.subjects
    program.session.set_front(satin.key)
    view = part.panel.view
    qtbot.waitUntil(lambda: view.grid.columns == ("p(ωi) p(ωo)", "q(|h|)", "d(ω·h)", "s(√|h|)"))
    assert "Satin" in part.panel.note.text()
    assert "p(ωi) p(ωo): θ 0.0°" in view.head_at(0, 0.5, 0.5)
    assert "d(ω·h): at 0.25" in view.head_at(2, 0.25, 0.5)
    before = view.grid.pictures[0, 0].codes
    part.panel.tone.set_choice("log")
    part.panel.tone.chosen.emit("log")
    assert not np.array_equal(view.grid.pictures[0, 0].codes, before)
    assert part.run_script("factor-channel", "red")
    assert part.panel.channel.choice == "red"
    assert not part.run_script("factor-channel", "mauve")
    program.session.set_front(matt.key)
    qtbot.waitUntil(lambda: not view.grid.columns)
    assert "Matt" in view.empty.text()
