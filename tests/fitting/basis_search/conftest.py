"""A small database of real paints, and the stored answer of the whole one."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from brdf_suite.fitting.basis_search.database import Database, load_database
from brdf_suite.resources import resource_root

FEW = ("blue", "satin_blue", "solid_red")


@pytest.fixture(scope="session")
def few_paints(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of three shipped paints."""
    folder = tmp_path_factory.mktemp("paints")
    for name in FEW:
        shutil.copy(resource_root() / "paints" / f"{name}.brdfpaint", folder)
    return folder


@pytest.fixture(scope="session")
def few(few_paints: Path) -> Database:
    """The database of these three."""
    return load_database(few_paints)


@pytest.fixture(scope="session")
def whole() -> Database:
    """The database of all shipped paints."""
    return load_database(resource_root() / "paints")
