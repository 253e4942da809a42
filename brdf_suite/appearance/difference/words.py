"""Verbal descriptions of colour differences: lighter or darker, cleaner or dirtier, redder, yellower, greener, bluer.

Of a sample against a standard, ΔL*, ΔC*ab and ΔH*ab are brought to one scale by the weights of CIEDE2000 (S_L, S_C and
S_H), so that 1 is about one unit of ΔE00. A component is named where it is at least :data:`NAMED_FROM` and at least a
quarter of the largest one there; up to 1 it is "slightly", from 3 on "much".

The word of a hue is the axis of a*b* (red 0°, yellow 90°, green 180°, blue 270°) towards which it turns. A hue that
already stands within 22.5° of that axis cannot become more of it, and is named by the next one: a blue is greener or
redder. Where a colour of the two has a chroma below :data:`GREY_BELOW` a hue says nothing; then Δa* and Δb* are named.

Words and sentences are English, made of :data:`WORDS` and :data:`PATTERNS`; a program hands its translator in as
``say``.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

from brdf_suite.appearance.difference.formulas import weights_2000
from brdf_suite.appearance.difference.tolerance import difference_parts

NAMED_FROM = 0.4
"""The smallest component that gets a word, in units of about one ΔE00."""
SLIGHT_BELOW, MUCH_FROM = 1.0, 3.0
GREY_BELOW = 5.0
FLOP_NAMED_FROM = 0.5
"""The smallest difference of flop indices that gets a word."""

_SHARE_NAMED = 0.25
_FAMILY_DEG = 22.5
_AXES = ("redder", "yellower", "greener", "bluer")

WORDS = ("lighter", "darker", "cleaner", "dirtier", *_AXES, "more flop", "less flop")
PATTERNS = (
    "slightly {word}",
    "much {word}",
    "{first} and {second}",
    "{first}, {second}",
    "{first}; {second}",
    "{words} at {angles}",
    "{words} at every angle",
    "no visible difference",
)

Degree = Literal["slightly", "", "much"]
Say = Callable[[str], str]
Lab = Sequence[float]


def in_english(text: str) -> str:
    """Return ``text`` itself: the ``say`` of callers without translation."""
    return text


@dataclass(frozen=True)
class NamedDifference:
    """One word for a difference; ``size`` in units of about one ΔE00."""

    word: str
    size: float

    @property
    def degree(self) -> Degree:
        """Return "slightly", "" or "much"."""
        if self.size < SLIGHT_BELOW:
            return "slightly"
        return "much" if self.size >= MUCH_FROM else ""

    def text(self, say: Say = in_english) -> str:
        """Return it as it is said, as in ``slightly darker``."""
        word = say(self.word)
        return say(f"{self.degree} {{word}}").format(word=word) if self.degree else word


def hue_word(hue_deg: float, turn: float) -> str:
    """Return the word for a hue (degrees, from +a* towards +b*) that turns by a little, positive or negative.

    >>> hue_word(285.0, -1.0), hue_word(300.0, -1.0), hue_word(300.0, 1.0), hue_word(60.0, 1.0)
    ('greener', 'bluer', 'redder', 'yellower')
    """
    hue = hue_deg % 360.0
    step = 1 if turn >= 0.0 else -1
    next_axis = math.floor(hue / 90.0) + 1 if step > 0 else math.ceil(hue / 90.0) - 1
    if abs(next_axis * 90.0 - hue) <= _FAMILY_DEG:
        next_axis += step
    return _AXES[next_axis % 4]


def name_differences(
    standard: Lab, sample: Lab, weights: Sequence[float] | None = None
) -> tuple[NamedDifference, ...]:
    """Return the words for a sample's L*a*b* (3,) against the standard's, the largest first; empty where none is.

    ``weights`` are S_L, S_C and S_H of the two (:func:`~brdf_suite.appearance.difference.formulas.weights_2000`),
    for callers that works them out for many pairs at once.

    >>> [named.text() for named in name_differences((25.0, 4.0, -38.0), (22.0, 4.0, -38.0))]
    ['darker']
    """
    lightness, chroma, hue = difference_parts(standard, sample)
    s_l, s_c, s_h = weights_2000(standard, sample).tolist() if weights is None else weights
    c1, c2 = math.hypot(standard[1], standard[2]), math.hypot(sample[1], sample[2])
    found = [NamedDifference("lighter" if lightness > 0.0 else "darker", abs(lightness) / s_l)]
    if min(c1, c2) < GREY_BELOW:
        delta_a, delta_b = float(sample[1]) - float(standard[1]), float(sample[2]) - float(standard[2])
        found.append(NamedDifference("redder" if delta_a > 0.0 else "greener", abs(delta_a) / s_c))
        found.append(NamedDifference("yellower" if delta_b > 0.0 else "bluer", abs(delta_b) / s_c))
    else:
        found.append(NamedDifference("cleaner" if chroma > 0.0 else "dirtier", abs(chroma) / s_c))
        place = math.degrees(math.atan2(standard[2], standard[1]))
        found.append(NamedDifference(hue_word(place, hue), abs(hue) / s_h))
    least = max(NAMED_FROM, _SHARE_NAMED * max(named.size for named in found))
    return tuple(sorted((named for named in found if named.size >= least), key=lambda named: -named.size))


def name_flop(standard: float, sample: float) -> NamedDifference | None:
    """Return "more flop" or "less flop" for two flop indices; ``None`` where they are alike or one is NaN."""
    change = sample - standard
    if not abs(change) >= FLOP_NAMED_FROM:
        return None
    # The degree of words for colours: a change of about 2 of the index is plain to see, of 6 much.
    return NamedDifference("more flop" if change > 0.0 else "less flop", abs(change) / 2.0)


def join_words(texts: Sequence[str], say: Say = in_english) -> str:
    """Return texts as a list in a sentence: ``a, b and c``; empty for none."""
    if len(texts) < 2:
        return "".join(texts)
    head = texts[0]
    for text in texts[1:-1]:
        head = say("{first}, {second}").format(first=head, second=text)
    return say("{first} and {second}").format(first=head, second=texts[-1])


def words_text(named: Sequence[NamedDifference], say: Say = in_english) -> str:
    """Return the words of one angle as they stand under a patch: ``darker and slightly bluer``."""
    if not named:
        return say("no visible difference")
    return join_words([one.text(say) for one in named], say)


def sentence(
    angles: Sequence[str],
    words: Sequence[tuple[NamedDifference, ...]],
    flop: NamedDifference | None = None,
    say: Say = in_english,
) -> str:
    """Return all angles in one line: ``lighter at 15° and 25°; darker and bluer at 110°; more flop``.

    Parameters
    ----------
    angles
        What each angle is called, as in ``15°``.
    words
        Per angle its words, as :func:`name_differences` gives them; angles without any are left out.

    >>> sentence(["15°", "110°"], [(), name_differences((25.0, 4.0, -38.0), (22.0, 4.0, -38.0))])
    'darker at 110°'
    """
    groups: dict[tuple[tuple[str, str], ...], list[int]] = {}
    for index, named in enumerate(words):
        if named:
            groups.setdefault(tuple((one.degree, one.word) for one in named), []).append(index)
    clauses: list[str] = []
    for members in groups.values():
        text = words_text(words[members[0]], say)
        if len(members) == len(angles) > 1:
            clauses.append(say("{words} at every angle").format(words=text))
        else:
            named_angles = join_words([angles[index] for index in members], say)
            clauses.append(say("{words} at {angles}").format(words=text, angles=named_angles))
    if flop is not None:
        clauses.append(flop.text(say))
    if not clauses:
        return say("no visible difference")
    line = clauses[0]
    for clause in clauses[1:]:
        line = say("{first}; {second}").format(first=line, second=clause)
    return line
