"""``brdf-suite factorize``: a file that every other command opens, and errors that name what is wrong."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.cli.main import FAILED, main
from brdf_suite.files.measured import read_measured
from brdf_suite.fitting.homomorphic.samples import even_directions
from brdf_suite.pipeline.measuring import load_measurable
from brdf_suite.reflectance.factored import Factored


def test_a_matte_paint_is_written_and_opened_again(tmp_path: Path, capsys) -> None:
    out = tmp_path / "matte.brdftable"
    arguments = ["factorize", "matte_grey", "-o", str(out), "--resolution", "16", "--pairs", "6000", "--json"]
    assert main(arguments) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["samples"] == 6000
    assert told["compression"] == pytest.approx(6000 / (2 * 16 * 16))
    value = read_measured(out)
    assert isinstance(value, Factored)
    assert max(value.p.max(), value.q.max()) == pytest.approx(1.0)
    rng = np.random.default_rng(3)
    wi, wo = even_directions(500, rng), even_directions(500, rng)
    truth = load_measurable("matte_grey").reflectance.eval(wi, wo)
    assert np.median(np.abs(value.eval(wi, wo) / truth - 1.0)) < 0.25
    assert main(["measure", str(out), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["nothing_of_that_name", "-o", "{}/a.brdftable"], "nothing_of_that_name"),
        (["blue", "-o", "{}/a.exr"], ".brdftable"),
        (["blue", "-o", "{}/a.brdftable", "--resolution", "1"], "resolution"),
        (["blue", "-o", "{}/a.brdftable", "--pairs", "0"], "pairs"),
    ],
)
def test_what_is_wrong_is_named_and_nothing_is_written(
    tmp_path: Path, capsys, arguments: list[str], said: str
) -> None:
    assert main(["factorize", *(word.format(tmp_path) for word in arguments)]) == FAILED
    assert said in capsys.readouterr().err
    assert not list(tmp_path.iterdir())
