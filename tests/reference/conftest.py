"""The path tracer, where it can run: Mitsuba is an optional extra, and on processors it needs the library LLVM."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from brdf_suite.documents.view import View
from brdf_suite.errors import ExtraError, ReferenceUnavailableError
from brdf_suite.files.images.environments import write_exr
from brdf_suite.lighting.latlong import column_angles, direction, ring_angles
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


@pytest.fixture(scope="session")
def small_light(tmp_path_factory: pytest.TempPathFactory) -> str:
    """A file of a broad warm light in a dim sky, of 32 × 16 texels: read in no time."""
    d = direction(ring_angles(16)[:, None], column_angles(32)[None])
    lobe = np.exp(6.0 * (d @ np.array([0.6, 0.6, 0.529]) - 1.0))[..., None]
    path = tmp_path_factory.mktemp("light") / "small.exr"
    write_exr(path, np.asarray(0.3 + lobe * np.array([6.0, 5.0, 4.0]), np.float32))
    return str(path)


@pytest.fixture(autouse=True)
def own_cache(cache_folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """One cache for the session: each light is prefiltered once, and never into the user's cache."""
    monkeypatch.setenv("BRDF_SUITE_CACHE", str(cache_folder))
