"""The writers of every format that a registry lists: palettes, exports, measured tables. New ones are found here."""

from __future__ import annotations

import re
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from brdf_suite.files.exports.format import ExportItem
from brdf_suite.files.measured import FORMATS as MEASURED
from brdf_suite.files.measured import read_measured, write_measured
from brdf_suite.files.palettes import FORMATS as PALETTES
from brdf_suite.files.palettes import read_content, write_palette
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.regular_files import read_bytes
from brdf_suite.reports.handover import formats, read_paints
from brdf_suite.reports.paint_report import document
from tools.attack.writing.writer import FILL, Writer, paint, palette, read_one

LEFT_OUT = {
    "rgl": "43 MB in 8 s; the same module writes measured:rgl",
    "html": "draws for half a minute; export:report writes as it does",
    "pdf": "draws for half a minute; export:report writes as it does",
    "cook_torrance": "a paint with the model's parameters, which document:paint writes",
    "merl": "35 MB; array files and pictures are written as it is",
    "cornell": "holds spectra only; measured:alta is written as it is",
}
"""Formats that no writer of the harness has, with the reason."""
_IN_SLICES = ("json", "csv", "cxf", "brdftable", "alta")
"""One of each kind; the others differ in the content that they give to the same function."""


def _name_of(entry: Any) -> str:
    """Return the version of an entry: its name where the format has names, or its first number."""
    named = re.match(r"v\d+\b", entry.name)
    return named[0] if named else f"v{round(255.0 * entry.content.values[0])}"


def _palette_writer(known: Any) -> Writer:
    path = f"p{known.endings[0]}"

    def read(folder: Path) -> int:
        content = read_bytes(folder / path)
        entries = read_content(content, folder / path, known).palette.entries
        if len(entries) != len(palette(0).entries):
            raise ValueError(f"{len(entries)} entries")
        return read_one(_name_of(entry) for entry in entries)

    return Writer(
        f"palette:{known.name}",
        lambda folder, number: write_palette(palette(number), folder / path, known),
        read,
        in_slices=known.name in ("brdfpalette", "ase", "sbz"),
    )


def _export_writer(known: Any) -> Writer:
    def read(folder: Path) -> int:
        path = folder / f"e{known.ending}"
        if known.read is not None:
            return read_one(one.name for one in read_paints(path).paints)
        content = read_bytes(path)
        number = read_one(found.decode() for found in re.findall(rb"(?<![\w.])v\d+(?=[\W_])", content))
        with tempfile.TemporaryDirectory(prefix="attack-") as other:
            again = Path(other) / path.name
            known.write([ExportItem(paint(number))], again, None)
            if read_bytes(again) != content:
                raise ValueError("it is not whole")
        return number

    return Writer(
        f"export:{known.name}",
        lambda folder, number: known.write([ExportItem(paint(number))], folder / f"e{known.ending}", None),
        read,
        in_slices=known.name in _IN_SLICES,
    )


def _table(number: int) -> IsotropicTable:
    return IsotropicTable.from_reflectance(Lambertian((number % 1000) / 1000.0), HalfAngleGrid(8, 8, 16))


def _measured_writer(known: Any) -> Writer:
    path = f"t{known.endings[0]}"

    def read(folder: Path) -> int:
        away = [[np.sin(0.5), 0.0, np.cos(0.5)]]
        value = 1000.0 * np.pi * float(read_measured(folder / path).eval(away, away)[0, 1])
        number = round(value)
        if abs(value - number) > 0.2:
            raise ValueError(f"no version has the value {value}")
        return number

    return Writer(
        f"measured:{known.name}",
        lambda folder, number: write_measured(_table(number), folder / path, known.name),
        read,
        in_slices=known.name in _IN_SLICES,
    )


def _page(item: Any) -> tuple[bytes, tuple[str, ...]]:
    return f"{item.name} {FILL} {item.name}".encode(), ()


def _write_report(folder: Path, number: int) -> None:
    # Drawing is not what is killed.
    document.__dict__["build_report"] = lambda item, *_: item
    document.write_report(
        document.ReportOptions(),
        _page,
        [ExportItem(paint(number))],
        folder / "r.html",
    )


def _read_report(folder: Path) -> int:
    first, _, last = read_bytes(folder / "r.html").decode().split()
    return read_one((first, last))


WRITERS = (
    *(_palette_writer(one) for one in PALETTES if one.write is not None),
    *(_export_writer(one) for one in formats() if one.name not in LEFT_OUT),
    Writer("export:report", _write_report, _read_report),
    *(
        _measured_writer(one)
        for one in MEASURED.built_in
        if one.write is not None and one.name not in LEFT_OUT
    ),
)
