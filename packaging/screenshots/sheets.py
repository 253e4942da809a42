"""Sheets of small pictures, one of a program in a theme with all its states, kept for comparison with later runs."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from brdf_suite.tracing.agreement.comparison import flip_of

INDEX = "states.json"
"""Names of the states of each sheet, in the order of their tiles."""
THRESHOLD = 0.15
"""Mean FLIP error of a block above which a state counts as changed; packing alone gives up to about half of it."""
_TILE = (448, 252)
_CAPTION = 18
_COLUMNS = 4
_LARGEST_SCALE = 0.6
_BLOCK = 28
_QUALITY = 80


def write_sheet(folder: Path, name: str, pictures: Mapping[str, Path]) -> Path:
    """Write the sheet ``name`` of states' pictures into ``folder``, enter it in the index, and return its file."""
    rows = -(-len(pictures) // _COLUMNS)
    wide, tall = _TILE[0] + 8, _TILE[1] + _CAPTION + 8
    sheet = Image.new("RGB", (_COLUMNS * wide, rows * tall), (119, 119, 119))
    draw, font = ImageDraw.Draw(sheet), ImageFont.load_default(12)
    for place, (state, file) in enumerate(pictures.items()):
        x, y = _corner(place)
        draw.text((x + 2, y - _CAPTION + 1), state.replace("_", " "), (0, 0, 0), font)
        sheet.paste(_tile(file), (x, y))
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{name}.webp"
    sheet.save(path, quality=_QUALITY, method=6)
    index = read_index(folder)
    index[name] = list(pictures)
    text = json.dumps(dict(sorted(index.items())), indent=1) + "\n"
    (folder / INDEX).write_text(text, encoding="utf-8")
    return path


def read_index(folder: Path) -> dict[str, list[str]]:
    """Return the states of each sheet in ``folder``; none where nothing is kept."""
    path = folder / INDEX
    if not path.exists():
        return {}
    index: dict[str, list[str]] = json.loads(path.read_text(encoding="utf-8"))
    return index


def changes(folder: Path, name: str, pictures: Mapping[str, Path]) -> dict[str, float]:
    """Return how much each state differs from the kept sheet: the FLIP error, 0 to 1, of the worst block of its tile.

    A state that is on one side only has 1. Raise :class:`ExtraError` where FLIP is not installed.
    """
    kept = read_index(folder).get(name, [])
    found = dict.fromkeys([*kept, *pictures], 1.0)
    if not kept:
        return found
    with Image.open(folder / f"{name}.webp") as file:
        sheet = file.convert("RGB")
    for place, state in enumerate(kept):
        if state in pictures:
            x, y = _corner(place)
            before = sheet.crop((x, y, x + _TILE[0], y + _TILE[1]))
            found[state] = worst_block(before, _tile(pictures[state]))
    return found


def worst_block(before: Image.Image, after: Image.Image) -> float:
    """Return the greatest mean FLIP error, 0 to 1, of a block of 28 × 28 pixels of two tiles."""
    first, second = (np.asarray(image, np.float64) / 255.0 for image in (before, after))
    error = flip_of(first, second)
    tall, wide = (side // _BLOCK for side in error.shape)
    blocks = error[: tall * _BLOCK, : wide * _BLOCK].reshape(tall, _BLOCK, wide, _BLOCK)
    return float(blocks.mean(axis=(1, 3)).max())


def _corner(place: int) -> tuple[int, int]:
    """Return where the tile of a place begins, pixels."""
    row, column = divmod(place, _COLUMNS)
    return column * (_TILE[0] + 8) + 4, row * (_TILE[1] + _CAPTION + 8) + _CAPTION + 4


def _tile(path: Path) -> Image.Image:
    """Return a picture made as small as a tile, in the middle of it where it has another shape."""
    with Image.open(path) as file:
        whole = file.convert("RGB")
    scale = min(_TILE[0] / whole.width, _TILE[1] / whole.height, _LARGEST_SCALE)
    small = whole.resize((round(scale * whole.width), round(scale * whole.height)), Image.Resampling.LANCZOS)
    tile = Image.new("RGB", _TILE, (119, 119, 119))
    tile.paste(small, ((_TILE[0] - small.width) // 2, (_TILE[1] - small.height) // 2))
    return tile
