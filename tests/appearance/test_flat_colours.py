"""Flat colours on the screen: every model against colour-science or a value worked out by hand."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import display_to_lab
from brdf_suite.appearance.colour.flat_colours import (
    display_notes,
    flat_labs,
    lab_to_hex,
    reference_white,
    to_paint,
)
from brdf_suite.appearance.colour.spectra import white_xyz
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import solid_paint

RED = display_to_lab((1.0, 0.0, 0.0))


@pytest.mark.parametrize(
    "colour",
    [
        FlatColour("", "RGB", (1.0, 0.0, 0.0)),
        FlatColour("", "RGB", (1.0, 0.0, 0.0), "sRGB IEC61966-2.1"),
        FlatColour("", "RGB", (0.9175, 0.2003, 0.1386), "Display P3"),
        FlatColour("", "RGB", (0.8586, 0.0, 0.0), "Adobe RGB (1998)"),
        FlatColour("", "HSB", (0.0, 1.0, 1.0)),
        FlatColour("", "HSL", (360.0, 1.0, 0.5)),
        FlatColour("", "CMY", (0.0, 1.0, 1.0)),
        FlatColour("", "CMYK", (0.0, 1.0, 1.0, 0.0)),
        FlatColour("", "XYZ", (41.24, 21.26, 1.93), "", "D65", 2),
        FlatColour("", "Lab", tuple(RED.tolist()), "", "D65", 10),
    ],
)
def test_red_is_red_in_every_model(colour: FlatColour) -> None:
    assert np.linalg.norm(flat_labs([colour])[0] - RED) < 0.6


def test_hue_goes_round_as_in_colorsys() -> None:
    import colorsys

    for hue in range(0, 360, 17):
        own = flat_labs(
            [FlatColour("", "HSB", (float(hue), 0.6, 0.8)), FlatColour("", "HSL", (float(hue), 0.6, 0.3))]
        )
        for found, rgb in zip(
            own,
            (colorsys.hsv_to_rgb(hue / 360, 0.6, 0.8), colorsys.hls_to_rgb(hue / 360, 0.3, 0.6)),
            strict=True,
        ):
            assert found == pytest.approx(display_to_lab(rgb), abs=1e-9)


def test_greys_and_whites_stay_grey_under_any_light() -> None:
    for light in ("A", "D50", "D65", "F11", ""):
        for observer in (2, 10):
            lab = FlatColour("", "Lab", (60.0, 0.0, 0.0), "", light, observer)
            # The tables' whites have five digits, so D65 of 2° is not quite the working space's.
            assert flat_labs([lab])[0] == pytest.approx([60.0, 0.0, 0.0], abs=0.02)
    assert reference_white(FlatColour("", "XYZ", (1.0, 1.0, 1.0), "", "D65", 10)) == pytest.approx(
        white_xyz(), abs=0.01
    )
    assert lab_to_hex(flat_labs([FlatColour("", "Gray", (0.2,))])[0]) == "#333333"


def test_many_colours_of_mixed_models_keep_their_places() -> None:
    one = FlatColour("", "RGB", (0.1, 0.5, 0.9))
    two = FlatColour("", "spectrum", (0.5,) * 31, wavelengths_nm=tuple(400.0 + 10.0 * i for i in range(31)))
    labs = flat_labs([one, two, one])
    assert labs[0] == pytest.approx(labs[2])
    assert labs[1] == pytest.approx([76.07, 0.0, 0.0], abs=0.01)
    assert flat_labs([]).shape == (0, 3)


def test_a_flat_colour_is_a_solid_paint() -> None:
    paint = to_paint(FlatColour("", "RGB", (60.0, 0.0, 0.0)))
    assert paint.name == "unnamed"
    assert paint.lab_at(15.0) == paint.lab_at(110.0)
    assert paint.lab_at(15.0)[0] == 250.0  # far beyond what a paint can be
    own = solid_paint("w", (95.0, 0.0, 1.0))
    assert to_paint(own) is own


def test_what_is_shown_roughly_is_said() -> None:
    colours = [
        FlatColour("", "CMYK", (0.0, 0.0, 0.0, 1.0)),
        FlatColour("", "CMYK", (0.0, 0.0, 0.0, 0.5)),
        FlatColour("", "Gray", (0.5,)),
        FlatColour("", "RGB", (0.5, 0.5, 0.5), "Apple RGB"),
        FlatColour("", "RGB", (0.5, 0.5, 0.5)),
    ]
    notes = display_notes(colours)
    assert len(notes) == 3
    assert "2 CMYK colours are shown without a profile" in notes[0]
    assert "Apple RGB" in notes[2]
