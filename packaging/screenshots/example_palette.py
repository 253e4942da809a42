"""Make the palette that the documents show: 200 paints in two groups, from those that come with the suite.

Run ``.venv/bin/python packaging/screenshots/example_palette.py FILE.brdfpalette``. Every paint is a shipped one, or
a variation of one as Designer offers them (lighter, darker, turned in hue, with more or less flop): made up, as its
notes say.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

from brdf_suite.documents.paint import Paint
from brdf_suite.documents.palette import Entry, Group, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.documents.store import PAINT_ENDING, load_paint
from brdf_suite.paint_design.variations import variations
from brdf_suite.palettes.columns import Columns
from brdf_suite.resources import resource, resource_names

COUNT = 200
METALLIC_FLOP = 5.0
DATE = "2024-05-31"
_HUES = {
    45.0: "red", 75.0: "orange", 110.0: "yellow", 180.0: "green", 225.0: "teal", 292.0: "blue", 335.0: "violet",
    360.0: "magenta",
}  # fmt: skip
"""The hue h_ab, degrees, up to which each word is used."""


def made() -> list[Paint]:
    """Return the paints: the shipped ones, then a variation of each by turns until there are enough."""
    shipped = [
        load_paint(resource("paints", name + PAINT_ENDING)) for name in resource_names("paints", PAINT_ENDING)
    ]
    found = list(shipped)
    step = 0
    while len(found) < COUNT:
        for paint in shipped:
            possible = [one for one in variations(paint, 5.0 + 2.0 * (step // 8)) if one.paint is not None]
            if step % 8 < len(possible) and len(found) < COUNT:
                one = possible[step % 8]
                found.append(
                    replace(one.paint, name=f"{paint.name}, {one.word}", notes="A made-up variation.")
                )
        step += 1
    return found


def hue_word(lab: np.ndarray) -> str:
    """Return a word for a hue, or for a grey by its lightness."""
    if np.hypot(lab[1], lab[2]) < 8.0:
        return "white" if lab[0] > 75.0 else "black" if lab[0] < 20.0 else "grey"
    hue = float(np.degrees(np.arctan2(lab[2], lab[1])) % 360.0)
    return next(word for end, word in _HUES.items() if hue <= end)


def palette() -> Palette:
    """Return the palette: solid paints in one group and metallic ones in the other."""
    entries = tuple(Entry(paint, id=f"e{number:03d}") for number, paint in enumerate(made()))
    columns = Columns.of(entries)
    grouped = []
    for number, entry in enumerate(entries):
        metallic = columns.flop[number] >= METALLIC_FLOP
        tags = (hue_word(columns.main[number, 1]), *(("matte",) if columns.gloss[number] < 40.0 else ()))
        group = ("Metallic",) if metallic else ("Solid and pearl",)
        grouped.append(replace(entry, group=group, code=f"M{number:03d}", tags=tags, date=DATE))
    groups = (Group(("Metallic",), colour="#8090a0"), Group(("Solid and pearl",), colour="#d0a060"))
    return Palette(
        "Two hundred paints",
        tuple(grouped),
        groups,
        notes="Made by packaging/screenshots/example_palette.py.",
    )


if __name__ == "__main__":
    save_palette(palette(), Path(sys.argv[1]))
