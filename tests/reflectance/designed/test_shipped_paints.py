"""The packaged paints: as generated, honest about their source, and measured back as they claim."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

import pytest

from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.store import load_any_paint, load_paint
from brdf_suite.fitting.metrics import aspecular_lab
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.reflectance.instruments.glossmeter import total_gloss
from brdf_suite.reflectance.models.table_1 import SOURCE, TABLE_1
from brdf_suite.resources import resource, resource_names

NAMES = resource_names("paints", ".brdfpaint")
LOBES = resource_names("paints/cook_torrance", ".brdfpaint")


def test_there_are_enough() -> None:
    assert len(NAMES) + len(LOBES) >= 30
    assert {"blue", "fine_silver", "red", "white_pearl", "silver_metallic", "pearl"} <= set(NAMES)
    paints = [load_paint(resource("paints", f"{name}.brdfpaint")) for name in NAMES]
    several_lights = [p for p in paints if len({m.illumination_deg for m in p.measurements}) > 1]
    assert len(several_lights) >= 2
    gloss = sorted(paint.gloss.gu_20 for paint in paints)
    assert gloss[0] < 5.0
    assert any(10.0 < gu < 30.0 for gu in gloss)
    assert sum(paint.flakes is None for paint in paints) >= 4


def test_the_eight_of_table_1_are_among_them_with_the_paper_s_numbers() -> None:
    assert set(LOBES) == set(TABLE_1)
    assert len(LOBES) == 8
    for name in LOBES:
        paint = load_any_paint(resource("paints/cook_torrance", f"{name}.brdfpaint"))
        assert isinstance(paint, CookTorrancePaint)
        assert paint == TABLE_1[name]
        assert paint.source == SOURCE


@pytest.mark.parametrize("name", NAMES)
def test_each_returns_its_own_readings(name: str) -> None:
    paint = load_paint(resource("paints", f"{name}.brdfpaint"))
    built = build_paint(paint)
    assert built.notices == ()
    for m in paint.measurements:
        assert float(delta_e_2000(aspecular_lab(built, m.aspecular_deg, m.illumination_deg), m.lab)) < 0.05
    assert total_gloss(built.base, built.coat)[0] == pytest.approx(paint.gloss.gu_20, abs=0.5)


@pytest.mark.parametrize("name", NAMES)
def test_each_says_where_its_numbers_come_from(name: str) -> None:
    paint = load_paint(resource("paints", f"{name}.brdfpaint"))
    if "Invented" not in paint.source:
        assert "published analytic fit" in paint.source
        assert f"{paint.gloss.gu_20:g} GU at 20° is assumed" in paint.notes
        assert 88.0 <= paint.gloss.gu_20 <= 90.0


def test_the_files_are_what_the_generator_writes(
    checkout: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    spec = importlib.util.spec_from_file_location(
        "generate_paints", checkout / "packaging/generators/paints.py"
    )
    assert spec is not None
    assert spec.loader is not None
    generator = importlib.util.module_from_spec(spec)
    monkeypatch.setitem(sys.modules, spec.name, generator)
    spec.loader.exec_module(generator)
    written = generator.generate(tmp_path / "paints")
    assert sorted(path.stem for path in written) == sorted([*NAMES, *LOBES])
    for path in written:
        kept = checkout / "resources/paints" / path.relative_to(tmp_path / "paints")
        assert path.read_bytes() == kept.read_bytes()
