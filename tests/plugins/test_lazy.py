"""Plug-ins are looked up when a table is read, and not when the suite is imported or a paint is opened."""

from __future__ import annotations

import subprocess
import sys

import pytest


def modules_after(code: str) -> set[str]:
    code = f"{code}\nimport sys\nprint('\\n'.join(sys.modules))"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=240
    )
    return set(done.stdout.split())


@pytest.mark.parametrize(
    "code",
    [
        "import brdf_suite",
        "import brdf_suite.reflectance.registry, brdf_suite.files.measured, brdf_suite.files.palettes",
        "from brdf_suite.pipeline.material import load_material; load_material('blue')",
        "from brdf_suite.pipeline.material import load_material; load_material('ggx')",
    ],
)
def test_nothing_is_looked_up_before_it_is_needed(code: str) -> None:
    assert "importlib.metadata" not in modules_after(code)


def test_the_suite_is_imported_without_numpy() -> None:
    assert not {"numpy", "brdf_suite.plugins"} & modules_after("import brdf_suite")


def test_a_table_looks_them_up() -> None:
    assert "importlib.metadata" in modules_after(
        "from brdf_suite.reflectance.registry import MODELS\nassert 'lambertian' in list(MODELS)"
    )
