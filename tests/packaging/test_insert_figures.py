"""Figures in the documents are those of docs/method/measurements.json, inserted at markers."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from types import ModuleType

import pytest

from brdf_suite.cli.tools.bench import load_module


@pytest.fixture(scope="module")
def tool(checkout: Path) -> ModuleType:
    return load_module(checkout / "packaging" / "documents" / "insert_figures.py")


def row(value: float | None, unit: str) -> dict[str, object]:
    return {"value": value, "unit": unit}


KEPT = {
    "edit": {
        "figures": {
            "median_ms": row(1.833, "ms"),
            "share": row(0.7842, ""),
            "memory_mb": row(1390.0, "MB"),
            "tiny": row(5.475e-13, "ΔE00"),
            "none": row(0.0, ""),
            "gpu_ms": row(None, "ms"),
        }
    }
}


def test_the_documents_hold_the_measured_figures(tool: ModuleType, checkout: Path) -> None:
    assert tool.insert_into_documents(checkout, check=True) == []


def test_a_renewed_measurement_reaches_every_document(
    tool: ModuleType, checkout: Path, tmp_path: Path
) -> None:
    for path in (*tool.documents(checkout), checkout / "docs" / "method" / "measurements.json"):
        copy = tmp_path / path.relative_to(checkout)
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, copy)
    kept_path = tmp_path / "docs" / "method" / "measurements.json"
    kept = json.loads(kept_path.read_text(encoding="utf-8"))
    kept["fit"]["figures"]["drag_median_ms"]["value"] = 70.0
    kept_path.write_text(json.dumps(kept), encoding="utf-8")
    found = tool.insert_into_documents(tmp_path, check=True)
    assert found
    assert all("70 ms" not in path.read_text(encoding="utf-8") for path in found)
    assert tool.insert_into_documents(tmp_path) == found
    assert all("-->70 ms<!--/-->" in path.read_text(encoding="utf-8") for path in found)
    assert tool.insert_into_documents(tmp_path, check=True) == []


@pytest.mark.parametrize(
    ("marker", "text"),
    [
        ("edit.median_ms", "1.8 ms"),
        ("edit.median_ms 3", "1.83 ms"),
        ("edit.median_ms 1 bare", "2"),
        ("edit.median_ms s", "0.0018 s"),
        ("edit.share 2 %", "78 %"),
        ("edit.memory_mb", "1,400 MB"),
        ("edit.tiny", "5.5·10⁻¹³ ΔE00"),
        ("edit.none", "0"),
    ],
)
def test_a_figure_is_written_as_its_marker_asks(tool: ModuleType, marker: str, text: str) -> None:
    before = f"took <!--figure {marker}-->9 s<!--/--> and\n"
    assert tool.filled(before, KEPT, "a.md") == f"took <!--figure {marker}-->{text}<!--/--> and\n"


def test_a_marker_that_is_quoted_is_text(tool: ModuleType) -> None:
    quoted = "write `<!--figure BENCH.KEY-->` and `<!--/-->`\n"
    assert tool.filled(quoted, KEPT, "a.md") == quoted


@pytest.mark.parametrize(
    ("marker", "said"),
    [
        ("<!--figure edit.other-->1<!--/-->", "no figure 'edit.other'"),
        ("<!--figure other.median_ms-->1<!--/-->", "no figure 'other.median_ms'"),
        ("<!--figure edit.gpu_ms-->1<!--/-->", "was not measured"),
        ("<!--figure edit.memory_mb 2 s-->1<!--/-->", "not converted to s"),
        ("<!--figure edit.share 2 % x-->1<!--/-->", "options"),
        ("<!--figure edit.share-->1", "without an end"),
        ("<!--table other-->\n| 1 |\n<!--/table-->", "no table 'other'"),
    ],
)
def test_a_marker_that_cannot_be_filled_is_named(tool: ModuleType, marker: str, said: str) -> None:
    with pytest.raises(tool.MarkerError, match=rf"^a\.md:3: .*{said}"):
        tool.filled(f"# A\n\n{marker}\n", KEPT, "a.md")
