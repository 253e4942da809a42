"""L*a*b* (D65, 10° observer) of flat colours in any colour model.

RGB without a named space counts as sRGB. CMY, CMYK and Gray have no meaning without the profile of a press; they are
shown by the plain rule of PostScript, R = (1 - C)(1 - K) in sRGB, which no printing ink follows: for the screen only.
Where such a colour has L*a*b*, XYZ or a spectrum beside its own numbers, it looks as these say.
Lab, LCh and XYZ of another white are adapted to D65: those of D50 and 2° by Bradford, because colour profiles and CSS
are made with it and a colour must be here what it is there; all others by CAT16, as everywhere in this suite. Without a
named white they count as D50 and 2°, as layout programs have them. A spectrum gives its colour exactly.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import (
    REC709_PRIMARIES,
    REC2020_PRIMARIES,
    WHITE_XY,
    WORKING_TO_XYZ,
    AdaptationTransform,
    adaptation,
    lab_to_working,
    lab_to_xyz,
    primaries_to_xyz,
    rgb_to_working,
    srgb_decode,
    working_to_display,
    working_to_lab,
)
from brdf_suite.appearance.colour.spaces import P3_PRIMARIES, adapt_xyz, lch_to_lab, xyz_to_working
from brdf_suite.appearance.colour.spectra import spectrum_to_lab
from brdf_suite.arrays import Floats
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.factored import FactoredPaint
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import PARAMETERS, Lab, Paint, solid_paint

ADOBE_RGB_PRIMARIES = ((0.64, 0.33), (0.21, 0.71), (0.15, 0.06))
"""Chromaticities of Adobe RGB (1998), with the white of D65 and a power of 563/256."""
_PROPHOTO_PRIMARIES = ((0.734699, 0.265301), (0.159597, 0.840403), (0.036598, 0.000105))
_PROPHOTO_POWER = 1.8
_GENERIC_PRIMARIES = ((0.625, 0.340), (0.280, 0.595), (0.155, 0.070))
"""Of Apple's "Generic RGB", the RGB of its older files, with the white of D65 and a power of 1.8."""
_D50_XY = (0.345704, 0.358540)

WHITES: dict[tuple[str, int], tuple[float, float, float]] = {
    ("A", 2): (109.850, 100.0, 35.585),
    ("A", 10): (111.144, 100.0, 35.200),
    ("C", 2): (98.074, 100.0, 118.232),
    ("C", 10): (97.285, 100.0, 116.145),
    ("D50", 2): (96.422, 100.0, 82.521),
    ("D50", 10): (96.720, 100.0, 81.427),
    ("D55", 2): (95.682, 100.0, 92.149),
    ("D55", 10): (95.799, 100.0, 90.926),
    ("D65", 2): (95.047, 100.0, 108.883),
    ("D65", 10): (94.811, 100.0, 107.304),
    ("D75", 2): (94.972, 100.0, 122.638),
    ("D75", 10): (94.416, 100.0, 120.641),
    ("E", 2): (100.0, 100.0, 100.0),
    ("E", 10): (100.0, 100.0, 100.0),
    ("F2", 2): (99.186, 100.0, 67.393),
    ("F2", 10): (103.279, 100.0, 69.027),
    ("F7", 2): (95.041, 100.0, 108.747),
    ("F7", 10): (95.792, 100.0, 107.686),
    ("F11", 2): (100.962, 100.0, 64.350),
    ("F11", 10): (103.863, 100.0, 65.607),
}
"""XYZ of the whites that colour files name (ASTM E308)."""

_PROFILE_WORDS = {"CMYK": "CMYK", "CMY": "CMY", "Gray": "grey"}


def flat_labs(colours: Sequence[FlatColour]) -> Floats:
    """Return L*a*b* (n, 3), D65 and 10°, of flat colours; many of one model are as quick as one."""
    found = np.zeros((len(colours), 3))
    alike: dict[tuple[object, ...], list[int]] = {}
    seen = [measured_look(colour) or colour for colour in colours]
    for index, colour in enumerate(seen):
        key = (colour.model, colour.space, colour.illuminant, colour.observer_deg, colour.wavelengths_nm)
        alike.setdefault(key, []).append(index)
    for indices in alike.values():
        values = np.array([seen[index].values for index in indices], float)
        found[indices] = _labs(seen[indices[0]], values)
    return found


