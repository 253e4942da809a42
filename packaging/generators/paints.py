"""Write the packaged paints.

Run with the folder to write to; without one they go to ``resources/paints`` of this checkout::

    python packaging/generators/paints.py [FOLDER]

No public table of L*a*b* with gloss of real paints was found. Each file says in ``source`` where its numbers
come from: the measured set was computed from published analytic fits of measured paints, whose gloss is not
known; the designed set was invented to be plausible; the Cook-Torrance paints, in a folder of their own because
they have no readings to edit, are those of Table 1 of Günther et al. 2005, with the paper's own numbers.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path

from brdf_suite.documents.paint import Flakes, Gloss, Interpolation, Lab, Measurement, Paint
from brdf_suite.documents.store import PAINT_ENDING, save_paint
from brdf_suite.reflectance.models.table_1 import TABLE_1

ILLUMINATION_DEG = 45.0
ASPECULAR_DEG = (15.0, 45.0, 110.0)
#: The second light of interference paints, at the angles read under it (ASTM E2539 has both).
SECOND_ILLUMINATION_DEG = 15.0
SECOND_ASPECULAR_DEG = (15.0, 45.0)
COOK_TORRANCE_FOLDER = "cook_torrance"

INVENTED = "Invented to be plausible; not a measurement of a real paint."
COMPUTED = (
    "Colours computed at 45° illumination from a published analytic fit of the paint that the MERL database "
    "calls {merl}; rounded to 0.1. Gloss and flakes are assumed."
)
NO_FLAKES = "No flakes: the same colour at every angle."
ENAMEL = "Gloss as of a single-stage enamel without a clearcoat of its own."
SEMI_GLOSS = "Gloss as of a semi-gloss clearcoat."
GLOSS_ASSUMED = "The gloss of this paint is unknown; {gloss:g} GU at 20° is assumed, as of a usual clearcoat."


@dataclass(frozen=True)
class Recipe:
    """The numbers of one paint: file name without ending, name, L*a*b* at 15, 45 and 110°, G20, flakes.

    ``second`` is L*a*b* at 15 and 45° with the light at 15°, for paints whose colour turns with the light.
    """

    file: str
    name: str
    labs: tuple[Lab, Lab, Lab]
    gu_20: float
    flakes: Flakes | None
    merl: str | None = None
    notes: str = ""
    second: tuple[Lab, Lab] | None = None
    interpolation: Interpolation = "flake"

    def paint(self) -> Paint:
        """Return the paint document."""
        notes = GLOSS_ASSUMED.format(gloss=self.gu_20) if self.merl else self.notes
        lights: list[tuple[float, tuple[float, ...], tuple[Lab, ...]]] = [
            (ILLUMINATION_DEG, ASPECULAR_DEG, self.labs)
        ]
        if self.second is not None:
            lights.append((SECOND_ILLUMINATION_DEG, SECOND_ASPECULAR_DEG, self.second))
        return Paint(
            name=self.name,
            measurements=tuple(
                Measurement(light, angle, lab)
                for light, angles, labs in lights
                for angle, lab in zip(angles, labs, strict=True)
            ),
            gloss=Gloss(self.gu_20),
            flakes=self.flakes,
            interpolation=self.interpolation,
            notes=notes,
            source=COMPUTED.format(merl=self.merl) if self.merl else INVENTED,
        )


def _solid(lab: Lab) -> tuple[Lab, Lab, Lab]:
    return (lab, lab, lab)


# The flakes' roughness is the spread of tilts that the flake rule finds in the colours (middle channel).
# Their size and colour spread are invented: coarser for silvers and finer for pearls. As many lie side by side.
DESIGNED = (
    Recipe(
        "fine_silver",
        "Fine silver",
        ((128.0, -1.0, 0.5), (62.0, -0.8, -0.5), (36.0, -0.5, -2.0)),
        90.0,
        Flakes(6500.0, 14.0, 0.16, 0.0),
    ),
    Recipe(
        "champagne",
        "Champagne",
        ((115.0, 3.0, 22.0), (60.0, 3.0, 15.0), (34.0, 2.5, 10.0)),
        90.0,
        Flakes(3190.0, 20.0, 0.17, 0.02),
    ),
    Recipe(
        "dark_grey",
        "Dark grey",
        ((78.0, -0.5, -1.0), (28.0, -0.3, -2.0), (12.0, 0.0, -2.5)),
        91.0,
        Flakes(2640.0, 22.0, 0.15, 0.0),
    ),
    Recipe(
        "blue",
        "Blue",
        ((62.0, -4.0, -45.0), (25.0, 4.0, -38.0), (9.0, 8.0, -28.0)),
        90.0,
        Flakes(3190.0, 20.0, 0.16, 0.03),
    ),
    Recipe(
        "red",
        "Red",
        ((58.0, 52.0, 32.0), (30.0, 44.0, 26.0), (16.0, 36.0, 20.0)),
        91.0,
        Flakes(3190.0, 20.0, 0.17, 0.03),
    ),
    Recipe(
        "copper",
        "Copper",
        ((82.0, 38.0, 48.0), (45.0, 36.0, 42.0), (26.0, 30.0, 32.0)),
        89.0,
        Flakes(2220.0, 24.0, 0.17, 0.03),
    ),
    Recipe(
        "white_pearl",
        "White pearl",
        ((104.0, -1.0, 4.0), (88.0, -1.0, 1.5), (84.0, -1.0, 2.0)),
        92.0,
        Flakes(8850.0, 12.0, 0.18, 0.05),
    ),
    Recipe(
        "violet_shift",
        "Violet shift",
        ((66.0, -8.0, -42.0), (24.0, 22.0, -36.0), (9.0, 18.0, -8.0)),
        90.0,
        Flakes(3930.0, 18.0, 0.15, 0.2),
    ),
    Recipe("solid_white", "Solid white", _solid((95.0, -0.8, 1.6)), 92.0, None, notes=NO_FLAKES),
    Recipe("solid_black", "Solid black", _solid((2.5, 0.0, -0.4)), 90.0, None, notes=NO_FLAKES),
    Recipe(
        "satin_graphite",
        "Satin graphite",
        ((74.0, -0.3, -0.8), (34.0, -0.2, -1.6), (19.0, 0.0, -2.2)),
        25.0,
        Flakes(2640.0, 22.0, 0.17, 0.0),
        notes="A satin clearcoat: its wide lobe is taken out of the colour readings.",
    ),
)

SHIFT = "The colour turns with the light's angle too: read with the light at 45° and at 15°."
MATTE_SOLID = (
    "No flakes; the wide lobe of the clearcoat is in the readings and taken out of them. What is left has no flop, "
    "so no spread of flakes can be found in it and the monotone rule is used."
)

# More of the trade. The middle readings follow from the outer two by the flake rule with a spread of tilts from
# .15 to .18, as real paints have it; those of satin and matte paints hold the lobe of a Beckmann coat.
MORE = (
    Recipe(
        "coarse_silver",
        "Coarse silver",
        ((132.0, -0.6, 0.8), (55.7, -0.4, -0.2), (26.0, -0.4, -1.5)),
        90.0,
        Flakes(890.0, 38.0, 0.153, 0.0),
    ),
    Recipe(
        "gunmetal",
        "Gunmetal",
        ((88.0, -0.4, -0.5), (31.0, -0.2, -0.7), (9.0, 0.0, -2.0)),
        91.0,
        Flakes(1420.0, 30.0, 0.147, 0.0),
    ),
    Recipe(
        "ice_blue",
        "Ice blue",
        ((99.0, -7.0, -18.0), (57.5, -4.6, -16.2), (46.0, -4.0, -17.0)),
        90.0,
        Flakes(4980.0, 16.0, 0.162, 0.02),
    ),
    Recipe(
        "midnight_blue",
        "Midnight blue",
        ((42.0, 4.0, -34.0), (12.0, 4.0, -18.4), (4.0, 4.0, -14.0)),
        40.0,
        Flakes(2640.0, 22.0, 0.147, 0.03),
        notes=SEMI_GLOSS,
    ),
    Recipe(
        "racing_green",
        "Racing green",
        ((44.0, -24.0, 12.0), (14.9, -14.0, 6.7), (6.0, -9.0, 4.0)),
        80.0,
        Flakes(3190.0, 20.0, 0.152, 0.02),
        notes=ENAMEL,
    ),
    Recipe(
        "lime_green",
        "Lime green",
        ((92.0, -28.0, 60.0), (52.8, -19.8, 41.9), (40.0, -18.0, 38.0)),
        90.0,
        Flakes(3930.0, 18.0, 0.166, 0.03),
    ),
    Recipe(
        "emerald_pearl",
        "Emerald pearl",
        ((72.0, -38.0, 6.0), (32.6, -24.1, 3.1), (20.0, -22.0, 2.0)),
        91.0,
        Flakes(6500.0, 14.0, 0.156, 0.06),
    ),
    Recipe(
        "burnt_orange",
        "Burnt orange",
        ((76.0, 42.0, 64.0), (38.7, 30.6, 39.1), (24.0, 30.0, 30.0)),
        60.0,
        Flakes(2640.0, 22.0, 0.167, 0.03),
        notes=SEMI_GLOSS,
    ),
    Recipe(
        "candy_red",
        "Candy red",
        ((62.0, 66.0, 42.0), (26.3, 40.0, 24.3), (11.0, 34.0, 15.0)),
        92.0,
        Flakes(2220.0, 24.0, 0.161, 0.02),
    ),
    Recipe(
        "sand_beige",
        "Sand beige",
        ((104.0, 1.0, 14.0), (66.3, 1.2, 11.3), (52.0, 1.5, 11.0)),
        90.0,
        Flakes(4980.0, 16.0, 0.177, 0.02),
    ),
    Recipe(
        "silver_pearl",
        "Silver pearl",
        ((110.0, -1.5, -2.0), (77.8, -1.0, -2.3), (70.0, -0.8, -2.5)),
        91.0,
        Flakes(8850.0, 12.0, 0.166, 0.05),
    ),
    Recipe(
        "gold_green_shift",
        "Gold-green shift",
        ((88.0, -18.0, 44.0), (36.0, -4.7, 22.9), (12.0, 10.0, 14.0)),
        90.0,
        Flakes(3190.0, 20.0, 0.16, 0.2),
        notes=SHIFT,
        second=((96.0, 8.0, 52.0), (44.0, 8.0, 30.0)),
    ),
    Recipe(
        "teal_violet_shift",
        "Teal-violet shift",
        ((74.0, -30.0, -16.0), (27.5, -5.7, -14.6), (9.0, 16.0, -22.0)),
        90.0,
        Flakes(3930.0, 18.0, 0.155, 0.2),
        notes=SHIFT,
        second=((80.0, -12.0, -34.0), (33.0, 4.0, -26.0)),
    ),
    Recipe(
        "copper_red_shift",
        "Copper-red shift",
        ((84.0, 20.0, 52.0), (35.0, 22.0, 33.0), (12.0, 15.0, 12.0)),
        90.0,
        Flakes(3190.0, 20.0, 0.16, 0.2),
        notes=SHIFT,
        second=((89.0, 33.0, 40.0), (41.0, 34.0, 26.0)),
    ),
    Recipe(
        "magenta_gold_shift",
        "Magenta-gold shift",
        ((72.0, 44.0, -20.0), (28.0, 36.0, -23.0), (9.0, 21.0, -17.0)),
        90.0,
        Flakes(3930.0, 18.0, 0.155, 0.2),
        notes=SHIFT,
        second=((79.0, 38.0, 20.0), (34.0, 33.0, 6.0)),
    ),
    Recipe("solid_red", "Solid red", _solid((41.0, 60.0, 38.0)), 76.0, None, notes=ENAMEL),
    Recipe("solid_yellow", "Solid yellow", _solid((80.0, 10.0, 82.0)), 68.0, None, notes=ENAMEL),
    Recipe(
        "satin_blue",
        "Satin blue",
        ((60.0, -2.0, -44.0), (27.1, 1.4, -30.8), (12.0, 6.0, -30.0)),
        13.5,
        Flakes(3190.0, 20.0, 0.17, 0.03),
        notes="A satin clearcoat of Beckmann roughness .03.",
    ),
    Recipe(
        "satin_white",
        "Satin white",
        _solid((92.0, -0.5, 1.0)),
        18.7,
        None,
        None,
        MATTE_SOLID,
        None,
        "monotone",
    ),
    Recipe(
        "matte_grey",
        "Matte grey",
        ((83.5, 0.0, -0.8), (34.0, 0.0, -0.8), (20.0, 0.0, -1.0)),
        2.8,
        Flakes(2640.0, 22.0, 0.165, 0.0),
        notes="A matte clearcoat of Beckmann roughness .08: its lobe is a large part of the reading at 15°.",
    ),
    Recipe(
        "matte_white",
        "Matte white",
        ((99.2, -0.4, 1.7), (91.0, -0.5, 2.0), (91.0, -0.5, 2.0)),
        3.1,
        None,
        notes=MATTE_SOLID,
        interpolation="monotone",
    ),
)

MEASURED = (
    Recipe(
        "silver_metallic",
        "Silver metallic",
        ((108.6, 0.3, 1.5), (40.9, 0.4, 0.3), (8.7, 1.2, -2.1)),
        89.0,
        Flakes(3190.0, 20.0, 0.15, 0.0),
        merl="silver-metallic-paint",
    ),
    Recipe(
        "silver_metallic_2",
        "Silver metallic 2",
        ((101.9, 1.6, 6.4), (53.1, 0.1, 1.7), (33.4, -1.2, -1.9)),
        88.0,
        Flakes(3930.0, 18.0, 0.17, 0.0),
        merl="silver-metallic-paint2",
    ),
    Recipe(
        "blue_metallic",
        "Blue metallic",
        ((61.8, 16.7, -34.0), (22.3, 9.7, -18.1), (4.6, 7.8, -12.5)),
        89.0,
        Flakes(3190.0, 20.0, 0.155, 0.02),
        merl="blue-metallic-paint",
    ),
    Recipe(
        "gold_metallic",
        "Gold metallic",
        ((87.8, 4.1, 44.0), (37.8, 2.1, 23.5), (13.6, 1.2, 14.5)),
        89.0,
        Flakes(2640.0, 22.0, 0.16, 0.02),
        merl="gold-metallic-paint",
    ),
    Recipe(
        "gold_metallic_3",
        "Gold metallic 3",
        ((75.2, 2.7, 24.7), (26.9, 1.3, 11.6), (9.9, 0.8, 6.7)),
        89.0,
        Flakes(3190.0, 20.0, 0.15, 0.02),
        merl="gold-metallic-paint3",
    ),
    Recipe(
        "green_metallic",
        "Green metallic",
        ((68.2, -13.2, -7.5), (26.0, -10.2, -7.1), (17.0, -11.5, -8.5)),
        88.0,
        Flakes(3190.0, 20.0, 0.145, 0.02),
        merl="green-metallic-paint",
    ),
    Recipe(
        "red_metallic",
        "Red metallic",
        ((43.4, 34.2, 25.3), (10.8, 15.4, 10.4), (2.3, 4.4, 2.2)),
        90.0,
        Flakes(3190.0, 20.0, 0.145, 0.02),
        merl="red-metallic-paint",
    ),
    Recipe(
        "pearl",
        "Pearl",
        ((84.5, 0.7, 15.5), (54.9, 0.7, 8.0), (48.1, 0.7, 5.8)),
        88.0,
        Flakes(6500.0, 14.0, 0.16, 0.05),
        merl="pearl-paint",
    ),
)

RECIPES = DESIGNED + MORE + MEASURED


def generate(destination: Path) -> list[Path]:
    """Write every paint into ``destination`` (made where it is missing) and return the paths."""
    lobes = destination / COOK_TORRANCE_FOLDER
    lobes.mkdir(parents=True, exist_ok=True)
    paths = []
    for recipe in RECIPES:
        path = destination / f"{recipe.file}{PAINT_ENDING}"
        save_paint(recipe.paint(), path)
        paths.append(path)
    for name, paint in TABLE_1.items():
        path = lobes / f"{name}{PAINT_ENDING}"
        save_paint(paint, path)
        paths.append(path)
    return paths


def main() -> int:
    """Generate into the folder named on the command line."""
    default = Path(__file__).resolve().parents[2] / "resources" / "paints"
    for path in generate(Path(sys.argv[1]) if len(sys.argv) > 1 else default):
        print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main())
