"""Checks for entries of plug-ins, for tests of their authors: what the suite's own models and formats are held to.

Each raises AssertionError with a sentence that says what does not hold.

>>> from brdf_suite.reflectance.registry import MODELS
>>> check_model(MODELS["ggx"])
"""

from __future__ import annotations

import random
import tempfile
from collections.abc import Callable
from pathlib import Path

import numpy as np

from brdf_suite.documents.palette import Palette
from brdf_suite.errors import FileError
from brdf_suite.files.exports.format import ExportFormat, ExportItem
from brdf_suite.files.measured.format import MeasuredFormat, ReadOptions
from brdf_suite.files.palettes.format import PaletteFormat
from brdf_suite.geometry.directions import spherical
from brdf_suite.pipeline.material import default_paint
from brdf_suite.reflectance.adjusting import adjust, adjustables
from brdf_suite.reflectance.checks import check_model as measure_model
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.registry import ModelEntry

_DAMAGED = 500
_SEED = 11


def check_model(entry: ModelEntry) -> None:
    """Check a model: shapes, darkness below the horizon, what it claims, and that its sliders work at both ends."""
    _check_values(entry.default)
    failed = [finding for finding in measure_model(entry).findings if not finding.passed]
    assert not failed, f"it claims what does not hold: {failed}"
    for key, one in adjustables(entry.default).items():
        for value in (one.parameter.low, one.parameter.high):
            _check_values(adjust(entry.default, {key: value}))


def check_palette_format(known: PaletteFormat, example: bytes) -> None:
    """Check a palette format by the content of a file of it.

    The file is recognised, read, and where the format is written comes back the same; damaged files are read or refused
    by :class:`FileError`.
    """
    assert known.sniff(example[: 1 << 16], len(example)) is True, "the example is not recognised"
    palette, notes = known.read(example, "example")
    assert isinstance(palette, Palette), "read returns (palette, notes)"
    assert isinstance(notes, tuple), "notes are a tuple of sentences"
    if known.write is not None:
        again, _ = known.read(known.write(palette), "example")
        assert again == palette, "what is written does not come back the same"
    _check_damaged(example, lambda content: known.read(content, "damaged"), known.sniff)


def check_measured_format(known: MeasuredFormat, example: bytes) -> None:
    """Check a format of measured reflectance by the content of a file of it, as :func:`check_palette_format`."""
    assert known.sniff(example[: 1 << 16], len(example)) is True, "the example is not recognised"
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"example{known.endings[0]}"

        def read(content: bytes) -> Reflectance:
            path.write_bytes(content)
            value: Reflectance = known.read(path, ReadOptions())
            return value

        value = read(example)
        _check_values(value)
        if known.write is not None:
            known.write(value, path)
            _check_values(known.read(path, ReadOptions()))
        _check_damaged(example, read, known.sniff)


def check_export(known: ExportFormat) -> None:
    """Check an export with the paint that a new user sees first: its losses are sentences, and it writes a file."""
    item = ExportItem(default_paint())
    losses = known.losses(item)
    assert all(isinstance(one, str) and one.endswith(".") for one in losses), "losses are sentences"
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"paint{known.ending}"
        notes = known.write([item], path, None)
        assert all(isinstance(one, str) for one in notes), "write returns sentences"
        assert path.stat().st_size > 0, "the file is empty"
        if known.read is not None:
            assert len(known.read(path).paints) == 1, "the paint is not read back"


def _check_values(reflectance: Reflectance) -> None:
    theta, phi = np.linspace(0.0, 3.0, 13), np.linspace(-3.0, 3.0, 7)
    wi, wo = spherical(theta[:, None], 0.3), spherical(0.4 + 0.1 * phi, phi)
    values = np.asarray(reflectance.eval(wi, wo))
    assert values.shape == (13, 7, 3), f"directions broadcast to (13, 7, 3), values are {values.shape}"
    assert np.isfinite(values).all(), "a value is not finite"
    assert (values >= 0.0).all(), "a value is negative"
    assert not values[theta > 0.5 * np.pi].any(), "light from below the horizon is reflected"
    assert np.asarray(reflectance.eval(wi[0, 0], wo[0])).shape == (3,), "one pair of directions gives (3,)"
    assert np.asarray(reflectance.eval(np.empty((0, 3)), wo[0])).shape == (0, 3), "no directions give (0, 3)"


def _check_damaged(
    example: bytes, read: Callable[[bytes], object], sniff: Callable[[bytes, int], bool]
) -> None:
    chance = random.Random(_SEED)  # noqa: S311 - the same damage each time
    for _ in range(_DAMAGED):
        data = bytearray(example)
        at = chance.randrange(len(data))
        if chance.random() < 0.3:
            del data[at:]
        else:
            data[at : at + chance.choice((0, 1, 4))] = chance.choice(
                (b"", b"\0", b"\xff", b"9" * 40, b"-1", b"nan")
            )
        sniff(bytes(data[: 1 << 16]), len(data))
        try:
            read(bytes(data))
        except FileError:
            continue
