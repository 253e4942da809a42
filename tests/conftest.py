"""Fixtures that every room's tests share."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

CHECKOUT = Path(__file__).resolve().parent.parent


@pytest.fixture(scope="session")
def shared_data() -> Path:
    """The folder of real files made by others; the test is skipped where there is none."""
    root = Path(os.environ.get("BRDF_SUITE_SHARED", CHECKOUT.parent / "shared"))
    if not (root / "data").is_dir():
        pytest.skip("no real files: set BRDF_SUITE_SHARED to the folder that holds data/")
    return root / "data"


@pytest.fixture(autouse=True)
def own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """No test reads or writes the user's cache."""
    monkeypatch.setenv("BRDF_SUITE_CACHE", str(tmp_path / "cache"))


@pytest.fixture(scope="session")
def checkout() -> Path:
    """The top of the source tree."""
    return CHECKOUT
