"""Material of a foreign mesh part, guessed from its names.

Everything is painted unless a name says otherwise: who opens a mesh here wants to see paint on it.
"""

from __future__ import annotations

import re

# In order: the first row with a word that a name begins a word with decides. Paint comes first, since
# "metallic paint" is no metal; trim before glass, since a window trim is no window.
_ROWS: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("paint", ("paint", "carpaint", "lacquer", "body", "bodywork", "coachwork")),
    ("trim", ("trim", "plastic", "bumper", "grille", "grill")),
    ("glass", ("glass", "window", "windscreen", "windshield")),
    ("rubber", ("rubber", "tire", "tyre", "wheel")),
    ("tail_lamp", ("taillight", "taillamp", "brakelight")),
    ("lamp", ("lamp", "headlamp", "headlight", "bulb")),
    ("chrome", ("chrome", "metal", "steel", "alumin", "rim")),
    ("neutral", ("calibration", "floor", "ground", "backdrop", "background", "pedestal", "plinth")),
)
_WHOLE_WORDS = frozenset({"rim", "rims", "body", "grill", "metal", "metals"})
_WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")


def material_word(material: str, part: str) -> str:
    """Return the material word for a part; the material's name counts before the part's own.

    >>> material_word("window_trim", "Body"), material_word("Material.001", "FrontTyre")
    ('trim', 'rubber')
    """
    for name in (material, part):
        words = [word.lower() for word in _WORD.findall(name)]
        for result, starts in _ROWS:
            if any(_fits(word, start) for word in words for start in starts):
                return result
    return "paint"


def _fits(word: str, start: str) -> bool:
    if start in _WHOLE_WORDS:
        return word in (start, start + "s")
    return word.startswith(start)
