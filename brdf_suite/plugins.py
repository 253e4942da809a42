"""Plug-ins: entries that installed packages add to the suite's tables of models and formats.

A package names an entry by an entry point of the group of its table: ``brdf_suite.models``,
``brdf_suite.measured_formats``, ``brdf_suite.palette_formats`` or ``brdf_suite.exports``. Entry points are looked up
when a table is first read beyond what is built in, never by an import. A plug-in that cannot be loaded, is of the wrong
type or has a name that is taken is skipped; the log and :func:`on_problem` name it. What it raises when it is called
becomes a :class:`~brdf_suite.errors.PluginError`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, fields, replace
from functools import cached_property
from threading import RLock
from typing import Any, Generic, Protocol, TypeVar, overload

from brdf_suite.errors import PluginError, SuiteError

_NAME = re.compile(r"[a-z][a-z0-9_]{0,63}")
_ENDING = re.compile(r"\.[a-z0-9_.+-]{1,32}")
_LONGEST_REASON = 300

_lock = RLock()
_problems: list[str] = []
_listeners: list[Callable[[str], object]] = []


class _Entry(Protocol):
    """A dataclass with the short name and the title of what it stands for."""

    @property
    def name(self) -> str: ...

    @property
    def title(self) -> str: ...


Entry = TypeVar("Entry", bound=_Entry)


@dataclass(frozen=True)
class Plugin:
    """An entry point of an installed package: the package with its version, the group, and the name in it."""

    package: str
    group: str
    name: str

    def __str__(self) -> str:
        return f"plug-in {self.name} ({self.package}, {self.group})"

    @contextmanager
    def blamed(self) -> Iterator[None]:
        """Turn what is raised inside, other than a :class:`SuiteError`, into a :class:`PluginError`."""
        try:
            yield
        except SuiteError:
            raise
        except (Exception, SystemExit) as error:
            raise PluginError(f"The {self} failed: {_reason(error)}.") from error


@dataclass(frozen=True)
class Call:
    """A call of an entry: whether its result is as the suite needs it, and what that is.

    ``instead`` is the result of a call that fails; None where the failure is reported to the caller.
    """

    is_right: Callable[[Any], bool]
    expected: str
    instead: object = None


def _fails(call: Callable[..., Any], plugin: Plugin, wanted: Call) -> Callable[..., Any]:
    """Return a call whose failures name the plug-in."""

    def guarded(*given: Any, **named: Any) -> Any:
        try:
            with plugin.blamed():
                found = call(*given, **named)
                if not wanted.is_right(found):
                    raise TypeError(f"expected {wanted.expected}, not {type(found).__name__}")
        except PluginError as error:
            if wanted.instead is None:
                raise
            _note(str(error))
            return wanted.instead
        return found

    return guarded


class Registry(Sequence[Entry], Generic[Entry]):
    """A table of entries: those that are built in, then those of plug-ins.

    Plug-ins are loaded when the table is iterated, counted or asked for a name that is not built in.

    Parameters
    ----------
    group
        The group of entry points.
    kind
        The type of an entry, a frozen dataclass.
    built_in
        The suite's own entries, in their order.
    calls
        What the entry's callables return, by their fields; what a plug-in's return is checked.
    endings
        ``(entry) -> endings`` of files, lower case, with the dot.
    prepare
        ``(entry, plugin) -> entry``: what is further done to an entry of a plug-in.
    reserved
        Names that no plug-in may have, beside those that are built in.
    """

    def __init__(
        self,
        group: str,
        kind: type[Entry],
        built_in: Sequence[Entry],
        *,
        calls: Mapping[str, Call],
        endings: Callable[[Entry], object] = lambda _entry: (),
        prepare: Callable[[Entry, Plugin], Entry] = lambda entry, _plugin: entry,
        reserved: Sequence[str] = (),
    ) -> None:
        self.group = group
        self.built_in = tuple(built_in)
        self._kind, self._calls, self._endings, self._prepare = kind, calls, endings, prepare
        self._reserved = frozenset(reserved)
        self._added: tuple[Entry, ...] | None = None
        self._loading = False
        self.states: dict[Plugin, str] = {}
        """Why each plug-in was skipped, empty where it was not; of those that were looked up."""

    @overload
    def __getitem__(self, index: int) -> Entry: ...

    @overload
    def __getitem__(self, index: slice) -> Sequence[Entry]: ...

    def __getitem__(self, index: int | slice) -> Entry | Sequence[Entry]:
        return (*self.built_in, *self.added)[index]

    def __len__(self) -> int:
        return len(self.built_in) + len(self.added)

    def __iter__(self) -> Iterator[Entry]:
        yield from self.built_in
        yield from self.added

    @property
    def added(self) -> tuple[Entry, ...]:
        """The entries of plug-ins, in the order of their packages and names; loaded at the first use."""
        with _lock:
            if self._added is None and not self._loading:
                # What a plug-in reads of the table while it is imported is what is built in.
                self._loading = True
                try:
                    self._added = self._load()
                finally:
                    self._loading = False
            return self._added or ()

    @cached_property
    def by_name(self) -> Mapping[str, Entry]:
        """The entries by their names; one that is built in is found without a look at plug-ins."""
        return _ByName(self)

    def _load(self) -> tuple[Entry, ...]:
        found: list[Entry] = []
        taken = self._reserved | {entry.name for entry in self.built_in}
        for plugin, load in _entry_points(self.group):
            try:
                entry = self._checked(load(), plugin)
            except (Exception, SystemExit) as error:  # noqa: BLE001 - whatever a plug-in raises is named
                self._skip(plugin, _reason(error))
                continue
            if entry.name in taken:
                self._skip(plugin, f"the name {entry.name} is taken")
                continue
            taken |= {entry.name}
            found.append(entry)
            self.states[plugin] = ""
        return tuple(found)

    def _skip(self, plugin: Plugin, reason: str) -> None:
        self.states[plugin] = reason
        _note(f"The {plugin} is skipped: {reason}.")

    def _checked(self, found: object, plugin: Plugin) -> Entry:
        """Return an entry whose calls name the plug-in; raise TypeError or ValueError for what is no entry."""
        if not isinstance(found, self._kind):
            raise TypeError(f"expected a {self._kind.__name__}, not {type(found).__name__}")
        for field, words in (("name", _NAME), ("title", None)):
            value = vars(found)[field]
            if not isinstance(value, str) or not value.strip() or (words and not words.fullmatch(value)):
                raise ValueError(f"{field}: {value!r} cannot be used")
        endings = self._endings(found)
        if not isinstance(endings, tuple) or not all(
            isinstance(one, str) and _ENDING.fullmatch(one) for one in endings
        ):
            raise ValueError(f"its endings cannot be used: {endings!r}")
        guarded: dict[str, Any] = {}
        for one in fields(found):  # type: ignore[arg-type]  # a dataclass, as the class docstring says
            value = vars(found)[one.name]
            if one.name not in self._calls or value is None:
                continue
            if not callable(value):
                raise TypeError(f"{one.name}: expected a function, not {type(value).__name__}")
            guarded[one.name] = _fails(value, plugin, self._calls[one.name])
        return self._prepare(replace(found, **guarded), plugin)  # type: ignore[type-var]


class _ByName(Mapping[str, Entry]):
    """The entries of a registry by their names."""

    def __init__(self, registry: Registry[Entry]) -> None:
        self._registry = registry
        self._built_in = {entry.name: entry for entry in registry.built_in}

    def __getitem__(self, name: str) -> Entry:
        if name in self._built_in:
            return self._built_in[name]
        return {entry.name: entry for entry in self._registry.added}[name]

    def __contains__(self, name: object) -> bool:
        return name in self._built_in or any(entry.name == name for entry in self._registry.added)

    def __iter__(self) -> Iterator[str]:
        return (entry.name for entry in self._registry)

    def __len__(self) -> int:
        return len(self._registry)


def on_problem(report: Callable[[str], object]) -> Callable[[], None]:
    """Call ``report`` with a sentence for each plug-in that is skipped or fails unseen; return what ends that.

    Those of before are reported at once. ``report`` is called on whichever thread a plug-in is used.
    """
    with _lock:
        _listeners.append(report)
        past = tuple(_problems)
    for sentence in past:
        report(sentence)

    def end() -> None:
        with _lock:
            if report in _listeners:
                _listeners.remove(report)

    return end


def _note(sentence: str) -> None:
    import logging

    with _lock:
        if sentence in _problems:
            return
        _problems.append(sentence)
        listeners = tuple(_listeners)
    logging.getLogger("brdf_suite").warning("brdf-suite: %s", sentence)
    for report in listeners:
        report(sentence)


def _entry_points(group: str) -> list[tuple[Plugin, Callable[[], object]]]:
    """Return the plug-ins of a group with what imports each, sorted by package and name."""
    from importlib.metadata import entry_points

    found: dict[Plugin, Callable[[], object]] = {}
    for point in entry_points(group=group):
        package = f"{point.dist.name} {point.dist.version}" if point.dist is not None else "unknown package"
        # One package can stand on the path twice; the first counts, as for imports.
        found.setdefault(Plugin(package, group, point.name), point.load)
    return sorted(found.items(), key=lambda item: (item[0].package, item[0].name))


def _reason(error: BaseException) -> str:
    words = " ".join(str(error).split()).rstrip(".")[:_LONGEST_REASON]
    kind = type(error).__name__
    return f"{kind}: {words}" if words else kind
