"""The light booth's lamps and the automatic exposure on the command line."""

from __future__ import annotations

import argparse

import pytest

from brdf_suite.cli.picture.scene_options import add_scene, parse_view
from brdf_suite.documents.store import save_view
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Lamp, LightColour


def view(*arguments: str) -> View:
    parser = argparse.ArgumentParser()
    add_scene(parser)
    return parse_view(parser.parse_args(arguments))


def test_a_lamp_and_its_tint() -> None:
    assert view().light_colour == LightColour()
    assert view("--lamp", "TL84").light_colour == LightColour("TL84", adapted=True)
    assert view("--lamp", "A", "--unadapted").light_colour == LightColour("A", adapted=False)
    with pytest.raises(SystemExit):
        view("--lamp", "D93")


def test_the_exposure_counts_from_the_measured_one() -> None:
    assert view().exposure_mode == "locked"
    found = view("--automatic-exposure", "--exposure", "1.5")
    assert (found.exposure_mode, found.exposure_ev) == ("automatic", 1.5)


def test_options_change_a_view(tmp_path) -> None:
    path = tmp_path / "a.brdfview"
    save_view(View(light_colour=LightColour("LED", adapted=True), exposure_mode="automatic"), path)
    assert view("--view", str(path)).light_colour == LightColour("LED", adapted=True)
    assert view("--view", str(path), "--unadapted").light_colour == LightColour("LED", adapted=False)
    assert view("--view", str(path)).exposure_mode == "automatic"


def test_lamps_without_the_environment(tmp_path) -> None:
    found = view(
        "--brightness",
        "0",
        "--point-light",
        "1,2,3,4",
        "--point-light",
        "0,-1,0.5,2,3000",
        "--point-light",
        "0,1,0.5,2,3000,0.4",
        "--lamp",
        "A",
    )
    assert found.light_colour == LightColour("A", adapted=True, brightness=0.0)
    assert found.lamps == (
        Lamp("point", (1.0, 2.0, 3.0), strength=4.0),
        Lamp("point", (0.0, -1.0, 0.5), strength=2.0, temperature_k=3000.0),
        Lamp("point", (0.0, 1.0, 0.5), strength=2.0, temperature_k=3000.0, diameter=0.4),
    )
    assert view("--point-light=-1,2,3,4").lamps[0].position == (-1.0, 2.0, 3.0)
    for wrong in ("1,2,3", "1,2,3,four", "1,2,3,4,5000,6,7", "1,2,3,-4", "1,2,3,4,5000,-6"):
        with pytest.raises(SystemExit):
            view("--point-light", wrong)
