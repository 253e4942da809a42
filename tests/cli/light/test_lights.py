"""``brdf-suite environment lights``: figures that add up, and a picture that shows where they are."""

import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from brdf_suite.cli.main import main
from brdf_suite.documents.view import ENVIRONMENT_LAYOUTS
from brdf_suite.files.images.environments import write_exr
from brdf_suite.lighting.layouts import LAYOUTS
from brdf_suite.lighting.lights import directional_lights
from brdf_suite.lighting.procedural.daylight import SUN
from brdf_suite.pipeline.environments import read_environment
from brdf_suite.pipeline.scene import find_environment


def test_the_json_holds_the_lights(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["environment", "lights", "sunny", "-n", "12", "--method", "structured", "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    expected = directional_lights(read_environment(find_environment("sunny")[1]), 12, "structured")
    assert answer["count"] == len(answer["lights"]) == 12
    np.testing.assert_allclose([light["strength"] for light in answer["lights"]], expected.strengths)
    np.testing.assert_allclose(
        np.sum([light["strength"] for light in answer["lights"]], axis=0), answer["total"]
    )
    sun = answer["lights"][0]
    assert sun["elevation_deg"] == pytest.approx(SUN.height_deg, abs=0.4)
    assert sun["azimuth_deg"] == pytest.approx(SUN.azimuth_deg, abs=0.4)


def test_the_table_and_the_picture(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    target = tmp_path / "lights.png"
    assert main(["environment", "lights", "booth", "-n", "5", "-o", str(target)]) == 0
    out = capsys.readouterr().out
    assert "5 lights by relaxed" in out
    assert str(target) in out
    plain = Image.open(target).convert("RGB")
    assert plain.size == (1024, 512)
    few = np.asarray(plain, dtype=float)
    assert main(["environment", "lights", "booth", "-n", "200", "-o", str(target)]) == 0
    many = np.asarray(Image.open(target).convert("RGB"), dtype=float)
    assert (few != many).any(axis=2).mean() > 0.01  # other rings, not the map alone


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["nothing_like_it"], "there is no such file"),
        (["booth", "-o", "lights.jpg"], "must end in .png"),
        (["booth", "-o", "/no/such/folder/lights.png"], "cannot be written"),
    ],
)
def test_a_mistake_is_reported_in_one_line(
    capsys: pytest.CaptureFixture[str], arguments: list[str], words: str
) -> None:
    assert main(["environment", "lights", *arguments]) == 1
    reported = capsys.readouterr().err
    assert words in reported
    assert reported.count("\n") == 1


@pytest.mark.parametrize("count", ["0", "1025", "-3", "²", "1e3", "9" * 400])
def test_an_impossible_number_is_a_wrong_argument(capsys: pytest.CaptureFixture[str], count: str) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(["environment", "lights", "booth", f"--count={count}"])
    assert stopped.value.code == 2


def test_the_help_names_what_there_is() -> None:
    assert ("auto", *LAYOUTS) == ENVIRONMENT_LAYOUTS


def test_the_layout_can_be_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A square image is a light probe or a dome: the shape is ambiguous, and the lights differ."""
    pixels = np.zeros((64, 64, 3), dtype=np.float32)
    pixels[24:40, 24:40] = 1.0
    write_exr(tmp_path / "probe.exr", pixels)
    strongest = {}
    for name in ("angular", "dome"):
        assert (
            main(
                ["environment", "lights", str(tmp_path / "probe.exr"), "-n", "1", "--layout", name, "--json"]
            )
            == 0
        )
        strongest[name] = json.loads(capsys.readouterr().out)["lights"][0]["direction"]
    assert strongest["angular"] == pytest.approx([0.0, 0.0, -1.0], abs=0.05)
    assert strongest["dome"] == pytest.approx([0.0, 1.0, 0.0], abs=0.05)
