"""Options of a traced picture: honoured, or refused by name."""

from __future__ import annotations

import json
import os
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.cli.main import main
from brdf_suite.documents.view import View
from brdf_suite.files.images.exr.image import read_exr
from brdf_suite.output.picture_file import PictureSettings

WORDS = ["render", "copper", "--renderer", "reference", "--mesh", "sphere", "--size", "24x20", "--spp", "4"]


@pytest.fixture(scope="module")
def traced(variant):
    """A scene and its estimate, to be written in many ways."""
    from brdf_suite.reference.passes import trace
    from brdf_suite.tracing.reference.scene import prepare_reference

    scene = prepare_reference("copper", View(surface="sphere", environment="booth"), (24, 20))
    return scene, trace(scene.traced, samples=8)


def pixels(path: Path) -> np.ndarray:
    from PIL import Image

    with Image.open(path) as image:
        return np.asarray(image)


def test_bits_colours_and_transparency_are_those_asked_for(traced, tmp_path: Path) -> None:
    from brdf_suite.tracing.reference.picture import write_reference

    scene, estimate = traced
    write_reference(tmp_path / "a.png", scene, estimate, PictureSettings())
    plain = pixels(tmp_path / "a.png").astype(int)
    np.testing.assert_array_equal(plain, scene.codes(estimate))
    write_reference(tmp_path / "b.png", scene, estimate, PictureSettings(bits=16))
    raw = (tmp_path / "b.png").read_bytes()
    assert raw[24] == 16  # IHDR's bit depth
    write_reference(tmp_path / "c.png", scene, estimate, PictureSettings(colour_space="display-p3"))
    wide = pixels(tmp_path / "c.png").astype(int)
    inside = estimate.coverage == 1.0
    # Orange takes less of red in the wider space.
    assert (plain[inside][:, 0] - wide[inside][:, 0]).mean() > 3.0
    write_reference(tmp_path / "d.png", scene, estimate, PictureSettings(transparent=True))
    alone = pixels(tmp_path / "d.png").astype(int)
    np.testing.assert_array_equal(alone[..., 3], np.rint(estimate.coverage * 255))
    assert np.abs(alone[inside][:, :3] - plain[inside]).max() <= 1
    write_reference(tmp_path / "e.exr", scene, estimate, PictureSettings(transparent=True))
    assert not read_exr(tmp_path / "e.exr").pixels[estimate.coverage == 0.0].any()


@pytest.mark.parametrize(
    ("name", "words", "expected"),
    [
        ("a.png", ["--samples", "8"], "--spp"),
        ("a.exr", ["--bits", "16"], "goes on from"),
        ("a.exr", ["--colour-space", "srgb"], "Rec. 2020"),
        ("a.png", ["--bits", "32"], "PNG has 8 or 16"),
        ("a.png", ["--quality", "fast"], "--quality"),
    ],
)
def test_what_cannot_be_is_refused_before_the_work(name, words, expected, tmp_path: Path, capsys) -> None:
    assert main([*WORDS, "-o", str(tmp_path / name), *words]) == 1
    assert expected in capsys.readouterr().err
    assert not (tmp_path / name).exists()


def test_spp_belongs_to_what_traces(tmp_path: Path, capsys) -> None:
    assert main(["render", "copper", "-o", str(tmp_path / "a.png"), "--spp", "8"]) == 1
    assert "--samples" in capsys.readouterr().err


def test_a_denoiser_that_is_not_there_is_reported_before_the_work(variant, tmp_path: Path, capsys) -> None:
    if variant.name.startswith("cuda"):
        pytest.skip("there is an NVIDIA graphics card")
    assert main([*WORDS, "-o", str(tmp_path / "a.png"), "--denoise"]) == 1
    assert "NVIDIA" in capsys.readouterr().err


def test_progress_can_be_followed_by_a_program(
    variant, small_light: str, tmp_path: Path, monkeypatch, capsys
) -> None:
    """Lines of JSON, as of every export, while standard input stays open."""
    reading, writing = os.pipe()
    with os.fdopen(reading) as stream, os.fdopen(writing, "w"):
        monkeypatch.setattr("sys.stdin", stream)
        assert main([*WORDS, "-o", str(tmp_path / "a.png"), "--environment", small_light, "--follow"]) == 0
    steps = [json.loads(line) for line in capsys.readouterr().out.splitlines() if line.startswith("{")]
    assert steps[-1]["fraction"] == 1.0
    assert (tmp_path / "a.png").exists()
