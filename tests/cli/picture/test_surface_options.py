"""Ground, occlusion, axes, unit and painted parts on the command line."""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.cli.picture.scene_options import add_scene, parse_view
from brdf_suite.documents.store import save_view
from brdf_suite.documents.view import View
from brdf_suite.errors import ValueRangeError
from brdf_suite.pipeline.surface import load_shaped


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


def view_of(*words: object) -> View:
    parser = argparse.ArgumentParser()
    add_scene(parser)
    return parse_view(parser.parse_args([str(word) for word in words]))


@pytest.fixture
def blocks(tmp_path: Path) -> Path:
    """Three triangles, and one more that is called glass."""
    lines = []
    for place, name in enumerate(("door_left", "door_right", "roof", "glass_front")):
        lines += [f"o {name}", f"v {place} 0 0", f"v {place + 1} 0 0", f"v {place} 1 0.5"]
        lines.append("f " + " ".join(str(3 * place + k) for k in (1, 2, 3)))
    path = tmp_path / "blocks.obj"
    path.write_text("\n".join(lines))
    return path


def test_unit_axis_and_fineness_of_a_mesh(blocks: Path) -> None:
    look = view_of("--mesh", blocks, "--unit", "mm", "--up", "z", "--tessellation", "0.5").surface_look
    assert (look.unit, look.up, look.tessellation_mm) == ("mm", "z", 0.5)
    low, high = load_shaped(str(blocks), look).bounds()
    np.testing.assert_allclose(high - low, [0.004, 0.0005, 0.001], atol=1e-8)


def test_another_mesh_than_the_views_own_is_taken_as_its_file_says(blocks: Path, tmp_path: Path) -> None:
    old = view_of("--mesh", blocks, "--up", "z", "--paint-parts", "roof")
    save_view(old, tmp_path / "old.brdfview")
    new = view_of("--view", tmp_path / "old.brdfview", "--mesh", "sphere").surface_look
    assert (new.up, new.unit, new.materials) == ("file", "file", ())
    assert view_of("--view", tmp_path / "old.brdfview").surface_look == old.surface_look


def test_the_paint_is_on_the_parts_that_are_named(blocks: Path) -> None:
    assert view_of("--mesh", blocks).surface_look.materials == ()
    chosen = view_of("--mesh", blocks, "--paint-parts", "DOOR*,glass_front").surface_look.chosen
    assert chosen == {
        "door_left": "paint",
        "door_right": "paint",
        "roof": "neutral",
        "glass_front": "paint",
    }
    with pytest.raises(
        ValueRangeError, match=r"'rof'; did you mean roof\?; there are door_left, door_right,"
    ):
        view_of("--mesh", blocks, "--paint-parts", "rof")
