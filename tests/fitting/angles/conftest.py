from __future__ import annotations

from collections.abc import Iterator

import pytest

from brdf_suite.fitting.lobes.angles import AngleFitter


@pytest.fixture(scope="session")
def angle_fitter() -> Iterator[AngleFitter]:
    """One kept fitter; its generous limit keeps a loaded machine out of tests of values."""
    fitter = AngleFitter(time_limit_s=20.0)
    yield fitter
    fitter.close()
