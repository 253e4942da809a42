"""How flakes are drawn, from the command line."""

from __future__ import annotations

import argparse

import pytest

from brdf_suite.cli.picture.scene_options import add_scene, parse_view
from brdf_suite.documents.store import save_view
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Sparkle


def view(*arguments: str) -> View:
    parser = argparse.ArgumentParser()
    add_scene(parser)
    return parse_view(parser.parse_args(arguments))


@pytest.mark.parametrize("mode", ["off", "texture", "glints"])
def test_a_mode(mode) -> None:
    assert view("--sparkle", mode).sparkle.mode == mode


def test_the_rest_stays_as_the_view_has_it(tmp_path) -> None:
    save_view(View(sparkle=Sparkle("off", 3, 2.0)), tmp_path / "a.brdfview")
    assert view("--view", str(tmp_path / "a.brdfview")).sparkle == Sparkle("off", 3, 2.0)
    changed = view("--view", str(tmp_path / "a.brdfview"), "--sparkle", "texture")
    assert changed.sparkle == Sparkle("texture", 3, 2.0)


def test_another_word_is_refused(capsys) -> None:
    with pytest.raises(SystemExit):
        view("--sparkle", "glitter")
    assert "glints" in capsys.readouterr().err
