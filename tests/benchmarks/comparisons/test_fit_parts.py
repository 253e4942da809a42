"""The parts of ``bench fit`` and the comparisons beside them run, here with few paints and steps."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.errors import SuiteError
from brdf_suite.fitting.basis_search.database import Database, load_database
from brdf_suite.fitting.lobes.basis import STORED_NAME
from brdf_suite.pipeline.material import paint_names
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.resources import resource, resource_root

HERE = Path(__file__).resolve().parent


def finite(figures: dict[str, float | None], module: ModuleType) -> dict[str, float]:
    """The figures, which are those that the part declares, and numbers."""
    assert list(figures) == list(module.BOUNDS)
    assert all(value is not None and math.isfinite(value) for value in figures.values())
    return {key: float(value) for key, value in figures.items() if value is not None}


def test_the_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    part = load_module(HERE.parent / "parts" / "fit_limit.py")
    for name, value in {
        "SAMPLES": 300,
        "LOBES": 16,
        "RUNS": 1,
        "FITS": 3,
        "COMPARED": 2,
        "PAUSE_S": 0.0,
        "DRAG_STEPS": 4,
        "COMPARED_STEPS": 2,
        "PAINTS": 1,
        "TARGETS": 2,
        # Any machine comes to an end within these.
        "OPTIMA": 2,
        "IDLE_S": 200.0,
        "BUSY_S": 200.0,
        "BUSY": 1,
        "INTERIMS": 3,
    }.items():
        assert hasattr(part, name)
        monkeypatch.setattr(part, name, value)
    figures = finite(part.run(None), part)
    assert figures["objective_rel_gap"] < 1e-5
    assert figures["linprog_ratio"] > 1.0
    assert figures["optimum_delivered"] == 1.0
    assert 0.0 < figures["interim_base_share"] < 1.0
    assert 0.0 < figures["interim_coat_share"] < 1.0


def test_the_angles(monkeypatch: pytest.MonkeyPatch) -> None:
    part = load_module(HERE.parent / "parts" / "fit_angles.py")
    # What the figures' meaning says of the database holds.
    assert len(part.designed()) == len(paint_names()) == 40
    assert len(part.cook_torrance()) == len(TABLE_1) == 8
    few = {name: part.designed()[name] for name in ("blue", "matte_grey", "gold_green_shift")}
    some = part.cook_torrance(2)
    monkeypatch.setattr(part, "STEPS", 3)
    monkeypatch.setattr(part, "designed", lambda: few)
    monkeypatch.setattr(part, "cook_torrance", lambda: some)
    reported: list[tuple[float, str]] = []
    figures = finite(part.run(lambda share, what: reported.append((share, what))), part)
    assert figures["de00_worst_usual"] < figures["de00_worst"] < 4.0
    assert figures["de00_at_measured"] < 0.2
    assert figures["de00_at_measured_cook_torrance"] < figures["de00_worst_cook_torrance"] < 7.0
    for key in ("de00_worst_usual", "de00_at_measured_cook_torrance", "de00_worst_cook_torrance"):
        assert part.BOUNDS[key][:2] == ("", None)
    assert [share for share, _ in reported] == sorted(share for share, _ in reported)
    assert any("table1_" in what for _, what in reported)


def test_the_basis(monkeypatch: pytest.MonkeyPatch) -> None:
    """Over a few of the paints, which a stored search of the same hash stands for."""
    part = load_module(HERE.parent / "parts" / "fit_basis.py")
    stored = json.loads(resource("basis", STORED_NAME).read_text(encoding="utf-8"))
    whole = load_database(resource_root() / "paints")
    few = Database(whole.paints[:3], stored["provenance"]["database_sha256"])
    monkeypatch.setattr(part, "load_database", lambda _folder: few)
    monkeypatch.setattr(part, "FIRST", part.FIRST[:1])
    monkeypatch.setattr(part, "LAST", part.LAST[-2:])
    figures = finite(part.run(None), part)
    assert figures["basis_vs_log"] < 1.5
    assert figures["database_paints"] == 3.0
    monkeypatch.setattr(part, "load_database", lambda _folder: Database(few.paints, "another"))
    with pytest.raises(SuiteError, match="other paints"):
        part.run(None)


def test_the_parts_are_reported_one_after_another_in_words(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = load_module(HERE.parent / "bench_fit.py")
    for module in whole.PARTS:

        def run(progress: object, module: ModuleType = module) -> dict[str, float]:
            assert callable(progress)
            progress(0.5, f"half of {module.TITLE}")
            return dict.fromkeys(module.BOUNDS, 1.0)

        monkeypatch.setattr(module, "run", run)
    reported: list[tuple[float, str]] = []
    figures = whole.run(lambda share, what: reported.append((share, what)))
    assert set(figures) == set(whole.BOUNDS)
    titles = [module.TITLE for module in whole.PARTS]
    assert [what for _, what in reported] == [w for title in titles for w in (title, f"half of {title}")]
    assert [share for share, _ in reported] == [k / (2 * len(titles)) for k in range(2 * len(titles))]


def test_the_comparison_of_limits_prints_its_tables() -> None:
    command = [sys.executable, "-W", "error", "compare_limit.py", "--paints", "2"]
    done = subprocess.run(command, cwd=HERE, capture_output=True, text=True, timeout=240, check=False)
    assert done.returncode == 0, done.stderr
    rows = [line for line in done.stdout.splitlines() if line.startswith("| ")]
    assert len(rows) >= 14
    assert not any("nan" in line for line in rows)


def test_the_comparison_of_incidences_prints_its_tables(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.syspath_prepend(str(HERE.parent / "parts"))
    import compare_incidences as compared

    few = {name: compared.PAINTS[name] for name in ("blue", "matte_grey", "gold_green_shift")}
    for name, value in {
        "PAINTS": few,
        "USUAL": ["blue"],
        "MATTE": {"matte_grey"},
        "SHIFT": {"gold_green_shift"},
        "TABLE_1": {name: TABLE_1[name] for name in list(TABLE_1)[:2]},
    }.items():
        monkeypatch.setattr(compared, name, value)
    compared.by_incidence()
    compared.coats()
    compared.cook_torrance()
    compared.table(["angles", *compared.HEAD], [["8", *compared.score(compared.AngleFitter())]])
    rows = [line for line in capsys.readouterr().out.splitlines() if line.startswith("| ")]
    assert len(rows) >= 3 * 6 + 4 + 2 * 3 + 2
    assert not any("nan" in line for line in rows)
