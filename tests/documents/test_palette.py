"""Palettes: values, files, and what is refused."""

from __future__ import annotations

import copy
import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.documents.cook_torrance import CookTorranceLobe, CookTorrancePaint
from brdf_suite.documents.flat_colour import CHANNELS, FlatColour
from brdf_suite.documents.paint import Flakes, Gloss, OrangePeel, TextureTargets, solid_paint
from brdf_suite.documents.palette import MOST_ENTRIES, Entry, Group, Palette
from brdf_suite.documents.palette_store import (
    encode_palette,
    load_palette,
    palette_from_json,
    palette_to_json,
    save_palette,
)
from brdf_suite.documents.store import any_paint_from_json, paint_to_json, quick_paint
from brdf_suite.errors import DocumentError, FileError, ValueRangeError

WHITE = Entry(
    solid_paint("White", (95.0, 0.0, 1.0)),
    id="white",
    code="LY9C",
    tags=("fleet", "été"),
    notes="the customer's\nown",
    date="2024-05-31",
)
BLUE = Entry(solid_paint("Blue", (30.0, 5.0, -40.0), Gloss(85.0, 92.0)), group=("Cold", "Blues"))
MEASURED = Entry(
    CookTorrancePaint("Table 1", (0.1, 0.0, 0.0), (CookTorranceLobe((0.1, 0.1, 0.1), 0.2, 0.5),)),
    group=("B",),
)
INK = Entry(
    FlatColour(
        "藍 ink", "CMYK", (1.0, 0.7, 0.0, 0.1), "FOGRA39", others=(FlatColour("", "Lab", (30.0, 1.0, -40.0)),)
    ),
    usage="spot",
    foreign=(("ase.model", "CMYK"),),
)


def palette() -> Palette:
    return Palette(
        "Summer",
        (WHITE, BLUE, INK, replace(BLUE, id="second"), MEASURED),
        (Group(("Cold",), "cold", "#0000ff"), Group(("Empty",), foreign=(("a", "b"),))),
        columns=4,
        colour="#aabbcc",
    )


def test_entries_get_ids_and_groups_are_declared() -> None:
    made = palette()
    assert [entry.id for entry in made] == [WHITE.id, "2", "3", "second", "5"]
    assert [group.path for group in made.groups] == [("Cold",), ("Empty",), ("Cold", "Blues"), ("B",)]
    assert made.entry("second").name == "Blue"
    # A number that is taken is not given twice.
    assert len({entry.id for entry in Palette("p", (replace(BLUE, id="2"), BLUE, BLUE))}) == 3


def test_sections_hold_each_group_once_in_the_order_of_the_file() -> None:
    reported = [
        (None if group is None else group.path, [entry.id for entry in entries])
        for group, entries in palette().sections()
    ]
    assert reported == [
        (None, [WHITE.id]),
        (("Cold",), []),
        (("Cold", "Blues"), ["2", "second"]),
        (("Empty",), []),
        (None, ["3"]),
        (("B",), ["5"]),
    ]


def test_a_palette_comes_back_from_its_file(tmp_path: Path) -> None:
    path = tmp_path / "a.brdfpalette"
    save_palette(palette(), path)
    assert load_palette(path) == palette()
    text = path.read_text("utf-8")
    assert json.loads(text)["version"] == 2
    assert json.loads(text) == json.loads(json.dumps(palette_to_json(palette())))
    assert sum(line.startswith('    {"id"') for line in text.splitlines()) == 5


def test_fields_with_a_default_may_be_left_out() -> None:
    least = {"format": "brdfpalette", "version": 2, "name": "x"}
    assert palette_from_json(least) == Palette("x")
    inside = {**least, "entries": [{"paint": paint_to_json(BLUE.content)}]}
    assert palette_from_json(inside) == Palette("x", (Entry(BLUE.content),))


