"""A basis of the user's own and the other settings of a fit, from the command."""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from brdf_suite.cli.fit_options import add_fitting, parse_fitting
from brdf_suite.cli.main import main
from brdf_suite.errors import DocumentError
from brdf_suite.files.images.environments import write_exr
from brdf_suite.fitting.lobes.basis import LobeBasis, default_basis, read_basis, shipped_basis
from brdf_suite.fitting.lobes.settings import FitSettings
from brdf_suite.pipeline.scene import STACK_EXPONENTS
from brdf_suite.tracing.agreement.forms import DEFAULT_FORM, FORMS, fit_for

OWN = (2.0, 30.0, 900.0)


@pytest.fixture
def own(tmp_path: Path) -> Path:
    """A file of two and of three lobes, as short as it may be."""
    path = tmp_path / "own.json"
    results = [{"exponents": [2.0, 50.0]}, {"exponents": list(OWN)}]
    path.write_text(
        json.dumps({"format": "lobe_basis", "version": 1, "default_count": 3, "results": results})
    )
    return path


@pytest.fixture
def command(capsys: pytest.CaptureFixture[str]):
    def run(*words: object) -> tuple[int, str, str]:
        status = main([str(word) for word in words])
        out, err = capsys.readouterr()
        return status, out, err

    return run


def test_a_fit_with_a_basis_of_ones_own(command, own: Path) -> None:
    def fitted(*words: object) -> dict[str, Any]:
        status, out, err = command("fit", "blue", "--json", *words)
        assert status == 0, err
        return json.loads(out)

    assert fitted("--basis", own)["exponents"] == list(OWN)
    chosen = fitted("--basis", own, "--lobe-count", 2, "--diffuse", "measured", "--weighting", "solid-angle")
    assert chosen["exponents"] == [2.0, 50.0]
    assert (chosen["diffuse"], chosen["weighting"]) == ("measured", "solid angle")
    seven = fitted("--lobe-count", 7)
    assert tuple(seven["exponents"]) == shipped_basis(7).exponents
    assert (seven["diffuse"], seven["weighting"]) == ("joint", "absolute")
    assert len(fitted("--basis", own, "--angles", 4)["exponents"]) == 3


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["--lobe-count", "5"], ["own.json", "no basis of 5 lobes", "2, 3"]),
        (["--angles", "4", "--diffuse", "joint"], ["--diffuse", "--angles"]),
    ],
)
def test_what_cannot_be_chosen_is_refused(command, own: Path, words: list[str], expected: list[str]) -> None:
    status, _, err = command("fit", "blue", "--basis", own, *words)
    assert status == 1
    assert all(word in err for word in expected), err


def test_a_file_that_is_no_basis_is_named(command, tmp_path: Path) -> None:
    other = tmp_path / "other.json"
    other.write_text('{"format": "lobe_basis_search", "version": 1, "results": []}')
    for path, expected in ((other, "lobe_basis"), (tmp_path / "missing.json", "No such file")):
        status, _, err = command("prefilter", "booth", "--basis", path)
        assert status == 1
        assert path.name in err
        assert expected in err


def test_more_lobes_than_are_drawn_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "many.json"
    results = [{"exponents": list(range(1, 14))}]
    path.write_text(
        json.dumps({"format": "lobe_basis", "version": 1, "default_count": 13, "results": results})
    )
    with pytest.raises(DocumentError, match="at most 12"):
        read_basis(path)


def test_maps_are_filtered_for_the_basis(command, own: Path, tmp_path: Path) -> None:
    light = tmp_path / "light.exr"
    write_exr(light, np.ones((16, 32, 3), np.float32))
    status, out, err = command("prefilter", light, "--basis", own, "--json")
    assert status == 0, err
    assert json.loads(out)["exponents"] == [*STACK_EXPONENTS, 900.0]


def test_traced_pictures_have_no_basis(command, own: Path, tmp_path: Path) -> None:
    for renderer in ("reference", "raytraced"):
        status, _, err = command(
            "render", "blue", "-o", tmp_path / "a.png", "--renderer", renderer, "--basis", own
        )
        assert status == 1
        assert "there is no --basis" in err


def test_the_agreement_compares_the_chosen_fit(own: Path) -> None:
    parser = argparse.ArgumentParser()
    add_fitting(parser)
    fitting = parse_fitting(parser.parse_args(["--basis", str(own), "--weighting", "relative"]))
    assert fitting == FitSettings(LobeBasis(OWN), "relative")
    drawn = fit_for(FORMS[DEFAULT_FORM], "blue", fitting)
    of_count = fit_for(FORMS["7 lobes"], "blue", fitting)
    assert drawn is not None
    assert drawn.settings == fitting
    assert of_count is not None
    assert of_count.settings == FitSettings(shipped_basis(7), "relative")


def test_without_options_all_is_as_it_was() -> None:
    parser = argparse.ArgumentParser()
    add_fitting(parser)
    assert parse_fitting(parser.parse_args([])) == FitSettings(default_basis(), "absolute", "joint")
