"""The packaged paints: as generated, honest about their source, and measured back as they claim."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

import pytest

from brdf_suite.appearance.difference import delta_e_2000
from brdf_suite.documents.store import load_paint
from brdf_suite.reflectance import measure_lab
from brdf_suite.reflectance.build import build_paint
from brdf_suite.reflectance.gloss_reading import total_gloss
from brdf_suite.resources import resource, resource_names

NAMES = resource_names("paints", ".brdfpaint")


def test_there_are_enough() -> None:
    assert len(NAMES) >= 16
    assert {"blue", "fine_silver", "red", "white_pearl", "silver_metallic", "pearl"} <= set(NAMES)


@pytest.mark.parametrize("name", NAMES)
def test_each_returns_its_own_readings(name: str) -> None:
    paint = load_paint(resource("paints", f"{name}.brdfpaint"))
    built = build_paint(paint)
    assert built.notices == ()
    for m in paint.measurements:
        assert float(delta_e_2000(measure_lab(built, 45.0, m.aspecular_deg), m.lab)) < 0.05
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
        "generate_paints", checkout / "packaging/generate_paints.py"
    )
    assert spec is not None
    assert spec.loader is not None
    generator = importlib.util.module_from_spec(spec)
    monkeypatch.setitem(sys.modules, spec.name, generator)
    spec.loader.exec_module(generator)
    written = generator.generate(tmp_path / "paints")
    assert sorted(path.stem for path in written) == NAMES
    for path in written:
        assert path.read_bytes() == resource("paints", path.name).read_bytes()
