"""Measured reflectance: every file format behind :func:`read_measured` and :func:`write_measured`.

A file is known by its content; the ending only breaks a tie and names the format to write.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.measured import (
    alta,
    astm,
    bird,
    brdftable,
    cook_torrance,
    cornell,
    materialx,
    mbsdf,
    merl,
    model_text,
    pgii,
    polarized,
    rgl,
    utia,
)
from brdf_suite.files.measured.format import (
    MeasuredFormat,
    MeasuredReflectance,
    ReadOptions,
    WrittenMeasurement,
)
from brdf_suite.files.measured.optics import lighttools, ssdd, zemax
from brdf_suite.files.unread_formats import refuse_axf
from brdf_suite.plugins import Call, Plugin, Registry
from brdf_suite.reflectance.guarded import GuardedReflectance, is_own
from brdf_suite.regular_files import open_regular, within_memory

_BUILT_IN = (
    polarized.FORMAT,
    rgl.FORMAT,
    mbsdf.FORMAT,
    brdftable.FORMAT,
    merl.FORMAT,
    utia.FORMAT,
    cook_torrance.FORMAT,
    materialx.FORMAT,
    bird.FORMAT,
    zemax.FORMAT,
    lighttools.FORMAT,
    ssdd.FORMAT,
    astm.FORMAT,
    alta.FORMAT,
    pgii.FORMAT,
    model_text.FORMAT,
    cornell.FORMAT,
)


def _are_notes(found: object) -> bool:
    return found is None or (isinstance(found, tuple) and all(isinstance(note, str) for note in found))


def _guard_value(known: MeasuredFormat, plugin: Plugin) -> MeasuredFormat:
    """Let the reflectance that a plug-in reads name it where it fails."""

    def read(path: PathLike, options: ReadOptions) -> MeasuredReflectance:
        value: MeasuredReflectance = known.read(path, options)
        return value if is_own(value) else GuardedReflectance(value, plugin, dict(value.facts))

    return replace(known, read=read)


FORMATS = Registry(
    "brdf_suite.measured_formats",
    MeasuredFormat,
    _BUILT_IN,
    calls={
        "sniff": Call(lambda found: isinstance(found, bool), "True or False", False),
        "read": Call(
            lambda found: isinstance(found, MeasuredReflectance) and isinstance(found.facts, dict),
            "a reflectance with eval() and facts",
        ),
        "write": Call(_are_notes, "notes or None"),
    },
    endings=lambda known: known.endings,
    prepare=_guard_value,
)
"""In the order in which they are tried; the ones that a few bytes settle come first, those of plug-ins last."""

_HEAD = 1 << 16
_LARGEST = 8 << 30


def sniff(path: PathLike) -> MeasuredFormat:
    """Return the format of the file at ``path``, by its content.

    Raises :class:`FileError`: it cannot be read, is empty, or is of no known format;
    :class:`~brdf_suite.errors.UnreadFormatError`: it is of one that is known and not read.
    """
    with open_regular(path, _LARGEST) as stream:
        head = stream.read(_HEAD)
        size = stream.seek(0, 2)
    if not head:
        raise FileError(path, "is empty", "byte 0")
    found = [known for known in FORMATS if known.sniff(head, size)]
    if not any(known in FORMATS.added for known in found):
        refuse_axf(head, path)
    ending = Path(path).suffix.lower()
    for known in found:
        if ending in known.endings:
            return known
    if found:
        return found[0]
    titles = ", ".join(known.title for known in FORMATS)
    raise FileError(path, f"is of no measured format that is known here ({titles})", "byte 0")


@within_memory
def read_measured(path: PathLike, *, options: ReadOptions | None = None) -> MeasuredReflectance:
    """Return the reflectance in a measured file of any known format.

    The value has ``eval`` and ``facts``; its class says what more it can do (a
    :class:`~brdf_suite.reflectance.tensor.tensor_reflectance.TensorReflectance`, scattered samples, a table).

    Raises :class:`FileError`: with the place in the file: byte offset, line or field. Nothing is partly read.
    """
    value: MeasuredReflectance = sniff(path).read(path, options or ReadOptions())
    return value


# Any: each writer takes its own value classes and says what it cannot write.
def write_measured(value: Any, path: PathLike, format_name: str = "") -> WrittenMeasurement:
    """Write a reflectance in the format of that name, or that the ending of ``path`` names; return it, and notes.

    The file is written whole or not at all.

    Raises
    ------
    FileError
        The ending belongs to no format that is written here, the value does not fit the format, or the disk
        refuses.
    """
    ending = Path(path).suffix.lower()
    writers = [known for known in FORMATS if known.write is not None]
    for known in writers:
        meant = known.name == format_name if format_name else ending in known.endings
        if meant and known.write is not None:
            return WrittenMeasurement(known, known.write(value, path) or ())
    endings = ", ".join(sorted({end for known in writers for end in known.endings}))
    raise FileError(path, f"the ending {ending or '(none)'} names no format that is written here ({endings})")
