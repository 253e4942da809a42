"""Lists of hex codes, one a line with or without a name, and the ``.txt`` palettes of paint.net.

A line holds one code (``#d40000``, ``d40000``, ``0xd40000``, ``#d00``) and, before or behind it, a name. In paint.net's
files, which have comments after ``;``, a code has eight digits with the opacity first; elsewhere that is so where all
codes begin with FF, and the opacity comes last where all end with it. Other codes of eight digits are refused, since
nothing says which two are the opacity.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from brdf_suite.documents.palette import Palette
from brdf_suite.errors import PathLike
from brdf_suite.files.palettes.collecting import Collector, decode_lines
from brdf_suite.files.palettes.conversions import convert_to_rgb8
from brdf_suite.files.palettes.format import PaletteFormat
from brdf_suite.files.tables.grid import decode_head

_CODE = re.compile(
    r"(?<![\w#])(?:#|0[xX])([0-9a-fA-F]{8}|[0-9a-fA-F]{6}|[0-9a-fA-F]{3})(?!\w)|"
    r"(?<![\w#])([0-9a-fA-F]{8}|[0-9a-fA-F]{6})(?!\w)"
)
_AROUND = " \t,;:=|-–—\"'()[]"
_COMMENTS = ("//", "--", ";")
_HASH_COMMENT = re.compile(r"#(?![0-9a-fA-F]{3}(?:[0-9a-fA-F]{3})?(?:[0-9a-fA-F]{2})?(?!\w))")
_LONGEST_LINE = 400


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a list; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    collector = Collector(path)
    lines = decode_lines(content, path, collector)
    found: list[tuple[int, str, str]] = []
    notes: list[str] = []
    of_paint_net = any(line.lstrip().startswith(";") for line in lines)
    name = ""
    for number, line in enumerate(lines, 1):
        text = line.strip()
        if not text or text in "[]{}":
            continue
        if text.startswith(_COMMENTS) or _HASH_COMMENT.match(text):
            said = text.lstrip(";/-#").strip()
            if said.lower().startswith("palette name:"):
                name = said.partition(":")[2].strip()
            elif said and len(notes) < 1000:
                notes.append(said[:_LONGEST_LINE])
            continue
        one = _find(text)
        if one is None:
            raise collector.fail(
                f"expected a hex code as in #336699, alone or with a name, not {text[:40]!r}",
                f"line {number}",
            )
        found += [(number, code, label) for code, label in one]
        collector.check_count(len(found), f"line {number}")
    if not found:
        raise collector.fail("holds no hex code", "line 1")
    if named := _take_numbers(found):
        found = named
        collector.note("The numbers before the codes are taken for names.")
    codes = [code for _, code, _ in found]
    opacity = "first" if of_paint_net else find_opacity(codes, collector)
    for number, code, label in found:
        _add(collector, f"line {number}", code, label, opacity)
    about = "\n".join(notes) if not of_paint_net or name else ""
    return collector.finish(name, notes=collector.lines(about))


def _find(line: str) -> list[tuple[str, str]] | None:
    """Return the code of a line and the name beside it, or several codes alone; None where there is no code."""
    if len(line) > _LONGEST_LINE:
        return None
    marked = [code for code in _CODE.finditer(line) if code[1]]
    codes = marked or [
        code for code in _CODE.finditer(line) if not code[0].isalpha() or len(line.split()) == 1
    ]
    if len(codes) > 1:
        alone = not _CODE.sub("", line).strip(_AROUND)
        return [(code[1] or code[2], "") for code in codes] if alone else None
    if not codes:
        return None
    code = codes[0]
    name = f"{line[: code.start()].strip(_AROUND)} {line[code.end() :].strip(_AROUND)}".strip()
    return [(code[1] or code[2], name)]


def _take_numbers(found: list[tuple[int, str, str]]) -> list[tuple[int, str, str]]:
    """Return two codes in each line as one with a name, where the first are all decimal and not all of the second."""
    pairs = list(zip(found[::2], found[1::2], strict=False))
    lines = {number for number, _, _ in found}
    if len(found) < 4 or not len(found) == 2 * len(pairs) == 2 * len(lines):
        return []
    alone = all(one[0] == other[0] and not one[2] + other[2] for one, other in pairs)
    numbered = all(one[1].isdecimal() for one, _ in pairs) and not all(
        other[1].isdecimal() for _, other in pairs
    )
    return [(line, code, name) for (line, name, _), (_, code, _) in pairs] if alone and numbered else []


def find_opacity(codes: Iterable[str], collector: Collector) -> str:
    """Return where codes of eight digits have their opacity: ``first`` or ``last``.

    Raises :class:`FileError`: neither the first nor the last two digits are FF in all, or both and it matters.
    """
    long = [code.lower() for code in codes if len(code) == 8]
    first = all(code.startswith("ff") for code in long)
    last = all(code.endswith("ff") for code in long)
    if first != last or all(code[2:] == code[:6] for code in long):
        return "first" if first else "last"
    reason = (
        f"{long[0]!r} has eight digits, and nothing says whether the first or the last two are the opacity"
    )
    raise collector.fail(reason, "the codes")


def _add(collector: Collector, place: str, code: str, label: str, opacity: str) -> None:
    if len(code) == 3:
        code = "".join(2 * digit for digit in code)
    elif len(code) == 8:
        alpha, code = (code[:2], code[2:]) if opacity == "first" else (code[6:], code[:6])
        if alpha.lower() != "ff":
            collector.note("The opacity of {n} colour[|s] is left out: a paint has none.")
    values = [byte / 255.0 for byte in bytes.fromhex(code)]
    collector.add(place, collector.colour(place, collector.name(label), "RGB", values))


def write(palette: Palette) -> bytes:
    """Return a line for each entry: its code and its name."""
    rows = []
    for entry in palette:
        code = bytes(convert_to_rgb8(entry)).hex()
        rows.append(f"#{code} {entry.name}".rstrip() if _is_kept(entry.name) else f"#{code}")
    return ("\n".join(rows) + "\n").encode("utf-8", "replace")


def _is_kept(name: str) -> bool:
    return _find(f"#000000 {name}") == [("000000", name)]


def _sniff(head: bytes, _size: int) -> bool:
    text = decode_head(head)
    if not text or len(head) < 3:
        return False
    seen = 0
    for line in text.splitlines()[:200]:
        plain = line.strip()
        if not plain or plain.startswith(_COMMENTS) or _HASH_COMMENT.match(plain):
            continue
        if _find(plain) is None:
            return False
        seen += 1
    return seen > 0


FORMAT = PaletteFormat(
    name="hex",
    title="List of hex codes",
    endings=(".hex", ".txt"),
    models=("RGB",),
    holds="sRGB in 8 bits, and names on the same line.",
    sniff=_sniff,
    read=read,
    write=write,
)
