"""The name that a dialog suggests for what is written of a palette."""

from __future__ import annotations

from pathlib import Path

from brdf_color_swatch.library.item import Item

_LONGEST = 100


def suggested_file(item: Item | None, name: str, ending: str) -> Path:
    """Return a file beside the palette's own, or in the user's folder, called as the palette is.

    What no system takes in the name of a file, or takes for a folder, is an underscore there.
    """
    folder = item.path.parent if item is not None and item.path is not None else Path.home()
    clean = "".join(letter if letter.isalnum() or letter in " -_." else "_" for letter in name)
    return folder / f"{clean[:_LONGEST].strip(' .') or 'palette'}{ending}"
