"""Declaration of a document's number: unit, range, default and meaning.

Validation, parameter panels and help texts all read the same declaration, so they cannot disagree.
"""

from __future__ import annotations

import math
import unicodedata
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from brdf_suite.errors import ValueRangeError


@dataclass(frozen=True)
class Parameter:
    """Declaration of a number: ``low`` and ``high`` belong to the range; ``unit`` is empty for a pure number."""

    label: str
    unit: str
    low: float
    high: float
    default: float
    meaning: str

    def check(self, value: object, place: str) -> float:
        """Return ``value`` as a float; raise :class:`ValueRangeError` naming ``place`` where it is not one.

        >>> Parameter("Gloss", "GU", 0.0, 200.0, 90.0, "").check(82, "gloss.gu_20")
        82.0
        """
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise ValueRangeError(place, f"expected a number, not {describe(value)}")
        try:
            number = float(value)
        except OverflowError:
            number = math.inf
        if not math.isfinite(number):
            raise ValueRangeError(place, f"expected a finite number, not {number}")
        if not self.low <= number <= self.high:
            unit = f" {self.unit}" if self.unit else ""
            raise ValueRangeError(
                place, f"{number:g}{unit} is outside the range {self.low:g} to {self.high:g}{unit}"
            )
        return number


def set_number(owner: object, parameter: Parameter, *names: str) -> None:
    """Check fields of a frozen value by one declaration, and store them as floats."""
    for name in names:
        object.__setattr__(owner, name, parameter.check(getattr(owner, name), name))


def set_numbers(owner: object, parameters: Mapping[str, Parameter], *names: str, group: str = "") -> None:
    """Check fields of a frozen value by the declarations of ``group`` + their names, and store them as floats."""
    for name in names:
        set_number(owner, parameters[group + name], name)


def check_numbers(value: object, place: str, parameter: Parameter, count: int) -> tuple[float, ...]:
    """Return ``count`` numbers in the parameter's range; the error names the one that is not."""
    if not isinstance(value, (tuple, list)) or len(value) != count:
        raise ValueRangeError(place, f"expected a list of {count} numbers, not {describe(value)}")
    return tuple(parameter.check(item, f"{place}[{i}]") for i, item in enumerate(value))


def check_flags(owner: object, *names: str) -> None:
    """Raise :class:`ValueRangeError` where a field is neither true nor false."""
    for name in names:
        value = getattr(owner, name)
        if not isinstance(value, bool):
            raise ValueRangeError(name, f"expected true or false, not {describe(value)}")


def check_choices(owner: object, **choices: tuple[str, ...]) -> None:
    """Raise :class:`ValueRangeError` where a field is none of its choices."""
    for name, known in choices.items():
        check_choice(getattr(owner, name), name, known)


def check_parts(owner: object, **kinds: tuple[type, str]) -> None:
    """Raise :class:`ValueRangeError` where a field is neither None nor of its kind, which the word names."""
    for name, (kind, word) in kinds.items():
        value = getattr(owner, name)
        if value is not None and not isinstance(value, kind):
            raise ValueRangeError(name, f"expected {word} or nothing, not {describe(value)}")


def check_labels(owner: object) -> None:
    """Check the name, the notes and the source of a paint."""
    for name, longest, long in (("name", 200, False), ("notes", 100_000, True), ("source", 10_000, True)):
        check_text(getattr(owner, name), name, longest=longest, lines=long, empty=long)


def check_items(value: object, place: str, kind: type | tuple[type, ...], most: int) -> tuple[Any, ...]:
    """Return a list's items as a tuple where each is of ``kind`` and they are not more than ``most``."""
    if not isinstance(value, (tuple, list)):
        raise ValueRangeError(place, f"expected a list, not {describe(value)}")
    if len(value) > most:
        raise ValueRangeError(place, f"{len(value)} are more than the {most} allowed")
    for index, item in enumerate(value):
        if not isinstance(item, kind):
            word = "list" if isinstance(kind, tuple) else "text" if kind is str else kind.__name__.lower()
            raise ValueRangeError(f"{place}[{index}]", f"expected a {word}, not {describe(item)}")
    return tuple(value)


def as_whole(value: object) -> object:
    """Return a float without a fraction as the whole number that it is in JSON; anything else as it is."""
    return int(value) if isinstance(value, float) and value.is_integer() else value


def describe(value: object) -> str:
    """Return the kind of value found, in JSON terms, short enough for a message."""
    if value is None:
        return "null"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return f"the text {value[:40]!r}"
    if isinstance(value, Mapping):
        return "an object"
    if isinstance(value, (list, tuple)):
        return f"a list of {len(value)}"
    return f"{value!r}"[:60]


def check_text(value: object, place: str, *, longest: int, lines: bool, empty: bool) -> str:
    """Return ``value`` where it is a text that can be shown and saved.

    Parameters
    ----------
    longest
        The largest number of characters.
    lines
        Whether line breaks and tabs are allowed; other control characters never are.
    empty
        Whether the empty text is allowed.
    """
    if not isinstance(value, str):
        raise ValueRangeError(place, f"expected a text, not {describe(value)}")
    if len(value) > longest:
        raise ValueRangeError(place, f"{len(value)} characters are more than the {longest} allowed")
    if not empty and not value.strip():
        raise ValueRangeError(place, "the text is empty")
    # What is printable holds no character that is refused, and asking so is a hundred times faster.
    if value.isprintable():
        return value
    allowed = "\n\t" if lines else ""
    for character in value:
        # Cc: control characters; Cs: half of a surrogate pair, which UTF-8 cannot hold.
        if unicodedata.category(character) in {"Cc", "Cs"} and character not in allowed:
            raise ValueRangeError(place, f"the character {character!r} is not allowed in this text")
    return value


def check_choice(value: object, place: str, choices: tuple[str, ...]) -> str:
    """Return ``value`` where it is one of ``choices``."""
    if not isinstance(value, str) or value not in choices:
        raise ValueRangeError(place, f"expected one of {', '.join(choices)}, not {describe(value)}")
    return value
