"""Files written here, read by programs of others; the method page on palette formats names those run by hand."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xmlschema
from PIL import GimpPaletteFile, ImageColor

from brdf_suite.appearance.colour.colorimetry import lab_to_working, working_to_display
from brdf_suite.appearance.colour.flat_colours import flat_labs
from brdf_suite.documents.flat_colour import CHANNELS, FlatColour
from brdf_suite.documents.paint import Gloss, Measurement, Paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.files.palettes import find_format, write_palette
from brdf_suite.files.palettes.conversions import lab_d50
from brdf_suite.files.palettes.text.css import format_css

PAINT = Paint(
    "Silver",
    tuple(Measurement(45.0, angle, (120.0 - angle, 0.5, -1.5)) for angle in (15.0, 25.0, 45.0, 75.0, 110.0)),
    Gloss(92.0, 95.0),
    notes="of the show",
)
BANDS = tuple(400.0 + 10.0 * i for i in range(31))
SPECTRUM = FlatColour("spectrum", "spectrum", tuple(0.1 + 0.02 * i for i in range(31)), wavelengths_nm=BANDS)
PALETTE = Palette(
    "Süd & <Nord>",
    (
        Entry(FlatColour("Red", "RGB", (1.0, 0.2, 0.4)), usage="global"),
        Entry(
            FlatColour("Ätna 藍 🎨", "CMYK", (1.0, 0.7, 0.1, 0.0), "FOGRA39"), group=("Inks",), usage="spot"
        ),
        Entry(FlatColour("Lab", "Lab", (60.0, -30.5, 12.25), "", "D50", 2), group=("Inks",), notes="note"),
        Entry(FlatColour("Grey", "Gray", (0.25,)), group=("Inks",)),
        Entry(SPECTRUM),
        Entry(PAINT, code="LY7W", foreign=(("instrument.effects", '{"graininess": 3.1}'),)),
    ),
    columns=4,
)


def test_pillow_reads_our_gimp_palette(tmp_path: Path) -> None:
    path = tmp_path / "a.gpl"
    write_palette(PALETTE, path)
    with path.open("rb") as stream:
        read = GimpPaletteFile.GimpPaletteFile(stream).getpalette()[0]
    rows = np.frombuffer(read, np.uint8).reshape(-1, 3)
    assert rows[:6].tolist()[0] == [255, 51, 102]
    assert rows[1].tolist() == [0, 77, 230]
    assert rows[3].tolist() == [64, 64, 64]
    silver = 255.0 * working_to_display(lab_to_working(PAINT.lab_at(45.0)))
    assert rows[5].tolist() == np.rint(silver).astype(int).tolist()


def parse_ase(data: bytes) -> list[dict[str, Any]]:
    """Return the colours and groups of an Adobe Swatch Exchange file, written from its description alone."""
    signature, major, minor, count = struct.unpack_from(">4sHHI", data)
    assert (signature, major, minor) == (b"ASEF", 1, 0)
    place, open_groups = 12, [[]]
    for _ in range(count):
        kind, size = struct.unpack_from(">HI", data, place)
        block = data[place + 6 : place + 6 + size]
        place += 6 + size
        if kind == 0xC002:
            open_groups.pop()
            continue
        (length,) = struct.unpack_from(">H", block)
        item: dict[str, Any] = {"name": block[2 : 2 * length].decode("utf-16-be")}  # without the closing zero
        open_groups[-1].append(item)
        if kind == 0xC001:
            item["swatches"] = []
            open_groups.append(item["swatches"])
            continue
        assert kind == 0x0001
        mode = block[2 + 2 * length :][:4].decode("ascii").strip()
        *values, use = struct.unpack(
            f">{ {'RGB': 3, 'CMYK': 4, 'LAB': 3, 'Gray': 1}[mode] }fH", block[6 + 2 * length :]
        )
        item |= {"type": ("Global", "Spot", "Process")[use], "data": {"mode": mode, "values": values}}
    assert place == len(data)
    assert len(open_groups) == 1
    return open_groups[0]


def test_an_independent_parser_reads_our_ase(tmp_path: Path) -> None:
    path = tmp_path / "a.ase"
    write_palette(PALETTE, path)
    reported = parse_ase(path.read_bytes())
    assert [item["name"] for item in reported] == ["Red", "Inks", "spectrum", "Silver"]
    assert reported[0]["type"] == "Global"
    assert reported[0]["data"] == {"mode": "RGB", "values": pytest.approx([1.0, 0.2, 0.4])}
    inks = reported[1]["swatches"]
    assert [(item["name"], item["type"], item["data"]["mode"]) for item in inks] == [
        ("Ätna 藍 🎨", "Spot", "CMYK"),
        ("Lab", "Process", "LAB"),
        ("Grey", "Process", "Gray"),
    ]
    assert inks[0]["data"]["values"] == pytest.approx([1.0, 0.7, 0.1, 0.0])
    assert inks[1]["data"]["values"] == pytest.approx([0.6, -30.5, 12.25])
    lightness, a, b = lab_d50(PAINT.lab_at(45.0))
    assert reported[3]["data"]["values"] == pytest.approx([lightness / 100.0, a, b], rel=1e-6)


def test_our_cxf_is_valid_against_the_schema(shared_data: Path, tmp_path: Path) -> None:
    schema = xmlschema.XMLSchema(shared_data / "palettes" / "cxf" / "CxF3_Core.xsd")
    path = tmp_path / "a.cxf"
    for palette in (PALETTE, Palette("empty")):
        write_palette(palette, path)
        schema.validate(path)


def test_colour_cxf_reads_our_cxf(tmp_path: Path) -> None:
    colour_cxf = pytest.importorskip("colour_cxf", reason="colour-cxf is not installed")
    path = tmp_path / "a.cxf"
    write_palette(PALETTE, path)
    read = colour_cxf.read_cxf_from_file(str(path))
    objects = {item.name: item for item in read.resources.object_collection.object_value}
    assert list(objects) == [entry.name for entry in PALETTE]
    lab = objects["Lab"].color_values.choice[0]
    assert (lab.l, lab.a, lab.b) == (60.0, -30.5, 12.25)
    angles = objects["Silver"].color_values.choice
    assert [(value.name, value.l) for value in angles] == [
        ("45as15", 105.0), ("45as25", 95.0), ("45as45", 75.0), ("45as75", 45.0), ("45as110", 10.0),
    ]  # fmt: skip
    spectra = [
        v for v in objects["spectrum"].color_values.choice if type(v).__name__ == "ReflectanceSpectrum"
    ]
    assert spectra[0].value == pytest.approx(list(SPECTRUM.values))
    specifications = {s.id: s for s in read.resources.color_specification_collection.color_specification}
    assert all(value.color_specification in specifications for value in angles)


@pytest.mark.parametrize(
    ("model", "space"),
    [(model, "") for model in ("RGB", "HSL", "Lab", "LCh")]
    + [("RGB", name) for name in ("Display P3", "Adobe RGB (1998)", "Rec. 2020", "ProPhoto RGB")],
)
def test_coloraide_sees_the_colours_of_our_css_as_we_do(model: str, space: str) -> None:
    coloraide = pytest.importorskip("coloraide", reason="coloraide is not installed")
    random = np.random.default_rng(5)
    white = ("D50", 2) if model in ("Lab", "LCh") else ("", 0)
    for _ in range(20):
        top = [c.high if c.unit else 1.0 if c.high in (1.0, 64.0) else 60.0 for c in CHANNELS[model]]
        values = tuple(random.uniform(0.0, top).tolist())
        colour = FlatColour("x", model, values, space, *white)  # type: ignore[arg-type]  # one of its words
        theirs = coloraide.Color(format_css(colour)).convert("srgb")
        ours = working_to_display(lab_to_working(flat_labs([colour])[0])).tolist()
        # Whites of four and five digits make a few thousandths.
        assert theirs.delta_e(coloraide.Color("srgb", ours), method="2000") < 0.02


def test_pillow_reads_the_colours_of_our_css() -> None:
    write = find_format("css").write
    assert write is not None
    random = np.random.default_rng(3)
    rows = [tuple((row / 255.0).tolist()) for row in random.integers(0, 256, (50, 3))]
    text = write(
        Palette("p", tuple(Entry(FlatColour(f"c{i}", "RGB", row)) for i, row in enumerate(rows)))
    ).decode()
    values = [
        line.split(":")[1].split(";")[0].strip() for line in text.splitlines() if line.startswith("  --")
    ]
    assert [ImageColor.getrgb(value) for value in values] == [
        tuple(round(255 * v) for v in row) for row in rows
    ]
