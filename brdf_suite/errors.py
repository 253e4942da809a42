"""Exception classes of the suite.

Every message is written for the person at the screen: it names the file and the place in it, says what is
wrong, and, where there is one, the way on. A program shows ``str(error)`` and nothing else.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from difflib import get_close_matches

PathLike = str | os.PathLike[str]  # a file as a caller names it


def did_you_mean(asked: str, names: Iterable[str]) -> str:
    """Return what ends a sentence about a name that is not there: the nearest of ``names``; empty where none is near.

    >>> did_you_mean("blu", ["blue", "copper"])
    '; did you mean blue?'
    """
    known = {name.casefold(): name for name in names}
    short = asked.casefold()
    near = get_close_matches(short, known, 1, 0.7) or [
        one for one in known if short[2:] and one.startswith(short)
    ]
    return f"; did you mean {known[near[0]]}?" if near else ""


_LONGEST_REASON, _LONGEST_PLACE = 2000, 200
"""Characters: what is wrong may quote a file, and more is not read."""


def _shortened(text: str, longest: int) -> str:
    return text if len(text) <= longest else f"{text[: longest - 1]}…"


class SuiteError(Exception):
    """Base class of all errors that are shown to a user. ``str(error)`` is a complete sentence or two.

    >>> import brdf_suite as bs
    >>> try:
    ...     bs.load("no such paint.brdfpaint")
    ... except bs.SuiteError as error:
    ...     print(error)
    no such paint.brdfpaint: there is no such file.
    """


class Cancelled(SuiteError):  # noqa: N818 - not an error that anyone is shown
    """Raised by a progress callback, or by a task that was asked to stop; never shown as an error."""

    def __init__(self, what: str = "The task was cancelled.") -> None:
        super().__init__(what)


class FileError(SuiteError):
    """A file that cannot be read or written.

    Parameters
    ----------
    path
        The file as the user named it.
    reason
        What is wrong, starting in lower case, without a full stop.
    place
        Where in the file: a byte offset, a line, a field; ``None`` where there is none.
    """

    def __init__(self, path: PathLike, reason: str, place: str | None = None) -> None:
        self.path = os.fspath(path)
        self.reason = _shortened(reason, _LONGEST_REASON)
        self.place = place and _shortened(place, _LONGEST_PLACE)
        reason, place = self.reason, self.place
        where = f", at {place}" if place else ""
        super().__init__(f"{self.path}{where}: {reason}" + ("" if reason.endswith("?") else "."))

    def __reduce__(self) -> tuple[type[FileError], tuple[str, str, str | None]]:
        """Return what makes it again, for processes that hand it on."""
        return type(self), (self.path, self.reason, self.place)


class UnreadFormatError(FileError):
    """A file of a format that is known and not read; the reason says what it is, and another way to its content."""


class DocumentError(FileError):
    """A document of ours (paint, palette, view) whose content is not valid; ``place`` names the field."""


class ValueRangeError(SuiteError, ValueError):
    """A value out of its range; the message names the quantity, its unit, the value and the range.

    ``place`` names the field, as in ``measurements[1].lab[0]``.
    """

    def __init__(self, place: str, reason: str) -> None:
        self.place = place
        self.reason = reason
        super().__init__(f"{place}: {reason}.")

    def __reduce__(self) -> tuple[type[ValueRangeError], tuple[str, str]]:
        """Return what makes it again, for processes that hand it on."""
        return type(self), (self.place, self.reason)


class UnreachableError(SuiteError):
    """A reading that no physical surface of the asked kind can give; the message says what could."""


class FittingError(SuiteError):
    """A target to which no lobes can be fitted (not finite, negative, wrong shape)."""


class AcquisitionError(SuiteError):
    """Photographs from which no measurement can be made; the message names what is missing or wrong in them."""


class GraphicsError(SuiteError):
    """OpenGL is missing, too old, lost, or a shader failed; the message names shader file and line."""


class ReferenceUnavailableError(SuiteError):
    """The path tracer cannot run here: LLVM, a graphics card or memory is missing; the message names what."""


class ExtraError(SuiteError):
    """An optional package that cannot be used: it is missing, too old, or fails to load.

    ``reason`` is the message as a :class:`FileError` takes it: starting in lower case, without a full stop.
    """

    def __init__(self, reason: str) -> None:
        self.reason = reason
        super().__init__(f"{reason[:1].upper()}{reason[1:]}.")

    def __reduce__(self) -> tuple[type[ExtraError], tuple[str]]:
        """Return what makes it again, for processes that hand it on."""
        return type(self), (self.reason,)


class MissingExtraError(ExtraError):
    """An optional package that is not installed; the message has the command that installs it here."""


class PluginError(SuiteError):
    """A plug-in that cannot be loaded, or that fails when it is used; the message names it and its package."""