def measured_look(colour: FlatColour) -> FlatColour | None:
    """Return the further numbers that say how a colour of inks or grey looks; None where it has none, or needs none."""
    if colour.model not in _PROFILE_WORDS:
        return None
    return next((other for other in colour.others if other.model in ("Lab", "LCh", "XYZ", "spectrum")), None)


def to_paint(
    content: Paint | CookTorrancePaint | FactoredPaint | FlatColour,
) -> Paint | CookTorrancePaint | FactoredPaint:
    """Return a palette entry's content as a paint: a flat colour becomes solid, the same at all angles.

    Numbers beyond a paint's range are brought to its edge: nothing that can be painted lies there.
    """
    if not isinstance(content, FlatColour):
        return content
    name = content.name[:200].strip() or "unnamed"
    return solid_paint(name, within_paint(flat_labs([content])[0]))


def within_paint(lab: npt.ArrayLike) -> Lab:
    """Return L*a*b* brought into the range of a paint's readings."""
    ranges = [PARAMETERS[f"lab[{i}]"] for i in range(3)]
    lightness, a, b = (
        min(max(float(value), part.low), part.high)
        for value, part in zip(np.asarray(lab, float), ranges, strict=True)
    )
    return lightness, a, b


def lab_to_hex(lab: npt.ArrayLike) -> str:
    """Return ``#rrggbb`` of L*a*b* (D65, 10°); what sRGB cannot show is clipped.

    >>> lab_to_hex((100.0, 0.0, 0.0))
    '#ffffff'
    """
    codes = np.rint(255.0 * np.clip(working_to_display(lab_to_working(lab)), 0.0, 1.0)).astype(int)
    return "#{:02x}{:02x}{:02x}".format(*codes)


def display_notes(colours: Sequence[FlatColour]) -> tuple[str, ...]:
    """Return what the user must know of how these colours are shown; a sentence for each matter."""
    notices = []
    for model, word in _PROFILE_WORDS.items():
        count = sum(colour.model == model and measured_look(colour) is None for colour in colours)
        if count:
            notices.append(
                f"{count} {word} colour{'s are' if count > 1 else ' is'} shown without a profile, so only roughly; "
                "the numbers are kept as they are."
            )
    unknown = {
        colour.space for colour in colours if colour.space and colour.model in ("RGB", "HSB", "HSL")
        and _space(colour.space) is None
    }  # fmt: skip
    if unknown:
        named = ", ".join(sorted(unknown)[:3])
        notices.append(f"The colour space {named[:120]} is not known here; its colours are shown as sRGB.")
    return tuple(notices)


def _labs(like: FlatColour, values: Floats) -> Floats:
    """Return L*a*b* of the numbers (n, k) of colours with this colour's model and white."""
    model = like.model
    if model == "spectrum":
        return spectrum_to_lab(values, np.array(like.wavelengths_nm))
    if model in ("Lab", "LCh", "XYZ"):
        white = reference_white(like)
        lab = lch_to_lab(values) if model == "LCh" else values
        if (like.illuminant, like.observer_deg) == ("D65", 10) and model != "XYZ":
            return lab
        xyz = values if model == "XYZ" else lab_to_xyz(lab, white)
        target = 100.0 * WORKING_TO_XYZ.sum(axis=1)
        named = (like.illuminant, like.observer_deg or 2)
        transform: AdaptationTransform = "CAT16" if named in WHITES and named != ("D50", 2) else "Bradford"
        return working_to_lab(xyz_to_working(adapt_xyz(xyz, white, target, transform)))
    encoded = _encoded_rgb(model, values)
    matrix, power = _known_space(like) or _srgb()
    has_line = power == _PROPHOTO_POWER and "prophoto" in like.space.lower().replace(" ", "")
    if power is None:
        return working_to_lab(srgb_decode(encoded) @ matrix.T)
    # A power, with ProPhoto RGB's line near black.
    size = np.abs(encoded)
    curved = np.where(has_line & (size < 16.0 / 512.0), size / 16.0, size**power)
    return working_to_lab(np.copysign(curved, encoded) @ matrix.T)


