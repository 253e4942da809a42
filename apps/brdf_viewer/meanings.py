"""Names and meanings of the numbers of views and studios: the core states them, the window shows them translated."""

from __future__ import annotations

from brdf_qt.program.translation import mark

MARKED = (
    mark("Above the horizontal plane"),
    mark("About the direction in which the lamp shines"),
    mark("Albedo"),
    mark("Around the y axis, 0 on +z"),
    mark("Each step doubles the light"),
    mark("Factor on all lengths of the mesh"),
    mark("Largest distance of a triangle from the CAD surface that it stands for"),
    mark("Factor on the environment's light; 0: the lamps alone"),
    mark("Factor on the light of single flakes; 1: as density and size say"),
    mark("Factor on the normal map's slopes"),
    mark("Haze: 2 very clear, 3 clear, 6 hazy"),
    mark("How often a second a blink changes over"),
    mark(
        "Illuminance over π, in the units of the environment: a white surface that faces the lamp, at 1 m from a "
        "point lamp, gets this radiance"
    ),
    mark("Across the disc of a directional lamp, the sun's is 0.53; 0: sharp shadows"),
    mark("By which the object turns while the shutter is open"),
    mark("Focal length over diameter of the lens's opening; 0: all is sharp"),
    mark("From the camera to the plane that is sharp"),
    mark("Of a point lamp, a ball; 0: a point, whose shadows are sharp"),
    mark("Of the lamp's light, on the locus of daylight"),
    mark("Of the middle of the scene"),
    mark("Of the room, from wall to wall"),
    mark("Of the sun above the horizon"),
    mark("Of the sun, from +z towards +x"),
    mark("On a 36 mm sensor"),
    mark("Root mean square slope of the coat's waviness"),
    mark("Share of the light that is given back"),
    mark("Share of the light that the ground gives back"),
    mark("Share of the width that shows the first"),
    mark("Size"),
    mark("Softness"),
    mark("Speed of the turntable, counter-clockwise seen from above"),
    mark("The brightest lights of the environment, in which flakes glint"),
    mark("The colour difference at the end of the colour scale"),
    mark("Turns the light counter-clockwise, seen from above"),
    mark("Typical distance from crest to crest of the orange peel"),
    mark("What one tile of the map covers"),
    mark("What one tile of the mask covers"),
)
"""Collected for the translation alone: the parts of the window pass what the core states to ``tr``."""
