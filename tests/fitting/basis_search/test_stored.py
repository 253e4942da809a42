"""The packaged answer: of these paints, by this code, and whole."""

from __future__ import annotations

import importlib.util
import json
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from brdf_suite.errors import DocumentError
from brdf_suite.fitting import default_basis
from brdf_suite.fitting.basis_search.database import Database
from brdf_suite.fitting.basis_search.error import BasisError
from brdf_suite.fitting.lobes.basis import STORED_NAME, stored_bases
from brdf_suite.resources import resource


@pytest.fixture(scope="module")
def stored() -> dict[str, object]:
    value: dict[str, object] = json.loads(resource("basis", STORED_NAME).read_text())
    return value


def test_it_is_of_the_shipped_paints(stored: dict, whole: Database) -> None:
    assert stored["provenance"]["database_sha256"] == whole.sha256
    assert stored["paints"] == list(whole.names)
    assert [row["count"] for row in stored["results"]] == list(range(1, 12))


def test_its_errors_are_those_of_its_exponents(stored: dict, whole: Database) -> None:
    errors = BasisError(whole)
    for row in stored["results"][::5]:
        np.testing.assert_allclose(errors(row["exponents"]), row["errors"], rtol=1e-6, atol=1e-9)
        assert row["equation_4"] == pytest.approx(row["maximum"] + row["mean"])
        assert row["maximum"] == max(row["errors"])


def test_more_lobes_are_better(stored: dict) -> None:
    values = [row["equation_4"] for row in stored["results"]]
    assert values == sorted(values, reverse=True)


def test_it_says_how_it_was_made(stored: dict) -> None:
    provenance = stored["provenance"]
    assert provenance["command"].startswith("brdf-suite basis ")
    assert provenance["seconds"] == pytest.approx(sum(row["seconds"] for row in stored["results"]))
    assert {"numpy", "scipy", "highspy", "python", "brdf-suite"} <= set(provenance["versions"])
    assert provenance["processor"]
    assert provenance["date"]


def test_the_default_is_read_from_it(stored: dict) -> None:
    row = stored["results"][stored["default_count"] - 1]
    assert default_basis().exponents == tuple(row["exponents"])


@pytest.mark.parametrize(
    ("old", "new", "place"),
    [
        ('"lobe_basis"', '"lobes"', "format"),
        ('"default_count": ', '"default_count": 9', "default_count"),
        ('"exponents": [', '"exponents": [0.5, ', r"results\[0\]\.exponents"),
        ('"exponents": [', '"exponents": ["a", ', r"results\[0\]\.exponents"),
        ('"results"', '"result"', '"results" is missing'),
        ("}", "", "line"),
    ],
)
def test_damage_is_reported_with_its_place(tmp_path: Path, old: str, new: str, place: str) -> None:
    text = resource("basis", STORED_NAME).read_text()
    assert old in text
    path = tmp_path / "search.json"
    path.write_text(text.replace(old, new, 1))
    with pytest.raises(DocumentError, match=place):
        stored_bases(path)


@pytest.fixture(scope="module")
def plots(checkout: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location("plot_basis", checkout / "packaging" / "plots" / "basis.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_both_plots_are_drawn(plots: ModuleType, tmp_path: Path) -> None:
    paths = plots.draw(resource("basis", STORED_NAME), tmp_path)
    assert sorted(path.name for path in paths) == ["basis_errors.png", "basis_exponents.png"]
    assert all(10_000 < path.stat().st_size < 300_000 for path in paths)
