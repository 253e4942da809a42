"""A light that is edited: a draft that says so, near the whole, and nothing of it in the cache."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from brdf_suite.documents.studio import Backdrop, Sky, Studio, StudioLamp
from brdf_suite.pipeline.environments import DRAFT_ROWS
from brdf_suite.pipeline.scene import PreparedEnvironment, prepare_light

STUDIO = Studio(
    "two",
    (StudioLamp("box", (0.0, 3.0, 1.0), (2.0, 2.0)), StudioLamp("ring", (3.0, 1.0, 1.0), (1.0, 0.2))),
    None,
    Backdrop(),
)


def test_a_draft_is_near_the_whole_and_says_what_it_is() -> None:
    partial: list[PreparedEnvironment] = []
    draft = prepare_light(STUDIO, partial=partial.append, draft=True)
    whole = prepare_light(STUDIO)
    assert not draft.is_final
    assert whole.is_final
    assert partial
    assert all(part.draft for part in partial)
    assert not any(part.is_final for part in partial)
    assert draft.environment.radiance.shape[0] == DRAFT_ROWS < whole.environment.radiance.shape[0]
    np.testing.assert_allclose(draft.environment.average(), whole.environment.average(), rtol=0.02)
    diffuse, sharp = draft.maps.diffuse.radiance(), whole.maps.diffuse.radiance()
    assert np.abs(diffuse - sharp).max() < 0.02 * sharp.max()
    cache = Path(os.environ["BRDF_SUITE_CACHE"])
    assert not cache.exists() or not any(cache.rglob("*.lobemaps"))


def test_a_sky_is_drafted_too() -> None:
    draft = prepare_light(Sky("s", "overcast"), draft=True)
    assert draft.environment.radiance.shape[0] == DRAFT_ROWS
    assert draft.name == "s"
