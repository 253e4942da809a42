"""``environment info``, ``studio`` and ``sky``, and where their files are taken."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.cli.light.environment import bars
from brdf_suite.cli.main import main
from brdf_suite.documents.studio import Sky, load_light
from brdf_suite.files.images.environments import read_environment_image, write_exr
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.procedural import BOOTH
from brdf_suite.lighting.procedural.studio import EXAMPLE
from brdf_suite.lighting.statistics import Histogram, environment_statistics
from brdf_suite.pipeline.environments import read_environment
from brdf_suite.pipeline.scene import find_environment


def reported(capsys: pytest.CaptureFixture[str], *arguments: str, status: int = 0) -> str:
    assert main(["environment", *arguments]) == status
    captured = capsys.readouterr()
    return captured.out if status == 0 else captured.err


def test_info_prints_the_figures_of_a_shipped_environment(capsys: pytest.CaptureFixture[str]) -> None:
    facts = json.loads(reported(capsys, "info", "sunny", "--json"))
    expected = environment_statistics(read_environment(find_environment("sunny")[1]))
    assert facts["environment"] == "sunny"
    assert (facts["width"], facts["height"]) == (1024, 512)
    assert facts["average_radiance"] == list(expected.average_radiance)
    assert facts["sun_elevation_deg"] == pytest.approx(42.0, abs=0.1)
    assert sum(facts["histogram"]["shares"]) + facts["histogram"]["black"] == pytest.approx(1.0)
    text = reported(capsys, "info", "sunny")
    assert "1,024 × 512 pixels, layout latlong" in text
    assert "42.01° above the horizon" in text
    assert text.count("#") > 40


def test_info_takes_a_layout_and_reports_repairs(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pixels = np.ones((64, 64, 3), np.float32)
    pixels[3, 3] = np.nan
    pixels[20:24, 40:44] = 2.0
    write_exr(tmp_path / "ball.exr", pixels)
    as_ball = json.loads(
        reported(capsys, "info", str(tmp_path / "ball.exr"), "--layout", "mirror_ball", "--json")
    )
    as_probe = json.loads(
        reported(capsys, "info", str(tmp_path / "ball.exr"), "--layout", "angular", "--json")
    )
    assert as_ball["layout"] == "mirror_ball"
    assert (as_ball["image_width"], as_ball["image_height"]) == (64, 64)
    guessed = json.loads(reported(capsys, "info", str(tmp_path / "ball.exr"), "--json"))
    assert guessed["layout"] == "angular", "what a square is taken for is reported"
    assert as_ball["width"] == 2 * as_ball["height"]
    assert as_ball["content_hash"] != as_probe["content_hash"]
    assert any("NaN" in note for note in as_ball["notes"])
    assert as_ball["sun_direction"] is not None
    write_exr(tmp_path / "even.exr", np.ones((16, 32, 3), np.float32))
    assert "the light is even" in reported(capsys, "info", str(tmp_path / "even.exr"))


def test_bars_are_readable_whatever_the_range() -> None:
    lines = bars(Histogram(-20.0, tuple([1.0 / 41] * 41), 0.0))
    assert len(lines) <= 20
    assert sum(float(line.rsplit(maxsplit=2)[1]) for line in lines) == pytest.approx(100.0, abs=0.2)
    assert bars(Histogram(0.0, (), 1.0)) == ["black  " + "#" * 40 + " 100.00 %"]
    black = environment_statistics(Environment("black", np.zeros((8, 16, 3), np.float32)))
    assert bars(black.histogram)


def test_a_studio_is_written_edited_and_drawn(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "mine.brdfstudio"
    reported(capsys, "studio", "--new", str(path))
    assert load_light(path) == EXAMPLE
    assert "there already" in reported(capsys, "studio", "--new", str(path), status=1)
    path.write_text(path.read_text().replace('"shape": "ring"', '"shape": "moon"'))
    assert "lamps[2].shape" in reported(capsys, "info", str(path), status=1)
    assert "Nothing to do" in reported(capsys, "studio", str(path), status=1)
    assert "must end in .brdfstudio" in reported(
        capsys, "studio", "--new", str(tmp_path / "a.json"), status=1
    )
    reported(capsys, "studio", "--new", "--booth", str(tmp_path / "booth.brdfstudio"))
    assert load_light(tmp_path / "booth.brdfstudio") == BOOTH


def test_a_sky_is_a_description_or_a_map_of_the_same_light(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    options = [
        "--model",
        "preetham",
        "--turbidity",
        "4",
        "--elevation",
        "25",
        "--azimuth",
        "-40",
        "--albedo",
        "0.1",
    ]
    reported(capsys, "sky", "-o", str(tmp_path / "day.brdfstudio"), *options)
    assert load_light(tmp_path / "day.brdfstudio") == Sky("day", "preetham", 4.0, 25.0, -40.0, 0.1, True)
    reported(capsys, "sky", "-o", str(tmp_path / "day.exr"), *options)
    drawn = read_environment(tmp_path / "day.brdfstudio")
    stored = read_environment_image(tmp_path / "day.exr").pixels
    assert drawn.name == "day"
    assert "Preetham" in drawn.notes[0]
    assert "cd/m²" in drawn.notes[0]
    np.testing.assert_allclose(stored, drawn.radiance, rtol=1e-3, atol=1e-6)
    assert "range" in reported(capsys, "sky", "-o", str(tmp_path / "a.exr"), "--elevation", "-3", status=1)
    assert "must end in" in reported(capsys, "sky", "-o", str(tmp_path / "a.hdr"), status=1)


def test_a_description_is_prefiltered_as_a_map_is(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    reported(capsys, "sky", "-o", str(tmp_path / "grey.brdfstudio"), "--model", "overcast")
    assert main(["prefilter", str(tmp_path / "grey.brdfstudio"), "--json"]) == 0
    facts = json.loads(capsys.readouterr().out)
    assert (facts["width"], facts["height"]) == (1024, 512)
    assert not facts["from_cache"]
    assert main(["prefilter", str(tmp_path / "grey.brdfstudio"), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["from_cache"]


@pytest.mark.usefixtures("shared_cache")
def test_render_reads_the_layout_it_is_reported(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write_exr(tmp_path / "square.exr", np.ones((16, 16, 3), np.float32))
    options = [
        "--environment",
        str(tmp_path / "square.exr"),
        "--size",
        "32x24",
        "-o",
        str(tmp_path / "out.png"),
    ]
    assert main(["render", "blue", "--mesh", "sphere", *options, "--layout", "vertical_cross"]) == 1
    assert "is vertical_cross, which must be 3 × 4 square faces" in capsys.readouterr().err
    assert main(["render", "blue", "--mesh", "sphere", *options, "--layout", "mirror_ball"]) == 0
