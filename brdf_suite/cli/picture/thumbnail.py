"""``brdf-suite thumbnail FILE -o FILE.png``: the small picture of a document, as a file manager shows it."""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from brdf_suite.cli.arguments import add_arguments, add_output, whole_number
from brdf_suite.cli.output import print_done
from brdf_suite.command_parser import CommandParser
from brdf_suite.errors import FileError, GraphicsError, SuiteError
from brdf_suite.files.images.png import write_png
from brdf_suite.palettes.swatches.look import LARGEST, SMALLEST, Content, SwatchLook
from brdf_suite.palettes.swatches.pictures import SwatchPainter
from brdf_suite.pipeline.material import file_kind, load_document, load_palette_file

_ACROSS = 3
"""Paints of a palette in a row of its picture, and rows."""
_GAP_SHARE = 0.03


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "Draw a paint as a sphere in the light booth, or the first nine paints of a palette, each as a sphere; without "
        "OpenGL as bands of their colours. For thumbnailers of file managers."
    )
    command.examples = ("brdf-suite thumbnail deep_sea.brdfpaint -o deep_sea.png --size 128",)
    add_arguments(command, {"file FILE": "a paint or a palette"})
    add_output(command, "the picture to write", stream=".png")
    add_arguments(
        command, {"--size N=256": "pixels of its side (default: 256)"}, size=whole_number(16, LARGEST)
    )
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Draw and write."""
    contents = _contents(options.file)
    try:
        pixels = _drawn(contents, "sphere", options.size)
    except GraphicsError:
        pixels = _drawn(contents, "chips", options.size)
    write_png(options.output, pixels)
    print_done(f"{options.output}: {options.size}×{options.size}")
    return 0


def _contents(file: Path) -> list[Content]:
    if file_kind(file) == "palette":
        contents: list[Content] = [
            entry.content for entry in load_palette_file(file).palette.entries[: _ACROSS**2]
        ]
        if not contents:
            raise FileError(file, "is a palette without a paint")
        return contents
    document = load_document(file)
    if document is None:
        raise FileError(file, "is neither a paint nor a palette")
    return [document]


def _drawn(contents: list[Content], form: str, size: int) -> NDArray[np.uint8]:
    """Return the picture (size, size, 4): one paint over all of it, or several in rows on nothing."""
    across = 1 if len(contents) == 1 else 2 if len(contents) <= 4 else _ACROSS
    gap = 0 if across == 1 else max(1, round(_GAP_SHARE * size))
    side = (size - gap * (across - 1)) // across
    with SwatchPainter() as painter:
        look = SwatchLook(form=form, size=max(SMALLEST, side))
        pictures = painter.draw(contents[: across**2], look)
    if all(picture.pixels is None for picture in pictures):
        raise SuiteError(pictures[0].problem)
    whole = np.zeros((size, size, 4), np.uint8)
    for place, picture in enumerate(pictures):
        if picture.pixels is None:
            continue
        row, column = (at * (side + gap) for at in divmod(place, across))
        shown = picture.pixels[:side, :side]
        whole[row : row + side, column : column + side, :3] = shown
        whole[row : row + side, column : column + side, 3] = 255
    return whole
