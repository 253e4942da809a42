"""The light of a studio or a sky while it is edited: a draft at once, the whole of it when the hand rests."""

from __future__ import annotations

from dataclasses import replace

from brdf_suite.documents.light_store import LightDocument
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.filter.prefilter import prefilter
from brdf_suite.pipeline.environments import draw_light
from brdf_suite.pipeline.scene import Partial, PreparedEnvironment, prepare_environment
from brdf_suite.progress import Progress, subrange

_DRAWING_SHARE = 0.3


def prepare_light(
    light: LightDocument,
    progress: Progress | None = None,
    partial: Partial | None = None,
    *,
    draft: bool = False,
) -> PreparedEnvironment:
    """Draw and filter a light that is in no file yet, past the cache: its versions would drive out what is used.

    A draft never says that it is final; ``partial`` as for :func:`brdf_suite.pipeline.scene.load_environment`.
    """
    made = draw_light(light, subrange(progress, 0.0, _DRAWING_SHARE), draft=draft)

    def hand_out(value: PreparedEnvironment) -> None:
        if partial is not None:
            partial(replace(value, draft=draft))

    environment = Environment(light.name, made.radiance, (made.comment.rstrip("."),))
    prepared = prepare_environment(
        light.name, environment, prefilter, subrange(progress, _DRAWING_SHARE, 1.0), partial=hand_out
    )
    return replace(prepared, draft=draft)