def test_the_first_version_is_brought_up_to_date() -> None:
    paints = [paint_to_json(solid_paint(name, (50.0, 0.0, 0.0))) for name in "abc"]
    old = {
        "format": "brdfpalette",
        "version": 1,
        "name": "Old",
        "notes": "n",
        "swatches": [{"paint": paints[0], "tags": ["t"], "notes": ""}],
        "groups": [
            {
                "name": "g",
                "notes": "of g",
                "swatches": [{"paint": paints[1]}, {"paint": paints[2], "notes": "c"}],
            },
            {"name": "empty"},
        ],
    }
    found = palette_from_json(old)
    assert [(e.name, e.group, e.tags, e.notes) for e in found] == [
        ("a", (), ("t",), ""),
        ("b", ("g",), (), ""),
        ("c", ("g",), (), "c"),
    ]
    assert found.groups == (Group(("g",), "of g"), Group(("empty",)))
    with pytest.raises(DocumentError, match="version 1 but not as that version was"):
        palette_from_json({**old, "groups": [3]})


def test_a_paint_of_an_older_version_is_brought_up_to_date() -> None:
    old = {**paint_to_json(BLUE.content), "version": 1}
    del old["out_of_plane"]
    found = palette_from_json(
        {"format": "brdfpalette", "version": 2, "name": "x", "entries": [{"paint": old}]}
    )
    assert found.entries[0].content == BLUE.content


@pytest.mark.parametrize(
    ("keys", "value", "place", "words"),
    [
        (("format",), "brdfpaint", "format", 'expected "brdfpalette"'),
        (("version",), 3, "version", "newer than this program"),
        (("name",), "", "name", "text"),
        (("columns",), -1, "columns", "whole number"),
        (("colour",), "blue", "colour", "#rrggbb"),
        (("groups",), {}, "groups", "expected a list"),
        (("groups", 0), 3, "groups[0]", "expected an object"),
        (("groups", 1, "path"), ["Cold"], "groups[1].path", "there twice"),
        (("groups", 1, "path"), [], "groups[1].path", "has a name"),
        (("groups", 0, "label"), 3, "groups[0]", "'label' is unknown"),
        (("entries",), 3, "entries", "expected a list"),
        (("entries", 0, "paint"), None, "entries[0].paint", "expected an object"),
        (("entries", 2, "flat", "values", 1), "x", "entries[2].flat.values[1]", "expected a number"),
        (("entries", 2, "flat", "values", 1), float("nan"), "entries[2].flat.values[1]", "finite"),
        (("entries", 2, "flat", "model"), "RYB", "entries[2].flat.model", "one of RGB"),
        (("entries", 2, "flat", "others", 0, "values"), [1], "entries[2].flat.others[0].values", "3 numbers"),
        (("entries", 2, "paint"), {}, "entries[2]", 'one of "paint" and "flat"'),
        (("entries", 1, "id"), WHITE.id, "entries[1].id", "there twice"),
        (("entries", 0, "tags"), "fleet", "entries[0].tags", "expected a list"),
        (("entries", 0, "tags"), ["a", 3], "entries[0].tags[1]", "expected a text"),
        (("entries", 0, "tags"), ["a", "a"], "entries[0].tags[1]", "there twice"),
        (("entries", 0, "date"), "2024-02-31", "entries[0].date", "a date as in"),
        (("entries", 0, "usage"), "ink", "entries[0].usage", "process"),
        (("entries", 0, "foreign"), [["a"]], "entries[0].foreign[0]", "a name and a text"),
        (("entries", 3, "paint", "kind"), "x", "entries[3].paint.kind", "kinds known"),
        (("entries", 3, "paint", "gloss", "gu_20"), -3, "entries[3].paint.gloss.gu_20", "range"),
        (("entries", 3, "paint", "measurements", 1, "lab", 2), 1e9, "entries[3].paint.measurements[1].lab[2]", "range"),
        (("entries", 3, "paint", "version"), 99, "entries[3].paint.version", "newer"),
    ],
)  # fmt: skip
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
    with pytest.raises(ValueRangeError, match="expected a paint or a flat colour"):
        Entry("blue")  # type: ignore[arg-type]
    with pytest.raises(ValueRangeError, match="100001 are more"):
        Palette("p", (BLUE,) * (MOST_ENTRIES + 1))
    with pytest.raises(ValueRangeError, match="must rise"):
        FlatColour("s", "spectrum", (0.1, 0.2), wavelengths_nm=(500.0, 400.0))
    with pytest.raises(ValueRangeError, match="1000000 characters"):
        FlatColour("n" * 1_000_000, "Gray", (0.5,))
    with pytest.raises(FileError, match="cannot be read"):
        load_palette("/nowhere/a.brdfpalette")


