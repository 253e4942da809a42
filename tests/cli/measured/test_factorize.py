"""``brdf-suite factorize``: files that every other command opens, and errors that name what is wrong."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.cli.main import FAILED, main
from brdf_suite.documents.factored import FactoredPaint
from brdf_suite.documents.store import load_any_paint
from brdf_suite.files.measured import read_measured
from brdf_suite.files.measured.brdftable import write_brdftable
from brdf_suite.fitting.homomorphic.samples import even_directions
from brdf_suite.pipeline.material import load_material
from brdf_suite.reflectance.factored.model import Factored
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples


def pairs(count: int = 500) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(3)
    return even_directions(count, rng), even_directions(count, rng)


def near(value: object, name: str) -> float:
    """The median relative distance from a paint."""
    wi, wo = pairs()
    truth = load_material(name).reflectance.eval(wi, wo)
    return float(np.median(np.abs(value.eval(wi, wo) / truth - 1.0)))


def test_a_paint_is_written_with_its_textures_and_opened_again(tmp_path: Path, capsys) -> None:
    out = tmp_path / "matte.brdfpaint"
    assert main(["factorize", "matte_grey", "-o", str(out), "--pairs", "5000", "--json"]) == 0
    reported = json.loads(capsys.readouterr().out)
    assert reported["factors"] == "p:|wo| q:sqrt|h| p:|wi| d:w.h"
    assert reported["peak"] == "s:sqrt|h| f:w.h"
    assert reported["texels"] == {"p": [32], "q": [32], "d": [16], "s": [64], "f": [32]}
    paint = load_any_paint(out)
    assert isinstance(paint, FactoredPaint)
    assert near(load_material(out).reflectance, "matte_grey") < 0.3
    assert main(["measure", str(out), "--json"]) == 0
    assert len(json.loads(capsys.readouterr().out)["readings"]) > 0
    assert sorted(path.suffix for path in tmp_path.iterdir()) == [".brdfpaint", ".exr"]


def test_factors_and_settings_are_taken_and_a_table_is_written(tmp_path: Path, capsys) -> None:
    out = tmp_path / "matte.brdftable"
    arguments = ["factorize", "matte_grey", "-o", str(out), "--pairs", "6000", "--factors", "p:wo q:h p:wi"]
    arguments += ["--resolution", "16", "--peak", "off", "--smoothness", "3"]
    assert main([*arguments, "--json"]) == 0
    reported = json.loads(capsys.readouterr().out)
    assert reported["peak"] is None
    assert reported["compression"] == pytest.approx(6000 / (2 * 16 * 16))
    assert reported["asymmetry"]["p"] < 0.1
    whole = read_measured(out)
    assert isinstance(whole, Factored)
    assert whole.p.shape == whole.q.shape == (16, 16, 3)
    assert max(whole.p.max(), whole.q.max()) == pytest.approx(1.0)
    assert near(whole, "matte_grey") < 0.3


def test_a_file_that_is_there_is_replaced_only_when_that_is_asked_for(tmp_path: Path, capsys) -> None:
    out = tmp_path / "a.brdftable"
    out.write_bytes(b"mine")
    arguments = ["factorize", "matte_grey", "-o", str(out), "--pairs", "900", "--resolution", "8"]
    assert main(arguments) == FAILED
    assert "--overwrite" in capsys.readouterr().err
    assert out.read_bytes() == b"mine"
    assert main([*arguments, "--overwrite"]) == 0
    assert isinstance(read_measured(out), Factored)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["nothing_of_that_name", "-o", "{}/a.brdftable"], "nothing_of_that_name"),
        (["blue", "-o", "{}/a.exr"], ".brdfpaint"),
        (["blue", "-o", "{}/a.brdftable", "--resolution", "1"], "resolution"),
        (["blue", "-o", "{}/a.brdftable", "--pairs", "0"], "pairs"),
        (["blue", "-o", "{}/a.brdfpaint", "--factors", "p:somewhere"], "map:projection"),
        (["blue", "-o", "{}/a.brdfpaint", "--factors", "s:|wo| s:|wi|", "--pairs", "900"], "the peak's"),
        (["blue", "-o", "{}/a.brdfpaint", "--smoothness", "-1", "--pairs", "900"], "smoothness"),
        (["blue", "-o", "{}/none/a.brdfpaint", "--pairs", "900"], "none"),
    ],
)
def test_what_is_wrong_is_named_and_nothing_is_written(
    tmp_path: Path, capsys, arguments: list[str], said: str
) -> None:
    assert main(["factorize", *(word.format(tmp_path) for word in arguments)]) == FAILED
    assert said in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_no_textures_are_left_where_the_paint_cannot_be_written(tmp_path: Path, capsys) -> None:
    out = tmp_path / "folder.brdfpaint"
    out.mkdir()
    assert main(["factorize", "matte_grey", "-o", str(out), "--pairs", "900", "--overwrite"]) == FAILED
    assert "folder.brdfpaint" in capsys.readouterr().err
    assert [path.name for path in tmp_path.rglob("*")] == ["folder.brdfpaint"]


def test_a_file_of_zeros_is_named_and_few_samples_are_reported_as_few(tmp_path: Path, capsys) -> None:
    wi, wo = pairs(6)
    dark, few = tmp_path / "dark.brdftable", tmp_path / "few.brdftable"
    write_brdftable(ScatteredSamples(wi, wo, np.zeros((6, 3))), dark)
    assert main(["factorize", str(dark), "-o", str(tmp_path / "a.brdfpaint")]) == FAILED
    said = capsys.readouterr().err
    assert "dark.brdftable" in said
    assert "nothing to factor" in said
    write_brdftable(ScatteredSamples(wi, wo, np.full((6, 3), 0.2)), few)
    assert main(["factorize", str(few), "-o", str(tmp_path / "b.brdfpaint")]) == 0
    # 6 samples, 80 texels
    assert "0.075 samples a texel" in capsys.readouterr().out
