"""Ground and occlusion on the command line."""

from __future__ import annotations

import argparse

import pytest

from brdf_suite.cli.picture.scene_options import add_scene, parse_view


@pytest.mark.parametrize(
    ("words", "ground", "occlusion"),
    [
        ([], True, True),
        (["--ground"], True, True),
        (["--ground", "--no-occlusion"], True, False),
        (["--no-ground", "--occlusion"], False, True),
    ],
)
def test_ground_and_occlusion(words: list[str], ground: bool, occlusion: bool) -> None:
    parser = argparse.ArgumentParser()
    add_scene(parser)
    look = parse_view(parser.parse_args(words)).surface_look
    assert (look.ground, look.occlusion) == (ground, occlusion)
