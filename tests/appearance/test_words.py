"""Differences in the trade's words."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.appearance.colour.spaces import lch_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.appearance.difference.words import (
    PATTERNS,
    WORDS,
    hue_word,
    join_words,
    name_differences,
    name_flop,
    sentence,
    words_text,
)

BLUE = (25.0, 4.0, -38.0)
OPPOSITE = {
    "lighter": "darker",
    "cleaner": "dirtier",
    "redder": "greener",
    "yellower": "bluer",
    "more flop": "less flop",
}
OPPOSITE |= {second: first for first, second in OPPOSITE.items()}


def said(standard, sample) -> str:
    return words_text(name_differences(standard, sample))


def test_lightness_and_its_degrees() -> None:
    assert said(BLUE, (24.2, 4.0, -38.0)) == "slightly darker"
    assert said(BLUE, (22.5, 4.0, -38.0)) == "darker"
    assert said(BLUE, (32.0, 4.0, -38.0)) == "much lighter"
    assert said(BLUE, BLUE) == "no visible difference"


def test_chroma_is_clean_or_dirty() -> None:
    assert said((50.0, 30.0, 30.0), (50.0, 38.0, 38.0)) == "much cleaner"
    assert said((50.0, 30.0, 30.0), (50.0, 26.0, 26.0)) == "dirtier"


@pytest.mark.parametrize(
    ("hue", "more", "less"),
    [
        # In each half quadrant the turn towards a hue and the turn away; at an axis itself its two neighbours.
        (0.0, "yellower", "bluer"),
        (45.0, "yellower", "redder"),
        (80.0, "greener", "redder"),
        (90.0, "greener", "redder"),
        (135.0, "greener", "yellower"),
        (180.0, "bluer", "yellower"),
        (225.0, "bluer", "greener"),
        (270.0, "redder", "greener"),
        (285.0, "redder", "greener"),
        (315.0, "redder", "bluer"),
        (350.0, "yellower", "bluer"),
    ],
)
def test_hue_words_by_place(hue: float, more: str, less: str) -> None:
    assert (hue_word(hue, 1.0), hue_word(hue, -1.0)) == (more, less)
    standard = tuple(lch_to_lab([50.0, 40.0, hue]).tolist())
    turned = tuple(lch_to_lab([50.0, 40.0, hue + 6.0]).tolist())
    assert more in said(standard, turned).split()


def test_a_grey_is_named_by_a_and_b() -> None:
    assert said((60.0, 0.0, 0.0), (60.0, 0.0, -2.0)) == "bluer"
    assert said((60.0, 0.2, 0.1), (60.0, -2.0, 0.1)) == "greener"


def test_a_small_part_beside_a_large_one_is_not_named() -> None:
    assert said(BLUE, (13.0, 4.0, -39.5)) == "much darker"


def test_angles_with_the_same_words_are_reported_together() -> None:
    darker = name_differences(BLUE, (22.5, 4.0, -38.0))
    lighter = name_differences(BLUE, (28.0, 4.0, -38.0))
    angles = ["15°", "25°", "45°", "110°"]
    assert sentence(angles, [lighter, lighter, (), darker]) == "lighter at 15° and 25°; darker at 110°"
    assert sentence(angles, [darker] * 4) == "darker at every angle"
    assert sentence(angles, [lighter, lighter, lighter, ()]) == "lighter at 15°, 25° and 45°"
    assert sentence(angles, [()] * 4) == "no visible difference"
    flop = name_flop(14.0, 17.0)
    assert sentence(angles, [(), (), (), darker], flop) == "darker at 110°; more flop"
    assert sentence(["15°"], [darker]) == "darker at 15°"


def test_flop_words() -> None:
    assert name_flop(14.0, 14.3) is None
    assert name_flop(math.nan, 14.3) is None
    assert name_flop(14.0, 13.0).text() == "slightly less flop"


def test_every_text_goes_through_the_translator() -> None:
    """Marked texts only: a program that translates all of WORDS and PATTERNS leaves no English behind."""
    heard: set[str] = set()

    def say(text: str) -> str:
        heard.add(text)
        return text

    angles = ["15°", "45°", "110°"]
    many = [
        name_differences(BLUE, (36.0, 8.0, -30.0)),
        name_differences((60.0, 0.0, 0.0), (59.0, -1.0, 0.0)),
        name_differences(BLUE, (22.0, 4.0, -38.0)),
    ]
    sentence(angles, many, name_flop(10.0, 20.0), say)
    sentence(angles, [many[2]] * 3, None, say)
    sentence(angles, [()] * 3, None, say)
    join_words(["a", "b", "c"], say)
    assert heard <= set(WORDS) | set(PATTERNS)
    assert set(PATTERNS) <= heard


labs = st.tuples(st.floats(5.0, 120.0), st.floats(-60.0, 60.0), st.floats(-60.0, 60.0))


@given(labs, labs)
def test_swapped_colours_swap_the_words_of_lightness_and_chroma(first: tuple, second: tuple) -> None:
    there = [one.word for one in name_differences(first, second)]
    back = [one.word for one in name_differences(second, first)]
    for word in ("lighter", "darker", "cleaner", "dirtier"):
        assert (word in there) == (OPPOSITE[word] in back)


@given(labs, st.tuples(*[st.floats(-8.0, 8.0)] * 3))
def test_what_cannot_be_seen_is_not_named_and_what_can_is(lab: tuple, change: tuple) -> None:
    other = tuple(a + b for a, b in zip(lab, change, strict=True))
    named = name_differences(lab, other)
    # Three components, each below the threshold; the rotation term of blue may add a little.
    if not named:
        assert float(delta_e_2000(lab, other)) < 1.0
    assert len({one.word for one in named}) == len(named) <= 3
    assert sorted((one.size for one in named), reverse=True) == [one.size for one in named]
