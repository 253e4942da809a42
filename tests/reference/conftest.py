"""The path tracer, where it can run: Mitsuba is an optional extra, and on processors it needs the library LLVM."""

from __future__ import annotations

from pathlib import Path

import pytest

from brdf_suite.documents.view import View
from brdf_suite.errors import ExtraError, ReferenceUnavailableError
from brdf_suite.pipeline.surface import load_shaped
from brdf_suite.reference.variant import Variant, start
from brdf_suite.surface.mesh import Mesh


@pytest.fixture(scope="module")
def variant() -> Variant:
    """The variant of Mitsuba that was started; without one the test is skipped, and says why.

    For each file anew: other files of the same process use Mitsuba in other variants.
    """
    try:
        return start()
    except (ExtraError, ReferenceUnavailableError) as error:
        pytest.skip(str(error))


@pytest.fixture(scope="session")
def sphere() -> Mesh:
    """The shipped sphere, as it is where a view says nothing of it."""
    return load_shaped("sphere", View().surface_look)


@pytest.fixture(autouse=True)
def own_cache(cache_folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """One cache for the session: each light is prefiltered once, and never into the user's cache."""
    monkeypatch.setenv("BRDF_SUITE_CACHE", str(cache_folder))
