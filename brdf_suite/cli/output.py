"""What the commands share of talking: a progress bar, JSON, sizes."""

from __future__ import annotations

import argparse
import json
import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager

from brdf_suite.progress import Progress

_SIZE = re.compile(r"([1-9]\d{0,4})[x×X]([1-9]\d{0,4})")
_LARGEST = 65_536


@contextmanager
def progress_bar(what: str, *, quiet: bool = False) -> Iterator[Progress]:
    """Show a bar on standard error while the body runs; none where it is not a terminal or ``quiet``."""
    from tqdm import tqdm

    form = "{desc:<28} {percentage:3.0f}% |{bar:30}| {elapsed}"
    with tqdm(total=1.0, desc=what, leave=False, disable=True if quiet else None, bar_format=form) as bar:

        def show(fraction: float, doing: str) -> None:
            bar.set_description_str(doing[:28], refresh=False)
            bar.update(fraction - bar.n)

        yield show


def print_json(value: Mapping[str, object]) -> None:
    """Print one JSON object. Numbers that are not finite are a fault, never printed as such."""
    print(json.dumps(value, indent=2, allow_nan=False, ensure_ascii=False))


def size(text: str) -> tuple[int, int]:
    """Parse ``WIDTHxHEIGHT`` in pixels, each 1 to 65,536 (an argparse type)."""
    match = _SIZE.fullmatch(text)
    if match is None:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not a size; write WIDTHxHEIGHT in pixels, as in 1280x720"
        )
    width, height = int(match[1]), int(match[2])
    if max(width, height) > _LARGEST:
        raise argparse.ArgumentTypeError(f"{text} is too large; each side is at most {_LARGEST} pixels")
    return width, height
