"""Palettes: values, files, and what is refused."""

from __future__ import annotations

import copy
import json
from pathlib import Path

import pytest

from brdf_suite.documents.cook_torrance import CookTorranceLobe, CookTorrancePaint
from brdf_suite.documents.paint import Gloss, solid_paint
from brdf_suite.documents.palette import Group, Palette, Swatch
from brdf_suite.documents.palette_store import (
    load_palette,
    palette_from_json,
    palette_to_json,
    save_palette,
)
from brdf_suite.documents.store import paint_to_json
from brdf_suite.errors import DocumentError, FileError, ValueRangeError

WHITE = Swatch(solid_paint("White", (95.0, 0.0, 1.0)), ("fleet", "été"), "the customer's\nown")
BLUE = Swatch(solid_paint("Blue", (30.0, 5.0, -40.0), Gloss(85.0, 92.0)))
MEASURED = Swatch(
    CookTorrancePaint("Table 1", (0.1, 0.0, 0.0), (CookTorranceLobe((0.1, 0.1, 0.1), 0.2, 0.5),))
)


def palette() -> Palette:
    return Palette(
        "Summer", (WHITE,), (Group("Blues", (BLUE, BLUE), "cold"), Group("Empty"), Group("B", (MEASURED,)))
    )


def test_order_and_count() -> None:
    assert [swatch.name for swatch in palette()] == ["White", "Blue", "Blue", "Table 1"]
    assert len(palette()) == 4


def test_a_palette_comes_back_from_its_file(tmp_path: Path) -> None:
    path = tmp_path / "a.brdfpalette"
    save_palette(palette(), path)
    assert load_palette(path) == palette()
    assert json.loads(path.read_text("utf-8"))["version"] == 1


def test_fields_with_a_default_may_be_left_out() -> None:
    least = {"format": "brdfpalette", "version": 1, "name": "x"}
    assert palette_from_json(least) == Palette("x")
    inside = {**least, "swatches": [{"paint": paint_to_json(BLUE.paint)}], "groups": [{"name": "g"}]}
    assert palette_from_json(inside) == Palette("x", (BLUE,), (Group("g"),))


def test_a_paint_of_an_older_version_is_brought_up_to_date() -> None:
    old = {**paint_to_json(BLUE.paint), "version": 1}
    del old["out_of_plane"]
    assert (
        next(
            iter(
                palette_from_json(
                    {"format": "brdfpalette", "version": 1, "name": "x", "swatches": [{"paint": old}]}
                )
            )
        )
        == BLUE
    )


@pytest.mark.parametrize(
    ("keys", "value", "place", "words"),
    [
        (("format",), "brdfpaint", "format", '"brdfpalette" is wanted'),
        (("version",), 2, "version", "newer than this program"),
        (("name",), "", "name", "text"),
        (("groups",), {}, "groups", "a list is wanted"),
        (("groups", 0), 3, "groups[0]", "an object is wanted"),
        (("groups", 1, "name"), "Blues", "groups[1].name", "there twice"),
        (("groups", 0, "colour"), 3, "groups[0]", "'colour' is unknown"),
        (("swatches", 0, "paint"), None, "swatches[0].paint", "an object is wanted"),
        (("swatches", 0, "tags"), "fleet", "swatches[0].tags", "a list is wanted"),
        (("swatches", 0, "tags"), ["a", 3], "swatches[0].tags[1]", "str is wanted"),
        (("swatches", 0, "tags"), ["a", "a"], "swatches[0].tags[1]", "there twice"),
        (
            ("groups", 0, "swatches", 1, "paint", "kind"),
            "x",
            "groups[0].swatches[1].paint.kind",
            "kinds known",
        ),
        (
            ("groups", 0, "swatches", 1, "paint", "gloss", "gu_20"),
            -3,
            "groups[0].swatches[1].paint.gloss.gu_20",
            "range",
        ),
        (
            ("groups", 0, "swatches", 1, "paint", "version"),
            99,
            "groups[0].swatches[1].paint.version",
            "newer",
        ),
    ],
)
def test_a_bad_field_is_named(tmp_path: Path, keys: tuple, value: object, place: str, words: str) -> None:
    document = copy.deepcopy(palette_to_json(palette()))
    target = document
    for key in keys[:-1]:
        target = target[key]
    target[keys[-1]] = value
    path = tmp_path / "bad.brdfpalette"
    path.write_text(json.dumps(document), "utf-8")
    with pytest.raises(DocumentError, match=words) as caught:
        load_palette(path)
    assert caught.value.place == place
    assert str(path) in str(caught.value)


def test_values_check_themselves() -> None:
    with pytest.raises(ValueRangeError, match="a paint is wanted"):
        Swatch("blue")  # type: ignore[arg-type]
    with pytest.raises(ValueRangeError, match="5001"):
        Group("g", (BLUE,) * 5001)
    with pytest.raises(ValueRangeError, match="6000 swatches in all"):
        Palette("p", (BLUE,) * 3000, (Group("g", (BLUE,) * 3000),))
    with pytest.raises(FileError, match="cannot be read"):
        load_palette("/nowhere/a.brdfpalette")
