"""A colour without angle dependence, in the colour model of its source file.

The numbers are kept as they are, in their own model; what they look like is computed elsewhere and never stored.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from types import MappingProxyType
from typing import Literal, get_args

from brdf_suite.documents.parameter import Parameter, as_whole, check_choice, check_text, describe
from brdf_suite.errors import ValueRangeError

Model = Literal["RGB", "CMYK", "CMY", "Gray", "HSB", "HSL", "Lab", "LCh", "XYZ", "spectrum"]
MODELS: tuple[str, ...] = get_args(Model)

LONGEST_NAME = 1000
"""Characters of the name of a flat colour; some palettes describe where a colour was seen."""

_MOST_BANDS = 2048
_MOST_OTHERS = 16


def _share(label: str, meaning: str) -> Parameter:
    # Scene-referred values pass 1, and differences go below 0.
    return Parameter(label, "", -64.0, 64.0, 0.5, meaning)


def _ink(label: str) -> Parameter:
    return Parameter(label, "", 0.0, 1.0, 0.0, "Share of the ink; 1 is full")


_HUE = Parameter("Hue", "°", 0.0, 360.0, 0.0, "Angle of the hue")
_SATURATION = Parameter("Saturation", "", 0.0, 1.0, 0.0, "0 is grey")
_LIGHTNESS = Parameter("L*", "", -1.0, 250.0, 50.0, "Lightness")

CHANNELS: Mapping[str, tuple[Parameter, ...]] = MappingProxyType(
    {
        "RGB": tuple(_share(name, "Encoded value; 1 is the most of a display") for name in ("R", "G", "B")),
        "CMYK": tuple(_ink(name) for name in ("C", "M", "Y", "K")),
        "CMY": tuple(_ink(name) for name in ("C", "M", "Y")),
        "Gray": (_share("Gray", "Encoded value; 0 is black, 1 is white"),),
        "HSB": (_HUE, _SATURATION, _share("Brightness", "Largest of R, G and B")),
        "HSL": (_HUE, _SATURATION, _share("Lightness", "Mean of the largest and the least of R, G and B")),
        "Lab": (
            _LIGHTNESS,
            Parameter("a*", "", -1000.0, 1000.0, 0.0, "Green to red"),
            Parameter("b*", "", -1000.0, 1000.0, 0.0, "Blue to yellow"),
        ),
        "LCh": (_LIGHTNESS, Parameter("C*", "", 0.0, 1500.0, 0.0, "Chroma"), _HUE),
        "XYZ": tuple(
            Parameter(name, "", -100.0, 10_000.0, 50.0, "The white's Y is 100") for name in ("X", "Y", "Z")
        ),
    }
)
"""The channels of each model but the spectrum, in the order of :attr:`FlatColour.values`."""

_REFLECTANCE = Parameter("Reflectance", "", -1.0, 100.0, 0.5, "1 is a perfect diffuser")
_WAVELENGTH = Parameter("Wavelength", "nm", 100.0, 10_000.0, 550.0, "Of a band of the spectrum")


@dataclass(frozen=True, slots=True)
class FlatColour:
    """A named colour of one model; ``name`` may be empty, as in formats without names.

    Attributes
    ----------
    values
        RGB, CMY, CMYK, Gray, saturation, brightness: 0 to 1, ink 1 is full. Hue: degrees. Lab, LCh: CIE 1976. XYZ: the
        white's Y is 100. Spectrum: reflectance factors, one for each of ``wavelengths_nm``.
    space
        Of RGB, CMYK and Gray: the name of their profile or colour space; empty where the file names none.
    illuminant, observer_deg
        Of Lab, LCh and XYZ: their white; empty and 0 where the file names none.
    others
        The same colour in further models, in the order of the file; theirs are empty.

    >>> FlatColour("Ink", "CMYK", (1.0, 0.5, 0.0, 0.1)).values
    (1.0, 0.5, 0.0, 0.1)
    """

    name: str
    model: Model
    values: tuple[float, ...]
    space: str = ""
    illuminant: str = ""
    observer_deg: int = 0
    wavelengths_nm: tuple[float, ...] = ()
    others: tuple[FlatColour, ...] = ()

    def __post_init__(self) -> None:
        check_text(self.name, "name", longest=LONGEST_NAME, lines=False, empty=True)
        check_choice(self.model, "model", MODELS)
        object.__setattr__(self, "values", self._checked_values())
        if self.space != "":
            check_text(self.space, "space", longest=200, lines=False, empty=True)
        if self.illuminant != "":
            check_text(self.illuminant, "illuminant", longest=50, lines=False, empty=True)
        object.__setattr__(self, "observer_deg", as_whole(self.observer_deg))
        if isinstance(self.observer_deg, bool) or self.observer_deg not in (0, 2, 10):
            raise ValueRangeError("observer_deg", f"expected 2, 10 or 0, not {describe(self.observer_deg)}")
        if self.others != ():
            self._check_others()

    def _check_others(self) -> None:
        if not isinstance(self.others, (tuple, list)) or len(self.others) > _MOST_OTHERS:
            raise ValueRangeError("others", f"expected a list of at most {_MOST_OTHERS} colours")
        for index, other in enumerate(self.others):
            if not isinstance(other, FlatColour) or other.others:
                raise ValueRangeError(f"others[{index}]", "expected a colour without others of its own")
        object.__setattr__(self, "others", tuple(self.others))

    def _checked_values(self) -> tuple[float, ...]:
        values, bands = self.values, self.wavelengths_nm
        for name, items in (("values", values), ("wavelengths_nm", bands)):
            if not isinstance(items, (tuple, list)):
                raise ValueRangeError(name, f"expected a list of numbers, not {describe(items)}")
        if self.model != "spectrum":
            channels = CHANNELS[self.model]
            if bands:
                raise ValueRangeError("wavelengths_nm", f"a colour in {self.model} has none")
            if len(values) != len(channels):
                raise ValueRangeError(
                    "values", f"{self.model} has {len(channels)} numbers, not {len(values)}"
                )
            # A comparison refuses NaN, too; only what fails it needs a message.
            if type(values) is tuple and all(
                type(value) is float and channel.low <= value <= channel.high
                for channel, value in zip(channels, values, strict=True)
            ):
                return values
            return tuple(
                channel.check(value, f"values[{index}]")
                for index, (channel, value) in enumerate(zip(channels, values, strict=True))
            )
        if not 2 <= len(values) <= _MOST_BANDS or len(values) != len(bands):
            raise ValueRangeError(
                "values", f"expected 2 to {_MOST_BANDS} numbers, as many as wavelengths, not {len(values)}"
            )
        checked = tuple(_WAVELENGTH.check(band, f"wavelengths_nm[{i}]") for i, band in enumerate(bands))
        if any(b <= a for a, b in pairwise(checked)):
            raise ValueRangeError("wavelengths_nm", "wavelengths must rise")
        object.__setattr__(self, "wavelengths_nm", checked)
        return tuple(_REFLECTANCE.check(value, f"values[{i}]") for i, value in enumerate(values))
