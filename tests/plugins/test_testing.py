"""The checks for authors of plug-ins: what is built in passes them, and faults do not."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np
import pytest

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.parameter import Parameter
from brdf_suite.files.exports import FORMATS as EXPORTS
from brdf_suite.files.measured import FORMATS as MEASURED
from brdf_suite.files.palettes import FORMATS as PALETTES
from brdf_suite.reflectance.registry import MODELS, ModelEntry
from brdf_suite.testing import check_export, check_measured_format, check_model, check_palette_format

BY_NAME = {one.name: one for one in (*PALETTES.built_in, *MEASURED.built_in, *EXPORTS.built_in)}
GPL = b"GIMP Palette\nName: A\nColumns: 0\n#\n255   0   0\tRed\n"
TEXT = b"def brdf(L, V, N, X, Y, a=number(0, 1, 0.5)):\n    return a / pi\n"


@dataclass(frozen=True)
class Model:
    """A model with one fault, by name."""

    fault: str = ""
    level: float = 0.5
    parameters: ClassVar = {"level": Parameter("Level", "", 0.0, 1.0, 0.5, "Level")}
    reciprocal: ClassVar = True
    energy_conserving: ClassVar = True

    def eval(self, wi, wo):
        wi, wo = np.broadcast_arrays(wi, wo)
        value = np.full(wi.shape, self.level / np.pi)
        if self.fault == "claim":
            value = value * 9.0
        if self.fault == "one way":
            value = value * (1.0 + wi[..., :1]) / 3.0
        if self.fault == "end" and self.level == 1.0:
            value = value * np.nan
        above = (wi[..., 2:] > 0.0) & (wo[..., 2:] > 0.0)
        return value if self.fault == "below" else np.where(above, value, 0.0)


def entry(fault: str) -> ModelEntry:
    return ModelEntry("flat", "Flat", lambda: Model(fault), True, True, "a test")


@pytest.mark.parametrize("name", ["lambertian", "ggx", "phong_original", "coat"])
def test_models_pass(name: str) -> None:
    check_model(MODELS[name])


def test_formats_pass() -> None:
    check_palette_format(BY_NAME["gpl"], GPL)
    check_measured_format(BY_NAME["model_text"], TEXT)
    check_export(BY_NAME["json"])


@pytest.mark.parametrize(
    ("fault", "words"),
    [
        ("claim", "claims what does not hold"),
        ("one way", "claims what does not hold"),
        ("below", "below the horizon"),
        ("end", "not finite"),
    ],
)
def test_a_model_with_a_fault_fails(fault: str, words: str) -> None:
    check_model(entry(""))
    with pytest.raises(AssertionError, match=words):
        check_model(entry(fault))


def test_formats_with_a_fault_fail() -> None:
    gpl, text, json = BY_NAME["gpl"], BY_NAME["model_text"], BY_NAME["json"]
    other = Palette("B", (Entry(solid_paint("Grey", (50.0, 0.0, 0.0))),))
    with pytest.raises(AssertionError, match="not recognised"):
        check_palette_format(gpl, b"JASC-PAL")
    with pytest.raises(AssertionError, match="come back the same"):
        check_palette_format(replace(gpl, write=lambda _palette: gpl.write(other)), GPL)
    with pytest.raises(IndexError):
        check_palette_format(
            replace(gpl, read=lambda content, path: (gpl.read(GPL, path), content[40])[0]), GPL
        )
    with pytest.raises(AssertionError, match="not recognised"):
        check_measured_format(replace(text, sniff=lambda _head, _size: False), TEXT)
    with pytest.raises(AssertionError, match="losses are sentences"):
        check_export(replace(json, losses=lambda _item: ("no full stop",)))
