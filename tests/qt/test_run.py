"""Arguments of the programs."""

from __future__ import annotations

import argparse

import pytest
from brdf_qt.program.run import window_size


def test_a_size_is_width_by_height():
    assert window_size("1280x800") == (1280, 800)


@pytest.mark.parametrize("text", ["", "3x", "x3", "0x10", "10x99999", "10,20", "1e3x5", "-3x4"])
def test_anything_else_is_refused(text):
    with pytest.raises(argparse.ArgumentTypeError, match="WIDTHxHEIGHT"):
        window_size(text)
