"""Every variant of what other programs and people write is read, and no colour comes out wrong."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import Paint
from brdf_suite.errors import FileError
from brdf_suite.files.palettes import read_content
from brdf_suite.files.palettes.format import ReadPalette

_writers = load_module(Path(__file__).parent / "foreign_writers.py")
WRITERS = _writers.WRITERS
LEAST_VARIANTS = 20
LEAST_READ = 0.97


def difference(variant: Any, read: ReadPalette) -> str:
    """What is wrong in a palette; empty where it is what the writer wrote."""
    entries = read.palette.entries
    if len(entries) != len(variant.flat) + len(variant.samples):
        return f"{len(entries)} entries"
    for entry, (name, model, values) in zip(entries, variant.flat, strict=False):
        content = entry.content
        if not isinstance(content, FlatColour) or (content.name, content.model) != (name, model):
            return f"{content.name!r} is not {name!r} in {model}"
        if not np.allclose(content.values, values, atol=2e-9, rtol=1e-9):
            return f"{name}: {content.values} are not {values}"
    for entry, (name, readings) in zip(entries, variant.samples, strict=False):
        paint = entry.content
        if not isinstance(paint, Paint) or paint.name != name:
            return f"{entry.name!r} is not the sample {name!r}"
        found = {(m.illumination_deg, m.aspecular_deg): m.lab for m in paint.measurements}
        if found.keys() != readings.keys():
            return f"{name}: angles {sorted(found)}"
        if not all(np.allclose(found[key], lab, atol=1e-9) for key, lab in readings.items()):
            return f"{name}: {found}"
        effects = json.loads(dict(entry.foreign).get("instrument.effects", "{}"))
        if effects != (variant.effects or {}):
            return f"{name}: effects {effects}"
    return ""


@pytest.mark.parametrize("title", WRITERS)
def test_variants_are_read_and_none_has_a_wrong_colour(title: str) -> None:
    name, make = WRITERS[title]
    variants = list(make())
    assert len(variants) >= LEAST_VARIANTS
    refused, wrong = [], []
    for variant in variants:
        try:
            read = read_content(variant.content, "a.dat")
        except FileError as error:
            refused.append(f"{variant.label}: {error}")
            continue
        bad = difference(variant, read) or ("" if read.format.name == name else f"read as {read.format.name}")
        if bad:
            wrong.append(f"{variant.label}: {bad}")
    assert wrong == []
    assert len(refused) <= (1.0 - LEAST_READ) * len(variants), refused


INSTRUMENTS = [
    title
    for title in WRITERS
    if "instruments'" in title or any(one.name in title for one in _writers.DEVICES)
]


@pytest.mark.parametrize("title", INSTRUMENTS)
def test_instruments_say_that_their_layout_is_not_published(title: str) -> None:
    for variant in WRITERS[title][1]():
        notes = read_content(variant.content, "a.dat").notes
        assert any(note.startswith("The layout of the table is not published") for note in notes)
        # What is out of the plane of incidence is no reading of a paint, and is named.
        assert any("45as25 is out of the plane" in note for note in notes) == ("MA-T12" in title)
