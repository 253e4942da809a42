"""The packages that a user of the suite installs: it, what it needs, and what its extras need, as installed here."""

from __future__ import annotations

import contextlib
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from importlib.metadata import Distribution, distribution
from pathlib import Path

from packaging.licenses import InvalidLicenseExpression, canonicalize_license_expression
from packaging.requirements import Requirement

PROJECT = "brdf-suite"
EXTRAS = ("acquisition", "batches", "meshes", "reference", "speed", "video")
"""The extras for users; ``dev`` is for those who change the suite."""

_STATED = {"Apache 2.0": "Apache-2.0"}
"""What packages write for an SPDX expression."""
_LICENCE_FILE = re.compile(r"(LICEN[CS]E|COPYING)(\.\w+)?", re.IGNORECASE)


@dataclass(frozen=True)
class Package:
    """An installed package, the names of what it needs itself, and the extra that brings it; empty: none, always."""

    found: Distribution
    needs: tuple[str, ...]
    extra: str

    @property
    def name(self) -> str:
        """Its name, as it writes it."""
        return str(self.found.metadata["Name"])

    @property
    def licence(self) -> str:
        """Its licence: the SPDX expression that it states, or that of its licence's text, or what else it says."""
        metadata = self.found.metadata
        for field in ("License-Expression", "License"):
            stated = str(metadata.get(field) or "")
            with contextlib.suppress(InvalidLicenseExpression):
                return str(canonicalize_license_expression(_STATED.get(stated, stated)))
            if found := _licence_of_text(" ".join(stated.split())):  # some state the whole text there
                return found
        for file in self.found.files or ():
            if _LICENCE_FILE.fullmatch(file.name):
                text = Path(str(file.locate())).read_text(encoding="utf-8", errors="replace")
                found = _licence_of_text(" ".join(text.split()))
                if found:
                    return found
        classified = [
            words.rpartition(" :: ")[2]
            for words in metadata.get_all("Classifier") or ()
            if words.startswith("License :: ")
        ]
        return "; ".join(classified)

    @property
    def address(self) -> str:
        """Where it lives; empty where it does not say."""
        metadata = self.found.metadata
        listed = dict(map(_labelled, metadata.get_all("Project-URL") or ()))
        for label in ("homepage", "source", "source code", "repository", "github", "documentation"):
            if label in listed:
                return listed[label]
        return str(metadata.get("Home-page") or next(iter(listed.values()), ""))


def _labelled(line: str) -> tuple[str, str]:
    label, _, address = line.partition(",")
    return label.strip().lower(), address.strip()


def _licence_of_text(text: str) -> str:
    if "Redistribution and use in source and binary forms" in text:
        return "BSD-3-Clause" if re.search("(Neither|None of) the name", text) else "BSD-2-Clause"
    return "MIT" if "Permission is hereby granted, free of charge" in text else ""


def key(name: str) -> str:
    """Return a name as indexes compare it."""
    return re.sub(r"[-_.]+", "-", name).lower()


def runtime_packages(extras: Iterable[str] = EXTRAS) -> dict[str, Package]:
    """Return the project and all that it needs on this machine, by their compared names, sorted.

    Raises
    ------
    PackageNotFoundError
        One of them is not installed here.
    """
    found: dict[str, Package] = {}

    def add(name: str, wanted: frozenset[str], extra: str) -> None:
        if key(name) in found and not wanted:
            return
        one = distribution(name)
        needed = dict(_needs(one, wanted))
        known = found.get(key(name), Package(one, (), extra))
        found[key(name)] = Package(one, tuple(sorted({*known.needs, *needed})), known.extra)
        for need, through in needed.items():
            add(need, through, extra)

    add(PROJECT, frozenset(), "")
    for extra in extras:
        add(PROJECT, frozenset({extra}), extra)
    return dict(sorted(found.items()))


def _needs(one: Distribution, extras: frozenset[str]) -> Iterator[tuple[str, frozenset[str]]]:
    """Yield the compared names of what a package needs here, with the extras of it that are wanted."""
    for line in one.requires or ():
        need = Requirement(line)
        if need.marker is None or any(need.marker.evaluate({"extra": extra}) for extra in extras or {""}):
            yield key(need.name), frozenset(need.extras)