def reference_white(colour: FlatColour) -> Floats:
    """Return the white, XYZ, that a Lab, LCh or XYZ colour is of; D50 and 2° where nothing known is named."""
    key = (colour.illuminant, colour.observer_deg or 2)
    return np.array(WHITES.get(key, WHITES["D50", 2]))


def decode_rgb(colour: FlatColour) -> tuple[float, float, float] | None:
    """Return R, G, B of a colour whose own numbers are RGB or a rule of RGB (HSB, HSL, CMY, CMYK, Gray), else None.

    None also where further numbers say better how inks look.
    """
    if measured_look(colour) is not None or colour.model in ("Lab", "LCh", "XYZ", "spectrum"):
        return None
    red, green, blue = _encoded_rgb(colour.model, np.array([colour.values]))[0].tolist()
    return red, green, blue


def is_of_other_space(colour: FlatColour) -> bool:
    """Return whether a colour's RGB, HSB or HSL is of a space that is known here and is not sRGB."""
    known = _known_space(colour)
    return known is not None and known is not _srgb()


def _known_space(colour: FlatColour) -> tuple[Floats, float | None] | None:
    return _space(colour.space) if colour.model in ("RGB", "HSB", "HSL") else None


def _encoded_rgb(model: str, values: Floats) -> Floats:
    if model == "Gray":
        return np.repeat(values, 3, axis=1)
    if model == "CMY":
        return 1.0 - values
    if model == "CMYK":
        return (1.0 - values[:, :3]) * (1.0 - values[:, 3:])
    if model in ("HSB", "HSL"):
        return _from_hue(values, lightness=model == "HSL")
    return values


def _from_hue(values: Floats, *, lightness: bool) -> Floats:
    """Return RGB of hue in degrees, saturation, and brightness or lightness (Smith 1978)."""
    hue, saturation, level = values.T
    if lightness:
        spread = saturation * np.minimum(level, 1.0 - level)
        most = level + spread
        least = level - spread
    else:
        most = level
        least = level * (1.0 - saturation)
    # Each channel is full for a third of the circle, and falls to the least over a sixth at both sides.
    channels = []
    for centre in (0.0, 120.0, 240.0):
        away = np.abs((hue - centre + 180.0) % 360.0 - 180.0)
        channels.append(least + (most - least) * np.clip((120.0 - away) / 60.0, 0.0, 1.0))
    return np.stack(channels, axis=1)


@cache
def _srgb() -> tuple[Floats, float | None]:
    return rgb_to_working(REC709_PRIMARIES, WHITE_XY), None


@cache
def _space(name: str) -> tuple[Floats, float | None] | None:
    """Return the matrix to the working space and the power of a named RGB space (None: the sRGB curve)."""
    plain = "".join(character for character in name.lower() if character.isalnum())
    if not plain or "srgb" in plain:
        return _srgb()
    if "displayp3" in plain or plain == "p3":
        return rgb_to_working(P3_PRIMARIES, WHITE_XY), None
    if "adobergb" in plain or plain == "a98rgb":
        return rgb_to_working(ADOBE_RGB_PRIMARIES, WHITE_XY), 563.0 / 256.0
    if "prophoto" in plain:
        to_xyz = primaries_to_xyz(_PROPHOTO_PRIMARIES, _D50_XY)
        white = to_xyz.sum(axis=1)
        adapted = adaptation(white, WORKING_TO_XYZ.sum(axis=1), "Bradford") @ to_xyz
        return np.asarray(np.linalg.solve(WORKING_TO_XYZ, adapted), np.float64), _PROPHOTO_POWER
    if "genericrgb" in plain:
        return rgb_to_working(_GENERIC_PRIMARIES, WHITE_XY), _PROPHOTO_POWER
    if "rec2020" in plain or "bt2020" in plain:
        return rgb_to_working(REC2020_PRIMARIES, WHITE_XY), 2.4
    return None
