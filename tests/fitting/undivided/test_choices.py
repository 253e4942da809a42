"""What docs/method/measured_fits.md says of the choices holds on two of its reflectances, and its scripts still run."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import pytest
from PIL import Image

from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_material
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.registry import MODELS


def script(path: Path, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    monkeypatch.setitem(sys.modules, path.stem, module)
    spec.loader.exec_module(module)
    return module


def test_the_energy_row_and_three_incidences_pay(checkout: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    choices = script(checkout / "tests" / "benchmarks" / "comparisons" / "undivided_choices.py", monkeypatch)
    judges = [
        choices.Judge.of(value)
        for value in (CookTorrance(TABLE_1["table1_ford_f8"]), MODELS["ggx_clearcoat"].default)
    ]
    variants = dict(choices.VARIANTS)
    energy = {
        name: choices.compare(judges, variants[name])[2][-len(choices.VIEWS_DEG) :].mean()
        for name in ("default", "no energy row", "30, 60° (undetermined)")
    }
    assert energy["no energy row"] > 1.2 * energy["default"]
    assert energy["30, 60° (undetermined)"] > 1.5 * energy["default"]


def test_slices_and_tables_are_drawn(
    checkout: Path,
    shared_data: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    plots = script(checkout / "packaging" / "plots" / "measured_fits.py", monkeypatch)
    fits = {
        "one": fit_material(load_material("table1_white"), errors=True),
        "two": fit_material(load_material(shared_data / "brdf" / "cayman.brdf"), errors=True),
    }
    out = tmp_path / "slices.png"
    plots.draw_slices(out, fits, 2)
    with Image.open(out) as image:
        assert image.width > 400
    rows = [*plots.errors_table(fits), *plots.angles_table(fits)]
    assert sum(row.startswith("| two") for row in rows) == 2
    assert not any("nan" in row for row in rows)
