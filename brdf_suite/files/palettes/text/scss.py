"""Colours in SCSS, Sass and LESS, read only: variables, and the members of maps and lists.

``$name: #336699;`` and ``@name: #336699;`` are entries; ``$map: ("red": #d40000, …)``, ``@map: { red: #d40000; }`` and
a list are groups, whose members have numbers in a list. A value may be a variable: in SCSS as it was set last before,
in LESS as it is set last in the file. Functions that make colours of others (``darken``, ``mix``) are not computed,
and are left out with a notice. ``!default`` and ``!global`` count behind a value, and not behind a list or a map in
brackets.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cache

from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import GroupPath, Palette
from brdf_suite.errors import PathLike
from brdf_suite.files.palettes.collecting import Collector, decode_text
from brdf_suite.files.palettes.format import PaletteFormat
from brdf_suite.files.palettes.text.css import parse_colour

# Every branch takes at least one character and none can be taken in two ways, so the time is that of the length.
_TOKEN = re.compile(
    r"/\*.*?(?:\*/|\Z)|//[^\n]*|(?P<open>\()|(?P<close>\))|(?P<end>[;{}])|(?P<comma>,)"
    r"|(?P<key>(?:--|[$@])?[\w-]+|\"[^\"\n]*\"|'[^'\n]*')\s*:"
    r"|(?P<word>#[\w-]+|[$@]?[\w.%+-]+(?:\([^()\n]*\))?|\"[^\"\n]*\"|'[^'\n]*'|!\w+)|\s+|.",
    re.DOTALL,
)
# What the tokens take for the end of a setting, without the others.
_END = re.compile(r"/\*.*?(?:\*/|\Z)|//[^\n]*|\"[^\"\n]*\"|'[^'\n]*'|\([^()\n]*\)|(?P<end>[;{}])", re.DOTALL)
_SNIFF = re.compile(rb"(?m)^\s*[$@][A-Za-z0-9_\x80-\xff-]+\s*:")
_RULES = (
    "@import",
    "@use",
    "@media",
    "@include",
    "@mixin",
    "@forward",
    "@charset",
    "@font-face",
    "@supports",
)
_DEEPEST = 16
_MOST_SETTINGS = 100_000
_REFERENCE = re.compile(r"([$@][\w-]+)|var\(\s*(--[\w-]+)\s*\)")


_Colour = tuple[FlatColour, float]


@dataclass(frozen=True, slots=True)
class _Setting:
    """What a name is set to: ``parts`` are the members of a list, or one value, each in words.

    ``names`` are those of the maps around it and its own; ``mark`` is that of the outermost. ``block`` is 0 outside
    rules, else the number of the rule. ``key`` is the name by which others refer to it, empty of a map's members.
    """

    line: int
    names: tuple[str, ...]
    mark: str
    parts: tuple[tuple[str, ...], ...]
    default: bool
    block: int
    key: str


def read(content: bytes, path: PathLike) -> tuple[Palette, tuple[str, ...]]:
    """Return the palette of a style sheet; see :class:`~brdf_suite.files.palettes.format.PaletteFormat`."""
    collector = Collector(path)
    values = _Values(collector)
    settings: list[_Setting] = []
    certain = 0
    for setting in _Scanner().scan(decode_text(content, path, collector).replace("\r\n", "\n")):
        settings.append(setting)
        certain += values.prepare(setting)
        collector.check_count(certain, f"line {setting.line}")
        if len(settings) > _MOST_SETTINGS:
            raise collector.fail(f"has more than {_MOST_SETTINGS:,} variables", f"line {setting.line}")
    groups: dict[tuple[str, ...], GroupPath] = {}
    for setting in settings:
        found = values.take(setting)
        if found is None:
            collector.note(
                "{n} variable[|s] without effect, since [it is|they are] set elsewhere, [is|are] left out."
            )
            continue
        if not any(found):
            collector.note("{n} value[ that is no colour|s that are no colours] known here skipped.")
            continue
        place = f"line {setting.line}"
        for number, one in enumerate(found, 1):
            if one is None:
                collector.note("{n} value[ that is no colour|s that are no colours] known here skipped.")
                continue
            colour, opacity = one
            if opacity != 1.0:
                collector.note("The opacity of {n} colour[|s] is left out: a paint has none.")
            *around, name = setting.names if len(found) == 1 else (*setting.names, str(number))
            key = tuple(around)
            if key and key not in groups:
                groups[key] = collector.declare(place, around[:_DEEPEST])
            collector.add(place, replace(colour, name=collector.name(name)), group=groups.get(key, ()))
    if not collector.entries:
        raise collector.fail("holds no variable that is a colour", "line 1")
    return collector.finish()


class _Values:
    """What variables are: in SCSS the latest setting before, in LESS the last of all."""

    def __init__(self, collector: Collector) -> None:
        self._collector = collector
        self._last: dict[tuple[int, str], _Setting] = {}
        self._known: dict[tuple[int, str], list[_Colour | None]] = {}
        self._followed: dict[tuple[int, str], _Colour | None] = {}
        self._parse = cache(parse_colour)

    def prepare(self, setting: _Setting) -> int:
        """Remember a setting of LESS; return how many colours of any setting become entries whatever else is set."""
        at = (setting.block, setting.key)
        again = at in self._last
        if setting.key.startswith("@"):
            self._last[at] = setting
        if again or setting.default:
            return 0
        return sum(one is not None for one in self._each(setting, self._parse))

    def take(self, setting: _Setting) -> list[_Colour | None] | None:
        """Set a variable, and return the colour of each part, None for what is none; None if that has no effect."""
        at = (setting.block, setting.key)
        less = setting.mark == "@"
        if setting.key and (self._last[at] is not setting if less else setting.default and at in self._known):
            return None
        found = self._each(setting, lambda text: self._colour(text, setting.block))
        if setting.key and not less:
            self._known[at] = found
        return found

    def _each(self, setting: _Setting, colour: Callable[[str], _Colour | None]) -> list[_Colour | None]:
        """Return the colours of the parts, or of the words of the only one where all of them are colours.

        Raises :class:`FileError`: they are more than a file may have.
        """
        found = self._counted(setting, colour, map(" ".join, setting.parts))
        if found != [None] or len(setting.parts[0]) == 1:
            return found
        members = self._counted(setting, colour, setting.parts[0], until_none=True)
        return members if members[-1] is not None else found

    def _counted(
        self,
        setting: _Setting,
        colour: Callable[[str], _Colour | None],
        texts: Iterable[str],
        *,
        until_none: bool = False,
    ) -> list[_Colour | None]:
        found: list[_Colour | None] = []
        count = 0
        for text in texts:
            found.append(colour(text))
            if found[-1] is not None:
                count += 1
                self._collector.check_count(count, f"line {setting.line}")
            elif until_none:
                break
        return found

    def _colour(self, text: str, block: int) -> _Colour | None:
        """Return the colour of a value, through all variables of which each is the next one."""
        passed: list[tuple[int, str]] = []
        while (found := self._parse(text)) is None and (named := _REFERENCE.fullmatch(text)):
            key = (named[1] or named[2]).replace("_", "-")
            at = (block, key)
            if at in self._followed:
                found = self._followed[at]
                break
            if not key.startswith("@"):
                colours = self._known.get(at) or self._known.get((0, key), [])
                found = colours[0] if len(colours) == 1 else None
                break
            last = self._last.get(at) or self._last.get((0, key))
            if last is None or [len(words) for words in last.parts] != [1]:
                break
            self._followed[at] = None  # until it is known; so it stays where it leads to itself
            passed.append(at)
            text, block = last.parts[0][0], last.block
        self._followed.update(dict.fromkeys(passed, found))
        return found


@dataclass
class _Frame:
    """A bracket that is open: of a map or list with a name, or any other."""

    name: str | None
    brace: bool
    members: list[tuple[str, ...]] = field(default_factory=list)


class _Scanner:
    """Scanner of settings."""

    def __init__(self) -> None:
        self._frames: list[_Frame] = []
        self._names: list[str] = []  # of the frames of maps
        self._rules = self._blocks = 0  # that are open, and that have begun outside others
        self._line = self._start = 1
        self._outer_mark = self._mark = self._key = ""
        self._clear()

    def scan(self, text: str) -> Iterator[_Setting]:
        """Yield the settings of a style sheet in their order."""
        # In the indented syntax of Sass, which has neither braces nor semicolons, a line is a setting.
        indented = not any(token["end"] for token in _END.finditer(text))
        reached = 0
        for token in _TOKEN.finditer(text):
            self._line += text.count("\n", reached, token.start())
            reached = token.start()
            kind = token.lastgroup
            if kind == "open":
                self._open()
            elif kind == "close":
                yield from self._close()
            elif kind == "comma":
                yield from self._comma()
            elif kind == "end" or (
                indented and kind is None and not self._frames and token[0].isspace() and "\n" in token[0]
            ):
                yield from self._end(token[0])
            elif kind == "key":
                yield from self._name(token["key"])
            elif kind == "word":
                self._word(token["word"])
        yield from self._finish()

    def _clear(self) -> None:
        self._key, self._default, self._global = "", False, False
        self._words: list[str] = []
        self._parts: list[tuple[str, ...]] = []

    def _in(self, *, brace: bool) -> bool:
        """Return whether the innermost bracket is of a map."""
        return bool(self._frames) and self._frames[-1].name is not None and self._frames[-1].brace == brace

    def _in_call(self) -> bool:
        return bool(self._frames) and self._frames[-1].name is None and not self._frames[-1].brace

    def _setting(self, name: str, parts: Sequence[tuple[str, ...]]) -> _Setting:
        mark = self._outer_mark if self._names else self._mark
        block = self._blocks if self._rules and not self._global else 0
        key = "" if self._names else mark + name.replace("_", "-")
        return _Setting(self._start, (*self._names, name), mark, tuple(parts), self._default, block, key)

    def _finish(self) -> Iterator[_Setting]:
        """Yield the setting that has begun; without a name it is a member of a list."""
        parts = [*self._parts, *([tuple(self._words)] if self._words else [])]
        if self._key and parts:
            yield self._setting(self._key, parts)
        elif parts and self._in(brace=False):
            self._frames[-1].members += parts
        self._clear()

    def _open(self) -> None:
        if self._key and not self._words and not self._parts and len(self._names) < _DEEPEST:
            self._push(brace=False)
        else:
            self._frames.append(_Frame(None, brace=False))
            if self._key:
                self._words.append("(")

    def _push(self, *, brace: bool) -> None:
        if not self._names:
            self._outer_mark = self._mark
        self._names.append(self._key)
        self._frames.append(_Frame(self._key, brace))
        self._clear()

    def _close(self) -> Iterator[_Setting]:
        if self._in_call():
            self._frames.pop()
            if self._key:
                self._words.append(")")
        elif self._in(brace=False):
            yield from self._finish()
            yield from self._pop()

    def _pop(self) -> Iterator[_Setting]:
        frame = self._frames.pop()
        if frame.name is None:
            return
        self._names.pop()
        if frame.members:
            yield self._setting(frame.name, frame.members)

    def _comma(self) -> Iterator[_Setting]:
        if self._in_call():
            return
        if self._in(brace=False):
            yield from self._finish()
        elif self._key and self._words:
            self._parts.append(tuple(self._words))
            self._words = []

    def _end(self, mark: str) -> Iterator[_Setting]:
        opens_map = mark == "{" and self._key and self._mark == "@" and not self._words and not self._parts
        if opens_map and len(self._names) < _DEEPEST:
            self._push(brace=True)
            return
        if mark != "{":
            yield from self._finish()
        self._clear()
        while self._frames and not self._frames[-1].brace:
            yield from self._pop()
        if mark == "{":
            self._blocks += not self._rules
            self._rules += 1
            self._frames.append(_Frame(None, brace=True))
        elif mark == "}" and self._frames:
            self._rules -= self._frames[-1].name is None
            yield from self._pop()

    def _name(self, text: str) -> Iterator[_Setting]:
        if self._in_call():
            return
        yield from self._finish()
        mark = next((one for one in ("--", "$", "@") if text.startswith(one)), "")
        if (mark or self._in(brace=True) or self._in(brace=False)) and text not in _RULES:
            self._key, self._start = text.removeprefix(mark).strip("\"'"), self._line
            if mark:
                self._mark = mark

    def _word(self, text: str) -> None:
        if text.startswith("!"):
            self._default |= text == "!default"
            self._global |= text == "!global"
        elif self._key or self._in(brace=False):
            if not self._key and not self._words:
                self._start = self._line
            self._words.append(text.strip("\"'"))


FORMAT = PaletteFormat(
    name="scss",
    title="SCSS, Sass and LESS variables",
    endings=(".scss", ".less", ".sass"),
    models=("RGB", "HSL", "HSB", "Lab", "LCh", "XYZ", "CMYK"),
    holds="Read only. Variables and maps of colours as CSS writes them, maps as groups.",
    sniff=lambda head, _size: (
        b"\0" not in head and not head.lstrip().startswith((b"<", b"{", b"[")) and bool(_SNIFF.search(head))
    ),
    read=read,
    groups="nested",
)
