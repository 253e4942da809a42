"""The other program that colours are compared with."""

from __future__ import annotations

import importlib
import warnings
from types import ModuleType

import numpy as np
import pytest


@pytest.fixture(scope="session")
def colour() -> ModuleType:
    """colour-science. Its import says that it will not plot without Matplotlib; no test plots."""
    # It also changes how numpy prints arrays, which is no business of the other tests.
    with np.printoptions(), warnings.catch_warnings():
        warnings.filterwarnings("ignore", message='"Matplotlib" related API features are not available')
        return importlib.import_module("colour")
