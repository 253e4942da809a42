"""Write the packaged paints.

Run with the folder to write to; without one they go to ``resources/paints`` of this checkout::

    python packaging/generate_paints.py [FOLDER]

No public table of L*a*b* with gloss of real paints was found. Each file says in ``source`` where its numbers
come from: the measured set was computed from published analytic fits of measured paints, whose gloss is not
known; the designed set was invented to be plausible.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path

from brdf_suite.documents.paint import Flakes, Gloss, Lab, Measurement, Paint
from brdf_suite.documents.store import PAINT_ENDING, save_paint

ILLUMINATION_DEG = 45.0
ASPECULAR_DEG = (15.0, 45.0, 110.0)

INVENTED = "Invented to be plausible; not a measurement of a real paint."
COMPUTED = (
    "Colours computed at 45° illumination from a published analytic fit of the paint that the MERL database "
    "calls {merl}; rounded to 0.1. Gloss and flakes are assumed."
)
GLOSS_ASSUMED = "The gloss of this paint is unknown; {gloss:g} GU at 20° is assumed, as of a usual clearcoat."


@dataclass(frozen=True)
class Recipe:
    """The numbers of one paint: file name without ending, name, L*a*b* at 15, 45 and 110°, G20, flakes."""

    file: str
    name: str
    labs: tuple[Lab, Lab, Lab]
    gu_20: float
    flakes: Flakes | None
    merl: str | None = None
    notes: str = ""

    def paint(self) -> Paint:
        """Return the paint document."""
        notes = GLOSS_ASSUMED.format(gloss=self.gu_20) if self.merl else self.notes
        return Paint(
            name=self.name,
            measurements=tuple(
                Measurement(ILLUMINATION_DEG, angle, lab)
                for angle, lab in zip(ASPECULAR_DEG, self.labs, strict=True)
            ),
            gloss=Gloss(self.gu_20),
            flakes=self.flakes,
            notes=notes,
            source=COMPUTED.format(merl=self.merl) if self.merl else INVENTED,
        )


def _solid(lab: Lab) -> tuple[Lab, Lab, Lab]:
    return (lab, lab, lab)


# The flakes' roughness is the spread of tilts that the flake rule finds in the colours (middle channel).
# Their density, size and colour spread are invented: coarser for silvers and finer for pearls.
DESIGNED = (
    Recipe(
        "fine_silver",
        "Fine silver",
        ((128.0, -1.0, 0.5), (62.0, -0.8, -0.5), (36.0, -0.5, -2.0)),
        90.0,
        Flakes(180.0, 14.0, 0.16, 0.0),
    ),
    Recipe(
        "champagne",
        "Champagne",
        ((115.0, 3.0, 22.0), (60.0, 3.0, 15.0), (34.0, 2.5, 10.0)),
        90.0,
        Flakes(120.0, 20.0, 0.17, 0.02),
    ),
    Recipe(
        "dark_grey",
        "Dark grey",
        ((78.0, -0.5, -1.0), (28.0, -0.3, -2.0), (12.0, 0.0, -2.5)),
        91.0,
        Flakes(90.0, 22.0, 0.15, 0.0),
    ),
    Recipe(
        "blue",
        "Blue",
        ((62.0, -4.0, -45.0), (25.0, 4.0, -38.0), (9.0, 8.0, -28.0)),
        90.0,
        Flakes(110.0, 20.0, 0.16, 0.03),
    ),
    Recipe(
        "red",
        "Red",
        ((58.0, 52.0, 32.0), (30.0, 44.0, 26.0), (16.0, 36.0, 20.0)),
        91.0,
        Flakes(100.0, 20.0, 0.17, 0.03),
    ),
    Recipe(
        "copper",
        "Copper",
        ((82.0, 38.0, 48.0), (45.0, 36.0, 42.0), (26.0, 30.0, 32.0)),
        89.0,
        Flakes(130.0, 24.0, 0.17, 0.03),
    ),
    Recipe(
        "white_pearl",
        "White pearl",
        ((104.0, -1.0, 4.0), (88.0, -1.0, 1.5), (84.0, -1.0, 2.0)),
        92.0,
        Flakes(220.0, 12.0, 0.18, 0.05),
    ),
    Recipe(
        "violet_shift",
        "Violet shift",
        ((66.0, -8.0, -42.0), (24.0, 22.0, -36.0), (9.0, 18.0, -8.0)),
        90.0,
        Flakes(140.0, 18.0, 0.15, 0.2),
    ),
    Recipe(
        "solid_white",
        "Solid white",
        _solid((95.0, -0.8, 1.6)),
        92.0,
        None,
        notes="No flakes: the same colour at every angle.",
    ),
    Recipe(
        "solid_black",
        "Solid black",
        _solid((2.5, 0.0, -0.4)),
        90.0,
        None,
        notes="No flakes: the same colour at every angle.",
    ),
    Recipe(
        "satin_graphite",
        "Satin graphite",
        ((74.0, -0.3, -0.8), (34.0, -0.2, -1.6), (19.0, 0.0, -2.2)),
        25.0,
        Flakes(90.0, 22.0, 0.17, 0.0),
        notes="A satin clearcoat: its wide lobe is taken out of the colour readings.",
    ),
)

MEASURED = (
    Recipe(
        "silver_metallic",
        "Silver metallic",
        ((108.6, 0.3, 1.5), (40.9, 0.4, 0.3), (8.7, 1.2, -2.1)),
        89.0,
        Flakes(150.0, 20.0, 0.15, 0.0),
        merl="silver-metallic-paint",
    ),
    Recipe(
        "silver_metallic_2",
        "Silver metallic 2",
        ((101.9, 1.6, 6.4), (53.1, 0.1, 1.7), (33.4, -1.2, -1.9)),
        88.0,
        Flakes(150.0, 18.0, 0.17, 0.0),
        merl="silver-metallic-paint2",
    ),
    Recipe(
        "blue_metallic",
        "Blue metallic",
        ((61.8, 16.7, -34.0), (22.3, 9.7, -18.1), (4.6, 7.8, -12.5)),
        89.0,
        Flakes(110.0, 20.0, 0.155, 0.02),
        merl="blue-metallic-paint",
    ),
    Recipe(
        "gold_metallic",
        "Gold metallic",
        ((87.8, 4.1, 44.0), (37.8, 2.1, 23.5), (13.6, 1.2, 14.5)),
        89.0,
        Flakes(120.0, 22.0, 0.16, 0.02),
        merl="gold-metallic-paint",
    ),
    Recipe(
        "gold_metallic_3",
        "Gold metallic 3",
        ((75.2, 2.7, 24.7), (26.9, 1.3, 11.6), (9.9, 0.8, 6.7)),
        89.0,
        Flakes(120.0, 20.0, 0.15, 0.02),
        merl="gold-metallic-paint3",
    ),
    Recipe(
        "green_metallic",
        "Green metallic",
        ((68.2, -13.2, -7.5), (26.0, -10.2, -7.1), (17.0, -11.5, -8.5)),
        88.0,
        Flakes(110.0, 20.0, 0.145, 0.02),
        merl="green-metallic-paint",
    ),
    Recipe(
        "red_metallic",
        "Red metallic",
        ((43.4, 34.2, 25.3), (10.8, 15.4, 10.4), (2.3, 4.4, 2.2)),
        90.0,
        Flakes(100.0, 20.0, 0.145, 0.02),
        merl="red-metallic-paint",
    ),
    Recipe(
        "pearl",
        "Pearl",
        ((84.5, 0.7, 15.5), (54.9, 0.7, 8.0), (48.1, 0.7, 5.8)),
        88.0,
        Flakes(200.0, 14.0, 0.16, 0.05),
        merl="pearl-paint",
    ),
)

RECIPES = DESIGNED + MEASURED


def generate(destination: Path) -> list[Path]:
    """Write every paint into ``destination`` (made where it is missing) and return the paths."""
    destination.mkdir(parents=True, exist_ok=True)
    paths = []
    for recipe in RECIPES:
        path = destination / f"{recipe.file}{PAINT_ENDING}"
        save_paint(recipe.paint(), path)
        paths.append(path)
    return paths


def main() -> int:
    """Generate into the folder named on the command line."""
    default = Path(__file__).resolve().parent.parent / "resources" / "paints"
    for path in generate(Path(sys.argv[1]) if len(sys.argv) > 1 else default):
        print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main())
