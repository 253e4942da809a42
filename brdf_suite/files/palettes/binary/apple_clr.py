"""CLR (colour list of macOS), read only: an archive of NSColor objects as a binary property list.

``NSKeys`` are the names and ``NSColors`` the colours, in one order. A colour has ``NSColorSpace`` (1 and 2 RGB, 3 and 4
white, 5 CMYK) and its numbers as text in ``NSRGB``, ``NSWhite`` or ``NSCMYK``; one of a space with a profile has
them in ``NSComponents`` too, of the space that ``NSCustomColorSpace`` names, and these count. ``NSRGB`` of space 1
is Apple's "Generic RGB" (1.8). Older lists, which begin with ``streamtyped``, are refused by name. Layout from a
file of macOS.
"""

from __future__ import annotations

import math
import plistlib
import re
from typing import Any

from brdf_suite.documents.flat_colour import Model
from brdf_suite.documents.palette import Palette
from brdf_suite.errors import PathLike
from brdf_suite.files.palettes.collecting import Collector
from brdf_suite.files.palettes.format import PaletteFormat

_OLD = b"\x04\x0bstreamtyped"
_SPACES = {1: "Generic RGB", 7: "sRGB", 8: "Display P3", 9: "Adobe RGB (1998)", 5: "sRGB"}
_DESCRIBED = (
    (b"Display P3", "Display P3"),
    (b"Adobe RGB", "Adobe RGB (1998)"),
    (b"Generic RGB", "Generic RGB"),
    (b"sRGB", "sRGB"),
)
"""Words in a profile that name its space."""
_NUMBER = re.compile(r"[-+]?(?:\d*\.?\d+|\d+\.)(?:[eE][-+]?\d{1,3})?", re.ASCII)
_MOST_OBJECTS = 500_000
_LONGEST_NUMBERS = 400


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a colour list; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    collector = Collector(path)
    if content.startswith(_OLD):
        reason = "is a colour list of an old kind (streamtyped); save it once more by a present macOS"
        raise collector.fail(reason, "byte 0")
    _check_table(content, collector)
    try:
        value = plistlib.loads(content, fmt=plistlib.FMT_BINARY)
        archive = _Archive(value)
        names, colours = archive.lists()
    except RecursionError as error:
        raise collector.fail("is nested too deep", "byte 8") from error
    except (plistlib.InvalidFileException, ValueError, KeyError, TypeError, IndexError, OverflowError, AttributeError,
            MemoryError, UnicodeError) as error:  # fmt: skip
        raise collector.fail(f"is no colour list of macOS ({str(error)[:80]})", "byte 8") from error
    collector.check_count(len(colours), "NSColors")
    for index, colour in enumerate(colours):
        place = f"NSColors[{index}]"
        name = names[index] if index < len(names) and isinstance(names[index], str) else ""
        found = _read_colour(colour, archive, collector, place)
        if found is None:
            collector.note("{n} colour[|s] without numbers (of the system, patterns) [is|are] left out.")
            continue
        model, values, space = found
        if len(values) > len(_channels(model)) and values[-1] != 1.0:
            collector.note("The opacity of {n} colour[|s] is left out: a paint has none.")
        kept = values[: len(_channels(model))]
        collector.add(place, collector.colour(place, collector.name(name), model, kept, space=space))
    return collector.finish()


def _check_table(content: bytes, collector: Collector) -> None:
    """Refuse a file whose table of objects cannot lie in it, before anything is made of it."""
    if len(content) < 40:
        raise collector.fail("ends within the property list", f"byte {len(content)}")
    count = int.from_bytes(content[-24:-16], "big")
    if count > min(_MOST_OBJECTS, len(content)):
        raise collector.fail(f"{count:,} objects cannot lie in it", f"byte {len(content) - 24}")


class _Archive:
    """The objects of a keyed archive, by their references."""

    def __init__(self, value: Any) -> None:
        self._objects: list[Any] = value["$objects"]
        self._top: dict[str, Any] = value["$top"]
        if not isinstance(self._objects, list) or not isinstance(self._top, dict):
            raise ValueError("no archive")

    def get(self, value: Any) -> Any:
        """Return what a reference stands for; anything else as it is."""
        if not isinstance(value, plistlib.UID):
            return value
        return self._objects[value.data] if value.data < len(self._objects) else None

    def lists(self) -> tuple[list[Any], list[Any]]:
        """Return the names and the colours."""
        top = self._top
        if "NSColors" not in top:  # the list is an object of its own
            objects = [self.get(item) for item in top.values()]
            top = next((found for found in objects if isinstance(found, dict) and "NSColors" in found), {})
        names, colours = (self._array(top.get(key)) for key in ("NSKeys", "NSColors"))
        return names, colours

    def _array(self, value: Any) -> list[Any]:
        found = self.get(value)
        items = found.get("NS.objects", []) if isinstance(found, dict) else found or []
        return [self.get(item) for item in items]


def _read_colour(
    colour: Any, archive: _Archive, collector: Collector, place: str
) -> tuple[Model, list[float], str] | None:
    if not isinstance(colour, dict):
        return None
    kind = colour.get("NSColorSpace")
    kind = kind if isinstance(kind, int) else 0
    components = _numbers(colour.get("NSComponents"), collector, place)
    if components:
        custom = archive.get(colour.get("NSCustomColorSpace"))
        space = _space_of(custom, archive)
        if space:
            return "RGB", components, space
    for key, model, spaces in (
        ("NSRGB", "RGB", {1: "Generic RGB"}),
        ("NSWhite", "Gray", {}),
        ("NSCMYK", "CMYK", {}),
    ):
        numbers = _numbers(colour.get(key), collector, place)
        if len(numbers) >= len(_channels(model)):  # type: ignore[arg-type]  # one of its words
            return model, numbers, spaces.get(kind, "")  # type: ignore[return-value]  # one of its words
    return None


def _space_of(custom: Any, archive: _Archive) -> str:
    """Return the RGB space that a colour's own space is; empty for one that is not known, or not of RGB."""
    if not isinstance(custom, dict):
        return ""
    profile = archive.get(custom.get("NSICC"))
    data = profile.get("NS.data", b"") if isinstance(profile, dict) else profile
    if isinstance(data, bytes) and data:
        if data[16:20] != b"RGB ":
            return ""
        plain = data.replace(b"\0", b"")
        return next((name for word, name in _DESCRIBED if word in plain), "")
    identity = custom.get("NSID")
    return _SPACES.get(identity, "") if isinstance(identity, int) else ""


def _numbers(value: Any, collector: Collector, place: str) -> list[float]:
    if not isinstance(value, bytes) or not value or len(value) > _LONGEST_NUMBERS:
        return []
    found = []
    for word in value.rstrip(b"\0").split():
        text = word.decode("latin-1")
        number = (
            float(text)
            if re.fullmatch(r"[-+]?\d*\.?\d+(?:[eE][-+]?\d{1,3})?|[-+]?\d+\.", text, re.ASCII)
            else math.nan
        )
        if not math.isfinite(number):
            raise collector.fail(f"expected a finite number, not {text[:40]!r}", place)
        found.append(number)
    return found


def _channels(model: Model) -> str:
    return "g" if model == "Gray" else model


FORMAT = PaletteFormat(
    name="clr",
    title="Apple colour list",
    endings=(".clr",),
    models=("RGB", "Gray", "CMYK"),
    holds="Read only. Names, RGB of several spaces, grey and CMYK.",
    sniff=lambda head, _size: (head.startswith(b"bplist00") and b"NSColor" in head) or head.startswith(_OLD),
    read=read,
)
