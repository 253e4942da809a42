"""Losses of a palette in a format, determined by writing to memory and reading back."""

from __future__ import annotations

from collections import Counter

from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.errors import FileError, PathLike, SuiteError
from brdf_suite.files.palettes import collecting
from brdf_suite.files.palettes.conversions import in_srgb
from brdf_suite.files.palettes.format import OWN, PaletteFormat

_SAME = 1e-9


def encode_palette(palette: Palette, known: PaletteFormat) -> bytes:
    """Return the content of a palette's file in a format.

    Raises :class:`SuiteError`: the format is only read, or cannot hold so many colours.
    """
    if known.write is None:
        raise SuiteError(f"{known.title} is only read here; choose another format.")
    return known.write(palette)


def find_losses(palette: Palette, known: PaletteFormat, content: bytes, path: PathLike) -> tuple[str, ...]:
    """Return what of a palette is missing or changed in the content of its file, in sentences.

    Raises :class:`SuiteError`: the palette is so large that the file would be beyond what is read of its format.
    """
    many = len(palette) > collecting.MOST_COLOURS
    try:
        with collecting.allow_palette_size():
            back, _ = known.read(content, path)
    except FileError as error:
        if not many:
            raise
        raise SuiteError(
            f"{_many(len(palette), 'entry')} are too many for {known.title}: the file {error.reason}. Write it in "
            "parts, or as a .brdfpalette."
        ) from error
    sections = palette.sections() if known.order != "kept" else [(None, palette.entries)]
    if known.order == "none first":
        sections.sort(key=lambda section: section[0] is not None)
    entries = [entry for _, section in sections for entry in section]
    losses = _of_entries(entries, list(back), numbered=known.unique_names)
    # The order as far as names and groups show it.
    shown, there = ([(e.name, e.group) for e in one] for one in (palette, back))
    if [e.id for e in entries] != [e.id for e in palette] and shown != there:
        losses.append("The entries of each group stand together there.")
    losses += _of_palette(palette, back)
    if many and known is not OWN:
        losses.append(
            f"BRDF Suite opens no file of this kind with more than {collecting.MOST_COLOURS:,} colours, "
            "so it cannot read this one back."
        )
    return tuple(losses)


def _of_entries(entries: list[Entry], back: list[Entry], *, numbered: bool) -> list[str]:
    counts: Counter[str] = Counter()
    models: Counter[tuple[str, str]] = Counter()
    for entry, other in zip(entries, back, strict=False):
        _compare(entry, other, counts, models)
    losses = []
    if len(back) < len(entries):
        losses.append(f"{_many(len(entries) - len(back), 'entry')} left out.")
    for (own, new), count in models.items():
        rough = ", computed without a profile" if own in ("CMYK", "CMY", "Gray") or new == "CMYK" else ""
        losses.append(f"{_many(count, 'colour')} in {own} {_were(count)} written as {new}{rough}.")
    sentences = {
        "paint": "{paint} {is} written as the one colour at 45°: other angles, gloss and flakes are left out.",
        "instrument": "Only what the virtual instruments read of {paint} goes in.",
        "paint fields": "Some settings of {paint} are left out or changed.",
        "clipped": "{colour} {is} beyond what it holds and brought to the nearest that it does.",
        "rounded": "The numbers of {colour} are rounded.",
        "others": "Further numbers of {colour} in other models are left out.",
        "space": "The colour spaces of {colour} are left out.",
        "white": "The whites that {colour} {is} measured by are left out.",
        "name": "The names of {entry} got a number: each must be there, and be unique."
        if numbered
        else "The names of {entry} are left out or changed.",
        "group": "The groups of {entry} are left out or changed.",
        "code": "The codes of {entry} are left out or changed.",
        "tags": "The tags of {entry} are left out.",
        "notes": "The notes of {entry} are left out or changed.",
        "usage": "Whether {entry} {is} spot, global or process colours is left out.",
        "date": "The dates of {entry} are left out.",
        "foreign": "What other programs' files said further of {entry} is left out.",
    }
    for key, sentence in sentences.items():
        if count := counts[key]:
            words = {word: _many(count, word) for word in ("paint", "colour", "entry")}
            losses.append(sentence.format_map({**words, "is": _were(count)}))
    return losses


def _compare(entry: Entry, other: Entry, counts: Counter[str], models: Counter[tuple[str, str]]) -> None:
    own, new = entry.content, other.content
    if isinstance(own, FlatColour) and isinstance(new, FlatColour):
        if own.model != new.model:
            models[own.model, new.model] += 1
        else:
            kept = own
            if own.space != new.space:
                kept = in_srgb(own)
                if kept is own:
                    counts["space"] += 1
                else:
                    models[own.space, "sRGB"] += 1
            counts["white"] += (own.illuminant, own.observer_deg) != (new.illuminant, new.observer_deg)
            changed = [
                (a, b)
                for a, b in zip(kept.values, new.values, strict=False)
                if abs(a - b) > _SAME * max(1.0, abs(a))
            ]
            if kept.model == "RGB" and any(not 0.0 <= a <= 1.0 and 0.0 <= b <= 1.0 for a, b in changed):
                counts["clipped"] += 1
            elif changed:
                counts["rounded"] += 1
        counts["others"] += own.others != new.others
    elif isinstance(new, FlatColour):
        counts["paint"] += 1
    elif type(own) is not type(new):
        counts["instrument"] += 1
    else:
        counts["paint fields"] += own != new and own.name == new.name
    counts["name"] += entry.name != other.name
    for field in ("group", "code", "tags", "notes", "usage", "date", "foreign"):
        counts[field] += getattr(entry, field) != getattr(other, field)


def _of_palette(palette: Palette, back: Palette) -> list[str]:
    losses = []
    if palette.name != back.name:
        losses.append("The palette's name is not stored; the file name is used.")
    for field, word in (("notes", "notes"), ("colour", "colour"), ("columns", "count of columns")):
        own, new = getattr(palette, field), getattr(back, field)
        if own and own != new:
            losses.append(f"The palette's {word} {'are' if field == 'notes' else 'is'} left out or changed.")
    if palette.foreign and palette.foreign != back.foreign:
        losses.append("What another program's file said further of the palette is left out.")
    paths = {group.path for group in back.groups}
    used = {entry.group[:depth] for entry in palette for depth in range(1, len(entry.group) + 1)}
    empty = sum(group.path not in paths and group.path not in used for group in palette.groups)
    if empty:
        losses.append(f"{_many(empty, 'empty group')} {_were(empty)} left out.")
    groups = {group.path: group for group in back.groups}
    changed = sum(
        (group.notes, group.colour) != (groups[group.path].notes, groups[group.path].colour)
        if group.path in groups
        else bool(group.notes or group.colour)
        for group in palette.groups
    )
    if changed:
        losses.append(f"The notes or colours of {_many(changed, 'group')} are left out.")
    return losses


def _many(count: int, word: str) -> str:
    plural = "entries" if word == "entry" else word + "s"
    return f"{count:,} {word if count == 1 else plural}"


def _were(count: int) -> str:
    return "is" if count == 1 else "are"
