"""The table of measurements and the benchmark runner."""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from types import SimpleNamespace

import pytest

from brdf_suite.cli.tools import bench
from brdf_suite.cli.tools.bench import appendix, measure
from brdf_suite.cli.tools.measurements import Bound, ReportSection, Result, page, renew_section
from brdf_suite.errors import SuiteError

DEMO = """'A benchmark for this test.'
NAME = "demo"
BOUNDS = {"fast_ms": ("<=", 5.0, "ms", "how fast"), "info": ("", None, "", "for information")}


def run(progress):
    return {"fast_ms": 4.0, "info": None}
"""


def module(**figures: float | None) -> SimpleNamespace:
    bounds = {"fast_ms": ("<=", 5.0, "ms", "how fast"), "info": ("", None, "", "for information")}
    return SimpleNamespace(
        NAME="demo", BOUNDS=bounds, NOTES={"info": "a reason"}, run=lambda progress: figures
    )


def section(name: str, value: float, more: str = "") -> ReportSection:
    bounds = {"x": Bound("<=", 2.0, "ms", f"what x of {name} is")}
    return ReportSection(
        f"About {name}.", "a machine", "2026-11-22", Result(name, {"x": value}, bounds), more
    )


def test_a_section_is_replaced_and_others_stay(tmp_path: Path) -> None:
    for one in (section("b", 1.0), section("a", 1.23456), section("b", 9.0)):
        renew_section(tmp_path, one)
    text = (tmp_path / "measurements.md").read_text()
    assert text.count("\n## ") == 2
    assert text.index("## a") < text.index("## b")
    assert "| `x` | 9 ms | ≤ 2 ms | NO | what x of b is |" in text
    assert "| `x` | 1.235 ms | ≤ 2 ms | yes | what x of a is |" in text
    kept = json.loads((tmp_path / "measurements.json").read_text())
    assert {name: kept[name]["figures"]["x"]["value"] for name in kept} == {"a": 1.235, "b": 9.0}


def test_the_page_is_made_of_the_kept_figures(checkout: Path) -> None:
    method = checkout / "docs" / "method"
    assert page(method) == (method / "measurements.md").read_text(encoding="utf-8")


def test_bench_writes_its_own_section_and_the_documents_that_quote_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    docs = tmp_path / "docs" / "method"
    docs.mkdir(parents=True)
    renew_section(docs, section("other", 1.0))
    for name in ("README.md", "CONTRIBUTING.md", "docs/method/page.md"):
        (tmp_path / name).write_text("It takes <!--figure demo.fast_ms-->?<!--/-->.\n", encoding="utf-8")
    monkeypatch.setattr(bench, "_CHECKOUT", tmp_path)
    monkeypatch.setattr(bench, "_DOCS", docs)
    folder = tmp_path / "benchmarks"
    folder.mkdir()
    (folder / "bench_demo.py").write_text(DEMO, encoding="utf-8")
    (folder / "bench_other.py").write_text("import a_package_that_is_not_there\n", encoding="utf-8")
    monkeypatch.setattr(bench, "_FOLDER", folder)
    options = argparse.Namespace(name="demo", list=False, all=False, json=True, write=True, large=False)
    assert bench.run(options) == 0
    assert "-->4.0 ms<!--/-->" in (docs / "page.md").read_text(encoding="utf-8")
    kept = json.loads((docs / "measurements.json").read_text(encoding="utf-8"))
    assert list(kept) == ["demo", "other"]
    assert kept["demo"]["figures"]["fast_ms"]["value"] == 4.0


def test_an_appendix_follows_its_table_and_is_replaced_with_it(tmp_path: Path) -> None:
    path = tmp_path / "measurements.md"
    demo = module()
    demo.appendix = lambda: "### More\n\n| a |\n|---|\n| 5 |\n"
    renew_section(tmp_path, section("b", 1.0, appendix(demo)))
    renew_section(tmp_path, section("c", 1.0, appendix(module())))
    text = path.read_text()
    assert text.index("what x of b is") < text.index("### More") < text.index("| 5 |") < text.index("## c")
    assert text.endswith("| what x of c is |\n")
    demo.appendix = lambda: "### More\n\nNothing."
    renew_section(tmp_path, section("b", 1.0, appendix(demo)))
    text = path.read_text()
    assert text.count("### More") == 1
    assert "| 5 |" not in text


def test_figures_are_held_against_their_bounds() -> None:
    result = measure(module(fast_ms=4.0, info=None), None)
    rows = {row[0]: row for row in result.rows()}
    assert rows["fast_ms"][1:4] == ("4 ms", "≤ 5 ms", "yes")
    assert rows["info"][1:] == ("not measured", "–", "", "for information (a reason)")
    assert {row[0]: row[3] for row in measure(module(fast_ms=6.0, info=1), None).rows()}["fast_ms"] == "NO"
    answer = result.to_json({})
    assert list(answer) == ["bench", "machine", "figures", "notes"]
    assert answer["figures"] == {"fast_ms": 4.0, "info": None}


def test_tables_go_into_the_object_that_json_prints() -> None:
    demo = module(fast_ms=4.0, info=None)
    demo.TABLES = {"info": {"matt": {"albedo": [[0.5, 0.5, 0.5]]}}}
    answer = measure(demo, None).to_json({})
    assert answer["tables"] == {"info": {"matt": {"albedo": [[0.5, 0.5, 0.5]]}}}


def test_undeclared_or_infinite_figures_are_a_fault() -> None:
    with pytest.raises(SuiteError, match="declares"):
        measure(module(fast_ms=1.0), None)
    with pytest.raises(SuiteError, match="inf"):
        measure(module(fast_ms=float("inf"), info=None), None)


def test_bounds_compare_both_ways() -> None:
    assert Bound(">=", 60.0, "", "").holds(61.0) is True
    assert Bound(">=", 60.0, "", "").holds(59.0) is False
    assert Bound("<=", 1.0, "", "").holds(None) is None