@given(model=st.sampled_from(sorted(CHANNELS)), data=st.data())
@settings(max_examples=settings.default.max_examples // 2)
def test_the_numbers_of_every_model_come_back_bit_for_bit(model: str, data: st.DataObject) -> None:
    values = tuple(data.draw(st.floats(max(c.low, -1e3), c.high)) for c in CHANNELS[model])
    colour = FlatColour("x", model, values)  # type: ignore[arg-type]  # a sampled word
    found = palette_from_json(json.loads(encode_palette(Palette("p", (Entry(colour),)))))
    assert [v.hex() for v in found.entries[0].content.values] == [v.hex() for v in values]


_DAMAGE = [
    ("name", " "), ("name", "a\nb"), ("name", 3), ("version", 2), ("observer_deg", 2), ("observer_deg", 10.0),
    ("illuminant", "A"), ("interpolation", []), ("interpolation", "cubic"), ("near_specular", 11.0),
    ("near_specular", float("nan")), ("gloss", None), ("gloss", {"gu_20": 300.0}), ("flakes", {"size": 1.0}),
    ("flakes", {"size_um": -1.0}), ("orange_peel", {"amplitude_um": 20.0, "wavelength_mm": 0.5}),
    ("texture", {"graininess": 2.0}), ("extra", 1),
    ("measurements", []), ("measurements", [3, 4, 5]), ("source", "\x00"),
]  # fmt: skip
_BAD_READINGS = [
    ("lab", [50.0, 0.0]), ("lab", [float("nan"), 0.0, 0.0]), ("lab", [50.0, 0.0, 251.0]), ("lab", [-1.0, 0.0, 0.0]),
    ("illumination_deg", 86.0), ("aspecular_deg", 136.0), ("aspecular_deg", 45.0 + 1e-10), ("aspecular_deg", "45"),
    ("lab", [True, 0.0, 0.0]), ("extra", 1.0),
]  # fmt: skip


def test_what_the_quick_reader_takes_is_what_the_usual_one_reads() -> None:
    full = replace(
        solid_paint("Blue", (30.0, 5.0, -40.0), Gloss(85.0, 92.0)),
        flakes=Flakes(),
        orange_peel=OrangePeel(),
        texture=TextureTargets(grade_45=0.8),
        notes="é",
    )
    for paint in (full, solid_paint("w", (95.0, 0.0, 1.0))):
        written = json.loads(json.dumps(paint_to_json(paint)))
        assert quick_paint(written) == any_paint_from_json(written) == paint
    good = json.loads(json.dumps(paint_to_json(full)))
    for name in ("flakes", "notes", "interpolation", "orange_peel", "texture", "near_specular", "illuminant"):
        less = {key: value for key, value in good.items() if key != name}
        assert quick_paint(less) == any_paint_from_json(less)
    for name, value in _DAMAGE:
        assert quick_paint({**good, name: value}) is None, name
    for name, value in _BAD_READINGS:
        bad = copy.deepcopy(good)
        bad["measurements"][2][name] = value
        assert quick_paint(bad) is None, (name, value)
        with pytest.raises(DocumentError):
            any_paint_from_json(bad)
    for other in (None, [], "x", paint_to_json(MEASURED.content)):
        assert quick_paint(other) is None


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """A file system of its own with room for 64 KB, where the user may mount one."""
    if sys.platform != "linux":
        pytest.skip("tmpfs is mounted on Linux")
    folder = tmp_path / "disk"
    folder.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", str(folder)]
    try:
        mounted = subprocess.run(mount, capture_output=True, check=False).returncode == 0
    except OSError:
        mounted = False
    if not mounted:
        pytest.skip("the user may not mount a file system")
    try:
        yield folder
    finally:
        subprocess.run(["umount", "-l", str(folder)], check=True)


def test_a_disk_without_room_leaves_the_old_palette(small_disk: Path) -> None:
    path = small_disk / "a.brdfpalette"
    save_palette(palette(), path)
    many = Palette("new", tuple(Entry(FlatColour(f"c{i}", "Gray", (0.5,))) for i in range(2000)))
    with pytest.raises(FileError, match="No space left on device"):
        save_palette(many, path)
    assert load_palette(path) == palette()
    assert [item.name for item in small_disk.iterdir()] == ["a.brdfpalette"]


_SAVE = """
import sys
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.errors import FileError
new = Palette("new", tuple(Entry(FlatColour(f"c{i}", "Gray", (0.5,))) for i in range(2000)))
try:
    save_palette(new, sys.argv[1])
except FileError as error:
    print(error)
    sys.exit(3)
"""


@pytest.mark.skipif(os.name == "nt", reason="signals and file size limits are those of Unix")
def test_a_killed_writer_and_a_full_disk_leave_the_old_palette(tmp_path: Path) -> None:
    path = tmp_path / "a.brdfpalette"
    save_palette(palette(), path)

    def run(prelude: str) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-c", prelude + _SAVE, str(path)]
        return subprocess.run(command, capture_output=True, text=True, timeout=240, check=False)

    killed = run("import os, signal\nos.replace = lambda *a: os.kill(os.getpid(), signal.SIGKILL)\n")
    assert killed.returncode == -signal.SIGKILL
    assert load_palette(path) == palette()
    # The system refuses to let a file grow past 20,000 bytes: in the middle of the writing.
    full = run("import resource\nresource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))\n")
    assert full.returncode == 3
    assert "cannot be written: File too large." in full.stdout
    assert load_palette(path) == palette()
    assert run("").returncode == 0
    assert load_palette(path).name == "new"


def test_entries_of_a_file_share_their_words_and_have_no_dictionaries(tmp_path: Path) -> None:
    blue = replace(BLUE.content, source="Of the same shelf", notes="As delivered")
    path = tmp_path / "many.brdfpalette"
    entries = [Entry(blue, id=str(n), group=("Dark",), tags=("metallic", "trial")) for n in range(20)]
    save_palette(Palette("Many", tuple(entries)), path)
    read = load_palette(path)
    assert read.entries == tuple(entries)
    for name in ("source", "notes", "interpolation", "scattering"):
        assert len({id(getattr(entry.content, name)) for entry in read}) == 1, name
    for name in ("group", "tags"):
        assert len({id(getattr(entry, name)) for entry in read}) == 1, name
    one = read.entries[0]
    assert isinstance(one.content, type(blue))
    for value in (one, one.content, one.content.gloss, *one.content.measurements):
        assert not hasattr(value, "__dict__")


def test_an_entry_takes_the_place_of_one_with_its_id_alone() -> None:
    palette = Palette("Some", (replace(BLUE, id="a"), replace(BLUE, id="b")))
    changed = palette.with_entries({1: replace(BLUE, id="b", code="B", group=("Outer", "Inner"))})
    assert changed == replace(palette, entries=changed.entries, groups=changed.groups)
    assert [group.path for group in changed.groups][-2:] == [("Outer",), ("Outer", "Inner")]
    assert changed.entry("b").code == "B"
    with pytest.raises(ValueRangeError, match="expected the id 'a'") as refused:
        palette.with_entries({0: replace(BLUE, id="c")})
    assert refused.value.place == "entries[0].id"
