"""The sparkle section: control to view to pixels, and what it says of the paint's flakes."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from brdf_viewer.paint.sparkle_section import NO_FLAKES, flake_facts

from brdf_suite.documents.paint import Flakes
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Lamp, Sparkle


@pytest.fixture
def near(start, lights):
    """A metallic sphere from near, in a lamp."""
    view = View(
        environment=str(lights["dim"]),
        surface="sphere",
        camera=Camera(20.0, 15.0, 0.3, focal_length_mm=260.0),
        lamps=(Lamp("directional", azimuth_deg=35.0, elevation_deg=25.0),),
        sparkle=Sparkle("off"),
    )
    return start(view=view, paint="coarse_silver")


def choose(viewer, key: str) -> None:
    box = viewer.window.sparkle.mode
    box.activated.emit(box.findData(key))


def test_each_mode_from_the_box(near) -> None:
    smooth = near.pixels().astype(int)
    seen = {}
    for mode in ("glints", "texture", "off"):
        choose(near, mode)
        assert near.view.sparkle.mode == mode
        assert near.window.sparkle.mode.currentData() == mode
        seen[mode] = np.abs(near.pixels().astype(int) - smooth).max()
    assert seen["glints"] > 20
    assert seen["texture"] > 20
    assert seen["off"] <= 1
    assert not near.window.sparkle.strength.isEnabled()


def test_a_mode_and_back_by_undo(near) -> None:
    choose(near, "glints")
    assert near.view.sparkle.mode == "glints"
    assert near.window.sparkle.mode.currentData() == "glints"
    near.window.commands.undo.trigger()
    assert near.view.sparkle.mode == "off"
    assert near.window.sparkle.mode.currentData() == "off"


def test_lights_and_strength(near) -> None:
    choose(near, "glints")
    section = near.window.sparkle
    section.lights.slider.setValue(3)
    assert near.view.sparkle.light_count == 3
    weak = near.pixels().astype(int)
    section.strength.number.setValue(6.0)
    assert near.view.sparkle.strength == pytest.approx(6.0)
    assert np.abs(near.pixels().astype(int) - weak).max() > 20
    section.strength.number.setValue(0.0)
    choose(near, "off")
    smooth = near.pixels().astype(int)
    near.state.change_view(sparkle=Sparkle("glints", strength=0.0))
    assert np.abs(near.pixels().astype(int) - smooth).max() <= 1


def test_it_shows_a_view_that_comes_from_elsewhere(near) -> None:
    near.state.change_view(sparkle=Sparkle("texture", 5, 2.5))
    section = near.window.sparkle
    assert section.mode.currentData() == "texture"
    assert (section.lights.value(), section.strength.value()) == (5.0, 2.5)


def test_the_paints_flakes_are_reported(near) -> None:
    facts = near.window.sparkle.facts
    assert facts.text() == "890 flakes per mm² of 38 µm, tilts spread by 0.15, of one colour"
    near.controller.paint.open("solid_white")
    assert facts.text() == NO_FLAKES
    assert facts.isVisibleTo(near.window.sparkle)
    choose(near, "off")
    smooth = near.pixels()
    choose(near, "glints")
    np.testing.assert_array_equal(near.pixels(), smooth)


def test_flakes_in_words() -> None:
    assert flake_facts(None) == NO_FLAKES
    assert flake_facts(Flakes(density_per_mm2=0.0)) == NO_FLAKES
    reported = flake_facts(dataclasses.replace(Flakes(), colour_spread=0.25))
    assert reported.endswith("colours spread by 0.25")
